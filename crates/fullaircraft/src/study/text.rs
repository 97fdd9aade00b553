//! A study as the text of a deck.

use super::cards::{card, real};
use super::file::{Balance, Control, Masses, Point, Splines, Study};
use super::matrix::MassTerms;
use super::nearest;
use nastran::{BulkData, InputError, parse_deck, read_text};
use std::fmt::Write as _;
use std::path::Path;

/// Numbers of what a study adds begin here.
const FIRST: u32 = 90_000_000;
/// Its constraint sets: its own, and the union with the decks' set.
const OWN_SET: u32 = FIRST;
const UNION: u32 = FIRST + 1;
/// Its system of reference, and that of upright panels.
const REFERENCE: u32 = FIRST + 2;
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
    /// The study as a deck; `terms` are those of [`Masses::Matrix`].
    ///
    /// # Errors
    /// If a deck cannot be read or has a case control, the support's grid, a control surface or a set is not there, the matrix is
    /// of another structure, or the decks weigh in other units than mass (PARAM WTMASS) beside it.
    pub fn deck(&self, path: &Path, terms: Option<&MassTerms>) -> Result<Deck, InputError> {
        // Places in what is made here are none of the study's file.
        let name = format!("{} as a deck", path.display());
        let includes = self.includes(path)?;
        let decks = parse_deck(&name, &includes)?;
        self.check(path, &decks, terms.is_some())?;
        let mut text = "SOL 144\nCEND\n".to_owned();
        let _ = writeln!(text, "SPC = {}", if self.spc.is_some() { UNION } else { OWN_SET });
        if let Some(set) = self.mpc {
            let _ = writeln!(text, "MPC = {set}");
        }
        if self.masses != Masses::OfDecks {
            let _ = writeln!(text, "M2GG = {MASS}");
        }
        for (number, trim) in (1..).zip(&self.trims) {
            let is_plain = |c: &char| c.is_alphanumeric() || " ._-+".contains(*c);
            let label: String = trim.name.chars().filter(is_plain).collect();
            let _ = writeln!(text, "SUBCASE {number}\n  LABEL = {label}\n  TRIM = {number}");
        }
        text += "BEGIN BULK\n";
        text += &includes;
        text += &self.held();
        text += &panel_properties(&decks);
        text += &self.variables(&decks);
        if let Some(terms) = terms {
            text += &card("PARAM", &["WTMASS".to_owned(), NOTHING.to_owned()]);
            text += &terms.cards(MASS, &decks).map_err(|error| error.or_in(path))?;
        }
        let sets = match &self.splines {
            Splines::OfDecks => None,
            Splines::Nearest => Some(None),
            Splines::NearestOf(sets) => Some(Some(sets.as_slice())),
        };
        if let Some(sets) = sets {
            text += &nearest::cards(&decks, sets, SPLINES, UPRIGHT).map_err(|error| error.or_in(path))?;
        }
        text += "ENDDATA\n";
        let bulk = parse_deck(&name, &text)?;
        Ok(Deck { text, bulk })
    }

    /// Whether what the study names is in its decks.
    fn check(&self, path: &Path, decks: &BulkData, is_by_matrix: bool) -> Result<(), InputError> {
        if !decks.grids.contains_key(&self.support) {
            return Err(InputError::in_field(
                path,
                "support",
                format!("GRID {} is not in the decks", self.support),
            ));
        }
        if let Some(card) = decks.supports.first() {
            let message = format!("the decks have a SUPORT of their own, at grid {}", card.grid);
            return Err(InputError::in_field(path, "support", message)
                .with_help("take it out of the decks: the study supports the aircraft"));
        }
        for surface in
            self.controls.iter().flat_map(|control| control.moves.iter().map(|(surface, _)| surface))
        {
            if decks.surfaces.values().all(|card| card.label != *surface) {
                let there: Vec<&str> = decks.surfaces.values().map(|card| card.label.as_str()).collect();
                return Err(InputError::in_field(
                    path,
                    "controls",
                    format!("AESURF {surface} is not in the decks"),
                )
                .with_help(format!("there are {}", there.join(", "))));
            }
        }
        if is_by_matrix && decks.parameters.contains_key("WTMASS") {
            let message =
                "the decks have PARAM WTMASS, which a mass matrix in their masses' place leaves no use for";
            return Err(InputError::in_field(path, "masses", message)
                .with_help("take it out of the decks: the matrix is in units of mass"));
        }
        Ok(())
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

    /// Whether a trim of it balances all axes, so that the support leaves all of them free.
    fn is_in_all_axes(&self) -> bool {
        self.trims.iter().any(|trim| trim.balance == Balance::AllAxes)
    }

    /// The support, and what is held of it.
    fn held(&self) -> String {
        let (held, free) = if self.is_in_all_axes() { ("1", "23456") } else { ("1246", "35") };
        let grid = self.support.to_string();
        let mut text = card("SPC1", &[OWN_SET.to_string(), held.to_owned(), grid.clone()]);
        if let Some(set) = self.spc {
            text += &card("SPCADD", &[UNION.to_string(), OWN_SET.to_string(), set.to_string()]);
        }
        text + &card("SUPORT", &[grid, free.to_owned()])
    }

    /// References, variables, links and trims.
    fn variables(&self, decks: &BulkData) -> String {
        let mut text = String::new();
        let zero = || "0.".to_owned();
        if let Some(of) = &self.reference {
            let [x, y, z] = of.point;
            let point = [[x, y, z], [x, y, z + 1.0], [x + 1.0, y, z]].concat();
            let head = [REFERENCE.to_string(), "0".to_owned()];
            text += &card("CORD2R", &head.into_iter().chain(point.into_iter().map(real)).collect::<Vec<_>>());
            text += &card(
                "AEROS",
                &[
                    "0".to_owned(),
                    REFERENCE.to_string(),
                    real(of.chord),
                    real(of.span),
                    real(of.area),
                    u8::from(of.is_half).to_string(),
                    "0".to_owned(),
                ],
            );
        }
        let rigid = ["ANGLEA", "SIDES", "ROLL", "PITCH", "YAW", "URDD2", "URDD3", "URDD4", "URDD5", "URDD6"];
        if decks.trim_variables.is_empty() {
            for (number, label) in (FIRST..).zip(rigid) {
                text += &card("AESTAT", &[number.to_string(), label.to_owned()]);
            }
        }
        for control in &self.controls {
            let Some(((leader, unit), others)) = control.moves.split_first() else { continue };
            for (other, factor) in others {
                let ratio = -factor / unit;
                text += &card("AELINK", &["ALWAYS".to_owned(), other.clone(), leader.clone(), real(ratio)]);
            }
        }
        for (number, trim) in (1..).zip(&self.trims) {
            let mut fixed: Vec<(String, String)> =
                ["SIDES", "ROLL", "YAW", "URDD5"].map(|label| (label.to_owned(), zero())).to_vec();
            let q = 0.5 * trim.rho * trim.v * trim.v;
            let chord =
                self.reference.map(|of| of.chord).or(decks.aero_reference.as_ref().map(|aeros| aeros.chord));
            let pitch = trim.pitch_rate_deg.to_radians() * chord.unwrap_or(0.0) / (2.0 * trim.v);
            fixed.push(("PITCH".to_owned(), real(pitch)));
            fixed.push(("URDD3".to_owned(), real(trim.load_factor * self.gravity)));
            // Accelerations that nothing balances are free where the support is.
            let still: &[&str] = match (trim.balance, self.is_in_all_axes()) {
                (Balance::AllAxes, _) => &["URDD4", "URDD6"],
                (Balance::Pitch, true) => &[],
                (Balance::Pitch, false) => &["URDD2", "URDD4", "URDD6"],
            };
            fixed.extend(still.iter().map(|label| ((*label).to_owned(), zero())));
            fixed.extend(self.surfaces_of(trim, decks));
            let mut fields = vec![number.to_string(), real(trim.mach), real(q)];
            for (place, (label, value)) in fixed.into_iter().enumerate() {
                if place == 2 {
                    // AEQR, which the first line has behind two variables
                    fields.push("1.0".to_owned());
                }
                fields.extend([label, value]);
            }
            text += &card("TRIM", &fields);
        }
        text
    }

    /// Values of the surfaces that do not balance a trim and follow no other.
    fn surfaces_of(&self, trim: &Point, decks: &BulkData) -> Vec<(String, String)> {
        let leads = |control: &Control, label: &str| control.moves[0].0 == label;
        let follows = |label: &str| {
            self.controls.iter().any(|control| control.moves[1..].iter().any(|(other, _)| other == label))
        };
        let is_free = |label: &str| {
            self.controls.iter().any(|control| leads(control, label) && trim.free.contains(&control.name))
        };
        let value = |label: &str| {
            let control = self.controls.iter().find(|control| leads(control, label));
            control.and_then(|control| trim.held_deg.get(&control.name)).copied().unwrap_or(0.0).to_radians()
        };
        let labels = decks.surfaces.values().map(|card| card.label.as_str());
        let fixed = labels.filter(|label| !follows(label) && !is_free(label));
        fixed.map(|label| (label.to_owned(), real(value(label)))).collect()
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
