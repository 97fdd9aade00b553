//! Campaigns: what is flown, what is recorded with noise, and the files of it.

pub(crate) mod design;
mod files;
pub(crate) mod noise;
mod record;
pub(crate) mod sampling;

pub use design::{Planned, benchmark, wind_off};
pub use files::Files;
pub use record::{Measured, Record, StaticPoint};
