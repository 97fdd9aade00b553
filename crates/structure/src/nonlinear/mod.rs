//! Structures that bend far: one corotation around every linear element, equilibria by Newton's method.
//!
//! Strains are small, places and rotations of nodes are not. Each element is seen from a frame that turns with it; there
//! its displacements are small, and its linear stiffness, whatever it is made of, gives the forces (Nour-Omid and Rankin,
//! Comput. Methods Appl. Mech. Eng. 93, 1991; Felippa and Haugen, same journal 194, 2005). Unknowns are displacements and
//! spins (small rotations about axes fixed in space, applied after the rotation reached); rotations are kept as matrices
//! and never added.
//!
//! Limits: small strains, and rotations within one element of some 30 degrees ([`Point::largest_local_rotation`] says how
//! far it went).

mod acting;
mod adjoint;
mod carried;
mod corotated;
mod differences;
mod error;
mod frame;
mod gain;
mod joints;
mod krylov;
mod loads;
mod near;
mod newton;
mod rotation;
mod stability;
mod state;
mod steps;
mod structure;
mod tangent;
mod weight;

pub use acting::Acting;
pub use adjoint::{Transposed, moments_across};
pub use carried::{Carried, CarriedPoint, PlacedCarriers};
pub use differences::differenced;
pub use error::NonlinearError;
pub use joints::reactions_of;
pub(crate) use loads::pressure_shares;
pub use loads::{Following, Loads, NodeLoad};
pub use near::Near;
pub use state::State;
pub use steps::{Controls, Path, Point};
pub use structure::LargeDeflection;
pub use weight::DeadChange;
