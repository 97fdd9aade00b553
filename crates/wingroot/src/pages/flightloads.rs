//! The page of `flightloads`.

use report::Page;
use report::page::{Block, KeyNumber, Plate, Section};
use serde_json::Value;

use super::plates::figures;
use super::values::{Column, at, digits, list, short_at, table_of, text, whole_at, word};

pub(super) fn page(result: &Value, plates: &mut Vec<Plate>) -> Page {
    let rows = list(result, "rows");
    let updated = rows.iter().any(|row| row["model"] == "updated");
    let judged = if updated { "updated" } else { "initial" };
    let own: Vec<&Value> = rows.iter().filter(|row| row["model"] == judged).collect();
    let count = |verdict: &str| own.iter().filter(|row| row["verdict"] == verdict).count();
    let numbers = ["reliable", "conservative", "unconservative", "not shown", "undetermined"]
        .into_iter()
        .filter(|verdict| count(verdict) > 0)
        .map(|verdict| {
            let number = KeyNumber::new(
                verdict,
                count(verdict).to_string(),
                format!("of {}, {judged} model", own.len()),
            );
            if verdict == "unconservative" { number.judged(false) } else { number }
        })
        .collect();
    let columns: [Column; 9] = [
        ("condition", "condition", word),
        ("station", "station", word),
        ("load", "load", word),
        ("model", "model", word),
        ("points", "points", whole_at),
        ("fitted", "fitted", whole_at),
        ("slope", "line/slope/value", short_at),
        ("large loads at least", "worst_ratio", short_at),
        ("verdict", "verdict", word),
    ];
    let caption = "Slope of measured on calculated loads; calculated over measured at large loads; points that fitted the corrections \
                   count in no verdict.";
    let sentences = rows.iter().map(|row| Block::Text(text(row, "sentence").to_owned())).collect();
    let percent = |path: &str| at(result, path).map_or_else(String::new, |share| digits(100.0 * share, 3));
    let asked = format!(
        "Asked for by the user: slopes within {} % of one, bias within {} sigma, large loads from {} % of the largest. No rule is \
         claimed to be met: compliance is the applicant's to show.",
        percent("thresholds/reliable_within"),
        short_at(result, "thresholds/bias_within_sigma"),
        percent("thresholds/large_from"),
    );
    let fitted = whole_at(result, "fitted");
    let mut sections = vec![
        Section::new("Verdicts", vec![Block::Table(table_of(caption, rows, &columns))]),
        Section::new("In sentences, with the reasons", sentences),
        figures("Measured and calculated", std::mem::take(plates)),
    ];
    sections.retain(|section| !section.blocks.is_empty());
    Page {
        title: format!("Measured against calculated loads: {}", text(result, "name")),
        lead: vec![
            format!("{} points, of which {fitted} fitted the corrections.", whole_at(result, "points")),
            asked,
        ],
        numbers,
        sections,
        ..Page::default()
    }
}
