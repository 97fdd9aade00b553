//! `rig.ron`: what is known of a rig before its free response is looked at, each with its standard deviation.

use crate::air::Strip;
use crate::held_out::HeldOut;
use crate::section::Section;
use nastran::{InputError, ron_file};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// A value and how well it is known.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Known {
    /// The value.
    pub value: f64,
    /// Its standard deviation, in the value's unit.
    pub sd: f64,
}

/// A rigid wing on a heave and a pitch spring. Heave is positive down, pitch nose up.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Rig {
    /// What it is called.
    pub name: String,
    /// Half of the chord, m.
    pub semichord_m: f64,
    /// The pitch axis behind mid-chord, in half chords.
    pub axis: Known,
    /// Span times the factor on the lift of thin sections in plane flow, m.
    pub lifting_span_m: Known,
    /// Part of plane flow's lag of the lift that is there; a wing of finite span has less than all of it.
    pub lag: Known,
    /// Everything that heaves, kg.
    pub mass_kg: Known,
    /// Mass times distance of the centre of gravity behind the axis, kg m.
    pub unbalance_kgm: Known,
    /// Moment of inertia about the axis, kg m2.
    pub inertia_kg_m2: Known,
    /// Heave spring, N/m.
    pub heave_stiffness_n_per_m: Known,
    /// Viscous damper in heave, N s/m.
    pub heave_damping_n_s_per_m: Known,
    /// Pitch spring for small angles, N m (a radian).
    pub pitch_stiffness_nm: Known,
    /// Viscous damper in pitch, N m s.
    pub pitch_damping_nm_s: Known,
    /// What the heave sensor shows per heave; 1 if its scale is right.
    pub heave_gain: Known,
    /// Factors on that which are as likely: a scale of which the decimal point is not certain.
    #[serde(default = "one")]
    pub heave_scales: Vec<f64>,
    /// By how much the heave sensor is later than the pitch sensor, s.
    pub heave_delay_s: Known,
    /// Scatter of the pitch spring from day to day, as a part of it.
    pub day_stiffness_sd: f64,
    /// Scatter of the pitch damper from day to day, as a part of it.
    pub day_damping_sd: f64,
    /// Scatter of the measurements about any model.
    pub scatter: Scatter,
    /// What of the campaign is kept from the fit.
    #[serde(default)]
    pub held_out: HeldOut,
}

fn one() -> Vec<f64> {
    vec![1.0]
}

/// How far an oscillation that is measured may be from one that a right model has.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Scatter {
    /// Of the amplitude, as a part of it.
    pub amplitude: f64,
    /// Of the frequency, as a part of it.
    pub frequency: f64,
    /// Of heave per pitch, as a part of it.
    pub heave_ratio: f64,
    /// Of growth, 1/s.
    pub growth_per_s: f64,
    /// Of the airspeed, m/s.
    pub airspeed_m_s: f64,
    /// Of second and third harmonics, as a part of the first.
    pub harmonics: f64,
    /// Turbulence moves an oscillation of this amplitude by its own size in a second, rad.
    pub turbulence_rad: f64,
}

/// Number of parameters of the linear rig.
pub(crate) const LINEAR: usize = 12;

