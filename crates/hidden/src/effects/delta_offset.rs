//! Surfaces that are rigged off zero.

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "delta_offset",
    parameters: &[Parameter::size("d0_deg", 0.05, 2.0, Sign::Either), Parameter::choice("control", 3)],
    deflection: |p, _, control, delta| {
        let (offset_deg, its_control) = (p[0], super::chosen(p[1], 3));
        if control == its_control {
            for value in delta {
                *value += offset_deg.to_radians();
            }
        }
    },
    ..Kind::NONE
};
