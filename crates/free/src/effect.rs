//! What may be missing from a linear section: springs, dampers and losses of lift that are not linear.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The section at an instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Instant {
    /// Heave rate, m/s.
    pub heave_rate_m_s: f64,
    /// Pitch about the middle of the motion at rest, rad.
    pub pitch_rad: f64,
    /// Pitch rate, rad/s.
    pub pitch_rate_rad_s: f64,
    /// Airspeed, m/s.
    pub v_m_s: f64,
    /// Dynamic pressure times lifting span times chord, N.
    pub pressed_n: f64,
    /// Chord, m.
    pub chord_m: f64,
    /// Circular frequency of the motion, rad/s.
    pub omega_rad_s: f64,
}

/// A family of missing effects. All act on the left of the equations.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Effect {
    /// Pitch spring with a part that grows with the cube of the angle.
    CubicPitch,
    /// With the fifth power.
    QuinticPitch,
    /// With the square of the angle, whatever its sign.
    QuadraticPitch,
    /// With the angle times its size.
    AbsolutePitch,
    /// Stiffer beyond an angle.
    BilinearPitch,
    /// Stiffer by and by about an angle, and then stays: a spring whose arm turns.
    StiffeningPitch,
    /// Without spring within an angle.
    FreeplayPitch,
    /// Dry friction of the pitch axis.
    DryPitch,
    /// Damping with the square of the pitch rate.
    QuadraticPitchDamping,
    /// Pitch damping that does not grow with the frequency.
    HystereticPitch,
    /// Dry friction of the heave guide.
    DryHeave,
    /// Lift lost beyond an incidence.
    LiftStall,
    /// Nose-down moment beyond an incidence.
    MomentStall,
}

/// A parameter of an effect.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameter {
    /// Its name with its unit.
    pub name: &'static str,
    /// What it may be.
    pub bounds: [f64; 2],
    /// Standard deviation of what is expected before any data.
    pub plausible: f64,
    /// About which value.
    pub centre: f64,
}

const fn about_zero(name: &'static str, bounds: [f64; 2], plausible: f64) -> Parameter {
    Parameter { name, bounds, plausible, centre: 0.0 }
}

/// A stall begins at about this incidence, and hardly below eight degrees.
const STALL_ANGLE: Parameter =
    Parameter { name: "onset_rad", bounds: [0.14, 0.5], plausible: 0.04, centre: 0.2 };
/// The incidence about which the section moves, rad: the rig was set by eye.
const STALL_MEAN: Parameter =
    Parameter { name: "mean_incidence_rad", bounds: [-0.15, 0.15], plausible: 0.05, centre: 0.0 };
/// Dry friction is rounded below this rate, rad/s and m/s: a sign that jumps cannot be integrated.
const SLOW: f64 = 2e-3;

impl Effect {
    /// All of them.
    pub const ALL: [Self; 13] = [
        Self::CubicPitch,
        Self::QuinticPitch,
        Self::QuadraticPitch,
        Self::AbsolutePitch,
        Self::BilinearPitch,
        Self::StiffeningPitch,
        Self::FreeplayPitch,
        Self::DryPitch,
        Self::QuadraticPitchDamping,
        Self::HystereticPitch,
        Self::DryHeave,
        Self::LiftStall,
        Self::MomentStall,
    ];

