//! The page of `fullaircraft --deck`: the trims of a whole-aircraft deck, in the deck's own units.

use report::Page;
use report::page::{Block, KeyNumber, PageTable, Plate, Section};
use serde_json::Value;

use super::plates::figures;
use super::values::{at, counted, decimals_at, digits, five_at, list, short_at, text};

/// Trimmed variables that stand at the top.
const FIRST: usize = 4;

pub(super) fn page(result: &Value, plates: &mut Vec<Plate>) -> Page {
    let cases = list(result, "subcases");
    let refused = cases.iter().filter(|case| case["refused"].is_string()).count();
    let mut numbers: Vec<KeyNumber> = values(cases.first().unwrap_or(&Value::Null))
        .take(FIRST)
        .map(|(name, value)| {
            KeyNumber::new(name.clone(), digits(value, 5), "first subcase, the deck's units")
        })
        .collect();
    let asked = list(result, "divergences");
    if let Some(q) = asked.first().and_then(|one| at(one, "q/0")) {
        numbers.push(KeyNumber::new("divergence q", digits(q, 5), "first DIVERG, the deck's units"));
    }
    numbers.push(KeyNumber::new("refused subcases", refused.to_string(), "").judged(refused == 0));
    let mut lead = vec![format!(
        "{} with {} boxes; forces, lengths and pressures in the deck's units, angles in radians.",
        counted(cases.len(), "subcase", "subcases"),
        at(result, "boxes").unwrap_or_default()
    )];
    let skipped: Vec<String> = result["cards_not_read"]
        .as_object()
        .into_iter()
        .flatten()
        .map(|(card, count)| format!("{count} {card}"))
        .collect();
    if !skipped.is_empty() {
        lead.push(format!("Cards that were not read: {}.", skipped.join(", ")));
    }
    let mut sections: Vec<Section> = cases.iter().map(subcase).collect();
    sections.extend(divergences(list(result, "divergences")));
    sections.push(figures("Figures", std::mem::take(plates)));
    sections.retain(|section| !section.blocks.is_empty());
    Page { title: format!("Trims of {}", text(result, "deck")), lead, numbers, sections, ..Page::default() }
}

/// Trimmed variables that are not zero.
fn values(case: &Value) -> impl Iterator<Item = (&String, f64)> {
    let all = case["values"].as_object().into_iter().flatten();
    all.filter_map(|(name, value)| Some((name, value.as_f64()?)))
        .filter(|(name, value)| *value != 0.0 && *name != "INTERCEPT")
}

fn subcase(case: &Value) -> Section {
    let title =
        format!("Subcase {} {}", short_at(case, "subcase"), text(case, "label")).trim_end().to_owned();
    if let Some(why) = case["refused"].as_str() {
        return Section::new(title, vec![Block::Text(format!("Refused: {why}"))]);
    }
    let caption = format!(
        "TRIM {}, Mach {}, q {}.",
        short_at(case, "trim"),
        short_at(case, "mach"),
        short_at(case, "q")
    );
    let mut trimmed = PageTable::new(caption, &["variable", "value"]);
    for (name, value) in case["values"].as_object().into_iter().flatten() {
        trimmed.row([name.clone(), five_at(value, "")]);
    }
    if let Some(angle) = at(case, "mean_angle_of_attack_rad") {
        trimmed.row(["ANGLEA of the mean axes (above: of the SUPORT grid)".to_owned(), digits(angle, 5)]);
    }
    if let Some(lift) = at(case, "lift") {
        trimmed.row(["lift".to_owned(), digits(lift, 5)]);
    }
    for (place, how) in ["rigid", "restrained", "unrestrained"].into_iter().enumerate() {
        if let Some(x) = at(case, &format!("neutral_point_x/{place}")) {
            trimmed.row([format!("neutral point x, {how}"), digits(x, 5)]);
        }
    }
    for (number, q) in list(case, "divergence_q").iter().filter_map(Value::as_f64).enumerate() {
        trimmed.row([format!("divergence q {}", number + 1), digits(q, 5)]);
    }
    let mut blocks = vec![Block::Table(trimmed)];
    if case["monitors"].as_object().is_some_and(|all| !all.is_empty()) {
        blocks.push(Block::Table(monitors(case)));
    }
    blocks.extend(derivatives(case).map(Block::Table));
    Section::new(title, blocks)
}

fn divergences(all: &[Value]) -> Option<Section> {
    let mut table = PageTable::new("What DIVERG asks for.", &["subcase", "Mach", "dynamic pressures"]);
    for one in all {
        let q: Vec<String> = list(one, "q").iter().filter_map(Value::as_f64).map(|q| digits(q, 5)).collect();
        let q = if q.is_empty() { "none".to_owned() } else { q.join(", ") };
        let name = format!("{} {}", short_at(one, "subcase"), text(one, "label"));
        table.row([name.trim_end().to_owned(), short_at(one, "mach"), q]);
    }
    (!all.is_empty()).then(|| Section::new("Divergence", vec![Block::Table(table)]))
}

fn monitors(case: &Value) -> PageTable {
    let mut table =
        PageTable::new("Loads at the monitor points.", &["station", "Fx", "Fy", "Fz", "Mx", "My", "Mz"]);
    for (name, loads) in case["monitors"].as_object().into_iter().flatten() {
        let six = (0..6).map(|c| five_at(&loads[c], ""));
        table.row(std::iter::once(name.clone()).chain(six));
    }
    table
}

fn derivatives(case: &Value) -> Option<PageTable> {
    let all = case["derivatives"].as_object().filter(|all| !all.is_empty())?;
    let caption =
        "Stability and control derivatives about the reference axes: rigid, restrained, unrestrained.";
    let mut table = PageTable::new(caption, &["variable", "kind", "CX", "CY", "CZ", "Cl", "Cm", "Cn"]);
    for (name, of) in all {
        for kind in ["rigid", "restrained", "unrestrained"] {
            if of[kind].as_object().is_some_and(|of| !of.is_empty()) {
                let six = ["CX", "CY", "CZ", "Cl", "Cm", "Cn"].map(|c| decimals_at(&of[kind], c));
                table.row([name.clone(), kind.to_owned()].into_iter().chain(six));
            }
        }
    }
    Some(table)
}
