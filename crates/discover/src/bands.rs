//! Bands about simulated runs: noise, calibrated parameters that stay uncertain (one after the other, one standard
//! deviation each) and model-form variants of the same wing. The corrections' own uncertainty is not in them.

use crate::analysis::Prepared;
use crate::load_model::LoadModel;
use crate::simulator::Simulator;
use maneuver::effects::{Active, Flown};
use rayon::prelude::*;

/// A run before and after the effects.
#[derive(Debug, Clone)]
pub struct Banded {
    /// Place in [`crate::data::Dataset::runs`].
    pub run: usize,
    /// Without the effects.
    pub before: Flown,
    /// With them.
    pub after: Flown,
    /// Half width of the band about the model after, N and N m, by load and sample.
    pub half: [Vec<f64>; 3],
}

impl Prepared {
    /// Runs with their bands; `after` flies the effects, with corrections of its own if it likes.
    pub fn bands(&self, after: &Simulator, effects: &[Active], runs: &[usize]) -> Vec<Banded> {
        let places: Vec<usize> = runs.iter().map(|run| self.data.place_of_run(*run)).collect();
        let plain = self.simulator.flown(&[], None, &places);
        let models = after.models(effects, None);
        let with = after.fly(&models, effects, &places);
        let known = self.uncertain.par_iter().map(|one| {
            let more: Vec<Active> = effects.iter().chain([one]).cloned().collect();
            (after.flown(&more, Some(&models), &places), &with)
        });
        let variants = self.variants.par_iter().map(|variant| (variant.flown(&[], None, &places), &plain));
        let changed: Vec<(Vec<Flown>, &Vec<Flown>)> = known.chain(variants).collect();
        let rules = &self.data.rules.verdict;
        let half = |k: usize, c: usize| {
            let mut squares = vec![0.0; with[k].loads[c].len()];
            for (new, old) in &changed {
                let pairs = new[k].loads[c].iter().zip(&old[k].loads[c]);
                squares.iter_mut().zip(pairs).for_each(|(sum, (new, old))| *sum += (new - old).powi(2));
            }
            let noise = self.noise.sigma(self.data.runs[runs[k]].airspeed, c, rules.band_noise_hz);
            squares.iter().map(|square| rules.band_sigmas * (square + noise * noise).sqrt()).collect()
        };
        let halves: Vec<[Vec<f64>; 3]> =
            (0..runs.len()).map(|k| std::array::from_fn(|c| half(k, c))).collect();
        let flown = plain.iter().zip(&with).zip(halves).zip(runs);
        flown
            .map(|(((before, after), half), run)| Banded {
                run: *run,
                before: before.clone(),
                after: after.clone(),
                half,
            })
            .collect()
    }
}
