#![doc = include_str!("../README.md")]

pub mod deformed;
pub mod error;
pub mod figure;
pub mod heatmap;
mod paint;
pub mod palette;
pub mod table;
mod thin;
pub mod vtu;

pub use error::DrawError;
pub use figure::{Figure, Panel, Series, Style};
pub use heatmap::PlanformView;
pub use table::Table;
