//! A concentrated mass near the tip, spread over two points (the obvious form: one point).

use super::{Kind, Parameter, Sign};
use crate::physics::PointMass;

pub(super) const KIND: Kind = Kind {
    name: "tip_mass",
    parameters: &[
        Parameter::size("m_kg", 0.01, 0.25, Sign::Plus),
        Parameter::shape("y_over_L", 0.8, 0.97, Sign::Plus),
        Parameter::shape("x_over_c", 0.25, 0.6, Sign::Plus),
    ],
    physics: |p, _, _, physics| {
        let (mass_kg, eta, x_over_c) = (p[0], p[1], p[2]);
        if mass_kg == 0.0 {
            return;
        }
        for (share, along, aft) in [(0.6, 0.02, -0.05), (0.4, -0.03, 0.075)] {
            physics.point_masses.push(PointMass {
                mass_kg: share * mass_kg,
                eta: eta + along,
                x_over_c: x_over_c + aft,
            });
        }
    },
    ..Kind::NONE
};
