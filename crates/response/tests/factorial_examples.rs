//! Effects of worked two-level experiments come out to the printed digits (data/factorials/README.md has the sources).

use std::path::Path;

use nastran::Table;
use response::design::{Generator, fractional_factorial};
use response::{Blocking, Data, Effect, Effects, Regression, Term, effects, half_normal_plot};

fn table(name: &str) -> Table {
    Table::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/factorials").join(name))
        .expect("a table")
}

fn data(name: &str, factors: &[&str], response: &str, blocks: &[&str]) -> Data {
    Data::from_table(&table(name), factors, &[response], blocks).expect("data")
}

fn of<'a>(all: &'a Effects, term: &str) -> &'a Effect {
    let term: Term = term.parse().expect("a term");
    all.effects.iter().find(|effect| effect.term == term).expect("an effect")
}

/// Half a unit of the last printed digit, and a hair.
fn printed(got: f64, want: f64, decimals: i32, what: &str) {
    let unit = 10.0_f64.powi(-decimals);
    assert!((got - want).abs() <= 0.500_000_1 * unit, "{what}: {got}, printed {want}");
}

/// The same for significant digits.
fn digits(got: f64, want: f64, digits: i32, what: &str) {
    let exponent = want.abs().log10().floor();
    printed(got / 10.0_f64.powf(exponent), want / 10.0_f64.powf(exponent), digits - 1, what);
}

#[test]
fn nist_ceramics_two_to_the_five() {
    let factors = ["speed", "rate", "grit", "direction", "batch"];
    let data = data("ceramics.csv", &factors, "strength", &[]);
    let all = effects(&data, "strength", &factors, 3, (Blocking::Ignored, 0.95)).expect("effects");
    let anova = table("ceramics_anova.csv");
    assert_eq!((all.effects.len(), anova.len()), (25, 25));
    printed(all.mean, 546.8959, 4, "mean");
    printed((all.residual_sum / all.degrees_of_freedom).sqrt(), 17.81632, 5, "root mean square error");
    assert_eq!(all.degrees_of_freedom, 6.0);
    for row in 0..anova.len() {
        let name = anova.text(row, "term").expect("a term");
        let effect = of(&all, name);
        let test = effect.test.expect("6 degrees of freedom");
        printed(effect.sum_of_squares, anova.number(row, "sum_of_squares").unwrap(), 0, name);
        printed(test.t * test.t, anova.number(row, "f").unwrap(), 3, name);
        let p = anova.number(row, "p").unwrap();
        if p < 1e-4 {
            digits(test.p_value, p, 3, name);
        } else {
            printed(test.p_value, p, 6, name);
        }
        assert_eq!(test.significant, p < 0.05, "{name}");
    }
}

#[test]
fn nist_ceramics_with_twelve_terms() {
    let factors = ["speed", "rate", "grit", "direction", "batch"];
    let data = data("ceramics.csv", &factors, "strength", &[]);
    let texts = [
        "1",
        "speed",
        "rate",
        "grit",
        "direction",
        "batch",
        "speed*rate",
        "speed*grit",
        "speed*direction",
        "rate*direction",
        "grit*direction",
        "direction*batch",
        "speed*rate*direction",
    ];
    let terms: Vec<Term> = texts.iter().map(|text| text.parse().expect("a term")).collect();
    let fitted = Regression::fit(&data, "strength", &terms, Blocking::Ignored).expect("a fit");
    printed(1.0 - fitted.residual_sum / fitted.total_sum, 0.989_114, 6, "R2");
    printed(fitted.error_variance.sqrt(), 14.96346, 5, "root mean square error");
    // printed F values of three terms and their p
    for (term, f, p) in
        [("speed", 3.994, 0.060_170), ("speed*grit", 8.212, 0.009_896), ("direction*batch", 5.935, 0.024_859)]
    {
        let coefficient = fitted.coefficient(&term.parse().unwrap()).expect("a coefficient");
        printed(coefficient.t.powi(2), f, 3, term);
        printed(coefficient.p_value, p, 6, term);
        let family = fitted.family_test(&[term.parse().unwrap()]).expect("a test");
        printed(family.f, f, 3, term);
        printed(family.p_value, p, 6, term);
    }
}

#[test]
fn montgomery_tool_life_two_to_the_three_thrice() {
    let factors = ["A", "B", "C"];
    let data = data("tool_life.csv", &factors, "life", &["replicate"]);
    let all = effects(&data, "life", &factors, 3, (Blocking::Ignored, 0.95)).expect("effects");
    // problem 6.1: the equation in coded units, coefficients half the effects
    printed(all.mean, 40.83333, 5, "mean");
    for (term, half) in [("A", 0.16667), ("B", 5.66667), ("C", 3.41667), ("A*C", -4.41667)] {
        printed(0.5 * of(&all, term).value, half, 5, term);
    }
    // problem 7.1: each replicate a block
    let blocked = effects(&data, "life", &factors, 3, (Blocking::Fixed, 0.95)).expect("effects");
    assert_eq!(blocked.degrees_of_freedom, 14.0);
    printed(blocked.residual_sum, 482.08, 2, "error");
    printed(all.residual_sum - blocked.residual_sum, 0.58, 2, "blocks");
    let sums = [
        ("A", 0.67),
        ("B", 770.67),
        ("C", 280.17),
        ("A*B", 16.67),
        ("A*C", 468.17),
        ("B*C", 48.17),
        ("A*B*C", 28.17),
    ];
    for (term, sum) in sums {
        printed(of(&blocked, term).sum_of_squares, sum, 2, term);
        // the source stars B, C and AC
        let significant = of(&blocked, term).test.expect("14 degrees of freedom").significant;
        assert_eq!(significant, ["B", "C", "A*C"].contains(&term), "{term}");
    }
    for (term, f) in [("B", 22.38), ("C", 8.14), ("A*C", 13.60), ("B*C", 1.40)] {
        let t = of(&blocked, term).test.expect("14 degrees of freedom").t;
        printed(t * t, f, 2, term);
    }
}

