//! A wing that is not what theory and its drawing say.

use aero::Corrections;
use coupling::{ByLoad, ElasticWing};

/// A wing off its theory.
#[derive(Debug, Clone, PartialEq)]
pub struct WingOff {
    /// Corrections of the boxes.
    pub corrections: Corrections,
    /// Factor on what each control surface does.
    pub controls: Vec<f64>,
    /// What each does in Fz, Mx, My of the balance beyond that, as a share.
    pub in_channels: Vec<ByLoad<f64>>,
    /// Logarithms of the factors on the flexibility in bending and in torsion.
    pub log_flexibility: [f64; 2],
}

impl WingOff {
    /// Theory.
    pub(super) fn theory(wing: &ElasticWing) -> Self {
        Self {
            corrections: Corrections::neutral(wing.correctable.len()),
            controls: vec![1.0; wing.controls.len()],
            in_channels: vec![ByLoad::default(); wing.controls.len()],
            log_flexibility: [0.0; 2],
        }
    }
}
