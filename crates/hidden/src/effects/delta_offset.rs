//! Surfaces that are rigged off zero.

use super::{Effect, Kind, Parameter, Sign};
use crate::flown::At;

pub(super) const KIND: Kind = Kind {
    name: "delta_offset",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("d0_deg", 0.05, 2.0, Sign::Either), Parameter::choice("control", 3)],
    make: |values| Box::new(DeltaOffset { offset_deg: values[0], control: super::chosen(values[1], 3) }),
};

#[derive(Debug)]
struct DeltaOffset {
    offset_deg: f64,
    control: usize,
}

impl Effect for DeltaOffset {
    fn deflection(&self, _at: &At<'_>, control: usize, delta: &mut [f64]) {
        if control == self.control {
            for value in delta {
                *value += self.offset_deg.to_radians();
            }
        }
    }
}
