//! Gusts: a vertical velocity that is frozen in the air and met by one box after the other.
//!
//! A gust w(t) at the reference point `x_0` meets the box at x later by (x - `x_0`)/V. In frequency its incidence is
//! `w_j = n_z (w/V) exp(-i omega (x_j - x_0)/V)`, the air forces follow from the doublet lattice, and the answer in time from a
//! Fourier series with a period long enough for it to die away (Rodden and Johnson, *MSC/NASTRAN Aeroelastic Analysis User's
//! Guide*, 1994, sec. 2.9).

mod elastic;
mod periodic;
mod shape;
mod table;

pub use elastic::elastic_response;
pub use periodic::{Periodic, periodic_response};
pub use shape::OneMinusCosineGust;
pub use table::{FrequencyTable, gust_incidence, gust_incidence_along};
