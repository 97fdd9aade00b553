//! The page of `gust`, in the deck's own units.

use report::Page;
use report::page::{Block, KeyNumber, PageTable, Plate, Section};
use serde_json::Value;

use super::plates::figures;
use super::values::{at, counted, digits, list, short_at, text};

pub(super) fn page(result: &Value, plates: &mut Vec<Plate>) -> Page {
    let cases = list(result, "subcases");
    let mut numbers = Vec::new();
    let mut sections = vec![figures("Answers", std::mem::take(plates))];
    for case in cases {
        let is_in_time = case["in_time"] == true;
        let when = if is_in_time { "at (s)" } else { "at (Hz)" };
        let mut table = PageTable::new("", &["of", "component", "highest", when, "lowest", when]);
        for row in list(case, "extremes") {
            let cells = ["highest", "highest_at", "lowest", "lowest_at"].map(|name| short_at(row, name));
            let [highest, highest_at, lowest, lowest_at] = cells;
            let (of, component) = (text(row, "of").to_owned(), text(row, "component").to_owned());
            table.row([of, component, highest, highest_at, lowest, lowest_at]);
        }
        let remarks: Vec<&str> = list(case, "remarks").iter().filter_map(Value::as_str).collect();
        let mut blocks = vec![Block::Text(format!(
            "GUST {}, velocity {}, dynamic pressure {}, Mach {}. {}",
            short_at(case, "gust"),
            short_at(case, "velocity"),
            short_at(case, "dynamic_pressure"),
            short_at(case, "mach"),
            remarks.join("; ")
        ))];
        blocks.push(Block::Table(table));
        let title = format!("Subcase {} {}", short_at(case, "subcase"), text(case, "label"));
        sections.push(Section::new(title.trim_end().to_owned(), blocks));
    }
    let random = list(result, "random");
    if !random.is_empty() {
        let mut table = PageTable::new("", &["RANDPS", "of", "component", "root mean square", "N0 (Hz)"]);
        for row in random {
            let (of, component) = (text(row, "of").to_owned(), text(row, "component").to_owned());
            table.row([short_at(row, "set"), of, component, short_at(row, "rms"), short_at(row, "n0_hz")]);
            if let Some(rms) = at(row, "rms").filter(|_| numbers.len() < 2) {
                let what = format!("rms of {} {}", text(row, "of"), text(row, "component"));
                numbers.push(KeyNumber::new(what, digits(rms, 5), "the deck's unit"));
            }
        }
        sections.push(Section::new("Random gusts".to_owned(), vec![Block::Table(table)]));
    }
    sections.retain(|section| !section.blocks.is_empty());
    Page {
        title: format!("Gusts of {}", text(result, "deck")),
        lead: vec![format!(
            "{}; all numbers in the deck's units. Modes of the deck in the doublet lattice, in the frequency domain; answers in \
             time are periodic.",
            counted(cases.len(), "subcase", "subcases")
        )],
        numbers,
        sections,
        ..Page::default()
    }
}
