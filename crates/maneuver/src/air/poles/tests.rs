//! Poles that are known are found again; bounds, starts and misfits by hand.

use super::*;
use faer::c64;

#[test]
fn poles_lie_within_their_bounds_and_apart() {
    let ln = |poles: &[f64]| -> Vec<f64> { poles.iter().map(|pole| pole.ln()).collect() };
    for (poles, expected) in [
        (&[0.051][..], true),
        (&[0.049], false),
        (&[39.9], true),
        (&[40.1], false),
        (&[2.0, 3.02], true),
        (&[2.0, 2.98], false),
        (&[3.02, 2.0], true),
        (&[0.051, 20.0, 0.06], false),
        (&[20.0, 0.051, 0.08], true),
        (&[], true),
    ] {
        assert_eq!(allowed(&ln(poles), 10.0), expected, "{poles:?}");
    }
}

#[test]
fn starts_are_geometric_rows() {
    let row: Vec<f64> = start(4, 10.0, 0.02, 2.5).iter().map(|l| l.exp()).collect();
    assert!(row.iter().zip([0.2, 1.0, 5.0, 25.0]).all(|(a, b)| (a / b - 1.0).abs() < 1e-12), "{row:?}");
    assert!((start(1, 10.0, 0.02, 2.5)[0].exp() - 0.2).abs() < 1e-12);
    assert!(start(0, 10.0, 0.02, 2.5).is_empty());
}

#[test]
fn entries_are_what_is_beyond_the_steady_answer_over_its_largest_modulus() {
    // two boxes, two motions; one row adds the boxes, the other looks at nothing
    let cp = |factor: f64| {
        Mat::from_fn(2, 2, |i, j| c64::new(1.0 + i as f64 + 2.0 * j as f64, 0.5 + i as f64) * factor)
    };
    let table = AirTable { omega_over_v_per_m: vec![0.5, 1.0], cp: vec![cp(1.0), cp(2.0)] };
    let steady = Mat::from_fn(2, 2, |i, j| 0.25 + 0.5 * (i + j) as f64);
    let rows = Mat::from_fn(2, 2, |i, _| if i == 0 { 1.0 } else { 0.0 });
    let data = Entries::new(&table, steady.as_ref(), rows.as_ref()).data;
    assert_eq!((data.nrows(), data.ncols()), (4, 4));
    // sums 3 + 2i and 7 + 2i, twice that at the second frequency; at rest 1 and 2
    for (entry, (re, rest)) in [(3.0, 1.0), (7.0, 2.0)].into_iter().enumerate() {
        let largest = 2.0 * f64::hypot(re, 2.0);
        for (sample, wanted) in [re - rest, 2.0 * re - rest, 2.0, 4.0].into_iter().enumerate() {
            assert!((data[(sample, entry)] - wanted / largest).abs() < 1e-12, "{sample} {entry}");
        }
        assert!((0..4).all(|sample| data[(sample, 2 + entry)] == 0.0));
    }
}

/// A row that symmetry keeps at zero for the second motion has a trillionth of its first one's load there, of any phase.
#[test]
fn rounding_chooses_no_poles() {
    let data = |second: f64| {
        let cp = |k: f64| Mat::from_fn(1, 2, |_, j| c64::new(1.0, k) * if j == 0 { 1.0 } else { second });
        let table = AirTable { omega_over_v_per_m: vec![0.5, 1.0], cp: vec![cp(0.3), cp(0.7)] };
        Entries::new(&table, Mat::zeros(1, 2).as_ref(), Mat::full(1, 1, 1.0).as_ref()).data
    };
    let is_there = |second: f64| data(second).col(1).iter().any(|value| *value != 0.0);
    assert!(is_there(1e-8) && !is_there(1e-12) && !is_there(0.0));
}

