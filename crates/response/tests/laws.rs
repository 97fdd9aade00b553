//! Laws of the regression that hold for any data, on drawn ones: what a change of the problem that means nothing must not
//! change, and short cuts beside the long way.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use response::{
    Blocking, Blocks, Data, ErrorRule, FTest, Regression, Rules, Search, Term, choose, cross_validation,
    lack_of_fit, pure_error,
};

struct Drawn {
    x: Vec<f64>,
    z: Vec<f64>,
    y: Vec<f64>,
    labels: Vec<&'static str>,
}

/// 40 points of two factors far from zero, a surface of second order in them, noise, four blocks.
fn drawn(seed: u64) -> Drawn {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut normal = || -> f64 { StandardNormal.sample(&mut random) };
    let x: Vec<f64> = (0..40).map(|_| 20.0 + 3.0 * normal()).collect();
    let z: Vec<f64> = (0..40).map(|_| -5.0 + normal()).collect();
    let y =
        (0..40).map(|i| 1.0 + 0.3 * x[i] - 0.02 * x[i] * x[i] + z[i] + 0.1 * x[i] * z[i] + 0.5 * normal());
    let y = y.collect();
    Drawn { x, z, y, labels: (0..40).map(|i| ["a", "b", "c", "d"][i % 4]).collect() }
}

impl Drawn {
    fn data(&self) -> Data {
        self.with(|x| x, |_, y| y)
    }

    fn with(&self, x: impl Fn(f64) -> f64, y: impl Fn(usize, f64) -> f64) -> Data {
        let of_y = self.y.iter().enumerate().map(|(i, value)| y(i, *value)).collect();
        Data::new()
            .factor("x", self.x.iter().map(|value| x(*value)).collect())
            .and_then(|data| data.factor("z", self.z.clone()))
            .and_then(|data| data.response("y", of_y))
            .and_then(|data| data.block(Blocks::from_labels("run", self.labels.iter().copied())))
            .expect("data")
    }
}

fn terms(texts: &[&str]) -> Vec<Term> {
    texts.iter().map(|text| text.parse().expect("a term")).collect()
}

fn second_order() -> Vec<Term> {
    Term::up_to_order(&["x", "z"], 2)
}

fn close(got: f64, want: f64, relative: f64, what: &str) {
    assert!((got - want).abs() <= relative * want.abs().max(1e-12), "{what}: {got}, expected {want}");
}

/// The plain way: normal equations of centred columns by elimination.
fn plain_predictions(data: &Data, terms: &[Term]) -> Vec<f64> {
    let y = data.response_values("y").expect("y");
    let columns: Vec<Vec<f64>> = terms.iter().map(|term| data.column(term).expect("a column")).collect();
    let scale: Vec<f64> = columns.iter().map(|c| c.iter().map(|v| v * v).sum::<f64>().sqrt()).collect();
    let n = columns.len();
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut rows: Vec<Vec<f64>> = (0..n)
        .map(|i| {
            let own = (0..n).map(|j| product(&columns[i], &columns[j]) / scale[i] / scale[j]);
            own.chain([product(&columns[i], y) / scale[i]]).collect()
        })
        .collect();
    for i in 0..n {
        let pivot = rows[i].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(k, _)| *k != i) {
            let factor = row[i] / pivot[i];
            row.iter_mut().zip(&pivot).for_each(|(value, pivot)| *value -= factor * pivot);
        }
    }
    let solution: Vec<f64> = (0..n).map(|i| rows[i][n] / rows[i][i] / scale[i]).collect();
    (0..y.len()).map(|p| (0..n).map(|j| solution[j] * columns[j][p]).sum()).collect()
}

