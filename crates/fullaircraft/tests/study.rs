//! What a study adds to decks: the published aircraft without the cards of its trim, trimmed by a study, has the published angles.

use fullaircraft::study::{Aim, MassTerms, Masses, Splines, Study};
use fullaircraft::{TrimDeck, TrimmedDeck, deck_cases};
use std::path::{Path, PathBuf};

/// A folder of its own with the bulk data of HA144A but for what a study gives, changed; and a study beside it.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str, change: &[(&str, &str)]) -> Self {
        let folder = std::env::temp_dir().join(format!("wingroot_study_{}_{name}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder");
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/published/decks/ha144a_fsw.bdf");
        let text = std::fs::read_to_string(path).expect("the shipped deck");
        let (_, bulk) = text.split_once("BEGIN BULK\n").expect("bulk data");
        let given =
            ["SUPORT,", "AEROS,", "AESTAT,", "TRIM,", "+T1,", "+T2,", "SPC1,1,1246", "PAERO1,", "ENDDATA"];
        let kept = bulk.lines().filter(|line| given.iter().all(|start| !line.starts_with(start)));
        let mut bulk = kept.collect::<Vec<_>>().join("\n") + "\n";
        for (from, to) in change {
            assert!(bulk.contains(from), "{from}");
            bulk = bulk.replace(from, to);
        }
        std::fs::write(folder.join("aircraft.bdf"), bulk).expect("a deck");
        Self(folder)
    }

    fn study(&self, text: &str) -> Result<Study, String> {
        let path = self.path();
        std::fs::write(&path, text).expect("a study");
        Study::read(&path).map_err(|error| error.to_string())
    }

    fn path(&self) -> PathBuf {
        self.0.join("study.ron")
    }

    fn trims(&self, study: &Study, terms: Option<&MassTerms>) -> Vec<TrimmedDeck> {
        let deck = study.deck(&self.path(), Aim::Trims, terms).expect("a deck");
        let cases = deck_cases(&deck.bulk).expect("trims");
        let trim = |case: &fullaircraft::DeckCase| {
            let bulk = deck.bulk.in_subcase(&case.subcase).expect("a subcase");
            TrimDeck::new(&bulk, case.trim.mach).expect("an aircraft").trim_card(&case.trim).expect("a trim")
        };
        cases.iter().map(trim).collect()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// AUNITS of the deck makes accelerations multiples of gravity.
const STUDY: &str = r#"(
    decks: ["aircraft.bdf"],
    spc: 1,
    gravity: 1.0,
    reference: (area: 200.0, chord: 10.0, span: 40.0, point: (15.0, 0.0, 0.0), is_half: true),
    support: 90,
    controls: [(name: "canard", moves: [("ELEV", 1.0)])],
    trims: [
        (name: "slow", mach: 0.9, v: 1000.0, rho: 8e-5, free: ["canard"]),
        (name: "fast", mach: 0.9, v: 1000.0, rho: 2.4e-3, free: ["canard"]),
    ],
)"#;

/// Published: MSC.Nastran Aeroelastic Analysis User's Guide, listing 7-2 (rad), at dynamic pressures of 40 and 1200.
const PUBLISHED: [[f64; 2]; 2] = [[0.169_191, 0.492_456_7], [0.001_373_015, 0.019_324_95]];

#[track_caller]
fn assert_published(trims: &[TrimmedDeck], digits: f64) {
    assert_eq!(trims.len(), 2);
    for (trim, [alpha, canard]) in trims.iter().zip(PUBLISHED) {
        let found = [trim.values["ANGLEA"], trim.values["ELEV"]];
        assert!(
            (found[0] - alpha).abs() < digits && (found[1] - canard).abs() < digits,
            "{found:?} {alpha} {canard}"
        );
    }
}

#[test]
fn the_published_aircraft_is_trimmed_without_the_cards_of_its_trim() {
    let folder = Folder::new("published", &[]);
    let study = folder.study(STUDY).expect("a study");
    assert_published(&folder.trims(&study, None), 2e-6);
}

