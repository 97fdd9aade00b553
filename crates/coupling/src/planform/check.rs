//! What a parametric wing must satisfy before cards are made of it.

use super::point_mass::check_masses;
use super::{BeamStructure, Control, Fairing, Planform};
use nastran::{InputError, Span};
use std::path::Path;

/// Something wrong in a wing file, with the text that leads to its place there.
#[derive(Debug)]
pub(crate) struct Fault {
    /// A field's name with its colon, or a quoted name: found in the file's text to give line and column.
    pub(crate) anchor: String,
    message: String,
    help: String,
}

impl Fault {
    pub(crate) fn field(field: &str, message: impl Into<String>, help: &str) -> Self {
        Self { anchor: format!("{field}:"), message: message.into(), help: help.to_owned() }
    }

    pub(crate) fn named(name: &str, message: impl Into<String>, help: &str) -> Self {
        Self { anchor: format!("\"{name}\""), message: message.into(), help: help.to_owned() }
    }

    pub(crate) fn at(&self, span: &Span) -> InputError {
        InputError::at(span, self.message.clone()).with_help(self.help.clone())
    }
}

/// Refuses a number that is not above zero, or so large that it can only be a slip.
pub(crate) fn positive(field: &str, value: f64) -> Result<(), Fault> {
    if value > 0.0 && value <= 1e4 {
        return Ok(());
    }
    Err(Fault::field(
        field,
        format!("{field} is {value:?}, expected a number above zero, 10000 at most"),
        "the unit is in the field's name",
    ))
}

/// Refuses a number outside `low` to `high`, or not finite.
pub(crate) fn within(field: &str, value: f64, low: f64, high: f64) -> Result<(), Fault> {
    if (low..=high).contains(&value) {
        return Ok(());
    }
    let message = format!("{field} is {value:?}, expected a number from {low} to {high}");
    Err(Fault::field(field, message, "the unit is in the field's name"))
}

/// Refuses a count outside `low` to `high`.
pub(crate) fn count(field: &str, value: usize, low: usize, high: usize) -> Result<(), Fault> {
    if (low..=high).contains(&value) {
        return Ok(());
    }
    let message = format!("{field} is {value:?}, expected a whole number from {low} to {high}");
    Err(Fault::field(field, message, "counts have no decimal point"))
}

impl Planform {
    /// Checks every number and name of a planform that was changed by a file.
    ///
    /// # Errors
    /// At the field's place in that file, or about the file.
    pub fn checked(&self, path: &Path) -> Result<(), InputError> {
        let text = nastran::read_text(path).unwrap_or_default();
        self.check().map_err(|fault| fault.at(&nastran::place_of(&[&fault.anchor], &text, path)))
    }

    /// Checks every number and name; files are checked when they are read.
    pub(crate) fn check(&self) -> Result<(), Fault> {
        positive("semispan_m", self.semispan_m)?;
        positive("root_chord_m", self.root_chord_m)?;
        positive("tip_chord_m", self.tip_chord_m)?;
        within("quarter_chord_sweep_deg", self.quarter_chord_sweep_deg, -75.0, 75.0)?;
        within("dihedral_deg", self.dihedral_deg, -75.0, 75.0)?;
        within("twist_deg", self.twist_deg.0, -45.0, 45.0)?;
        within("twist_deg", self.twist_deg.1, -45.0, 45.0)?;
        within("root_leading_edge_x_m", self.root_leading_edge_x_m, -1e4, 1e4)?;
        count("chordwise", self.boxes.chordwise, 1, 100)?;
        count("spanwise", self.boxes.spanwise, 1, 900)?;
        self.check_strip_edges()?;
        if let Some(fairing) = &self.fairing {
            fairing.check()?;
        }
        for (index, control) in self.controls.iter().enumerate() {
            self.check_control(control, &self.controls[..index])?;
        }
        self.structure.as_ref().map_or(Ok(()), |structure| structure.check(self))
    }

    fn check_strip_edges(&self) -> Result<(), Fault> {
        let Some(edges) = &self.boxes.strip_edges else { return Ok(()) };
        let fault =
            |message| Fault::field("strip_edges", message, "give fractions of the half span: 0.0, ..., 1.0");
        if edges.len() != self.boxes.spanwise + 1 {
            let expected = self.boxes.spanwise + 1;
            return Err(fault(format!(
                "strip_edges has {} numbers, expected spanwise + 1 = {expected}",
                edges.len()
            )));
        }
        if edges.first() != Some(&0.0) || edges.last() != Some(&1.0) {
            return Err(fault("strip_edges must start with 0.0 and end with 1.0".to_owned()));
        }
        match edges.windows(2).find(|pair| pair[0].partial_cmp(&pair[1]) != Some(std::cmp::Ordering::Less)) {
            Some(pair) => {
                Err(fault(format!("strip_edges must ascend, but {} is followed by {}", pair[0], pair[1])))
            }
            None => Ok(()),
        }
    }

    fn check_control(&self, control: &Control, earlier: &[Control]) -> Result<(), Fault> {
        let name = &control.name;
        let (first, last) = control.strips;
        let fault = |message: String, help: &str| Err(Fault::named(name, message, help));
        let plain = name.chars().all(|letter| letter.is_ascii_alphanumeric() || letter == '_');
        if !plain || name.len() > 8 || !name.starts_with(|letter: char| letter.is_ascii_alphabetic()) {
            return fault(
                format!("control surface name \"{name}\" is no AESURF label"),
                "one to eight letters, digits and underscores, a letter first",
            );
        }
        if first < 1 || first > last || last > self.boxes.spanwise {
            return fault(
                format!(
                    "control surface {name} has strips ({first}, {last}), expected two that ascend from 1 to {}",
                    self.boxes.spanwise
                ),
                "give the first and the last strip, counted from 1 at the root",
            );
        }
        if control.chord_boxes < 1 || control.chord_boxes >= self.boxes.chordwise {
            return fault(
                format!(
                    "control surface {name} has {} boxes along the chord of {}",
                    control.chord_boxes, self.boxes.chordwise
                ),
                "at least one box and fewer than all boxes of the chord",
            );
        }
        if let Some(limit_deg) = control.limit_deg.filter(|limit| !(*limit > 0.0 && *limit <= 90.0)) {
            return fault(
                format!("control surface {name} has limit_deg {limit_deg:?}, expected a number up to 90"),
                "leave limit_deg out if it is not known",
            );
        }
        for other in earlier {
            if other.name.eq_ignore_ascii_case(name) {
                return fault(format!("two control surfaces are called {name}"), "give each its own name");
            }
            if first <= other.strips.1 && other.strips.0 <= last {
                return fault(
                    format!("{name} and {} share strips", other.name),
                    "a strip carries one surface at most",
                );
            }
        }
        Ok(())
    }
}

impl Fairing {
    fn check(&self) -> Result<(), Fault> {
        positive("width_m", self.width_m)?;
        // `strips:` also heads the controls' fields, so the fairing's own name leads to the place.
        if (1..=100).contains(&self.strips) {
            return Ok(());
        }
        let message = format!("the fairing has {} strips, expected 1 to 100", self.strips);
        Err(Fault::field("fairing", message, "leave `fairing` out for a wing without one"))
    }
}

impl BeamStructure {
    pub(super) fn check(&self, semispan_m: f64) -> Result<(), Fault> {
        count("elements", self.elements, 1, 1900)?;
        check_masses(self.point_masses.iter().chain(&self.sensors), semispan_m)
    }
}