#[test]
fn an_orthogonalised_fit_predicts_as_the_plain_one() {
    for seed in 0..20 {
        let data = drawn(seed).data();
        let fitted = Regression::fit(&data, "y", &second_order(), Blocking::Ignored).unwrap();
        for (i, plain) in plain_predictions(&data, &second_order()).into_iter().enumerate() {
            close(fitted.value(&data.point(i)).unwrap(), plain, 1e-7, "prediction");
        }
        // and the order of orthogonalisation does not matter
        let mut reversed = second_order();
        reversed.reverse();
        let other = Regression::fit(&data, "y", &reversed, Blocking::Ignored).unwrap();
        for coefficient in &fitted.coefficients {
            let same = other.coefficient(&coefficient.term).unwrap();
            close(same.value, coefficient.value, 1e-10, "coefficient");
            close(same.standard_error, coefficient.standard_error, 1e-10, "standard error");
        }
    }
}

#[test]
fn shifted_blocks_change_nothing_but_their_offsets() {
    let drawn = drawn(3);
    let shift = [5.0, -2.0, 0.5, 11.0];
    let shifted = drawn.with(|x| x, |i, y| y + shift[i % 4]);
    let before = Regression::fit(&drawn.data(), "y", &second_order(), Blocking::Fixed).unwrap();
    let after = Regression::fit(&shifted, "y", &second_order(), Blocking::Fixed).unwrap();
    let mean = shift.iter().sum::<f64>() / 4.0;
    for (one, other) in before.coefficients.iter().zip(&after.coefficients) {
        let moved = if one.term.is_constant() { mean } else { 0.0 };
        assert!((other.value - one.value - moved).abs() < 1e-9 * one.value.abs().max(1.0), "{}", one.term);
        close(other.standard_error, one.standard_error, 1e-10, "standard error");
    }
    for (k, (one, other)) in before.offsets.iter().zip(&after.offsets).enumerate() {
        assert!((other.value - one.value - shift[k] + mean).abs() < 1e-9, "{}", one.label);
    }
    close(after.residual_sum, before.residual_sum, 1e-10, "residual sum");
    close(after.total_sum, before.total_sum, 1e-10, "total sum");
    let one = choose(&drawn.data(), "y", &second_order(), Rules::default()).unwrap();
    let other = choose(&shifted, "y", &second_order(), Rules::default()).unwrap();
    assert_eq!(one.fitted.terms(), other.fitted.terms());
    let pure = |data: &Data| pure_error(&repeated(data), "y", Blocking::Fixed).unwrap().sum;
    close(pure(&shifted), pure(&drawn.data()), 1e-9, "pure error");
}

/// The same data with factors rounded, so that points coincide.
fn repeated(data: &Data) -> Data {
    let round =
        |name| data.factor_values(name).expect("a factor").iter().map(|v: &f64| (v / 4.0).round()).collect();
    Data::new()
        .factor("x", round("x"))
        .and_then(|new| new.factor("z", round("z")))
        .and_then(|new| new.response("y", data.response_values("y").expect("y").to_vec()))
        .and_then(|new| new.block(data.blocks()[0].clone()))
        .expect("data")
}

#[test]
fn a_hierarchical_choice_does_not_depend_on_where_a_factor_is_counted_from() {
    for seed in 0..20 {
        let drawn = drawn(seed);
        let candidates = Term::up_to_order(&["x", "z"], 3);
        for search in [Search::BestSubset, Search::Stepwise, Search::Ranked] {
            let rules = Rules { search, ..Rules::default() };
            let here = choose(&drawn.data(), "y", &candidates, rules).unwrap();
            let there = choose(&drawn.with(|x| x + 37.0, |_, y| y), "y", &candidates, rules).unwrap();
            assert_eq!(here.fitted.terms(), there.fitted.terms(), "{search:?} {seed}");
            close(there.fitted.residual_sum, here.fitted.residual_sum, 1e-8, "residual sum");
        }
    }
}

