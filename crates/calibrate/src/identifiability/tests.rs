//! The posterior as covariance, beside its textbook's form by information: `(M/s² + J' N⁻¹ J)⁻¹`.

use super::*;
use crate::calibration::Context;
use crate::campaign::TipReading;
use crate::objective::line_fit;
use crate::statics::StaticData;
use crate::tests::{RHO, Toy, near, noise, settings};
use faer::linalg::solvers::DenseSolveCore;

/// Of a family's corrections over the boxes; a family has four unknowns, which share it.
const SPREAD: f64 = 0.3;
const UNIT: f64 = 0.15;
const SIGMA: [f64; 4] = [0.5, 0.4, 0.02, 1e-3];
const COMMON: [f64; 4] = [0.3, 0.0, 0.01, 5e-4];

/// What is told, the metric, and the derivatives of all rows by channel, of a wing whose rows are repeated once,
/// twice, ...
fn told(tip: TipReading) -> (Identifiability, Basis, Mat<f64>, Vec<Mat<f64>>) {
    let toy = Toy::new(4, 2);
    let alphas = [-0.05, 0.0, 0.1];
    let mut campaign = toy.measured(&[10.0], &alphas, &toy.uniform(1.1));
    (campaign.tip, campaign.noise) = (tip, Some(noise(SIGMA)));
    let more: Vec<_> = [1, 2, 2].iter().map(|&i: &usize| campaign.points[i].clone()).collect();
    campaign.points.extend(more);
    let data = StaticData::from_campaign(&campaign).expect("it is sound");
    let settings = settings(2);
    let context = Context::new(&toy, RHO, &data, &settings);
    let metric = context.metric(&data.airspeeds).expect("it is linear");
    let problem = context
        .problem(&data.airspeeds[0], &line_fit(&data, &data.airspeeds[0]), &metric)
        .expect("it is linear");
    let at = problem.linearise(&context.basis.neutral()).expect("it is linear");
    let inputs = Inputs {
        basis: &context.basis,
        area_share: &toy.boxes.area_share,
        metric: &metric,
        prior_spread: SPREAD,
        channels: data.channels,
        angles: data.airspeeds[0].angles.iter().collect(),
        zero: &problem.zero,
        point_sigma: SIGMA,
        common_sigma: COMMON,
    };
    let found = identifiability(&at, &inputs).expect("it is finite");
    let gradients: Vec<Mat<f64>> = at.sensitivities.iter().map(|s| context.basis.gradient(s)).collect();
    let jacobians = (0..4).filter(|&c| data.channels[c]).map(|c| problem.jacobian(&gradients, c)).collect();
    (found, context.basis.clone(), metric.clone(), jacobians)
}

#[test]
fn what_is_told_is_the_posterior_by_information() {
    for (tip, channels) in [(TipReading::Unused, 3), (TipReading::Zeroed, 4)] {
        let (found, basis, metric, jacobians) = told(tip);
        let (size, rows) = (basis.size(), 3 * channels);
        let jacobian = Mat::from_fn(rows, size, |r, k| jacobians[r / 3][(r % 3, k)]);
        // one row, two and three
        let noise = Mat::from_fn(rows, rows, |a, b| {
            let c = a / 3;
            let own = if a == b { SIGMA[c].powi(2) / [1.0, 2.0, 3.0][a % 3] } else { 0.0 };
            own + if b / 3 == c { COMMON[c].powi(2) } else { 0.0 }
        });
        let precision = faer::Scale(1.0 / (UNIT * UNIT)) * &metric
            + jacobian.transpose() * noise.partial_piv_lu().inverse() * &jacobian;
        let posterior = precision.partial_piv_lu().inverse();
        let prior = faer::Scale(UNIT * UNIT) * metric.partial_piv_lu().inverse();
        let variance = |covariance: &Mat<f64>, row: &[f64]| -> f64 {
            (0..size).map(|i| (0..size).map(|j| row[i] * covariance[(i, j)] * row[j]).sum::<f64>()).sum()
        };
        let of_box = |family: usize, b: usize| {
            let mut row = vec![0.0; size];
            (0..basis.terms)
                .for_each(|k| row[basis.column(family, basis.strip_of[b]) + k] = basis.polynomials[(b, k)]);
            row
        };
        let ByFamily { force, moment, pressure_offset } = found.posterior_sigma;
        let remaining = found.remaining_spread;
        let remaining = [remaining.force, remaining.moment, remaining.pressure_offset];
        for (family, sigma) in [force, moment, pressure_offset].into_iter().enumerate() {
            let both =
                |b: usize| [&posterior, &prior].map(|covariance| variance(covariance, &of_box(family, b)));
            near(sigma, ((0..8).map(|b| both(b)[0]).sum::<f64>() / 8.0).sqrt(), 1e-6);
            let ratio = |b: usize| (both(b)[0] / both(b)[1]).sqrt();
            if family < 2 {
                near((0..8).map(|b| both(b)[1]).sum::<f64>() / 8.0, SPREAD * SPREAD, 1e-9);
            }
            near(remaining[family], (0..8).map(ratio).sum::<f64>() / 8.0, 1e-6);
        }
        let mean: Vec<f64> = (0..size).map(|k| (0..8).map(|b| of_box(0, b)[k] / 8.0).sum()).collect();
        near(found.mean_force_sigma[0], variance(&prior, &mean).sqrt(), 1e-6);
        near(found.mean_force_sigma[1], variance(&posterior, &mean).sqrt(), 1e-6);
        for c in 0..channels {
            let row = |i: usize| (0..size).map(|k| jacobian[(3 * c + i, k)]).collect::<Vec<f64>>();
            let mean_square = (0..3).map(|i| variance(&posterior, &row(i))).sum::<f64>() / 3.0;
            near(found.predicted_sigma[c], mean_square.sqrt(), 1e-6);
        }
        assert_eq!(found.predicted_sigma[3] > 0.0, channels == 4);
    }
}

