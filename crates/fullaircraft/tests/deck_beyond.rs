//! Roots beyond the reduced frequencies of a deck: MSC Nastran's print of the Goland wing, with one of them at each Mach number.

use crate::deck_flutter::{assembled, curves};
use fullaircraft::{FlutterDeck, FlutterPoints, flutter_cases};
use maneuver::flutter::CompleteCurves;
use nastran::{BulkData, parse_deck};
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::fmt::Write as _;
use std::path::Path;

fn published(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/published").join(name);
    std::fs::read_to_string(path).expect("a published file")
}

fn numbers<T: DeserializeOwned>(value: &Value) -> T {
    serde_json::from_value(value.clone()).unwrap_or_else(|error| panic!("{error}: {value}"))
}

/// The print's rows of a mode: reduced frequency, Mach number, airspeed, damping and frequency.
fn rows(case: &Value, mode: usize) -> Vec<[f64; 5]> {
    numbers(&case["expected"]["flutter"][mode.to_string()]["rows"])
}

fn case() -> Value {
    serde_json::from_str(&published("flutter__goland_pknl.json")).expect("JSON")
}

/// A list as FLFACT has it.
fn list(id: u32, values: impl IntoIterator<Item = f64>) -> String {
    let mut text = format!("FLFACT,{id}");
    for (i, value) in values.into_iter().enumerate() {
        let newline = if i % 8 == 7 { "\n" } else { "" };
        let _ = write!(text, "{newline},{value:?}");
    }
    text + "\n"
}

/// The wing asked for flutter by the cards given.
fn wing(asked: &str) -> BulkData {
    let head = "SOL 145\nCEND\nSPC = 1\nMETHOD = 5\nFMETHOD = 6\nBEGIN BULK\n";
    let text = format!("{head}{}{asked}", published("decks/goland_wing.inc"));
    parse_deck("goland", &text).unwrap_or_else(|error| panic!("{error}"))
}

/// The matched points of the print.
fn matched(case: &Value) -> BulkData {
    let pairs: Vec<[f64; 2]> = numbers(&case["inputs"]["mkaero2_mach_k"]);
    let mut asked = String::from("FLUTTER,6,PKNL,1,2,3\n");
    for [mach, k] in pairs {
        let _ = writeln!(asked, "MKAERO2,{mach:?},{k:?}");
    }
    let rows = rows(case, 1);
    asked += &list(1, rows.iter().map(|_| 1.0));
    asked += &list(2, rows.iter().map(|row| row[1]));
    asked += &list(3, rows.iter().map(|row| row[2]));
    wing(&asked)
}

/// Demands a printed root, within a thousandth of its frequency and of g.
fn assert_met(curves: &CompleteCurves, [_, _, v, g, hz]: [f64; 5]) {
    let place = curves.flows.iter().position(|flow| (flow.v_m_s - v).abs() < 1e-9).expect("an airspeed");
    let roots: Vec<_> = curves.branches.iter().filter_map(|branch| branch.at(place)).collect();
    let is_met = |root: &&&maneuver::flutter::Root| {
        let is_near = (root.frequency_hz() / hz - 1.0).abs() < 1e-3;
        is_near && root.damping_g().is_some_and(|own| (own - g).abs() < 1e-3)
    };
    let all = || roots.iter().map(|root| (root.frequency_hz(), root.damping_g())).collect::<Vec<_>>();
    assert!(roots.iter().any(|root| is_met(&root)), "{v}: {hz} Hz, g {g}: {:?}", all());
}

#[test]
fn roots_beyond_the_one_reduced_frequency_of_each_mach_number_are_msc_nastran_s() {
    let case = case();
    let bulk = matched(&case);
    let curves = curves(&bulk);
    let mut met = 0;
    for row in (1..=4).flat_map(|mode| rows(&case, mode)) {
        // One root is below the deck's frequency, where ours has the steady air, too, and Nastran nothing.
        if row[0] > 0.4373 {
            assert_met(&curves, row);
            met += 1;
        }
    }
    assert_eq!(met, 79);
    let all = curves.branches.iter().flat_map(|branch| &branch.roots);
    assert_eq!(all.filter(|root| root.beyond_table).count(), 79);
    // The second mode's g goes through zero between -.0033 at 160 and .0579 at 170; what bends in the plane has no air and no damping.
    let [flutter] = curves.crossings.as_slice() else { panic!("{:?}", curves.crossings) };
    assert!(flutter.beyond_table && flutter.unstable && curves.branches.len() == 4, "{flutter:?}");
    assert!((flutter.flow.v_m_s - 160.5).abs() < 0.2, "{flutter:?}");
    let points = assembled(&bulk).1;
    let mach = points[0].mach_at(flutter.flow.v_m_s);
    assert!((mach - (0.4706 + (flutter.flow.v_m_s - 160.0) * 0.00294)).abs() < 1e-9, "{mach}");
}

