//! Held-out runs one by one: a run that does on another day what a training run did tells what stays the same; how the model
//! does in what it has not seen, only the others tell.

use crate::analysis::Prepared;
use crate::current_model::CurrentModel;
use crate::data::Dataset;
use crate::load_model::LoadModel;
use crate::result::{BeforeAfter, HeldOutRun};
use crate::simulator::Simulator;
use calibrate::Use;

impl Dataset {
    /// The training run that a held-out run repeats: so its entry says, or it moved in the same way at the same airspeed.
    pub fn repeated_training_run(&self, run: usize) -> Option<usize> {
        let own = &self.runs[run];
        let is_same = |other: usize| {
            let there = &self.runs[other];
            there.usage == Use::Train
                && there.airspeed == own.airspeed
                && (own.repeat_of == Some(other)
                    || there.repeat_of == Some(run)
                    || self.is_moved_like(&own.stimulus, &there.stimulus))
        };
        (0..self.runs.len()).find(|&other| is_same(other))
    }
}

/// See the module: before, as `model` flies without effects; after, as `after` does with them.
pub(crate) fn held_out_runs(
    prepared: &Prepared,
    model: &CurrentModel<'_>,
    after: &Simulator,
) -> Vec<HeldOutRun> {
    let [_, judged] = prepared.judged();
    let places = judged.places();
    let before = prepared.simulator.flown(&[], Some(&model.models), &places);
    let after = after.flown(&model.effects, None, &places);
    let statics = prepared.data.statics.len();
    (0..judged.segments.len())
        .filter(|segment| places[*segment] >= statics)
        .map(|segment| {
            let run = places[segment] - statics;
            let gap = |flown: &[_]| judged.gap_of(flown, |other| other == segment).all;
            let repeats = prepared.data.repeated_training_run(run);
            HeldOutRun {
                run: prepared.data.runs[run].name.clone(),
                repeats: repeats.map(|first| prepared.data.runs[first].name.clone()),
                gap: BeforeAfter { before: gap(&before), after: gap(&after) },
                rows: judged.segments[segment].rows.len(),
            }
        })
        .collect()
}

/// How many held-out runs repeat a training maneuver, and the gaps of these and of the others; none where none does.
pub fn sentence(runs: &[HeldOutRun]) -> Option<String> {
    let (repeating, new): (Vec<_>, Vec<_>) = runs.iter().partition(|run| run.repeats.is_some());
    if repeating.is_empty() {
        return None;
    }
    let gap = |of: &[&HeldOutRun]| {
        let rows: usize = of.iter().map(|run| run.rows).sum();
        let root = |value: fn(&BeforeAfter<f64>) -> f64| {
            let squares: f64 = of.iter().map(|run| run.rows as f64 * value(&run.gap).powi(2)).sum();
            (squares / rows.max(1) as f64).sqrt()
        };
        format!("{:.1} -> {:.1}", root(|gap| gap.before), root(|gap| gap.after))
    };
    let (count, all, same) = (repeating.len(), runs.len(), gap(&repeating));
    let does = if count == 1 { "repeats" } else { "repeat" };
    let others = match new.len() {
        0 => "none moves in a way or at an airspeed of its own, so they do not judge what is new".to_owned(),
        others => {
            format!("gap of the {others} that move in a way or at an airspeed of their own {}", gap(&new))
        }
    };
    Some(format!("{count} of {all} held-out runs {does} a training maneuver (their gap {same}); {others}"))
}
