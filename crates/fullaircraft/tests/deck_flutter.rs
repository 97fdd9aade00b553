//! Flutter of decks (SOL 145): a printed case, and laws that hold whatever the wing.

use aero::Flow;
use fullaircraft::{FlutterDeck, FlutterPoints, FlutterRoots, flutter_cases};
use maneuver::flutter::{CompleteCurves, GafTable, KRoot};
use nalgebra::{Rotation3, Vector3};
use nastran::{BulkData, parse_deck};
use serde_json::Value;
use std::fmt::Write as _;
use std::path::Path;

/// A cantilever wing of 2 m by 0.5 m with its masses 5 cm behind the elastic axis; all of it stands in system 9, which is turned by
/// `turn` and shifted, and the stream flows along the x of system `acsid`.
fn wing(turn: &Rotation3<f64>, acsid: u32, flutter: &str) -> BulkData {
    parse_deck("wing", &wing_text(turn, acsid, flutter)).unwrap_or_else(|error| panic!("{error}"))
}

/// The text of [`wing`].
pub(crate) fn wing_text(turn: &Rotation3<f64>, acsid: u32, flutter: &str) -> String {
    let origin = if turn.angle() == 0.0 { Vector3::zeros() } else { Vector3::new(3.0, -2.0, 0.5) };
    let [up, along] = [Vector3::z(), Vector3::x()].map(|axis| origin + turn * axis);
    let list = |v: &Vector3<f64>| format!("{:.10},{:.10},{:.10}", v.x, v.y, v.z);
    let mut deck = format!(
        "SOL 145\nCEND\nSPC = 1\nMETHOD = 5\nFMETHOD = 6\nBEGIN BULK\nCORD2R,9,,{},{}\n,{}\nCORD2R,8,9,.2,0.,0.,.2,0.,1.\n,1.2,0.,0.\n",
        list(&origin),
        list(&up),
        list(&along)
    );
    let v = turn * Vector3::z();
    for i in 1..=9 {
        let _ = writeln!(deck, "GRID,{i},9,.2,{:.2},0.", 0.25 * f64::from(i - 1));
        let _ = writeln!(deck, "CONM2,{},{i},9,1.,.05,0.,0.\n,.001,,.02,,,.02", 100 + i);
    }
    for i in 1..=8 {
        let _ = writeln!(deck, "CBAR,{i},1,{i},{},{:.10},{:.10},{:.10}", i + 1, v.x, v.y, v.z);
    }
    deck.push_str(
        "MAT1,1,2.+9,1.+9,,0.\nPBAR,1,1,1.-3,1.-7,1.-5,1.-7\nSPC1,1,123456,1\nEIGRL,5,,,6\nPARAM,COUPMASS,1\nPAERO1,1\n\
         CAERO1,1001,1,9,8,4,,,1\n,0.,0.,0.,.5,0.,2.,0.,.5\nSET1,30,1,THRU,9\n\
         SPLINE2,20,1001,1001,1032,30,0.,1.,8\n,0.,0.\nMKAERO1,0.\n,.001,.05,.1,.2,.3,.5,.8,1.2\n\
         FLFACT,1,1.\nFLFACT,2,0.\n",
    );
    let _ = writeln!(deck, "AERO,{acsid},,.5,1.225,1\n{flutter}");
    deck
}

pub(crate) const PK: &str = "FLUTTER,6,PK,1,2,3\nFLFACT,3,5.,10.,15.,20.,25.,30.\n,35.,40.,45.,50.,55.,60.";

pub(crate) fn assembled(bulk: &BulkData) -> (FlutterDeck, Vec<FlutterPoints>, Vec<(f64, GafTable)>) {
    let (case, card) = flutter_cases(bulk).unwrap_or_else(|error| panic!("{error}")).remove(0);
    let deck = FlutterDeck::new(bulk, &case).unwrap_or_else(|error| panic!("{error}"));
    let points = deck.points(bulk, &card).unwrap_or_else(|error| panic!("{error}"));
    let mut machs: Vec<f64> =
        points.iter().flat_map(FlutterPoints::machs).map(|m| deck.modal.nearest_mach(m)).collect();
    machs.dedup();
    let tables = machs.into_iter().map(|m| (m, deck.forces(m).expect("forces"))).collect();
    (deck, points, tables)
}

