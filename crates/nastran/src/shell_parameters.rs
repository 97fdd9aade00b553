//! PARAM K6ROT and SNORM: how a deck's flat shells carry rotations about their normals.

use crate::{BulkData, InputError};

/// What a deck says about rotations about the normals of flat shells, or Nastran's default.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShellParameters {
    /// Stiffness of rotations about the normal, in millionths of the membrane's shear stiffness: 100 is MSC Nastran's default
    /// (Simcenter's is none). Where it is zero AUTOSPC holds what has no other stiffness.
    pub k6rot: f64,
    /// Shells that stand off the mean of their normals at a grid by no more than this share it; not above zero: none do.
    pub snorm_deg: f64,
}

impl BulkData {
    /// PARAM K6ROT and SNORM.
    ///
    /// # Errors
    /// If K6ROT is negative or SNORM is not below 90.
    pub fn shell_parameters(&self) -> Result<ShellParameters, InputError> {
        let given = |name, default| self.parameters.get(name).copied().unwrap_or(default);
        let (k6rot, snorm_deg) = (given("K6ROT", 100.0), given("SNORM", 20.0));
        let bad = |what: String, help| Err(InputError::general(what).with_help(help));
        if !(0.0..f64::INFINITY).contains(&k6rot) {
            let help = "it is a stiffness in millionths of the membrane's: zero or more";
            return bad(format!("PARAM K6ROT is {k6rot}"), help);
        }
        if snorm_deg.is_nan() || snorm_deg >= 90.0 {
            let help =
                "it is an angle between normals in degrees, less than 90; zero leaves each shell its own";
            return bad(format!("PARAM SNORM is {snorm_deg}"), help);
        }
        Ok(ShellParameters { k6rot, snorm_deg })
    }

    /// What is taken where a deck with flat shells (other than CQUADR and CTRIAR) leaves K6ROT open: said to the user.
    pub fn shell_remark(&self) -> Option<String> {
        let is_flat = self.shells.values().any(|card| card.midsides.is_empty() && !card.is_r);
        (is_flat && !self.parameters.contains_key("K6ROT")).then(|| {
            "the deck has no PARAM K6ROT: rotations of flat shells about their normals get 100, MSC Nastran's default (Simcenter's is 0)".to_owned()
        })
    }
}
