//! The page of `deflection`.

use report::Page;
use report::page::{Block, KeyNumber, PageTable, Plate, Section};
use serde_json::Value;

use super::figures;
use super::values::{LOADS, at, counted, digits, from_to, list, short, short_at, text};

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
    sections.push(Section::new("Held-out doublets", vec![Block::Table(held_out(result))]));
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
    let head =
        ["surface", "V (m/s)", "commanded (deg)", "equivalent (deg)", "K", "standard error", "doublets"];
    let mut table = PageTable::new("", &head);
    for f in factors {
        table.row([
            text(f, "control").to_owned(),
            short_at(f, "V_m_s"),
            short_at(f, "commanded_deg"),
            short_at(f, "equivalent_deg"),
            at(f, "factor").map_or_else(|| "-".into(), |k| format!("{k:.4}")),
            at(f, "standard_error").map_or_else(|| "-".into(), |k| format!("{k:.4}")),
            short_at(f, "runs"),
        ]);
    }
    table
}

fn held_out(result: &Value) -> PageTable {
    let head = ["run", "Fz before (N)", "after", "Mx before (N m)", "after", "My before (N m)", "after"];
    let mut table = PageTable::new("Root mean square of measured less simulated.", &head);
    for run in list(result, "holdout/runs") {
        let mut row = vec![text(run, "run").to_owned()];
        for (key, ..) in LOADS {
            row.extend(["before", "after"].map(|when| short(at(run, &format!("residual_rms/{when}/{key}")))));
        }
        table.row(row);
    }
    table
}
