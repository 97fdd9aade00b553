//! What a plan of loads says of the design: rules, speeds, masses, altitudes and gusts. The fields of the plan's file.

use nastran::InputError;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// Which table of numbers is taken where the file gives none of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
pub enum Rules {
    /// CS-VLA.
    Vla,
    /// CS-23 and 14 CFR 23 before amendment 64, normal category.
    Cs23Normal,
    /// CS-25 and 14 CFR 25.
    Cs25,
    /// STANAG 4671: no number of its own is known to the program, so all are asked for.
    Stanag4671,
    /// The file gives every number.
    Own,
}

/// One of the design speeds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize, Serialize, JsonSchema)]
pub enum Speed {
    /// Maneuvers.
    VA,
    /// Rough air.
    VB,
    /// Cruise.
    VC,
    /// Dive.
    VD,
    /// Flaps.
    VF,
}

/// Design speeds, equivalent airspeed.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DesignSpeeds {
    /// Maneuvers, m/s; left out: where the stall line meets the largest load factor.
    #[serde(rename = "VA", default)]
    pub va: Option<f64>,
    /// Rough air, m/s.
    #[serde(rename = "VB", default)]
    pub vb: Option<f64>,
    /// Cruise, m/s.
    #[serde(rename = "VC")]
    pub vc: f64,
    /// Dive, m/s.
    #[serde(rename = "VD")]
    pub vd: f64,
    /// Flaps, m/s.
    #[serde(rename = "VF", default)]
    pub vf: Option<f64>,
}

impl DesignSpeeds {
    /// A speed that is given, m/s EAS.
    pub fn get(&self, speed: Speed) -> Option<f64> {
        match speed {
            Speed::VA => self.va,
            Speed::VB => self.vb,
            Speed::VC => Some(self.vc),
            Speed::VD => Some(self.vd),
            Speed::VF => self.vf,
        }
    }
}

/// Limit load factors of maneuvers.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LimitLoadFactors {
    /// The largest, up to VD.
    pub n1: f64,
    /// The smallest, up to VC.
    pub n2: f64,
    /// The smallest at VD; between VC and VD it is linear.
    #[serde(rename = "n2_at_VD", default)]
    pub n2_at_vd: f64,
}

/// Where the aircraft stalls.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Lift {
    /// Largest lift coefficient of the aircraft.
    pub cl_max: f64,
    /// Smallest lift coefficient of the aircraft.
    pub cl_min: f64,
}

/// A state of loading; what is left out stays as in the aircraft's file.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MassCase {
    /// What it is called.
    pub name: String,
    /// Mass of the whole aircraft, kg.
    pub mass_kg: f64,
    /// Centre of gravity, m aft.
    #[serde(default)]
    pub x_cg_m: Option<f64>,
    /// Centre of gravity, m up.
    #[serde(default)]
    pub z_cg_m: Option<f64>,
    /// Moment of inertia about the roll axis, kg m^2.
    #[serde(default)]
    pub ixx_kg_m2: Option<f64>,
    /// Moment of inertia about the pitch axis, kg m^2.
    #[serde(default)]
    pub iyy_kg_m2: Option<f64>,
    /// Moment of inertia about the yaw axis, kg m^2.
    #[serde(default)]
    pub izz_kg_m2: Option<f64>,
    /// Product of inertia, kg m^2.
    #[serde(default)]
    pub ixz_kg_m2: Option<f64>,
}

/// Where a gust comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
pub enum Direction {
    /// From below.
    Up,
    /// From above.
    Down,
    /// From the right.
    Lateral,
}

/// Distances over which a discrete gust grows.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, Serialize, JsonSchema)]
pub enum Gradients {
    /// Ten from 9 m to 107 m in geometric steps; from 12.5 mean chords for aircraft whose chord is below 0.72 m.
    #[default]
    Default,
    /// These, m.
    Of(Vec<f64>),
}

/// Power spectral density of turbulence.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize, JsonSchema)]
pub enum Spectrum {
    /// Von Karman.
    #[default]
    Karman,
    /// Dryden.
    Dryden,
}

/// What keeps airspeed and attitude in turbulence, whose waves are longer than any gust.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize, JsonSchema)]
pub enum Attitude {
    /// The aircraft itself: one that is refused in discrete gusts as unstable is refused in turbulence, too.
    #[default]
    Stable,
    /// A pilot or control laws: an aircraft that diverges in airspeed and attitude alone is flown, and its loads are said to be
    /// those with airspeed and attitude held.
    Held,
}

