//! One set of corrections per airspeed, the rule between them, and the file they are kept in.

use aero::Corrections;
use nastran::{InputError, ron_file};
use serde::{Deserialize, Serialize};
use std::fmt::Write as _;
use std::path::Path;

/// What to do outside the calibrated airspeeds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outside {
    /// Interpolate in dynamic pressure between sets; refuse an airspeed outside.
    Refuse,
    /// Take the set of the nearest airspeed, inside and outside (the paper takes 40 m/s for 37 and 42 m/s).
    Nearest,
}

/// An airspeed at which corrections were found.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CorrectionSet {
    /// Airspeed, m/s.
    #[serde(rename = "V_m_s")]
    pub v_m_s: f64,
    /// Force factors, one a box of the wing, chordwise first.
    pub force: Vec<f64>,
    /// Moment factors.
    pub moment: Vec<f64>,
    /// Pressure offsets f_e/q.
    pub pressure_offset: Vec<f64>,
}

/// Corrections by airspeed, as in `corrections.ron`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename = "Corrections")]
pub struct Schedule {
    /// Name of the wing.
    pub wing: String,
    /// Hash of the wing's file and what it names.
    pub wing_hash: String,
    /// Sets in ascending airspeed.
    pub sets: Vec<CorrectionSet>,
}

impl Schedule {
    /// Reads `corrections.ron` and checks it.
    ///
    /// # Errors
    /// A missing or misspelt field, arrays of different lengths, airspeeds that do not ascend.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let schedule: Self = ron_file::read(path)?;
        if schedule.sets.is_empty() {
            return Err(InputError::in_file(path, "there is no set of corrections")
                .with_help("run `cargo xtask calibrate`, which writes corrections.ron"));
        }
        for set in &schedule.sets {
            let lengths = [set.moment.len(), set.pressure_offset.len()];
            if lengths.iter().any(|&length| length != set.force.len()) {
                return Err(InputError::in_file(
                    path,
                    format!("force, moment and pressure_offset at {} m/s differ in length", set.v_m_s),
                ));
            }
            let mut values = set.force.iter().chain(&set.moment).chain(&set.pressure_offset);
            if values.any(|value| !value.is_finite()) {
                return Err(InputError::in_file(
                    path,
                    format!("a correction at {} m/s is not finite", set.v_m_s),
                ));
            }
        }
        if schedule.sets.windows(2).any(|pair| pair[0].v_m_s >= pair[1].v_m_s) {
            return Err(InputError::in_file(path, "airspeeds must ascend, each once"));
        }
        Ok(schedule)
    }

    /// The corrections at an airspeed (same air density as the campaign's).
    ///
    /// # Errors
    /// If the airspeed is outside and `outside` says to refuse.
    pub fn at(&self, v_m_s: f64, outside: Outside) -> Result<Corrections, InputError> {
        let q = |set: &CorrectionSet| set.v_m_s * set.v_m_s;
        let wanted = v_m_s * v_m_s;
        let (first, last) = (&self.sets[0], &self.sets[self.sets.len() - 1]);
        if outside == Outside::Nearest {
            let distance = |set: &&CorrectionSet| (set.v_m_s - v_m_s).abs();
            let nearest = self.sets.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
            return Ok(nearest.unwrap_or(first).corrections());
        }
        let slack = 1e-9 * wanted;
        if wanted < q(first) - slack || wanted > q(last) + slack {
            return Err(InputError::general(format!(
                "no corrections at {v_m_s} m/s: they were found from {} to {} m/s",
                first.v_m_s, last.v_m_s
            ))
            .with_help("choose an airspeed inside, or calibrate at this one"));
        }
        if self.sets.len() == 1 {
            return Ok(first.corrections());
        }
        let above = self.sets.partition_point(|set| q(set) <= wanted).clamp(1, self.sets.len().max(2) - 1);
        let (low, high) = (&self.sets[above - 1], &self.sets[above]);
        let share = ((wanted - q(low)) / (q(high) - q(low))).clamp(0.0, 1.0);
        let mix = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a + share * (b - a)).collect();
        Ok(Corrections {
            force: mix(&low.force, &high.force),
            moment: mix(&low.moment, &high.moment),
            pressure_offset: mix(&low.pressure_offset, &high.pressure_offset),
        })
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
                list(&set.force),
                list(&set.moment),
                list(&set.pressure_offset)
            );
        }
        text.push_str("    ],\n)\n");
        text
    }
}

impl CorrectionSet {
    /// The set of one airspeed.
    pub fn new(v_m_s: f64, corrections: Corrections) -> Self {
        Self {
            v_m_s,
            force: corrections.force,
            moment: corrections.moment,
            pressure_offset: corrections.pressure_offset,
        }
    }

    /// Its corrections.
    pub fn corrections(&self) -> Corrections {
        Corrections {
            force: self.force.clone(),
            moment: self.moment.clone(),
            pressure_offset: self.pressure_offset.clone(),
        }
    }
}
