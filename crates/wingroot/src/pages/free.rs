//! The page of `free`.

use report::Page;
use report::page::{Block, KeyNumber, PageTable, Plate, Section};
use serde_json::Value;

use super::plates::figures;
use super::values::{at, four_at, list, short_at, table_of, text, whole_at, word};

/// Sets of cycles with what they are called.
const SETS: [(&str, &str); 3] =
    [("fitted", "fitted"), ("held_out_airspeeds", "airspeeds held out"), ("held_out_days", "days held out")];

pub(super) fn page(result: &Value, plates: &mut Vec<Plate>) -> Page {
    let lead = format!(
        "{}: {} oscillations fitted, mean square left {} times the scatter.",
        text(result, "name"),
        whole_at(result, "points"),
        short_at(result, "left")
    );
    Page {
        title: "Free response".into(),
        lead: vec![text(result, "sentence").to_owned(), lead],
        numbers: sets(result).map(|(name, set)| amplitude(name, set)).chain(airspeeds(result)).collect(),
        sections: vec![
            figures("Measured and predicted", std::mem::take(plates)),
            Section::new("Before and after", vec![Block::Table(cycles(result))]),
            Section::new("What was found", vec![Block::Table(found(result))]),
            Section::new("What was tried", vec![Block::Table(tried(result))]),
        ],
        ..Page::default()
    }
}

/// Sets that have a cycle, with their names.
fn sets(result: &Value) -> impl Iterator<Item = (&'static str, &Value)> {
    let of = |(key, name): (&'static str, &'static str)| Some((name, result.get(key)?));
    SETS.into_iter().filter_map(of).filter(|(_, set)| at(set, "cycles").is_some_and(|count| count > 0.0))
}

fn amplitude(name: &str, set: &Value) -> KeyNumber {
    let value = format!("{} %", short_at(set, "amplitude_error_percent"));
    KeyNumber::new(format!("pitch amplitude, {name}"), value, "rms, of cycles that the model has")
}

fn airspeeds(result: &Value) -> impl Iterator<Item = KeyNumber> {
    [("onset", "measured"), ("fold", "lowest cycle measured")].into_iter().map(|(key, note)| {
        let of = |what: &str| {
            let found = at(result, &format!("{key}/{what}_m_s"));
            found.map_or_else(|| "none".to_owned(), |v| format!("{v:.1} m/s"))
        };
        KeyNumber::new(key, of("predicted"), format!("{note}: {}", of("measured")))
    })
}

fn cycles(result: &Value) -> PageTable {
    let heads = [
        "cycles",
        "measured",
        "missing before",
        "missing after",
        "pitch amplitude (% rms)",
        "frequency (% rms)",
    ];
    let mut table = PageTable::new("A linear rig has no cycle of its own: before, all are missing.", &heads);
    for (name, set) in sets(result) {
        let count = whole_at(set, "cycles");
        let [amplitude, frequency] =
            ["amplitude", "frequency"].map(|what| short_at(set, &format!("{what}_error_percent")));
        table.row([name.to_owned(), count.clone(), count, whole_at(set, "missing"), amplitude, frequency]);
    }
    table
}

fn found(result: &Value) -> PageTable {
    let mut table = PageTable::new("", &["effect", "parameter", "value", "standard deviation"]);
    for effect in list(result, "effects") {
        for parameter in list(effect, "parameters") {
            table.row([
                word(effect, "name"),
                word(parameter, "name"),
                four_at(parameter, "value"),
                short_at(parameter, "sd"),
            ]);
        }
    }
    table
}

fn tried(result: &Value) -> PageTable {
    table_of(
        "",
        list(result, "candidates"),
        &[
            ("beside", "level", whole_at),
            ("effect", "name", word),
            ("log Bayes factor", "log_bayes_factor", short_at),
            ("wins of drawn days", "wins", short_at),
            ("left (1 is the scatter)", "left", short_at),
        ],
    )
}
