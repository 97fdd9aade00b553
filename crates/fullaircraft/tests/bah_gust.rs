//! The jet transport wing of Bisplinghoff, Ashley and Halfman as a deck in a random gust, beside NASA's print
//! (data/published/gust__bah_gust_frequency_response.json), and in a square one, beside
//! its print of the transient and Newton's law.

use faer::c64;
use fullaircraft::{DeckGust, DynamicAnswer, GustCase, GustDeck, gust_cases};
use nastran::{BulkData, read_deck};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// What the case allows: its air forces are interpolated between three frequencies, ours between fourteen.
const SHARE: f64 = 0.05;

fn published(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/published").join(name)
}

fn wing() -> (BulkData, Vec<GustCase>, GustDeck) {
    let bulk = read_deck(&published("decks/bah_gust.bdf")).unwrap_or_else(|error| panic!("{error}"));
    let cases = gust_cases(&bulk).unwrap_or_else(|error| panic!("{error}"));
    let all: Vec<&GustCase> = cases.iter().collect();
    let deck = GustDeck::new(&bulk, &cases[0].subcase, &all).unwrap_or_else(|error| panic!("{error}"));
    (bulk, cases, deck)
}

/// A motion of a grid at each frequency.
fn motion(deck: &GustDeck, answer: &DynamicAnswer, grid: u32, row: usize) -> Vec<c64> {
    let shapes = deck.shapes_at(grid).expect("a grid");
    let at = |x: &Vec<c64>| x.iter().enumerate().map(|(j, x)| *x * shapes[(row, j)]).sum();
    answer.modal.iter().map(at).collect()
}

/// Demands the printed curve within a share of its largest.
fn near(what: &str, ours: &[c64], printed: &Value, share: f64) {
    let rows: Vec<[f64; 3]> = serde_json::from_value(printed.clone()).expect("rows of numbers");
    let size = rows.iter().map(|row| row[1].hypot(row[2])).fold(0.0, f64::max);
    // The print begins at rest, where a wing free in plunge has no answer.
    for (row, ours) in rows[1..].iter().zip(ours) {
        let off = (ours - c64::new(row[1], row[2])).norm();
        assert!(off < share * size, "{what} at {} Hz: {ours} beside {row:?}", row[0]);
    }
}

#[test]
fn the_wing_of_bisplinghoff_ashley_and_halfman_answers_a_random_gust_as_printed() {
    let text = std::fs::read_to_string(published("gust__bah_gust_frequency_response.json")).expect("a case");
    let case: Value = serde_json::from_str(&text).expect("JSON");
    let expected = &case["expected"];
    let (bulk, cases, deck) = wing();
    let answer = deck.answer(&cases[0]).unwrap_or_else(|error| panic!("{error}"));
    for grid in [1, 9, 10, 11] {
        near(
            &format!("T3 of {grid}"),
            &motion(&deck, &answer, grid, 2),
            &expected["disp_T3"][grid.to_string()],
            SHARE,
        );
    }
    near("aileron angle", &motion(&deck, &answer, 12, 4), &expected["disp_R2_12"], SHARE);
    // What holds the root takes away what the wing puts on it: elasticity in the print, at a station air less mass times acceleration,
    // which structural damping (g = .06) carries, too.
    let names: Vec<String> = deck.stations().map(|station| station.0.to_owned()).collect();
    for (name, key) in [("CENTRE", "root_bending_11R1_centreline"), ("SIDE", "root_bending_11R3_station45")] {
        let at = names.iter().position(|own| own == name).expect("a station");
        let bending: Vec<c64> = answer.stations.iter().map(|all| -all[at].total(3)).collect();
        near(name, &bending, &expected[key], SHARE + 0.06);
    }
    let gusts = [DeckGust { case: &cases[0], deck: &deck, answer: &answer }];
    let random = DeckGust::random(&bulk, 5, &gusts).unwrap_or_else(|error| panic!("{error}"));
    for (grid, key) in [(11, "plunge_11T3"), (9, "tip_9T3")] {
        let ours = random.of_grid(grid, 2, false).expect("a grid");
        // the print's first trapezoid, from nothing at rest
        let rms = (ours.rms.powi(2) + 0.125 * ours.density[0]).sqrt();
        let printed = expected["psd_rms"][key]["rms"].as_f64().expect("a number");
        println!("{key}: {rms} beside {printed}");
        assert!((rms / printed - 1.0).abs() < SHARE, "{key}: {rms} beside {printed}");
    }
}

#[test]
fn the_wing_answers_a_square_gust_in_time_as_printed_and_as_newton_says() {
    let text = include_str!("data/bah_square_gust.json");
    let printed: Value = serde_json::from_str(text).expect("JSON");
    let (_, cases, deck) = wing();
    let answer = deck.answer(&cases[1]).unwrap_or_else(|error| panic!("{error}"));
    let time = deck.in_time(&cases[1], &answer).expect("in time");
    let motions = |grid: u32| time.of_grid(&deck.shapes_at(grid).expect("a grid"));
    let loads = |name: &str| {
        let at = deck.stations().position(|station| station.0 == name).expect("a station");
        &time.stations[at].loads
    };
    let of_grid = |grid: u32| -> Vec<f64> { motions(grid).iter().map(|motion| motion[0][2]).collect() };
    let bending = |name: &str| -> Vec<f64> { loads(name).iter().map(|loads| -loads.total(3)).collect() };
    for (key, ours) in [
        ("T3_10", of_grid(10)),
        ("T3_11", of_grid(11)),
        ("root_bending_11R1_centreline", bending("CENTRE")),
        ("root_bending_11R3_station45", bending("SIDE")),
    ] {
        let printed: Vec<f64> = serde_json::from_value(printed[key].clone()).expect("numbers");
        assert_eq!(printed.len(), ours.len());
        let size = printed.iter().map(|value| value.abs()).fold(0.0, f64::max);
        let off = printed.iter().zip(&ours).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / size;
        println!("{key}: at most {off:.4} of the largest off");
        assert!(off < SHARE, "{key}: {off}: {ours:?}");
    }
    // Air on the boxes points up, the structure's z down: all of it is mass times acceleration of root (17400 lb) and wing.
    let mass = 17_400.0 * 0.002_590_7;
    let size = loads("AIR").iter().map(|loads| loads.total(2).abs()).fold(0.0, f64::max);
    for ((air, net), root) in loads("AIR").iter().zip(loads("CENTRE")).zip(motions(11)) {
        let left = -air.total(2) + net.inertial[2] - mass * root[1][2];
        assert!(left.abs() < 1e-6 * size, "{left} of {size}");
    }
}
