//! Claims of "Wind-Tunnel Testing and Modeling of a Micro Air Vehicle with Flexible Wings" that its published models
//! can be asked about: M1 to M5, M9, M11, M14, M17 to M22, M24 to M29, M31 to M33. The expected numbers are the paper's, or
//! computed by hand from its coefficients.

use response::mav::{
    AIRSPEEDS_M_S, BALANCE_RESOLUTION_N, Condition, Confidence, Model, Published, ROOT_CHORD_M, Rules,
    SPAN_M, Series, Status, VOLTAGES_V, WING_AREA_M2, dynamic_pressure_pa,
};
use std::sync::OnceLock;
use validation::data;

fn published() -> &'static Published {
    static PUBLISHED: OnceLock<Published> = OnceLock::new();
    PUBLISHED.get_or_init(|| Published::read(&data("mav/published")).expect("the shipped coefficients"))
}

fn equation(number: u8, wing: &str) -> &'static Model {
    published().equation(number, wing).expect("an equation of the paper")
}

/// Its value, without the terms that the paper gives no coefficient of.
fn value(model: &Model, state: Condition) -> f64 {
    published().value(model, &state, Rules::STRICT.leaving_out_missing()).expect("within the range")
}

fn at(q_pa: f64, alpha_deg: f64, delta_deg: f64) -> Condition {
    Condition::unpowered(q_pa, alpha_deg, delta_deg)
}

/// Effects over eight angles of attack, mean at the high level less mean at the low one: dynamic pressure, elevator,
/// both; `ends` of the elevator.
fn effects(model: &Model, ends: [f64; 2]) -> [f64; 3] {
    let mean = |v_m_s: f64, delta: f64| {
        let alphas = (4..=18).step_by(2);
        alphas.map(|alpha| value(model, at(dynamic_pressure_pa(v_m_s), f64::from(alpha), delta))).sum::<f64>()
            / 8.0
    };
    let [ll, lh, hl, hh] =
        [(10.0, ends[0]), (10.0, ends[1]), (13.0, ends[0]), (13.0, ends[1])].map(|(v, d)| mean(v, d));
    [0.5 * (hl + hh - ll - lh), 0.5 * (lh + hh - ll - hl), 0.5 * (ll + hh - lh - hl)]
}

#[test]
fn m01_m03_area_span_aspect_ratio_and_propeller() {
    assert!((SPAN_M * SPAN_M / WING_AREA_M2 - 1.26).abs() < 0.005);
    assert!((SPAN_M / 0.080 - 1.88).abs() < 0.006);
    assert_eq!(ROOT_CHORD_M, 0.130);
}

#[test]
fn m02_models_carry_their_wing() {
    let wings = |number: u8| -> Vec<&str> {
        let models = published().models().iter().filter(|model| model.equation == number);
        models.map(|model| model.wing.as_str()).collect()
    };
    assert_eq!((wings(4), wings(5)), (vec!["R"], vec!["PR"]));
    assert_eq!(wings(10), ["BR", "PR"]);
}

#[test]
fn m04_a_step_of_the_balance_is_a_lift_coefficient_of_0_043_at_8_m_s() {
    let step = BALANCE_RESOLUTION_N / (dynamic_pressure_pa(8.0) * WING_AREA_M2);
    assert!((step - 0.043).abs() < 5e-4, "{step}");
    // chord and airspeed range give the published Reynolds numbers, 50 000 to 150 000
    for (v_m_s, reynolds) in [(8.0, 5e4..1.5e5), (13.0, 5e4..1.5e5)] {
        assert!(reynolds.contains(&(v_m_s * ROOT_CHORD_M / 1.46e-5)));
    }
}

