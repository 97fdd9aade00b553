//! Repeated runs taken together.

use crate::run_data::RunData;
use calibrate::Use;
use maneuver::Smooth;
use maneuver::effects::{Inputs, Stimulus};

/// A run and those that repeat it, as one: what the model misses is the same in all of them, only their noise differs.
#[derive(Debug, Clone)]
pub struct Condition {
    /// Places in [`crate::data::Dataset::runs`].
    pub runs: Vec<usize>,
    /// Training or held out.
    pub usage: Use,
    /// Place of the airspeed.
    pub airspeed: usize,
    /// Mean of what moved.
    pub stimulus: Stimulus,
    /// Mean of the measured Fz, Mx, My.
    pub measured: [Vec<f64>; 3],
}

/// Runs with the runs that repeat them, where they are of one length and use.
pub(crate) fn conditions(runs: &[RunData]) -> Vec<Condition> {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for (i, run) in runs.iter().enumerate() {
        let same = |first: usize| {
            let first = &runs[first];
            (first.usage, first.airspeed, first.measured[0].len())
                == (run.usage, run.airspeed, run.measured[0].len())
        };
        let of = run.repeat_of.and_then(|of| groups.iter_mut().find(|g| g.contains(&of) && same(g[0])));
        match of {
            Some(group) => group.push(i),
            None => groups.push(vec![i]),
        }
    }
    groups.into_iter().map(|group| condition(runs, group)).collect()
}

fn condition(runs: &[RunData], group: Vec<usize>) -> Condition {
    let first = &runs[group[0]];
    let share = 1.0 / group.len() as f64;
    let mean = |of: &dyn Fn(&RunData) -> &[f64]| {
        let mut sum = vec![0.0; of(first).len()];
        for &i in &group {
            sum.iter_mut().zip(of(&runs[i])).for_each(|(s, value)| *s += share * value);
        }
        sum
    };
    let inputs = &first.stimulus.inputs;
    let controls = 0..inputs.controls_rad.len();
    Condition {
        usage: first.usage,
        airspeed: first.airspeed,
        stimulus: Stimulus {
            inputs: Inputs {
                alpha: Smooth {
                    value: mean(&|run| &run.stimulus.inputs.alpha.value),
                    rate: mean(&|run| &run.stimulus.inputs.alpha.rate),
                    second: mean(&|run| &run.stimulus.inputs.alpha.second),
                },
                incidence_rad: inputs.incidence_rad.clone(),
                controls_rad: controls.map(|k| mean(&|run| &run.stimulus.inputs.controls_rad[k])).collect(),
            },
            clock_h: share * group.iter().map(|i| runs[*i].stimulus.clock_h).sum::<f64>(),
            ..first.stimulus
        },
        measured: std::array::from_fn(|c| mean(&|run| &run.measured[c])),
        runs: group,
    }
}
