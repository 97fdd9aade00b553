//! The time of unsteady runs: setting up the air, the linear system at an airspeed, and a chirp of 30 s.

use aero::{Corrections, Flow};
use coupling::{ElasticWing, WingFile};
use maneuver::motion::{Chirp, sampled};
use maneuver::{Motion, Rig, RigSettings, Smooth};
use serde_json::Value;

use super::bench_clock::{median, row};
use wingroot::failure::Failure;

/// Samples per second and length of the chirp, its airspeed and its amplitude.
const RATE_HZ: f64 = 1000.0;
const SAMPLES: usize = 30_001;
const V_M_S: f64 = 30.0;
const AMPLITUDE_DEG: f64 = 5.0;

/// Rows of the wing: its rig, its system at one airspeed, one chirp of its first control.
pub(crate) fn rows(file: &WingFile, wing: &ElasticWing) -> Result<Vec<Value>, Failure> {
    let settings = || RigSettings::of_wing(file);
    let boxes = wing.correctable.len();
    let rig = Rig::new(wing, settings())?;
    let flow = Flow { v_m_s: V_M_S, rho_kg_m3: 1.225 };
    let neutral = Corrections::neutral(boxes);
    let model = rig.at(flow, &neutral)?;
    let height = AMPLITUDE_DEG.to_radians();
    let chirp = Chirp { height, from_hz: 0.0, to_hz: 10.0, duration_s: 30.0, start_s: 0.0 };
    let still = vec![0.0; SAMPLES];
    let motion = Motion {
        time_step_s: 1.0 / RATE_HZ,
        alpha: Smooth { value: still.clone(), rate: still.clone(), second: still },
        controls_rad: vec![sampled(&chirp, 1.0 / RATE_HZ, SAMPLES)],
    };
    Ok(vec![
        row(
            &format!("unsteady_air_{boxes}_boxes_13_frequencies_with_modes"),
            median(|| Rig::new(wing, settings()).map(drop).map_err(Failure::from))?,
        ),
        row(
            &format!("state_space_{}_states_at_an_airspeed", model.a.nrows()),
            median(|| rig.at(flow, &neutral).map(drop).map_err(Failure::from))?,
        ),
        row(
            "chirp_30_s_at_1_khz",
            median(|| {
                std::hint::black_box(model.fly(&motion));
                Ok(())
            })?,
        ),
    ])
}
