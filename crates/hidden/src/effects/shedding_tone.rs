//! Vortex shedding: a spectral line with a frequency that follows the airspeed and a phase of its own in every record.

use super::{Kind, Parameter, Sign};
use crate::random::{Random, Stream};
use std::f64::consts::TAU;

pub(super) const KIND: Kind = Kind {
    name: "shedding_tone",
    in_library: false,
    parameters: &[
        Parameter::size("A_N", 0.15, 2.0, Sign::Plus),
        Parameter::shape("hz_per_m_s", 0.25, 0.7, Sign::Plus),
    ],
    balance: |p, at, flown| {
        let (amplitude_n, hz_per_m_s) = (p[0], p[1]);
        if at.time_step_s * flown.tip_z_m.len() as f64 <= 2.0 * at.time_step_s {
            // a static point is an average
            return;
        }
        let phase = TAU * Random::new(at.record, Stream::Plan).unit();
        for i in 0..flown.tip_z_m.len() {
            let turns = hz_per_m_s * at.v_m_s * i as f64 * at.time_step_s;
            let tone = amplitude_n * at.q_pa / Q_REF_PA * (TAU * turns + phase).sin();
            for (load, arm) in flown.loads.iter_mut().zip([1.0, 0.8, -0.25]) {
                load[i] += arm * tone;
            }
        }
    },
    ..Kind::NONE
};

/// Dynamic pressure that the amplitude refers to: 30 m/s at sea level.
const Q_REF_PA: f64 = 551.25;
