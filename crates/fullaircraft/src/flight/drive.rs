//! What a command moves: one control surface, or several in fixed shares.

use crate::aircraft::assembly::Aircraft;
use nastran::InputError;

/// A command's name and the surfaces it moves, each with its share of the commanded angle.
#[derive(Debug, Clone, PartialEq)]
pub struct Drive {
    /// Name.
    pub name: String,
    /// Index of a control surface and its share.
    pub parts: Vec<(usize, f64)>,
}

impl Aircraft {
    /// The drive of a control of the aircraft: the elevator moves both halves alike; any other pair moves antisymmetrically,
    /// right trailing edge down positive; a single surface (the rudder, or `L_` of one side) moves alone.
    ///
    /// # Errors
    /// If there is no such control; names the ones there are.
    pub fn drive(&self, name: &str) -> Result<Drive, InputError> {
        let parts = match (self.control(name), self.control(&format!("L_{name}"))) {
            (Some(right), Some(left)) if name == self.file.htp.control.name => {
                vec![(right, 1.0), (left, 1.0)]
            }
            (Some(right), Some(left)) => vec![(right, 1.0), (left, -1.0)],
            (Some(alone), None) => vec![(alone, 1.0)],
            // the complaint about a pair that is not there names all controls
            _ => self.control_pair(name).map(|_| Vec::new())?,
        };
        Ok(Drive { name: name.to_owned(), parts })
    }
}
