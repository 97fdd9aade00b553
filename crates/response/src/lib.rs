//! Response surfaces of measured coefficients: polynomials in a few factors, chosen and tested by statistics.

pub mod asymmetry;
pub mod mav;

mod columns;
mod data;
mod distributions;
mod fault;
mod qr;
mod regression;
mod reml;
mod term;

pub use data::{Blocks, Data};
pub use fault::Fault;
pub use regression::{BlockOffset, Blocking, Coefficient, Regression};
pub use term::Term;