#[test]
fn m05_levels_are_the_papers_and_no_test_point_is_outside() {
    assert_eq!(AIRSPEEDS_M_S, [8.0, 10.0, 11.5, 13.0]);
    assert_eq!(VOLTAGES_V, [6.6, 7.0, 7.4]);
    let q = AIRSPEEDS_M_S.map(dynamic_pressure_pa);
    assert!((q[0] - 39.0).abs() < 0.5 && (q[3] - 104.0).abs() < 0.5);
    for series in Series::ALL {
        for point in series.points() {
            assert!((-30.0..=30.0).contains(&point.condition.delta_deg));
            let limits = if series == Series::PropellerSpeed { 4.0..=38.0 } else { 4.0..=36.0 };
            assert!(limits.contains(&point.condition.alpha_deg));
            assert!(point.condition.voltage_v.is_none_or(|voltage| VOLTAGES_V.contains(&voltage)));
        }
    }
}

#[test]
fn m09_m11_propeller_speed_has_nine_terms_and_is_18_43_krpm() {
    let model = equation(4, "R");
    assert_eq!((model.coefficients.len(), model.missing().count()), (9, 0));
    let speed = value(model, at(dynamic_pressure_pa(8.0), 4.0, 0.0).at_voltage(7.4));
    assert!((speed - 18.43).abs() < 0.005, "{speed}");
    // measured with the larger propeller: 18 300 rpm
    assert!((speed / 18.3 - 1.007).abs() < 5e-4);
}

#[test]
fn m14_term_counts_and_values_at_10_degrees_and_60_pa() {
    for (number, terms, expected) in [(5, 12, 0.463), (6, 15, 0.068), (7, 8, -0.114)] {
        let model = equation(number, "PR");
        assert_eq!((model.coefficients.len(), model.missing().count()), (terms, 0), "Eq. {number}");
        let found = value(model, at(60.0, 10.0, 0.0));
        assert!((found - expected).abs() < 5.1e-4, "Eq. {number}: {found}");
    }
}

#[test]
fn m17_m18_pressure_elevator_and_both_by_equations_8_and_10() {
    // Table 3 has all three effects for the moment, as Eq. 10 of paper 1 does
    for wing in ["BR", "PR"] {
        assert!(effects(equation(10, wing), [-30.0, 0.0]).iter().all(|effect| effect.abs() > 0.05), "{wing}");
    }
    // and for lift the elevator and both but not the pressure alone: by Eq. 8 of paper 1 that is the larger of the two, so no
    // test can find the one and not the other in runs that follow it
    let [pressure, elevator, both] = effects(equation(8, "BR"), [-30.0, 0.0]);
    assert!(elevator.abs() > 5.0 * both.abs());
    assert!(pressure.abs() > 1.5 * both.abs(), "{pressure} {both}");
}

#[test]
fn m19_lift_and_moment_follow_the_elevator_more_than_the_pressure() {
    for (number, wing, ends) in [(5, "PR", [0.0, 30.0]), (7, "PR", [0.0, 30.0]), (8, "BR", [-30.0, 0.0])] {
        let [pressure, elevator, _] = effects(equation(number, wing), ends);
        assert!(elevator.abs() > 3.0 * pressure.abs(), "Eq. {number}: {pressure} {elevator}");
    }
    for wing in ["BR", "PR"] {
        let [pressure, elevator, _] = effects(equation(10, wing), [-30.0, 0.0]);
        assert!(elevator.abs() > 3.0 * pressure.abs(), "Eq. 10 {wing}: {pressure} {elevator}");
    }
}

#[test]
fn m19_drag_by_equation_6_follows_the_elevator_more_against_the_text() {
    // the text says that drag follows dynamic pressure more: not by its own model for positive elevator
    let [pressure, elevator, _] = effects(equation(6, "PR"), [0.0, 30.0]);
    assert!(elevator.abs() > 5.0 * pressure.abs(), "{pressure} {elevator}");
}

#[test]
fn m20_lift_falls_and_moment_rises_with_negative_elevator_faster_at_higher_pressure() {
    let change = |number: u8, v_m_s: f64| {
        let model = equation(number, "BR");
        let q_pa = dynamic_pressure_pa(v_m_s);
        value(model, at(q_pa, 10.0, -30.0)) - value(model, at(q_pa, 10.0, 0.0))
    };
    assert!(change(8, 13.0) < change(8, 10.0) && change(8, 10.0) < 0.0);
    assert!(change(10, 13.0) > change(10, 10.0) && change(10, 10.0) > 0.0);
}