#[test]
fn one_mach_number_with_one_reduced_frequency_has_the_same_roots() {
    let lists = [list(1, [1.0]), list(2, [0.4706]), list(3, [150.0, 160.0, 170.0])].concat();
    let bulk = wing(&format!("FLUTTER,6,PK,1,2,3\nMKAERO1,.4706\n,.5466\n{lists}"));
    let curves = curves(&bulk);
    let case = case();
    for mode in 1..=4 {
        let printed = rows(&case, mode).into_iter().find(|row| row[2] == 160.0).expect("a row");
        assert_met(&curves, printed);
    }
    assert_eq!(curves.crossings.len(), 1, "{:?}", curves.crossings);
}

/// NASTRAN-95 (PyPI nastran95 0.3, own run) on this wing with sixteen reduced frequencies from .01 to 80: Mach number, airspeed, and g and
/// frequency of each mode on which air acts.
const IN_THE_TABLE: [[f64; 8]; 3] = [
    [0.0294, 10.0, -0.016_88, 7.4243, -0.007_61, 14.9530, 0.000_34, 38.2872],
    [0.1765, 60.0, -0.141_12, 7.5127, -0.080_39, 14.4079, -0.054_08, 36.9863],
    [0.4118, 140.0, -0.626_33, 8.4616, -0.114_83, 11.1637, -0.153_23, 36.4789],
];

#[test]
fn with_a_few_low_frequencies_roots_beyond_them_are_rough_but_nothing_flutters() {
    // NASTRAN-95 with the same three goes on in a straight line and has g .120 of the second mode at 10 m/s, .017 at 60.
    for [mach, v, expected @ ..] in IN_THE_TABLE {
        let lists = [list(1, [1.0]), list(2, [mach]), list(3, [v])].concat();
        let bulk = wing(&format!("FLUTTER,6,PK,1,2,3\nMKAERO1,{mach:?}\n,.01,.1,.3\n{lists}"));
        let curves = curves(&bulk);
        for pair in expected.chunks(2) {
            let [g, hz] = [pair[0], pair[1]];
            let roots = curves.branches.iter().map(|branch| branch.roots[0]);
            let is_met = |root: maneuver::flutter::Root| {
                let is_near = (root.frequency_hz() / hz - 1.0).abs() < 0.05 && root.beyond_table;
                is_near && root.damping_g().is_some_and(|own| (own - g).abs() < 0.08)
            };
            assert!(roots.clone().any(is_met), "{v}: {hz} Hz, g {g}: {:?}", roots.collect::<Vec<_>>());
        }
        assert!(curves.branches.iter().all(|branch| !branch.roots[0].is_growing()), "{v}");
    }
}

#[test]
fn the_k_method_beyond_the_deck_s_frequencies_is_refused_with_the_card_and_what_to_list() {
    let lists = [list(1, [1.0]), list(2, [0.47]), list(3, [0.5, 2.0, 0.7])].concat();
    let bulk = wing(&format!("FLUTTER,6,K,1,2,3\nMKAERO1,.4706\n,.5466,.6\n{lists}"));
    let (case, card) = flutter_cases(&bulk).expect("a case").remove(0);
    let deck = FlutterDeck::new(&bulk, &case).unwrap_or_else(|error| panic!("{error}"));
    let said = deck.points(&bulk, &card).expect_err("k = 2 is not there").to_string();
    for words in ["goland:", "FLUTTER 6 asks for k = 2 at Mach 0.47", "(up to 0.6)", "list k up to 2"] {
        assert!(said.contains(words), "{words}: {said}");
    }
    assert_eq!((deck.highest_k(0.4), deck.highest_k(0.9)), (0.6, 0.6));
}

#[test]
fn matched_points_have_the_mach_number_between_them() {
    let flows = [10.0, 20.0, 40.0].map(|v_m_s| aero::Flow { v_m_s, rho_kg_m3: 1.0 }).to_vec();
    let points = FlutterPoints::Matched { machs: vec![0.1, 0.3, 0.4], flows };
    for (v, mach) in
        [(5.0, 0.1), (10.0, 0.1), (15.0, 0.2), (20.0, 0.3), (30.0, 0.35), (40.0, 0.4), (50.0, 0.4)]
    {
        assert!((points.mach_at(v) - mach).abs() < 1e-12, "{v}: {}", points.mach_at(v));
    }
}