#[test]
fn a_mass_matrix_stands_in_the_place_of_the_decks_masses() {
    // pounds of the deck's CONM2 are masses in the matrix
    let lumps = [
        (97, 1500.0),
        (98, 1500.0),
        (99, 1500.0),
        (100, 1500.0),
        (111, 600.0),
        (112, 400.0),
        (121, 600.0),
        (122, 400.0),
    ];
    let terms = lumps.iter().flat_map(|(grid, weight)| {
        (1..=3).map(move |component| ((*grid, component), (*grid, component), weight * 0.031_081))
    });
    let terms = MassTerms::Motions(terms.collect());
    // other masses of the deck count for nothing
    let folder = Folder::new("matrix", &[(",0,1500.", ",0,99."), ("PARAM,WTMASS,.031081\n", "")]);
    let text = STUDY.replace("spc: 1", "spc: 1, masses: Matrix(\"mass.csv\")");
    let study = folder.study(&text).expect("a study");
    assert_eq!(study.masses, Masses::Matrix("mass.csv".into()));
    assert_published(&folder.trims(&study, Some(&terms)), 2e-6);
    let weighed = Folder::new("weighed", &[]);
    let study = weighed.study(&text).expect("a study");
    let error = study.deck(&weighed.path(), Aim::Trims, Some(&terms)).expect_err("weights").to_string();
    assert!(error.contains("PARAM WTMASS") && error.contains("study.ron:3:"), "{error}");
}

#[test]
fn boxes_that_follow_their_nearest_grid_move_as_on_a_rigid_arm() {
    // so stiff that nothing bends: the angles are those of a rigid aircraft whatever moves the boxes
    let stiff = [("MAT1,1,1.44+9,5.40+8", "MAT1,1,1.44+19,5.40+18")];
    let folder = Folder::new("rigid", &stiff);
    let by_splines = folder.study(STUDY).expect("a study");
    let nearest = Study { splines: Splines::Nearest, ..by_splines.clone() };
    let bare = Folder::new("nearest", &[stiff[0], ("SPLINE2,", "$ "), ("+S", "$ ")]);
    for (a, b) in folder.trims(&by_splines, None).iter().zip(bare.trims(&nearest, None)) {
        for label in ["ANGLEA", "ELEV"] {
            assert!(
                (a.values[label] / b.values[label] - 1.0).abs() < 1e-6,
                "{label} {:?} {:?}",
                a.values,
                b.values
            );
        }
    }
    // and sets leave out grids
    let of_canard = Study { splines: Splines::NearestOf(vec![1000]), ..by_splines.clone() };
    let deck = of_canard.deck(&bare.path(), Aim::Trims, None).expect("a deck");
    let grids: Vec<u32> =
        deck.bulk.splines.values().flat_map(|card| deck.bulk.sets[&card.set].ids.clone()).collect();
    assert_eq!(deck.bulk.splines.len(), 2 + usize::from(grids.len() > 2), "{grids:?}");
    assert!(grids.iter().all(|grid| [98, 99].contains(grid)), "{grids:?}");
    let boxes: usize = deck
        .bulk
        .splines
        .values()
        .map(|card| deck.bulk.box_lists[&card.list.expect("a list")].boxes.len())
        .sum();
    assert_eq!(boxes, 40);
}