#[test]
fn m21_term_counts_of_the_models_over_all_elevator_angles() {
    for wing in ["BR", "PR"] {
        for (number, terms) in [(8, 11), (9, 11), (10, 9)] {
            assert_eq!(equation(number, wing).coefficients.len(), terms, "Eq. {number} {wing}");
        }
        // printed twice with delta; the table's a2 is that of alpha in Eq. 13 of paper 1 within 1 %
        let a2 = &equation(9, wing).coefficients[2];
        assert_eq!((a2.term.to_string(), a2.status == Status::Printed), ("alpha".to_string(), false));
        let of_13 = equation(13, "").coefficient("alpha").and_then(|c| c.value).expect("a value");
        assert!((a2.value.expect("a value") / of_13 - 1.0).abs() < 0.01);
    }
}

#[test]
fn m22_the_moment_of_the_pr_wing_is_coupled_more_to_the_pressure() {
    let a = |wing: &str, term: &str| {
        equation(10, wing).coefficient(term).and_then(|coefficient| coefficient.value).expect("a value")
    };
    for term in ["q", "q^2", "q*delta"] {
        assert!(a("PR", term).abs() > 1.25 * a("BR", term).abs(), "{term}");
    }
    assert!(a("PR", "alpha^2").abs() > 5.0 * a("BR", "alpha^2").abs());
    // elevator alone: much alike
    assert!((a("PR", "delta^2") / a("BR", "delta^2") - 1.0).abs() < 0.06);
}

#[test]
fn m24_powered_lift_is_of_second_order_in_alpha_and_voltage() {
    let model = equation(11, "");
    assert_eq!(model.coefficients.len(), 9);
    assert!(model.coefficient("alpha^2").is_some() && model.coefficient("E^2").is_some());
    // the printed term in delta alone has no coefficient
    assert!(model.coefficient("delta").is_none());
}

#[test]
fn m25_voltage_changes_the_elevators_authority_and_not_the_lift_without_it() {
    let model = equation(11, "");
    let lift = |delta: f64, voltage: f64| value(model, at(60.0, 10.0, delta).at_voltage(voltage));
    assert!((lift(0.0, 6.6) - 0.467).abs() < 5e-4 && (lift(0.0, 7.4) - 0.475).abs() < 5e-4);
    let authority = |voltage: f64| (lift(30.0, voltage) - lift(0.0, voltage)) / 30.0;
    assert!((authority(6.6) - 0.0060).abs() < 5e-5, "{}", authority(6.6));
    assert!((authority(7.4) - 0.0070).abs() < 5e-5, "{}", authority(7.4));
}

#[test]
fn m26_the_propeller_speed_of_equation_4_goes_into_equations_12_to_16() {
    for number in 12..=16 {
        let model = equation(number, "");
        let alpha = if number < 15 { 10.0 } else { 25.0 };
        let state = at(60.0, alpha, 5.0);
        let n_krpm = value(equation(4, "R"), state.at_voltage(7.0));
        let given = value(model, Condition { n_krpm: Some(n_krpm), ..state });
        assert_eq!(value(model, state.at_voltage(7.0)), given, "Eq. {number}");
    }
}

#[test]
fn m27_coefficients_with_a_value_in_equations_12_to_14() {
    for (number, values) in [(12, 9), (13, 10), (14, 7)] {
        let model = equation(number, "");
        assert_eq!(model.coefficients.len() - model.missing().count(), values, "Eq. {number}");
    }
    let names: Vec<String> = equation(14, "").missing().map(|missing| missing.term.to_string()).collect();
    assert_eq!(names, ["n*delta", "alpha^4"]);
}

