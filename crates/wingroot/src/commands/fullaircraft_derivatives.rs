//! Stability and control derivatives as a table: rigid, and elastic with the aircraft free, initial beside updated model.

use fullaircraft::results::comparison::BothDerivatives;
use fullaircraft::{Coefficients, Derivatives};

/// Name of a coefficient and where it is.
type Named = (&'static str, fn(&Coefficients) -> f64);

/// Of each variable the coefficients that a symmetric aircraft has.
const SYMMETRIC: [Named; 2] = [("CL", |c| c.lift), ("Cm", |c| c.pitch)];
const ANTISYMMETRIC: [Named; 3] = [("CY", |c| c.side), ("Cl", |c| c.roll), ("Cn", |c| c.yaw)];

/// The table; restrained ones are in `result.json` only.
pub(crate) fn table(both: &BothDerivatives) -> report::Table {
    let (initial, updated) = (&both.initial, &both.updated);
    let title = format!("derivatives at {} m/s (per rad)", initial.v_m_s);
    let mut table = report::Table::new(&[
        &title,
        "initial, rigid",
        "initial, elastic",
        "updated, rigid",
        "updated, elastic",
    ]);
    for (before, after) in initial.derivatives.iter().zip(&updated.derivatives) {
        let even = |c: &Coefficients| c.lift.abs() + c.pitch.abs();
        let odd = |c: &Coefficients| c.side.abs() + c.roll.abs() + c.yaw.abs();
        let symmetric = even(&before.rigid) >= odd(&before.rigid);
        let rows: &[Named] = if symmetric { &SYMMETRIC } else { &ANTISYMMETRIC };
        for (name, of) in rows {
            let cells = [&before.rigid, &before.unrestrained, &after.rigid, &after.unrestrained];
            let numbers = cells.map(|c| format!("{:.4}", of(c)));
            table.row(std::iter::once(format!("{name} by {}", before.variable)).chain(numbers));
        }
    }
    let places =
        |d: &Derivatives| [d.neutral_point_x_m[0], d.neutral_point_x_m[2]].map(|x_m| format!("{x_m:.4}"));
    let name = std::iter::once("neutral point x (m)".to_owned());
    table.row(name.chain(places(initial)).chain(places(updated)));
    table
}
