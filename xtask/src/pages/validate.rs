//! The page of `validate`.

use report::Page;
use report::page::{Block, KeyNumber, PageTable, Plate, Section};
use serde_json::Value;

use wingroot::pages::plates::figures;
use wingroot::pages::values::{Column, at, five_at, list, table_of, text, word};

pub(crate) fn page(result: &Value, plates: &mut Vec<Plate>) -> Page {
    let cases = list(result, "cases");
    let count = |key: &str| at(result, key).unwrap_or_default();
    let failed = cases.iter().filter(|case| case["good"] != true).count();
    let numbers = vec![
        KeyNumber::new("published cases", cases.len().to_string(), ""),
        KeyNumber::new(
            "numbers met",
            count("met").to_string(),
            "within the tolerance that stands beside them",
        )
        .judged(true),
        KeyNumber::new("not met", count("not_met").to_string(), "").judged(count("not_met") == 0.0),
        KeyNumber::new(
            "known deviations",
            count("known_deviations").to_string(),
            "bounded, with the reason given",
        ),
        KeyNumber::new(
            "recorded",
            count("recorded").to_string(),
            "beside the reference, without a tolerance",
        ),
    ];
    let mut sections = vec![
        Section::new("All cases", vec![Block::Table(overview(cases))]),
        Section::new("Numbers of each case", cases.iter().flat_map(case).collect()),
    ];
    if !plates.is_empty() {
        sections.push(figures("Figures", std::mem::take(plates)));
    }
    let left: Vec<Block> = list(result, "not_compared")
        .iter()
        .map(|entry| Block::Text(format!("{}: {}", text(entry, "case"), text(entry, "reason"))))
        .collect();
    if !left.is_empty() {
        sections.push(Section::new("Not compared", left));
    }
    Page {
        title: "Our results beside published references".into(),
        lead: vec![if failed == 0 {
            "Every published case is met, or deviates as known, for the reason given.".into()
        } else {
            format!("{failed} published cases are not met.")
        }],
        numbers,
        sections,
        ..Page::default()
    }
}

/// One row a case, those that are not met first.
fn overview(cases: &[Value]) -> PageTable {
    let mut table = PageTable::new("", &["case", "met", "not met", "known deviations", "recorded", "source"]);
    let mut ordered: Vec<&Value> = cases.iter().collect();
    ordered.sort_by_key(|case| case["good"] == true);
    for case in ordered {
        let count = |verdict: &str| {
            let of = |row: &&Value| text(row, "verdict") == verdict;
            match (case["error"].is_string(), list(case, "rows").iter().filter(of).count()) {
                (true, _) => "not computed".to_owned(),
                (_, count) => count.to_string(),
            }
        };
        table.row([
            text(case, "case").to_owned(),
            count("met"),
            count("not_met"),
            count("known_deviation"),
            count("recorded"),
            text(case, "source").to_owned(),
        ]);
    }
    table
}

fn case(case: &Value) -> Vec<Block> {
    let caption = format!("{}. {}", text(case, "case"), text(case, "source"));
    let columns: [Column; 5] = [
        ("quantity", "quantity", word),
        ("ours", "ours", five_at),
        ("reference", "reference", five_at),
        ("tolerance", "tolerance", word),
        ("verdict", "verdict", |row, key| match (text(row, key).replace('_', " "), text(row, "reason")) {
            (verdict, "") => verdict,
            (verdict, reason) => format!("{verdict}: {reason}"),
        }),
    ];
    let table = table_of(caption, list(case, "rows"), &columns);
    let mut blocks = vec![Block::Table(table)];
    if let Some(error) = case["error"].as_str() {
        blocks.push(Block::Text(format!("not computed: {error}")));
    }
    blocks
}
