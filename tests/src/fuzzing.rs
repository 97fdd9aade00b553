//! What reads input of users, as functions of bytes: for the fuzz targets in `fuzz` and for the bounded run of
//! mutations among the tests. Whatever the bytes, each ends soon, with a result or an `InputError`.

use calibrate::{Campaign, Schedule, StaticData};
use coupling::WingFile;
use fullaircraft::AircraftFile;
use maneuver::{ManeuverFile, Run};
use nastran::Table;
use std::path::{Path, PathBuf};

/// A reader's name, which is that of its fuzz target and of its folder of seeds, and its function.
pub type EntryPoint = (&'static str, fn(&[u8]));

/// All of them.
pub const ENTRY_POINTS: [EntryPoint; 8] = [
    ("deck", deck),
    ("dmi", dmi),
    ("table", table),
    ("campaign", campaign),
    ("wing", wing),
    ("corrections", corrections),
    ("aircraft", aircraft),
    ("maneuver", maneuver),
];

/// A deck: cards, coordinate systems, boxes, the model of the structure, and its text again.
pub fn deck(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    let Ok(bulk) = nastran::parse_deck("fuzz.bdf", &text) else { return };
    // Bad decks end in an error here or there; what counts is that they end.
    let _ = aero::Lattice::from_bulk(&bulk);
    let _ = structure::Model::from_bulk(&bulk);
    let _ = nastran::write_deck(&bulk);
}

/// Matrices: read, written and read again; corrections from them.
///
/// # Panics
/// If a matrix that was read cannot be read again from its own text.
pub fn dmi(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    let Ok(bulk) = nastran::parse_deck("fuzz.bdf", &text) else { return };
    for matrix in bulk.matrices.values().filter(|matrix| matrix.rows * matrix.columns.len() < 10_000) {
        let again = nastran::parse_deck("again.bdf", &matrix.write()).expect("our own cards can be read");
        assert_eq!(again.matrices.get(&matrix.name), Some(&matrix.rounded_to_fields()));
    }
    if let (Some(wkk), Some(fa2j)) = (bulk.matrices.get("WKK"), bulk.matrices.get("FA2J")) {
        let _ = aero::Corrections::from_dmi(wkk, fa2j);
    }
}

/// A table, and a table as a run.
///
/// # Panics
/// If a number that is not finite comes out of a cell.
pub fn table(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    if let Ok(table) = Table::parse("fuzz.csv", &text) {
        let columns: Vec<String> = table.columns().map(str::to_owned).collect();
        for column in columns.iter().take(50) {
            let numbers = table.numbers(column).unwrap_or_default();
            assert!(numbers.iter().all(|number| number.is_finite()), "{column}");
        }
    }
    let _ = Run::read(&written("run.csv", bytes));
}

/// A campaign: as `campaign.ron` beside a good table, and as the table beside a good `campaign.ron`.
pub fn campaign(bytes: &[u8]) {
    for (name, other) in [("campaign.ron", "static.csv"), ("static.csv", "campaign.ron")] {
        let folder = scratch().join(name);
        // A disk that refuses is not what is tested.
        let _ = std::fs::create_dir_all(&folder);
        let _ = std::fs::copy(crate::data("own_wing/campaign").join(other), folder.join(other));
        let _ = std::fs::write(folder.join(name), bytes);
        if let Ok(campaign) = Campaign::read(&folder) {
            let _ = StaticData::from_campaign(&campaign);
        }
    }
}

/// A wing's file, beside the section and beam of the example.
pub fn wing(bytes: &[u8]) {
    for name in ["section.dat", "beam.csv"] {
        let to = scratch().join(name);
        if !to.exists() {
            let _ = std::fs::copy(crate::data("own_wing").join(name), to);
        }
    }
    let _ = WingFile::read(&written("wing.ron", bytes));
}

/// A file of corrections.
pub fn corrections(bytes: &[u8]) {
    let _ = Schedule::read(&written("corrections.ron", bytes));
}

/// An aircraft's file.
pub fn aircraft(bytes: &[u8]) {
    let _ = AircraftFile::read(&written("aircraft.ron", bytes));
}

/// A maneuver's file.
pub fn maneuver(bytes: &[u8]) {
    let _ = ManeuverFile::read(&written("maneuver.ron", bytes));
}

/// A folder of this process.
pub fn scratch() -> PathBuf {
    let folder = std::env::temp_dir().join(format!("wingroot-fuzz-{}", std::process::id()));
    // A disk that refuses is not what is tested.
    let _ = std::fs::create_dir_all(&folder);
    folder
}

/// The bytes as a file of that name.
fn written(name: &str, bytes: &[u8]) -> PathBuf {
    let path = scratch().join(name);
    let _ = std::fs::write(&path, bytes);
    path
}

/// The seeds of an entry point: name and bytes, in the order of their names.
///
/// # Panics
/// If the folder of seeds cannot be read: the test's own fault.
pub fn seeds(entry_point: &str) -> Vec<(String, Vec<u8>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/corpus").join(entry_point);
    let mut paths: Vec<PathBuf> = std::fs::read_dir(&folder)
        .expect("every entry point has seeds")
        .flatten()
        .map(|entry| entry.path())
        .collect();
    paths.sort();
    let named = |path: &PathBuf| {
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        (name, std::fs::read(path).expect("a seed can be read"))
    };
    paths.iter().map(named).collect()
}
