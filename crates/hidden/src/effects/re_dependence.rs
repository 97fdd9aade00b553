//! A lift slope that follows a power of the airspeed (the obvious form: linear in its inverse).

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "re_dependence",
    parameters: &[Parameter::size("r", 0.01, 0.4, Sign::Either)],
    physics: |p, _, v_m_s, physics| {
        let factor = (V_REF_M_S / v_m_s.max(1.0)).powf(p[0]);
        for lift in &mut physics.lift {
            *lift *= factor;
        }
    },
    ..Kind::NONE
};

/// Airspeed at which nothing changes.
const V_REF_M_S: f64 = 30.0;
