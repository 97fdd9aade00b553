//! The page of `hidden`: the gates of the blind benchmark, its metrics with their intervals, and who was taken for whom.

use hidden::score::{BenchmarkResult, Bound, Gate};
use report::Page;
use report::page::{Block, KeyNumber, PageTable, Plate, Section};
use serde::Deserialize;
use serde_json::Value;

use super::values::digits;

/// Metrics that stand at the top where they were measured, with what they say.
const FIRST: [(&str, &str, &str); 4] = [
    ("null_false_naming", "false names", "share of campaigns without an effect in which one is named"),
    ("top1_clear", "clear effects named", "share named first where the effect is ten times the floor"),
    ("precision", "names that are right", "share of all names given"),
    ("set_coverage", "truth among the names", "share of reported sets that hold the hidden effect"),
];

/// The page of a result; an empty one if it is none of `hidden`.
pub(super) fn page(result: &Value, _: &mut Vec<Plate>) -> Page {
    BenchmarkResult::deserialize(result).map_or_else(|_| Page::default(), |result| page_of(&result))
}

fn page_of(result: &BenchmarkResult) -> Page {
    let BenchmarkResult { gates, scored, .. } = result;
    let numbers = FIRST.into_iter().filter_map(|(metric, label, note)| {
        let number = KeyNumber::new(label, digits(scored.metrics.get(metric)?.value?, 3), note);
        Some(match gates.iter().find(|gate| gate.metric == metric) {
            Some(gate) => number.judged(gate.reached),
            None => number,
        })
    });
    let with: Vec<&Gate> = gates.iter().filter(|gate| gate.value.is_some()).collect();
    let reached = with.iter().filter(|gate| gate.reached).count();
    Page {
        title: "The blind benchmark of discover".into(),
        lead: vec![
            format!(
                "{} campaigns{} of {} and other forms of every effect, each with a known effect hidden or none, track {}, seed {}.",
                scored.cases,
                result.class.map_or_else(String::new, |class| format!(" of the class {class:?}")),
                made_by(&result.truth),
                result.track,
                result.seed
            ),
            match gates.len() - with.len() {
                0 => format!("{reached} of {} acceptance criteria are met.", with.len()),
                without => format!(
                    "{reached} of {} acceptance criteria with cases are met; {without} more have no case.",
                    with.len()
                ),
            },
        ],
        numbers: numbers.collect(),
        sections: vec![
            Section::new("Acceptance criteria", vec![Block::Table(gates_table(result))]),
            Section::new("What was named for what was hidden", vec![Block::Table(confusion(result))]),
            Section::new("All metrics", vec![Block::Table(metrics(result))]),
        ],
        ..Page::default()
    }
}

/// What made the campaigns.
fn made_by(truth: &str) -> &'static str {
    if truth == "vortex" {
        "another program (a vortex lattice and a beam that share nothing with the model)"
    } else {
        "a wing with another discretisation"
    }
}

fn shown(value: Option<f64>) -> String {
    value.map_or_else(|| "-".into(), |value| digits(value, 3))
}

/// Interval and number of cases of a metric; its value is given by the caller.
fn interval(result: &BenchmarkResult, metric: &str) -> [String; 3] {
    let metric = result.scored.metrics.get(metric);
    let of = |of: fn(&hidden::score::Metric) -> Option<f64>| shown(metric.and_then(of));
    [of(|m| m.low), of(|m| m.high), of(|m| Some(m.n as f64))]
}

fn gates_table(result: &BenchmarkResult) -> PageTable {
    let caption = "Wilson's interval of 95 % beside each share; a dash: no case of the kind.";
    let mut table = PageTable::new(caption, &["metric", "limit", "value", "low", "high", "cases", "met"]);
    for Gate { metric, bound, limit, value, reached } in &result.gates {
        let side = match bound {
            Bound::AtLeast => "at least",
            Bound::AtMost => "at most",
        };
        let met = match (value, reached) {
            (None, _) => "-",
            (_, true) => "yes",
            (_, false) => "no",
        };
        let [low, high, n] = interval(result, metric);
        let limit = format!("{side} {}", shown(Some(*limit)));
        table.row([metric.replace('_', " "), limit, shown(*value), low, high, n, met.to_owned()]);
    }
    table
}

fn metrics(result: &BenchmarkResult) -> PageTable {
    let mut table = PageTable::new("", &["metric", "value", "low", "high", "cases"]);
    for (metric, of) in &result.scored.metrics {
        let [low, high, n] = interval(result, metric);
        table.row([metric.replace('_', " "), shown(of.value), low, high, n]);
    }
    table
}

/// A row for each pair of hidden and named, hidden effects in their order, the most frequent names first.
fn confusion(result: &BenchmarkResult) -> PageTable {
    let caption = "What was hidden, what was named, and how often; a bar between names means that the data do not tell them apart.";
    let mut table = PageTable::new(caption, &["hidden", "named", "cases", "share of the hidden"]);
    let words = |name: &str| name.replace('_', " ").replace('|', " | ");
    for (hidden, named) in &result.scored.confusion {
        let mut pairs: Vec<(&String, usize)> = named.iter().map(|(name, n)| (name, *n)).collect();
        pairs.sort_by_key(|pair| std::cmp::Reverse(pair.1));
        let all: usize = pairs.iter().map(|(_, n)| n).sum();
        for (place, (name, n)) in pairs.into_iter().enumerate() {
            let first = if place == 0 { words(hidden) } else { String::new() };
            let share = format!("{:.0} %", 100.0 * n as f64 / all.max(1) as f64);
            table.row([first, words(name), n.to_string(), share]);
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
            "command": "hidden", "cases": 3, "seed": 5, "track": "A", "truth": "doublet", "seconds": 1.0,
            "metrics": { "precision": { "value": 0.5, "low": 0.1, "high": 0.9, "n": 2 }, "pair_one": { "value": null, "n": 0 } },
            "gates": [
                { "metric": "precision", "bound": "at_least", "limit": 0.92, "value": 0.5, "reached": false },
                { "metric": "pair_one", "bound": "at_least", "limit": 0.9, "value": null, "reached": false },
            ],
            "confusion": { "none": { "none": 1 }, "stall": { "none": 1, "stall|backlash": 3 } },
        });
        let page = page(&result, &mut Vec::new());
        assert!(page.lead[1].starts_with("0 of 1 acceptance criteria"));
        let Block::Table(gates) = &page.sections[0].blocks[0] else { panic!("a table") };
        assert_eq!(gates.rows[0].join(";"), "precision;at least 0.920;0.500;0.100;0.900;2;no");
        assert_eq!(gates.rows[1][6], "-");
        let Block::Table(confusion) = &page.sections[1].blocks[0] else { panic!("a table") };
        assert_eq!(confusion.rows[1].join(";"), "stall;stall | backlash;3;75 %");
        assert_eq!(confusion.rows[2].join(";"), ";none;1;25 %");
    }
}
