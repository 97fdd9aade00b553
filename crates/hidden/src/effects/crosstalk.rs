//! Lift that shows in the pitching moment, and a little of the moment in the lift: the inverse of a matrix (the
//! obvious form: the matrix).

use super::{Effect, Kind, Parameter, Sign};
use crate::flown::{At, Flown};

pub(super) const KIND: Kind = Kind {
    name: "crosstalk",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("c_my_fz_m", 0.002, 0.08, Sign::Either)],
    make: |values| Box::new(Crosstalk { moment_of_lift_m: values[0] }),
};

/// What of a moment shows in the lift, over what of a lift shows in the moment, 1/m².
const BACK_PER_M: f64 = 0.15;

#[derive(Debug)]
struct Crosstalk {
    moment_of_lift_m: f64,
}

impl Effect for Crosstalk {
    fn sensor(&self, _at: &At<'_>, flown: &mut Flown) {
        // (1 - C)⁻¹ of a C with two entries
        let back = BACK_PER_M * self.moment_of_lift_m;
        let over = 1.0 / (1.0 - back * self.moment_of_lift_m);
        let [fz, _, my] = &mut flown.loads;
        for (fz, my) in fz.iter_mut().zip(my) {
            let (lift, moment) = (*fz, *my);
            *fz = over * (lift + back * moment);
            *my = over * (moment + self.moment_of_lift_m * lift);
        }
    }
}
