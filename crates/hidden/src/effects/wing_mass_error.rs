//! A distributed mass that is wrong, more so towards the tip (the obvious form: one factor).

use super::{Effect, Kind, Parameter, Sign, WingView};
use crate::physics::{Ends, Physics};

pub(super) const KIND: Kind = Kind {
    name: "wing_mass_error",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("dm_over_m", 0.01, 0.25, Sign::Either)],
    make: |values| Box::new(WingMassError { share: values[0] }),
};

#[derive(Debug)]
struct WingMassError {
    share: f64,
}

impl Effect for WingMassError {
    fn physics(&self, _wing: WingView<'_>, _v_m_s: f64, physics: &mut Physics) {
        physics.mass.add(Ends { root: 0.85 * self.share, tip: 1.15 * self.share });
    }
}
