//! The page of `statics`.

use report::Page;
use report::page::{Block, KeyNumber, PageTable, Plate, Section};
use serde_json::Value;

use super::plates::figures;
use super::values::{at, digits, list, text, whole_at};

pub(super) fn page(result: &Value, plates: &mut Vec<Plate>) -> Page {
    let grid = whole_at(result, "grid");
    let length = |key: &str| {
        let square: f64 = list(result, key).iter().filter_map(Value::as_f64).map(|u| u * u).sum();
        square.sqrt()
    };
    let is_large = result["large_deflections"] == true;
    let metres = |value: f64| format!("{} m", digits(value, 5));
    let mut numbers =
        vec![KeyNumber::new(format!("GRID {grid}"), metres(length("displacement_m")), "moves most")];
    if is_large {
        numbers.push(KeyNumber::new(
            "by linear theory",
            metres(length("linear_displacement_m")),
            "the same grid",
        ));
    }
    let mut sections = vec![figures("Shapes", std::mem::take(plates))];
    if is_large {
        sections.push(Section::new("Steps", vec![Block::Table(steps(result))]));
    }
    sections.retain(|section| !section.blocks.is_empty());
    Page {
        title: format!("Statics of {}", text(result, "structure")),
        lead: vec![format!(
            "Load set {}, {} grids, {} free motions, {} deflections.",
            whole_at(result, "load_set"),
            whole_at(result, "grids"),
            whole_at(result, "free_motions"),
            if is_large { "large" } else { "small" }
        )],
        numbers,
        sections,
        ..Page::default()
    }
}

fn steps(result: &Value) -> PageTable {
    let mut table = PageTable::new(
        "Displacements are those of the grid that moves most at the end.",
        &["share of the load", "iterations", "x (m)", "y (m)", "z (m)"],
    );
    for step in list(result, "steps") {
        let number = |path: &str| at(step, path).map_or_else(String::new, |value| digits(value, 5));
        table.row([
            number("load_factor"),
            whole_at(step, "iterations"),
            number("displacement_m/0"),
            number("displacement_m/1"),
            number("displacement_m/2"),
        ]);
    }
    table
}
