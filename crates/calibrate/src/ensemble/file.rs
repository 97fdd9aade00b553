//! The ensemble and the file it is kept in.

use crate::member::{CorrectionSet, Member};
use crate::schedule::Schedule;
use coupling::wing_file;
use nastran::{InputError, ron_file};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// More wings than this say nothing new, and reading them would take the memory.
const MOST: usize = 1000;

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
            if !member.is_of(&schedule.sets) {
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
        if !CorrectionSet::same_airspeeds(&from.sets, &to.sets) {
            return None;
        }
        let about = |member: Member| member.about(&from.sets, &to.sets, known);
        self.members = self.members.into_iter().map(about).collect();
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
