//! `deck`: the wing as a Nastran deck, with structure, boxes, splines and, if given, corrections.

use clap::Args;
use std::path::{Path, PathBuf};
use std::time::Instant;

use coupling::exchange::LeftOut;
use coupling::{DeckOptions, ElasticWing, Exchange, NastranDeck};
use faer::Mat;
use nastran::InputError;
use serde_json::Value;
use structure::{Flexibility, Model, System, normal_modes};

use super::modes_pictures::hertz;
use super::{deck_hdf5, modes_shapes};
use crate::args::{Common, Given, Measured, airspeed, whole};
use crate::commands::deck_result::{DeckResult, LeftOutOfDeck, TipLoad};
use crate::commands::result_parts::as_json;
use crate::corrections::{CorrectedWing, corrected_wing};
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::{paths, show};

/// Options of `deck`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  wingroot deck
  wingroot deck --wing my_wing/wing.ron --corrections out/my_wing/corrections.ron --airspeed 20
  wingroot deck --bars --count 6 --hdf5

With corrections the deck has them as WKK and FA2J, and beside it stand, for programs without these, w2gj.bdf (camber
plus what acts as the pressure offsets) and qjj.op4 (pressures per incidence with the force factors in them); what
they leave out is in result.json under `left_out`.")]
pub struct DeckArgs {
    /// The wing [default: wing.ron of the current folder]
    #[arg(long, value_name = "FILE")]
    pub(crate) wing: Option<PathBuf>,
    /// Corrections from `calibrate` to write as WKK and FA2J
    #[arg(long, value_name = "FILE")]
    pub(crate) corrections: Option<PathBuf>,
    /// Take corrections of a fit that stalled or diverged all the same
    #[arg(long, requires = "corrections")]
    pub(crate) accept_unconverged: bool,
    /// Airspeed of the corrections, m/s [default: the first of the file]
    #[arg(long, value_name = "V", requires = "corrections", value_parser = airspeed)]
    pub(crate) airspeed: Option<f64>,
    /// Number of modes asked for in the case control
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = whole::<10_000>)]
    pub(crate) count: usize,
    /// Write CBAR and PBAR instead of CBEAM and PBEAM where the section is uniform and has no offsets (for programs
    /// without CBEAM)
    #[arg(long)]
    pub(crate) bars: bool,
    /// Write model.h5, too: boxes, pressures, modes, and with corrections these and the linear systems that `simulate` flies
    #[arg(long)]
    pub(crate) hdf5: bool,
}

/// Load at the tip for the comparison of deflections, N.
const TIP_LOAD_N: f64 = 10.0;
/// Density at sea level and an angle, at which what cannot be carried to other programs is shown.
const RHO_KG_M3: f64 = 1.225;
const ALPHA_DEG: f64 = 4.0;

/// Corrections at one airspeed, for the deck and for programs without WKK and FA2J.
struct AtAirspeed {
    v_m_s: f64,
    padded: aero::Corrections,
    /// None if these corrections cannot be carried so.
    exchange: Option<(Exchange, LeftOut)>,
    corrected: CorrectedWing,
    corrections: aero::Corrections,
    flow: aero::Flow,
}

/// Runs the command.
pub(crate) fn run(args: &DeckArgs, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let path = paths::wing(args.wing.as_deref())?;
    let file = coupling::WingFile::read(&path)?;
    let corrections = corrections(args)?;
    let padded = corrections.as_ref().map(|at| at.padded.clone());
    let options = DeckOptions { modes: args.count, bars: args.bars, corrections: padded };
    let deck = NastranDeck::of(&file, &options)?;
    if deck.bulk.grids.is_empty() {
        let error = InputError::in_file(&path, "the wing has no structure to write");
        return Err(error.with_help("a rigid wing has boxes only; give it a structure or a deck").into());
    }
    if let Some(cards) = deck.bulk.unread_cards() {
        show::note(&format!("not in the deck, as these cards are not read: {cards}"));
    }
    if deck.kept_beams > 0 {
        show::note(&format!("{} tapered or offset beams stay CBEAM", deck.kept_beams));
    }
    let system = System::assemble(&Model::from_bulk(&deck.bulk)?)?;
    let modes = normal_modes(&system, args.count).map_err(Failure::computation)?;
    let boxes = aero::Lattice::from_bulk(&deck.bulk)?.len();
    let result = as_json(&DeckResult {
        command: "deck",
        wing: file.name.clone(),
        wing_hash: file.hash.clone(),
        file: "wing.bdf",
        mass_kg: system.mass_properties().mass_kg,
        grids: system.node_count(),
        elements: deck.bulk.element_counts(),
        frequencies_hz: hertz(&modes),
        boxes,
        splines: deck.bulk.splines.len(),
        tip_load: tip_load(&file, &deck.bulk, &system),
        corrections_at_m_s: corrections.as_ref().map(|at| at.v_m_s),
        left_out: corrections.as_ref().and_then(left_out),
        model: args.hdf5.then_some("model.h5"),
        seconds: start.elapsed().as_secs_f64(),
    })?;
    let model = if args.hdf5 { Some(model(&path, args, corrections.as_ref())?) } else { None };
    let folder = ResultFolder::begin(&common.out("deck"))?;
    folder.input("wing", &path)?;
    let cells = structure::mesh::cells(&deck.bulk, &system);
    modes_shapes::write(&folder, &file.name, &system, &cells, &modes, &[])?;
    let out = write(folder, &deck, corrections.as_ref(), model.as_deref(), &result)?;
    let mut text = format!(
        "{}: {:.4} kg, {} grids, {boxes} boxes, {} splines; first frequency {:.4} Hz\nwritten to {}",
        file.name,
        system.mass_properties().mass_kg,
        system.node_count(),
        deck.bulk.splines.len(),
        hertz(&modes).first().copied().unwrap_or(0.0),
        out.join("wing.bdf").display()
    );
    text.push_str(&corrections.as_ref().map_or_else(String::new, carried));
    show::summary(common, &text);
    show::json(common, &result)
}