/// Singular values squared are the eigenvalues of `J M⁻¹ J'` over the noise: their sum is its trace.
#[test]
fn singular_values_are_of_the_data_over_their_noise_in_units_of_the_prior() {
    let (found, basis, metric, jacobians) = told(TipReading::FreeZero);
    let size = basis.size();
    let inverse = metric.partial_piv_lu().inverse();
    let square = |c: usize, i: usize, from: usize, to: usize| -> f64 {
        let by = |k: usize| jacobians[c][(i, k)];
        (from..to).map(|k| (from..to).map(|l| by(k) * inverse[(k, l)] * by(l)).sum::<f64>()).sum()
    };
    let all = (0..4).flat_map(|c| (0..3).map(move |i| (c, i)));
    let trace: f64 =
        all.map(|(c, i)| square(c, i, 0, size) * [1.0, 2.0, 3.0][i] * (UNIT / SIGMA[c]).powi(2)).sum();
    near(found.singular_values.iter().map(|s| s * s).sum(), trace, 1e-6);
    assert!(found.singular_values.is_sorted_by(|a, b| a >= b));
    assert_eq!(found.determined_directions, found.singular_values.iter().filter(|s| **s > 1.0).count());
    // three loads' slopes and offsets, and the tip's slope: they hang together, as the tip follows the moment
    assert!((1..=6).contains(&found.determined_directions), "{:?}", found.singular_values);
    let ByFamily { force, moment, pressure_offset } = found.leverage;
    for c in 0..4 {
        let of = |family: usize| {
            (0..3).map(|i| square(c, i, family * size / 3, (family + 1) * size / 3)).sum::<f64>()
        };
        let total = of(0) + of(1) + of(2);
        for (family, share) in [force, moment, pressure_offset].into_iter().enumerate() {
            assert!((share[c] - (of(family) / total).sqrt()).abs() < 1e-9, "{family} {c}: {share:?}");
        }
    }
}

#[test]
fn a_family_on_which_less_than_a_twentieth_hangs_is_undetermined() {
    let (mut found, ..) = told(TipReading::Unused);
    let of = |found: &mut Identifiability, force: f64, moment: f64, offset: f64| {
        found.leverage = ByFamily {
            force: [0.0, force, 0.0, 0.0],
            moment: [moment; 4],
            pressure_offset: [0.0, 0.0, 0.0, offset],
        };
        found.undetermined()
    };
    assert_eq!(of(&mut found, 0.05, 0.049, 1.0), ["moment"]);
    assert_eq!(of(&mut found, 0.04, 0.05, 0.0), ["force", "pressure_offset"]);
    assert_eq!(
        ByFamily::from_array([1, 2, 3]).map(|value| 2 * value),
        ByFamily { force: 2, moment: 4, pressure_offset: 6 }
    );
}
