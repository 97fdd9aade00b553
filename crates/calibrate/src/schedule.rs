//! One set of corrections per airspeed, the rule between them, and the file they are kept in.

use crate::campaign::AIRSPEEDS_M_S;
use crate::member::{CorrectionSet, Member};
use aero::Corrections;
use aero::flow::STRAY_AIRSPEED;
use nastran::{InputError, ron_file};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::fmt::Write as _;
use std::path::Path;

/// No factor or pressure offset of a wing is larger: theory would say nothing of it.
const LARGEST: f64 = 1000.0;

/// Corrections by airspeed, as in `corrections.ron`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename = "Corrections")]
pub struct Schedule {
    /// Name of the wing.
    pub wing: String,
    /// Hash of the wing's file and what it names.
    pub wing_hash: String,
    /// Sets in ascending airspeed, for the structure as given.
    pub sets: Vec<CorrectionSet>,
    /// The wing with the structure and surfaces that were found, where more than root loads was measured, and its own corrections: what
    /// flies as the updated model.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub found: Option<Member>,
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
        check_sets(path, &schedule.sets)?;
        if let Some(found) = &schedule.found {
            check_sets(path, &found.sets)?;
            check_found(path, found, &schedule.sets)?;
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

    /// These corrections, and what was found beside those that they were made `from`, moved by as much as they were, for a wing whose
    /// `known` control surfaces (by index) were measured since; nothing found stays beside other airspeeds.
    #[must_use]
    pub fn with_found_of(mut self, from: &Self, known: &[usize]) -> Self {
        let found = from.found.clone().filter(|_| CorrectionSet::same_airspeeds(&from.sets, &self.sets));
        self.found = found.map(|found| found.about(&from.sets, &self.sets, known));
        self
    }

    /// The file's text: one airspeed a block, one strip a line is left to the reader's editor.
    pub fn to_ron(&self) -> String {
        let mut text = String::from(
            "// Corrections of the panel model by airspeed: force and moment factors (1 = theory) and pressure offsets\n\
             // f_e/q, one number a box of the wing (fairing excluded), chordwise first, then spanwise.\n",
        );
        let _ = write!(
            text,
            "Corrections(\n    wing: {:?},\n    wing_hash: {:?},\n    {}",
            self.wing,
            self.wing_hash,
            sets_in_ron(&self.sets, "    ")
        );
        if let Some(Member { log_flexibility: [bending, torsion], controls, sets, .. }) = &self.found {
            let _ = write!(
                text,
                "    // The structure and surfaces that more than root loads told, and the corrections that go with them: the updated\n    \
                 // model flies these. Those above are for the structure as given.\n    found: (\n        \
                 log_flexibility: ({bending:?}, {torsion:?}),\n        controls: {controls:?},\n        {}    ),\n",
                sets_in_ron(sets, "        ")
            );
        }
        if !self.unconverged.is_empty() {
            let _ = writeln!(text, "    unconverged: {:?},", self.unconverged);
        }
        text.push_str(")\n");
        text
    }
}

/// Most that the logarithm of a flexibility can be: a structure ten times as soft as its drawing is another structure.
const MOST_LOG_FLEXIBILITY: f64 = std::f64::consts::LN_10;

fn check_sets(path: &Path, sets: &[CorrectionSet]) -> Result<(), InputError> {
    for CorrectionSet { v_m_s, corrections } in sets {
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
    Ok(())
}

fn check_found(path: &Path, found: &Member, sets: &[CorrectionSet]) -> Result<(), InputError> {
    let refuse = |message: String| {
        let help = "run `wingroot calibrate` again, which writes it, or leave `found` out to fly the structure as given";
        Err(InputError::in_field(path, "found", message).with_help(help))
    };
    if !found.is_of(sets) {
        return refuse("the wing that was found has other airspeeds or boxes than the corrections".into());
    }
    if let Some(log) = found
        .log_flexibility
        .iter()
        .find(|log| !(-MOST_LOG_FLEXIBILITY..=MOST_LOG_FLEXIBILITY).contains(*log))
    {
        return refuse(format!(
            "log_flexibility {log:?}, expected -2.3 to 2.3 (a tenth to ten times as soft)"
        ));
    }
    if let Some(factor) = found.controls.iter().find(|factor| !(-LARGEST..=LARGEST).contains(*factor)) {
        return refuse(format!("a factor of {factor:?} on a control surface, beyond {LARGEST}"));
    }
    if found.stream != 1.0 {
        return refuse(format!(
            "stream {:?}: the wing that was found is that in the tunnel's stream",
            found.stream
        ));
    }
    Ok(())
}

/// The field `sets` behind so much space.
fn sets_in_ron(sets: &[CorrectionSet], space: &str) -> String {
    let mut text = String::from("sets: [\n");
    for CorrectionSet { v_m_s, corrections } in sets {
        let list = |values: &[f64]| {
            let numbers: Vec<String> = values.iter().map(|value| format!("{value:?}")).collect();
            numbers.join(", ")
        };
        let _ = writeln!(
            text,
            "{space}    (\n{space}        V_m_s: {v_m_s:?},\n{space}        force: [{}],\n{space}        moment: [{}],\n{space}        \
             pressure_offset: [{}],\n{space}    ),",
            list(&corrections.force),
            list(&corrections.moment),
            list(&corrections.pressure_offset)
        );
    }
    let _ = writeln!(text, "{space}],");
    text
}
