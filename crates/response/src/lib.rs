//! Response surfaces of measured coefficients: polynomials in a few factors, chosen and tested by statistics.

pub mod asymmetry;
pub mod mav;

mod data;
mod fault;
mod term;

pub use data::{Blocks, Data};
pub use fault::Fault;
pub use term::Term;
