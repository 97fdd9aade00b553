//! The page of `modes`, with and without measurements.

use report::Page;
use report::page::{Block, KeyNumber, PageTable, Plate, Section};
use serde_json::Value;

use super::plates::figures;
use super::values::{
    Column, at, counted, digits, five_at, four_at, from_to, list, rounded, short, short_at, table_of, text,
    whole_at, word,
};

pub(super) fn page(result: &Value, plates: &mut Vec<Plate>) -> Page {
    if result.get("measurements").is_some() {
        return fitted(result, plates);
    }
    let hertz = list(result, "frequencies_hz");
    let mut numbers: Vec<KeyNumber> = hertz
        .iter()
        .filter_map(Value::as_f64)
        .filter(|hz| *hz > 0.0)
        .take(3)
        .enumerate()
        .map(|(i, hz)| KeyNumber::new(format!("elastic mode {}", i + 1), format!("{} Hz", digits(hz, 4)), ""))
        .collect();
    numbers.push(KeyNumber::new("mass", format!("{} kg", short_at(result, "mass_kg")), ""));
    let mut sections = vec![figures("Shapes", std::mem::take(plates))];
    sections.push(Section::new("Frequencies", vec![Block::Table(frequencies(result))]));
    sections.retain(|section| !section.blocks.is_empty());
    let whole = |path: &str| whole_at(result, path);
    Page {
        title: format!("Natural modes of {}", text(result, "structure")),
        lead: vec![format!(
            "{} grids, {} free motions, {} rigid modes.",
            whole("grids"),
            whole("free_motions"),
            whole("rigid_modes")
        )],
        numbers,
        sections,
        ..Page::default()
    }
}

fn frequencies(result: &Value) -> PageTable {
    let mut table = PageTable::new(
        "Effective masses tell how much of the mass a mode moves along an axis.",
        &["mode", "frequency (Hz)", "mass along x (kg)", "along y", "along z"],
    );
    let masses = list(result, "effective_masses");
    let total = at(result, "mass_kg").unwrap_or_default();
    for (i, hz) in list(result, "frequencies_hz").iter().enumerate() {
        // what symmetry forbids comes out of the round-off
        let above = |mass: &f64| *mass > 1e-6 * total;
        let mass = |axis: usize| {
            let mass = masses.get(i).and_then(|mass| mass[axis].as_f64());
            mass.map_or_else(|| "-".into(), |mass| short(Some(mass).filter(above).or(Some(0.0))))
        };
        table.row([
            (i + 1).to_string(),
            digits(hz.as_f64().unwrap_or(f64::NAN), 5),
            mass(0),
            mass(1),
            mass(2),
        ]);
    }
    table
}

/// The page of a fit to measurements.
fn fitted(result: &Value, plates: &mut Vec<Plate>) -> Page {
    let factors = list(result, "factors");
    let mut numbers = vec![
        KeyNumber::new(
            "sum of squares",
            from_to(
                at(result, "before/chi_square"),
                at(result, "after/chi_square").map(|sum| rounded(sum, 6)),
                "",
            ),
            format!(
                "in sigma, before and after, {} degrees of freedom",
                short_at(result, "degrees_of_freedom")
            ),
        )
        .judged(result["converged"] == true),
    ];
    for factor in factors {
        let label = format!("{} of {}", text(factor, "quantity"), text(factor, "region"));
        let (value, note) = match at(factor, "sigma") {
            Some(sigma) => (four_at(factor, "value"), format!("\u{b1} {}", digits(sigma, 2))),
            None => ("not determined".to_owned(), "the measurements do not tell it from others".to_owned()),
        };
        numbers.push(KeyNumber::new(label, value, note).judged(factor["determined"] == true));
    }
    let mut sections =
        vec![Section::new("Measurements beside the model", vec![Block::Table(measured(result))])];
    sections.push(figures("What is left", std::mem::take(plates)));
    if !factors.is_empty() {
        sections.push(Section::new("Fitted factors", vec![Block::Table(factors_table(factors))]));
    }
    sections.push(Section::new("Frequencies", vec![Block::Table(before_and_after(result))]));
    sections.retain(|section| !section.blocks.is_empty());
    Page {
        title: format!("{} beside its measurements", text(result, "structure")),
        lead: vec![format!(
            "{} of regions' stiffness and mass, fitted to {}; a factor of one is the model as given.",
            counted(factors.len(), "factor", "factors"),
            counted(list(result, "measurements").len(), "measurement", "measurements")
        )],
        numbers,
        sections,
        ..Page::default()
    }
}

fn measured(result: &Value) -> PageTable {
    let off = |row: &Value, model: &str| {
        let off = |model: f64| Some((model - at(row, "measured")?) / at(row, "sigma")?);
        at(row, model).and_then(off).map_or_else(|| "-".into(), |off| format!("{:+.2}", rounded(off, 2)))
    };
    let columns: [Column; 8] = [
        ("measured", "name", word),
        ("unit", "unit", word),
        ("value", "measured", four_at),
        ("sigma", "sigma", short_at),
        ("initial model", "before", four_at),
        ("updated", "after", four_at),
        ("off (sigma)", "before", off),
        ("then", "after", off),
    ];
    let caption = "Off: model less measurement in standard deviations of it.";
    table_of(caption, list(result, "measurements"), &columns)
}

fn factors_table(factors: &[Value]) -> PageTable {
    let columns: [Column; 5] = [
        ("region", "region", word),
        ("quantity", "quantity", word),
        ("factor", "value", four_at),
        ("sigma", "sigma", short_at),
        ("determined", "determined", |factor, key| if factor[key] == true { "yes" } else { "no" }.to_owned()),
    ];
    table_of("", factors, &columns)
}

fn before_and_after(result: &Value) -> PageTable {
    let mut table = PageTable::new("", &["mode", "initial (Hz)", "updated (Hz)"]);
    let (before, after) = (list(result, "before/frequencies_hz"), list(result, "after/frequencies_hz"));
    for (mode, (before, after)) in before.iter().zip(after).enumerate() {
        table.row([(mode + 1).to_string(), five_at(before, ""), five_at(after, "")]);
    }
    table
}
