//! A concentrated mass near the tip, spread over two points (the obvious form: one point).

use super::{Effect, Kind, Parameter, Sign, WingView};
use crate::physics::{Physics, PointMass};

pub(super) const KIND: Kind = Kind {
    name: "tip_mass",
    in_library: true,
    compared: None,
    parameters: &[
        Parameter::size("m_kg", 0.01, 0.25, Sign::Plus),
        Parameter::shape("y_over_L", 0.8, 0.97, Sign::Plus),
        Parameter::shape("x_over_c", 0.25, 0.6, Sign::Plus),
    ],
    make: |values| Box::new(TipMass { mass_kg: values[0], eta: values[1], x_over_c: values[2] }),
};

#[derive(Debug)]
struct TipMass {
    mass_kg: f64,
    eta: f64,
    x_over_c: f64,
}

impl Effect for TipMass {
    fn physics(&self, _wing: WingView<'_>, _v_m_s: f64, physics: &mut Physics) {
        if self.mass_kg == 0.0 {
            return;
        }
        for (share, along, aft) in [(0.6, 0.02, -0.05), (0.4, -0.03, 0.075)] {
            physics.point_masses.push(PointMass {
                mass_kg: share * self.mass_kg,
                eta: self.eta + along,
                x_over_c: self.x_over_c + aft,
            });
        }
    }
}
