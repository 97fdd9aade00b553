//! An effect at some size beside those of the current model: what it changes, and what misfit that leaves.

use crate::current_model::{CurrentModel, Setting, norm};
use crate::problem::Problem;
use maneuver::effects::{Active, Effect, Flown, Parameter};
use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Effect, form, sizes.
type Key = (&'static str, &'static str, Vec<u64>);

/// Changes that were flown around one current model: they depend on its effects and on what was commanded, not on what was measured.
#[derive(Debug, Default)]
pub(crate) struct Memory(Mutex<HashMap<Key, Arc<Vec<f64>>>>);

impl Memory {
    fn locked(&self) -> MutexGuard<'_, HashMap<Key, Arc<Vec<f64>>>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Something to try around the current model.
pub(crate) struct Trial<'a> {
    pub(crate) setting: &'a Setting<'a>,
    pub(crate) problem: &'a Problem<'a>,
    pub(crate) current: &'a CurrentModel,
    pub(crate) effect: &'a Arc<dyn Effect>,
    /// Where changes are kept that other measurements of the same points and runs will ask for again.
    pub(crate) memory: Option<&'a Memory>,
}

/// Sizes in units of the plausible, and what they give.
#[derive(Debug, Clone)]
pub(crate) struct Point {
    pub(crate) sizes: Vec<f64>,
    pub(crate) residual: Vec<f64>,
    pub(crate) chi2: f64,
    pub(crate) score: f64,
}

impl Trial<'_> {
    pub(crate) fn active(&self, sizes: &[f64]) -> Active {
        let parameters = self.effect.parameters();
        let values: Vec<f64> = sizes.iter().zip(&parameters).map(|(size, p)| size * p.plausible).collect();
        Active::new(Arc::clone(self.effect), &values)
    }

    /// What one more plausible size of a parameter changes, from sizes whose change is known.
    pub(crate) fn secant(
        &self,
        parameters: &[Parameter],
        k: usize,
        (base, at_base): (&[f64], &[f64]),
    ) -> Vec<f64> {
        let sign = if parameters[k].upper > 0.0 { 1.0 } else { -1.0 };
        let around = |from: &[f64], at: &[f64], step: f64| {
            let mut sizes = from.to_vec();
            sizes[k] += step;
            let mut column = difference(&self.change(&sizes), at);
            for value in &mut column {
                *value /= step;
            }
            column
        };
        if base.iter().any(|size| *size != 0.0) {
            return around(base, at_base, -0.2 * sign);
        }
        let column = around(base, at_base, sign);
        if column.iter().any(|value| *value != 0.0) {
            return column;
        }
        // a parameter that does nothing alone (the power of an airspeed, a limit) is tried beside the others
        let others: Vec<f64> = parameters.iter().map(|p| 0.5 * f64::from(u8::from(p.upper > 0.0))).collect();
        around(&others, &self.change(&others), sign)
    }

    /// What the effect changes in the residual at sizes.
    fn change(&self, sizes: &[f64]) -> Arc<Vec<f64>> {
        let Some(memory) = self.memory else { return Arc::new(self.flown_change(sizes)) };
        let bits = sizes.iter().map(|size| size.to_bits()).collect();
        let key = (self.effect.spec().name, self.effect.form(), bits);
        if let Some(known) = memory.locked().get(&key) {
            return Arc::clone(known);
        }
        let change = Arc::new(self.flown_change(sizes));
        memory.locked().insert(key, Arc::clone(&change));
        change
    }

    fn flown_change(&self, sizes: &[f64]) -> Vec<f64> {
        let mut effects = self.current.effects.clone();
        effects.push(self.active(sizes));
        let simulator = self.setting.simulator;
        let flown = simulator.fly(
            &simulator.models(&effects, Some(&self.current.models)),
            &effects,
            &self.problem.places(),
        );
        let all: Vec<usize> = (0..self.problem.segments.len()).collect();
        let before: Vec<&Flown> = self.current.flown.iter().collect();
        self.problem.change(&all, &flown, &before)
    }

    pub(crate) fn point(&self, sizes: &[f64]) -> Point {
        // as the bounds and physics allow
        let parameters = self.effect.parameters();
        let allowed = self.active(sizes).values;
        let sizes: Vec<f64> = allowed.iter().zip(&parameters).map(|(value, p)| value / p.plausible).collect();
        let change = self.change(&sizes);
        let residual = difference(&self.current.residual, &change);
        let chi2 = norm(&self.current.shared, &residual);
        let score = chi2 + sizes.iter().map(|s| s * s).sum::<f64>();
        Point { sizes, residual, chi2, score }
    }

    pub(crate) fn point_at_rest(&self) -> Point {
        let none = vec![0.0; self.effect.parameters().len()];
        Point {
            sizes: none,
            residual: self.current.residual.clone(),
            chi2: self.current.chi2,
            score: self.current.chi2,
        }
    }
}

/// `a - b`.
pub(crate) fn difference(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}
