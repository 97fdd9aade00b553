//! `deck`: the wing as a Nastran deck, with structure, boxes, splines and, if given, corrections.

use std::time::Instant;

use coupling::{DeckOptions, NastranDeck};
use nastran::InputError;
use serde_json::json;
use structure::{Model, System, normal_modes};

use super::modes::hertz;
use crate::args::{Common, DeckArgs};
use crate::corrections::{corrected_wing, corrections_at, wing_path};
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::show;

/// Runs the command.
pub(crate) fn run(args: &DeckArgs, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let path = wing_path(args.wing.as_deref());
    let file = coupling::WingFile::read(&path)?;
    let options = DeckOptions { modes: args.count, bars: args.bars, corrections: corrections(args, common)? };
    let deck = NastranDeck::of(&file, &options)?;
    if deck.bulk.grids.is_empty() {
        let error = InputError::in_file(&path, "the wing has no structure to write");
        return Err(error.with_help("a rigid wing has boxes only; give it a structure or a deck").into());
    }
    if !deck.bulk.unknown.is_empty() {
        let list: Vec<String> = deck.bulk.unknown.iter().map(|(card, n)| format!("{n} {card}")).collect();
        show::note(&format!("not in the deck, as these cards are not read: {}", list.join(", ")));
    }
    if deck.kept_beams > 0 {
        show::note(&format!("{} tapered or offset beams stay CBEAM", deck.kept_beams));
    }
    let system = System::assemble(&Model::from_bulk(&deck.bulk)?)?;
    let modes = normal_modes(&system, args.count).map_err(Failure::computation)?;
    let boxes = aero::Lattice::from_bulk(&deck.bulk)?.len();
    let result = json!({
        "command": "deck", "wing": file.name, "wing_hash": file.hash, "file": "wing.bdf",
        "mass_kg": system.mass_properties().mass_kg, "grids": system.node_count(),
        "elements": deck.bulk.element_counts(), "frequencies_hz": hertz(&modes),
        "boxes": boxes, "splines": deck.bulk.splines.len(), "corrections_at_m_s": args.airspeed,
        "seconds": start.elapsed().as_secs_f64(),
    });
    let folder = ResultFolder::begin(&common.out("deck"))?;
    folder.write_text("wing.bdf", &deck.text)?;
    folder.write_json("result.json", &result)?;
    let out = folder.commit()?;
    let text = format!(
        "{}: {:.4} kg, {} grids, {boxes} boxes, {} splines; first frequency {:.4} Hz\nwritten to {}",
        file.name,
        system.mass_properties().mass_kg,
        system.node_count(),
        deck.bulk.splines.len(),
        hertz(&modes).first().copied().unwrap_or(0.0),
        out.join("wing.bdf").display()
    );
    show::summary(common, &text);
    show::json(common, &result)
}

/// The corrections of the file that is named, at the airspeed that is, for every box of the lattice.
fn corrections(args: &DeckArgs, common: &Common) -> Result<Option<aero::Corrections>, Failure> {
    let Some(path) = args.corrections.as_deref() else { return Ok(None) };
    let corrected = corrected_wing(args.wing.as_deref(), Some(path), None, common)?;
    let v_m_s = args.airspeed.unwrap_or_else(|| corrected.schedule.sets[0].v_m_s);
    let corrections = corrections_at(&corrected.schedule, v_m_s)?;
    Ok(Some(corrected.wing.padded(&corrections)?))
}
