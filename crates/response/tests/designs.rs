//! Planned experiments: fractions and what they confuse, composite and D-optimal designs with known answers, power beside
//! SciPy.

use response::design::{
    Axial, Design, Generator, central_composite, d_optimal, detectable_noncentrality, fractional_factorial,
    full_factorial, power, smallest_effects,
};
use response::{Blocking, Blocks, Regression, Term};

fn terms(texts: &[&str]) -> Vec<Term> {
    texts.iter().map(|text| text.parse().expect("a term")).collect()
}

fn generators(texts: &[&str]) -> Vec<Generator> {
    texts.iter().map(|text| Generator::parse(text).expect("a generator")).collect()
}

#[test]
fn a_full_factorial_is_in_standard_order_and_orthogonal() {
    let design = full_factorial(&["a", "b", "c"]).unwrap();
    assert_eq!(design.points().len(), 8);
    assert_eq!(design.points()[1], [1.0, -1.0, -1.0]);
    assert_eq!(design.points()[6], [-1.0, 1.0, 1.0]);
    let all = Term::up_to_order(&["a", "b", "c"], 3);
    let single: Vec<Term> =
        all.into_iter().filter(|term| term.powers().all(|(_, power)| power == 1)).collect();
    assert_eq!(single.len(), 8);
    for (i, one) in single.iter().enumerate() {
        for other in &single[..i] {
            let (one, other) = (design.column(one).unwrap(), design.column(other).unwrap());
            assert_eq!(one.iter().zip(other).map(|(a, b)| a * b).sum::<f64>(), 0.0);
        }
    }
    let decoded = design.decoded(&[(4.0, 18.0), (61.25, 103.5), (-30.0, 0.0)]).unwrap();
    assert_eq!(decoded[1], [18.0, 61.25, -30.0]);
}

#[test]
fn words_and_aliases_of_fractions_hold_at_every_point() {
    for (basic, more, resolution) in [
        (vec!["a", "b", "c"], vec!["d = a*b*c"], 4),
        (vec!["a", "b", "c"], vec!["d = a*b", "e = -a*c"], 3),
        (vec!["a", "b", "c", "d"], vec!["e = a*b*c*d"], 5),
        (vec!["a", "b", "c"], vec!["d = a*b", "e = a*c", "f = b*c", "g = a*b*c"], 3),
    ] {
        let fraction = fractional_factorial(&basic, &generators(&more)).unwrap();
        assert_eq!(fraction.resolution(), Some(resolution));
        assert_eq!(fraction.words.len(), (1 << more.len()) - 1);
        for (word, opposite) in &fraction.words {
            let sign = if *opposite { -1.0 } else { 1.0 };
            assert!(fraction.design.column(word).unwrap().iter().all(|value| *value == sign), "{word}");
        }
        for term in terms(&["a", "a*b"]) {
            for (alias, opposite) in fraction.aliases(&term) {
                let sign = if opposite { -1.0 } else { 1.0 };
                let (one, other) =
                    (fraction.design.column(&term).unwrap(), fraction.design.column(&alias).unwrap());
                assert!(one.iter().zip(other).all(|(one, other)| *one == sign * other), "{term} {alias}");
            }
        }
    }
}

#[test]
fn a_rotatable_composite_design_is_as_sure_in_all_directions() {
    let design = central_composite(&["a", "b", "c"], Axial::Rotatable, 6).unwrap();
    assert_eq!(design.points().len(), 8 + 6 + 6);
    let y = (0..20_u32).map(|i| f64::from(i * i % 7)).collect();
    let data = design.data().and_then(|data| data.response("y", y)).unwrap();
    let second = Term::up_to_order(&["a", "b", "c"], 2);
    let fitted = Regression::fit(&data, "y", &second, Blocking::Ignored).unwrap();
    let leverage = |p: [f64; 3]| fitted.predict(&[("a", p[0]), ("b", p[1]), ("c", p[2])]).unwrap().leverage;
    let along = leverage([1.2, 0.0, 0.0]);
    for direction in [[0.0, 1.2, 0.0], [0.72, 0.0, -0.96], [0.8, 0.8, 0.4]] {
        assert!((leverage(direction) - along).abs() < 1e-12, "{direction:?}");
    }
    let faces = central_composite(&["a", "b"], Axial::Face, 1).unwrap();
    assert_eq!(faces.points().len(), 9);
    assert!(faces.points().iter().flatten().all(|value| [-1.0, 0.0, 1.0].contains(value)));
}

