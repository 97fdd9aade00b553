//! The page of `simulate`.

use report::Page;
use report::page::{Block, KeyNumber, Plate, Section};
use serde_json::Value;

use super::changes::{self, RunChange};
use super::plates::figures;
use super::values::{LOADS, at, counted, from_to, list, short_at, text};

pub(super) fn page(result: &Value, plates: &mut Vec<Plate>) -> Page {
    let runs = list(result, "runs");
    let median = |model: &str, key: &str| {
        let mut all: Vec<f64> =
            runs.iter().filter_map(|run| at(run, &format!("raw_percent/{model}/{key}"))).collect();
        all.sort_by(f64::total_cmp);
        all.get(all.len() / 2).copied()
    };
    let mut numbers = Vec::new();
    for (key, name, _) in LOADS {
        let (before, after) = (median("initial", key), median("updated", key));
        if let (Some(was), Some(is)) = (before, after) {
            let note = "rms error over the load's rms variation, initial to updated; median of the runs";
            numbers.push(KeyNumber::new(name, from_to(before, after, "%"), note).judged(is < was));
        }
    }
    numbers.push(KeyNumber::new("runs", runs.len().to_string(), "flown in unsteady air"));
    let changes = changes(runs);
    numbers.extend(changes::number(&changes));
    let measured = runs.iter().any(|run| run["residual_rms"]["updated"].is_object());
    // runs of the paper's figures stand first, and so are not folded up
    plates.sort_by_key(|plate| plate.caption.is_empty());
    let mut sections = vec![figures("Time histories", std::mem::take(plates))];
    if measured {
        let caption =
            "Root mean square of measured less simulated; initial is theory, updated has the corrections.";
        let table = changes::table(caption, &["run", "V (m/s)"], ["initial", "updated"], &changes);
        sections.push(Section::new("All runs", vec![Block::Table(table)]));
    }
    let remarks: Vec<Block> = runs
        .iter()
        .flat_map(|run| list(run, "remarks").iter().map(move |remark| (run, remark)))
        .map(|(run, remark)| Block::Text(format!("{}: {}", name(run), remark.as_str().unwrap_or_default())))
        .collect();
    if !remarks.is_empty() {
        sections.push(Section::new("Remarks", remarks));
    }
    Page {
        title: "Wind-tunnel runs flown again".into(),
        lead: [format!(
            "{} with the initial model (theory) and the updated one (corrections from {}{}){}.",
            counted(runs.len(), "run", "runs"),
            text(result, "corrections"),
            if result["deflection_correction"] == true { ", commanded deflections corrected" } else { "" },
            if measured { ", beside the measurement" } else { "" }
        )]
        .into_iter()
        .chain(measured.then(|| changes::sentence(&changes)))
        .collect(),
        numbers,
        sections,
        ..Page::default()
    }
}

/// The run's file without folders and ending.
fn name(run: &Value) -> &str {
    let file = text(run, "file");
    let file = file.rsplit(['/', '\\']).next().unwrap_or(file);
    file.rsplit_once('.').map_or(file, |(stem, _)| stem)
}

/// What corrections do to each measured run.
fn changes(runs: &[Value]) -> Vec<RunChange> {
    let measured = runs.iter().filter(|run| run["residual_rms"]["updated"].is_object());
    let change = |run: &Value| {
        let left = &run["residual_rms"];
        RunChange::of(vec![name(run).to_owned(), short_at(run, "V_m_s")], &left["initial"], &left["updated"])
    };
    measured.map(change).collect()
}