pub(crate) fn curves(bulk: &BulkData) -> CompleteCurves {
    let (deck, points, tables) = assembled(bulk);
    match deck.roots(&points[0], &tables).expect("roots") {
        FlutterRoots::Curves(curves) => curves,
        FlutterRoots::ByFrequency(_) => panic!("the deck asks for airspeeds"),
    }
}

#[test]
fn a_deck_turned_with_its_stream_has_the_same_roots() {
    let straight = curves(&wing(&Rotation3::identity(), 0, PK));
    let flutter = straight.flutter().expect("it flutters");
    for axis_angle in [Vector3::z() * std::f64::consts::PI, Vector3::new(0.3, -0.7, 2.0)] {
        let turn = Rotation3::new(axis_angle);
        let turned = curves(&wing(&turn, 9, PK));
        assert_eq!(turned.branches.len(), straight.branches.len());
        for (a, b) in straight.branches.iter().zip(&turned.branches) {
            for (one, other) in a.roots.iter().zip(&b.roots) {
                assert!((one.p - other.p).norm() < 1e-6 * one.p.norm(), "{one:?} {other:?}");
            }
        }
        let other = turned.flutter().expect("it flutters");
        assert!((other.flow.v_m_s / flutter.flow.v_m_s - 1.0).abs() < 1e-8, "{flutter:?} {other:?}");
    }
}

#[test]
fn a_stream_from_behind_is_another_wing() {
    // Turned half round, but with the stream along basic x the wing flies backwards.
    let half = Rotation3::new(Vector3::z() * std::f64::consts::PI);
    let [forwards, backwards] = [curves(&wing(&half, 9, PK)), curves(&wing(&half, 0, PK))];
    let speed =
        |curves: &CompleteCurves| curves.flutter().map_or(f64::INFINITY, |flutter| flutter.flow.v_m_s);
    assert!(
        (speed(&forwards) / speed(&backwards) - 1.0).abs() > 0.05,
        "{} {}",
        speed(&forwards),
        speed(&backwards)
    );
}

#[test]
fn k_and_ke_find_the_flutter_of_pk() {
    let flutter = *curves(&wing(&Rotation3::identity(), 0, PK)).flutter().expect("it flutters");
    let k = flutter.omega_rad_s * 0.25 / flutter.flow.v_m_s;
    for method in ["K", "KE"] {
        let bulk = wing(&Rotation3::identity(), 0, &format!("FLUTTER,6,{method},1,2,3\nFLFACT,3,{k:.14}"));
        let (deck, points, tables) = assembled(&bulk);
        let Ok(FlutterRoots::ByFrequency(list)) = deck.roots(&points[0], &tables) else {
            panic!("the deck asks for reduced frequencies")
        };
        let off = |root: &&KRoot| (root.v_m_s / flutter.flow.v_m_s - 1.0).abs();
        let root = list[0].1.iter().min_by(|a, b| off(a).total_cmp(&off(b))).expect("roots");
        assert!(off(&root) < 1e-6 && root.g.abs() < 1e-6, "{root:?} {flutter:?}");
    }
}

