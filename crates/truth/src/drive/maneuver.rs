//! Maneuver files: read with this crate's own types, and written for the campaigns it makes.

use super::Motion;
use crate::fault::{Fault, text_of};
use serde::Deserialize;
use std::fmt::Write as _;
use std::path::Path;

/// A maneuver as its file declares it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Maneuver {
    /// Airspeed, m/s; zero is wind-off.
    #[serde(rename = "V_m_s")]
    pub v_m_s: f64,
    /// Density, kg/m³.
    #[serde(default = "sea_level")]
    pub rho_kg_m3: f64,
    /// Angle of attack at the beginning, degrees.
    pub alpha_deg: f64,
    /// Samples of the record per second.
    pub sample_rate_hz: f64,
    /// Length of the record, s.
    pub length_s: f64,
    /// What moves.
    pub motions: Vec<Motion>,
}

fn sea_level() -> f64 {
    1.225
}

impl Maneuver {
    /// Reads a file.
    ///
    /// # Errors
    /// A file that cannot be read, or a motion that this program does not fly.
    pub fn read(path: &Path) -> Result<Self, Fault> {
        ron::from_str(&text_of(path)?).map_err(|error| Fault::new(path, error))
    }

    /// Angle of attack or a control's command with derivatives at a time: rad, s.
    pub fn at(&self, of: &str, t_s: f64) -> [f64; 3] {
        let base = if of == "alpha" { self.alpha_deg } else { 0.0 };
        let moving = self.motions.iter().filter(|motion| motion.of() == of);
        let sum = moving.fold([base, 0.0, 0.0], |sum, motion| {
            let more = motion.at(t_s);
            [0, 1, 2].map(|derivative| sum[derivative] + more[derivative])
        });
        sum.map(f64::to_radians)
    }

    /// Number of samples of the record.
    pub fn samples(&self) -> usize {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "lengths are a few seconds"
        )]
        let steps = (self.length_s * self.sample_rate_hz).round() as usize;
        steps + 1
    }

    /// The maneuver as a file.
    pub fn text(&self) -> String {
        let mut text = format!(
            "Maneuver(\n    V_m_s: {:?},\n    rho_kg_m3: {:?},\n    alpha_deg: {:?},\n    sample_rate_hz: {:?},\n    length_s: {:?},\n    motions: [\n",
            self.v_m_s, self.rho_kg_m3, self.alpha_deg, self.sample_rate_hz, self.length_s
        );
        for motion in &self.motions {
            let of = motion.of();
            let _ = match motion {
                Motion::OneMinusCosine { height_deg, frequency_hz, start_s, .. } => writeln!(
                    text,
                    "        OneMinusCosine(of: {of:?}, height_deg: {height_deg:?}, frequency_hz: {frequency_hz:?}, start_s: {start_s:?}),"
                ),
                Motion::Doublet { height_deg, frequency_hz, start_s, .. } => writeln!(
                    text,
                    "        Doublet(of: {of:?}, height_deg: {height_deg:?}, frequency_hz: {frequency_hz:?}, start_s: {start_s:?}),"
                ),
                Motion::Chirp { height_deg, from_hz, to_hz, duration_s, start_s, .. } => writeln!(
                    text,
                    "        Chirp(of: {of:?}, height_deg: {height_deg:?}, from_hz: {from_hz:?}, to_hz: {to_hz:?}, duration_s: {duration_s:?}, start_s: {start_s:?}),"
                ),
                Motion::Step { height_deg, start_s, .. } => {
                    writeln!(
                        text,
                        "        Step(of: {of:?}, height_deg: {height_deg:?}, start_s: {start_s:?}),"
                    )
                }
            };
        }
        text.push_str("    ],\n)\n");
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_written_maneuver_is_read_as_it_was() {
        let motion =
            Motion::Doublet { of: "inner".into(), height_deg: 15.0, frequency_hz: 1.0, start_s: 0.5 };
        let maneuver = Maneuver {
            v_m_s: 30.0,
            rho_kg_m3: 1.2,
            alpha_deg: 1.3,
            sample_rate_hz: 100.0,
            length_s: 2.5,
            motions: vec![motion],
        };
        assert_eq!(ron::from_str(&maneuver.text()), Ok(maneuver));
    }

    #[test]
    fn the_shipped_maneuvers_are_read() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex/maneuvers");
        for name in ["pitch_4hz.ron", "doublet.ron", "chirp.ron"] {
            let maneuver = Maneuver::read(&folder.join(name)).unwrap_or_else(|fault| panic!("{fault}"));
            assert_eq!(maneuver.v_m_s, 30.0);
        }
    }
}
