//! Lift that shows in the pitching moment, and a little of the moment in the lift: the inverse of a matrix (the
//! obvious form: the matrix).

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "crosstalk",
    parameters: &[Parameter::size("c_my_fz_m", 0.002, 0.08, Sign::Either)],
    sensor: |p, _, flown| {
        // (1 - C)⁻¹ of a C with two entries
        let back = BACK_PER_M * p[0];
        let over = 1.0 / (1.0 - back * p[0]);
        let [fz, _, my] = &mut flown.loads;
        for (fz, my) in fz.iter_mut().zip(my) {
            let (lift, moment) = (*fz, *my);
            *fz = over * (lift + back * moment);
            *my = over * (moment + p[0] * lift);
        }
    },
    ..Kind::NONE
};

/// What of a moment shows in the lift, over what of a lift shows in the moment, 1/m².
const BACK_PER_M: f64 = 0.15;
