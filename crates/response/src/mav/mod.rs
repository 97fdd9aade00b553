//! The micro air vehicle of "Wind-Tunnel Testing and Modeling of a Micro Air Vehicle with Flexible Wings": its published
//! models (Eqs. 4 to 16 of paper 2) and what is drawn from them.

mod draw;
mod factor;
pub mod figures;
mod model;
mod points;
mod published;
mod runs;

pub use draw::{Balance, Errors, SHIPPED_SEED, Spread, draw, shipped_files, truth};
pub use factor::{Condition, Factor};
pub use model::{Coefficient, Confidence, Model, NoValue, Range, Rules, Status};
pub use points::{
    AIRSPEEDS_M_S, BALANCE_RESOLUTION_N, FULL_NEGATIVE_DEG, NEGATIVE_ELEVATOR_AIRSPEEDS_M_S, RHO_KG_M3,
    ROOT_CHORD_M, SPAN_M, Series, TestPoint, VOLTAGES_V, WING_AREA_M2, dynamic_pressure_pa,
};
pub use published::Published;
pub use runs::{Row, Runs};
