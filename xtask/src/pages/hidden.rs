//! The page of `hidden`: the gates of the blind benchmark, its metrics with their intervals, and who was taken for whom.

use report::Page;
use report::page::{Block, KeyNumber, PageTable, Plate, Section};
use serde_json::Value;

use super::values::{at, digits, list, text};

/// Metrics that stand at the top where they were measured, with what they say.
const FIRST: [(&str, &str, &str); 4] = [
    ("null_false_naming", "false names", "share of campaigns without an effect in which one is named"),
    ("top1_clear", "clear effects named", "share named first where the effect is ten times the floor"),
    ("precision", "names that are right", "share of all names given"),
    ("set_coverage", "truth among the names", "share of reported sets that hold the hidden effect"),
];

pub(super) fn page(result: &Value, _: &mut Vec<Plate>) -> Page {
    let gates = list(result, "gates");
    let gate = |metric: &str| gates.iter().find(|gate| text(gate, "metric") == metric);
    let numbers = FIRST.into_iter().filter_map(|(metric, label, note)| {
        let value = at(result, &format!("metrics/{metric}/value"))?;
        let number = KeyNumber::new(label, digits(value, 3), note);
        Some(match gate(metric) {
            Some(gate) => number.judged(gate["reached"] == true),
            None => number,
        })
    });
    let measured = |gate: &&Value| at(gate, "value").is_some();
    let (with, reached) = (
        gates.iter().filter(measured).count(),
        gates.iter().filter(measured).filter(|gate| gate["reached"] == true).count(),
    );
    let whole = |path: &str| at(result, path).map_or_else(|| "-".into(), |value| format!("{value:.0}"));
    Page {
        title: "The blind benchmark of discover".into(),
        lead: vec![
            format!(
                "{} campaigns of another program's wing, each with a known effect hidden or none, track {}, seed {}.",
                whole("cases"),
                text(result, "track"),
                whole("seed")
            ),
            match gates.len() - with {
                0 => format!("{reached} of {with} gates are reached."),
                without => {
                    format!("{reached} of {with} gates with cases are reached; {without} more have no case.")
                }
            },
        ],
        numbers: numbers.collect(),
        sections: vec![
            Section::new("Gates", vec![Block::Table(gates_table(result, gates))]),
            Section::new("Who was taken for whom", vec![Block::Table(confusion(result))]),
            Section::new("All metrics", vec![Block::Table(metrics(result))]),
        ],
        ..Page::default()
    }
}

fn shown(value: Option<f64>) -> String {
    value.map_or_else(|| "-".into(), |value| digits(value, 3))
}

/// Interval and number of cases of a metric; its value is given by the caller.
fn interval(result: &Value, metric: &str) -> [String; 3] {
    ["low", "high", "n"].map(|what| shown(at(result, &format!("metrics/{metric}/{what}"))))
}

fn gates_table(result: &Value, gates: &[Value]) -> PageTable {
    let caption = "Wilson's interval of 95 % beside each share; a dash: no case of the kind.";
    let mut table = PageTable::new(caption, &["metric", "gate", "value", "low", "high", "cases", "reached"]);
    for gate in gates {
        let metric = text(gate, "metric");
        let bound = format!("{} {}", text(gate, "bound").replace('_', " "), shown(at(gate, "limit")));
        let value = at(gate, "value");
        let reached = match (value, gate["reached"] == true) {
            (None, _) => "-",
            (_, true) => "yes",
            (_, false) => "no",
        };
        let [low, high, n] = interval(result, metric);
        table.row([metric.replace('_', " "), bound, shown(value), low, high, n, reached.to_owned()]);
    }
    table
}

fn metrics(result: &Value) -> PageTable {
    let mut table = PageTable::new("", &["metric", "value", "low", "high", "cases"]);
    for (metric, of) in result["metrics"].as_object().into_iter().flatten() {
        let [low, high, n] = interval(result, metric);
        table.row([metric.replace('_', " "), shown(at(of, "value")), low, high, n]);
    }
    table
}

/// A row for each pair of hidden and named, hidden effects in their order, the most frequent names first.
fn confusion(result: &Value) -> PageTable {
    let caption = "What was hidden, what was named, and how often; a bar between names means that the data do not tell them apart.";
    let mut table = PageTable::new(caption, &["hidden", "named", "cases", "share of the hidden"]);
    let words = |name: &str| name.replace('_', " ").replace('|', " | ");
    for (hidden, named) in result["confusion"].as_object().into_iter().flatten() {
        let mut pairs: Vec<(&String, f64)> = named
            .as_object()
            .into_iter()
            .flatten()
            .map(|(name, n)| (name, n.as_f64().unwrap_or_default()))
            .collect();
        pairs.sort_by(|a, b| b.1.total_cmp(&a.1));
        let all: f64 = pairs.iter().map(|(_, n)| n).sum();
        for (place, (name, n)) in pairs.into_iter().enumerate() {
            let first = if place == 0 { words(hidden) } else { String::new() };
            table.row([first, words(name), format!("{n:.0}"), format!("{:.0} %", 100.0 * n / all.max(1.0))]);
        }
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn a_gate_without_a_case_is_neither_reached_nor_missed() {
        let result = json!({
            "cases": 3, "seed": 5, "track": "A",
            "metrics": { "precision": { "value": 0.5, "low": 0.1, "high": 0.9, "n": 2 }, "pair_one": { "value": null, "n": 0 } },
            "gates": [
                { "metric": "precision", "bound": "at_least", "limit": 0.92, "value": 0.5, "reached": false },
                { "metric": "pair_one", "bound": "at_least", "limit": 0.9, "value": null, "reached": false },
            ],
            "confusion": { "none": { "none": 1 }, "stall": { "none": 1, "stall|play": 3 } },
        });
        let page = page(&result, &mut Vec::new());
        assert!(page.lead[1].starts_with("0 of 1 gates"));
        let Block::Table(gates) = &page.sections[0].blocks[0] else { panic!("a table") };
        assert_eq!(gates.rows[0].join(";"), "precision;at least 0.920;0.500;0.100;0.900;2;no");
        assert_eq!(gates.rows[1][6], "-");
        let Block::Table(confusion) = &page.sections[1].blocks[0] else { panic!("a table") };
        assert_eq!(confusion.rows[1].join(";"), "stall;stall | play;3;75 %");
        assert_eq!(confusion.rows[2].join(";"), ";none;1;25 %");
    }
}
