//! `deck`: the wing as a Nastran deck, with structure, boxes, splines and, if given, corrections.

use std::time::Instant;

use coupling::{DeckOptions, NastranDeck};
use faer::Mat;
use nastran::InputError;
use serde_json::{Value, json};
use structure::{Flexibility, Model, System, normal_modes};

use super::modes::hertz;
use crate::args::{Common, DeckArgs};
use crate::corrections::{corrected_wing, corrections_at, wing_path};
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::show;

/// Load at the tip for the comparison of deflections, N.
const TIP_LOAD_N: f64 = 10.0;

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
    let tip = tip_load(&file, &deck.bulk, &system);
    let boxes = aero::Lattice::from_bulk(&deck.bulk)?.len();
    let result = json!({
        "command": "deck", "wing": file.name, "wing_hash": file.hash, "file": "wing.bdf",
        "mass_kg": system.mass_properties().mass_kg, "grids": system.node_count(),
        "elements": deck.bulk.element_counts(), "frequencies_hz": hertz(&modes),
        "boxes": boxes, "splines": deck.bulk.splines.len(), "corrections_at_m_s": args.airspeed, "tip_load": tip,
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

/// Deflections under a load at the outermost spline grid, for comparison with other programs; nothing for a structure
/// that is not held.
fn tip_load(file: &coupling::WingFile, bulk: &nastran::BulkData, system: &System) -> Option<Value> {
    let nodes = coupling::spline_nodes(file, bulk, system).ok()?;
    let y = |node: usize| system.points()[node].y;
    let tip = nodes.into_iter().max_by(|a, b| y(*a).total_cmp(&y(*b)))?;
    let mut load = Mat::zeros(6 * system.node_count(), 1);
    load[(6 * tip + 2, 0)] = TIP_LOAD_N;
    let free = Flexibility::new(system).ok()?.displacements(system.reduce(load.as_ref()).as_ref());
    let motion = system.expand(free.as_ref());
    let six: Vec<f64> = (0..6).map(|component| motion[(6 * tip + component, 0)]).collect();
    Some(json!({ "grid": system.node_ids()[tip], "fz_N": TIP_LOAD_N, "displacement_m_rad": six }))
}

/// The corrections of the file that is named, at the airspeed that is, for every box of the lattice.
fn corrections(args: &DeckArgs, common: &Common) -> Result<Option<aero::Corrections>, Failure> {
    let Some(path) = args.corrections.as_deref() else { return Ok(None) };
    let corrected = corrected_wing(args.wing.as_deref(), Some(path), None, common)?;
    let v_m_s = args.airspeed.unwrap_or_else(|| corrected.schedule.sets[0].v_m_s);
    let corrections = corrections_at(&corrected.schedule, v_m_s)?;
    Ok(Some(corrected.wing.padded(&corrections)?))
}
