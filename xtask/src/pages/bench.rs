//! The page of `bench`: the time of every step, and of other programs where they were there.

use report::Page;
use report::page::{Block, KeyNumber, PageTable, Plate, Section};
use serde_json::Value;

use wingroot::pages::values::{at, digits, list, short_at, text};

/// Keys of a row that have columns of their own.
const OWN: [&str; 7] = ["name", "seconds", "peak_MB", "peer", "peer_seconds", "ratio", "peer_peak_MB"];

pub(crate) fn page(result: &Value, _: &mut Vec<Plate>) -> Page {
    let rows = list(result, "rows");
    let mut numbers: Vec<KeyNumber> = rows
        .iter()
        .filter_map(|row| {
            let ratio = at(row, "ratio")?;
            let label = text(row, "name").replace('_', " ");
            Some(KeyNumber::new(label, format!("{} times faster", digits(ratio, 3)), text(row, "peer")))
        })
        .collect();
    numbers.push(KeyNumber::new(
        "memory",
        format!("{} MB", short_at(result, "peak_MB")),
        "the most of the whole run",
    ));
    let caption = "Medians of several runs on this machine, as it was busy then; a dash: not measured.";
    let head = ["step", "seconds", "memory (MB)", "peer", "its seconds", "times ours", "remarks"];
    let mut table = PageTable::new(caption, &head);
    for row in rows {
        let remarks: Vec<String> = row
            .as_object()
            .into_iter()
            .flatten()
            .filter(|(key, _)| !OWN.contains(&key.as_str()))
            .map(|(key, value)| {
                let value = value.as_f64().map_or_else(|| value.to_string(), |value| digits(value, 4));
                format!("{} {value}", key.replace('_', " "))
            })
            .collect();
        table.row([
            text(row, "name").replace('_', " "),
            short_at(row, "seconds"),
            short_at(row, "peak_MB"),
            text(row, "peer").to_owned(),
            short_at(row, "peer_seconds"),
            short_at(row, "ratio"),
            remarks.join("; "),
        ]);
    }
    Page {
        title: "Time of the main steps".into(),
        numbers,
        sections: vec![Section::new("Steps", vec![Block::Table(table)])],
        ..Page::default()
    }
}