#[test]
fn two_surfaces_of_a_control_go_by_their_factors_and_others_are_held() {
    let halves = [(
        "AELIST,1000,1000,THRU,1007\nAESURF,505,ELEV,1,1000\n",
        "AELIST,1000,1000,THRU,1003\nAELIST,1001,1004,THRU,1007\nAESURF,505,ELEV,1,1000\nAESURF,506,OUTER,1,1001\n",
    )];
    let folder = Folder::new("halves", &halves);
    let both = STUDY.replace("(\"ELEV\", 1.0)", "(\"ELEV\", 2.0), (\"OUTER\", 2.0)");
    let trims = folder.trims(&folder.study(&both).expect("a study"), None);
    assert_published(&trims, 2e-6);
    assert!((trims[0].values["OUTER"] / trims[0].values["ELEV"] - 1.0).abs() < 1e-9);
    let against = STUDY.replace("(\"ELEV\", 1.0)", "(\"ELEV\", 1.0), (\"OUTER\", -0.5)");
    let trims = folder.trims(&folder.study(&against).expect("a study"), None);
    assert!((trims[0].values["OUTER"] / trims[0].values["ELEV"] + 0.5).abs() < 1e-9);
    let held = STUDY
        .replace("[(\"ELEV\", 1.0)])", "[(\"ELEV\", 1.0)]), (name: \"outer\", moves: [(\"OUTER\", 1.0)])")
        .replace("free: [\"canard\"]", "free: [\"canard\"], held_deg: {\"outer\": 3.0}");
    let trims = folder.trims(&folder.study(&held).expect("a study"), None);
    assert!((trims[1].values["OUTER"] - 3.0_f64.to_radians()).abs() < 1e-9, "{:?}", trims[1].values);
}

#[test]
fn what_is_not_there_is_said_where_it_stands() {
    let folder = Folder::new("refused", &[]);
    let of_study = |from: &str, to: &str| folder.study(&STUDY.replacen(from, to, 1));
    for (from, to, said) in [
        ("decks: [\"aircraft.bdf\"]", "decks: []", "without decks"),
        ("free: [\"canard\"]", "free: []", "slow has 0 free controls, 1 balance it"),
        ("free: [\"canard\"]", "free: [\"rudder\"]", "there is no control rudder (hint: there are canard)"),
        ("rho: 8e-5", "rho: 0.0", "above zero is expected"),
        ("(\"ELEV\", 1.0)", "(\"ELEV\", 0.0)", "moves no surface at first"),
        ("support:", "suport:", "suport"),
        ("gravity: 1.0,", "", "trims need `gravity`"),
        ("support: 90,", "", "trims need `support`"),
        ("span: 40.0, ", "", "trims need `reference: (area"),
        ("free: [\"canard\"]", "free: [\"canard\"], held_deg: {\"canard\": 1.0}", "or is held as well"),
        ("free: [\"canard\"]", "balance: AllAxes, free: [\"canard\"]", "neither rolls nor yaws"),
    ] {
        let error = of_study(from, to).expect_err(said);
        assert!(error.contains(said) && error.contains("study.ron"), "{error}");
    }
    for (from, to, said) in [
        ("support: 90", "support: 91", "GRID 91 is not in the decks"),
        ("\"ELEV\"", "\"FLAP\"", "AESURF FLAP is not in the decks (hint: there are ELEV)"),
        ("aircraft.bdf", "gone.bdf", "gone.bdf"),
    ] {
        let study = of_study(from, to).expect("well written");
        let error = study.deck(&folder.path(), Aim::Trims, None).expect_err(said).to_string();
        assert!(error.contains(said), "{error}");
    }
    let own = Folder::new("own", &[]);
    let deck = own.0.join("aircraft.bdf");
    let cards = std::fs::read_to_string(&deck).expect("the deck") + "SUPORT,90,35\n";
    std::fs::write(&deck, cards).expect("a deck");
    let study = own.study(STUDY).expect("a study");
    let error = study.deck(&own.path(), Aim::Trims, None).expect_err("two supports").to_string();
    assert!(error.contains("a SUPORT of their own, at grid 90"), "{error}");
    std::fs::write(folder.0.join("whole.bdf"), "CEND\nBEGIN BULK\nGRID,90\n").expect("a deck");
    let whole = of_study("aircraft.bdf", "whole.bdf").expect("well written");
    let error = whole.deck(&folder.path(), Aim::Trims, None).expect_err("a case control").to_string();
    assert!(error.contains("no case control of its own"), "{error}");
}
