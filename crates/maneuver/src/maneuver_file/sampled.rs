//! A maneuver's motions as samples. Angles of attack need two derivatives: kinds that have them in closed form give
//! them; what jumps, and a user's own signal, passes the smoothing that a measured angle passes.

use super::ManeuverFile;
use crate::motion::{ANGLE, MotionSpec};
use crate::rig_model::{Motion, RigModel};
use crate::smoothing::{Smooth, smooth_from_rest};

impl ManeuverFile {
    /// Commanded values of what `of` names, without the angle's own beginning, rad.
    pub(super) fn sampled(&self, of: &str, keep: impl Fn(&MotionSpec) -> bool) -> Vec<f64> {
        let times = self.times();
        let mut sum = vec![0.0; times.len()];
        for spec in self.motions.iter().filter(|spec| spec.moves(of) && keep(spec)) {
            sum.iter_mut().zip(&times).for_each(|(sum, &t_s)| *sum += spec.at(of, t_s));
        }
        sum
    }

    /// Angle of attack and commanded deflections, for [`crate::fly_commanded`]. Controls that the wing does not have are
    /// left out: [`ManeuverFile::checked`] refuses them.
    pub fn motion(&self, model: &RigModel) -> Motion {
        let times = self.times();
        let time_step_s = 1.0 / self.sample_rate_hz;
        let known = |spec: &MotionSpec| spec.kind().has_derivatives();
        let base = self.alpha_deg.unwrap_or(0.0).to_radians();
        let rough: Vec<f64> = self.sampled(ANGLE, |spec| !known(spec)).iter().map(|a| a + base).collect();
        let mut alpha = if rough.iter().all(|value| *value == rough[0]) {
            Smooth { value: rough, rate: vec![0.0; times.len()], second: vec![0.0; times.len()] }
        } else {
            smooth_from_rest(&rough, time_step_s, model.cutoff_hz)
        };
        for kind in self.motions.iter().filter(|spec| known(spec) && spec.moves(ANGLE)).map(MotionSpec::kind)
        {
            for (i, &t_s) in times.iter().enumerate() {
                alpha.value[i] += kind.at(t_s);
                alpha.rate[i] += kind.rate(t_s);
                alpha.second[i] += kind.second(t_s);
            }
        }
        let controls_rad = model.controls.iter().map(|name| self.sampled(name, |_| true)).collect();
        Motion { time_step_s, alpha, controls_rad }
    }
}
