//! Flutter of a study: decks without the cards of their flutter have the roots of the whole ones, printed ones among them.

use crate::apart::Apart;
use crate::deck_flutter::{PK, assert_printed, curves, plate, printed, wing_text};
use fullaircraft::study::{Aim, read_terms};
use maneuver::flutter::CompleteCurves;
use nalgebra::{Rotation3, Vector3};
use nastran::{BulkData, op4_text, parse_deck};

/// Cards of a deck's flutter that a study gives.
const GIVEN: [&str; 5] = ["AERO,", "MKAERO1,", "FLUTTER,", "FLFACT,", "EIGRL,"];

/// A list as a study has it.
fn list(values: impl IntoIterator<Item = f64>) -> String {
    format!("{:?}", values.into_iter().collect::<Vec<f64>>())
}

/// The matched points of the print.
fn matched(rows: &[Vec<f64>], more: &str) -> String {
    let column = |at: usize| list(rows.iter().map(|row| row[at]));
    format!(
        "(decks: [\"part.bdf\"], spc: 1, reference: (chord: 1.0), unsteady: (modes: 2), {more}\n\
         flutter: (method: Pknl, machs: {}, densities: Given({}), airspeeds: {}))",
        column(3),
        column(2),
        column(4)
    )
}

/// The print has the forces of one Mach number for all points: its MKAERO1 stays in the deck.
#[test]
fn a_printed_deck_taken_apart_has_its_printed_roots() {
    let printed = printed();
    let given: Vec<&str> = GIVEN.into_iter().filter(|name| *name != "MKAERO1,").collect();
    let apart = Apart::new("plate", &plate(&printed[0]), &given);
    let bulk = apart.bulk(&matched(&printed[0], ""), Aim::Flutter, None);
    assert!(bulk.trims.is_empty() && bulk.supports.is_empty());
    assert_printed(&bulk, &printed);
}

/// Nothing is left of the deck's own masses, which are made wrong.
#[test]
fn an_op4_matrix_in_the_masses_place_has_the_printed_roots() {
    let printed = printed();
    let given: Vec<&str> = GIVEN.into_iter().filter(|name| *name != "MKAERO1,").collect();
    let deck = plate(&printed[0]);
    let apart = Apart::new("op4", &deck, &given);
    let masses = parse_deck("plate", &deck).expect("a deck").masses;
    let mut columns = vec![vec![0.0; 36]; 36];
    for mass in masses.values() {
        for motion in 0..3 {
            let place = 6 * (mass.grid as usize - 1) + motion;
            columns[place][place] = mass.mass;
        }
    }
    std::fs::write(apart.0.join("mass.op4"), op4_text("MGG", &columns)).expect("a matrix");
    let terms = read_terms(&apart.0.join("mass.op4")).expect("a matrix");
    apart.change("CONM2,10,1,,", "CONM2,10,1,,5");
    let study = matched(&printed[0], "masses: Matrix(\"mass.op4\"),");
    assert_printed(&apart.bulk(&study, Aim::Flutter, Some(&terms)), &printed);
}

/// A cantilever with structural damping, whole; its half is moved symmetrically (1) or not (-1).
fn whole(symmetry: i32) -> String {
    let deck = wing_text(&Rotation3::identity(), 0, PK).replace("METHOD = 5\n", "METHOD = 5\nSDAMPING = 7\n");
    let deck = deck.replace("AERO,0,,.5,1.225,1", &format!("AERO,0,,.5,1.225,{symmetry}"));
    deck + "TABDMP1,7,G\n,0.,.02,100.,.06,ENDT\n"
}

const CANTILEVER: &str = "(decks: [\"part.bdf\"], spc: 1, reference: (chord: 0.5, is_half: true),
    unsteady: (reduced_frequencies: [0.001, 0.05, 0.1, 0.2, 0.3, 0.5, 0.8, 1.2], modes: 6, damping: [(0.0, 0.02), (100.0, 0.06)]),
    flutter: (machs: [0.0], densities: Ratios(to: 1.225, ratios: [1.0]),
        airspeeds: [5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0, 45.0, 50.0, 55.0, 60.0]))";

fn taken_apart(name: &str) -> Apart {
    Apart::new(name, &whole(1), &[&GIVEN[..], &["TABDMP1,"]].concat())
}

fn of(deck: &str) -> BulkData {
    parse_deck("wing", deck).unwrap_or_else(|error| panic!("{error}"))
}

#[track_caller]
fn assert_same(one: &CompleteCurves, other: &CompleteCurves) {
    assert_eq!(one.flows.len(), other.flows.len());
    assert_eq!(one.branches.len(), other.branches.len());
    for (a, b) in one.branches.iter().zip(&other.branches) {
        for (a, b) in a.roots.iter().zip(&b.roots) {
            assert!((a.p - b.p).norm() <= 1e-9 * a.p.norm(), "{a:?} {b:?}");
        }
    }
}

#[test]
fn a_wing_taken_apart_has_the_roots_of_the_whole_deck() {
    let apart = taken_apart("wing");
    let symmetric = curves(&of(&whole(1)));
    assert_same(&symmetric, &curves(&apart.bulk(CANTILEVER, Aim::Flutter, None)));
    let speed = symmetric.flutter().expect("it flutters").flow.v_m_s;
    assert!((5.0..60.0).contains(&speed), "{speed}");
    let study = CANTILEVER.replace("modes: 6,", "modes: 6, motion: Antisymmetric,");
    let antisymmetric = curves(&of(&whole(-1)));
    assert_same(&antisymmetric, &curves(&apart.bulk(&study, Aim::Flutter, None)));
    let other = antisymmetric.flutter().expect("it flutters").flow.v_m_s;
    assert!((other / speed - 1.0).abs() > 1e-3, "the image tells them apart: {speed} {other}");
}