/// Weights at frequencies 1 and 2 are 1/.9 and 1/1.4: what is at right angles to p and p² is all misfit.
#[test]
fn a_misfit_is_the_sum_of_sixth_powers_of_the_largest_differences() {
    let (first, second) = (1.0 / (0.9 * 0.9), 1.0 / (1.4 * 1.4));
    let (real, imaginary) = ([4.0 * second, -first], [2.0 * second, -first]);
    let data = Mat::from_fn(4, 3, |sample, entry| {
        let (re, im) = (if entry == 1 { 0.0 } else { 1.0 }, if entry == 0 { 0.0 } else { 1.0 });
        if sample < 2 { re * real[sample] } else { im * imaginary[sample - 2] }
    });
    let misfit = Entries { data }.misfit(&[1.0, 2.0], &[]);
    let both = (0..2).map(|k| f64::hypot(real[k], imaginary[k])).fold(0.0, f64::max);
    let most = |pair: [f64; 2]| pair.map(f64::abs).into_iter().fold(0.0, f64::max);
    let wanted: f64 = [most(real), most(imaginary), both].map(|error| error.powi(6)).iter().sum();
    assert!((misfit / wanted - 1.0).abs() < 1e-9, "{misfit} {wanted}");
}

/// One entry with lags at these poles, and what is left of it with theirs in the fit.
fn with_lags(poles: &[f64]) -> AirTable {
    let kappa: Vec<f64> = (1..=12).map(|k| 10.0 * (f64::from(k) / 12.0).powi(2)).collect();
    let at = |kappa: &f64| {
        let p = c64::new(0.0, *kappa);
        let lags = poles.iter().enumerate().map(|(k, g)| p / (p + *g) * (0.8 - 0.3 * k as f64));
        Mat::from_fn(1, 1, |_, _| c64::from(2.0) + p * 0.1 + p * p * 0.02 - lags.clone().sum::<c64>())
    };
    AirTable { cp: kappa.iter().map(at).collect(), omega_over_v_per_m: kappa }
}

#[test]
fn poles_of_a_function_of_the_fitted_form_are_found_again() {
    let (steady, rows) = (Mat::from_fn(1, 1, |_, _| 2.0), Mat::from_fn(1, 1, |_, _| 1.0));
    for poles in [&[1.3][..], &[0.4, 3.0]] {
        let table = with_lags(poles);
        let entries = Entries::new(&table, steady.as_ref(), rows.as_ref());
        let kappa = &table.omega_over_v_per_m;
        let exact: Vec<f64> = poles.iter().map(|pole| pole.ln()).collect();
        assert!(entries.misfit(kappa, &exact) < 1e-60, "{:e}", entries.misfit(kappa, &exact));
        let found = choose(&table, steady.as_ref(), rows.as_ref(), poles.len());
        assert_eq!(found.len(), poles.len());
        for (found, pole) in found.iter().zip(poles) {
            // the last step of the logarithms is .02
            assert!((found / pole).ln().abs() < 0.03, "{found} {pole}");
        }
        // a search never ends worse than it begins, and none of its neighbours by a last step is better
        let begin = start(poles.len(), 10.0, 0.02, 2.0);
        let (misfit, end) = search(&entries, kappa, 10.0, begin.clone());
        assert!(misfit < entries.misfit(kappa, &begin));
        assert_eq!(misfit, entries.misfit(kappa, &end));
        for pole in 0..end.len() {
            for by in [0.025, -0.025] {
                let mut moved = end.clone();
                moved[pole] += by;
                assert!(entries.misfit(kappa, &moved) >= misfit, "pole {pole} by {by}");
            }
        }
    }
    let table = with_lags(&[1.3]);
    assert!(choose(&table, steady.as_ref(), rows.as_ref(), 0).is_empty());
    let entries = Entries::new(&table, steady.as_ref(), rows.as_ref());
    assert_eq!(search(&entries, &table.omega_over_v_per_m, 10.0, Vec::new()).1.len(), 0);
    // where bounds stop it it stays: nothing may lie nearer than half as much again
    let (_, end) = search(&entries, &table.omega_over_v_per_m, 10.0, vec![0.2, 0.2 + 1.6_f64.ln()]);
    assert!(allowed(&end, 10.0), "{end:?}");
}
