//! Families of rows: every number and every key of the example's files, spoilt in the same ways.

use super::row::{Change, End, Row};
use std::path::Path;

/// Files of the example with the command that reads them.
const FILES: [(&str, &str); 8] = [
    ("calibrate", "wing.ron"),
    ("calibrate", "campaign/campaign.ron"),
    ("fullaircraft --corrections corrections.ron", "aircraft.ron"),
    ("fullaircraft --corrections corrections.ron --cases cases.ron", "cases.ron"),
    ("simulate --corrections corrections.ron --maneuver maneuver.ron", "maneuver.ron"),
    ("modes --measured measured.ron", "measured.ron"),
    ("tunnel --runs tunnel.ron", "tunnel.ron"),
    ("response --data response.ron", "response.ron"),
];

/// What a number is made.
const NOT_FINITE: [&str; 4] = ["NaN", "inf", "-inf", "1e400"];
const ODD: [&str; 3] = ["-1e300", "0.0", "1e300"];

/// The rows.
pub(crate) fn rows() -> Vec<Row> {
    let all = crate::slow::runs("spoils every number in every way");
    FILES.iter().flat_map(|(command, file)| of_file(command, file, all)).collect()
}

/// The example's text of a file, as `new` and [`super::lists::added`] make it.
fn text_of(file: &str) -> String {
    if let Some((_, text)) = super::lists::added().into_iter().find(|(name, _)| *name == file) {
        return text;
    }
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/own_wing").join(file);
    std::fs::read_to_string(data).expect("a shipped file")
}

/// Each key misspelt, and each number spoilt in all ways, or in some of them in turn, so that every way meets every file of some size.
fn of_file(command: &str, file: &str, all: bool) -> Vec<Row> {
    let text = text_of(file);
    let mut rows = Vec::new();
    for (number, (at, key, value)) in entries(&text).into_iter().enumerate() {
        let here = |from: &str, to: String| Change::At(at, from.to_owned(), to);
        let refused = |change, words: &[&str]| Row::refused(command, file, change, words);
        let name = format!("{key}x");
        rows.push(refused(here(&key, name.clone()), &[file, &name]));
        let Some(value) = value else { continue };
        let entry = format!("{key}: {value}");
        let with = |new: &str| here(&entry, format!("{key}: {new}"));
        let gone = refused(here(&entry, String::new()), &[file]).ending(End::Open);
        let odd = ODD.map(|odd| refused(with(odd), &[file]).ending(End::Open));
        let none = NOT_FINITE.map(|word| refused(with(word), &[file, word]));
        let word = refused(with("\"a word\""), &[file]);
        let ways: Vec<Row> = none.into_iter().chain([word, gone]).chain(odd).collect();
        let in_turn = |way: usize| all || way % 8 == number % 8;
        rows.extend(ways.into_iter().enumerate().filter(|(way, _)| in_turn(*way)).map(|(_, row)| row));
    }
    rows
}

/// Keys outside comments and quotes, each with its byte and, if one number stands behind it, the number.
fn entries(text: &str) -> Vec<(usize, String, Option<String>)> {
    let mut found = Vec::new();
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let code = line.split("//").next().unwrap_or_default();
        for (colon, _) in code.match_indices(": ") {
            let before = &code[..colon];
            let key: String = before.chars().rev().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
            let key: String = key.chars().rev().collect();
            if key.is_empty() || before.matches('"').count() % 2 == 1 {
                continue;
            }
            let value: String =
                code[colon + 2..].chars().take_while(|c| c.is_alphanumeric() || ".-+".contains(*c)).collect();
            let value = Some(value).filter(|value| value.parse::<f64>().is_ok());
            found.push((start + colon - key.len(), key, value));
        }
        start += line.len();
    }
    found
}
