//! What a study says of discrete gusts.

use super::fault::{Fault, is_above_zero};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Most frequencies and most times, as of FREQ1 and TSTEP.
const MOST: f64 = 1e6;

/// A gust: a velocity of the air across the stream, that varies along it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Wave {
    /// Its name.
    pub name: String,
    /// Largest velocity of one minus cosine; what the values of `points` are multiplied with.
    pub amplitude: f64,
    /// Length from nothing to the largest velocity of one minus cosine, whose whole is twice as long.
    #[serde(default)]
    pub gradient: Option<f64>,
    /// Times (s, rising) at which the front feels a gust of any other form, and its values, straight lines between; nothing before and after.
    #[serde(default)]
    pub points: Vec<(f64, f64)>,
}

/// Frequencies at which the answer is computed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Frequencies {
    /// Distance of one from the next, Hz; answers in time repeat after one over it.
    pub step_hz: f64,
    /// The highest, Hz.
    pub highest_hz: f64,
    /// The lowest, Hz; without it one step, as an aircraft free to move has no answer at rest.
    #[serde(default)]
    pub lowest_hz: Option<f64>,
}

/// Times of the answer, from zero.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Times {
    /// Distance of one from the next, s.
    pub step_s: f64,
    /// The last, s.
    pub end_s: f64,
}

/// Discrete gusts in one flow.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Gusts {
    /// Mach number of the air forces.
    pub mach: f64,
    /// Airspeed.
    pub v: f64,
    /// Density.
    pub rho: f64,
    /// Where the air of the gusts goes, degrees about the stream from up (z); 90 is to the right (y).
    #[serde(default)]
    pub direction_deg: f64,
    /// Place along the stream that feels a gust from the time zero on; without it the foremost corner of the boxes.
    #[serde(default)]
    pub front_x: Option<f64>,
    /// The gusts.
    pub waves: Vec<Wave>,
    /// Frequencies.
    pub frequencies: Frequencies,
    /// Times.
    pub times: Times,
    /// Grids whose motions are written.
    #[serde(default)]
    pub grids: Vec<u32>,
}

impl Frequencies {
    /// The lowest frequency, Hz.
    pub(super) fn first_hz(&self) -> f64 {
        self.lowest_hz.unwrap_or(self.step_hz)
    }

    /// How many steps there are from the lowest to the highest.
    pub(super) fn steps(&self) -> f64 {
        ((self.highest_hz - self.first_hz()) / self.step_hz).round()
    }
}

impl Times {
    /// How many steps there are.
    pub(super) fn steps(&self) -> f64 {
        (self.end_s / self.step_s).round()
    }
}

impl Gusts {
    /// What is wrong with it, if anything is.
    pub(super) fn fault(&self) -> Option<Fault> {
        if !(0.0..1.0).contains(&self.mach) {
            let message = format!("a Mach number of {}: the doublet lattice is subsonic", self.mach);
            return Some(Fault::new("gusts.mach", message));
        }
        let Frequencies { step_hz, highest_hz, .. } = self.frequencies;
        for (field, value) in [
            ("gusts.v", self.v),
            ("gusts.rho", self.rho),
            ("gusts.step_hz", step_hz),
            ("gusts.highest_hz", highest_hz),
            ("gusts.step_s", self.times.step_s),
            ("gusts.end_s", self.times.end_s),
        ] {
            if !is_above_zero(value) {
                return Some(Fault::new(field, format!("{value} where a number above zero is expected")));
            }
        }
        let first_hz = self.frequencies.first_hz();
        if !(0.0..=highest_hz).contains(&first_hz) {
            let message = format!("frequencies from {first_hz} to {highest_hz} Hz");
            return Some(
                Fault::new("gusts.frequencies", message)
                    .with_help("the lowest is not below zero, nor above the highest"),
            );
        }
        for (field, steps) in
            [("gusts.frequencies", self.frequencies.steps()), ("gusts.times", self.times.steps())]
        {
            if !(1.0..=MOST).contains(&steps) {
                let message = format!("{steps} steps, where 1 to {MOST} are expected");
                return Some(Fault::new(field, message));
            }
        }
        if self.waves.is_empty() {
            return Some(Fault::new("gusts.waves", "gusts without waves ask for nothing"));
        }
        self.waves.iter().find_map(Wave::fault)
    }
}

impl Wave {
    fn fault(&self) -> Option<Fault> {
        let refuse = |what: &str| Some(Fault::new("waves", format!("the gust {}: {what}", self.name)));
        if !(self.amplitude != 0.0 && self.amplitude.is_finite()) {
            return refuse("an amplitude other than zero is expected");
        }
        match (self.gradient, self.points.as_slice()) {
            (Some(gradient), []) if is_above_zero(gradient) => None,
            (Some(_), []) => refuse("a gradient above zero is expected"),
            (None, [_, _, ..]) if self.points.windows(2).all(|pair| pair[0].0 <= pair[1].0) => None,
            (None, [_, _, ..]) => refuse("the times of its points fall"),
            _ => refuse("either a gradient or two points or more are expected"),
        }
    }
}
