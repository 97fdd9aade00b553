//! Which numbers of an aircraft's file are refused, and that their neighbours are not.

use crate::aircraft::file::AircraftFile;
use crate::aircraft::small;

type Change = fn(&mut AircraftFile, f64);

fn refused(change: Change, value: f64) -> Option<String> {
    let (mut file, _) = small::files();
    change(&mut file, value);
    file.check().err().map(|error| error.to_string())
}

fn assert_bounds(what: &str, change: Change, fits: &[f64], wrong: &[f64]) {
    for value in fits {
        assert_eq!(refused(change, *value), None, "{what} {value}");
    }
    for value in wrong {
        let why = refused(change, *value).unwrap_or_else(|| panic!("{what} {value} is not refused"));
        assert!(why.contains(what), "{what} {value}: {why}");
    }
}

#[test]
fn masses_stiffnesses_and_sizes_are_above_zero_and_finite() {
    let wrong = [0.0, -1.0, f64::NAN, f64::INFINITY];
    let all: [(&str, Change); 19] = [
        ("correction_airspeed_m_s", |file, value| file.correction_airspeed_m_s = value),
        ("rho_kg_m3", |file, value| file.rho_kg_m3 = value),
        ("total.mass_kg", |file, value| file.total.mass_kg = value),
        ("total.ixx_kg_m2", |file, value| file.total.ixx_kg_m2 = value),
        ("total.iyy_kg_m2", |file, value| file.total.iyy_kg_m2 = value),
        ("total.izz_kg_m2", |file, value| file.total.izz_kg_m2 = value),
        ("fuselage.height_m", |file, value| file.fuselage.height_m = value),
        ("actuator.frequency_hz", |file, value| file.actuator.frequency_hz = value),
        ("actuator.damping_ratio", |file, value| file.actuator.damping_ratio = value),
        ("modes_up_to_hz", |file, value| file.modes_up_to_hz = value),
        ("fuselage.beam", |file, value| file.fuselage.beam.ei_nm2 = value),
        ("fuselage.beam", |file, value| file.fuselage.beam.gj_nm2 = value),
        ("fuselage.beam", |file, value| file.fuselage.beam.mass_kg_m = value),
        ("htp.beam", |file, value| file.htp.beam.mass_kg_m = value),
        ("vtp.beam", |file, value| file.vtp.beam.gj_nm2 = value),
        ("htp: span and chords", |file, value| file.htp.span_m = value),
        ("htp: span and chords", |file, value| file.htp.root_chord_m = value),
        ("vtp: span and chords", |file, value| file.vtp.tip_chord_m = value),
        ("vtp: span and chords", |file, value| file.vtp.span_m = value),
    ];
    for (what, change) in all {
        assert_bounds(what, change, &[1e-3, 1.0], &wrong);
    }
}

#[test]
fn numbers_have_the_bounds_that_their_sentences_say() {
    let infinite = [f64::NAN, f64::INFINITY];
    let above = [1e6 * (1.0 + 1e-9), f64::INFINITY];
    assert_bounds("rho_kg_m3", |file, value| file.rho_kg_m3 = value, &[1e6], &above);
    assert_bounds("total.mass_kg", |file, value| file.total.mass_kg = value, &[1e6], &above);
    assert_bounds("modes_up_to_hz", |file, value| file.modes_up_to_hz = value, &[1e6], &above);
    assert_bounds(
        "actuator.damping_ratio",
        |file, value| file.actuator.damping_ratio = value,
        &[10.0],
        &[10.1],
    );
    assert_bounds("total.x_cg_m", |file, value| file.total.x_cg_m = value, &[-1.0, 0.0], &infinite);
    assert_bounds(
        "pull_up.load_factor",
        |file, value| file.pull_up.load_factor = value,
        &[-3.0, 0.0],
        &infinite,
    );
    let speeds: [(&str, Change); 3] = [
        ("trim.V_m_s", |file, value| (file.trim.v_m_s, file.gust) = (value, None)),
        ("pull_up.V_m_s", |file, value| file.pull_up.v_m_s = value),
        ("push_down.V_m_s", |file, value| file.push_down.v_m_s = value),
    ];
    for (what, change) in speeds {
        assert_bounds(what, change, &[0.1, 340.0], &[0.09, 340.1, 0.0, f64::NAN]);
    }
    let thrust: [Change; 2] = [
        |file, value| {
            file.thrust_line =
                Some(crate::aircraft::file::ThrustLine { point_m: (value, 0.0, 0.0), up_deg: 0.0 });
        },
        |file, value| {
            file.thrust_line =
                Some(crate::aircraft::file::ThrustLine { point_m: (0.0, 0.0, 0.0), up_deg: value });
        },
    ];
    for change in thrust {
        assert_bounds("thrust_line", change, &[0.0, -3.0], &infinite);
    }
}

