//! Linkages that give way to the hinge moment of deflection and angle of attack (the obvious form: of deflection
//! alone).

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "ctl_compliance",
    parameters: &[Parameter::size("k_at_30_m_s", 0.02, 0.8, Sign::Plus)],
    deflection: |p, at, _, delta| {
        let load = p[0] * at.q_pa / Q_REF_PA;
        for (value, alpha) in delta.iter_mut().zip(at.alpha_rad) {
            *value = (*value - load * ALPHA_SHARE * alpha) / (1.0 + load);
        }
    },
    ..Kind::NONE
};

/// Dynamic pressure that the softness refers to: 30 m/s at sea level.
const Q_REF_PA: f64 = 551.25;
/// Hinge moment of the angle of attack over that of the deflection.
const ALPHA_SHARE: f64 = 0.12;
