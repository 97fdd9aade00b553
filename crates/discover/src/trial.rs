//! An effect at some size beside those of the current model: what it changes, and what misfit that leaves.

use crate::current_model::CurrentModel;
use crate::memory::Memory;
use crate::setting::Setting;
use faer::Mat;
use maneuver::effects::{Active, Effect, Flown, Parameter};
use std::sync::Arc;

/// Something to try around the current model.
pub(crate) struct Trial<'a> {
    pub(crate) setting: &'a Setting<'a>,
    pub(crate) current: &'a CurrentModel<'a>,
    pub(crate) effect: &'a Arc<dyn Effect>,
    /// Where changes are kept that other measurements of the same points and runs will ask for again.
    pub(crate) memory: Option<&'a Memory>,
}

/// Sizes in units of the plausible, and what they give.
#[derive(Debug, Clone)]
pub(crate) struct Point {
    pub(crate) sizes: Vec<f64>,
    /// [`crate::shared::Shared::extended`], as changes and secants are.
    pub(crate) residual: Vec<f64>,
    pub(crate) chi2: f64,
    pub(crate) score: f64,
}

/// Sizes and what they change in the residual.
pub(crate) struct Base {
    pub(crate) sizes: Vec<f64>,
    pub(crate) change: Vec<f64>,
}

impl Trial<'_> {
    pub(crate) fn active(&self, sizes: &[f64]) -> Active {
        let parameters = self.effect.parameters();
        let values: Vec<f64> = sizes.iter().zip(&parameters).map(|(size, p)| size * p.plausible).collect();
        Active::new(Arc::clone(self.effect), &values)
    }

    /// What one more plausible size of a parameter changes, from sizes whose change is known.
    pub(crate) fn secant(&self, parameters: &[Parameter], k: usize, base: &Base) -> Vec<f64> {
        let rules = &self.setting.rules().fit;
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
        if base.sizes.iter().any(|size| *size != 0.0) {
            return around(&base.sizes, &base.change, -rules.secant_step * sign);
        }
        let column = around(&base.sizes, &base.change, sign);
        if column.iter().any(|value| *value != 0.0) {
            return column;
        }
        // a parameter that does nothing alone (the power of an airspeed, a limit) is tried beside the others
        let beside = |p: &Parameter| rules.beside_size * f64::from(u8::from(p.upper > 0.0));
        let others: Vec<f64> = parameters.iter().map(beside).collect();
        around(&others, &self.change(&others), sign)
    }

    /// What one more plausible size of each parameter changes around a point.
    pub(crate) fn secants_around(&self, parameters: &[Parameter], point: &Point) -> Mat<f64> {
        let rules = &self.setting.rules().fit;
        let column = |k: usize| {
            let mut sizes = point.sizes.clone();
            // towards zero, where bounds are not
            let step = match sizes[k] {
                0.0 => rules.secant_step * if parameters[k].upper > 0.0 { 1.0 } else { -1.0 },
                size => -rules.last_secant_share * size,
            };
            sizes[k] += step;
            let beside = difference(&self.current.extended, &self.change(&sizes));
            point.residual.iter().zip(beside).map(|(at, beside)| (at - beside) / step).collect()
        };
        let columns: Vec<Vec<f64>> = (0..parameters.len()).map(column).collect();
        Mat::from_fn(point.residual.len(), columns.len(), |i, j| columns[j][i])
    }

    /// Sizes with the least misfit near some, by secants that are taken anew at every step, and those secants.
    pub(crate) fn least_squares(&self, near: &[f64]) -> (Point, Mat<f64>) {
        let rules = &self.setting.rules().fit;
        let parameters = self.effect.parameters();
        let mut point = self.point(near);
        let mut jacobian = self.secants_around(&parameters, &point);
        for _ in 0..rules.last_steps {
            let step = self.current.shared.step(&jacobian, &point.residual, &point.sizes).step;
            let shortened = |share: f64| {
                let sizes = point.sizes.iter().zip(&step).map(|(size, step)| size + share * step);
                self.point(&sizes.collect::<Vec<f64>>())
            };
            let next = [1.0, 0.5, 0.25].into_iter().map(shortened).find(|next| next.score < point.score);
            let Some(next) = next else { break };
            let gained = point.score - next.score;
            point = next;
            jacobian = self.secants_around(&parameters, &point);
            if gained < rules.least_gain {
                break;
            }
        }
        (point, jacobian)
    }

    /// What the effect changes in the residual at sizes.
    fn change(&self, sizes: &[f64]) -> Arc<Vec<f64>> {
        let Some(memory) = self.memory else { return Arc::new(self.flown_change(sizes)) };
        let bits = sizes.iter().map(|size| size.to_bits()).collect();
        memory.change((self.effect.spec().name, self.effect.form(), bits), || self.flown_change(sizes))
    }

    fn flown_change(&self, sizes: &[f64]) -> Vec<f64> {
        let CurrentModel { problem, effects, models, flown, .. } = self.current;
        let mut effects = effects.clone();
        effects.push(self.active(sizes));
        let after = self.setting.model.flown(&effects, Some(models), &problem.places());
        let before: Vec<&Flown> = flown.iter().collect();
        self.current.shared.extended(problem.change(&problem.all(), &after, &before))
    }

    pub(crate) fn point(&self, sizes: &[f64]) -> Point {
        // as the bounds and physics allow
        let parameters = self.effect.parameters();
        let allowed = self.active(sizes).values;
        let sizes: Vec<f64> = allowed.iter().zip(&parameters).map(|(value, p)| value / p.plausible).collect();
        if sizes.iter().all(|size| *size == 0.0) {
            return self.point_at_rest();
        }
        let change = self.change(&sizes);
        let residual = difference(&self.current.extended, &change);
        let chi2 = self.current.shared.norm_of_extended(&residual);
        let score = chi2 + sizes.iter().map(|s| s * s).sum::<f64>();
        Point { sizes, residual, chi2, score }
    }

    pub(crate) fn point_at_rest(&self) -> Point {
        let CurrentModel { extended, chi2, .. } = self.current;
        let sizes = vec![0.0; self.effect.parameters().len()];
        Point { sizes, residual: extended.clone(), chi2: *chi2, score: *chi2 }
    }
}

/// `a - b`.
pub(crate) fn difference(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

#[cfg(test)]
mod tests;
