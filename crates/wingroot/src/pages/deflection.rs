//! The page of `deflection`.

use report::Page;
use report::page::{Block, KeyNumber, PageTable, Plate, Section};
use serde_json::Value;

use super::changes::{self, RunChange};
use super::plates::figures;
use super::values::{
    Column, at, counted, decimals_at, digits, from_to, list, short_at, table_of, text, word,
};

pub(super) fn page(result: &Value, plates: &mut Vec<Plate>) -> Page {
    let factors = list(result, "factors");
    let values: Vec<f64> = factors.iter().filter_map(|f| at(f, "factor")).collect();
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let (before, after) = (at(result, "holdout/gap/before"), at(result, "holdout/gap/after"));
    let mut numbers = vec![
        KeyNumber::new(
            "held-out doublets",
            from_to(before, after, ""),
            "rms residual in standard deviations of the noise, deflections as commanded, then corrected",
        )
        .judged(after < before),
    ];
    let changes = ["before", "after"].map(|when| at(result, &format!("holdout/gap_of_changes/{when}")));
    numbers.push(
        KeyNumber::new(
            "the same without the trim",
            from_to(changes[0], changes[1], ""),
            "means of the runs taken out",
        )
        .judged(changes[1] < changes[0]),
    );
    if !values.is_empty() {
        numbers.push(KeyNumber::new(
            "factor K",
            format!("{} to {}", digits(low, 3), digits(high, 3)),
            "share of a commanded deflection that acts",
        ));
    }
    let mut sections = vec![figures("Deflections that act", std::mem::take(plates))];
    sections.push(Section::new("Factors", vec![Block::Table(factors_table(factors))]));
    let runs = held_out(result);
    numbers.extend(changes::number(&runs));
    let caption = "Root mean square of measured less simulated.";
    let table = changes::table(caption, &["run"], ["before", "after"], &runs);
    let held_out = vec![Block::Text(changes::sentence(&runs)), Block::Table(table)];
    sections.push(Section::new("Held-out doublets", held_out));
    Page {
        title: "How much of a commanded deflection acts".into(),
        lead: vec![format!(
            "{} by control surface, airspeed and deflection, fitted to {} and judged on {} that had no part in the fit.",
            counted(factors.len(), "factor", "factors"),
            counted(list(result, "training").len(), "measured doublet", "measured doublets"),
            counted(list(result, "holdout/runs").len(), "other", "others")
        )],
        numbers,
        sections,
        ..Page::default()
    }
}

fn factors_table(factors: &[Value]) -> PageTable {
    let columns: [Column; 7] = [
        ("surface", "control", word),
        ("V (m/s)", "V_m_s", short_at),
        ("commanded (deg)", "commanded_deg", short_at),
        ("equivalent (deg)", "equivalent_deg", short_at),
        ("K", "factor", decimals_at),
        ("standard error", "standard_error", decimals_at),
        ("doublets", "runs", short_at),
    ];
    table_of("", factors, &columns)
}

fn held_out(result: &Value) -> Vec<RunChange> {
    let change = |run: &Value| {
        let left = &run["residual_rms"];
        RunChange::of(vec![text(run, "run").to_owned()], &left["before"], &left["after"])
    };
    list(result, "holdout/runs").iter().map(change).collect()
}
