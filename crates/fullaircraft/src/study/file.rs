//! The file of a study.

use nastran::{InputError, ron_file};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::Path;

/// A study of trims; lengths, masses and forces in the units of the decks, angles in degrees.
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
    /// References of the coefficients; none where the decks have AEROS.
    #[serde(default)]
    pub reference: Option<Reference>,
    /// Grid that the aircraft is held at (SUPORT); angles of trim are its own.
    pub support: u32,
    /// Controls of the pilot.
    #[serde(default)]
    pub controls: Vec<Control>,
    /// The trims.
    pub trims: Vec<Point>,
    /// Acceleration of a load factor of one: 9.80665 where the decks have metres; 1 where their PARAM AUNITS turns multiples of gravity
    /// into accelerations.
    pub gravity: f64,
}

/// Where the mass comes from.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum Masses {
    /// The decks' elements and mass elements.
    #[default]
    OfDecks,
    /// A matrix in a file, in the place of all masses of the decks: `.h5` (Nastran's HDF5), `.mtx` (MatrixMarket), six rows a grid in
    /// rising number and one a scalar point, along the grids' displacement systems; or `.csv` by motions.
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
    /// Area.
    pub area: f64,
    /// Chord.
    pub chord: f64,
    /// Span.
    pub span: f64,
    /// Point that moments and rates of turn are about, basic axes.
    pub point: [f64; 3],
    /// Whether the decks are the half of an aircraft at y > 0 or y < 0.
    #[serde(default)]
    pub is_half: bool,
}

/// A control of the pilot.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Control {
    /// Its name.
    pub name: String,
    /// Control surfaces (AESURF) and how far each goes by a unit of the control; the value of the first is what trims give.
    pub moves: Vec<(String, f64)>,
}

/// What is balanced.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum Balance {
    /// Heave and pitch, with the angle of attack and one control.
    #[default]
    Pitch,
    /// Heave, pitch, roll and yaw, with the angle of attack and three controls; to the side the aircraft may accelerate.
    /// Where a study has such a trim, its trims in pitch may accelerate to the side, in roll and in yaw.
    AllAxes,
}

/// One trim.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Point {
    /// Its name.
    pub name: String,
    /// Mach number of the air forces.
    pub mach: f64,
    /// Airspeed.
    pub v: f64,
    /// Density.
    pub rho: f64,
    /// Load factor.
    #[serde(default = "one")]
    pub load_factor: f64,
    /// Pitch rate, degrees per unit of time.
    #[serde(default)]
    pub pitch_rate_deg: f64,
    /// What is balanced.
    #[serde(default)]
    pub balance: Balance,
    /// Controls that balance it.
    pub free: Vec<String>,
    /// Controls with a deflection, degrees of their first surface; all others are at zero.
    #[serde(default)]
    pub held_deg: BTreeMap<String, f64>,
}

const fn one() -> f64 {
    1.0
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
    /// If the file cannot be read, a field is missing, misspelt or out of its range, or a trim has not as many free controls as
    /// what it balances asks for.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let study: Self = ron_file::read(path)?;
        let refuse = |field: &str, message: String| Err(InputError::in_field(path, field, message));
        if study.decks.is_empty() {
            return refuse("decks", "a study without decks has no aircraft".to_owned());
        }
        if study.trims.is_empty() {
            return refuse("trims", "a study without trims asks for nothing".to_owned());
        }
        let positive = study.reference.iter().flat_map(|of| [of.area, of.chord, of.span]);
        let points = study.trims.iter().flat_map(|trim| [trim.v, trim.rho]);
        if let Some(value) =
            positive.chain(points).chain([study.gravity]).find(|value| !(*value > 0.0 && value.is_finite()))
        {
            return refuse(
                "decks",
                format!("{value} where a reference, airspeed, density or gravity above zero is expected"),
            );
        }
        let is_half = study.reference.is_some_and(|of| of.is_half);
        if is_half && study.trims.iter().any(|trim| trim.balance == Balance::AllAxes) {
            return refuse(
                "balance",
                "half an aircraft neither rolls nor yaws: AllAxes needs a whole one".to_owned(),
            );
        }
        for control in &study.controls {
            if control.moves.first().is_none_or(|(_, factor)| *factor == 0.0) {
                return refuse("controls", format!("the control {} moves no surface at first", control.name));
            }
        }
        study.trims.iter().try_for_each(|trim| study.check_controls(path, trim))?;
        Ok(study)
    }

    /// Whether a trim has as many free controls as it needs, each there and once.
    fn check_controls(&self, path: &Path, trim: &Point) -> Result<(), InputError> {
        let refuse = |field: &str, message: String| Err(InputError::in_field(path, field, message));
        let wanted = match trim.balance {
            Balance::Pitch => 1,
            Balance::AllAxes => 3,
        };
        if trim.free.len() != wanted {
            let message = format!("{} has {} free controls, {wanted} balance it", trim.name, trim.free.len());
            return refuse("free", message);
        }
        let twice = |(at, name): &(usize, &String)| {
            trim.held_deg.contains_key(*name) || trim.free[..*at].contains(name)
        };
        if let Some((_, name)) = trim.free.iter().enumerate().find(twice) {
            return refuse("free", format!("{}: {name} balances it twice, or is held as well", trim.name));
        }
        let known = |name: &&String| self.controls.iter().all(|control| control.name != **name);
        if let Some(name) = trim.free.iter().chain(trim.held_deg.keys()).find(known) {
            let there: Vec<&str> = self.controls.iter().map(|control| control.name.as_str()).collect();
            return Err(InputError::in_field(
                path,
                "free",
                format!("{}: there is no control {name}", trim.name),
            )
            .with_help(format!("there are {}", there.join(", "))));
        }
        Ok(())
    }
}
