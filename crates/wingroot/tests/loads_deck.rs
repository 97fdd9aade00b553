//! `loads --deck`: the plan of HA144A as a user runs it, its package at grids and at stations, its origin, and what is refused.

use crate::package_peers::{Cut, read_by_pynastran};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// HA144A's whole, the wing outboard of the fuselage, and the air's loads of all boxes.
const STATIONS: &str = "SET1,82,110,111,112,120,121,122\nMONPNT3,OUTER   ,wing\n,123456,82,,0,27.11325,5.,0.\n\
                        AECOMP,ALL,CAERO,1000,1100\nMONPNT1,AIR     ,all boxes\n,123456,ALL,0,15.,0.,0.\n";
const POUND_N: f64 = 4.448_221_615_260_5;

fn repository(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(name)
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("wingroot-loads-deck-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder of our own");
        let deck = read(&repository("data/published/decks/ha144a_fsw.bdf"));
        std::fs::write(folder.join("deck.bdf"), deck.replace("ENDDATA", &format!("{STATIONS}ENDDATA")))
            .expect("a file");
        std::fs::copy(repository("data/loads/loads_ha144a.ron"), folder.join("plan.ron")).expect("a copy");
        Self(folder)
    }

    /// The plan's trims alone.
    fn of_trims(name: &str) -> Self {
        let folder = Self::new(name);
        let plan = read(&folder.0.join("plan.ron"));
        let at = plan.find("        Discrete(").expect("gusts");
        let end = at + plan[at..].find("    ],").expect("an end");
        std::fs::write(folder.0.join("plan.ron"), plan[..at].to_owned() + &plan[end..]).expect("a file");
        folder
    }

    fn change(&self, file: &str, from: &str, to: &str) {
        let text = read(&self.0.join(file));
        assert!(text.contains(from), "{from}");
        std::fs::write(self.0.join(file), text.replacen(from, to, 1)).expect("a file");
    }

    fn loads(&self, words: &[&str]) -> Output {
        Command::new(env!("CARGO_BIN_EXE_wingroot"))
            .args(["loads", "--deck", "deck.bdf", "--plan", "plan.ron"])
            .args(words)
            .current_dir(&self.0)
            .output()
            .expect("the command starts")
    }

    fn flown(&self, out: &str, words: &[&str]) -> PathBuf {
        let output = self.loads(&[&["--out", out][..], words].concat());
        assert!(output.status.success(), "{}", said(&output));
        self.0.join(out)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned() + &String::from_utf8_lossy(&output.stdout)
}

fn rows(text: &str) -> Vec<Vec<&str>> {
    text.lines().filter(|line| !line.starts_with('#')).skip(1).map(|line| line.split(',').collect()).collect()
}

fn number(cell: &str) -> f64 {
    cell.parse().unwrap_or_else(|_| panic!("{cell} is no number"))
}

