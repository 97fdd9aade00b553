//! The head of every command's `report.html`: from `result.json`'s numbers to sentences, key numbers and tables that an
//! aeroelastician reads, and the figures sorted under headings. [`crate::output::ResultFolder`] gathers the rest.

mod aircraft;
mod aircraft_deck;
mod bench;
mod calibrate;
mod deck;
mod deflection;
mod discover;
mod discover_map;
mod flutter;
mod hidden;
mod modes;
mod origin;
mod pipeline;
mod response;
mod simulate;
mod tunnel;
mod validate;
mod values;

pub use origin::input;

use report::Page;
use report::page::{Block, Content, Plate, Section};
use serde_json::Value;

use crate::output::Written;

/// So many figures with curves stand open on a page; more are folded up.
const OPEN: usize = 6;

/// The page of a command's results; none for commands without one.
pub(crate) fn page(written: Written) -> Option<Page> {
    let Written { result, mut plates, inputs, .. } = written;
    let command = result["command"].as_str().unwrap_or_default();
    let head: fn(&Value, &mut Vec<Plate>) -> Page = match command {
        "calibrate" => calibrate::page,
        "deflection" => deflection::page,
        "simulate" => simulate::page,
        "discover" => discover::page,
        "fullaircraft" => aircraft::page,
        "fullaircraft --cases" => aircraft::cases,
        "fullaircraft --deck" => aircraft_deck::page,
        "flutter" => flutter::page,
        "modes" => modes::page,
        "deck" => deck::page,
        "tunnel" => tunnel::page,
        "hidden" => hidden::page,
        "bench" => bench::page,
        "response" => response::page,
        "validate" => validate::page,
        "pipeline" => pipeline::page,
        _ => return None,
    };
    let mut page = head(&result, &mut plates);
    command.clone_into(&mut page.command);
    if !plates.is_empty() {
        page.sections.push(figures("Figures", plates));
    }
    page.inputs = inputs;
    page.run = origin::lines();
    Some(page)
}

/// A section of figures; curves beyond the first few are folded up.
fn figures(title: &str, plates: Vec<Plate>) -> Section {
    let mut open = 0;
    let block = |mut plate: Plate| {
        if matches!(plate.content, Content::Curves(_)) {
            open += 1;
            plate.folded |= open > OPEN;
        }
        Block::Plate(Box::new(plate))
    };
    Section::new(title, plates.into_iter().map(block).collect())
}

/// Takes the figures whose names begin with something out of the list.
fn taken(plates: &mut Vec<Plate>, prefix: &str) -> Vec<Plate> {
    let (chosen, rest) = plates.drain(..).partition(|plate: &Plate| plate.name.starts_with(prefix));
    *plates = rest;
    chosen
}
