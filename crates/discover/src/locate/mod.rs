//! Where simulation and measurements disagree: a map in units of pure error, and what the residual goes with.

pub mod chirps;
pub mod families;
mod gram;
pub mod maneuver;
pub mod map;
pub mod regressors;
pub mod residuals;
pub mod variances;

pub use chirps::{ChirpCell, chirps};
pub use maneuver::Maneuver;
pub use map::{Cell, map};
pub use regressors::{Located, regressors};
pub use residuals::{PureError, Residuals, Unit};
pub use variances::{VarianceCell, Variances, variances};
