//! The balance's channels read a share of each other: interaction, or axes not aligned.
//! `y += C y`, C without diagonal.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct Crosstalk;

impl Effect for Crosstalk {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "crosstalk",
            title: "channels of the balance read a share of each other",
            side: Side::Balance,
            rivals: &["ac_shift", "gain", "joiner_inertia", "balance_nonlin"],
            experiment: "dead weights at several stations, wind off",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![
            Parameter::new("c_fz_mx_per_m", (-0.2, 0.2), 0.02),
            Parameter::new("c_fz_my_per_m", (-0.2, 0.2), 0.02),
            Parameter::new("c_mx_fz_m", (-0.2, 0.2), 0.02),
            Parameter::new("c_mx_my", (-0.2, 0.2), 0.02),
            Parameter::new("c_my_fz_m", (-0.2, 0.2), 0.02),
            Parameter::new("c_my_mx", (-0.2, 0.2), 0.02),
        ]
    }

    fn stage(&self) -> Stage {
        Stage::Reading
    }

    fn loads(&self, p: &[f64], _place: &Place<'_>, seen: &Seen<'_>, loads: &mut Loads) {
        for i in 0..seen.len() {
            let [fz, mx, my] = [0, 1, 2].map(|c| loads.balance[c][i]);
            loads.balance[0][i] += p[0] * mx + p[1] * my;
            loads.balance[1][i] += p[2] * fz + p[3] * my;
            loads.balance[2][i] += p[4] * fz + p[5] * mx;
        }
    }
}
