//! The page of `response`.

use report::Page;
use report::page::{Block, KeyNumber, PageTable, Plate, Section};
use serde_json::Value;

use super::figures;
use super::values::{at, counted, digits, list, short_at, text};

/// So many responses have a number at the top.
const TOP: usize = 6;

pub(super) fn page(result: &Value, plates: &mut Vec<Plate>) -> Page {
    let responses = list(result, "responses");
    let mut numbers = Vec::new();
    for r in responses.iter().take(TOP) {
        let r2 = at(r, "r2").map_or_else(|| "-".into(), |r2| format!("{r2:.4}"));
        let note = format!("R\u{b2}; {}", counted(list(r, "terms").len(), "term", "terms"));
        numbers.push(KeyNumber::new(text(r, "name"), r2, note));
    }
    let mut table =
        PageTable::new("", &["data", "response", "points", "terms", "R\u{b2}", "predicted squared error"]);
    for r in responses {
        table.row([
            text(r, "data").to_owned(),
            text(r, "name").to_owned(),
            at(r, "points").map_or_else(|| "-".into(), |n| n.to_string()),
            list(r, "terms").len().to_string(),
            at(r, "r2").map_or_else(|| "-".into(), |r2| format!("{r2:.5}")),
            short_at(r, "pse"),
        ]);
    }
    let mut sections = vec![Section::new("Surfaces", vec![Block::Table(table)])];
    let terms: Vec<Block> = responses.iter().map(|r| Block::Table(terms(r))).collect();
    sections.push(figures("Choice of terms, fit and surface", std::mem::take(plates)));
    sections.push(Section::new("Terms", terms));
    sections.retain(|section| !section.blocks.is_empty());
    Page {
        title: "Response surfaces of measured coefficients".into(),
        lead: vec![format!(
            "{}: terms chosen by the predicted squared error, each with its standard error.",
            counted(responses.len(), "response", "responses")
        )],
        numbers,
        sections,
        ..Page::default()
    }
}

fn terms(r: &Value) -> PageTable {
    let mut table = PageTable::new(
        format!("{} ({})", text(r, "name"), text(r, "data")),
        &["term", "coefficient", "standard error", "t", "p-value"],
    );
    for term in list(r, "terms") {
        let number = |key: &str| at(term, key).map_or_else(|| "-".into(), |v| digits(v, 4));
        let name = term["term"].as_str().unwrap_or_default();
        table.row([
            name.to_owned(),
            number("coefficient"),
            number("standard_error"),
            number("t"),
            number("p_value"),
        ]);
    }
    table
}
