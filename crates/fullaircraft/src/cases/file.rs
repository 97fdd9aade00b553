//! The RON file of a grid of flight cases: airspeeds, load factors, maneuvers and where loads are monitored.

use crate::trim::maneuvers::Steady;
use coupling::wing_file::StationAt;
use loads::Design;
use loads::design::{DesignSpeeds, Gust, GustSpeeds, Lift, LimitLoadFactors, MassCase, Rules};
use maneuver::motion::{MotionOr, MotionSpec, Others};
use nastran::{InputError, ron_file};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// A grid of cases as its file describes it.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename = "Cases")]
pub struct CasesFile {
    /// What reports call it.
    pub name: String,
    /// Airspeeds, m/s; a plan of loads (with `rules`) may leave them out.
    #[serde(rename = "airspeeds_V_m_s", default)]
    pub airspeeds_v_m_s: Vec<f64>,
    /// Load factors of `Pull`, `Roll` and `Turn`.
    #[serde(default)]
    pub load_factors: Vec<f64>,
    /// What is flown at each airspeed.
    #[serde(default)]
    pub maneuvers: Vec<Maneuver>,
    /// Points of the right wing where loads are monitored, beside the root; the left has their images.
    #[serde(default)]
    pub stations: Vec<StationAt>,
    /// Whose numbers are taken where the file gives none: makes the file a plan of loads, to which all fields below belong.
    #[serde(default)]
    pub rules: Option<Rules>,
    /// Design speeds, equivalent airspeed.
    #[serde(rename = "design_speeds_EAS_m_s", default)]
    pub design_speeds: Option<DesignSpeeds>,
    /// Limit load factors in place of those of the rules.
    #[serde(default)]
    pub limit_load_factors: Option<LimitLoadFactors>,
    /// Lift coefficients of the stall lines.
    #[serde(default)]
    pub lift: Option<Lift>,
    /// Altitudes, m.
    #[serde(default)]
    pub altitudes_m: Vec<f64>,
    /// States of loading.
    #[serde(default)]
    pub masses: Vec<MassCase>,
    /// Gusts.
    #[serde(default)]
    pub gusts: Vec<Gust>,
    /// Gust speeds in place of those of the rules, and what those depend on.
    #[serde(default)]
    pub gust_speeds: Option<GustSpeeds>,
    /// The file that says which cases go to stress.
    #[serde(default)]
    pub select: Option<String>,
    /// Of a plan that is flown on a Nastran deck (`loads --deck`): the deck's units, and its level flight.
    #[serde(default)]
    pub deck: Option<DeckUnits>,
    /// The file as it was named when read.
    #[serde(skip)]
    pub path: PathBuf,
}

/// What a plan says of the deck that it is flown on; forces, lengths and seconds make all other units.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DeckUnits {
    /// The deck's unit of length, m: 0.3048 for feet.
    #[serde(default = "one")]
    pub length_m: f64,
    /// The deck's unit of force, N: 4.4482216 for pounds.
    #[serde(rename = "force_N", default = "one")]
    pub force_n: f64,
    /// Number of the TRIM card that is level flight; left out: the deck's first.
    #[serde(default)]
    pub trim: Option<u32>,
    /// Highest frequency of the modes that gusts and turbulence move, Hz; left out: as the deck's METHOD, or its only EIGRL, says.
    #[serde(default)]
    pub modes_up_to_hz: Option<f64>,
}

impl Default for DeckUnits {
    fn default() -> Self {
        Self { length_m: 1.0, force_n: 1.0, trim: None, modes_up_to_hz: None }
    }
}

fn one() -> f64 {
    1.0
}

/// What is flown: trims, or from level flight a motion of a pair of ailerons (a record without `duration_s` ends with it).
pub type Maneuver = MotionOr<Trims>;

/// One kind of trims; controls are pairs of the wing's ailerons.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub enum Trims {
    /// Straight and level.
    Level,
    /// Pull-up or push-down at each load factor that is not one.
    Pull,
    /// Steady roll at each load factor and rate.
    Roll {
        /// Pair of ailerons.
        control: String,
        /// Right wing down, deg/s.
        rates_deg_s: Vec<f64>,
    },
    /// Level turn to the right and to the left at each load factor above one.
    Turn {
        /// Pair of ailerons.
        control: String,
    },
    /// Steady sideslip at load factor one.
    Sideslip {
        /// Pair of ailerons.
        control: String,
        /// Wind from the right, deg.
        angles_deg: Vec<f64>,
    },
    /// Any trim.
    Trim {
        /// What it is called.
        name: String,
        /// Variables with values.
        #[serde(default)]
        given: BTreeMap<String, f64>,
        /// Variables to be found, as many as there are targets.
        free: Vec<String>,
        /// Motions asked for.
        targets: BTreeMap<String, f64>,
    },
}