/// Of one mode, a damper at the tip is the modal damping that its share of the mode makes: that of SDAMPING with the same 1/s.
#[test]
fn a_damper_is_the_damping_of_the_modes_that_move_it() {
    const STRUCTURAL: f64 = 0.04;
    let text = wing_text(&Rotation3::identity(), 0, PK)
        .replace("PARAM,COUPMASS,1", "PARAM,COUPMASS,1\nPARAM,LMODES,1");
    let bare = parse_deck("wing", &text).expect("a deck");
    let modal = assembled(&bare).0.modal;
    assert_eq!((modal.omega_rad_s.len(), modal.damping[(0, 0)]), (1, 0.0));
    let damped = |cards: &str, command: &str| {
        let text = text.replace("BEGIN BULK\n", &format!("{command}BEGIN BULK\n{cards}"));
        parse_deck("wing", &text).unwrap_or_else(|error| panic!("{error}"))
    };
    let table =
        damped(&format!("TABDMP1,7,G,,,,,,\n,0.,{STRUCTURAL},100.,{STRUCTURAL},ENDT\n"), "SDAMPING = 7\n");
    // A damper of one at the tip shows the square of the mode there.
    let of_one = assembled(&damped("CDAMP2,900,1.,9,3\n", "")).0.modal.damping[(0, 0)];
    let size = STRUCTURAL * modal.omega_rad_s[0] / of_one;
    for cards in [
        format!("CDAMP2,900,{size:.13},9,3\n"),
        format!("CDAMP1,900,901,9,3\nPDAMP,901,{size:.13}\n"),
        // The clamped root is the ground.
        format!("CBUSH,900,901,9,,,,,0\nPBUSH,901,B,,,{size:.13}\n"),
        format!("GRID,900,,.2,2.,-1.,,123456\nCVISC,900,901,900,9\nPVISC,901,{size:.13}\n"),
    ] {
        let bulk = damped(&cards, "");
        assert_eq!(assembled(&bulk).0.modal.dampers.len(), 1, "{cards}");
        for (a, b) in curves(&table).branches.iter().zip(&curves(&bulk).branches) {
            for (one, other) in a.roots.iter().zip(&b.roots) {
                assert!((one.p - other.p).norm() < 1e-9 * one.p.norm(), "{cards}{one:?} {other:?}");
            }
        }
    }
    // And it damps.
    let growth = |bulk: &BulkData| curves(bulk).branches[0].roots[0].p.re;
    assert!(growth(&table) < growth(&bare));
}

#[test]
fn points_are_those_of_the_lists() {
    let bulk = wing(&Rotation3::identity(), 0, "FLUTTER,6,PK,4,2,3\nFLFACT,3,20.,10.,-20.\nFLFACT,4,1.,.5");
    let points = assembled(&bulk).1;
    let flow = |v_m_s: f64, rho_kg_m3: f64| Flow { v_m_s, rho_kg_m3 };
    let speeds =
        |rho: f64| FlutterPoints::Speeds { mach: 0.0, flows: vec![flow(10.0, rho), flow(20.0, rho)] };
    assert_eq!(points, [speeds(1.225), speeds(0.6125)]);
    let uneven = wing(&Rotation3::identity(), 0, "FLUTTER,6,PKNL,1,2,3\nFLFACT,3,20.,10.");
    let (case, card) = flutter_cases(&uneven).expect("a case").remove(0);
    let deck = FlutterDeck::new(&uneven, &case).expect("a deck");
    let error = deck.points(&uneven, &card).expect_err("lists of different lengths");
    assert!(error.to_string().contains("1 density ratios, 1 Mach numbers and 2 airspeeds"), "{error}");
}

#[test]
fn what_flutter_needs_is_asked_for_by_its_name() {
    let mut bulk = wing(&Rotation3::identity(), 0, PK);
    let case = flutter_cases(&bulk).expect("a case").remove(0).0;
    let why = |change: &dyn Fn(&mut BulkData)| {
        let mut bulk = bulk.clone();
        change(&mut bulk);
        FlutterDeck::new(&bulk, &case).expect_err("a card is missing").to_string()
    };
    assert!(why(&|bulk| bulk.unsteady_reference = None).contains("no AERO"));
    assert!(why(&|bulk| bulk.reduced_frequencies.clear()).contains("no MKAERO1"));
    assert!(why(&|bulk| bulk.panels.clear()).contains("no CAERO1"));
    bulk.flutters.clear();
    assert!(
        flutter_cases(&bulk).expect_err("no FLUTTER").to_string().contains("FMETHOD 6, which is not there")
    );
}

