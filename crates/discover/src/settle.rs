//! Sizes of effects that were found, by the gap itself.
//!
//! While effects are looked for, a run may be off by a gain and a shift of its own: what is left is the shape of an effect over
//! time, known to the noise. That is right for telling effects apart and trusts their form too much for their size: a lag of
//! four poles, fitted by one, is found a quarter too small, and the rest of its delay is left to the runs. In the end sizes
//! are weighed against those that leave the least gap on the training data, each by what is known of it: the search's standard
//! deviations, and the scatter of the least squares from run to run (covariance clustered by runs: Liang and Zeger 1986).

use crate::current_model::CurrentModel;
use crate::found::Found;
use crate::setting::Setting;
use crate::trial::Trial;
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use std::ops::Range;
use std::sync::Arc;

/// Sets each effect's values so; the model with them. Values stay as they were if the gap does not shrink.
pub(crate) fn settle<'a>(
    setting: &Setting<'_>,
    mut current: CurrentModel<'a>,
    found: &mut [Found],
) -> CurrentModel<'a> {
    let gap = |model: &CurrentModel<'_>| model.problem.gap(&model.flown).all;
    for (which, found) in found.iter_mut().enumerate() {
        let lacking = current.lacking(setting, which);
        let effect = Arc::clone(&found.active.effect);
        let trial = Trial { setting, current: &lacking, effect: &effect, memory: None };
        let mut effects = current.effects.clone();
        effects[which] = trial.active(&weighed(&trial, found));
        let settled = current.beside(setting, &effects);
        if gap(&settled) < gap(&current) {
            found.active = effects.swap_remove(which);
            current = settled;
        }
    }
    current
}

/// Sizes, in units of the plausible, between those found and those of least squares.
fn weighed(trial: &Trial<'_>, found: &Found) -> Vec<f64> {
    let parameters = trial.effect.parameters();
    let in_plausible = |values: &[f64]| -> Vec<f64> {
        values.iter().zip(&parameters).map(|(value, p)| value / p.plausible).collect()
    };
    let (before, sigma) = (in_plausible(&found.active.values), in_plausible(&found.sigma));
    let (least, jacobian) = trial.least_squares(&before);
    let k = before.len();
    let runs = trial.current.problem.segments.iter().map(|segment| segment.rows.clone());
    let mut whole = clustered(runs, &jacobian, &least.residual);
    for j in 0..k {
        whole[(j, j)] += sigma[j] * sigma[j];
    }
    let change = Mat::from_fn(k, 1, |j, _| least.sizes[j] - before[j]);
    let Ok(factor) = whole.llt(Side::Lower) else { return before };
    let weight = factor.solve(&change);
    let step: Vec<f64> = (0..k).map(|j| sigma[j] * sigma[j] * weight[(j, 0)]).collect();
    let far =
        step.iter().zip(&sigma).map(|(step, sigma)| (step / sigma).abs()).fold(f64::MIN_POSITIVE, f64::max);
    let share = (trial.setting.rules().naming.settled_within / far).min(1.0);
    before.iter().zip(step).map(|(size, step)| size + share * step).collect()
}

/// Covariance of sizes by least squares: `A⁻¹ (sum over runs of g g') A⁻¹`, A = J'J + I, g = J'r of a run's rows.
fn clustered(
    runs: impl IntoIterator<Item = Range<usize>>,
    jacobian: &Mat<f64>,
    residual: &[f64],
) -> Mat<f64> {
    let k = jacobian.ncols();
    let normal = jacobian.transpose() * jacobian + Mat::<f64>::identity(k, k);
    let mut scatter = Mat::zeros(k, k);
    for run in runs {
        let of = |j: usize| run.clone().map(|i| jacobian[(i, j)] * residual[i]).sum::<f64>();
        let score = Mat::from_fn(k, 1, |j, _| of(j));
        scatter += &score * score.transpose();
    }
    let inverse = normal.full_piv_lu();
    inverse.solve(inverse.solve(&scatter).transpose())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_that_are_off_as_a_whole_tell_less_than_their_samples() {
        let jacobian = Mat::from_fn(6, 1, |_, _| 2.0);
        let of = |residual: [f64; 6]| clustered([0..3, 3..6], &jacobian, &residual)[(0, 0)];
        // each run as a whole: scores of 2 x 3 and -2 x 3 over 6 x 2² + 1
        assert!((of([1.0, 1.0, 1.0, -1.0, -1.0, -1.0]) - 2.0 * 36.0 / 625.0).abs() < 1e-12);
        // the same sum of squares from sample to sample: scores of 2 and -2
        assert!((of([1.0, -1.0, 1.0, -1.0, 1.0, -1.0]) - 2.0 * 4.0 / 625.0).abs() < 1e-12);
    }

    #[test]
    fn covariances_of_two_sizes_are_those_of_the_textbook() {
        // J'J + I = diag(5, 10): sizes of runs that see one parameter each do not mix
        let jacobian = Mat::from_fn(2, 2, |i, j| [[2.0, 0.0], [0.0, 3.0]][i][j]);
        let covariance = clustered([0..1, 1..2], &jacobian, &[1.0, 2.0]);
        let by_hand = [[4.0 / 25.0, 0.0], [0.0, 36.0 / 100.0]];
        for (i, row) in by_hand.iter().enumerate() {
            for (j, value) in row.iter().enumerate() {
                assert!((covariance[(i, j)] - value).abs() < 1e-12, "{i} {j}");
            }
        }
        // one run that sees both: its parameters are off together
        let together = clustered(std::iter::once(0..2), &jacobian, &[1.0, 2.0]);
        assert!((together[(0, 1)] - 2.0 * 6.0 / 50.0).abs() < 1e-12);
    }
}
