//! One set of corrections per airspeed, the rule between them, and the file they are kept in.

use crate::campaign::AIRSPEEDS_M_S;
use aero::Corrections;
use aero::flow::STRAY_AIRSPEED;
use nastran::{InputError, ron_file};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::fmt::Write as _;
use std::path::Path;

/// No factor or pressure offset of a wing is larger: theory would say nothing of it.
const LARGEST: f64 = 1000.0;

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

/// Corrections by airspeed, as in `corrections.ron`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename = "Corrections")]
pub struct Schedule {
    /// Name of the wing.
    pub wing: String,
    /// Hash of the wing's file and what it names.
    pub wing_hash: String,
    /// Sets in ascending airspeed.
    pub sets: Vec<CorrectionSet>,
    /// Fits that did not reach their floor ("30 m/s: Stalled"): loads with these corrections are wrong by an unknown amount.
    #[serde(default)]
    pub unconverged: Vec<String>,
}

impl Schedule {
    /// Reads `corrections.ron` and checks it.
    ///
    /// # Errors
    /// A missing or misspelt field, arrays of different lengths, airspeeds that do not ascend, fits that did not converge.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let schedule = Self::read_unconverged(path)?;
        if schedule.unconverged.is_empty() {
            return Ok(schedule);
        }
        let message = format!(
            "these corrections are of fits that did not converge: {}",
            schedule.unconverged.join(", ")
        );
        Err(InputError::in_field(path, "unconverged", message).with_help(
            "calibrate again with better data, or take them all the same with --accept-unconverged",
        ))
    }

    /// The same, of fits that did not converge, too.
    ///
    /// # Errors
    /// As [`Schedule::read`], but for that.
    pub fn read_unconverged(path: &Path) -> Result<Self, InputError> {
        let schedule: Self = ron_file::read(path)?;
        if schedule.sets.is_empty() {
            return Err(InputError::in_file(path, "there is no set of corrections")
                .with_help("run `wingroot calibrate`, which writes corrections.ron"));
        }
        for CorrectionSet { v_m_s, corrections } in &schedule.sets {
            let Corrections { force, moment, pressure_offset } = corrections;
            if [moment.len(), pressure_offset.len()].iter().any(|&length| length != force.len()) {
                return Err(InputError::in_file(
                    path,
                    format!("force, moment and pressure_offset at {v_m_s} m/s differ in length"),
                ));
            }
            if !AIRSPEEDS_M_S.contains(v_m_s) {
                let message = format!("corrections at {v_m_s:?} m/s: no wing is calibrated there");
                return Err(InputError::in_field(path, "V_m_s", message).with_help("expected 0.1 to 340 m/s"));
            }
            let mut values = force.iter().chain(moment).chain(pressure_offset);
            if let Some(value) = values.find(|value| !(-LARGEST..=LARGEST).contains(*value)) {
                let message = format!("a correction at {v_m_s} m/s is {value:?}, beyond {LARGEST}");
                return Err(InputError::in_file(path, message)
                    .with_help("factors are near one and offsets near zero: calibrate again"));
            }
        }
        if schedule.sets.windows(2).any(|pair| pair[0].v_m_s >= pair[1].v_m_s) {
            return Err(InputError::in_file(path, "airspeeds must ascend, each once"));
        }
        Ok(schedule)
    }

    /// The corrections at an airspeed (same air density as the campaign's): interpolated in dynamic pressure inside of the
    /// calibrated range, the nearest set up to [`STRAY_AIRSPEED`] beyond it.
    ///
    /// # Errors
    /// If the airspeed is farther outside.
    pub fn at(&self, v_m_s: f64) -> Result<Corrections, InputError> {
        let q = |set: &CorrectionSet| set.v_m_s * set.v_m_s;
        let wanted = v_m_s * v_m_s;
        let (first, last) = (&self.sets[0], &self.sets[self.sets.len() - 1]);
        let slack = 1e-9 * wanted;
        if wanted < q(first) - slack || wanted > q(last) + slack {
            let nearest = self.nearest(v_m_s);
            if (nearest.v_m_s - v_m_s).abs() <= STRAY_AIRSPEED * nearest.v_m_s {
                return Ok(nearest.corrections.clone());
            }
            return Err(InputError::general(format!(
                "no corrections at {v_m_s} m/s: they were found from {} to {} m/s",
                first.v_m_s, last.v_m_s
            ))
            .with_help("choose an airspeed inside, or calibrate at this one"));
        }
        if self.sets.len() == 1 {
            return Ok(first.corrections.clone());
        }
        let above = self.sets.partition_point(|set| q(set) <= wanted).clamp(1, self.sets.len().max(2) - 1);
        let (low, high) = (&self.sets[above - 1], &self.sets[above]);
        let share = ((wanted - q(low)) / (q(high) - q(low))).clamp(0.0, 1.0);
        let mix = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a + share * (b - a)).collect();
        let (a, b) = (&low.corrections, &high.corrections);
        Ok(Corrections {
            force: mix(&a.force, &b.force),
            moment: mix(&a.moment, &b.moment),
            pressure_offset: mix(&a.pressure_offset, &b.pressure_offset),
        })
    }

    /// The set of the nearest airspeed, at any distance: for who must go on outside of the calibrated range and says so.
    pub fn nearest(&self, v_m_s: f64) -> &CorrectionSet {
        let distance = |set: &&CorrectionSet| (set.v_m_s - v_m_s).abs();
        let nearest = self.sets.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
        nearest.unwrap_or(&self.sets[0])
    }

    /// As [`Schedule::at`]; where that refuses, the nearest set and a sentence that says so, for the caller to show.
    pub fn at_or_nearest(&self, v_m_s: f64) -> (Corrections, Option<String>) {
        match self.at(v_m_s) {
            Ok(corrections) => (corrections, None),
            Err(refused) => {
                let nearest = self.nearest(v_m_s);
                let taken = format!("{}; those of {} m/s are taken", refused.message, nearest.v_m_s);
                (nearest.corrections.clone(), Some(taken))
            }
        }
    }

    /// The file's text: one airspeed a block, one strip a line is left to the reader's editor.
    pub fn to_ron(&self) -> String {
        let mut text = String::from(
            "// Corrections of the panel model by airspeed: force and moment factors (1 = theory) and pressure offsets\n\
             // f_e/q, one number a box of the wing (fairing excluded), chordwise first, then spanwise.\n",
        );
        let _ = writeln!(
            text,
            "Corrections(\n    wing: {:?},\n    wing_hash: {:?},\n    sets: [",
            self.wing, self.wing_hash
        );
        for set in &self.sets {
            let list = |values: &[f64]| {
                let numbers: Vec<String> = values.iter().map(|value| format!("{value:?}")).collect();
                numbers.join(", ")
            };
            let _ = writeln!(
                text,
                "        (\n            V_m_s: {:?},\n            force: [{}],\n            moment: [{}],\n            \
                 pressure_offset: [{}],\n        ),",
                set.v_m_s,
                list(&set.corrections.force),
                list(&set.corrections.moment),
                list(&set.corrections.pressure_offset)
            );
        }
        text.push_str("    ],\n");
        if !self.unconverged.is_empty() {
            let _ = writeln!(text, "    unconverged: {:?},", self.unconverged);
        }
        text.push_str(")\n");
        text
    }
}
