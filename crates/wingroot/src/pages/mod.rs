//! The head of every command's `report.html`: from `result.json`'s numbers to sentences, key numbers and tables that an
//! aeroelastician reads, and the figures sorted under headings. [`crate::output::ResultFolder`] gathers the rest.

mod aircraft;
mod aircraft_deck;
mod calibrate;
mod changes;
mod deck;
mod deflection;
mod discover;
mod discover_campaigns;
mod discover_map;
mod docs;
mod flightloads;
mod flutter;
mod flutter_bent;
mod flutter_deck;
mod free;
mod gust;
mod hidden;
mod loads;
mod modes;
mod origin;
mod pipeline;
pub mod plates;
mod response;
mod simulate;
mod statics;
mod tunnel;
pub mod values;

pub use origin::input;
pub use plates::{Head, Written};

use plates::figures;
use report::Page;

/// The page of a command's results; none for commands without one.
pub(crate) fn page(written: Written) -> Option<Page> {
    let Written { result, mut plates, inputs, head, .. } = written;
    let command = result["command"].as_str().unwrap_or_default();
    let known: Head = match command {
        "calibrate" => calibrate::page,
        "deflection" => deflection::page,
        "simulate" => simulate::page,
        "discover" => discover::page,
        "discover --campaigns" => discover_campaigns::page,
        "fullaircraft" => aircraft::page,
        "fullaircraft --cases" => aircraft::cases,
        "fullaircraft --deck" => aircraft_deck::page,
        "flightloads" => flightloads::page,
        "flutter" => flutter::page,
        "free" => free::page,
        "flutter --deck" => flutter_deck::page,
        "gust" => gust::page,
        "loads" => loads::page,
        "modes" => modes::page,
        "statics" => statics::page,
        "deck" => deck::page,
        "docs" => docs::page,
        "tunnel" => tunnel::page,
        "hidden" => hidden::page,
        "response" => response::page,
        "pipeline" => pipeline::page,
        _ => head?,
    };
    let mut page = known(&result, &mut plates);
    command.clone_into(&mut page.command);
    if !plates.is_empty() {
        page.sections.push(figures("Figures", plates));
    }
    page.inputs = inputs;
    page.run = origin::lines();
    Some(page)
}