#[test]
fn leaving_one_point_out_is_what_its_leverage_says() {
    let drawn = drawn(7);
    let data = drawn.data();
    let rules = Rules { blocking: Blocking::Ignored, error: ErrorRule::LeastT(1.0), ..Rules::default() };
    let choice = choose(&data, "y", &second_order(), rules).unwrap();
    let mut sum = 0.0;
    for out in 0..40 {
        let without =
            |values: &[f64]| values.iter().enumerate().filter(|(i, _)| *i != out).map(|(_, v)| *v).collect();
        let rest = Data::new().factor("x", without(&drawn.x)).and_then(|d| d.factor("z", without(&drawn.z)));
        let rest = rest.and_then(|d| d.response("y", without(&drawn.y))).unwrap();
        let fitted = Regression::fit(&rest, "y", &choice.fitted.terms(), Blocking::Ignored).unwrap();
        sum += (drawn.y[out] - fitted.value(&data.point(out)).unwrap()).powi(2);
    }
    close(choice.curve[choice.chosen].criteria.leave_one_out, sum / 40.0, 1e-9, "leave-one-out");
    // and so do folds of one point
    let each: Vec<usize> = (0..40).collect();
    let folds = cross_validation(&data, "y", &choice.fitted.terms(), Blocking::Ignored, &each).unwrap();
    close(folds, sum / 40.0, 1e-9, "folds of one point");
}

#[test]
fn a_block_that_is_left_out_is_predicted_at_the_mean_of_the_others() {
    // no scatter: what is left of block k is its offset from the mean of the other three
    let offsets = [3.0, -1.0, 0.5, 2.0];
    let drawn = drawn(2);
    let data = drawn.with(|x| x, |i, _| 1.0 + 2.0 * drawn.x[i] + offsets[i % 4]);
    let fold: Vec<usize> = (0..40).map(|i| i % 4).collect();
    let got = cross_validation(&data, "y", &terms(&["1", "x"]), Blocking::Fixed, &fold).unwrap();
    let sum: f64 = offsets.iter().sum();
    let want = offsets.iter().map(|o| (o - (sum - o) / 3.0).powi(2)).sum::<f64>() / 4.0;
    close(got, want, 1e-9, "cross-validation by blocks");
}

#[test]
fn the_best_subsets_are_those_of_trying_all() {
    for seed in 0..5 {
        let data = drawn(seed).data();
        let candidates = Term::up_to_order(&["x", "z"], 3);
        for hierarchical in [true, false] {
            let rules = Rules { hierarchical, ..Rules::default() };
            let choice = choose(&data, "y", &candidates, rules).unwrap();
            assert!(choice.complete && choice.curve_complete);
            let mut best = vec![f64::INFINITY; candidates.len() + 1];
            for set in 0..1_usize << (candidates.len() - 1) {
                let chosen = (0..candidates.len()).filter(|k| *k == 0 || set >> (k - 1) & 1 == 1);
                let chosen: Vec<Term> = chosen.map(|k| candidates[k].clone()).collect();
                let needs = |term: &Term| candidates.iter().all(|c| !term.is_above(c) || chosen.contains(c));
                if !hierarchical || chosen.iter().all(needs) {
                    let fitted = Regression::fit(&data, "y", &chosen, Blocking::Fixed).unwrap();
                    best[chosen.len()] = best[chosen.len()].min(fitted.residual_sum);
                }
            }
            for step in &choice.curve {
                close(step.criteria.residual_sum, best[step.terms.len()], 1e-6, "residual sum");
            }
            assert_eq!(choice.curve.len(), candidates.len());
        }
    }
}

#[test]
fn an_f_test_of_a_family_is_that_of_the_extra_sum_of_squares() {
    let data = drawn(11).data();
    for blocking in [Blocking::Ignored, Blocking::Fixed] {
        let full = Regression::fit(&data, "y", &second_order(), blocking).unwrap();
        let small = Regression::fit(&data, "y", &terms(&["1", "x", "z"]), blocking).unwrap();
        let test = full.family_test(&terms(&["x^2", "x*z", "z^2"])).unwrap();
        let extra = FTest::new(
            small.residual_sum - full.residual_sum,
            3.0,
            full.residual_sum,
            full.degrees_of_freedom,
        );
        close(test.f, extra.f, 1e-9, "F");
        close(test.p_value, extra.p_value, 1e-7, "p");
        for coefficient in &full.coefficients {
            let alone = full.family_test(std::slice::from_ref(&coefficient.term)).unwrap();
            close(alone.f, coefficient.t.powi(2), 1e-9, "t squared");
        }
    }
}

