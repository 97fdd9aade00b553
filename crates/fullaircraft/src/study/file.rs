//! The file of a study.

use super::fault::{Fault, is_above_zero};
use super::flutter::Flutter;
use super::gusts::Gusts;
use super::trims::{self, Control, Point};
use super::unsteady::Unsteady;
use nastran::{BulkData, InputError, ron_file};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// A study of trims, flutter or gusts; lengths, masses and forces in the units of the decks, angles in degrees.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Study {
    /// Files of bulk data without case control, beside this one: structure, panels, control surfaces, camber and twist (W2GJ).
    pub decks: Vec<String>,
    /// Where the mass comes from.
    #[serde(default)]
    pub masses: Masses,
    /// What moves the boxes with the structure.
    #[serde(default)]
    pub splines: Splines,
    /// Set of constraints (SPC, SPCADD) of the decks that applies.
    #[serde(default)]
    pub spc: Option<u32>,
    /// Set of equations (MPC, MPCADD) of the decks that applies.
    #[serde(default)]
    pub mpc: Option<u32>,
    /// References of the coefficients; none where the decks have AEROS (of flutter and gusts: AERO or AEROS).
    #[serde(default)]
    pub reference: Option<Reference>,
    /// Grid that the aircraft is held at in trims (SUPORT); angles of trim are its own.
    #[serde(default)]
    pub support: Option<u32>,
    /// Controls of the pilot, in trims.
    #[serde(default)]
    pub controls: Vec<Control>,
    /// The trims (`fullaircraft --deck`, `loads --deck`).
    #[serde(default)]
    pub trims: Vec<Point>,
    /// Acceleration of a load factor of one in trims: 9.80665 where the decks have metres; 1 where their PARAM AUNITS turns multiples
    /// of gravity into accelerations.
    #[serde(default)]
    pub gravity: Option<f64>,
    /// Modes and unsteady air of flutter and gusts.
    #[serde(default)]
    pub unsteady: Unsteady,
    /// Flutter (`flutter --deck`).
    #[serde(default)]
    pub flutter: Option<Flutter>,
    /// Discrete gusts (`gust --deck`).
    #[serde(default)]
    pub gusts: Option<Gusts>,
}

/// Where the mass comes from.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum Masses {
    /// The decks' elements and mass elements.
    #[default]
    OfDecks,
    /// A matrix in a file, in the place of all masses of the decks: `.h5` (Nastran's HDF5), `.op4` (OUTPUT4), `.mtx` (MatrixMarket), six
    /// rows a grid in rising number and one a scalar point, along the grids' displacement systems; or `.csv` by motions.
    Matrix(String),
}

/// What moves the boxes with the structure.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum Splines {
    /// Splines of the decks.
    #[default]
    OfDecks,
    /// Each box follows its nearest grid, as on a rigid arm.
    Nearest,
    /// The same among the grids of some sets (SET1).
    NearestOf(Vec<u32>),
}

/// References of the coefficients.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Reference {
    /// Chord.
    pub chord: f64,
    /// Area; only trims need it.
    #[serde(default)]
    pub area: Option<f64>,
    /// Span; only trims need it.
    #[serde(default)]
    pub span: Option<f64>,
    /// Point that moments and rates of turn are about, basic axes; only trims need it.
    #[serde(default)]
    pub point: Option<[f64; 3]>,
    /// Whether the decks are the half of an aircraft at y > 0 or y < 0.
    #[serde(default)]
    pub is_half: bool,
    /// System of the decks whose x lies along the stream and whose z points up (ACSID); the basic one without it.
    #[serde(default)]
    pub stream: Option<u32>,
}

/// What a deck is made for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Aim {
    /// Trims (SOL 144).
    Trims,
    /// Flutter (SOL 145).
    Flutter,
    /// Gusts (SOL 146).
    Gusts,
}

impl Aim {
    /// All of them, the section of a study that each is made of, and the command that runs it.
    const ALL: [(Self, &'static str, &'static str); 3] = [
        (Self::Trims, "trims", "fullaircraft"),
        (Self::Flutter, "flutter", "flutter"),
        (Self::Gusts, "gusts", "gust"),
    ];
}