#[test]
fn what_the_decks_give_of_it_is_taken_from_them() {
    // AERO with half of the density, MKAERO1 and EIGRL stay in the deck; damping of one point is that of all frequencies
    let deck = whole(1).replace("AERO,0,,.5,1.225,1", "AERO,0,,.5,.6125,1");
    let apart = Apart::new("of_decks", &deck, &["FLUTTER,", "FLFACT,", "TABDMP1,"]);
    let study = "(decks: [\"part.bdf\"], spc: 1, unsteady: (damping: [(3.0, 0.02)]), flutter: (machs: [0.0], densities: Given([1.225]), \
        airspeeds: [5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0, 45.0, 50.0, 55.0, 60.0]))";
    let even = whole(1).replace(",100.,.06,", ",100.,.02,");
    assert_same(&curves(&of(&even)), &curves(&apart.bulk(study, Aim::Flutter, None)));
}

#[test]
fn boxes_follow_their_nearest_grids_in_a_turned_stream_as_in_a_straight_one() {
    let given = [&GIVEN[..], &["SPLINE2,", "SET1,"]].concat();
    let roots = |name: &str, turn: &Rotation3<f64>, strips: u32| {
        let panel = format!("CAERO1,1001,1,9,{strips},4,");
        let deck = wing_text(turn, 9, PK).replace("CAERO1,1001,1,9,8,4,", &panel);
        let apart = Apart::new(&format!("{name}-{strips}"), &deck, &given);
        let study = CANTILEVER
            .replace("spc: 1,", "spc: 1, splines: Nearest,")
            .replace("is_half: true", "is_half: true, stream: 9");
        curves(&apart.bulk(&study, Aim::Flutter, None))
    };
    // real roots come and go by rounding where two meet: what flutters, and at which frequency, does not
    let flutter = |name: &str, turn: &Rotation3<f64>, strips: u32| {
        let curves = roots(name, turn, strips);
        let crossing = curves.flutter().expect("it flutters");
        (crossing.flow.v_m_s, crossing.omega_rad_s)
    };
    // middles of five strips are nowhere between two grids, those of eight are
    for strips in [5, 8] {
        let straight = flutter("straight", &Rotation3::identity(), strips);
        let turned = flutter("turned", &Rotation3::new(Vector3::new(0.3, -0.7, 2.0)), strips);
        assert!((straight.0 / turned.0 - 1.0).abs() < 1e-6, "{straight:?} {turned:?}");
        assert!((straight.1 / turned.1 - 1.0).abs() < 1e-6, "{straight:?} {turned:?}");
    }
}

#[test]
fn what_flutter_lacks_is_said_where_it_stands() {
    let apart = taken_apart("refused");
    for (from, to, said) in [
        ("flutter: (", "flatter: (", "flatter"),
        ("machs: [0.0]", "machs: []", "needs Mach numbers, densities and airspeeds"),
        ("machs: [0.0]", "machs: [1.2]", "subsonic"),
        ("ratios: [1.0]", "ratios: [-1.0]", "-1 where a number above zero is expected"),
        ("[5.0, 10.0,", "[0.0, 10.0,", "0 where a number above zero is expected"),
        (
            "machs: [0.0]",
            "method: Pknl, machs: [0.0]",
            "1 Mach numbers, 1 densities and 12 airspeeds one by one",
        ),
        ("modes: 6", "modes: 0", "no modes"),
        ("modes: 6", "up_to_hz: 0.0", "0 where a frequency above zero"),
        ("(100.0, 0.06)", "(0.0, 0.06)", "do not rise"),
        ("[0.001,", "[-0.001,", "-0.001 where a reduced frequency"),
        ("[0.001, 0.05, 0.1, 0.2, 0.3, 0.5, 0.8, 1.2]", "[]", "have reduced frequencies"),
        ("reference: (chord: 0.5, is_half: true),", "", "needs a reference chord"),
        ("chord: 0.5, is_half: true", "chord: 0.5, stream: 77", "77"),
    ] {
        let study = CANTILEVER.replacen(from, to, 1);
        assert_ne!(study, CANTILEVER, "{from}");
        let error = match apart.deck(&study, Aim::Flutter, None) {
            Err(error) => error,
            Ok(deck) => why(&deck.bulk),
        };
        assert!(error.contains(said), "{said}: {error}");
    }
    let whole =
        CANTILEVER.replace(", is_half: true", "").replace("modes: 6,", "modes: 6, motion: Antisymmetric,");
    let error = apart.deck(&whole, Aim::Flutter, None).expect_err("a whole aircraft");
    assert!(error.contains("only half an aircraft") && error.contains("study.ron:2:"), "{error}");
    let error = apart.deck(CANTILEVER, Aim::Trims, None).expect_err("no trims");
    assert!(
        error.contains("no section `trims`") && error.contains("`flutter` (`flutter --deck`)"),
        "{error}"
    );
    apart.change("PBAR,", "EIGRL,3,,,4\nEIGRL,4,,,5\nPBAR,");
    let error = apart.deck(&CANTILEVER.replace("modes: 6, ", ""), Aim::Flutter, None).expect_err("two EIGRL");
    assert!(error.contains("2 EIGRL or EIGR, and nothing says which"), "{error}");
}

/// Why a deck does not flutter.
fn why(bulk: &BulkData) -> String {
    let (case, _) = fullaircraft::flutter_cases(bulk).expect("a case").remove(0);
    fullaircraft::FlutterDeck::new(bulk, &case).expect_err("it is wrong").to_string()
}
