//! A maneuver's motions as samples. Angles of attack need two derivatives: one-minus-cosines and chirps have them in
//! closed form; what jumps, and a user's own signal, passes the smoothing that a measured angle passes.

use super::{ManeuverFile, MotionSpec};
use crate::rig_model::{Motion, RigModel};
use crate::signals::{Chirp, Doublet, OneMinusCosine, Signal, Step, ThreeTwoOneOne};
use crate::smoothing::{Smooth, smooth_from_rest};

impl MotionSpec {
    /// The motion as a signal, rad; none for a file.
    fn signal(&self) -> Option<Box<dyn Signal>> {
        Some(match *self {
            Self::OneMinusCosine { height_deg, frequency_hz, start_s, .. } => {
                Box::new(OneMinusCosine { base: 0.0, height: height_deg.to_radians(), frequency_hz, start_s })
            }
            Self::Doublet { height_deg, frequency_hz, start_s, .. } => {
                Box::new(Doublet { height: height_deg.to_radians(), frequency_hz, start_s })
            }
            Self::Chirp { height_deg, from_hz, to_hz, duration_s, start_s, .. } => {
                Box::new(Chirp { height: height_deg.to_radians(), from_hz, to_hz, duration_s, start_s })
            }
            Self::Step { height_deg, start_s, .. } => {
                Box::new(Step { height: height_deg.to_radians(), start_s })
            }
            Self::ThreeTwoOneOne { height_deg, unit_s, start_s, .. } => {
                Box::new(ThreeTwoOneOne { height: height_deg.to_radians(), unit_s, start_s })
            }
            Self::FromFile { .. } => return None,
        })
    }
}

impl ManeuverFile {
    /// Commanded values of what `of` names, without the angle's own beginning, rad.
    pub(super) fn sampled(&self, of: &str, keep: impl Fn(&MotionSpec) -> bool) -> Vec<f64> {
        let times = self.times();
        let mut sum = vec![0.0; times.len()];
        let mut own = self.own.iter();
        for spec in &self.motions {
            let file = if matches!(spec, MotionSpec::FromFile { .. }) { own.next() } else { None };
            if !keep(spec) {
                continue;
            }
            if let (Some(signal), true) = (spec.signal(), spec.of() == Some(of)) {
                sum.iter_mut().zip(&times).for_each(|(sum, &t_s)| *sum += signal.at(t_s));
            }
            for (file, values) in file.iter().flat_map(|file| {
                file.columns.iter().filter(|(name, ..)| name == of).map(move |(.., values)| (file, values))
            }) {
                sum.iter_mut()
                    .zip(&times)
                    .for_each(|(sum, &t_s)| *sum += file.at(values, t_s - spec.start_s()));
            }
        }
        sum
    }

    /// Angle of attack and commanded deflections, for [`crate::fly_commanded`]. Controls that the wing does not have are
    /// left out: [`ManeuverFile::checked`] refuses them.
    pub fn motion(&self, model: &RigModel) -> Motion {
        let times = self.times();
        let time_step_s = 1.0 / self.sample_rate_hz;
        let smooth =
            |spec: &MotionSpec| matches!(spec, MotionSpec::OneMinusCosine { .. } | MotionSpec::Chirp { .. });
        let base = self.alpha_deg.unwrap_or(0.0).to_radians();
        let rough: Vec<f64> = self.sampled("alpha", |spec| !smooth(spec)).iter().map(|a| a + base).collect();
        let mut alpha = if rough.iter().all(|value| *value == rough[0]) {
            Smooth { value: rough, rate: vec![0.0; times.len()], second: vec![0.0; times.len()] }
        } else {
            smooth_from_rest(&rough, time_step_s, model.cutoff_hz)
        };
        for spec in self.motions.iter().filter(|spec| smooth(spec) && spec.of() == Some("alpha")) {
            let Some(signal) = spec.signal() else { continue };
            for (i, &t_s) in times.iter().enumerate() {
                alpha.value[i] += signal.at(t_s);
                alpha.rate[i] += signal.rate(t_s);
                alpha.second[i] += signal.second(t_s);
            }
        }
        let controls_rad = model.controls.iter().map(|name| self.sampled(name, |_| true)).collect();
        Motion { time_step_s, alpha, controls_rad }
    }
}