#[test]
fn lack_of_fit_splits_the_residual_of_a_line() {
    // y = x^2 at 0, 1, 2 with replicates 0.1 apart: pure error 3 x 0.005, a line leaves the curvature
    let x = vec![0.0, 0.0, 1.0, 1.0, 2.0, 2.0];
    let y = vec![0.05, -0.05, 1.05, 0.95, 4.05, 3.95];
    let data = Data::new().factor("x", x).and_then(|d| d.response("y", y)).unwrap();
    let fitted = Regression::fit(&data, "y", &terms(&["1", "x"]), Blocking::Ignored).unwrap();
    let pure = pure_error(&data, "y", Blocking::Ignored).unwrap();
    close(pure.sum, 0.015, 1e-12, "pure error");
    assert_eq!(pure.degrees_of_freedom, 3.0);
    // means 0, 1, 4 about their line 2 x - 1/3: 1/3, -2/3, 1/3, each twice: 12/9
    let test = lack_of_fit(&data, &fitted, Blocking::Ignored).unwrap();
    close(test.f, 12.0 / 9.0 / 0.005, 1e-10, "F");
    assert_eq!((test.above, test.below), (1.0, 3.0));
}

#[test]
fn predictions_know_how_far_they_are_from_the_data() {
    // a straight line: variance s^2 (1/n + (x - mean)^2 / Sxx)
    let x: Vec<f64> = (0..10).map(f64::from).collect();
    let y = x.iter().enumerate().map(|(i, x)| 2.0 + 3.0 * x + if i % 2 == 0 { 0.1 } else { -0.1 }).collect();
    let data = Data::new().factor("x", x).and_then(|d| d.response("y", y)).unwrap();
    let fitted = Regression::fit(&data, "y", &terms(&["1", "x"]), Blocking::Ignored).unwrap();
    for at in [-3.0, 0.0, 4.5, 9.0, 20.0] {
        let prediction = fitted.predict(&[("x", at)]).unwrap();
        close(prediction.leverage, 0.1 + (at - 4.5) * (at - 4.5) / 82.5, 1e-12, "leverage");
        assert_eq!(prediction.extrapolated, !(0.0..=9.0).contains(&at), "{at}");
        let (mean, reading) =
            (prediction.mean_interval(0.95).unwrap(), prediction.reading_interval(0.95).unwrap());
        assert!(reading.0 < mean.0 && mean.1 < reading.1);
    }
    let slope = fitted.slope("x", &[("x", 2.0)]).unwrap();
    close(slope.value, fitted.coefficients[1].value, 1e-12, "slope");
    close(slope.standard_error, fitted.coefficients[1].standard_error, 1e-12, "its error");
    close(fitted.leverages.iter().sum(), 2.0, 1e-12, "leverages add up to parameters");
    // two points of a line differ by slope times distance, and so does what is significant of it (t(0.975, 8), SciPy)
    let lsd = fitted.least_significant_difference(&[("x", 7.0)], &[("x", 4.0)], 0.95).unwrap();
    close(lsd, 2.306_004_135_204_166 * 3.0 * slope.standard_error, 1e-10, "LSD");
    let mean = fitted.mean_least_significant_difference(0.95).unwrap();
    close(mean, 2.306_004_135_204_166 * (2.0 * fitted.error_variance * 0.2).sqrt(), 1e-10, "LSD");
}

#[test]
fn the_gradient_is_that_of_the_surface() {
    let data = drawn(5).data();
    let fitted =
        Regression::fit(&data, "y", &terms(&["1", "x", "z", "x^2/z", "x*z"]), Blocking::Fixed).unwrap();
    let at = |x: f64, z: f64| fitted.value(&[("x", x), ("z", z)]).unwrap();
    let gradient = fitted.gradient(&[("x", 21.0), ("z", -4.0)]).unwrap();
    let h = 1e-4;
    close(gradient[0].value, (at(21.0 + h, -4.0) - at(21.0 - h, -4.0)) / (2.0 * h), 1e-6, "d/dx");
    close(gradient[1].value, (at(21.0, -4.0 + h) - at(21.0, -4.0 - h)) / (2.0 * h), 1e-6, "d/dz");
}
