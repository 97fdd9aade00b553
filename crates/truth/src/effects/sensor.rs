//! What balance and data acquisition make of loads and angles.

use super::{Effect, Record};
use crate::signals::{early, lagged};
use std::f64::consts::{SQRT_2, TAU};

/// Ranges of the channels, N and N m.
const RANGE: [f64; 3] = [300.0, 200.0, 100.0];
/// Of the channels, for a drift in N/h: N, and N m.
const DRIFT: [f64; 3] = [1.0, 0.6, 0.25];
/// Time in which a balance warms up, h.
const WARM_H: f64 = 4.0;

impl Effect {
    pub(crate) fn on_record(&self, record: &Record<'_>, loads: &mut [Vec<f64>; 3]) {
        let p = self.value(0);
        let chosen = self.choice(1);
        match self.name.as_str() {
            "crosstalk" => {
                let [fz, mx, my] = loads;
                for i in 0..fz.len() {
                    let (lift, roll, pitch) = (fz[i], mx[i], my[i]);
                    my[i] += p * (lift + 0.05 * roll);
                    fz[i] += 0.1 * p * pitch;
                }
            }
            "gain" => {
                for load in &mut loads[chosen] {
                    *load *= 1.0 + p * (1.0 - 0.1 * (*load / RANGE[chosen]).powi(2));
                }
            }
            "balance_nonlin" => {
                for load in &mut loads[chosen] {
                    let share = *load / RANGE[chosen];
                    *load *= 1.0 + p * share * (-0.2 * share.abs()).exp();
                }
            }
            "drift" => {
                for (i, load) in loads[chosen].iter_mut().enumerate() {
                    let hours = (record.start_s + i as f64 * record.time_step_s) / 3600.0;
                    *load += DRIFT[chosen] * p * WARM_H * (hours / WARM_H).tanh();
                }
            }
            "delay" if p != 0.0 => {
                for (load, share) in loads.iter_mut().zip([1.03, 1.0, 0.97]) {
                    *load = early(load, -share * p / record.time_step_s);
                }
            }
            // four equal lags with the delay of the two poles that are stated
            "daq_filter" if p > 0.0 => {
                let lag_s = 0.25 * SQRT_2 * p / TAU;
                for load in loads {
                    for _ in 0..4 {
                        *load = lagged(load, lag_s, record.time_step_s);
                    }
                }
            }
            "balance_creep" if p != 0.0 => {
                for load in loads {
                    let late = lagged(load, self.value(1), record.time_step_s);
                    load.iter_mut().zip(late).for_each(|(now, late)| *now -= p * (*now - late));
                }
            }
            _ => {}
        }
    }

    /// What an angle sensor says, rad.
    pub(crate) fn on_reading(&self, alpha_rad: f64) -> f64 {
        if self.name == "alpha_encoder" && self.value(0) != 0.0 {
            (alpha_rad.tan() / (1.0 + self.value(0))).atan()
        } else {
            alpha_rad
        }
    }
}