#[test]
fn a_gust_is_half_a_metre_or_longer_and_at_most_half_the_airspeed() {
    let of: [(&str, Change, [f64; 2], [f64; 3]); 4] = [
        ("gust.start_s", |file, value| gust(file).start_s = value, [0.0, 600.0], [-0.1, 600.1, f64::NAN]),
        (
            "gust.duration_s",
            |file, value| gust(file).duration_s = value,
            [0.0, 600.0],
            [-0.1, 600.1, f64::NAN],
        ),
        (
            "gust.length_m",
            |file, value| gust(file).length_m = value,
            [0.5, 100.0],
            [0.49, f64::NAN, f64::INFINITY],
        ),
        // the trim's airspeed is 25.7 m/s
        (
            "gust.velocity_m_s",
            |file, value| gust(file).velocity_m_s = value,
            [12.85, -12.85],
            [12.9, -12.9, f64::NAN],
        ),
    ];
    for (what, change, fits, wrong) in of {
        assert_bounds(what, change, &fits, &wrong);
    }
}

fn gust(file: &mut AircraftFile) -> &mut crate::aircraft::file::GustCase {
    file.gust.as_mut().expect("the shipped aircraft flies a gust")
}

#[test]
fn fuselage_and_tail_have_parts_that_follow_each_other_and_boxes_to_spare() {
    let order = "must follow each other";
    assert_bounds(order, |file, value| file.fuselage.x_m.0 = value, &[-0.1], &[0.0, 0.1, f64::NEG_INFINITY]);
    assert_bounds(order, |file, value| file.fuselage.gap_x_m.0 = value, &[0.2], &[0.45, 0.5, f64::NAN]);
    assert_bounds(order, |file, value| file.fuselage.x_m.1 = value, &[0.46], &[0.45, f64::INFINITY]);
    let one: [(&str, Change); 3] = [
        ("strips and boxes", |file, value| file.fuselage.half_width_wing_strips = usize::from(value > 0.5)),
        ("strips and boxes", |file, value| file.fuselage.boxes.ahead = u32::from(value > 0.5)),
        ("strips and boxes", |file, value| file.fuselage.boxes.behind = u32::from(value > 0.5)),
    ];
    for (what, change) in one {
        assert_bounds(what, change, &[1.0], &[0.0]);
    }
    assert_bounds(
        "the sweep",
        |file, value| file.htp.leading_edge_sweep_deg = value,
        &[75.0, -75.0],
        &[75.1, -75.1],
    );
    assert_bounds("a place", |file, value| file.vtp.root_leading_edge_m.2 = value, &[0.0], &[f64::NAN]);
    assert_bounds("a place", |file, value| file.htp.root_leading_edge_m.0 = value, &[0.0], &[f64::INFINITY]);
    let control = "not all, of the chord";
    assert_bounds(
        control,
        |file, value| file.htp.control.chord_share = value,
        &[0.01, 0.99],
        &[0.0, 1.0, -0.1],
    );
    for (boxes, fits) in [(0, false), (1, true), (2, false), (3, false)] {
        let (mut file, _) = small::files();
        file.vtp.control.chord_boxes = boxes;
        assert_eq!(file.check().is_ok(), fits, "{boxes} of two boxes");
    }
    for (boxes, fits) in [(0, false), (1, true), (200, true), (201, false)] {
        let (mut file, _) = small::files();
        file.vtp.boxes.spanwise = boxes;
        assert_eq!(file.check().is_ok(), fits, "{boxes} strips");
        let (mut file, _) = small::files();
        file.htp.boxes.chordwise = boxes;
        assert_eq!(file.check().is_ok(), fits && boxes > 1, "{boxes} boxes along the chord");
    }
}
