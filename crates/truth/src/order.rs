//! What is ordered of the tunnel.

use crate::drive::Servo;
use crate::effects::Effect;

/// A case as it is ordered.
#[derive(Debug, Clone, PartialEq)]
pub struct Order {
    /// Seed of noise, order and, unless it is ordered, servo.
    pub seed: u64,
    /// Number of the true wing; none for the wing as drawn.
    pub wing: Option<u64>,
    /// What is hidden.
    pub effects: Vec<Effect>,
    /// The servos; none: drawn by the seed.
    pub servo: Option<Servo>,
    /// Whether pitch without wind is flown too.
    pub wind_off: bool,
}