#[test]
fn a_plan_on_a_deck_is_trimmed_enveloped_selected_and_gives_cards_for_the_deck_s_structure() {
    let folder = Folder::new("whole");
    let out = folder.flown("out", &[]);
    let cases = read(&out.join("cases.csv"));
    let rows_of_cases = rows(&cases);
    assert_eq!(
        rows_of_cases.len(),
        2 * (6 + 4 + 40 + 1),
        "six corners, four gusts by Pratt, ten gradients at two speeds up and down and turbulence, at two altitudes: {cases}"
    );
    let flown: Vec<&Vec<&str>> = rows_of_cases.iter().filter(|row| row[10] == "flown").collect();
    assert!(flown.len() > 15 && !cases.contains(",failed,"), "{cases}");
    // the air carries the load factor times the weight: of half the aircraft, 8000 lb
    let monitors = read(&out.join("monitors.csv"));
    for row in rows(&monitors) {
        let case = flown.iter().find(|case| case[0] == row[1]).expect("it was flown");
        let (lift, expected) = (number(row[5]), number(case[7]) * 8000.0 * POUND_N);
        assert!(row[2] == "AIR" && (lift - expected).abs() < 2e-5 * 8000.0 * POUND_N, "{row:?} {expected}");
    }
    // neutral corrections: both models are one
    let envelope = read(&out.join("envelope.csv"));
    for station in ["OUTER", "root", "half", "whole"] {
        let of = |model: &str| -> Vec<String> {
            let own = rows(&envelope).into_iter().filter(|row| row[0] == model && row[1] == station);
            own.map(|row| row[2..].join(",")).collect()
        };
        assert!(of("updated").len() == 12 && of("updated") == of("initial"), "{station}: {envelope}");
    }
    gusts_and_turbulence(&out, &flown);
    let result: serde_json::Value = serde_json::from_str(&read(&out.join("result.json"))).expect("JSON");
    for key in ["stations", "balance", "tip", "structure", "repeat"] {
        let off = result["round_trip"][key].as_f64().expect("a number");
        assert!(off < 1e-9, "{key}: {off}");
    }
    let package = out.join("package");
    let deck = nastran::read_deck(&package.join("index.bdf")).expect("it is read");
    let sets = result["selected"].as_array().expect("a list").len();
    assert!(sets > 3 && deck.subcases.len() == sets && deck.beams.len() == 6 && deck.panels.is_empty());
    let held = deck.constraints.iter().find(|card| card.components == [3, 5]).expect("the SUPORT is held");
    assert_eq!(held.grids, [90]);
    // the half of an aircraft is held against its other half in its plane, so that the whole is not in balance there
    let cut =
        Cut { station: "root", beyond_y: 1.0 / 0.3048, about: 90, unit_loads: [POUND_N, POUND_N * 0.3048] };
    read_by_pynastran(&package, sets, &cut);
    let page = read(&out.join("report.html"));
    for words in [
        "V-n diagram",
        "Loads at OUTER",
        "Loads at whole",
        "Discrete gusts",
        "Continuous turbulence",
        "package/ holds index.bdf",
    ] {
        assert!(page.contains(words), "{words}");
    }
}

/// Gusts and turbulence are flown, drive loads, and go to stress with their cards.
fn gusts_and_turbulence(out: &Path, flown: &[&Vec<&str>]) {
    let of_kind = |kind: &str| flown.iter().filter(|row| row[1] == kind).count();
    assert!(of_kind("discrete") == 80 && of_kind("turbulence") == 2, "{flown:?}");
    let gusts = read(&out.join("gusts.csv"));
    let bending: Vec<Vec<&str>> =
        rows(&gusts).into_iter().filter(|row| row[2] == "root" && row[3] == "Mx_Nm").collect();
    // two models, two altitudes, two speeds, two directions, two ends
    assert_eq!(bending.len(), 32, "{gusts}");
    for row in bending.iter().filter(|row| row[4] == "largest") {
        let gradient_m = number(row[5]);
        assert!((8.9..107.1).contains(&gradient_m) && number(row[6]) > 0.0, "{row:?}");
    }
    let turbulence = read(&out.join("turbulence.csv"));
    for row in rows(&turbulence).iter().filter(|row| row[3] != "n_z") {
        let [one_g, a, u, smallest, largest] = [4, 5, 6, 7, 8].map(|at| number(row[at]));
        assert!((largest - one_g - u * a).abs() < 1e-6 * largest.abs().max(u * a), "{row:?}");
        assert!((one_g - smallest - u * a).abs() < 1e-6 * smallest.abs().max(u * a), "{row:?}");
    }
    assert!(turbulence.contains(",whole,n_z,") && read(&out.join("correlation.csv")).lines().count() > 10);
    let selected = read(&out.join("selected.csv"));
    let kinds: Vec<&str> = rows(&selected).into_iter().map(|row| row[6]).collect();
    for kind in ["discrete", "turbulence"] {
        assert!(kinds.contains(&kind), "{kind}: {selected}");
    }
    assert!(kinds.iter().any(|kind| ["corner", "pratt"].contains(kind)), "no trim: {selected}");
    let package = out.join("package");
    for (row, words) in rows(&selected).iter().filter_map(|row| match row[6] {
        "discrete" => Some((row.clone(), "gust ")),
        "turbulence" => Some((row.clone(), "at its limit, and the loads that go with it")),
        _ => None,
    }) {
        let card = read(&package.join(format!("case_{:0>5}.bdf", row[0])));
        assert!(card.contains(words) && card.contains("FORCE*"), "{row:?}");
    }
}

