//! Families of regressors that a residual may go with: what moves, and powers, rates and signs of it.
//!
//! Each also times dynamic pressure and airspeed, unless the campaign's airspeeds do not tell them apart.

use super::residuals::Unit;
use crate::rules::LocateRules;

/// A column of a unit, by name of its family.
pub struct Column {
    /// Name of the family.
    pub family: &'static str,
    /// As the rows of the unit are, without a channel's weights.
    pub rows: Vec<f64>,
}

/// Names of the families, `run_id` apart.
pub const FAMILIES: [&str; 10] = [
    "1",
    "alpha",
    "alpha^2, alpha^3",
    "alpha_dot",
    "alpha_ddot",
    "sign(alpha_dot)",
    "delta",
    "delta|delta|, delta^3",
    "delta_dot",
    "clock_time",
];

/// All columns of a unit, the same order for all units of a campaign.
pub fn columns(rules: &LocateRules, unit: &Unit) -> Vec<Column> {
    let inputs = &unit.stimulus.inputs;
    let alpha = &inputs.alpha;
    let of =
        |values: &[f64], f: &dyn Fn(f64) -> f64| values.iter().map(|value| f(*value)).collect::<Vec<f64>>();
    let one = vec![1.0; alpha.value.len()];
    let mut base: Vec<(&'static str, Vec<f64>)> = vec![
        ("1", one.clone()),
        ("alpha", alpha.value.clone()),
        ("alpha^2, alpha^3", of(&alpha.value, &|a| a * a)),
        ("alpha^2, alpha^3", of(&alpha.value, &|a| a * a * a)),
        ("alpha_dot", alpha.rate.clone()),
        ("alpha_ddot", alpha.second.clone()),
        ("sign(alpha_dot)", of(&alpha.rate, &|rate| rate / rate.hypot(rules.full_rate_rad_s))),
    ];
    for delta in &inputs.controls_rad {
        base.push(("delta", delta.clone()));
        base.push(("delta|delta|, delta^3", of(delta, &|d| d * d.abs())));
        base.push(("delta|delta|, delta^3", of(delta, &|d| d * d * d)));
        base.push(("delta_dot", rate(delta, unit)));
    }
    let v = unit.v_m_s / rules.reference_v_m_s;
    let rows = unit.rows_of(&base.iter().map(|(_, values)| values.as_slice()).collect::<Vec<_>>());
    let mut all: Vec<Column> = base
        .iter()
        .zip(&rows)
        .flat_map(|((family, _), rows)| {
            let times = |factor: f64| Column { family, rows: of(rows, &|value| factor * value) };
            [times(1.0), times(v * v), times(v)]
        })
        .collect();
    all.push(Column { family: "clock_time", rows: of(&rows[0], &|value| unit.stimulus.clock_h * value) });
    all
}

/// Central differences; static points have no rate.
fn rate(values: &[f64], unit: &Unit) -> Vec<f64> {
    let n = values.len();
    let at = |i: usize| {
        let (before, after) = (i.saturating_sub(1), (i + 1).min(n - 1));
        (values[after] - values[before]) / ((after - before).max(1) as f64 * unit.stimulus.time_step_s)
    };
    if unit.stimulus.steady { vec![0.0; n] } else { (0..n).map(at).collect() }
}
