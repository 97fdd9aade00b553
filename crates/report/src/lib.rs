#![doc = include_str!("../README.md")]

pub mod coarse;
mod curves_csv;
pub mod deformed;
pub mod drawing;
pub mod error;
mod escape;
pub mod figure;
pub mod heatmap;
pub mod page;
mod paint;
pub mod palette;
pub mod table;
mod thin;
mod ticks;
pub mod vtu;

pub use drawing::Drawing;
pub use error::DrawError;
pub use figure::{Figure, Panel, Series, Style};
pub use heatmap::PlanformView;
pub use page::Page;
pub use table::{Column, Table};
pub use ticks::extent;
