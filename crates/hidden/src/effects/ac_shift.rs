//! A shift of the point where the lift acts, growing towards the tip (the obvious form: the same share of every chord).

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "ac_shift",
    parameters: &[Parameter::size("dx_over_c", 0.004, 0.05, Sign::Either)],
    physics: |p, wing, _, physics| {
        for (aft, eta) in physics.centre_aft_over_c.iter_mut().zip(&wing.strips.eta) {
            *aft += p[0] * (0.8 + 0.45 * eta);
        }
    },
    ..Kind::NONE
};
