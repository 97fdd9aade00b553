//! A balance that creeps: it gives way a little further while a load stays, on all channels, which no library has.

use super::filters::lag;
use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "balance_creep",
    in_library: false,
    parameters: &[
        Parameter::size("share", 0.02, 0.2, Sign::Plus),
        Parameter::shape("time_s", 0.2, 1.0, Sign::Plus),
    ],
    sensor: |p, at, flown| {
        let (share, time_s) = (p[0], p[1]);
        for load in &mut flown.loads {
            let mut late = load.clone();
            lag(&mut late, time_s, at.time_step_s);
            // what is static is calibrated: creep is what is still to come
            for (now, late) in load.iter_mut().zip(late) {
                *now -= share * (*now - late);
            }
        }
    },
    ..Kind::NONE
};