impl Study {
    /// Whether a file is a study and no deck, by its ending.
    pub fn is_study(path: &Path) -> bool {
        path.extension()
            .is_some_and(|ending| ending.eq_ignore_ascii_case("ron") || ending.eq_ignore_ascii_case("json"))
    }

    /// Reads a study.
    ///
    /// # Errors
    /// If the file cannot be read, a field is missing, misspelt or out of its range, a trim has not as many free controls as what it
    /// balances asks for, or a section lacks what it needs.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let study: Self = ron_file::read(path)?;
        study.fault().map_or(Ok(study), |fault| Err(fault.of_file(path)))
    }

    /// Refuses a study without the section that an aim is made of, and names those that there are.
    pub(super) fn demand(&self, path: &Path, aim: Aim) -> Result<(), InputError> {
        if self.has(aim) {
            return Ok(());
        }
        let section =
            Aim::ALL.iter().find(|(other, _, _)| *other == aim).map_or("", |(_, section, _)| section);
        let there = Aim::ALL.iter().filter(|(other, _, _)| self.has(*other));
        let there: Vec<String> =
            there.map(|(_, section, command)| format!("`{section}` (`{command} --deck`)")).collect();
        Err(InputError::in_file(
            path,
            format!("the study has no section `{section}`, which this command runs"),
        )
        .with_help(format!("it has {}", there.join(" and "))))
    }

    fn has(&self, aim: Aim) -> bool {
        match aim {
            Aim::Trims => !self.trims.is_empty(),
            Aim::Flutter => self.flutter.is_some(),
            Aim::Gusts => self.gusts.is_some(),
        }
    }

    /// The system whose x lies along the stream, by its own words or those of its decks.
    pub(super) fn stream(&self, decks: &BulkData) -> u32 {
        let of_decks = decks.aero_reference.as_ref().map(|aeros| aeros.acsid);
        let of_unsteady = decks.unsteady_reference.as_ref().map(|aero| aero.acsid);
        self.reference.and_then(|of| of.stream).or(of_decks).or(of_unsteady).unwrap_or(0)
    }

    /// Whether its decks are half of an aircraft, by its own words.
    pub(super) fn is_half(&self) -> bool {
        self.reference.is_some_and(|of| of.is_half)
    }

    /// What is wrong with it, if anything is.
    fn fault(&self) -> Option<Fault> {
        if self.decks.is_empty() {
            return Some(Fault::new("decks", "a study without decks has no aircraft"));
        }
        if Aim::ALL.iter().all(|(aim, _, _)| !self.has(*aim)) {
            return Some(Fault::new("decks", "a study without trims, flutter or gusts asks for nothing"));
        }
        let lengths = self.reference.iter().flat_map(|of| [Some(of.chord), of.area, of.span]).flatten();
        if let Some(value) = lengths.chain(self.gravity).find(|value| !is_above_zero(*value)) {
            let message = format!("{value} where a reference or gravity above zero is expected");
            return Some(Fault::new("decks", message));
        }
        let trims = if self.has(Aim::Trims) { self.fault_of_trims() } else { None };
        trims
            .or_else(|| self.unsteady.fault())
            .or_else(|| self.flutter.as_ref()?.fault())
            .or_else(|| self.gusts.as_ref()?.fault())
    }

    fn fault_of_trims(&self) -> Option<Fault> {
        let lacks = |field: &str, what: &str| {
            let help = format!("add `{field}`: {what}");
            Some(Fault::new("trims", format!("trims need `{field}`")).with_help(help))
        };
        if self.support.is_none() {
            return lacks("support", "the grid that the aircraft is held at");
        }
        if self.gravity.is_none() {
            return lacks("gravity", "the acceleration of a load factor of one, 9.80665 in metres");
        }
        if self.reference.is_some_and(|of| of.area.is_none() || of.span.is_none() || of.point.is_none()) {
            return lacks("reference: (area: ..., span: ..., point: (...))", "all of it, beside the chord");
        }
        trims::fault(&self.trims, &self.controls, self.is_half())
    }
}