#[test]
fn loads_condensed_to_stations_add_up_to_every_cut() {
    let folder = Folder::of_trims("stations");
    std::fs::write(
        folder.0.join("select.ron"),
        "Select(policies: [Envelope()], export: (at: Stations, components: [Air, Inertia]))",
    )
    .expect("a file");
    let out = folder.flown("out", &["--select", "select.ron"]);
    let package = out.join("package");
    assert!(!read(&package.join("round_trip.csv")).contains("not reproduced"));
    assert!(!package.join("aircraft.bdf").exists());
    // in pounds and feet at four grids; cuts of case_00001 by hand: points inside a cut, moved to it
    let index = nastran::read_deck(&package.join("index.bdf")).expect("it is read");
    let places: Vec<(u32, [f64; 3])> =
        index.grids.iter().map(|(id, grid)| (*id, [grid.xyz.x, grid.xyz.y, grid.xyz.z])).collect();
    assert_eq!(places.len(), 4, "OUTER, root, half, whole");
    let mut at: BTreeMap<u32, [f64; 6]> = BTreeMap::new();
    let parts: Vec<u32> = index.load_sums[&1].parts.iter().map(|(_, set)| *set).collect();
    for card in index.point_loads.iter().filter(|card| parts.contains(&card.set)) {
        let six = at.entry(card.grid).or_default();
        let from = if card.is_moment { 3 } else { 0 };
        (0..3).for_each(|axis| six[from + axis] += card.vector[axis]);
    }
    let about = |cut: [f64; 3], inside: &[usize]| {
        let mut sum = [0.0; 6];
        for &place in inside {
            let (id, r) = places[place];
            let six = at.get(&id).copied().unwrap_or_default();
            let arm = [0, 1, 2].map(|axis| r[axis] - cut[axis]);
            let cross = [
                arm[1] * six[2] - arm[2] * six[1],
                arm[2] * six[0] - arm[0] * six[2],
                arm[0] * six[1] - arm[1] * six[0],
            ];
            (0..3).for_each(|axis| sum[axis] += six[axis]);
            (0..3).for_each(|axis| sum[3 + axis] += six[3 + axis] + cross[axis]);
        }
        sum
    };
    let table = read(&package.join("station_loads.csv"));
    let net = |station: &str| -> Vec<f64> {
        let row = rows(&table).into_iter().find(|row| row[0] == "1" && row[4] == station && row[5] == "net");
        row.expect("a row")[6..].iter().map(|cell| number(cell)).collect()
    };
    // OUTER and root have the same grids, beyond y = 1 m; half those beyond y = 3 m
    for (station, place, inside) in
        [("OUTER", 0, &[0, 1, 2][..]), ("root", 1, &[1, 2]), ("half", 2, &[2]), ("whole", 3, &[0, 1, 2, 3])]
    {
        let (sum, known) = (about(places[place].1, inside), net(station));
        let size = net("OUTER").iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        for (load, value) in sum.iter().enumerate() {
            let unit = if load < 3 { POUND_N } else { POUND_N * 0.3048 };
            assert!((unit * value - known[load]).abs() < 1e-8 * size, "{station} {load}: {value} {known:?}");
        }
    }
}

