//! Rows by hand: the tables beside this file, and files and sizes that no table can hold.

use super::row::Change::{Folder, Gone};
use super::row::{End, Row, text, whole};

/// What the tables abbreviate.
const SHORT: [(&str, &str); 2] =
    [("$C", "--corrections corrections.ron"), ("$RUN", "campaign/pitch_1hz_20.csv")];

/// Files that the example of `new` does not have.
pub(crate) fn added() -> Vec<(&'static str, String)> {
    let polars = "e214_neuralfoil_polars.csv";
    let runs = include_str!("../../../../data/own_wing/made_with/tunnel.ron");
    let runs = runs.replace("../wing.ron", "wing.ron").replace(&format!("../../tuflex/{polars}"), polars);
    let files = [
        ("cases.ron", include_str!("example/cases.ron")),
        ("deck_wing.ron", include_str!("example/deck_wing.ron")),
        ("maneuver.ron", include_str!("example/maneuver.ron")),
        ("measured.ron", include_str!("example/measured.ron")),
        ("points.csv", include_str!("../../../../data/factorials/tensile.csv")),
        ("response.ron", include_str!("example/response.ron")),
        ("wing.bdf", include_str!("example/wing.bdf")),
        (polars, include_str!("../../../../data/tuflex/e214_neuralfoil_polars.csv")),
    ];
    files.map(|(name, text)| (name, text.to_owned())).into_iter().chain([("tunnel.ron", runs)]).collect()
}

/// The rows.
pub(crate) fn rows() -> Vec<Row> {
    let texts = cells(include_str!("texts.txt")).map(|row| match row.as_slice() {
        [command, file, from, to, said] => refused(command, file, text(from, to), said),
        _ => panic!("{row:?} has not five cells"),
    });
    let files = cells(include_str!("files.txt")).map(|row| match row.as_slice() {
        [command, file, content, said] => refused(command, file, whole(content.as_str()), said),
        _ => panic!("{row:?} has not four cells"),
    });
    let options = cells(include_str!("options.txt")).map(|row| match row.as_slice() {
        [command, said] => refused(command, "", whole(""), said),
        _ => panic!("{row:?} has not two cells"),
    });
    let stopped = [refused(
        "calibrate --wing deck_wing.ron --campaign campaign",
        "wing.bdf",
        text("SPC1,1,123456,1\n", ""),
        "free to move",
    )];
    let stopped = stopped.map(|row| row.ending(End::Stopped));
    texts.chain(files).chain(options).chain(stopped).chain(spoilt()).chain(large()).collect()
}

fn refused(command: &str, file: &str, change: super::row::Change, said: &str) -> Row {
    Row::refused(command, file, change, &said.split(" & ").collect::<Vec<_>>())
}

/// The cells of a table's rows.
fn cells(table: &str) -> impl Iterator<Item = Vec<String>> {
    let lines = table.lines().filter(|line| !line.starts_with('#'));
    lines.map(|line| {
        line.split('|')
            .map(|cell| {
                let cell = SHORT
                    .iter()
                    .fold(cell.trim().to_owned(), |cell, (short, long)| cell.replace(short, long));
                cell.replace("\\n", "\n").replace("\\t", "\t")
            })
            .collect()
    })
}

/// Each file that a command reads: not there, a folder, empty, no text, nested without end, a line without end.
fn spoilt() -> Vec<Row> {
    let mut rows = Vec::new();
    for (command, file) in [
        ("calibrate", "wing.ron"),
        ("calibrate", "section.dat"),
        ("calibrate", "beam.csv"),
        ("calibrate", "campaign/campaign.ron"),
        ("calibrate", "campaign/static.csv"),
        ("simulate $C --run $RUN", "$RUN"),
        ("simulate $C --run $RUN", "corrections.ron"),
        ("simulate $C --maneuver maneuver.ron", "maneuver.ron"),
        ("fullaircraft $C --cases cases.ron", "cases.ron"),
        ("fullaircraft $C", "aircraft.ron"),
        ("modes --measured measured.ron", "measured.ron"),
        ("modes --deck wing.bdf", "wing.bdf"),
        ("modes --wing deck_wing.ron", "wing.bdf"),
        ("response --data response.ron", "response.ron"),
        ("response --data response.ron", "points.csv"),
        ("tunnel --runs tunnel.ron", "tunnel.ron"),
    ] {
        let [command, file] = [command, file]
            .map(|cell| SHORT.iter().fold(cell.to_owned(), |cell, (short, long)| cell.replace(short, long)));
        // Without the file of this folder a command says what to name.
        let name = file.rsplit('/').next().unwrap_or(&file).trim_end_matches(".ron");
        rows.push(Row::refused(&command, &file, Gone, &[name]));
        rows.push(Row::refused(&command, &file, Folder, &[name]));
        let nines = "9".repeat(200_000) + ",1\n";
        for content in [String::new(), "\0".repeat(5000), "(".repeat(100_000), "x".repeat(200_000), nines] {
            rows.push(Row::refused(&command, &file, whole(content), &[&file]));
        }
        rows.push(Row::refused(&command, &file, whole([0xC3, 0x28, b'\n', 0xFF]), &[&file, "UTF-8"]));
        rows.push(Row::refused(&command, &file, whole([0xFF, 0xFE, 0x00, 0xD8, 0x41]), &[&file, "UTF-16"]));
    }
    rows
}

/// Numbers of things that no machine holds.
fn large() -> Vec<Row> {
    let rates = |count: usize| {
        let numbers: Vec<String> = (0..count).map(|i| format!("{:?}", 0.5 + 1e-3 * i as f64)).collect();
        text("[30.0]", &format!("[{}]", numbers.join(",")))
    };
    let boxes = |along: usize, across: usize| {
        text("(chordwise: 8, spanwise: 24)", &format!("(chordwise: {along}, spanwise: {across})"))
    };
    let cases = "fullaircraft --corrections corrections.ron --cases cases.ron";
    let flutter = "flutter --corrections corrections.ron";
    vec![
        refused("calibrate", "wing.ron", boxes(100, 200), "20000 boxes & GB"),
        refused("calibrate", "wing.ron", boxes(100, 900), "90000 boxes"),
        refused("calibrate", "wing.ron", boxes(100, 1_000_000), "wing.ron: & spanwise"),
        refused(flutter, "wing.ron", boxes(100, 200), "20000 boxes"),
        refused(cases, "wing.ron", boxes(100, 200), "20000 boxes"),
        refused(cases, "cases.ron", rates(700_000), "cases.ron: & the most of a file"),
    ]
}
