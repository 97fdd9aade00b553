//! Flow that separates, Kirchhoff's way and zone by zone (the obvious form: piecewise linear in the angle).

use super::{Kind, Parameter, Sign};
use crate::separation::Separation;
use crate::strips::ZONES;

pub(super) const KIND: Kind = Kind {
    name: "stall",
    parameters: &[
        Parameter::size("k", 0.08, 1.1, Sign::Plus),
        Parameter::shape("alpha_s_deg", 2.5, 7.0, Sign::Plus),
    ],
    separation: |p| {
        let (strength, angle_deg) = (p[0], p[1]);
        let begins = angle_deg.to_radians();
        // the angle at which .157 of it are lost is where a line of slope LOSS from the beginning has lost as much
        let middle = begins / (1.0 - 0.157 / LOSS);
        let by_zone = |zone: usize| middle * (0.95 + 0.1 * zone as f64 / (ZONES - 1) as f64);
        (strength != 0.0).then(|| Separation {
            angle_rad: (0..ZONES).map(by_zone).collect(),
            width_rad: (BEFORE * middle, BEYOND * middle),
            chords: 3.0,
            strength: strength / LOSS,
        })
    },
    ..Kind::NONE
};

/// Lift slope that is lost beyond the beginning, at full strength.
const LOSS: f64 = 0.8;
/// Widths of the exponentials over the angle between them: beyond it about `LOSS` is lost, before it the curve is round, and
/// the lift rises on everywhere.
const BEFORE: f64 = 0.2;
const BEYOND: f64 = 0.55;
