//! Another torsional stiffness, more so outboard (the obvious form: one factor).

use super::{Kind, Parameter, Sign};
use crate::physics::Ends;

pub(super) const KIND: Kind = Kind {
    name: "tors_stiff",
    parameters: &[Parameter::size("dGJ", 0.04, 0.6, Sign::Either)],
    physics: |p, _, _, physics| {
        physics.torsion.add(Ends { root: 0.9 * p[0], tip: 1.2 * p[0] });
    },
    ..Kind::NONE
};