#[test]
fn d_optimal_designs_with_known_answers_are_found() {
    // two factors with interaction in four points: the corners, orthogonal
    let levels: Vec<f64> = (0..=10_i32).map(|k| f64::from(k - 5) / 5.0).collect();
    let grid = levels.iter().flat_map(|a| levels.iter().map(|b| vec![*a, *b])).collect();
    let candidates = Design::new(&["a", "b"], grid).unwrap();
    let found = d_optimal(&candidates, &terms(&["1", "a", "b", "a*b"]), 4).unwrap();
    assert!((found.efficiency - 1.0).abs() < 1e-12);
    assert!(found.design.points().iter().flatten().all(|value| value.abs() == 1.0));
    // a polynomial of order k on [-1, 1] in k + 1 points: the ends and the zeros of the derivative of the Legendre polynomial
    // of order k (Fedorov); for k = 3 these are +-1/sqrt(5) = 0.4472, here the nearest on a grid of 0.01
    let fine: Vec<Vec<f64>> = (-100..=100_i32).map(|k| vec![f64::from(k) / 100.0]).collect();
    let candidates = Design::new(&["x"], fine).unwrap();
    let points = |texts: &[&str], count| -> Vec<f64> {
        let found = d_optimal(&candidates, &terms(texts), count).unwrap();
        found.design.points().iter().map(|point| point[0]).collect()
    };
    assert_eq!(points(&["1", "x", "x^2", "x^3"], 4), [-1.0, -0.45, 0.45, 1.0]);
    assert_eq!(points(&["1", "x", "x^2"], 6), [-1.0, -1.0, 0.0, 0.0, 1.0, 1.0]);
}

#[test]
fn the_power_of_t_tests_is_that_of_scipy() {
    // SciPy 1.17: nct.sf(t, nu, d) + nct.cdf(-t, nu, d) with t = t.ppf(0.5 + level / 2, nu)
    for (freedom, delta, level, want) in [
        (5.0, 2.0, 0.95, 0.368_157_514_138_397_1),
        (21.0, 3.3, 0.95, 0.882_153_592_337_907),
        (1.0, 6.0, 0.9, 0.652_067_334_818_726_3),
        (300.0, 3.0, 0.99, 0.658_207_298_835_547),
    ] {
        let got = power(delta, freedom, level).unwrap();
        assert!((got - want).abs() < 1e-9, "{freedom} {delta}: {got}, expected {want}");
        assert!((detectable_noncentrality(freedom, level, want).unwrap() - delta).abs() < 1e-7);
    }
    // no effect: false alarms
    assert!((power(0.0, 12.0, 0.95).unwrap() - 0.05).abs() < 1e-9);
}

#[test]
fn the_smallest_effect_shrinks_with_the_root_of_the_points() {
    // 2^2 in eight blocks: coefficients have a standard error of sigma / sqrt(32) and 21 degrees of freedom (claim M16)
    let design = full_factorial(&["q", "delta"]).unwrap().replicated(8);
    let labels: Vec<String> = (0..32).map(|point| format!("{}", point / 4)).collect();
    let blocks = Blocks::from_labels("alpha", labels.iter().map(String::as_str));
    let model = terms(&["1", "q", "delta", "q*delta"]);
    let effects = smallest_effects(&design, &model, &[blocks], 0.01, (0.95, 0.9)).unwrap();
    let delta = detectable_noncentrality(21.0, 0.95, 0.9).unwrap();
    for (term, smallest) in effects {
        assert!((smallest - delta * 0.01 / 32.0_f64.sqrt()).abs() < 1e-12, "{term}");
    }
}
