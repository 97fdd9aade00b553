//! Response surfaces.

pub mod asymmetry;
pub mod mav;
