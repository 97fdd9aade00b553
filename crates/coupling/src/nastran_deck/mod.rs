//! A wing as a deck that Nastran and pyNastran read: executive and case control for normal modes (SOL 103), and the
//! bulk data of structure, boxes, control surfaces, splines and corrections.
//!
//! All clamps and equations of the model apply in the case control. Masses are consistent (PARAM COUPMASS) unless the
//! wing's own deck says otherwise, as in this program. What this program needs no card for is added: splines from the
//! wing file's spline and grids, AEROS and AERO, an EIGRL.

mod aerodynamics;
mod bars;

pub use bars::bars_for_beams;

use crate::error::CouplingError;
use crate::wing_file::{Mount, WingFile};
use aero::Corrections;
use nastran::{BulkData, write_deck};
use std::collections::BTreeSet;
use std::fmt::Write as _;

/// EIGRL of the case control.
const METHOD: u32 = 1;

/// What a deck is to hold.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct DeckOptions {
    /// Number of modes.
    pub modes: usize,
    /// CBAR and PBAR where CBEAM and PBEAM say no more, for programs that have no CBEAM.
    pub bars: bool,
    /// Corrections of every box of the lattice, fairing included, to be written as WKK and FA2J.
    pub corrections: Option<Corrections>,
}

/// A wing's deck.
#[derive(Debug, Clone, PartialEq)]
pub struct NastranDeck {
    /// The cards that [`nastran::BulkData`] knows.
    pub bulk: BulkData,
    /// The whole file.
    pub text: String,
    /// Beams that stay CBEAM although bars were asked for, as bars cannot say what they say.
    pub kept_beams: usize,
}

impl NastranDeck {
    /// The deck of a wing as it is held in the tunnel.
    ///
    /// # Errors
    /// If the wing's files cannot be read or its boxes are none.
    pub fn of(file: &WingFile, options: &DeckOptions) -> Result<Self, CouplingError> {
        let mut bulk = file.bulk(Mount::Tunnel)?.with_distinct_elements();
        let mut kept_beams = 0;
        if options.bars {
            kept_beams = bars_for_beams(&mut bulk);
        }
        bulk.parameters.entry("COUPMASS".into()).or_insert(1.0);
        bulk.parameters.entry("GRDPNT".into()).or_insert(0.0);
        let aerodynamics = aerodynamics::add(&mut bulk, file)?;
        if let Some(corrections) = &options.corrections {
            for matrix in [corrections.wkk(), corrections.fa2j()] {
                let matrix = matrix.rounded_to_fields();
                bulk.matrices.insert(matrix.name.clone(), matrix);
            }
        }
        let mut text = control(file, &bulk, options.modes);
        let cards = write_deck(&bulk);
        let (body, end) = cards.rsplit_once("ENDDATA").unwrap_or((&cards, ""));
        text.push_str(body);
        text.push_str(&unions(&bulk));
        let _ = writeln!(text, "EIGRL,{METHOD},,,{}", options.modes);
        text.push_str(&aerodynamics);
        text.push_str("ENDDATA");
        text.push_str(end);
        Ok(Self { bulk, text, kept_beams })
    }
}

/// Executive and case control.
fn control(file: &WingFile, bulk: &BulkData, modes: usize) -> String {
    // Titles are plain characters without the comment sign.
    let title: String =
        file.name.chars().map(|c| if c.is_ascii_graphic() && c != '$' { c } else { ' ' }).take(60).collect();
    let mut text = format!(
        "$ {title}, written by wingroot: SI units, x aft, y to the right tip, z up\n\
         SOL 103\nCEND\nTITLE = {title}\nSUBTITLE = {modes} NORMAL MODES\nECHO = NONE\nMETHOD = {METHOD}\n"
    );
    for (keyword, sets) in [("SPC", clamp_sets(bulk)), ("MPC", equation_sets(bulk))] {
        if let Some(set) = selected(&sets) {
            let _ = writeln!(text, "{keyword} = {set}");
        }
    }
    text.push_str("DISPLACEMENT(PLOT) = ALL\n");
    text
}

fn clamp_sets(bulk: &BulkData) -> BTreeSet<u32> {
    bulk.constraints.iter().map(|card| card.set).collect()
}

fn equation_sets(bulk: &BulkData) -> BTreeSet<u32> {
    bulk.equations.iter().map(|card| card.set).collect()
}

/// The set that the case control names: the only one, or the union that [`unions`] makes of several.
fn selected(sets: &BTreeSet<u32>) -> Option<u32> {
    let last = *sets.last()?;
    Some(if sets.len() == 1 { last } else { last + 1 })
}

/// SPCADD and MPCADD where several sets apply.
fn unions(bulk: &BulkData) -> String {
    let mut text = String::new();
    for (name, sets) in [("SPCADD", clamp_sets(bulk)), ("MPCADD", equation_sets(bulk))] {
        if let Some(union) = selected(&sets).filter(|_| sets.len() > 1) {
            let _ = write!(text, "{name:<8}{union:>8}");
            for (at, set) in sets.iter().enumerate() {
                // Eight fields a line, the first of which on the first line is the union.
                if at > 0 && (at + 1) % 8 == 0 {
                    text.push_str("\n+       ");
                }
                let _ = write!(text, "{set:>8}");
            }
            text.push('\n');
        }
    }
    text
}

#[cfg(test)]
mod tests;
