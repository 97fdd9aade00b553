//! Another bending stiffness, more so outboard (the obvious form: one factor).

use super::{Effect, Kind, Parameter, Sign, WingView};
use crate::physics::{Ends, Physics};

pub(super) const KIND: Kind = Kind {
    name: "bend_stiff",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("dEI", 0.02, 0.45, Sign::Either)],
    make: |values| Box::new(BendStiff { change: values[0] }),
};

#[derive(Debug)]
struct BendStiff {
    change: f64,
}

impl Effect for BendStiff {
    fn physics(&self, _wing: WingView<'_>, _v_m_s: f64, physics: &mut Physics) {
        physics.bending.add(Ends { root: 0.92 * self.change, tip: 1.16 * self.change });
    }
}