#[test]
fn m28_voltage_hardly_moves_lift_but_drag_and_moment() {
    // 6, 7 and 8 V as drawn, though Eq. 4 of paper 1 was fitted between 6.6 and 7.4
    let rules = Rules::STRICT.extrapolating().leaving_out_missing();
    let spread = |number: u8| {
        let of = |voltage: f64| {
            published().value(equation(number, ""), &at(60.0, 10.0, 0.0).at_voltage(voltage), rules)
        };
        (of(6.0).expect("a value") - of(8.0).expect("a value")).abs()
    };
    assert!(spread(12) < 0.02 * 0.47 && spread(13) > 0.05 && spread(14) > 0.05);
    let curved = |number: u8| {
        let n_krpm = Some(18.0);
        let of = |alpha: f64| value(equation(number, ""), Condition { n_krpm, ..at(60.0, alpha, 0.0) });
        (of(4.0) - 2.0 * of(11.0) + of(18.0)).abs() / (of(18.0) - of(4.0)).abs()
    };
    assert!(curved(12) < 1e-12 && curved(14) < 1e-12 && curved(13) > 0.3);
}

#[test]
fn m29_the_models_of_high_angles_hold_above_22_degrees_only() {
    let lift = |number: u8, alpha: f64| {
        value(equation(number, ""), Condition { n_krpm: Some(18.0), ..at(60.0, alpha, 0.0) })
    };
    assert_eq!((equation(15, "").coefficients.len(), equation(16, "").coefficients.len()), (10, 9));
    assert!((lift(15, 25.0) - 1.17).abs() < 5e-3);
    assert!((lift(15, 18.0) + 0.74).abs() < 5e-3);
    assert!((lift(12, 18.0) - 0.90).abs() < 5e-3);
    // where both should hold they are 1.6 apart, so the generated runs start at 22 degrees
    let least =
        Series::HighAlpha.points().iter().map(|p| p.condition.alpha_deg).fold(f64::INFINITY, f64::min);
    assert_eq!(least, 22.0);
    assert!(published().models().iter().all(|model| model.equation < 15 || model.response != "Cm"));
}

#[test]
fn m31_powered_lift_is_straight_in_the_pressure_with_a_slope_by_alpha_and_elevator() {
    let model = equation(11, "");
    for (alpha, delta) in [(4.0, 0.0), (10.0, 10.0), (18.0, 30.0)] {
        let of = |q_pa: f64| value(model, at(q_pa, alpha, delta).at_voltage(7.0));
        let slope = (of(100.0) - of(40.0)) / 60.0;
        let expected = 3.5739e-4 - 2.8758e-5 * delta - 8.7326e-5 * alpha;
        assert!((slope - expected).abs() < 1e-12, "{slope} {expected}");
        assert!((of(70.0) - 0.5 * (of(40.0) + of(100.0))).abs() < 1e-12);
    }
}

#[test]
fn m32_authority_of_the_elevator_depends_on_the_pressure() {
    for (number, wing, ends) in
        [(5, "PR", [0.0, 30.0]), (6, "PR", [0.0, 30.0]), (8, "BR", [-30.0, 0.0]), (10, "BR", [-30.0, 0.0])]
    {
        let [_, elevator, both] = effects(equation(number, wing), ends);
        assert!(both.abs() > 0.05 * elevator.abs(), "Eq. {number}: {elevator} {both}");
    }
}

#[test]
fn m33_every_constant_of_the_tables_is_there_with_its_confidence() {
    let count = |keep: &dyn Fn(Confidence, Status) -> bool| {
        let all = published().models().iter().flat_map(|model| &model.coefficients);
        all.filter(|coefficient| keep(coefficient.confidence, coefficient.status)).count()
    };
    // two blanks of Eq. 8 of paper 1, twelve of Eq. 9, two of Eq. 14
    assert_eq!(count(&|_, status| status == Status::Missing), 16);
    assert_eq!(count(&|_, status| status == Status::ExponentAssumed), 2);
    assert_eq!(count(&|_, status| status == Status::SuspectedCopy), 15);
    assert_eq!(
        count(&|confidence, status| { status == Status::Printed && confidence != Confidence::High }),
        0
    );
}
