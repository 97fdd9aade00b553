//! Wings whose lift is off the drawing, for judging calibrations at rest: by what polars and built wings are off by, rough from place to
//! place, in steps at the ailerons, or separated within the angles that are measured. The README argues the sizes.

use crate::draw::off;
use crate::profile::Profile;
use crate::random::{Purpose, Random};
use crate::setting::{Setting, Stall};
use crate::wing::Wing;

/// How the lift is off.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// By what polars and built wings are off by, in waves along the span.
    Polars,
    /// From place to place, without a shape: surface, joints, gaps.
    Rough,
    /// In steps at the ailerons' ends: gaps at the hinge, rigging.
    Stepped,
    /// As by polars, and the flow separates within the angles that are measured.
    Separated,
}

impl Kind {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Polars, Self::Rough, Self::Stepped, Self::Separated];

    /// Its name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Polars => "polars",
            Self::Rough => "rough",
            Self::Stepped => "stepped",
            Self::Separated => "separated",
        }
    }
}

/// Standard deviations of a whole wing and of its places along the span: stiffness, lift slope beside the polars.
const BENDING: (f64, f64) = (0.025, 0.02);
const TORSION: (f64, f64) = (0.04, 0.03);
const SLOPE: (f64, f64) = (0.03, 0.02);
/// Of the angle of zero lift, degrees; of the place of lift, share of the chord; of moment coefficients.
const ZERO_DEG: (f64, f64) = (0.4, 0.3);
const LIFT_AFT: (f64, f64) = (0.006, 0.005);
const MOMENT: (f64, f64) = (0.004, 0.003);
/// Of all mass, of the airspeed, of what a correction for walls leaves (rad for a lift coefficient of one).
const MASS: f64 = 0.01;
const AIRSPEED: f64 = 0.002;
const WALL_RAD: f64 = 0.003;
/// Effect of flaps: least, and the standard deviation of each about the wing's.
const FLAP: (f64, f64) = (0.85, 0.03);
/// What the tip carries less, from and to, and over which share of the span.
const TIP_LOSS: (f64, f64) = (-0.03, 0.12);
const TIP_REACH: (f64, f64) = (0.05, 0.2);
/// Rough: number of cells from and to, of their lift and angle of zero lift (degrees).
const CELLS: (f64, f64) = (6.0, 16.0);
const CELL_LIFT: f64 = 0.08;
const CELL_ZERO_DEG: f64 = 0.4;
/// Steps: most loss of lift over an aileron, and how it is rigged, degrees.
const STEP_LOSS: f64 = 0.12;
const STEP_ZERO_DEG: f64 = 0.5;
/// Separation: angle from and to (degrees), share of the incidence lost from and to, knee.
const STALL_DEG: (f64, f64) = (2.0, 4.5);
const STALL_SHARE: (f64, f64) = (0.4, 0.9);
const KNEE_DEG: f64 = 0.8;
const STALL_CHORDS: f64 = 4.0;

/// The wing of a kind and a number.
pub fn off_drawing(wing: &Wing, kind: Kind, number: u64) -> Setting {
    let random = &mut Random::new(number, Purpose::Lift(kind as u64));
    let mut setting = Setting::drawn(wing.damping_ratio, wing.controls.len());
    setting.bending = off(1.0, BENDING, random);
    setting.torsion = off(1.0, TORSION, random);
    setting.mass = Profile::even(1.0 + random.normal(MASS));
    setting.airspeed = 1.0 + random.normal(AIRSPEED);
    setting.wall_rad = random.normal(WALL_RAD);
    setting.slope = off(1.0, SLOPE, random);
    setting.zero_rad = off(0.0, (ZERO_DEG.0.to_radians(), ZERO_DEG.1.to_radians()), random);
    setting.aft_over_c = off(0.0, LIFT_AFT, random);
    setting.moment = off(0.0, MOMENT, random);
    let flaps = between((FLAP.0, 1.0), random);
    setting.flap.iter_mut().for_each(|flap| *flap = flaps + random.normal(FLAP.1));
    let (loss, reach) = (between(TIP_LOSS, random), between(TIP_REACH, random));
    setting.lift.scale(|eta| 1.0 - loss * (-(1.0 - eta) / reach).exp());
    match kind {
        Kind::Polars => {}
        Kind::Rough => {
            let count = between(CELLS, random);
            let lift = cells(count, CELL_LIFT, random);
            setting.lift.scale(|eta| 1.0 + lift(eta));
            setting.zero_rad.add(cells(count, CELL_ZERO_DEG.to_radians(), random));
        }
        Kind::Stepped => {
            for control in &wing.controls {
                let ends = [control.y_m.0, control.y_m.1].map(|y_m| y_m / wing.planform.semispan_m);
                let loss = between((0.0, STEP_LOSS), random);
                let turned = random.normal(STEP_ZERO_DEG.to_radians());
                let there = move |eta: f64| f64::from(u8::from((ends[0]..ends[1]).contains(&eta)));
                setting.lift.scale(|eta| 1.0 - loss * there(eta));
                setting.zero_rad.add(|eta| turned * there(eta));
            }
        }
        Kind::Separated => {
            setting.stall = Some(Stall {
                angle_rad: between(STALL_DEG, random).to_radians(),
                share: between(STALL_SHARE, random),
                knee_rad: KNEE_DEG.to_radians(),
                chords: STALL_CHORDS,
            });
        }
    }
    setting
}

fn between((from, to): (f64, f64), random: &mut Random) -> f64 {
    from + (to - from) * random.unit()
}

/// Cells of even width, a normal number each.
fn cells(count: f64, sigma: f64, random: &mut Random) -> impl Fn(f64) -> f64 + use<> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few cells")]
    let count = count as usize;
    let values: Vec<f64> = (0..count).map(|_| random.normal(sigma)).collect();
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and a few")]
    move |eta| values[((eta * count as f64) as usize).min(count - 1)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    #[test]
    fn numbers_and_kinds_differ_and_repeat() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex/wing_beam.ron");
        let wing = Wing::read(&path).unwrap();
        for kind in Kind::ALL {
            assert!(off_drawing(&wing, kind, 3) == off_drawing(&wing, kind, 3));
            assert!(off_drawing(&wing, kind, 3) != off_drawing(&wing, kind, 4));
            assert_eq!(off_drawing(&wing, kind, 3).stall.is_some(), kind == Kind::Separated);
        }
        assert!(off_drawing(&wing, Kind::Polars, 3) != off_drawing(&wing, Kind::Rough, 3));
    }
}
