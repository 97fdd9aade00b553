//! The page of `modes`, with and without measurements.

use report::Page;
use report::page::{Block, KeyNumber, PageTable, Plate, Section};
use serde_json::Value;

use super::figures;
use super::values::{at, digits, list, short, short_at, text};

pub(super) fn page(result: &Value, plates: &mut Vec<Plate>) -> Page {
    let hertz = list(result, "frequencies_hz");
    let mut numbers: Vec<KeyNumber> = hertz
        .iter()
        .filter_map(Value::as_f64)
        .filter(|hz| *hz > 0.0)
        .take(3)
        .enumerate()
        .map(|(i, hz)| KeyNumber::new(format!("elastic mode {}", i + 1), format!("{} Hz", digits(hz, 4)), ""))
        .collect();
    if at(result, "mass_kg").is_some() {
        numbers.push(KeyNumber::new("mass", format!("{} kg", short_at(result, "mass_kg")), ""));
    }
    let mut sections = vec![figures("Shapes", std::mem::take(plates))];
    if !hertz.is_empty() {
        sections.push(Section::new("Frequencies", vec![Block::Table(table(result))]));
    }
    for name in ["measurements", "factors"] {
        if let Some(table) = of_objects(list(result, name)) {
            sections.push(Section::new(heading(name), vec![Block::Table(table)]));
        }
    }
    sections.retain(|section| !section.blocks.is_empty());
    let counted = at(result, "grids").map(|grids| {
        format!(
            "{grids} grids, {} free motions, {} rigid modes.",
            short_free(result),
            short_at(result, "rigid_modes")
        )
    });
    Page {
        title: format!("Natural modes of {}", text(result, "structure")),
        lead: counted.into_iter().collect(),
        numbers,
        sections,
        ..Page::default()
    }
}

fn short_free(result: &Value) -> String {
    at(result, "free_motions").map_or_else(|| "-".into(), |count| format!("{count:.0}"))
}

fn heading(name: &str) -> &'static str {
    if name == "factors" { "Fitted factors" } else { "Measurements beside the model" }
}

fn table(result: &Value) -> PageTable {
    let mut table = PageTable::new(
        "Effective masses tell how much of the mass a mode moves along an axis.",
        &["mode", "frequency (Hz)", "mass along x (kg)", "along y", "along z"],
    );
    let masses = list(result, "effective_masses");
    for (i, hz) in list(result, "frequencies_hz").iter().enumerate() {
        let mass = |axis: usize| short(masses.get(i).and_then(|mass| mass[axis].as_f64()));
        let hz = hz.as_f64().map_or_else(|| "-".into(), |hz| digits(hz, 5));
        table.row([(i + 1).to_string(), hz, mass(0), mass(1), mass(2)]);
    }
    table
}

/// A list of objects as a table: their names are the columns, and values that are no text or number are left out.
fn of_objects(list: &[Value]) -> Option<PageTable> {
    let simple = |value: &Value| match value {
        Value::String(text) => Some(text.clone()),
        Value::Number(number) => number.as_f64().map(|v| digits(v, 4)),
        Value::Bool(yes) => Some(if *yes { "yes" } else { "no" }.into()),
        Value::Null => Some("-".into()),
        _ => None,
    };
    let first = list.first()?.as_object()?;
    let names: Vec<&String> =
        first.iter().filter(|(_, value)| simple(value).is_some()).map(|(name, _)| name).collect();
    let head: Vec<String> = names.iter().map(|name| name.replace('_', " ")).collect();
    let mut table = PageTable { head, ..PageTable::default() };
    for entry in list {
        table.row(names.iter().map(|name| simple(&entry[name.as_str()]).unwrap_or_default()));
    }
    Some(table)
}
