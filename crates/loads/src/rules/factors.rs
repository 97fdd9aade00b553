//! Limit load factors of maneuvers.

use super::{Mark, Quantity};
use crate::design::{Design, LimitLoadFactors, Rules};
use nastran::InputError;

/// Kilograms of a pound.
const LB_KG: f64 = 0.453_592_37;

/// 2.1 + 24000/(W + 10000), W in pounds, at most 3.8 (23.337(a)(1), 25.337(b)).
pub fn positive_limit(mass_kg: f64) -> f64 {
    (2.1 + 24_000.0 / (mass_kg / LB_KG + 10_000.0)).min(3.8)
}

impl Design {
    /// Limit load factors: the plan's own, or those of its rules for the largest take-off mass.
    ///
    /// # Errors
    /// If neither has them.
    pub fn load_factors(&self) -> Result<(LimitLoadFactors, Vec<Quantity>), InputError> {
        let mtow = self.mtow_kg();
        let of = |n1: (f64, &str, Mark), n2: (f64, &str, Mark), at_vd: (&str, Mark)| {
            let factors = LimitLoadFactors { n1: n1.0, n2: n2.0, n2_at_vd: 0.0 };
            let quantity =
                |name: &str, value: f64, source: &str, mark| Quantity::new(name, value, "-", source, mark);
            let list = vec![
                quantity("n1", n1.0, n1.1, n1.2),
                quantity("n2", n2.0, n2.1, n2.2),
                quantity("n2 at VD", 0.0, at_vd.0, at_vd.1),
            ];
            Ok((factors, list))
        };
        if let Some(own) = self.factors {
            let list = [("n1", own.n1), ("n2", own.n2), ("n2 at VD", own.n2_at_vd)];
            return Ok((own, list.into_iter().map(|(name, n)| Quantity::own(name, n, "-")).collect()));
        }
        match self.rules {
            Rules::Vla => of(
                (3.8, "CS-VLA 337(a)", Mark::Code),
                (-1.5, "CS-VLA 337(b)", Mark::Code),
                ("CS-VLA 333(b)(3)", Mark::Code),
            ),
            Rules::Cs23Normal => {
                let n1 = positive_limit(mtow);
                of(
                    (n1, "14 CFR 23.337(a)(1) before amendment 64", Mark::Code),
                    (-0.4 * n1, "14 CFR 23.337(b)(1) before amendment 64", Mark::Code),
                    ("14 CFR 23.333(b)(3) before amendment 64", Mark::Text),
                )
            }
            Rules::Cs25 => of(
                (positive_limit(mtow).max(2.5), "CS 25.337(b), 14 CFR 25.337(b)", Mark::Text),
                (-1.0, "CS 25.337(c)(1), 14 CFR 25.337(c)(1)", Mark::Text),
                ("CS 25.337(c)(2), 14 CFR 25.337(c)(2)", Mark::Text),
            ),
            Rules::Stanag4671 | Rules::Own => {
                Err(self.asked_for("limit_load_factors", "the field `limit_load_factors`"))
            }
        }
    }
}