#[test]
fn a_changed_byte_of_an_input_changes_the_fingerprint_in_every_file_of_the_package() {
    let folder = Folder::of_trims("origin");
    let files = |out: &Path| -> BTreeMap<String, Vec<u8>> {
        let all = std::fs::read_dir(out.join("package")).expect("a package").flatten();
        let of = |entry: std::fs::DirEntry| {
            let bytes = std::fs::read(entry.path()).expect("a file");
            (entry.file_name().to_string_lossy().into_owned(), bytes)
        };
        all.map(of).collect()
    };
    let print = |bytes: &[u8], what: &str| -> String {
        let text = String::from_utf8_lossy(bytes).into_owned();
        let at = text.find(what).unwrap_or_else(|| panic!("no {what}"));
        text[at + what.len()..].split_whitespace().next().expect("a fingerprint").to_owned()
    };
    let first = files(&folder.flown("first", &[]));
    assert_eq!(first, files(&folder.flown("same", &[])), "same inputs, same bytes");
    // a comment, and nothing that any number depends on
    for (file, from, to, what) in [
        ("deck.bdf", "$ FSW aircraft", "$ fSW aircraft", "deck deck.bdf "),
        ("plan.ron", "// A plan of design", "// a plan of design", "plan plan.ron "),
    ] {
        let before = files(&folder.flown("before", &[]));
        folder.change(file, from, to);
        let after = files(&folder.flown("after", &[]));
        assert!(before.keys().eq(after.keys()) && before.len() > 8);
        for (name, bytes) in &before {
            assert!(
                bytes.windows(9).any(|nine| nine.eq_ignore_ascii_case(b"wingroot ")),
                "{name} has no version"
            );
            assert_ne!(print(bytes, what), print(&after[name], what), "{name}: {what}");
        }
    }
}

#[test]
fn what_a_deck_cannot_fly_is_listed_and_a_plan_of_other_units_or_masses_is_refused() {
    let folder = Folder::of_trims("refused");
    folder.change(
        "plan.ron",
        "Pratt(at: [VC, VD]),",
        "Pratt(at: [VC, VD]), Discrete(at: [VC], gradients_m: Of([30.0]), directions: [Up, Lateral]),",
    );
    let out = folder.flown("out", &["--matrix-only"]);
    let cases = read(&out.join("cases.csv"));
    let left = rows(&cases).into_iter().filter(|row| row[1] == "discrete");
    let left: Vec<Vec<&str>> = left.collect();
    assert!(
        left.len() == 4
            && left.iter().all(|row| row[8].contains("lateral")
                == (row[10] == "left_out" && row[11].contains("half of an aircraft"))),
        "{cases}"
    );
    for (from, to, words) in [
        ("length_m: 0.3048", "length_m: 1.0", "not level flight"),
        ("mass_kg: 7257.478", "mass_kg: 7300.0", "7257.4"),
        ("mass_kg: 7257.478", "mass_kg: 7257.478, x_cg_m: 4.0", "those of the deck"),
        ("trim: Some(1)", "trim: Some(3)", "no TRIM"),
        ("force_N: 4.4482216152605", "force_N: 0.0", "above zero"),
        ("y_m: 3.0", "y_m: 30.0", "no grid outboard"),
        (", modes_up_to_hz: Some(1000.0)", "", "nothing says which"),
        ("modes_up_to_hz: Some(1000.0)", "modes_up_to_hz: Some(0.0)", "above zero"),
    ] {
        let before = read(&folder.0.join("plan.ron"));
        folder.change("plan.ron", from, to);
        let output = folder.loads(&["--out", "none"]);
        assert_eq!(output.status.code(), Some(2), "{words}: {}", said(&output));
        assert!(
            said(&output).contains(words) && !folder.0.join("none").exists(),
            "{words}: {}",
            said(&output)
        );
        std::fs::write(folder.0.join("plan.ron"), before).expect("a file");
    }
}
