//! A balance that creeps: it gives way a little further while a load stays, on all channels, which no library has.

use super::filters::lag;
use super::{Effect, Kind, Parameter, Sign};
use crate::flown::{At, Flown};

pub(super) const KIND: Kind = Kind {
    name: "balance_creep",
    in_library: false,
    compared: None,
    parameters: &[
        Parameter::size("share", 0.02, 0.2, Sign::Plus),
        Parameter::shape("time_s", 0.2, 1.0, Sign::Plus),
    ],
    make: |values| Box::new(BalanceCreep { share: values[0], time_s: values[1] }),
};

#[derive(Debug)]
struct BalanceCreep {
    share: f64,
    time_s: f64,
}

impl Effect for BalanceCreep {
    fn sensor(&self, at: &At<'_>, flown: &mut Flown) {
        for load in &mut flown.loads {
            let mut late = load.clone();
            lag(&mut late, self.time_s, at.time_step_s);
            // what is static is calibrated: creep is what is still to come
            for (now, late) in load.iter_mut().zip(late) {
                *now -= self.share * (*now - late);
            }
        }
    }
}
