//! The benchmark's campaign: what is flown, which of it may be learnt from, and when.
//!
//! 37 runs at 100 Hz: one-minus-cosine pitch at .5, 2 and 4 Hz, aileron doublets of 5, 15 and 25 degrees, one chirp an
//! airspeed. Training airspeeds are 18, 30 and 34 m/s; all of 22 and 40 m/s, all doublets of 15 degrees and the 2 Hz
//! pitch at 30 m/s are held out.

/// Air density, kg/m³.
pub const RHO_KG_M3: f64 = 1.225;
/// Samples of a written run per second.
pub const SAMPLE_RATE_HZ: usize = 100;
/// Steps of the simulation for one sample.
pub const STEPS_PER_SAMPLE: usize = 4;
/// Airspeeds of the static points.
pub const STATIC_AIRSPEEDS_M_S: [f64; 5] = [18.0, 22.0, 30.0, 34.0, 40.0];
/// Airspeeds whose static points and runs are held out.
pub const HELD_OUT_AIRSPEEDS_M_S: [f64; 2] = [22.0, 40.0];
/// Angles of the static points, degrees.
pub const STATIC_ANGLES_DEG: [f64; 7] = [-4.0, -2.0, 0.0, 2.0, 4.0, 6.0, 8.0];
/// Wind-off weight tares, degrees.
pub const TILT_DEG: [f64; 4] = [-4.0, 0.0, 4.0, 8.0];
/// Angle at which ailerons move and pitch begins, degrees.
const BASE_DEG: f64 = 1.3;
/// Everything is at rest before, s.
pub const START_S: f64 = 0.5;
/// From the beginning of one run to that of the next, s.
pub const CYCLE_S: f64 = 180.0;

/// What moves in a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Move {
    /// The angle of attack goes up by `height_deg` and back once.
    Pitch {
        /// Height, degrees.
        height_deg: f64,
        /// One over the duration, Hz.
        frequency_hz: f64,
    },
    /// A control goes trailing edge down, then up.
    Doublet {
        /// Which control.
        control: usize,
        /// Commanded deflection, degrees.
        deflection_deg: f64,
    },
    /// A control swings with a frequency that rises from 0 to 10 Hz.
    Chirp {
        /// Which control.
        control: usize,
        /// Commanded amplitude, degrees.
        deflection_deg: f64,
    },
}

/// Frequency of all doublets, Hz.
pub const DOUBLET_HZ: f64 = 1.0;
/// A chirp's last frequency, Hz.
pub const CHIRP_TO_HZ: f64 = 10.0;
/// A chirp's duration, s.
pub const CHIRP_S: f64 = 15.0;

/// One run of the design; every run is flown twice.
#[derive(Debug, Clone, PartialEq)]
pub struct Planned {
    /// File name without ending.
    pub name: String,
    /// Airspeed, m/s.
    pub v_m_s: f64,
    /// Angle of attack at the beginning, degrees.
    pub alpha_deg: f64,
    /// Length, s.
    pub length_s: f64,
    /// What moves.
    pub motion: Move,
    /// Whether it may be learnt from.
    pub train: bool,
}

impl Planned {
    /// Number of written samples.
    pub fn samples(&self) -> usize {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "lengths are a few seconds"
        )]
        let steps = (self.length_s * SAMPLE_RATE_HZ as f64).round() as usize;
        steps + 1
    }

    /// The control that moves.
    pub fn control(&self) -> Option<usize> {
        match self.motion {
            Move::Pitch { .. } => None,
            Move::Doublet { control, .. } | Move::Chirp { control, .. } => Some(control),
        }
    }
}

/// Whether a run may be learnt from.
fn may_train(v_m_s: f64, motion: Move) -> bool {
    let held = match motion {
        Move::Pitch { frequency_hz, .. } => v_m_s == 30.0 && frequency_hz == 2.0,
        Move::Doublet { deflection_deg, .. } => deflection_deg == 15.0,
        Move::Chirp { .. } => false,
    };
    !held && !HELD_OUT_AIRSPEEDS_M_S.contains(&v_m_s)
}

/// All runs, in the order of the file's list; `controls` are the names of the wing's control surfaces.
pub fn runs(controls: &[String]) -> Vec<Planned> {
    let mut all = Vec::new();
    let mut add = |name: String, v_m_s: f64, length_s: f64, motion: Move| {
        let train = may_train(v_m_s, motion);
        all.push(Planned { name, v_m_s, alpha_deg: BASE_DEG, length_s, motion, train });
    };
    for v_m_s in [18.0, 22.0, 30.0, 34.0] {
        for (frequency_hz, said) in [(0.5, "0p5"), (2.0, "2"), (4.0, "4")] {
            let motion = Move::Pitch { height_deg: 5.0, frequency_hz };
            add(format!("aoa_{said}hz_{v_m_s}"), v_m_s, START_S + 1.0 / frequency_hz + 1.0, motion);
        }
    }
    add("aoa_2hz_40".into(), 40.0, START_S + 1.5, Move::Pitch { height_deg: 5.0, frequency_hz: 2.0 });
    for (control, name) in controls.iter().enumerate() {
        for (v_m_s, deflection_deg) in
            [(18.0, 25.0), (22.0, 25.0), (30.0, 5.0), (30.0, 15.0), (30.0, 25.0), (34.0, 5.0)]
        {
            let motion = Move::Doublet { control, deflection_deg };
            add(format!("doublet_{name}_{deflection_deg}_{v_m_s}"), v_m_s, START_S + 2.0, motion);
        }
    }
    if !controls.is_empty() {
        add(
            "doublet_last_15_40".into(),
            40.0,
            START_S + 2.0,
            Move::Doublet { control: controls.len() - 1, deflection_deg: 15.0 },
        );
        for (place, v_m_s) in [18.0, 22.0, 30.0, 34.0, 40.0].into_iter().enumerate() {
            let control = place % controls.len();
            let motion = Move::Chirp { control, deflection_deg: 4.0 };
            add(format!("chirp_{}_{v_m_s}", controls[control]), v_m_s, START_S + CHIRP_S + 1.0, motion);
        }
    }
    all
}

/// Pitch without wind at 2, 4 and 6 Hz, which separates what has mass from what the air does; 4 Hz is held out.
pub fn wind_off_runs() -> Vec<Planned> {
    let run = |frequency_hz: f64| Planned {
        name: format!("wind_off_{frequency_hz}hz"),
        v_m_s: 0.0,
        alpha_deg: BASE_DEG,
        length_s: START_S + 1.0 / frequency_hz + 1.0,
        motion: Move::Pitch { height_deg: 5.0, frequency_hz },
        train: frequency_hz != 4.0,
    };
    [2.0, 4.0, 6.0].map(run).to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_campaign_has_37_runs_and_one_chirp_an_airspeed() {
        let runs = runs(&["inner", "middle", "outer"].map(String::from));
        assert_eq!(runs.len(), 37);
        for v_m_s in STATIC_AIRSPEEDS_M_S {
            let chirp = |run: &&Planned| run.v_m_s == v_m_s && matches!(run.motion, Move::Chirp { .. });
            assert_eq!(runs.iter().filter(chirp).count(), 1);
        }
        let held = |run: &&Planned| HELD_OUT_AIRSPEEDS_M_S.contains(&run.v_m_s);
        assert!(runs.iter().filter(held).all(|run| !run.train));
        assert!(runs.iter().any(|run| run.train && run.control().is_none()));
    }
}
