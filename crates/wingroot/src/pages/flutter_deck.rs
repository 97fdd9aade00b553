//! The page of `flutter --deck`, in the deck's own units.

use report::Page;
use report::page::{Block, KeyNumber, PageTable, Plate, Section};
use serde_json::Value;

use super::plates::figures;
use super::values::{at, counted, digits, list, short_at, text};

pub(super) fn page(result: &Value, plates: &mut Vec<Plate>) -> Page {
    let cases = list(result, "subcases");
    let mut numbers = Vec::new();
    let mut sections = Vec::new();
    for case in cases {
        let mut table = PageTable::new(
            "",
            &["Mach", "density", "velocity", "frequency (Hz)", "branch", "becomes", "remarks"],
        );
        for condition in list(case, "conditions") {
            let remarks: Vec<&str> = list(condition, "remarks").iter().filter_map(Value::as_str).collect();
            let mut remarks = Some(remarks.join("; "));
            let changes = list(condition, "changes_of_stability");
            if changes.is_empty() {
                let speeds =
                    format!("{} to {}", short_at(condition, "speeds/0"), short_at(condition, "speeds/1"));
                let none = "-".to_owned();
                let [low, high] = [0, 1].map(|place| short_at(condition, &format!("machs/{place}")));
                table.row([
                    if low == high { low } else { format!("{low} to {high}") },
                    short_at(condition, "density"),
                    speeds,
                    none.clone(),
                    none,
                    "no change".to_owned(),
                    remarks.take().unwrap_or_default(),
                ]);
            }
            for change in changes {
                table.row([
                    short_at(change, "mach"),
                    short_at(change, "density"),
                    short_at(change, "velocity"),
                    short_at(change, "frequency_hz"),
                    short_at(change, "branch"),
                    text(change, "becomes").to_owned(),
                    remarks.take().unwrap_or_default(),
                ]);
                let is_first = numbers.len() < 2 && text(change, "becomes") == "unstable";
                if let Some(velocity) = at(change, "velocity").filter(|_| is_first) {
                    let what = if at(change, "frequency_hz") == Some(0.0) { "divergence" } else { "flutter" };
                    numbers.push(KeyNumber::new(what, digits(velocity, 5), "the deck's unit"));
                }
            }
        }
        let title = format!("Subcase {} {}", short_at(case, "subcase"), text(case, "label"));
        sections.push(Section::new(title.trim_end().to_owned(), vec![Block::Table(table)]));
    }
    sections.push(figures("V-g and V-f curves", std::mem::take(plates)));
    sections.retain(|section| !section.blocks.is_empty());
    Page {
        title: format!("Flutter of {}", text(result, "deck")),
        lead: vec![format!(
            "{}; velocities and densities in the deck's units. Roots are those of the p-k equation (PK, PKNL) or of the K \
             method, all of them, followed over airspeed.",
            counted(cases.len(), "subcase", "subcases")
        )],
        numbers,
        sections,
        ..Page::default()
    }
}
