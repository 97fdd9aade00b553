//! What a sensor and a dead weight may be.

use super::*;

fn sensor(column: &str, reads: Reading, under: Option<DeadWeight>) -> Sensor {
    Sensor { column: column.into(), reads, sigma: 0.1, zero: Zero::WindOff, scale: 0.0, under }
}

const HEIGHT: Reading = Reading::Height { y_over_span: 0.5, x_over_c: 0.25 };
const WEIGHT: DeadWeight = DeadWeight { mass_kg: 1.0, y_over_span: 0.5, x_over_c: 0.25 };

fn said(sensors: &[Sensor]) -> String {
    let checked = check(sensors, |name| name == "Fz_N", Path::new("campaign.ron"));
    checked.err().map(|error| error.to_string()).unwrap_or_default()
}

#[test]
fn places_are_on_the_wing_and_noise_and_scale_are_what_they_can_be() {
    let height =
        |y_over_span, x_over_c| said(&[sensor("a", Reading::Height { y_over_span, x_over_c }, None)]);
    for [y, x] in [[0.0, 0.0], [1.0, 1.0]] {
        assert_eq!(height(y, x), "");
    }
    for [y, x] in [[-0.01, 0.5], [1.01, 0.5], [0.5, -0.01], [0.5, 1.01]] {
        assert!(height(y, x).contains("beside the wing"), "{y} {x}");
    }
    for reads in [
        Reading::StripLift { y_over_span: 1.1 },
        Reading::Shear { y_over_span: 1.1 },
        Reading::Bending { y_over_span: 1.1 },
        Reading::Twist { y_over_span: 1.1 },
    ] {
        assert_eq!(reads.y_over_span(), 1.1);
        assert!(said(&[sensor("a", reads, None)]).contains("beside the wing"));
        assert_eq!(reads.is_shape(), matches!(reads, Reading::Twist { .. }));
    }
    assert!(HEIGHT.is_shape());
    for (sigma, good) in [(0.1, true), (0.0, false), (-0.1, false), (f64::INFINITY, false)] {
        assert_eq!(said(&[Sensor { sigma, ..sensor("a", HEIGHT, None) }]).is_empty(), good, "{sigma}");
    }
    for (scale, good) in [(0.0, true), (0.99, true), (1.0, false), (-0.01, false)] {
        assert_eq!(said(&[Sensor { scale, ..sensor("a", HEIGHT, None) }]).is_empty(), good, "{scale}");
    }
}

#[test]
fn columns_are_of_one_sensor_each_and_of_nothing_else() {
    let two = |a: &str, b: &str| said(&[sensor(a, HEIGHT, None), sensor(b, HEIGHT, None)]);
    assert_eq!(two("a", "b"), "");
    for (a, b, called) in [("a", "a", "`a`"), ("a", "Fz_N", "`Fz_N`"), ("", "b", "``")] {
        assert!(two(a, b).contains(&format!("cannot be called {called}")), "{a} {b}");
    }
}

#[test]
fn a_dead_weight_has_a_mass_a_place_and_a_shape_that_is_read() {
    let under = |reads: Reading, weight: DeadWeight| said(&[sensor("a", reads, Some(weight))]);
    assert_eq!(under(HEIGHT, WEIGHT), "");
    assert_eq!(under(Reading::Twist { y_over_span: 0.5 }, WEIGHT), "");
    assert!(under(Reading::Shear { y_over_span: 0.5 }, WEIGHT).contains("under a weight of 1.0 kg"));
    for mass_kg in [0.0, -1.0, f64::INFINITY] {
        assert!(under(HEIGHT, DeadWeight { mass_kg, ..WEIGHT }).contains("under a weight"), "{mass_kg}");
    }
    for beside in [DeadWeight { y_over_span: 1.5, ..WEIGHT }, DeadWeight { x_over_c: -0.5, ..WEIGHT }] {
        assert!(under(HEIGHT, beside).contains("beside the wing"));
    }
}

#[test]
fn one_weight_hangs_in_a_row_and_only_with_wind_off() {
    let other = DeadWeight { mass_kg: 2.0, ..WEIGHT };
    let sensors = [
        sensor("free", HEIGHT, None),
        sensor("one", HEIGHT, Some(WEIGHT)),
        sensor("two", HEIGHT, Some(other)),
    ];
    let cells = |read: [bool; 3]| read.map(|read| read.then_some(0.5));
    let weight = |read: [bool; 3]| weight_in(&sensors, &cells(read));
    assert_eq!(weight([true, false, false]), None);
    assert_eq!(weight([false, true, false]), Some(WEIGHT));
    assert_eq!(weight([true, false, true]), Some(other));
    let said = |v_m_s: f64, read: [bool; 3]| {
        let checked = check_weights(&sensors, v_m_s, &cells(read), Span::generated);
        checked.err().map(|error| error.to_string()).unwrap_or_default()
    };
    for (v_m_s, read) in [
        (20.0, [true, false, false]),
        (0.0, [true, false, false]),
        (0.0, [false, true, false]),
        (0.0, [false, false, true]),
        (20.0, [false, false, false]),
    ] {
        assert_eq!(said(v_m_s, read), "", "{v_m_s} {read:?}");
    }
    assert!(said(20.0, [false, true, false]).contains("`one` cannot be read here: it is read with wind off"));
    assert!(said(0.0, [false, true, true]).contains("`two` cannot be read here: another sensor"));
    assert!(said(0.0, [true, true, false]).contains("`free` cannot be read here: another sensor"));
}