/// A family of gusts.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub enum Gust {
    /// Pratt's formula: a balanced trim at one and at minus the load factor that it gives.
    Pratt {
        /// Design speeds.
        at: Vec<Speed>,
    },
    /// Gusts of one minus a cosine, flown in time.
    Discrete {
        /// Design speeds.
        at: Vec<Speed>,
        /// Gradients.
        #[serde(default)]
        gradients_m: Gradients,
        /// Directions.
        #[serde(default = "up_and_down")]
        directions: Vec<Direction>,
        /// Whether the worst gradient of each load is searched for between those given.
        #[serde(default)]
        refine: bool,
    },
    /// Continuous turbulence.
    Turbulence {
        /// Design speeds.
        at: Vec<Speed>,
        /// Scale, m.
        #[serde(default = "scale_m")]
        scale_m: f64,
        /// Frequency above which the response is not computed, Hz.
        cut_off_hz: f64,
        /// Spectrum.
        #[serde(default)]
        spectrum: Spectrum,
        /// Axes: `Up` (the same as `Down`) and `Lateral`.
        #[serde(default = "upward")]
        directions: Vec<Direction>,
        /// What keeps airspeed and attitude.
        #[serde(default)]
        attitude: Attitude,
    },
}

fn up_and_down() -> Vec<Direction> {
    vec![Direction::Up, Direction::Down]
}

fn upward() -> Vec<Direction> {
    vec![Direction::Up]
}

/// 2500 ft (14 CFR 25.341(b)(2)).
fn scale_m() -> f64 {
    762.0
}

/// Gust speeds of one's own, and what the rules' gust speeds depend on; what is left out is taken from the rules.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GustSpeeds {
    /// Derived gust velocity at VB, m/s EAS.
    #[serde(rename = "U_de_VB_m_s", default)]
    pub u_de_vb_m_s: Option<f64>,
    /// Derived gust velocity at VC, m/s EAS.
    #[serde(rename = "U_de_VC_m_s", default)]
    pub u_de_vc_m_s: Option<f64>,
    /// Derived gust velocity at VD, m/s EAS.
    #[serde(rename = "U_de_VD_m_s", default)]
    pub u_de_vd_m_s: Option<f64>,
    /// Reference velocity of discrete gusts up to VC, m/s EAS; half of it at VD.
    #[serde(rename = "U_ref_m_s", default)]
    pub u_ref_m_s: Option<f64>,
    /// Reference intensity of turbulence up to VC, m/s TAS; half of it at VD.
    #[serde(rename = "U_sigma_ref_m_s", default)]
    pub u_sigma_ref_m_s: Option<f64>,
    /// Alleviation factor of the flight profile.
    #[serde(rename = "F_g", default)]
    pub f_g: Option<f64>,
    /// Largest operating altitude, m.
    #[serde(rename = "Z_mo_m", default)]
    pub z_mo_m: Option<f64>,
    /// Largest landing mass, kg.
    #[serde(rename = "MLW_kg", default)]
    pub mlw_kg: Option<f64>,
    /// Largest mass without fuel, kg.
    #[serde(rename = "MZFW_kg", default)]
    pub mzfw_kg: Option<f64>,
    /// Largest take-off mass, kg; left out: the largest of the mass cases.
    #[serde(rename = "MTOW_kg", default)]
    pub mtow_kg: Option<f64>,
}

/// What a plan says of the design. Files are read by whoever knows the maneuvers, too.
#[derive(Debug, Clone, PartialEq)]
pub struct Design {
    /// The plan's file, for complaints.
    pub path: PathBuf,
    /// Where numbers come from that are not given.
    pub rules: Rules,
    /// Design speeds.
    pub speeds: DesignSpeeds,
    /// Limit load factors of one's own.
    pub factors: Option<LimitLoadFactors>,
    /// Stall; without it there is no stall line.
    pub lift: Option<Lift>,
    /// Altitudes, m.
    pub altitudes_m: Vec<f64>,
    /// States of loading.
    pub masses: Vec<MassCase>,
    /// Gusts.
    pub gusts: Vec<Gust>,
    /// Gust speeds of one's own.
    pub gust_speeds: GustSpeeds,
}

impl Design {
    /// The largest take-off mass, kg: as given, or the largest of the mass cases.
    pub fn mtow_kg(&self) -> f64 {
        let heaviest = self.masses.iter().map(|mass| mass.mass_kg).fold(0.0, f64::max);
        self.gust_speeds.mtow_kg.unwrap_or(heaviest)
    }

    /// A complaint at a field of the plan's file.
    pub(crate) fn wrong(&self, field: &str, message: impl Into<String>, help: &str) -> InputError {
        InputError::in_field(&self.path, field, message).with_help(help)
    }
}