    /// What it is called.
    pub fn name(self) -> &'static str {
        match self {
            Self::CubicPitch => "cubic_pitch",
            Self::QuinticPitch => "quintic_pitch",
            Self::QuadraticPitch => "quadratic_pitch",
            Self::AbsolutePitch => "absolute_pitch",
            Self::BilinearPitch => "bilinear_pitch",
            Self::StiffeningPitch => "stiffening_pitch",
            Self::FreeplayPitch => "freeplay_pitch",
            Self::DryPitch => "dry_pitch",
            Self::QuadraticPitchDamping => "quadratic_pitch_damping",
            Self::HystereticPitch => "hysteretic_pitch",
            Self::DryHeave => "dry_heave",
            Self::LiftStall => "lift_stall",
            Self::MomentStall => "moment_stall",
        }
    }

    /// The family whose members data of free motion tell apart less well than families.
    pub fn family(self) -> Family {
        match self {
            Self::CubicPitch
            | Self::QuinticPitch
            | Self::AbsolutePitch
            | Self::BilinearPitch
            | Self::StiffeningPitch => Family::HardeningPitch,
            Self::QuadraticPitch => Family::UnevenPitch,
            Self::FreeplayPitch => Family::FreeplayPitch,
            Self::DryPitch => Family::DryPitch,
            Self::QuadraticPitchDamping | Self::HystereticPitch => Family::PitchDamping,
            Self::DryHeave => Family::DryHeave,
            Self::LiftStall => Family::LiftStall,
            Self::MomentStall => Family::MomentStall,
        }
    }

    /// Its parameters.
    pub fn parameters(self) -> Vec<Parameter> {
        match self {
            Self::CubicPitch => vec![about_zero("k3_nm_rad3", [0.0, 5e4], 3e3)],
            Self::QuinticPitch => vec![about_zero("k5_nm_rad5", [0.0, 3e6], 3e5)],
            Self::QuadraticPitch => vec![about_zero("k2_nm_rad2", [-3e3, 3e3], 300.0)],
            Self::AbsolutePitch => vec![about_zero("k_abs_nm_rad2", [0.0, 5e3], 300.0)],
            Self::BilinearPitch => vec![
                about_zero("k_beyond_nm_rad", [0.0, 500.0], 40.0),
                Parameter { name: "gap_rad", bounds: [0.01, 0.12], plausible: 0.03, centre: 0.05 },
            ],
            Self::StiffeningPitch => vec![
                about_zero("k_beyond_nm_rad", [0.0, 1e3], 60.0),
                Parameter { name: "about_rad", bounds: [0.02, 0.4], plausible: 0.06, centre: 0.08 },
            ],
            Self::FreeplayPitch => {
                vec![Parameter { name: "half_gap_rad", bounds: [0.0, 0.05], plausible: 0.005, centre: 0.0 }]
            }
            Self::DryPitch => vec![about_zero("friction_nm", [0.0, 1.0], 0.05)],
            Self::QuadraticPitchDamping => vec![about_zero("c2_nm_s2", [0.0, 5.0], 0.3)],
            Self::HystereticPitch => vec![about_zero("loss_nm_rad", [0.0, 50.0], 3.0)],
            Self::DryHeave => vec![about_zero("friction_n", [0.0, 30.0], 1.0)],
            Self::LiftStall => vec![about_zero("lost", [0.0, 1.0], 0.4), STALL_ANGLE, STALL_MEAN],
            Self::MomentStall => vec![about_zero("slope_per_rad", [0.0, 50.0], 3.0), STALL_ANGLE, STALL_MEAN],
        }
    }

    /// Where fits begin, in standard deviations of what is plausible: from nothing, and from sizes that show.
    pub fn starts(self) -> Vec<Vec<f64>> {
        match self {
            Self::LiftStall | Self::MomentStall => {
                // a stall beyond the measured angles moves nothing: a fit would stay where it is
                vec![vec![0.0; 3], vec![1.0, -1.5, 2.0], vec![1.0, -1.5, -2.0]]
            }
            Self::BilinearPitch | Self::StiffeningPitch => {
                vec![vec![0.0; 2], vec![0.5, -0.5], vec![1.0, 0.5]]
            }
            _ => vec![vec![0.0], vec![0.5], vec![2.0]],
        }
    }

    /// Force (N) and moment (N m) on the left of the equations, with the section's pitch stiffness (N m/rad) for what lacks it.
    pub fn loads(self, p: &[f64], at: &Instant, pitch_stiffness_nm: f64) -> [f64; 2] {
        let a = at.pitch_rad;
        let beyond = |angle: f64, onset: f64| (angle.abs() - onset).max(0.0).copysign(angle);
        let moment = match self {
            Self::CubicPitch => p[0] * a.powi(3),
            Self::QuinticPitch => p[0] * a.powi(5),
            Self::QuadraticPitch => p[0] * a * a,
            Self::AbsolutePitch => p[0] * a * a.abs(),
            Self::BilinearPitch => p[0] * beyond(a, p[1]),
            Self::StiffeningPitch => p[0] * a.powi(3) / (a * a + p[1] * p[1]),
            Self::FreeplayPitch => pitch_stiffness_nm * (beyond(a, p[0]) - a),
            Self::DryPitch => p[0] * rounded_sign(at.pitch_rate_rad_s),
            Self::QuadraticPitchDamping => p[0] * at.pitch_rate_rad_s * at.pitch_rate_rad_s.abs(),
            Self::HystereticPitch => p[0] * at.pitch_rate_rad_s / at.omega_rad_s,
            Self::DryHeave => return [p[0] * rounded_sign(at.heave_rate_m_s), 0.0],
            Self::LiftStall => {
                let incidence = a + p[2] + at.heave_rate_m_s / at.v_m_s;
                return [-p[0] * std::f64::consts::TAU * at.pressed_n * beyond(incidence, p[1]), 0.0];
            }
            Self::MomentStall => {
                let incidence = a + p[2] + at.heave_rate_m_s / at.v_m_s;
                p[0] * at.pressed_n * at.chord_m * beyond(incidence, p[1])
            }
        };
        [0.0, moment]
    }
}

/// The sign of a rate, rounded where it is slow.
fn rounded_sign(rate: f64) -> f64 {
    rate / rate.hypot(SLOW)
}

/// Effects that free motion hardly tells apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Family {
    /// A pitch spring that grows stiffer on both sides.
    HardeningPitch,
    /// One that is stiffer on one side.
    UnevenPitch,
    /// Freeplay of the pitch axis.
    FreeplayPitch,
    /// Dry friction of the pitch axis.
    DryPitch,
    /// Pitch damping that is not viscous.
    PitchDamping,
    /// Dry friction in heave.
    DryHeave,
    /// Lift that stalls.
    LiftStall,
    /// Moment that stalls.
    MomentStall,
}

impl Family {
    /// In words.
    pub fn title(self) -> &'static str {
        match self {
            Self::HardeningPitch => "a pitch spring that hardens",
            Self::UnevenPitch => "a pitch spring that is stiffer on one side",
            Self::FreeplayPitch => "freeplay of the pitch axis",
            Self::DryPitch => "dry friction of the pitch axis",
            Self::PitchDamping => "pitch damping that is not viscous",
            Self::DryHeave => "dry friction in heave",
            Self::LiftStall => "a stall of the lift",
            Self::MomentStall => "a stall of the moment",
        }
    }
}

/// An effect with its size.
#[derive(Debug, Clone, PartialEq)]
pub struct Active {
    /// Which.
    pub effect: Effect,
    /// Values of its parameters, in their order.
    pub values: Vec<f64>,
}
