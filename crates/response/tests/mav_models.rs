//! The published models: the files are read whole, an equation is a sum of its terms, and it refuses what the paper does
//! not support by name.

use std::path::{Path, PathBuf};

use nastran::Table;
use response::mav::figures::{FIGURES, figure};
use response::mav::{Condition, Confidence, Factor, NoValue, Published, Rules, Status, TestPoint};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/mav/published")
}

fn published() -> Published {
    Published::read(&folder()).expect("the shipped coefficients")
}

fn missing(names: &[&str], equation: u8) -> NoValue {
    NoValue::Missing { equation, names: names.iter().map(ToString::to_string).collect() }
}

#[test]
fn every_equation_is_there_and_no_other() {
    let published = published();
    let mut numbers: Vec<u8> = published.models().iter().map(|model| model.equation).collect();
    numbers.sort_unstable();
    assert_eq!(numbers, [4, 5, 6, 7, 8, 8, 9, 9, 10, 10, 11, 12, 13, 14, 15, 16]);
    for wing in ["BR", "PR"] {
        assert_eq!(published.equation(9, wing).expect("both wings").wing, wing);
    }
    assert!(published.equation(8, "R").expect_err("no such wing").to_string().contains("`BR` and `PR`"));
    assert!(published.equation(17, "").expect_err("no such equation").to_string().contains("17"));
}

#[test]
fn an_equation_is_the_sum_of_its_terms() {
    // Eq. 13 of paper 2 by hand at q 50 Pa, alpha 8 deg, delta -10 deg, n 18 krpm, with the table's coefficients
    let by_hand = 0.88137 + 2.0199e-4 * 50.0 - 5.5996e-3 * 8.0 + 8.1962e-4 * 64.0
        - 0.088_852 * 18.0
        - 4.6516e-5 * 400.0
        + 1.2739e-3 * -10.0
        + 2.5972e-3 * 324.0
        - 0.042_488 * 324.0 / 50.0
        + 1.9689e-5 * 100.0;
    let state = Condition { n_krpm: Some(18.0), ..Condition::unpowered(50.0, 8.0, -10.0) };
    let model = published().equation(13, "").expect("Eq. 13").clone();
    assert!((model.value(&state, Rules::STRICT).expect("within its range") - by_hand).abs() < 1e-13);
}

#[test]
fn the_propeller_speed_is_put_in_where_only_a_voltage_is_given() {
    let published = published();
    let model = published.equation(12, "").expect("Eq. 12");
    let state = Condition::unpowered(60.0, 10.0, 5.0).at_voltage(7.0);
    let n_krpm = published.propeller_speed_krpm(&state, Rules::STRICT).expect("within the range");
    let given = Condition { n_krpm: Some(n_krpm), ..state };
    let value = |state: &Condition| published.value(model, state, Rules::STRICT).expect("a value");
    assert_eq!(value(&state), value(&given));
    // a speed that is given is taken
    assert!((value(&Condition { n_krpm: Some(n_krpm + 0.5), ..state }) - value(&state)).abs() > 1e-4);
    let neither = Condition::unpowered(60.0, 10.0, 5.0);
    let error = published.value(model, &neither, Rules::STRICT).expect_err("no speed");
    assert_eq!(error, NoValue::Lacking { equation: 12, factor: Factor::PropellerSpeed });
}

#[test]
fn outside_its_range_an_equation_is_evaluated_only_if_asked() {
    let published = published();
    let outside = |equation: u8, wing: &str, state: Condition, factor: Factor| {
        let model = published.equation(equation, wing).expect("an equation");
        let error = published.value(model, &state, Rules::STRICT).expect_err("outside");
        let NoValue::Outside { factor: named, .. } = error else { panic!("{error}") };
        assert_eq!(named, factor, "{error}");
        let text = error.to_string();
        assert!(text.contains(&format!("Eq. {equation}")) && text.contains(factor.symbol()), "{text}");
        assert!(published.value(model, &state, Rules::STRICT.extrapolating()).is_ok());
    };
    outside(5, "PR", Condition::unpowered(60.0, 20.0, 0.0), Factor::Alpha);
    outside(5, "PR", Condition::unpowered(60.0, 10.0, -1.0), Factor::Elevator);
    outside(7, "PR", Condition::unpowered(20.0, 10.0, 0.0), Factor::DynamicPressure);
    outside(11, "", Condition::unpowered(60.0, 10.0, 0.0).at_voltage(8.0), Factor::Voltage);
    outside(4, "R", Condition::unpowered(60.0, 10.0, 0.0).at_voltage(0.0), Factor::Voltage);
    let fast = Condition { n_krpm: Some(25.0), ..Condition::unpowered(60.0, 10.0, 0.0) };
    outside(12, "", fast, Factor::PropellerSpeed);
    outside(15, "", Condition { n_krpm: Some(18.0), ..Condition::unpowered(60.0, 17.0, 0.0) }, Factor::Alpha);
    outside(5, "PR", Condition::unpowered(f64::NAN, 10.0, 0.0), Factor::DynamicPressure);
}

#[test]
fn coefficients_that_are_not_published_are_named() {
    let published = published();
    let state = Condition { n_krpm: Some(18.0), ..Condition::unpowered(80.0, 10.0, 0.0) };
    let error = |equation: u8, wing: &str| {
        let model = published.equation(equation, wing).expect("an equation");
        assert!(model.value(&state, Rules::STRICT.leaving_out_missing()).is_ok());
        model.value(&state, Rules::STRICT).expect_err("not complete")
    };
    assert_eq!(error(8, "BR"), missing(&["a10 (delta^3)"], 8));
    assert_eq!(error(14, ""), missing(&["a7 (n*delta)", "a8 (alpha^4)"], 14));
    let drag = error(9, "PR").to_string();
    for name in ["a5 (delta^2)", "a6 (q*alpha)", "a7 (q*delta)", "a8 (alpha*delta)", "a9 (q*alpha^2)"] {
        assert!(drag.contains(name), "{drag}");
    }
}

