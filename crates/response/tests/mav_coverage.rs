//! What the generator's errors leave of ordinary statistics: with the published structure given, intervals of ordinary
//! least squares hold the published coefficients as often as they should, although forces, not coefficients, scatter alike;
//! and blocking on runs removes more than half of the pure error (claim M12). The fit here is the test's own (modified
//! Gram-Schmidt), so that nothing depends on the regression of this crate.

use std::path::Path;

use response::mav::{Errors, Model, Published, Runs, Series, draw, truth};
use statrs::distribution::{ContinuousCDF, StudentsT};

fn published() -> Published {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/mav/published");
    Published::read(&folder).expect("the shipped coefficients")
}

/// Columns of the model's terms, then one for each block but the last: 1 in it, -1 in the last, so that the first
/// coefficients are those of the mean block.
fn columns(model: &Model, runs: &Runs) -> Vec<Vec<f64>> {
    let of_term = |k: usize| -> Vec<f64> {
        let term = &model.coefficients[k].term;
        runs.rows.iter().map(|row| row.point.condition.value(term).expect("a factor of the series")).collect()
    };
    let last = runs.series.blocks() - 1;
    let of_block = |block: usize| -> Vec<f64> {
        let code = |row: usize| f64::from(i8::from(row == block) - i8::from(row == last));
        runs.rows.iter().map(|row| code(row.block)).collect()
    };
    (0..model.coefficients.len()).map(of_term).chain((0..last).map(of_block)).collect()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Orthonormal columns Q and the inverse of R, upper triangular, with X = Q R.
fn factorise(mut q: Vec<Vec<f64>>) -> (Vec<Vec<f64>>, Vec<Vec<f64>>) {
    let count = q.len();
    let mut r = vec![vec![0.0; count]; count];
    for j in 0..count {
        // twice is enough (Kahan)
        for _ in 0..2 {
            for i in 0..j {
                let share = dot(&q[i], &q[j]);
                r[i][j] += share;
                let done = q[i].clone();
                q[j].iter_mut().zip(done).for_each(|(value, done)| *value -= share * done);
            }
        }
        r[j][j] = dot(&q[j], &q[j]).sqrt();
        let norm = r[j][j];
        q[j].iter_mut().for_each(|value| *value /= norm);
    }
    let unit = |i: usize, k: usize| f64::from(u8::from(i == k));
    let mut inverse = vec![vec![0.0; count]; count];
    for i in (0..count).rev() {
        let row: Vec<f64> = (0..count)
            .map(|k| (unit(i, k) - (i + 1..count).map(|j| r[i][j] * inverse[j][k]).sum::<f64>()) / r[i][i])
            .collect();
        inverse[i] = row;
    }
    (q, inverse)
}

/// Of each coefficient, how many of the draws have it in its 95 % interval.
fn coverage(published: &Published, series: Series, response: usize, draws: &[Runs]) -> Vec<f64> {
    let (equations, wing) = series.equations();
    let model = published.equation(equations[response], wing).expect("the series' equation");
    let (q, inverse) = factorise(columns(model, &draws[0]));
    let terms = model.coefficients.len();
    let freedom = (draws[0].rows.len() - q.len()) as f64;
    let quantile = StudentsT::new(0.0, 1.0, freedom).expect("degrees of freedom").inverse_cdf(0.975);
    let mut inside = vec![0.0; terms];
    for runs in draws {
        let y = runs.response(&model.response).expect("a response");
        let projected: Vec<f64> = q.iter().map(|column| dot(column, &y)).collect();
        let variance = (dot(&y, &y) - dot(&projected, &projected)) / freedom;
        for k in 0..terms {
            let value = dot(&inverse[k], &projected);
            let sigma = (variance * dot(&inverse[k], &inverse[k])).sqrt();
            let true_value = model.coefficients[k].value.expect("Eqs. 4 to 7 are complete");
            inside[k] += f64::from(u8::from((value - true_value).abs() <= quantile * sigma));
        }
    }
    inside.iter().map(|inside| inside / draws.len() as f64).collect()
}

fn drawn(published: &Published, series: Series, count: u64) -> Vec<Runs> {
    let one = |seed| draw(published, series, &Errors::default(), seed).expect("the series' equations");
    (1..=count).map(one).collect()
}

#[test]
fn with_the_structure_given_95_percent_intervals_hold_the_published_coefficients() {
    let published = published();
    let mut all = Vec::new();
    for (series, responses) in [(Series::PropellerSpeed, 1), (Series::PropellerOff, 3)] {
        let draws = drawn(&published, series, 500);
        for response in 0..responses {
            let shares = coverage(&published, series, response, &draws);
            let mean = shares.iter().sum::<f64>() / shares.len() as f64;
            assert!((0.93..=0.97).contains(&mean), "{} {response}: {mean} of {shares:?}", series.name());
            all.extend(shares);
        }
    }
    assert_eq!(all.len(), 9 + 12 + 15 + 8);
    let mean = all.iter().sum::<f64>() / all.len() as f64;
    assert!((0.93..=0.97).contains(&mean), "{mean}");
    // no single coefficient is hidden in the mean: four standard errors of 500 draws below 0.95
    assert!(all.iter().all(|&share| share > 0.911), "{all:?}");
}

/// Mean square about the mean of replicates, and the same once the means of the runs are taken out.
fn pure_error(runs: &Runs, response: usize) -> (f64, f64) {
    let blocks = runs.series.blocks();
    let points = runs.rows.len() / blocks;
    let y = |block: usize, point: usize| runs.rows[block * points + point].values[response];
    let of_point: Vec<f64> =
        (0..points).map(|p| (0..blocks).map(|b| y(b, p)).sum::<f64>() / blocks as f64).collect();
    let of_block: Vec<f64> = (0..blocks)
        .map(|b| (0..points).map(|p| y(b, p) - of_point[p]).sum::<f64>() / points as f64)
        .collect();
    let (mut plain, mut blocked) = (0.0, 0.0);
    for (b, shift) in of_block.iter().enumerate() {
        for (p, mean) in of_point.iter().enumerate() {
            plain += (y(b, p) - mean).powi(2);
            blocked += (y(b, p) - mean - shift).powi(2);
        }
    }
    let lost = (blocks - 1) as f64;
    (plain / (lost * points as f64), blocked / (lost * (points - 1) as f64))
}

#[test]
fn m12_blocking_on_runs_removes_more_than_half_of_the_pure_error_of_the_shipped_runs() {
    let published = published();
    for series in [Series::PropellerSpeed, Series::PropellerOff] {
        let runs = draw(&published, series, &Errors::default(), response::mav::SHIPPED_SEED).expect("runs");
        for response in 0..runs.responses.len() {
            let (plain, blocked) = pure_error(&runs, response);
            assert!(blocked < 0.5 * plain, "{} {response}: {plain:e} {blocked:e}", series.name());
        }
    }
}

#[test]
fn blocking_finds_the_declared_scatter() {
    // without the balance the variance within runs is that of the points: a chi-square of 100 x 254
    let published = published();
    let errors = Errors { balance: None, ..Errors::default() };
    let variances = (0..100)
        .map(|seed| pure_error(&draw(&published, Series::PropellerOff, &errors, seed).expect("runs"), 0).1);
    let mean = variances.sum::<f64>() / 100.0;
    let declared = errors.lift.point.powi(2);
    assert!((mean / declared - 1.0).abs() < 3.0 * (2.0 / 25_400.0_f64).sqrt(), "{mean:e} {declared:e}");
    let clean = truth(&published, Series::PropellerOff).expect("runs");
    assert!(pure_error(&clean, 0).0 < 1e-30);
}
