//! The page of `response`.

use report::Page;
use report::page::{Block, KeyNumber, PageTable, Plate, Section};
use serde_json::Value;

use super::plates::figures;
use super::values::{Column, at, counted, four_at, list, short_at, table_of, text, whole_at, word};

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
    let columns: [Column; 6] = [
        ("data", "data", word),
        ("response", "name", word),
        ("points", "points", whole_at),
        ("terms", "terms", |r, key| list(r, key).len().to_string()),
        ("R\u{b2}", "r2", |r, key| at(r, key).map_or_else(|| "-".into(), |r2| format!("{r2:.5}"))),
        ("predicted squared error", "pse", short_at),
    ];
    let table = table_of("", responses, &columns);
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
    let columns: [Column; 5] = [
        ("term", "term", word),
        ("coefficient", "coefficient", four_at),
        ("standard error", "standard_error", four_at),
        ("t", "t", four_at),
        ("p-value", "p_value", four_at),
    ];
    table_of(format!("{} ({})", text(r, "name"), text(r, "data")), list(r, "terms"), &columns)
}
