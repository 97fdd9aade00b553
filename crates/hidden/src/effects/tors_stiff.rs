//! Another torsional stiffness, more so outboard (the obvious form: one factor).

use super::{Effect, Kind, Parameter, Sign, WingView};
use crate::physics::{Ends, Physics};

pub(super) const KIND: Kind = Kind {
    name: "tors_stiff",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("dGJ", 0.04, 0.6, Sign::Either)],
    make: |values| Box::new(TorsStiff { change: values[0] }),
};

#[derive(Debug)]
struct TorsStiff {
    change: f64,
}

impl Effect for TorsStiff {
    fn physics(&self, _wing: WingView<'_>, _v_m_s: f64, physics: &mut Physics) {
        physics.torsion.add(Ends { root: 0.9 * self.change, tip: 1.2 * self.change });
    }
}
