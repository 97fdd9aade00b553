//! A study as the text of a deck.

use super::cards::{Asked, FIRST, card};
use super::fault::Fault;
use super::file::{Aim, Masses, Splines, Study};
use super::flutter::Flutter;
use super::gusts::Gusts;
use super::matrix::MassTerms;
use super::nearest;
use super::unsteady::Motion;
use aero::{Lattice, StreamAxes};
use nastran::{BulkData, Frames, InputError, Span, memory, parse_deck, read_text};
use std::fmt::Write as _;
use std::path::Path;

/// The system of upright panels.
const UPRIGHT: u32 = FIRST + 3;
/// First number of its splines, with their sets and lists.
const SPLINES: u32 = FIRST + 1000;
/// Name of its mass matrix.
const MASS: &str = "MASSES";
/// What the decks' own masses are multiplied with where a matrix stands in their place (M2GG is in units of mass).
const NOTHING: &str = "1.E-30";

/// A study as a deck.
#[derive(Debug, Clone)]
pub struct Deck {
    /// Executive and case control and cards, the decks included.
    pub text: String,
    /// What it says.
    pub bulk: BulkData,
}

impl Study {
    /// The study as a deck of one of its sections; `terms` are those of [`Masses::Matrix`].
    ///
    /// # Errors
    /// If the study has no such section or lacks what that needs, a deck cannot be read or has a case control, what the section names is
    /// not there or given by the decks as well, the matrix is of another structure, or the decks weigh in other units than mass (PARAM
    /// WTMASS) beside it.
    pub fn deck(&self, path: &Path, aim: Aim, terms: Option<&MassTerms>) -> Result<Deck, InputError> {
        self.demand(path, aim)?;
        // Places in what is made here are none of the study's file.
        let name = format!("{} as a deck", path.display());
        let includes = self.includes(path)?;
        let decks = parse_deck(&name, &includes)?;
        let asked = self.asked(path, aim, &decks)?;
        let mut text = match aim {
            Aim::Trims => "SOL 144\nCEND\n",
            Aim::Flutter => "SOL 145\nCEND\n",
            Aim::Gusts => "SOL 146\nCEND\n",
        }
        .to_owned();
        if self.masses != Masses::OfDecks {
            let _ = writeln!(text, "M2GG = {MASS}");
        }
        if let Some(set) = self.mpc {
            let _ = writeln!(text, "MPC = {set}");
        }
        text = text + &asked.control + "BEGIN BULK\n" + &includes + &asked.cards + &panel_properties(&decks);
        text += &mass_cards(path, &decks, terms)?;
        let sets = match &self.splines {
            Splines::OfDecks => None,
            Splines::Nearest => Some(None),
            Splines::NearestOf(sets) => Some(Some(sets.as_slice())),
        };
        if let Some(sets) = sets {
            let cards = nearest::cards(&decks, sets, [SPLINES, UPRIGHT], self.stream(&decks));
            text += &cards.map_err(|error| error.or_in(path))?;
        }
        text += "ENDDATA\n";
        let bulk = parse_deck(&name, &text)?;
        Ok(Deck { text, bulk })
    }

    /// What the section of an aim asks for.
    fn asked(&self, path: &Path, aim: Aim, decks: &BulkData) -> Result<Asked, InputError> {
        let mut asked = Asked::default();
        let set = if aim == Aim::Trims { Some(self.set_of_trims()) } else { self.spc };
        if let Some(set) = set {
            asked.select("SPC", set);
        }
        let of_file = |fault: Fault| fault.of_file(path);
        match (aim, &self.flutter, &self.gusts) {
            (Aim::Flutter, Some(flutter), _) => {
                asked.join(&self.flutter_asked(flutter, decks).map_err(of_file)?);
            }
            (Aim::Gusts, _, Some(gusts)) => asked.join(&self.gusts_asked(path, gusts, decks)?),
            _ => {
                self.check_trims(path, decks)?;
                asked.join(&self.unsteady.said());
                asked.control += &self.subcases_of_trims();
                asked.cards += &self.cards_of_trims(decks);
            }
        }
        Ok(asked)
    }

