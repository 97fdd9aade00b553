//! A run or a static group beside its simulation, and the few numbers by which it is compared with its peers.

use crate::data::Dataset;
use crate::locate::maneuver::Maneuver;
use crate::rules::RecordRules;
use crate::statistics::{dot, mean, median};
use coupling::{ByLoad, Load};
use maneuver::effects::{Flown, Stimulus};

/// One channel.
#[derive(Debug, Clone)]
pub(crate) struct Pair {
    pub(crate) measured: Vec<f64>,
    pub(crate) simulated: Vec<f64>,
    /// Its mean square must be so many times the noise's before it has a gain.
    visible: f64,
}

/// See the module.
#[derive(Debug, Clone)]
pub(crate) struct Record {
    pub(crate) name: String,
    pub(crate) steady: bool,
    pub(crate) v_m_s: f64,
    pub(crate) maneuver: Maneuver,
    pub(crate) alpha_rad: f64,
    pub(crate) repeat_of: Option<usize>,
    pub(crate) time_step_s: f64,
    pub(crate) sigma: ByLoad<f64>,
    /// Samples at a jump of a control; of a chirp none.
    pub(crate) edges: Vec<bool>,
    pub(crate) channels: ByLoad<Option<Pair>>,
}

/// Records in the order static groups, runs.
pub(crate) fn records(data: &Dataset, simulated: &[Flown], sigma: &[ByLoad<f64>]) -> Vec<Record> {
    let rules = &data.rules.record;
    let statics = data.statics.iter().map(|group| {
        let v_m_s = data.airspeeds_m_s[group.airspeed];
        let present: Vec<Load> = Load::ALL
            .into_iter()
            .filter(|&c| group.measured.iter().any(|loads| loads[c as usize].is_some()))
            .collect();
        let kept: Vec<usize> = (0..group.measured.len())
            .filter(|&i| present.iter().all(|&c| group.measured[i][c as usize].is_some()))
            .collect();
        let name = if v_m_s > 0.0 {
            format!("static points at {v_m_s} m/s")
        } else {
            "static points without wind".to_owned()
        };
        (name, &group.stimulus, v_m_s, None, kept, present)
    });
    let runs = data.runs.iter().map(|run| {
        let kept: Vec<usize> = (0..run.measured[0].len()).collect();
        let repeat = run.repeat_of.map(|first| first + data.statics.len());
        let present: Vec<Load> = Load::ALL.into_iter().filter(|&c| data.run_loads[c as usize]).collect();
        (run.name.clone(), &run.stimulus, data.airspeeds_m_s[run.airspeed], repeat, kept, present)
    });
    let of = |place: usize, c: Load, i: usize| match place.checked_sub(data.statics.len()) {
        None => data.statics[place].measured[i][c as usize].unwrap_or(f64::NAN),
        Some(run) => data.runs[run].measured[c as usize][i],
    };
    statics
        .chain(runs)
        .enumerate()
        .map(|(place, (name, stimulus, v_m_s, repeat_of, kept, present))| {
            let maneuver = Maneuver::of(&data.rules.locate, stimulus, v_m_s);
            Record {
                name,
                steady: stimulus.steady,
                v_m_s,
                alpha_rad: mean(&stimulus.inputs.alpha.value),
                repeat_of,
                time_step_s: stimulus.time_step_s,
                sigma: sigma[place],
                edges: edges(rules, stimulus, &maneuver),
                maneuver,
                channels: ByLoad::from_fn(|c| {
                    present.contains(&c).then(|| Pair {
                        measured: kept.iter().map(|&i| of(place, c, i)).collect(),
                        simulated: kept.iter().map(|&i| simulated[place].loads[c as usize][i]).collect(),
                        visible: rules.visible_rms * rules.visible_rms,
                    })
                }),
            }
        })
        .collect()
}

/// Samples around jumps of a control.
fn edges(rules: &RecordRules, stimulus: &Stimulus, maneuver: &Maneuver) -> Vec<bool> {
    let samples = stimulus.inputs.alpha.value.len();
    let mut edges = vec![false; samples];
    if stimulus.steady || maneuver.swept_control().is_some() {
        return edges;
    }
    for delta in &stimulus.inputs.controls_rad {
        let height = delta.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        for i in 2..samples {
            if height > 0.0 && (delta[i] - delta[i - 2]).abs() > rules.jump * height {
                edges[i.saturating_sub(rules.rough_around)..(i + rules.rough_around).min(samples)].fill(true);
            }
        }
    }
    edges
}

impl Record {
    /// A channel with the mean taken off.
    pub(crate) fn about_mean(&self, c: Load) -> Option<Pair> {
        let off = |values: &[f64]| {
            let mean = mean(values);
            values.iter().map(|value| value - mean).collect()
        };
        self.channels[c].as_ref().map(|pair| Pair {
            measured: off(&pair.measured),
            simulated: off(&pair.simulated),
            ..*pair
        })
    }

    /// What tells most of its sign and size: all of it with wind, what moves without.
    pub(crate) fn signal(&self, c: Load) -> Option<Pair> {
        if self.v_m_s > 0.0 { self.channels[c].clone() } else { self.about_mean(c) }
    }
}

impl Pair {
    /// Factor on the simulation that brings it nearest to the measurement; none if the simulation hardly moves.
    pub(crate) fn gain(&self, sigma: f64) -> Option<f64> {
        let power = dot(&self.simulated, &self.simulated);
        (power > self.visible * sigma * sigma * self.simulated.len() as f64)
            .then(|| dot(&self.measured, &self.simulated) / power)
    }
}

/// One standard deviation of a sample of Fz, Mx, My for [`super::defects`], static groups first, then runs: as stated, or
/// from what runs hold above 10 Hz, where little else is.
pub fn rough_noise(data: &Dataset) -> Vec<ByLoad<f64>> {
    let highest_hz = data.rules.data.highest_hz;
    let quiet_hz = data.rules.noise.quiet_from * highest_hz;
    let quiet = |c: Load| {
        let of = |run: &crate::data::RunData| {
            let (values, dt) = (&run.measured[c as usize], run.stimulus.time_step_s);
            let all = crate::transform::cosines(values, dt, highest_hz);
            let high = all
                .iter()
                .enumerate()
                .filter(|(k, _)| crate::transform::frequency_hz(*k, values.len(), dt) > quiet_hz);
            // the middle of |x| of normal numbers
            median(high.map(|(_, value)| value.abs()).collect()).map(|middle| middle / 0.6745)
        };
        median(data.runs.iter().filter_map(of).collect()).unwrap_or(0.0)
    };
    let rough: ByLoad<f64> = ByLoad::from_fn(|c| match data.stated {
        Some(stated) if stated.sample[c] > 0.0 => stated.sample[c],
        _ => quiet(c),
    });
    let statics = data.statics.iter().map(|_| data.stated.map_or(rough, |stated| stated.point));
    let runs = data.runs.iter().map(|run| {
        ByLoad::from_fn(|c| {
            let stated = data.stated.is_some_and(|stated| stated.sample[c] > 0.0);
            let behind_filter = if stated { (run.decimation as f64).sqrt() } else { 1.0 };
            (rough[c] / behind_filter).max(f64::MIN_POSITIVE)
        })
    });
    statics.chain(runs).collect()
}
