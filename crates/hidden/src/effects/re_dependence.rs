//! A lift slope that follows a power of the airspeed (the obvious form: linear in its inverse).

use super::{Effect, Kind, Parameter, Sign, WingView};
use crate::physics::Physics;

pub(super) const KIND: Kind = Kind {
    name: "re_dependence",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("r", 0.01, 0.4, Sign::Either)],
    make: |values| Box::new(ReDependence { power: values[0] }),
};

/// Airspeed at which nothing changes.
const V_REF_M_S: f64 = 30.0;

#[derive(Debug)]
struct ReDependence {
    power: f64,
}

impl Effect for ReDependence {
    fn physics(&self, _wing: WingView<'_>, v_m_s: f64, physics: &mut Physics) {
        let factor = (V_REF_M_S / v_m_s.max(1.0)).powf(self.power);
        for lift in &mut physics.lift {
            *lift *= factor;
        }
    }
}
