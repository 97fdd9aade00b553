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
    let mut table = PageTable::new(
        "A linear rig has no cycle of its own: before, all are missing.",
        &[
            "cycles",
            "measured",
            "missing before",
            "missing after",
            "pitch amplitude (% rms)",
            "frequency (% rms)",
        ],
    );
    let mut numbers = Vec::new();
    for (key, name) in SETS {
        let of = |what: &str| whole_at(result, &format!("{key}/{what}"));
        let percent = |what: &str| short_at(result, &format!("{key}/{what}_error_percent"));
        let cycles = of("cycles");
        if cycles == "0" {
            continue;
        }
        let row = [
            name.to_owned(),
            cycles.clone(),
            cycles,
            of("missing"),
            percent("amplitude"),
            percent("frequency"),
        ];
        table.row(row);
        let value = format!("{} %", percent("amplitude"));
        numbers.push(KeyNumber::new(
            format!("pitch amplitude, {name}"),
            value,
            "rms, of cycles that the model has",
        ));
    }
    for (key, note) in [("onset", "measured"), ("fold", "lowest cycle measured")] {
        let of = |what: &str| {
            at(result, &format!("{key}/{what}_m_s"))
                .map_or_else(|| "none".to_owned(), |v| format!("{v:.1} m/s"))
        };
        numbers.push(KeyNumber::new(key, of("predicted"), format!("{note}: {}", of("measured"))));
    }
    let mut found = PageTable::new("", &["effect", "parameter", "value", "standard deviation"]);
    for effect in list(result, "effects") {
        for parameter in list(effect, "parameters") {
            found.row([
                word(effect, "name"),
                word(parameter, "name"),
                four_at(parameter, "value"),
                short_at(parameter, "sd"),
            ]);
        }
    }
    let tried = table_of(
        "",
        list(result, "candidates"),
        &[
            ("beside", "level", whole_at),
            ("effect", "name", word),
            ("log Bayes factor", "log_bayes_factor", short_at),
            ("wins of drawn days", "wins", short_at),
            ("left (1 is the scatter)", "left", short_at),
        ],
    );
    Page {
        title: "Free response".into(),
        lead: vec![
            text(result, "sentence").to_owned(),
            format!(
                "{}: {} oscillations fitted, mean square left {} times the scatter.",
                text(result, "name"),
                whole_at(result, "points"),
                short_at(result, "left")
            ),
        ],
        numbers,
        sections: vec![
            figures("Measured and predicted", std::mem::take(plates)),
            Section::new("Before and after", vec![Block::Table(table)]),
            Section::new("What was found", vec![Block::Table(found)]),
            Section::new("What was tried", vec![Block::Table(tried)]),
        ],
        ..Page::default()
    }
}