    fn flutter_asked(&self, flutter: &Flutter, decks: &BulkData) -> Result<Asked, Fault> {
        let mut asked = self.unsteady.asked(decks)?;
        let air = self.air(decks, flutter.densities.ratios().0, None, 0.0)?;
        asked.cards += &air.cards;
        asked.cards += &self.unsteady.pairs(decks, &flutter.machs)?;
        asked.join(&flutter.asked(air.density));
        Ok(asked)
    }

    fn gusts_asked(&self, path: &Path, gusts: &Gusts, decks: &BulkData) -> Result<Asked, InputError> {
        let of_file = |fault: Fault| fault.of_file(path);
        if self.unsteady.motion == Motion::Antisymmetric {
            return Err(of_file(Fault::new("motion", "a gust moves both halves of an aircraft alike")));
        }
        // The answer in time is a sum of waves: a complex number for each frequency at each time.
        let waves = 16.0 * (gusts.frequencies.steps() + 1.0) * (gusts.times.steps() + 1.0);
        memory::demand("the frequencies at the times", waves).map_err(|error| error.or_in(path))?;
        let mut asked = self.unsteady.asked(decks).map_err(of_file)?;
        let air = self.air(decks, gusts.rho, Some(gusts.v), gusts.direction_deg).map_err(of_file)?;
        asked.cards += &air.cards;
        asked.cards += &self.unsteady.pairs(decks, &[gusts.mach]).map_err(of_file)?;
        let front_x = match gusts.front_x {
            Some(x) => x,
            None => foremost(decks, air.acsid).map_err(|error| error.or_in(path))?,
        };
        asked.join(&gusts.asked(decks, front_x).map_err(of_file)?);
        Ok(asked)
    }

    /// INCLUDE of each deck, by its whole path.
    fn includes(&self, path: &Path) -> Result<String, InputError> {
        let folder = path.parent().unwrap_or(Path::new(""));
        let mut text = String::new();
        for deck in &self.decks {
            let file = folder.join(deck);
            let is_begin = |line: &str| line.trim_start().to_ascii_uppercase().starts_with("BEGIN ");
            if read_text(&file)?.lines().any(is_begin) {
                return Err(InputError::in_file(&file, "a deck of a study has no case control of its own")
                    .with_help(
                        "name the file of its bulk data, or put that into a file and INCLUDE it in both",
                    ));
            }
            let whole = std::path::absolute(&file).unwrap_or(file);
            let _ = writeln!(text, "INCLUDE '{}'", whole.display());
        }
        Ok(text)
    }
}

/// The matrix in the place of the decks' masses, if there is one.
fn mass_cards(path: &Path, decks: &BulkData, terms: Option<&MassTerms>) -> Result<String, InputError> {
    let Some(terms) = terms else { return Ok(String::new()) };
    if decks.parameters.contains_key("WTMASS") {
        let message =
            "the decks have PARAM WTMASS, which a mass matrix in their masses' place leaves no use for";
        return Err(InputError::in_field(path, "masses", message)
            .with_help("take it out of the decks: the matrix is in units of mass"));
    }
    let weight = card("PARAM", &["WTMASS".to_owned(), NOTHING.to_owned()]);
    Ok(weight + &terms.cards(MASS, decks).map_err(|error| error.or_in(path))?)
}

/// The foremost corner of the boxes along the stream.
fn foremost(decks: &BulkData, acsid: u32) -> Result<f64, InputError> {
    let stream = StreamAxes::of_deck(&Frames::resolve(decks)?, acsid, &Span::generated("the study"))?;
    let lattice = Lattice::in_axes(decks, &stream)?;
    let corners = lattice.boxes.iter().flat_map(|one| one.corners);
    let x = corners.map(|corner| corner.x).fold(f64::INFINITY, f64::min);
    if x.is_finite() {
        Ok(x)
    } else {
        Err(InputError::general("the decks have no boxes (CAERO1) that feel a gust"))
    }
}

/// PAERO1 of panels whose property is not there: it says nothing but that there is no body.
fn panel_properties(decks: &BulkData) -> String {
    let mut missing: Vec<u32> = decks.panels.values().map(|panel| panel.property).collect();
    missing.sort_unstable();
    missing.dedup();
    missing.retain(|id| !decks.panel_properties.contains_key(id));
    missing.into_iter().map(|id| card("PAERO1", &[id.to_string()])).collect()
}