impl Rig {
    /// Reads a rig's file.
    ///
    /// # Errors
    /// If it cannot be read, a value that must be above zero is not, or a standard deviation is negative.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let rig: Self = ron_file::read(path)?;
        rig.check().map_err(|error| error.or_in(path))?;
        Ok(rig)
    }

    fn check(&self) -> Result<(), InputError> {
        let scatter = &self.scatter;
        let above_zero = [
            ("semichord_m", self.semichord_m),
            ("lifting_span_m", self.lifting_span_m.value),
            ("mass_kg", self.mass_kg.value),
            ("inertia_kg_m2", self.inertia_kg_m2.value),
            ("heave_stiffness_n_per_m", self.heave_stiffness_n_per_m.value),
            ("pitch_stiffness_nm", self.pitch_stiffness_nm.value),
            ("heave_damping_n_s_per_m", self.heave_damping_n_s_per_m.value),
            ("pitch_damping_nm_s", self.pitch_damping_nm_s.value),
            ("heave_gain", self.heave_gain.value),
            ("scatter: amplitude", scatter.amplitude),
            ("scatter: frequency", scatter.frequency),
            ("scatter: heave_ratio", scatter.heave_ratio),
            ("scatter: growth_per_s", scatter.growth_per_s),
            ("scatter: airspeed_m_s", scatter.airspeed_m_s),
            ("scatter: harmonics", scatter.harmonics),
            ("scatter: turbulence_rad", scatter.turbulence_rad),
        ];
        if let Some((name, value)) = above_zero.into_iter().find(|(_, value)| *value <= 0.0) {
            return Err(InputError::general(format!("{name} is {value}; it must be above zero")));
        }
        if self.heave_scales.is_empty() || self.heave_scales.iter().any(|scale| *scale <= 0.0) {
            return Err(InputError::general("heave_scales needs one factor at least, each above zero"));
        }
        let sds = self.linear().map(|(known, _)| known.sd);
        if let Some(sd) = sds.into_iter().find(|sd| *sd < 0.0) {
            return Err(InputError::general(format!("a standard deviation is {sd}; it cannot be negative")));
        }
        if self.unbalance_kgm.value.powi(2) >= self.mass_kg.value * self.inertia_kg_m2.value {
            return Err(InputError::general(
                "no body has this mass, unbalance and inertia: unbalance squared must be below mass times inertia",
            ));
        }
        Ok(())
    }

    /// The rig with each of the scales that its heave sensor may have.
    pub fn scaled(&self) -> Vec<Self> {
        let of = |scale: &f64| {
            let Known { value, sd } = self.heave_gain;
            Self { heave_gain: Known { value: value * scale, sd: sd * scale }, ..self.clone() }
        };
        self.heave_scales.iter().map(of).collect()
    }

    /// The linear parameters in order; true for those that are above zero, whose logarithm is normal.
    fn linear(&self) -> [(Known, bool); LINEAR] {
        [
            (self.mass_kg, true),
            (self.unbalance_kgm, false),
            (self.inertia_kg_m2, true),
            (self.heave_stiffness_n_per_m, true),
            (self.heave_damping_n_s_per_m, true),
            (self.pitch_stiffness_nm, true),
            (self.pitch_damping_nm_s, true),
            (self.lifting_span_m, true),
            (self.axis, false),
            (self.heave_gain, true),
            (self.heave_delay_s, false),
            (self.lag, false),
        ]
    }

    /// The rig so many standard deviations from what is known.
    pub fn at(&self, x: &[f64]) -> LinearRig {
        let linear = self.linear();
        let value = |k: usize| {
            let (Known { value, sd }, above_zero) = linear[k];
            if above_zero { value * (sd / value * x[k]).exp() } else { value + sd * x[k] }
        };
        LinearRig {
            section: Section {
                mass_kg: value(0),
                unbalance_kgm: value(1),
                inertia_kg_m2: value(2),
                heave_stiffness_n_per_m: value(3),
                heave_damping_n_s_per_m: value(4),
                pitch_stiffness_nm: value(5),
                pitch_damping_nm_s: value(6),
                strip: Strip {
                    lifting_span_m: value(7),
                    axis: value(8),
                    lag: value(11),
                    semichord_m: self.semichord_m,
                },
            },
            heave_gain: value(9),
            heave_delay_s: value(10),
        }
    }
}

/// A section and the sensor that sees its heave.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearRig {
    /// The section.
    pub section: Section,
    /// What the sensor shows per heave.
    pub heave_gain: f64,
    /// How much later than the pitch, s.
    pub heave_delay_s: f64,
}