/// The model as HDF5.
fn model(path: &Path, args: &DeckArgs, corrections: Option<&AtAirspeed>) -> Result<Vec<u8>, Failure> {
    let (_, wing) = ElasticWing::read(path)?;
    let corrected = corrections.map(|at| (&at.corrected, &at.corrections, at.flow));
    deck_hdf5::file(&wing, args.count, corrected)
}

fn write(
    folder: ResultFolder,
    deck: &NastranDeck,
    corrections: Option<&AtAirspeed>,
    model: Option<&[u8]>,
    result: &Value,
) -> Result<PathBuf, Failure> {
    folder.write_text("wing.bdf", &deck.text)?;
    if let Some((exchange, _)) = corrections.and_then(|at| at.exchange.as_ref()) {
        folder.write_text("w2gj.bdf", &exchange.w2gj().write())?;
        folder.write_text("qjj.op4", &exchange.op4())?;
    }
    if let Some(bytes) = model {
        folder.write_bytes("model.h5", bytes)?;
    }
    folder.write_json("result.json", result)?;
    folder.commit()
}

/// What is written for programs without WKK and FA2J, in words.
fn carried(at: &AtAirspeed) -> String {
    let Some((_, left_out)) = &at.exchange else { return String::new() };
    format!(
        "\nfor programs without WKK and FA2J: w2gj.bdf and qjj.op4 carry the lift of every box; moment factors are left out: \
         My at {} m/s and {ALPHA_DEG} degrees {:.4} instead of {:.4} N m",
        at.v_m_s, left_out.carried.my_nm, left_out.complete.my_nm
    )
}

/// What w2gj.bdf and qjj.op4 do not carry, in numbers.
fn left_out(at: &AtAirspeed) -> Option<LeftOutOfDeck> {
    let (_, left_out) = at.exchange.as_ref()?;
    Some(LeftOutOfDeck {
        what: "the moment factors: a box's moment about its midpoint is that of its corrected lift at the quarter chord",
        v_m_s: at.v_m_s,
        rho_kg_m3: RHO_KG_M3,
        alpha_deg: ALPHA_DEG,
        root_loads_complete: left_out.complete.into(),
        root_loads_carried: left_out.carried.into(),
    })
}

/// Deflections under a load at the outermost spline grid, for comparison with other programs; nothing for a structure
/// that is not held.
fn tip_load(file: &coupling::WingFile, bulk: &nastran::BulkData, system: &System) -> Option<TipLoad> {
    let nodes = coupling::spline_nodes(file, bulk, system).ok()?;
    let y = |node: usize| system.points()[node].y;
    let tip = nodes.into_iter().max_by(|a, b| y(*a).total_cmp(&y(*b)))?;
    let mut load = Mat::zeros(6 * system.node_count(), 1);
    load[(6 * tip + 2, 0)] = TIP_LOAD_N;
    let free = Flexibility::new(system).ok()?.displacements(system.reduce(load.as_ref()).as_ref());
    let motion = system.expand(free.as_ref());
    let displacement_m_rad = (0..6).map(|component| motion[(6 * tip + component, 0)]).collect();
    Some(TipLoad { grid: system.node_ids()[tip], fz_n: TIP_LOAD_N, displacement_m_rad })
}

/// The corrections of the file that is named, at the airspeed that is.
fn corrections(args: &DeckArgs) -> Result<Option<AtAirspeed>, Failure> {
    let Some(path) = &args.corrections else { return Ok(None) };
    let given = Given {
        measured: Measured { wing: args.wing.clone(), campaign: None },
        corrections: Some(path.clone()),
        accept_unconverged: args.accept_unconverged,
        no_intervals: true,
    };
    let corrected = corrected_wing(&given)?;
    let v_m_s = args.airspeed.unwrap_or_else(|| corrected.schedule.sets[0].v_m_s);
    let corrections = corrected.schedule.at(v_m_s)?;
    let wing = &corrected.wing;
    let flow = aero::Flow { v_m_s, rho_kg_m3: RHO_KG_M3 };
    let exchange = match Exchange::of(wing, &corrections) {
        Ok(exchange) => {
            Some((exchange, Exchange::left_out(wing, &corrections, flow, ALPHA_DEG.to_radians())?))
        }
        Err(error) => {
            show::note(&format!("w2gj.bdf and qjj.op4 are not written: {error}"));
            None
        }
    };
    let padded = wing.padded(&corrections)?;
    Ok(Some(AtAirspeed { v_m_s, padded, exchange, corrected, corrections, flow }))
}
