//! Numbers of the rules, each with its source and how sure it is that the source says so.
//!
//! What was only remembered is no number here: the program then asks for it by name.

pub mod discrete;
pub mod factors;
pub mod pratt;
mod turbulence;

use crate::design::{Design, Rules, Speed};
use nastran::InputError;
use schemars::JsonSchema;
use serde::Serialize;

/// How sure it is that a source says so.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
pub enum Mark {
    /// The rule's text was read.
    #[serde(rename = "text read")]
    Text,
    /// Public programs compute it so, or quote the text.
    #[serde(rename = "in code")]
    Code,
    /// The user gives it.
    #[serde(rename = "own number")]
    Own,
}

/// A number with its source.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Quantity {
    /// What it is called.
    pub name: String,
    /// The number.
    pub value: f64,
    /// Its unit.
    pub unit: &'static str,
    /// Where it comes from.
    pub source: String,
    /// How sure that is.
    pub mark: Mark,
}

impl Quantity {
    fn new(name: impl Into<String>, value: f64, unit: &'static str, source: &str, mark: Mark) -> Self {
        Self { name: name.into(), value, unit, source: source.to_owned(), mark }
    }

    /// A number of the plan.
    fn own(name: impl Into<String>, value: f64, unit: &'static str) -> Self {
        Self::new(name, value, unit, "the plan", Mark::Own)
    }
}

impl Design {
    /// The rules by which loads are really made: one own number in place of a rule's makes them own.
    pub fn rules_in_use(&self) -> Rules {
        let speeds = &self.gust_speeds;
        let own = [
            speeds.u_de_vb_m_s,
            speeds.u_de_vc_m_s,
            speeds.u_de_vd_m_s,
            speeds.u_ref_m_s,
            speeds.u_sigma_ref_m_s,
            speeds.f_g,
        ];
        let changed = self.factors.is_some() || own.iter().any(Option::is_some);
        if changed { Rules::Own } else { self.rules }
    }

    /// A complaint that a number is asked for which the rules do not give.
    fn asked_for(&self, field: &str, what: &str) -> InputError {
        let message = format!("{what} is asked for: the numbers of {} do not give it", self.rules.words());
        self.wrong(field, message, "give it in the plan; the report then calls it an own number")
    }
}

impl Rules {
    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Vla => "CS-VLA",
            Self::Cs23Normal => "CS-23, normal category",
            Self::Cs25 => "CS-25",
            Self::Stanag4671 => "STANAG 4671 (whose text was not read)",
            Self::Own => "the plan's own rules",
        }
    }
}

impl Speed {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::VA => "VA",
            Self::VB => "VB",
            Self::VC => "VC",
            Self::VD => "VD",
            Self::VF => "VF",
        }
    }
}

/// Linear between points in rising order of x, constant outside.
fn between(points: &[(f64, f64)], x: f64) -> f64 {
    let last = points.len() - 1;
    if x <= points[0].0 {
        return points[0].1;
    }
    for pair in points.windows(2) {
        let ((x0, y0), (x1, y1)) = (pair[0], pair[1]);
        if x <= x1 {
            return y0 + (y1 - y0) * (x - x0) / (x1 - x0);
        }
    }
    points[last].1
}

/// The share of a gust at VC that is met at an airspeed: one up to VC, a half at VD, linear between.
fn share_by_speed(design: &Design, v_eas_m_s: f64) -> f64 {
    between(&[(design.speeds.vc, 1.0), (design.speeds.vd, 0.5)], v_eas_m_s)
}
