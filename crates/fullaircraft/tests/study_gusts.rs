//! Gusts of a study: decks without the cards of their gusts answer as the whole ones, and as printed and computed by others.

use crate::apart::Apart;
use crate::deck_gust::{IN_TIME, SLOPE, rectangle_text, solved, station, wave};
use fullaircraft::study::Aim;
use fullaircraft::{DynamicAnswer, GustCase, GustDeck, TimeAnswer, gust_cases};
use nalgebra::{Rotation3, Vector3};
use nastran::{BulkData, parse_deck, read_deck};
use serde_json::Value;
use std::path::Path;

/// Cards of a deck's gusts that a study gives.
const GIVEN: [&str; 14] = [
    "AERO,",
    "MKAERO1,",
    "EIGRL,",
    "PARAM,Q,",
    "PARAM,MACH,",
    "GUST,",
    "DLOAD,",
    "TLOAD",
    "RLOAD",
    "FREQ",
    "TSTEP",
    "DAREA,",
    "TABLED1,",
    "TABDMP1,",
];

/// A motion of a grid over time: displacement (0) or acceleration (1), by component.
fn motion(time: &TimeAnswer, deck: &GustDeck, grid: u32, kind: usize, component: usize) -> Vec<f64> {
    let motions = time.of_grid(&deck.shapes_at(grid).expect("a grid"));
    motions.iter().map(|motion| motion[kind][component]).collect()
}

fn in_time(solved: &(GustCase, GustDeck, DynamicAnswer)) -> TimeAnswer {
    solved.1.in_time(&solved.0, &solved.2).expect("in time")
}

/// Largest difference of two histories over the largest of the first.
fn off(one: &[f64], other: &[f64]) -> f64 {
    assert_eq!(one.len(), other.len());
    let size = one.iter().map(|value| value.abs()).fold(0.0, f64::max);
    one.iter().zip(other).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / size
}

/// The square gust of the jet transport wing of Bisplinghoff, Ashley and Halfman; rho is 2 Q/V².
fn bah_study() -> String {
    format!(
        "(decks: [\"part.bdf\"], spc: 1, mpc: 1, reference: (chord: 131.232, is_half: true, stream: 1),
        unsteady: (modes: 12, damping: [(0.0, 0.06)],
            reduced_frequencies: [0.01, 0.02, 0.04, 0.07, 0.1, 0.14, 0.18, 0.22, 0.26, 0.3, 0.35, 0.4, 0.45, 0.5]),
        gusts: (mach: 0.62, v: 8360.0, rho: {:e}, front_x: 0.0,
            waves: [(name: \"square\", amplitude: 8360.0, points: [(0.0, 1.0), (1.0, 1.0), (1.0, -1.0), (2.0, -1.0)])],
            frequencies: (step_hz: 0.25, highest_hz: 9.75), times: (step_s: 0.1, end_s: 4.0), grids: [1, 9, 10, 11, 12]))",
        2.0 * 4.00747 / 8360.0_f64.powi(2)
    )
}

#[test]
fn a_printed_deck_taken_apart_answers_a_square_gust_as_printed() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/published/decks/bah_gust.bdf");
    let text = std::fs::read_to_string(&path).expect("the shipped deck");
    let random = ["RANDPS,", "TABRND1,"];
    let apart = Apart::new("bah", &text, &[&GIVEN[..], &random].concat());
    let bulk = apart.bulk(&bah_study(), Aim::Gusts, None);
    let of_study = solved(&bulk);
    assert_eq!(of_study.0.subcase.label, "square");
    assert_eq!(of_study.1.asked_grids(&of_study.0.subcase), [1, 9, 10, 11, 12]);
    let time = in_time(&of_study);
    let printed: Value = serde_json::from_str(include_str!("data/bah_square_gust.json")).expect("JSON");
    for (key, grid) in [("T3_10", 10), ("T3_11", 11)] {
        let printed: Vec<f64> = serde_json::from_value(printed[key].clone()).expect("numbers");
        let off = off(&printed, &motion(&time, &of_study.1, grid, 0, 2));
        // as the whole deck (`bah_gust.rs`)
        assert!(off < 0.05, "{key}: {off}");
    }
    let whole = read_deck(&path).expect("the shipped deck");
    let cases = gust_cases(&whole).expect("two gusts");
    let deck = GustDeck::new(&whole, &cases[1].subcase, &[&cases[0], &cases[1]]).expect("a deck");
    let answer = deck.answer(&cases[1]).expect("an answer");
    let of_whole = deck.in_time(&cases[1], &answer).expect("in time");
    for component in 0..6 {
        let loads = |deck: &GustDeck, time: &TimeAnswer| -> Vec<f64> {
            time.stations[station(deck, "SIDE")].loads.iter().map(|loads| loads.total(component)).collect()
        };
        let [one, other] = [loads(&deck, &of_whole), loads(&of_study.1, &time)];
        let is_loaded = one.iter().any(|value| *value != 0.0);
        assert!(!is_loaded || off(&one, &other) < 1e-9, "component {component}: {one:?} {other:?}");
    }
}

