//! Section aerodynamics of the truth, strip by strip, as factors and offsets of its boxes.
//!
//! From the viscous polars at the strip's own Reynolds number, relative to a reference: lift slope (a factor),
//! angle of zero lift (an incidence that the lattice answers to) and moment. From tables: a force factor over
//! span and chord, and by airspeed a factor of the boxes' own moments and a pressure offset.

use crate::file::{AirspeedSections, Corners, Sections};
use crate::polars::{PolarLine, Polars};
use aero::Corrections;
use coupling::ElasticWing;
use faer::Mat;
use nastran::InputError;
use std::path::Path;

/// Sections ready to be asked.
#[derive(Debug)]
pub(crate) struct SectionModel {
    settings: Sections,
    pub(crate) polars: Polars,
    reference: PolarLine,
    /// Per strip of the correctable boxes: boxes (indices into the correctable ones), chord and `y_norm`.
    pub(crate) strips: Vec<Strip>,
}

/// One strip of the wing.
#[derive(Debug)]
pub(crate) struct Strip {
    /// Entries of the correctable boxes, leading edge first.
    pub(crate) entries: Vec<usize>,
    /// Chord at its middle, m.
    pub(crate) chord_m: f64,
    /// 0 root, 1 tip.
    pub(crate) eta: f64,
}

impl SectionModel {
    pub(crate) fn new(
        settings: &Sections,
        polars: &Path,
        wing: &ElasticWing,
        mean_chord_m: f64,
    ) -> Result<Self, InputError> {
        let polars = Polars::read(polars, mean_chord_m)?;
        let boxes = &wing.correctable;
        let count = boxes.strip.iter().max().map_or(0, |last| last + 1);
        let strips = (0..count)
            .map(|strip| {
                let entries: Vec<usize> = (0..boxes.len()).filter(|&b| boxes.strip[b] == strip).collect();
                let chord_m = entries.iter().map(|&b| wing.lattice.boxes[boxes.places[b]].chord_m()).sum();
                let eta = entries.first().map_or(0.0, |&b| boxes.y_norm[b]);
                Strip { entries, chord_m, eta }
            })
            .collect();
        let mut model = Self { settings: settings.clone(), reference: zero_line(), polars, strips };
        model.reference = model.line(model.polars.reynolds(settings.reference_v_m_s, mean_chord_m));
        Ok(model)
    }

    /// Share of the polars that enters.
    pub(crate) fn share(&self) -> f64 {
        self.settings.polar_share
    }

    /// The straight line through the polar at a Reynolds number.
    pub(crate) fn line(&self, re: f64) -> PolarLine {
        let (low, high) = self.settings.angles_in_use_deg;
        self.polars.line(re, (low.to_radians(), high.to_radians()))
    }

    /// Incidence that moves each strip's angle of zero lift to its Reynolds number's, rad.
    pub(crate) fn lead_shift(&self, strip: &Strip, v_m_s: f64) -> f64 {
        let line = self.line(self.polars.reynolds(v_m_s, strip.chord_m));
        self.share() * (line.lead_rad - self.reference.lead_rad)
    }

    /// Pressures of an incidence given strip by strip, one a box of the whole lattice.
    pub(crate) fn pressures(&self, wing: &ElasticWing, by_strip: &[f64]) -> Vec<f64> {
        let mut w = Mat::zeros(wing.lattice.len(), 1);
        for (strip, incidence) in self.strips.iter().zip(by_strip) {
            for &entry in &strip.entries {
                w[(wing.correctable.places[entry], 0)] = *incidence;
            }
        }
        wing.pressures(w.as_ref()).col_as_slice(0).to_vec()
    }

    /// All of it as corrections of the true lattice (without the polars' curvature).
    pub(crate) fn corrections(&self, wing: &ElasticWing, v_m_s: f64) -> Corrections {
        let mut all = Corrections::neutral(wing.correctable.len());
        let table = self.at_airspeed(v_m_s);
        let shifts: Vec<f64> = self.strips.iter().map(|strip| self.lead_shift(strip, v_m_s)).collect();
        let shift_cp = self.pressures(wing, &shifts);
        let power = self.settings.force_power;
        for strip in &self.strips {
            let line = self.line(self.polars.reynolds(v_m_s, strip.chord_m));
            let slope = 1.0 + self.share() * (line.slope / self.reference.slope - 1.0);
            let cm = self.share() * (line.cm - self.reference.cm);
            let moment = table.moment_factor.0 + strip.eta * (table.moment_factor.1 - table.moment_factor.0);
            for (row, &entry) in strip.entries.iter().enumerate() {
                let xi = (row as f64 + 0.5) / strip.entries.len() as f64;
                let force = slope * self.settings.force_factor.at(strip.eta, xi, power);
                all.force[entry] = force;
                all.moment[entry] = moment;
                // 6 cm (1 - 2 xi) has no lift and the moment cm about the quarter chord.
                all.pressure_offset[entry] = table.pressure_offset.at(strip.eta, xi, 1.0)
                    + 6.0 * cm * (1.0 - 2.0 * xi)
                    + force * shift_cp[wing.correctable.places[entry]];
            }
        }
        all
    }

    /// The table at an airspeed: linear between its rows.
    fn at_airspeed(&self, v_m_s: f64) -> AirspeedSections {
        let rows = &self.settings.by_airspeed;
        let above = rows.partition_point(|row| row.v_m_s <= v_m_s);
        let (low, high) = (&rows[above.saturating_sub(1)], &rows[above.min(rows.len() - 1)]);
        let width = high.v_m_s - low.v_m_s;
        let share = if width > 0.0 { ((v_m_s - low.v_m_s) / width).clamp(0.0, 1.0) } else { 0.0 };
        let mix = |a: (f64, f64), b: (f64, f64)| (a.0 + share * (b.0 - a.0), a.1 + share * (b.1 - a.1));
        AirspeedSections {
            v_m_s,
            moment_factor: mix(low.moment_factor, high.moment_factor),
            pressure_offset: Corners {
                root: mix(low.pressure_offset.root, high.pressure_offset.root),
                tip: mix(low.pressure_offset.tip, high.pressure_offset.tip),
            },
        }
    }
}

fn zero_line() -> PolarLine {
    PolarLine { slope: 1.0, lead_rad: 0.0, cm: 0.0 }
}
