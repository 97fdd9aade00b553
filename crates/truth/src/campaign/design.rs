//! The benchmark's runs as maneuvers: 37 runs of pitch, doublets and chirps, and pitch without wind.

use crate::drive::{Maneuver, Motion};

/// Airspeeds of static points, m/s.
pub(crate) const AIRSPEEDS_M_S: [f64; 5] = [18.0, 22.0, 30.0, 34.0, 40.0];
/// Angles of static points, degrees.
pub(crate) const ANGLES_DEG: [f64; 7] = [-4.0, -2.0, 0.0, 2.0, 4.0, 6.0, 8.0];
/// Angles of the weight tares, degrees.
pub(crate) const TILT_DEG: [f64; 4] = [-4.0, 0.0, 4.0, 8.0];
/// Airspeeds whose runs are held out.
const HELD_OUT_M_S: [f64; 2] = [22.0, 40.0];
/// Density, kg/m³.
pub(crate) const RHO_KG_M3: f64 = 1.225;
/// Angle at which pitch begins and surfaces move, degrees.
const BASE_DEG: f64 = 1.3;
/// Beginning of every motion, s.
const START_S: f64 = 0.5;
/// From the beginning of a run to that of the next, s.
pub(crate) const CYCLE_S: f64 = 180.0;

/// A run that is planned; it is flown once in each block.
#[derive(Debug, Clone, PartialEq)]
pub struct Planned {
    /// File name without ending.
    pub name: String,
    /// What is flown.
    pub maneuver: Maneuver,
    /// Whether it may be learnt from.
    pub train: bool,
}

fn run(name: String, v_m_s: f64, length_s: f64, motion: Motion, train: bool) -> Planned {
    let maneuver = Maneuver {
        v_m_s,
        rho_kg_m3: RHO_KG_M3,
        alpha_deg: BASE_DEG,
        sample_rate_hz: 100.0,
        length_s,
        motions: vec![motion],
    };
    Planned { name, maneuver, train }
}

fn pitch(name: String, v_m_s: f64, frequency_hz: f64, train: bool) -> Planned {
    let motion =
        Motion::OneMinusCosine { of: "alpha".into(), height_deg: 5.0, frequency_hz, start_s: START_S };
    run(name, v_m_s, START_S + 1.0 / frequency_hz + 1.0, motion, train)
}

fn doublet(name: String, v_m_s: f64, of: &str, height_deg: f64) -> Planned {
    let motion = Motion::Doublet { of: of.into(), height_deg, frequency_hz: 1.0, start_s: START_S };
    let train = height_deg != 15.0 && !HELD_OUT_M_S.contains(&v_m_s);
    run(name, v_m_s, START_S + 2.0, motion, train)
}

/// The benchmark's runs for a wing with these controls: those with 22 and 40 m/s, doublets of 15 degrees and the 2 Hz pitch at
/// 30 m/s are held out.
pub fn benchmark(controls: &[String]) -> Vec<Planned> {
    let mut all = Vec::new();
    for v_m_s in [18.0, 22.0, 30.0, 34.0] {
        for (hz, said) in [(0.5, "0p5"), (2.0, "2"), (4.0, "4")] {
            let held = HELD_OUT_M_S.contains(&v_m_s) || (v_m_s == 30.0 && hz == 2.0);
            all.push(pitch(format!("aoa_{said}hz_{v_m_s}"), v_m_s, hz, !held));
        }
    }
    all.push(pitch("aoa_2hz_40".into(), 40.0, 2.0, false));
    for name in controls {
        for (v, deg) in [(18.0, 25.0), (22.0, 25.0), (30.0, 5.0), (30.0, 15.0), (30.0, 25.0), (34.0, 5.0)] {
            all.push(doublet(format!("doublet_{name}_{deg}_{v}"), v, name, deg));
        }
    }
    let Some(last) = controls.last() else { return all };
    all.push(doublet("doublet_last_15_40".into(), 40.0, last, 15.0));
    for (place, v_m_s) in AIRSPEEDS_M_S.into_iter().enumerate() {
        let of = &controls[place % controls.len()];
        let motion = Motion::Chirp {
            of: of.clone(),
            height_deg: 4.0,
            from_hz: 0.0,
            to_hz: 10.0,
            duration_s: 15.0,
            start_s: START_S,
        };
        let train = !HELD_OUT_M_S.contains(&v_m_s);
        all.push(run(format!("chirp_{of}_{v_m_s}"), v_m_s, START_S + 16.0, motion, train));
    }
    all
}

/// Pitch without wind at 2, 4 and 6 Hz; 4 Hz is held out.
pub fn wind_off() -> Vec<Planned> {
    [2.0, 4.0, 6.0].map(|hz| pitch(format!("wind_off_{hz}hz"), 0.0, hz, hz != 4.0)).to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_are_37_runs_and_every_airspeed_has_a_chirp() {
        let runs = benchmark(&["inner", "middle", "outer"].map(String::from));
        assert_eq!(runs.len(), 37);
        for v_m_s in AIRSPEEDS_M_S {
            let chirps =
                runs.iter().filter(|run| run.name.starts_with("chirp") && run.maneuver.v_m_s == v_m_s);
            assert_eq!(chirps.count(), 1);
        }
        let held = |run: &&Planned| HELD_OUT_M_S.contains(&run.maneuver.v_m_s);
        assert!(runs.iter().filter(held).all(|run| !run.train));
    }
}
