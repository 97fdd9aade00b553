//! Whether two campaigns are flown alike, so that what is found in one where nothing is missing is found in the other: the same
//! loads, points and runs at the same airspeeds, moved alike within what a turntable is set to.

use crate::data::{Dataset, RunData, StaticGroup};
use maneuver::effects::Stimulus;

impl Dataset {
    /// See the module. Measured loads have no part in it, and no statement of noise.
    pub fn has_design_of(&self, other: &Self) -> bool {
        let speeds = (self.airspeeds_m_s.iter().zip(&other.airspeeds_m_s))
            .all(|(own, other)| (own - other).abs() <= self.rules.data.same_airspeed * own);
        self.airspeeds_m_s.len() == other.airspeeds_m_s.len()
            && speeds
            && self.run_loads == other.run_loads
            && alike(&self.runs, &other.runs, |own, other| self.is_run_like(own, other))
            && alike(&self.statics, &other.statics, |own, other| self.is_group_like(own, other))
    }

    fn is_run_like(&self, own: &RunData, other: &RunData) -> bool {
        own.usage == other.usage
            && own.airspeed == other.airspeed
            && own.repeat_of == other.repeat_of
            && own.decimation == other.decimation
            && self.is_moved_like(&own.stimulus, &other.stimulus)
    }

    fn is_group_like(&self, own: &StaticGroup, other: &StaticGroup) -> bool {
        let there = |group: &StaticGroup| -> Vec<[bool; 3]> {
            group.measured.iter().map(|loads| loads.map(|load| load.is_some())).collect()
        };
        own.usage == other.usage
            && own.airspeed == other.airspeed
            && own.blocks == other.blocks
            && there(own) == there(other)
            && self.is_moved_like(&own.stimulus, &other.stimulus)
    }

    /// Angle and deflections, root mean square of their differences.
    pub(crate) fn is_moved_like(&self, own: &Stimulus, other: &Stimulus) -> bool {
        let same_angle_rad = self.rules.noise.same_angle_rad;
        let near = |own: &Vec<f64>, other: &Vec<f64>| {
            let square: f64 = own.iter().zip(other).map(|(a, b)| (a - b).powi(2)).sum();
            own.len() == other.len() && (square / own.len().max(1) as f64).sqrt() <= same_angle_rad
        };
        // a step that is rounded in a file makes no other record
        let steps = (own.time_step_s - other.time_step_s).abs() <= 1e-6 * own.time_step_s;
        own.steady == other.steady
            && steps
            && near(&own.inputs.alpha.value, &other.inputs.alpha.value)
            && alike(&own.inputs.controls_rad, &other.inputs.controls_rad, near)
    }
}

/// Whether as many of one are as those of the other, one by one.
fn alike<T>(own: &[T], other: &[T], are: impl Fn(&T, &T) -> bool) -> bool {
    own.len() == other.len() && own.iter().zip(other).all(|(own, other)| are(own, other))
}
