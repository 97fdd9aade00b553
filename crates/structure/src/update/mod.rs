//! Static and modal update in the small: factors of regions' stiffness and mass, fitted to measurements.
//!
//! K(f) = K + sum (`f_p` - 1) `K_p` over the stiffness factors, likewise M, where `K_p` is what the elements of the
//! region of factor p contribute. Measured are natural frequencies (with shapes, to tell which mode they are of),
//! deflections under loads, and the mass. Factors minimise the sum of squares of (measured - model) / sigma, by
//! Gauss and Newton, with the derivatives
//!
//! - of a frequency: d lambda = x^T (dK - lambda dM) x with x^T M x = 1 (Fox and Kapoor 1968; the mode is a simple one),
//! - of a deflection c^T u with K u = p: -w^T dK u with K w = c,
//! - of the mass: the region's own.
//!
//! What the data do not determine is said, not guessed: directions of the factors whose standard deviation is beyond
//! [`Settings::undetermined`] are left as they are.

mod determination;
pub mod file;
mod fit;
mod forms;
mod mac;
mod measurements;
mod state;

pub use determination::Determination;
pub use file::MeasuredFile;
pub use fit::{Factor, Fit, fit};
pub use mac::modal_assurance;
pub use measurements::{
    AtMotion, MeasuredDeflection, MeasuredMode, Measurements, Parameter, Quantity, Settings, UpdateError,
};
pub use state::{Prediction, State, evaluate};
