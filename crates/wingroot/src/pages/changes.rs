//! Runs before and after a change of the model: those that got worse stand beside those that got better.

use report::Figure;
use report::page::{KeyNumber, PageTable};
use serde_json::Value;

use super::values::{LOADS, at, counted, rms_beside_measured, short, text, with_unit};

/// So many runs are named in a sentence.
const NAMED: usize = 4;

/// Root mean squares of measured less simulated of a run.
pub(super) struct RunChange {
    /// Its name, and what else stands before the loads in a table.
    pub(super) cells: Vec<String>,
    loads: Vec<LoadChange>,
}

struct LoadChange {
    /// `Fz (N)`.
    label: String,
    before: f64,
    after: f64,
}

impl LoadChange {
    /// Whether it grows by as much as three digits show.
    fn is_worse(&self) -> bool {
        self.after > 1.005 * self.before
    }

    /// `Fz 0.154 → 0.594 N`.
    fn said(&self) -> String {
        let (load, unit) = self.label.trim_end_matches(')').split_once(" (").unwrap_or((&self.label, ""));
        format!("{load} {} \u{2192} {} {unit}", short(Some(self.before)), short(Some(self.after)))
    }
}

impl RunChange {
    /// From two tables of loads by their keys.
    pub(super) fn of(cells: Vec<String>, before: &Value, after: &Value) -> Self {
        let load = |(key, ..): (&str, &str, &str)| {
            Some(LoadChange { label: with_unit(key), before: at(before, key)?, after: at(after, key)? })
        };
        Self { cells, loads: LOADS.into_iter().filter_map(load).collect() }
    }

    /// From a figure of what was measured and of both models, a load a panel.
    pub(super) fn of_figure(run: &str, figure: &Figure) -> Self {
        let [before, after] = ["before", "after"].map(|model| rms_beside_measured(figure, model));
        let pairs = figure.panels.iter().zip(before.into_iter().zip(after));
        let loads = pairs
            .map(|(panel, (before, after))| LoadChange { label: panel.y_label.clone(), before, after })
            .collect();
        Self { cells: vec![run.to_owned()], loads }
    }

    /// From an entry with `run`, `before` and `after`.
    pub(super) fn of_entry(entry: &Value) -> Self {
        Self::of(vec![text(entry, "run").to_owned()], &entry["before"], &entry["after"])
    }

    fn worse(&self) -> Vec<&LoadChange> {
        self.loads.iter().filter(|load| load.is_worse()).collect()
    }

    /// By how much its worst load grows.
    fn growth(&self) -> f64 {
        self.worse().iter().map(|load| load.after / load.before).fold(0.0, f64::max)
    }

    fn verdict(&self) -> String {
        let worse: Vec<&str> =
            self.worse().iter().map(|load| load.label.split(' ').next().unwrap_or_default()).collect();
        let better = self.loads.iter().any(|load| load.after < load.before);
        match &worse[..] {
            [] if better => "better".into(),
            [] => "as before".into(),
            worse => format!("worse in {}", worse.join(", ")),
        }
    }
}

/// A row a run, with a last column that says whether it got worse; `heads` are those of the cells, `states` the two models.
pub(super) fn table(caption: &str, heads: &[&str], states: [&str; 2], runs: &[RunChange]) -> PageTable {
    let labels = runs.iter().map(|run| &run.loads).max_by_key(|loads| loads.len());
    let mut head: Vec<String> = heads.iter().map(|&head| head.to_owned()).collect();
    for load in labels.into_iter().flatten() {
        let (name, unit) = load.label.split_once(' ').unwrap_or((&load.label, ""));
        head.extend([format!("{name} {} {unit}", states[0]).trim_end().to_owned(), states[1].to_owned()]);
    }
    head.push("change".into());
    let mut table = PageTable::new(caption, &head.iter().map(String::as_str).collect::<Vec<_>>());
    for run in runs {
        let loads = run.loads.iter().flat_map(|load| [short(Some(load.before)), short(Some(load.after))]);
        let mut row: Vec<String> = run.cells.iter().cloned().chain(loads).collect();
        row.resize(head.len() - 1, "-".into());
        row.push(run.verdict());
        table.row(row);
    }
    table
}

/// The runs that got worse, those that did most first.
fn worse(runs: &[RunChange]) -> Vec<&RunChange> {
    let mut worse: Vec<&RunChange> = runs.iter().filter(|run| !run.worse().is_empty()).collect();
    worse.sort_by(|a, b| b.growth().total_cmp(&a.growth()));
    worse
}

/// How many runs got better and worse, and which got worse most.
pub(super) fn sentence(runs: &[RunChange]) -> String {
    let worse = worse(runs);
    let all = counted(runs.len(), "run", "runs");
    if worse.is_empty() {
        return format!("No load of {all} got worse.");
    }
    let said = |run: &&&RunChange| {
        let loads: Vec<String> = run.worse().iter().map(|load| load.said()).collect();
        format!("{} ({})", run.cells[0], loads.join(", "))
    };
    let named: Vec<String> = worse.iter().take(NAMED).map(|run| said(&run)).collect();
    let most = if worse.len() > NAMED { ", most of all" } else { "" };
    format!("{} of {all} got worse in some load{most}: {}.", worse.len(), named.join("; "))
}

/// How many runs got worse, as a number for the head of a page; none without runs.
pub(super) fn number(runs: &[RunChange]) -> Option<KeyNumber> {
    let worse = worse(runs);
    let note = match worse.first() {
        Some(run) => format!("in some load; most of all {}", run.cells[0]),
        None => "in any load".to_owned(),
    };
    let value = format!("{} of {}", worse.len(), runs.len());
    (!runs.is_empty()).then(|| KeyNumber::new("runs that got worse", value, note).judged(worse.is_empty()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn run(name: &str, before: [f64; 3], after: [f64; 3]) -> RunChange {
        let loads = |v: [f64; 3]| json!({ "Fz_N": v[0], "Mx_Nm": v[1], "My_Nm": v[2] });
        RunChange::of_entry(&json!({ "run": name, "before": loads(before), "after": loads(after) }))
    }

    #[test]
    fn a_run_that_got_worse_is_said_beside_those_that_got_better() {
        let runs = [
            run("doublet", [9.58, 6.16, 2.78], [2.14, 1.38, 0.655]),
            run("chirp", [0.154, 0.174, 0.0816], [0.594, 0.10, 0.2]),
            run("still", [1.0, 1.0, 1.0], [1.0001, 1.0, 1.0]),
        ];
        assert_eq!(
            sentence(&runs),
            "1 of 3 runs got worse in some load: chirp (Fz 0.154 \u{2192} 0.594 N, My 0.0816 \u{2192} 0.200 N m)."
        );
        let table = table("", &["run"], ["before", "after"], &runs);
        assert_eq!(table.head[..3], ["run", "Fz before (N)", "after"]);
        let last: Vec<&str> = table.rows.iter().map(|row| row[7].as_str()).collect();
        assert_eq!(last, ["better", "worse in Fz, My", "as before"]);
        let number = number(&runs).unwrap();
        assert_eq!((number.value.as_str(), number.judgement), ("1 of 3", report::page::Judgement::Doubtful));
        assert!(super::number(&[]).is_none());
    }
}