/// The rigid plate of data/published/flutter__flutter_0012_pknl.json as a deck: heave and pitch springs at the leading edge, the
/// lumped mass of its elements, SPLINE1. The print has the forces of Mach 0.4 (tests/README.md).
pub(crate) fn plate(rows: &[Vec<f64>]) -> String {
    let (mass, x) = (280.0, [0.0, 0.333, 0.667, 1.0]);
    let mut deck = String::from(
        "SOL 145\nCEND\nSPC = 1\nMETHOD = 5\nFMETHOD = 6\nBEGIN BULK\nGRID,5,,0.,10.,0.\nGRID,6,,1.,10.,0.\n\
         RBE2,9,1,123456,2,3,4,5,6\nCELAS2,1,1.+5,1,3\nCELAS2,2,1.+5,1,5\nSPC1,1,1246,1\nEIGRL,5,,,2\n\
         AERO,0,1.,1.,1.\nCAERO1,1001,1,,20,5,,,1\n,0.,0.,0.,1.,0.,10.,0.,1.\nPAERO1,1\nSET1,30,1,4,5,6\n\
         SPLINE1,20,1001,1001,1100,30\nMKAERO1,.4\n,.001,.005,.01,.02,.03,.05,.07,.1\nMKAERO1,.4\n,.2,.3,.5,.7,1.,2.,3.,5.\n\
         FLUTTER,6,PKNL,1,2,3\n",
    );
    for i in 0..4_usize {
        let left = if i > 0 { x[i] - x[i - 1] } else { 0.0 };
        let right = if i < 3 { x[i + 1] - x[i] } else { 0.0 };
        let _ = writeln!(deck, "GRID,{},,{:?},0.,0.", i + 1, x[i]);
        let _ = writeln!(deck, "CONM2,{},{},,{:?}", 10 + i, i + 1, 0.5 * mass * (left + right));
    }
    for (id, column) in [(1, 2), (2, 3), (3, 4)] {
        let _ = write!(deck, "FLFACT,{id}");
        for (i, row) in rows.iter().enumerate() {
            let newline = if i % 8 == 7 { "\n" } else { "" };
            let _ = write!(deck, "{newline},{:?}", row[column]);
        }
        deck.push('\n');
    }
    deck
}

/// The print's rows of both modes: reduced frequency, its inverse, density, Mach number, airspeed, damping, frequency.
pub(crate) fn printed() -> [Vec<Vec<f64>>; 2] {
    let path =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/published/flutter__flutter_0012_pknl.json");
    let case: Value = serde_json::from_str(&std::fs::read_to_string(path).expect("a case")).expect("JSON");
    ["1", "2"].map(|mode| {
        serde_json::from_value(case["expected"]["flutter"][mode]["rows"].clone()).expect("rows of numbers")
    })
}

/// Demands the oscillating roots of the print.
pub(crate) fn assert_printed(bulk: &BulkData, printed: &[Vec<Vec<f64>>; 2]) {
    let curves = curves(bulk);
    assert_eq!(curves.flows.len(), printed[0].len());
    let mut met = 0;
    for table in printed {
        for (place, row) in table.iter().enumerate() {
            // About to stop oscillating, where the frequency falls without bound, or stopped.
            if row[6] == 0.0 || row[5] < -3.0 {
                continue;
            }
            let roots = curves.branches.iter().filter_map(|branch| branch.at(place));
            let is_met = |root: &maneuver::flutter::Root| {
                let near = (root.frequency_hz() / row[6] - 1.0).abs() < 0.01;
                near && root.damping_g().is_some_and(|g| (g - row[5]).abs() < 0.01)
            };
            assert!(roots.clone().any(is_met), "{row:?}: {:?}", roots.collect::<Vec<_>>());
            met += 1;
        }
    }
    assert!(met > 100, "{met} of the print's roots oscillate");
}

#[test]
fn a_printed_matched_point_analysis_is_met_root_by_root() {
    let printed = printed();
    let bulk = parse_deck("plate", &plate(&printed[0])).unwrap_or_else(|error| panic!("{error}"));
    assert_printed(&bulk, &printed);
}