impl Others for Trims {
    const NAMES: &'static [&'static str] = &["Level", "Pull", "Roll", "Turn", "Sideslip", "Trim"];
}

/// What one case flies.
#[derive(Debug, Clone, PartialEq)]
pub enum Action {
    /// A trim.
    Steady(Steady),
    /// A motion from level flight.
    Motion(MotionSpec),
}

impl CasesFile {
    /// Reads and checks a file.
    ///
    /// # Errors
    /// If it cannot be read, a number makes no sense, or it has no case.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let mut file: Self = ron_file::read(path)?;
        file.path = path.to_path_buf();
        let points = file.stations.iter().flat_map(|at| [Some(at.y_m), at.x_m, at.z_m]).flatten();
        if !points.into_iter().all(f64::is_finite) {
            return Err(InputError::in_field(path, "stations", "a place of `stations` is not finite")
                .with_help("expected metres"));
        }
        let units = file.deck.unwrap_or_default();
        let given = [Some(units.length_m), Some(units.force_n), units.modes_up_to_hz];
        if !given.into_iter().flatten().all(|value| value.is_finite() && value > 0.0) {
            return Err(InputError::in_field(path, "deck", "a number of `deck` is not above zero")
                .with_help("expected deck: (length_m: 0.3048, force_N: 4.4482216), for instance"));
        }
        file.check()?;
        file.design()?;
        Ok(file)
    }

    /// The plan's design, of a file that has `rules`.
    ///
    /// # Errors
    /// If it has no design speeds, or its numbers make no sense.
    pub fn design(&self) -> Result<Option<Design>, InputError> {
        let Some(rules) = self.rules else { return Ok(None) };
        let speeds = self.design_speeds.ok_or_else(|| {
            InputError::in_field(&self.path, "rules", "a plan of loads needs `design_speeds_EAS_m_s`")
                .with_help("such as design_speeds_EAS_m_s: (VC: 37.0, VD: 46.0)")
        })?;
        let design = Design {
            path: self.path.clone(),
            rules,
            speeds,
            factors: self.limit_load_factors,
            lift: self.lift,
            altitudes_m: self.altitudes_m.clone(),
            masses: self.masses.clone(),
            gusts: self.gusts.clone(),
            gust_speeds: self.gust_speeds.unwrap_or_default(),
        };
        design.check().map(|()| Some(design))
    }

    /// What is flown at each airspeed, in the file's order.
    pub fn actions(&self) -> Vec<Action> {
        let of = |maneuver: &Maneuver| match maneuver {
            Maneuver::Motion(motion) => vec![Action::Motion(motion.clone())],
            Maneuver::Other(trims) => trims.all(&self.load_factors).into_iter().map(Action::Steady).collect(),
        };
        self.maneuvers.iter().flat_map(of).collect()
    }
}

impl Trims {
    fn all(&self, load_factors: &[f64]) -> Vec<Steady> {
        let each = |keep: fn(f64) -> bool| load_factors.iter().copied().filter(move |n| keep(*n));
        match self {
            Self::Level => vec![Steady::Level],
            Self::Pull => each(|n| n != 1.0).map(|load_factor| Steady::Pull { load_factor }).collect(),
            Self::Roll { control, rates_deg_s } => each(|_| true)
                .flat_map(|n| rates_deg_s.iter().map(move |rate| (n, *rate)))
                .map(|(load_factor, rate_deg_s)| Steady::Roll {
                    load_factor,
                    rate_deg_s,
                    control: control.clone(),
                })
                .collect(),
            Self::Turn { control } => each(|n| n > 1.0)
                .flat_map(|n| [(n, false), (n, true)])
                .map(|(load_factor, left)| Steady::Turn { load_factor, left, control: control.clone() })
                .collect(),
            Self::Sideslip { control, angles_deg } => angles_deg
                .iter()
                .map(|&beta_deg| Steady::Sideslip { load_factor: 1.0, beta_deg, control: control.clone() })
                .collect(),
            Self::Trim { name, given, free, targets } => vec![Steady::Trim {
                name: name.clone(),
                given: given.clone(),
                free: free.clone(),
                targets: targets.clone(),
            }],
        }
    }
}
