//! The page of `deck`: what the written Nastran deck holds, and what other programs get of the corrections.

use report::Page;
use report::page::{Block, KeyNumber, Link, PageTable, Plate, Section};
use serde_json::Value;

use super::values::{LOADS, at, digits, list, short, short_at, text, whole_at};

/// Frequencies shown.
const MODES: usize = 20;

pub(super) fn page(result: &Value, plates: &mut Vec<Plate>) -> Page {
    let whole = |path: &str| whole_at(result, path);
    let first = list(result, "frequencies_hz").iter().find_map(Value::as_f64);
    let mut numbers = vec![
        KeyNumber::new(
            "mass",
            at(result, "mass_kg").map_or_else(|| "-".into(), |m| format!("{} kg", digits(m, 4))),
            "",
        ),
        KeyNumber::new("grids", whole("grids"), ""),
        KeyNumber::new("boxes", whole("boxes"), format!("on {} splines", whole("splines"))),
    ];
    if let Some(hz) = first {
        numbers.push(KeyNumber::new("first frequency", format!("{} Hz", digits(hz, 4)), ""));
    }
    let mut sections = vec![Section::new("Files", vec![Block::Links(files(result))])];
    let shapes = super::plates::figures("", std::mem::take(plates)).blocks;
    if !shapes.is_empty() {
        sections.push(Section::new("The structure", shapes));
    }
    sections.push(Section::new("Elements and frequencies", tables(result)));
    if result["left_out"].is_object() {
        sections.push(Section::new("What w2gj.bdf and qjj.op4 carry", left_out(&result["left_out"])));
    }
    Page {
        title: format!("Nastran deck of {}", text(result, "wing")),
        lead: vec![match at(result, "corrections_at_m_s") {
            Some(v) => format!(
                "Structure, boxes, splines, and the corrections at {} m/s as WKK and FA2J.",
                digits(v, 3)
            ),
            None => "Structure, boxes and splines, without corrections.".into(),
        }],
        numbers,
        sections,
        ..Page::default()
    }
}

fn files(result: &Value) -> Vec<Link> {
    let link = |name: &str, note: &str| Link { text: name.into(), to: name.into(), note: note.into() };
    let mut links = vec![link("wing.bdf", "the deck")];
    if result["left_out"].is_object() {
        links.push(link("w2gj.bdf", "incidences of the boxes, for programs without FA2J"));
        links.push(link("qjj.op4", "the corrected matrix of pressures, for programs without WKK"));
    }
    if result["model"].is_string() {
        links.push(link("model.h5", "matrices, modes and boxes as HDF5"));
    }
    links
}

fn tables(result: &Value) -> Vec<Block> {
    let mut elements = PageTable::new("Elements of the deck.", &["card", "elements"]);
    for (card, count) in result["elements"].as_object().into_iter().flatten() {
        elements.row([card.clone(), count.to_string()]);
    }
    let mut hertz =
        PageTable::new("Natural frequencies of the deck, read back.", &["mode", "frequency (Hz)"]);
    for (i, hz) in list(result, "frequencies_hz").iter().filter_map(Value::as_f64).take(MODES).enumerate() {
        hertz.row([(i + 1).to_string(), digits(hz, 5)]);
    }
    vec![Block::Table(elements), Block::Table(hertz)]
}

fn left_out(left: &Value) -> Vec<Block> {
    let caption = format!(
        "Left out: {}. Root loads at {} m/s and {} degrees, with all corrections and with what these files carry.",
        text(left, "what"),
        short_at(left, "V_m_s"),
        short_at(left, "alpha_deg")
    );
    let mut table = PageTable::new(caption, &["load", "all corrections", "carried"]);
    for (key, name, unit) in LOADS {
        let of = |which: &str| short(at(left, &format!("root_loads_{which}/{key}")));
        table.row([format!("{name} ({unit})"), of("complete"), of("carried")]);
    }
    vec![Block::Table(table)]
}