/// One minus cosine on the rigid rectangle of `deck_gust.rs`, in its own units: chord, airspeed and density one.
fn rectangle_study(reference: &str, gradient: f64, more: &str) -> String {
    format!(
        "(decks: [\"part.bdf\"], spc: 1, reference: (chord: 1.0{reference}),
        unsteady: (modes: 1, reduced_frequencies: [1e-4, 0.003, 0.01, 0.03, 0.06, 0.1, 0.15, 0.2, 0.27, 0.35, 0.45, 0.55, 0.7, 0.85,
            1.0, 1.2, 1.4, 1.6, 1.8, 2.0]),
        gusts: (mach: 0.0, v: 1.0, rho: 1.0{more}, waves: [(name: \"up\", amplitude: 1.0, gradient: {gradient:?})],
            frequencies: (step_hz: 2.5e-4, highest_hz: 0.6365), times: (step_s: 0.1, end_s: 40.0), grids: [1]))"
    )
}

const HALF: &str = ", is_half: true, stream: 9";

fn rectangle(name: &str, mu: f64, turn: &Rotation3<f64>) -> Apart {
    Apart::new(name, &rectangle_text(mu, turn, IN_TIME, &wave(12.5)), &GIVEN)
}

#[test]
fn one_minus_cosine_peaks_as_by_another_doublet_lattice_and_as_the_whole_deck() {
    let reference: Value =
        serde_json::from_str(include_str!("data/rectangular_wing_gust.json")).expect("JSON");
    let row = &reference["cases"][0];
    let number = |key: &str| row[key].as_f64().expect("a number");
    let (mu_g, gradient) = (number("mu_g"), number("H_over_c"));
    let mu = 0.5 * mu_g * SLOPE;
    let bulk = rectangle("peak", mu, &Rotation3::identity()).bulk(
        &rectangle_study(HALF, gradient, ""),
        Aim::Gusts,
        None,
    );
    let of_study = solved(&bulk);
    let time = in_time(&of_study);
    let heave = motion(&time, &of_study.1, 1, 1, 2);
    let peak = heave.iter().copied().fold(0.0, f64::max) * mu_g;
    let expected = number("peak_over_sharp_edge");
    assert!((peak / expected - 1.0).abs() < 0.01, "{peak} {expected}");
    let text = rectangle_text(mu, &Rotation3::identity(), IN_TIME, &wave(gradient));
    let whole = solved(&parse_deck("wing", &text).expect("a deck"));
    let of_whole = motion(&in_time(&whole), &whole.1, 1, 1, 2);
    assert!(off(&of_whole, &heave) < 1e-9, "{}", off(&of_whole, &heave));
}

/// Heave (along the wing's own normal) over time of a whole aircraft of one rectangle.
fn heave(bulk: &BulkData, normal: &Vector3<f64>) -> Vec<f64> {
    let solved = solved(bulk);
    let time = in_time(&solved);
    let along: Vec<Vec<f64>> = (0..3).map(|axis| motion(&time, &solved.1, 1, 1, axis)).collect();
    (0..along[0].len()).map(|i| (0..3).map(|axis| along[axis][i] * normal[axis]).sum()).collect()
}

#[test]
fn a_gust_from_the_side_does_to_a_fin_what_one_from_below_does_to_a_wing() {
    let flat = rectangle("flat", 20.0, &Rotation3::identity());
    let up = heave(&flat.bulk(&rectangle_study("", 12.5, ""), Aim::Gusts, None), &Vector3::z());
    // turned about the stream so that its normal points to the right, and put elsewhere: its front is felt first all the same
    let turn = Rotation3::from_axis_angle(&Vector3::x_axis(), -std::f64::consts::FRAC_PI_2);
    let fin = rectangle("fin", 20.0, &turn);
    let aside = rectangle_study("", 12.5, ", direction_deg: 90.0");
    let right = heave(&fin.bulk(&aside, Aim::Gusts, None), &Vector3::y());
    assert!(off(&up, &right) < 1e-6, "{}", off(&up, &right));
    let below = heave(&fin.bulk(&rectangle_study("", 12.5, ""), Aim::Gusts, None), &Vector3::y());
    assert!(below.iter().all(|value| value.abs() < 1e-9), "a gust from below does not move a fin");
}

#[test]
fn what_gusts_lack_is_said_where_it_stands() {
    let apart = rectangle("refused", 20.0, &Rotation3::identity());
    let right = rectangle_study(HALF, 12.5, "");
    apart.bulk(&right, Aim::Gusts, None);
    for (from, to, said) in [
        ("gradient: 12.5", "gradient: 0.0", "the gust up: a gradient above zero"),
        (", gradient: 12.5", "", "either a gradient or two points"),
        ("gradient: 12.5", "points: [(1.0, 0.0), (0.0, 1.0)]", "the times of its points fall"),
        ("amplitude: 1.0", "amplitude: 0.0", "an amplitude other than zero"),
        ("waves: [(name: \"up\", amplitude: 1.0, gradient: 12.5)]", "waves: []", "gusts without waves"),
        ("mach: 0.0", "mach: 1.0", "subsonic"),
        ("rho: 1.0", "rho: 0.0", "0 where a number above zero"),
        ("step_hz: 2.5e-4", "step_hz: 1e-9", "steps, where 1 to 1000000"),
        ("highest_hz: 0.6365", "lowest_hz: 1.0, highest_hz: 0.6365", "frequencies from 1 to 0.6365 Hz"),
        ("step_s: 0.1", "step_s: 100.0", "0 steps, where 1 to 1000000"),
        ("grids: [1]", "grids: [1, 99]", "GRID 99 is not in the decks"),
        ("rho: 1.0", "rho: 1.0, direction_deg: 90.0", "half an aircraft meets gusts along z alone"),
        ("modes: 1,", "modes: 1, motion: Antisymmetric,", "a gust moves both halves of an aircraft alike"),
    ] {
        let study = right.replacen(from, to, 1);
        assert_ne!(study, right, "{from}");
        let error = apart.deck(&study, Aim::Gusts, None).expect_err(said);
        assert!(error.contains(said) && error.contains("study.ron:"), "{said}: {error}");
    }
    let many = right.replace("step_hz: 2.5e-4", "step_hz: 1e-6").replace("step_s: 0.1", "step_s: 5e-5");
    let error = apart.deck(&many, Aim::Gusts, None).expect_err("terabytes");
    assert!(error.contains("the frequencies at the times take about 8.1 TB"), "{error}");
    let error = apart.deck(&right, Aim::Flutter, None).expect_err("no flutter");
    assert!(error.contains("no section `flutter`") && error.contains("`gusts` (`gust --deck`)"), "{error}");
    apart.change("PAERO1,1\n", "PAERO1,1\nPARAM,Q,3.\n");
    let error = apart.deck(&right, Aim::Gusts, None).expect_err("two flows");
    assert!(error.contains("a PARAM Q of their own"), "{error}");
}
