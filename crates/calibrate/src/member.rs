//! A wing that may be the true one: its corrections by airspeed, and what its structure and surfaces depart from the drawing by.

mod moved;

pub(crate) use moved::{moved, short};

use aero::Corrections;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// An airspeed and the corrections found there.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(from = "SetInFile", into = "SetInFile")]
#[schemars(into = "SetInFile")]
pub struct CorrectionSet {
    /// Airspeed, m/s.
    pub v_m_s: f64,
    /// One entry a box of the wing, chordwise first.
    pub corrections: Corrections,
}

/// A set as `corrections.ron` writes it.
#[derive(Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct SetInFile {
    /// Airspeed, m/s.
    #[serde(rename = "V_m_s")]
    v_m_s: f64,
    /// Factors of the boxes' forces (1 is theory), one a box of the wing without its fairing, chordwise first.
    force: Vec<f64>,
    /// Factors of the boxes' own moments (1 is theory).
    moment: Vec<f64>,
    /// Pressures added at every angle, over dynamic pressure.
    pressure_offset: Vec<f64>,
}

impl From<SetInFile> for CorrectionSet {
    fn from(SetInFile { v_m_s, force, moment, pressure_offset }: SetInFile) -> Self {
        Self { v_m_s, corrections: Corrections { force, moment, pressure_offset } }
    }
}

impl From<CorrectionSet> for SetInFile {
    fn from(CorrectionSet { v_m_s, corrections }: CorrectionSet) -> Self {
        let Corrections { force, moment, pressure_offset } = corrections;
        Self { v_m_s, force, moment, pressure_offset }
    }
}

impl CorrectionSet {
    /// Whether two lists of sets are of the same airspeeds.
    pub(crate) fn same_airspeeds(one: &[Self], other: &[Self]) -> bool {
        one.iter().map(|set| set.v_m_s).eq(other.iter().map(|set| set.v_m_s))
    }
}

/// See the module.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Member {
    /// Logarithms of the factors on the structure's flexibility in bending and in torsion.
    pub log_flexibility: [f64; 2],
    /// Factor on what each control surface does, in the wing's order.
    pub controls: Vec<f64>,
    /// Factor on all lift in flight: what the tunnel's stream was off free air by.
    #[serde(default = "one", skip_serializing_if = "is_one")]
    pub stream: f64,
    /// Corrections, at the airspeeds of `corrections.ron`.
    pub sets: Vec<CorrectionSet>,
}

const fn one() -> f64 {
    1.0
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "the signature serde calls")]
fn is_one(value: &f64) -> bool {
    *value == 1.0
}

impl Member {
    /// Its corrections in free air.
    pub fn sets_in_flight(&self) -> Vec<CorrectionSet> {
        let scaled = |values: &[f64]| values.iter().map(|value| value * self.stream).collect();
        let one = |set: &CorrectionSet| CorrectionSet {
            v_m_s: set.v_m_s,
            corrections: Corrections {
                force: scaled(&set.corrections.force),
                moment: scaled(&set.corrections.moment),
                pressure_offset: scaled(&set.corrections.pressure_offset),
            },
        };
        self.sets.iter().map(one).collect()
    }

    /// Whether its sets are of the airspeeds and boxes of others.
    pub(crate) fn is_of(&self, sets: &[CorrectionSet]) -> bool {
        CorrectionSet::same_airspeeds(&self.sets, sets)
            && self.sets.iter().zip(sets).all(|(own, other)| {
                let Corrections { force, moment, pressure_offset } = &own.corrections;
                [force, moment, pressure_offset].iter().all(|values| values.len() == other.corrections.len())
            })
    }

    /// The wing moved by as much as corrections of the same airspeeds were, whose `known` control surfaces (by index) were measured since.
    pub(crate) fn about(mut self, from: &[CorrectionSet], to: &[CorrectionSet], known: &[usize]) -> Self {
        for (set, (from, to)) in self.sets.iter_mut().zip(from.iter().zip(to)) {
            set.corrections = moved(&set.corrections, &to.corrections, &from.corrections);
        }
        for (_, factor) in self.controls.iter_mut().enumerate().filter(|(control, _)| known.contains(control))
        {
            *factor = 1.0;
        }
        self
    }
}
