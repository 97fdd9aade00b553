//! The trims of a study as cards.

use super::cards::{FIRST, card, label, real};
use super::file::Study;
use super::trims::{Balance, Control, Point};
use nastran::{BulkData, InputError};
use std::fmt::Write as _;
use std::path::Path;

/// Its constraint sets: its own, and the union with the decks' set.
const OWN_SET: u32 = FIRST;
const UNION: u32 = FIRST + 1;
/// Its system of reference.
const REFERENCE: u32 = FIRST + 2;

impl Study {
    /// Whether what the trims name is in the decks.
    pub(super) fn check_trims(&self, path: &Path, decks: &BulkData) -> Result<(), InputError> {
        let refuse = |field: &str, message: String| InputError::in_field(path, field, message);
        if let Some(grid) = self.support.filter(|grid| !decks.grids.contains_key(grid)) {
            return Err(refuse("support", format!("GRID {grid} is not in the decks")));
        }
        if let Some(card) = decks.supports.first() {
            let message = format!("the decks have a SUPORT of their own, at grid {}", card.grid);
            return Err(refuse("support", message)
                .with_help("take it out of the decks: the study supports the aircraft"));
        }
        let moved = self.controls.iter().flat_map(|control| control.moves.iter().map(|(surface, _)| surface));
        for surface in moved {
            if decks.surfaces.values().all(|card| card.label != *surface) {
                let there: Vec<&str> = decks.surfaces.values().map(|card| card.label.as_str()).collect();
                let message = format!("AESURF {surface} is not in the decks");
                return Err(refuse("controls", message).with_help(format!("there are {}", there.join(", "))));
            }
        }
        Ok(())
    }

    /// The set of constraints of the trims.
    pub(super) fn set_of_trims(&self) -> u32 {
        if self.spc.is_some() { UNION } else { OWN_SET }
    }

    /// A subcase a trim.
    pub(super) fn subcases_of_trims(&self) -> String {
        let mut text = String::new();
        for (number, trim) in (1..).zip(&self.trims) {
            let _ = writeln!(text, "SUBCASE {number}\n  LABEL = {}\n  TRIM = {number}", label(&trim.name));
        }
        text
    }

    /// The support, what is held of it, references, variables, links and trims.
    pub(super) fn cards_of_trims(&self, decks: &BulkData) -> String {
        self.held() + &self.references(decks) + &self.variables(decks) + &self.points(decks)
    }

    /// Whether a trim of it balances all axes, so that the support leaves all of them free.
    fn is_in_all_axes(&self) -> bool {
        self.trims.iter().any(|trim| trim.balance == Balance::AllAxes)
    }

    fn held(&self) -> String {
        let (held, free) = if self.is_in_all_axes() { ("1", "23456") } else { ("1246", "35") };
        let grid = self.support.unwrap_or_default().to_string();
        let mut text = card("SPC1", &[OWN_SET.to_string(), held.to_owned(), grid.clone()]);
        if let Some(set) = self.spc {
            text += &card("SPCADD", &[UNION.to_string(), OWN_SET.to_string(), set.to_string()]);
        }
        text + &card("SUPORT", &[grid, free.to_owned()])
    }

    /// The references, if they are given and whole.
    fn references(&self, decks: &BulkData) -> String {
        let Some(of) = &self.reference else { return String::new() };
        let (Some([x, y, z]), Some(area), Some(span)) = (of.point, of.area, of.span) else {
            return String::new();
        };
        let point = [[x, y, z], [x, y, z + 1.0], [x + 1.0, y, z]].concat();
        let head = [REFERENCE.to_string(), "0".to_owned()];
        let system = card("CORD2R", &head.into_iter().chain(point.into_iter().map(real)).collect::<Vec<_>>());
        let systems = [self.stream(decks), REFERENCE].map(|id| id.to_string());
        let symmetries = [u8::from(of.is_half), 0].map(|word| word.to_string());
        system + &card("AEROS", &[&systems[..], &[of.chord, span, area].map(real), &symmetries].concat())
    }

    /// Variables of trim and links of surfaces.
    fn variables(&self, decks: &BulkData) -> String {
        let mut text = String::new();
        let rigid = ["ANGLEA", "SIDES", "ROLL", "PITCH", "YAW", "URDD2", "URDD3", "URDD4", "URDD5", "URDD6"];
        if decks.trim_variables.is_empty() {
            for (number, label) in (FIRST..).zip(rigid) {
                text += &card("AESTAT", &[number.to_string(), label.to_owned()]);
            }
        }
        for control in &self.controls {
            let Some(((leader, unit), others)) = control.moves.split_first() else { continue };
            for (other, factor) in others {
                let ratio = -factor / unit;
                text += &card("AELINK", &["ALWAYS".to_owned(), other.clone(), leader.clone(), real(ratio)]);
            }
        }
        text
    }

    /// The trims.
    fn points(&self, decks: &BulkData) -> String {
        let mut text = String::new();
        let zero = || "0.".to_owned();
        let of_decks = decks.aero_reference.as_ref().map(|aeros| aeros.chord);
        let chord = self.reference.map(|of| of.chord).or(of_decks).unwrap_or(0.0);
        for (number, trim) in (1..).zip(&self.trims) {
            let mut fixed: Vec<(String, String)> =
                ["SIDES", "ROLL", "YAW", "URDD5"].map(|label| (label.to_owned(), zero())).to_vec();
            let q = 0.5 * trim.rho * trim.v * trim.v;
            let pitch = trim.pitch_rate_deg.to_radians() * chord / (2.0 * trim.v);
            fixed.push(("PITCH".to_owned(), real(pitch)));
            fixed.push(("URDD3".to_owned(), real(trim.load_factor * self.gravity.unwrap_or_default())));
            // Accelerations that nothing balances are free where the support is.
            let still: &[&str] = match (trim.balance, self.is_in_all_axes()) {
                (Balance::AllAxes, _) => &["URDD4", "URDD6"],
                (Balance::Pitch, true) => &[],
                (Balance::Pitch, false) => &["URDD2", "URDD4", "URDD6"],
            };
            fixed.extend(still.iter().map(|label| ((*label).to_owned(), zero())));
            fixed.extend(self.surfaces_of(trim, decks));
            let mut fields = vec![number.to_string(), real(trim.mach), real(q)];
            for (place, (label, value)) in fixed.into_iter().enumerate() {
                if place == 2 {
                    // AEQR, which the first line has behind two variables
                    fields.push("1.0".to_owned());
                }
                fields.extend([label, value]);
            }
            text += &card("TRIM", &fields);
        }
        text
    }

    /// Values of the surfaces that do not balance a trim and follow no other.
    fn surfaces_of(&self, trim: &Point, decks: &BulkData) -> Vec<(String, String)> {
        let leads = |control: &Control, label: &str| control.moves[0].0 == label;
        let follows = |label: &str| {
            self.controls.iter().any(|control| control.moves[1..].iter().any(|(other, _)| other == label))
        };
        let is_free = |label: &str| {
            self.controls.iter().any(|control| leads(control, label) && trim.free.contains(&control.name))
        };
        let value = |label: &str| {
            let control = self.controls.iter().find(|control| leads(control, label));
            control.and_then(|control| trim.held_deg.get(&control.name)).copied().unwrap_or(0.0).to_radians()
        };
        let labels = decks.surfaces.values().map(|card| card.label.as_str());
        let fixed = labels.filter(|label| !follows(label) && !is_free(label));
        fixed.map(|label| (label.to_owned(), real(value(label)))).collect()
    }
}
