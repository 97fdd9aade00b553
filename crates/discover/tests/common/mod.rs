//! The shipped campaign beside the shipped wing, calibrated on it.

use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

use calibrate::{Campaign, CorrectionSet, Schedule, Settings, calibrate};
use coupling::ElasticWing;
use discover::data::Dataset;
use discover::load_model::LoadModel;
use discover::simulator::{Simulator, SplitRig};
use maneuver::AirModel;
use maneuver::effects::{Active, Flown};

/// A folder in `data/`.
pub(crate) fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name)
}

/// A campaign, its wing, and the wing flown through it.
pub(crate) struct Flight {
    /// As measured.
    pub(crate) data: Dataset,
    /// The wing.
    pub(crate) simulator: Simulator,
    /// As flown without effects.
    pub(crate) flown: Vec<Flown>,
    /// Names of the controls.
    pub(crate) controls: Vec<String>,
}

impl Flight {
    /// Everything flown with effects.
    pub(crate) fn with(&self, effects: &[Active]) -> Vec<Flown> {
        let all: Vec<usize> = (0..self.data.statics.len() + self.data.runs.len()).collect();
        self.simulator.flown(effects, None, &all)
    }

    /// Measurements replaced by what was flown, with noise of the stated size from a simple generator.
    pub(crate) fn pretend(&self, flown: &[Flown], seed: u64) -> Dataset {
        let mut data = self.data.clone();
        let stated = data.stated.expect("the shipped campaign states its noise");
        let [sample, point] = [stated.sample, stated.point].map(coupling::ByLoad::to_array);
        let mut state = seed;
        // sum of twelve uniform numbers (Knuth's generator), variance one
        let mut normal = || -> f64 {
            (0..12)
                .map(|_| {
                    state =
                        state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                    (state >> 33) as f64 / (1_u64 << 31) as f64
                })
                .sum::<f64>()
                - 6.0
        };
        let (statics, runs) = flown.split_at(data.statics.len());
        for (group, flown) in data.statics.iter_mut().zip(statics) {
            for (i, loads) in group.measured.iter_mut().enumerate() {
                *loads = std::array::from_fn(|c| Some(flown.loads[c][i] + point[c] * normal()));
            }
        }
        for (i, run) in data.runs.iter_mut().enumerate() {
            // a repeat moves as the run that it repeats: what the encoder's noise says of its angle moves no wing
            let first = run.repeat_of.filter(|first| runs[*first].loads[0].len() == run.measured[0].len());
            let flown = &runs[first.unwrap_or(i)];
            let behind_filter = (run.decimation as f64).sqrt();
            for (c, sample) in sample.into_iter().enumerate() {
                let noisy = flown.loads[c].iter().map(|value| value + sample / behind_filter * normal());
                run.measured[c] = noisy.collect();
            }
        }
        data
    }

    /// Place of a run among the runs.
    pub(crate) fn run(&self, name: &str) -> usize {
        self.data.runs.iter().position(|run| run.name == name).expect("a run of the campaign")
    }
}

/// The shipped campaign.
pub(crate) fn shipped() -> &'static Flight {
    static FLIGHT: OnceLock<Flight> = OnceLock::new();
    FLIGHT.get_or_init(|| {
        let (file, wing) = ElasticWing::read(&folder("tuflex/wing_beam.ron")).expect("the shipped wing");
        let campaign = Campaign::read(&folder("tuflex/measured")).expect("the shipped campaign");
        let found =
            calibrate(&wing, &campaign, &Settings::of_wing(&file.correction)).expect("it can be calibrated");
        let sets = found
            .airspeeds
            .iter()
            .map(|a| CorrectionSet { v_m_s: a.data.v_m_s, corrections: a.corrections.clone() })
            .collect();
        let schedule = Schedule {
            wing: file.name.clone(),
            wing_hash: file.hash.clone(),
            sets,
            found: None,
            unconverged: Vec::new(),
        };
        let data = Dataset::read(&campaign, &wing, &Arc::default()).expect("its runs");
        let simulator = {
            let rig = SplitRig::new(&file, &wing, AirModel::default(), &data.rules.variants).expect("a rig");
            Simulator::new(&rig, &schedule, &data).expect("a simulator")
        };
        let all: Vec<usize> = (0..data.statics.len() + data.runs.len()).collect();
        let flown = simulator.flown(&[], None, &all);
        let controls = wing.controls.iter().map(|control| control.name.clone()).collect();
        Flight { data, simulator, flown, controls }
    })
}
