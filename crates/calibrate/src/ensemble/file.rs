//! The ensemble and the file it is kept in.

use super::moved::moved;
use crate::schedule::{CorrectionSet, Schedule};
use aero::Corrections;
use coupling::wing_file;
use nastran::{InputError, ron_file};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// More wings than this say nothing new, and reading them would take the memory.
const MOST: usize = 1000;

/// A wing of an ensemble.
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
}

/// See the module; its mean is the calibrated wing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Ensemble {
    /// Name of the wing.
    pub wing: String,
    /// Hash of the wing's file and what it names.
    pub wing_hash: String,
    /// Fingerprint of the text of the corrections that the ensemble spreads about.
    pub corrections: String,
    /// The wings.
    pub members: Vec<Member>,
}

impl Ensemble {
    /// Reads `ensemble.ron`.
    ///
    /// # Errors
    /// A missing or misspelt field, no members or too many, or members whose sets are not those of `schedule`.
    pub fn read(path: &Path, schedule: &Schedule) -> Result<Self, InputError> {
        let ensemble: Self = ron_file::read(path)?;
        let refuse = |message: String| {
            Err(InputError::in_field(path, "members", message).with_help(
                "run `wingroot calibrate` again, which writes ensemble.ron beside corrections.ron",
            ))
        };
        if !(1..=MOST).contains(&ensemble.members.len()) {
            return refuse(format!("{} wings, expected 1 to {MOST}", ensemble.members.len()));
        }
        for (index, member) in ensemble.members.iter().enumerate() {
            let alike = member.sets.len() == schedule.sets.len()
                && member.sets.iter().zip(&schedule.sets).all(|(a, b)| {
                    a.v_m_s == b.v_m_s
                        && [&a.corrections.force, &a.corrections.moment, &a.corrections.pressure_offset]
                            .iter()
                            .all(|values| values.len() == b.corrections.len())
                });
            if !alike {
                return refuse(format!(
                    "wing {} has other airspeeds or boxes than the corrections",
                    index + 1
                ));
            }
        }
        Ok(ensemble)
    }

    /// The same wings about other corrections of the same airspeeds, each moved by as much as the corrections were, for a wing whose
    /// `known` control surfaces (by index) were measured since; none for other airspeeds.
    pub fn about(mut self, from: &Schedule, to: &Schedule, known: &[usize]) -> Option<Self> {
        let airspeeds = |schedule: &Schedule| schedule.sets.iter().map(|set| set.v_m_s).collect::<Vec<_>>();
        if airspeeds(from) != airspeeds(to) {
            return None;
        }
        for member in &mut self.members {
            for (set, (from, to)) in member.sets.iter_mut().zip(from.sets.iter().zip(&to.sets)) {
                set.corrections = moved(&set.corrections, &to.corrections, &from.corrections);
            }
            for &control in known {
                member.controls[control] = 1.0;
            }
        }
        self.wing.clone_from(&to.wing);
        self.wing_hash.clone_from(&to.wing_hash);
        self.corrections = wing_file::fingerprint(&to.to_ron());
        Some(self)
    }

    /// The file's text.
    ///
    /// # Errors
    /// If a number cannot be written.
    pub fn to_ron(&self) -> Result<String, InputError> {
        let text = ron_file::to_text(self)?;
        Ok(format!(
            "// Wings that the campaign leaves as likely as its uncertainty says: simulate, flutter and fullaircraft fly each of them\n\
             // and give 90 % intervals by how far they spread about the wing of corrections.ron.\n{text}"
        ))
    }
}