#[test]
fn montgomery_half_fraction_with_lenths_margins() {
    let fraction = fractional_factorial(&["A", "B", "C"], &[Generator::parse("D = A*B*C").unwrap()]).unwrap();
    let factors = ["A", "B", "C", "D"];
    let data = data("half_fraction.csv", &factors, "yield_percent", &[]);
    for name in factors {
        let planned = fraction.design.column(&name.parse().unwrap()).unwrap();
        assert_eq!(data.factor_values(name).unwrap(), planned, "{name}");
    }
    assert_eq!(fraction.resolution(), Some(4));
    let all = effects(&data, "yield_percent", &factors, 4, (Blocking::Ignored, 0.95)).expect("effects");
    let published =
        [("A", -12.0), ("B", -1.0), ("C", 4.0), ("D", -1.0), ("A*B", 6.0), ("A*C", -1.0), ("A*D", -5.0)];
    assert_eq!(all.effects.len(), 7);
    for (term, value) in published {
        printed(of(&all, term).value, value, 6, term);
        // 8 runs: sum of squares 2 e^2; the source prints 288, 2, 32, 2, 72, 2, 50
        printed(of(&all, term).sum_of_squares, 2.0 * value * value, 6, term);
        assert!(of(&all, term).test.is_none(), "nothing is repeated");
    }
    // as the source says: BC, BD, CD and all of three factors are aliased
    let aliases: Vec<String> = of(&all, "A*B").aliases.iter().map(|(term, _)| term.to_string()).collect();
    assert_eq!(aliases, ["C*D"]);
    let lenth = all.lenth.expect("seven effects");
    assert_eq!(lenth.pseudo_standard_error, 6.0);
    // SciPy 1.17: 6 t(0.975, 7/3) and 6 t((1 + 0.95^(1/7)) / 2, 7/3)
    printed(lenth.margin, 22.584_738_432_495_5, 10, "ME");
    printed(lenth.simultaneous_margin, 54.049_842_683_669_9, 10, "SME");
    // the source prints 22.5856 and 54.0516: 4e-5 above, as its t at 7/3 degrees of freedom is an approximation
    assert!((lenth.margin / 22.5856 - 1.0).abs() < 5e-5);
    assert!((lenth.simultaneous_margin / 54.0516 - 1.0).abs() < 5e-5);
}

#[test]
fn box_hunter_hunter_pilot_plant() {
    let factors = ["t", "c", "k"];
    let data = data("pilot_plant.csv", &factors, "yield_percent", &[]);
    let all = effects(&data, "yield_percent", &factors, 3, (Blocking::Ignored, 0.95)).expect("effects");
    let published =
        [("t", 23.0), ("c", -5.0), ("k", 1.5), ("t*c", 1.5), ("t*k", 10.0), ("c*k", 0.0), ("t*c*k", 0.5)];
    for (term, value) in published {
        printed(of(&all, term).value, value, 6, term);
    }
    // the outermost points of the half-normal plot
    let values: Vec<f64> = all.effects.iter().map(|effect| effect.value).collect();
    let plot = half_normal_plot(&values);
    let names: Vec<String> = plot.iter().rev().map(|p| all.effects[p.index].term.to_string()).collect();
    assert_eq!(names[..3], ["t", "t*k", "c"]);
}

#[test]
fn tensile_strength_two_to_the_two_thrice() {
    let data = data("tensile.csv", &["A", "B"], "strength", &["replicate"]);
    let all = effects(&data, "strength", &["A", "B"], 2, (Blocking::Ignored, 0.95)).expect("effects");
    printed(all.mean, 63.25, 2, "mean");
    // R prints coefficients and their errors: half of the effects
    for (term, half, t, p, digits_of_p) in
        [("A", 9.58, 7.29, 8.4e-5, 2), ("B", -5.75, -4.38, 0.0024, 2), ("A*B", 1.92, 1.46, 0.1828, 4)]
    {
        let effect = of(&all, term);
        let test = effect.test.expect("8 degrees of freedom");
        printed(0.5 * effect.value, half, 2, term);
        printed(0.5 * test.standard_error, 1.31, 2, term);
        printed(test.t, t, 2, term);
        digits(test.p_value, p, digits_of_p, term);
    }
    let residual: f64 = all.residual_sum;
    printed((residual / all.degrees_of_freedom).sqrt(), 4.55, 2, "residual standard error");
}
