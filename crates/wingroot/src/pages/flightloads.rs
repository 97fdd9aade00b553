//! The page of `flightloads`.

use report::Page;
use report::page::{Block, KeyNumber, Plate, Section};
use serde_json::Value;

use super::plates::figures;
use super::values::{Column, at, digits, list, short_at, table_of, text, whole_at, word};

/// Whether, in a word.
fn yes(value: &Value, path: &str) -> String {
    match value.get(path).and_then(Value::as_bool) {
        Some(true) => "yes".to_owned(),
        Some(false) => "no".to_owned(),
        None => "not recorded".to_owned(),
    }
}

/// How far what was flown covers the design loads.
fn coverage(result: &Value) -> Section {
    let Some(coverage) = result.get("coverage") else {
        return Section::new("Coverage of the design", Vec::new());
    };
    let instants: [Column; 7] = [
        ("load set", "sid", whole_at),
        ("case", "case", whole_at),
        ("mass", "mass", word),
        ("V (m/s)", "V_m_s", short_at),
        ("n", "n_z", short_at),
        ("V was flown", "v_is_flown", yes),
        ("n was flown", "n_is_flown", yes),
    ];
    let loads: [Column; 6] = [
        ("station", "station", word),
        ("load", "load", word),
        ("end", "end", word),
        ("measured", "measured", short_at),
        ("design", "design", short_at),
        ("extrapolated by", "extrapolated_by", short_at),
    ];
    let of_loads = "Ends of measured loads beside those of the design loads (updated model); one: flown beyond them; empty: no load of that sign \
                    was measured.";
    let of_instants =
        "Instants that went to stress, and whether airspeed and load factor lie within those flown.";
    let table = |caption: &str, key: &str, columns: &[Column]| {
        Block::Table(table_of(caption, list(coverage, key), columns))
    };
    let tables = vec![table(of_loads, "loads", &loads), table(of_instants, "instants", &instants)];
    Section::new("Coverage of the design", tables)
}

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
        coverage(result),
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
