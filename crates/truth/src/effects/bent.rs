//! What a bent wing does to the loads, strip by strip: forces along the chord have an arm, and the arm of the lift is shorter.

use super::{Effect, Record};
use crate::air::Strip;
use crate::rig::Flight;
use std::f64::consts::TAU;

impl Effect {
    pub(crate) fn on_bent_wing(&self, record: &Record<'_>, strips: &[Strip], flight: &mut Flight) {
        if !self.needs_strips() {
            return;
        }
        for i in 0..flight.lift_n.len().min(flight.tip_z_m.len()) {
            let (lift_n, height_m) = (&flight.lift_n[i], &flight.height_m[i]);
            let more = if self.name == "inplane_force" {
                [0.0, 0.0, self.along_the_chord(record, strips, lift_n, height_m)]
            } else {
                shortened(strips, lift_n, height_m).map(|load| self.value(0) * load)
            };
            for (load, more) in flight.loads.iter_mut().zip(more) {
                load[i] += more;
            }
        }
    }

    /// Moment of suction and drag at their heights.
    fn along_the_chord(
        &self,
        record: &Record<'_>,
        strips: &[Strip],
        lift_n: &[f64],
        height_m: &[f64],
    ) -> f64 {
        let (suction, drag) = (self.value(0), self.value(1));
        let of = |s: usize| {
            let pressed = (record.q_pa * strips[s].chord_m * strips[s].width_m).max(1e-9);
            let cl = lift_n[s] / pressed;
            let aft_n = pressed * (drag * (1.0 + 0.25 * cl * cl) - suction * cl * cl / TAU);
            aft_n * height_m[s]
        };
        (0..strips.len()).filter(|s| strips[*s].metric).map(of).sum()
    }
}

/// Fz and Mx that are lost as the span keeps its length and lifts lean inward.
fn shortened(strips: &[Strip], lift_n: &[f64], height_m: &[f64]) -> [f64; 3] {
    let (mut inward_m, mut before) = (0.0, [0.0, 0.0]);
    let mut lost = [0.0; 3];
    for (s, strip) in strips.iter().enumerate().filter(|(_, strip)| strip.metric) {
        let along_m = strip.y_m - before[0];
        let turned = ((height_m[s] - before[1]) / along_m).clamp(-0.95, 0.95).asin();
        inward_m += along_m * (1.0 - turned.cos());
        before = [strip.y_m, height_m[s]];
        let (up, inward) = (lift_n[s] * turned.cos(), lift_n[s] * turned.sin());
        lost[0] += up - lift_n[s];
        lost[1] += up * (strip.y_m - inward_m) + inward * height_m[s] - lift_n[s] * strip.y_m;
    }
    lost
}