#[test]
fn values_are_missing_exactly_where_the_status_says_so_and_doubts_have_a_reason() {
    for model in published().models() {
        for coefficient in &model.coefficients {
            let place = format!("Eq. {} {}", model.equation, coefficient.name);
            assert_eq!(coefficient.value.is_none(), coefficient.status == Status::Missing, "{place}");
            let sure = coefficient.status == Status::Printed && coefficient.confidence == Confidence::High;
            assert!(sure || !coefficient.note.is_empty(), "{place}");
        }
    }
}

#[test]
fn every_factor_of_an_equation_has_a_range() {
    for model in published().models() {
        for coefficient in &model.coefficients {
            for factor in Factor::of_term(&coefficient.term) {
                assert!(model.range(factor).is_some(), "Eq. {} {}", model.equation, factor.symbol());
            }
        }
    }
}

#[test]
fn the_range_of_the_propeller_speed_is_what_equation_4_gives() {
    let published = published();
    for (equation, alphas) in [(12, (40, 180)), (15, (180, 360))] {
        let range = published.equation(equation, "").expect("an equation").range(Factor::PropellerSpeed);
        let range = range.expect("a range");
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for v_m_s in [8.0, 10.0, 11.5, 13.0] {
            for alpha in alphas.0..=alphas.1 {
                for voltage in [6.6, 7.0, 7.4] {
                    let state = Condition::unpowered(0.6125 * v_m_s * v_m_s, f64::from(alpha) / 10.0, 0.0);
                    let n = published.propeller_speed_krpm(&state.at_voltage(voltage), Rules::STRICT);
                    let n = n.expect("within the range");
                    (low, high) = (low.min(n), high.max(n));
                }
            }
        }
        // rounded outward to a tenth
        assert!(range.low <= low && low < range.low + 0.1, "Eq. {equation}: {low}");
        assert!(range.high >= high && high > range.high - 0.1, "Eq. {equation}: {high}");
    }
}

#[test]
fn wrong_files_are_refused_at_their_cell() {
    let header = "equation,wing,response,coefficient,term,value,unit,confidence,status,printed_term,note\n";
    let ranges = Table::parse("ranges.csv", "equation,factor,low,high\n5,q,39,104\n").expect("a table");
    let error = |row: &str| {
        let table = Table::parse("coefficients.csv", &format!("{header}{row}\n")).expect("a table");
        Published::from_tables(&table, &ranges).expect_err("a wrong row").to_string()
    };
    for (row, word) in [
        ("3,PR,CL,a0,1,0.2,1,high,printed,1,", "`3`"),
        ("5,PR,CL,a0,x*q,0.2,1,high,printed,1,", "`x`"),
        ("5,PR,CL,a0,1,,1,high,printed,1,", "empty"),
        ("5,PR,CL,a0,1,0.2,1,high,missing,1,", "`missing`"),
        ("5,PR,CL,a0,1,0.2,1,sure,printed,1,", "`sure`"),
        ("5,PR,CL,a0,1,0.2,1,high,copied,1,", "`copied`"),
        ("6,PR,CD,a0,1,0.2,1,high,printed,1,", "no range of Eq. 6"),
        ("5,PR,CL,a0,1,0.2,1,high,printed,1,\n5,PR,CD,a1,q,0.2,1,high,printed,q,", "of CL above"),
    ] {
        let text = error(row);
        assert!(text.contains(word) && (text.contains(".csv:2") || text.contains(".csv:3")), "{text}");
    }
    let turned = Table::parse("ranges.csv", "equation,factor,low,high\n5,q,104,39\n").expect("a table");
    let table = Table::parse("c.csv", header).expect("a table");
    assert!(Published::from_tables(&table, &turned).is_err());
    assert!(Published::read(Path::new("nowhere")).is_err());
}

#[test]
fn figures_have_finite_curves_and_say_what_they_assume() {
    let published = published();
    for number in FIGURES {
        let figure = figure(&published, number).expect("a figure");
        assert!(figure.title.contains(&format!("Fig. {number}")) && !figure.notes.is_empty());
        for panel in &figure.panels {
            assert!(panel.x_label.ends_with("[deg]") && panel.curves.len() >= 2, "{panel:?}");
            for curve in &panel.curves {
                assert_eq!(curve.x.len(), curve.y.len());
                assert!(curve.y.iter().all(|y| y.is_finite()));
            }
        }
    }
    let notes = figure(&published, 9).expect("Fig. 9").notes.join("; ");
    assert!(notes.contains("a10 (delta^3)") && notes.contains("exponent"), "{notes}");
    assert!(figure(&published, 8).is_err());
}

#[test]
fn all_test_points_are_within_the_equations_ranges() {
    let published = published();
    for series in response::mav::Series::ALL {
        let (equations, wing) = series.equations();
        for &equation in equations {
            let model = published.equation(equation, wing).expect("an equation");
            for TestPoint { condition, .. } in series.points() {
                let rules = Rules::STRICT.leaving_out_missing();
                published.value(model, &condition, rules).expect("within the range");
            }
        }
    }
}
