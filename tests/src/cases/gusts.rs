//! Gusts met by wings (data/published/gust__*.json): doublet lattice in frequency, Fourier series in time.

use super::flutter_decks::NASTRAN;
use crate::half_wing::WALL;
use crate::registry::Case;
use crate::row::{Row, worst};
use crate::{list, number, numbers};
use aero::{DoubletLattice, Integration, Lattice};
use faer::{Mat, c64};
use maneuver::gust::{FrequencyTable, OneMinusCosineGust, gust_incidence, periodic_response};
use serde_json::Value;

/// The cases of this file.
pub const CASES: &[Case] = &[Case { file: "gust__rect_ar6_gust_M0", run: rigid_wing }];

/// Lift, moment about the quarter chord and bending moment at the root of a rectangle of chord 1 in a gust whose phase is taken
/// at mid-chord, over half area, chord and dynamic pressure.
fn lift_moment_bending(lattice: &Lattice, doublets: &DoubletLattice, kappa: f64) -> Mat<c64> {
    let cp = doublets.at(kappa).expect("a frequency").pressures(gust_incidence(lattice, 0.5, kappa).as_ref());
    let integration = Integration::new(lattice);
    let area: f64 = (0..lattice.len()).map(|j| integration.area(j)).sum();
    Mat::from_fn(3, 1, |row, _| {
        let each = lattice.boxes.iter().enumerate().map(|(j, panel)| {
            let point = panel.quarter_point();
            cp[(j, 0)] * (integration.area(j) / area * [1.0, 0.25 - point.x, point.y][row])
        });
        each.sum::<c64>()
    })
}

/// A rigid rectangle of aspect ratio 6 in two gusts: peaks, and whole histories.
fn rigid_wing(case: &Value) -> Vec<Row> {
    let semispan = 0.5 * number(&case["inputs"]["AR"]);
    let lattice =
        Lattice::trapezoid(1, [0.0; 3], 1.0, [0.0, semispan, 0.0], 1.0, [8, 16]).expect("a rectangle");
    let doublets =
        DoubletLattice::new(&lattice, WALL, number(&case["inputs"]["mach"]), &NASTRAN).expect("a half");
    // omega/V of k = 0 to 2
    let kappa: Vec<f64> = (0..=24).map(|i| 4.0 * (f64::from(i) / 24.0).powi(2)).collect();
    let answers = kappa.iter().map(|kappa| lift_moment_bending(&lattice, &doublets, *kappa)).collect();
    let table = FrequencyTable::new(kappa, answers, 0.5).expect("rising frequencies");
    let mut rows = vec![in_frequency(case, &table)];
    // chord and airspeed are one: times are tau = V t/c, and the period is 200 of them
    let (samples, step) = (4096, 200.0 / 4096.0);
    for want in list(&case["expected"]).iter().filter(|want| want.get("Lg_over_c").is_some()) {
        let length_m = number(&want["Lg_over_c"]);
        let gust = OneMinusCosineGust { incidence_rad: 1.0, length_m, start_s: 0.0 };
        let signal: Vec<f64> = (0..samples).map(|k| gust.at(step * f64::from(k), 1.0)).collect();
        let answer = |omega: f64| {
            table.at(omega, 0.0).map(|column| (0..3).map(|row| column[(row, 0)]).collect::<Vec<c64>>())
        };
        let got = periodic_response(&signal, step, 4.0, answer).expect("within the table");
        let [lift, ..] = &got.answers[..] else { panic!("three answers") };
        let at_peak = (0..lift.len()).max_by(|a, b| lift[*a].total_cmp(&lift[*b])).expect("samples");
        let name = |what: &str| format!("gust of {length_m} chords: {what}");
        let peak = number(&want["peak_CL_over_w0V"]);
        rows.push(Row::relative(name("largest lift"), lift[at_peak], peak, 0.01));
        let tau = step * at_peak as f64;
        let abs = number(&case["tolerance"]["tau_peak"]);
        rows.push(Row::absolute(name("time of it"), tau, number(&want["tau_peak"]), abs));
        for (answer, what) in
            ["lift", "moment about the quarter chord", "bending at the root"].iter().enumerate()
        {
            let printed: Vec<Vec<f64>> = list(&want["rows"]).iter().map(numbers).collect();
            let size = printed.iter().map(|row| row[1 + answer].abs()).fold(0.0, f64::max);
            let each = printed.iter().map(|row| {
                let after = (0..samples).position(|k| step * f64::from(k) > row[0] - 0.5 * step);
                let ours = got.answers[answer][after.expect("a time within the period")];
                Row::absolute(format!("at V t/c = {}", row[0]), ours, row[1 + answer], 0.01 * size)
            });
            rows.push(worst(&name(what), each.collect()));
        }
    }
    rows
}

/// Lift in gusts of single frequencies, phase at the leading edge; held to the same 1 % as the peaks, of the largest.
fn in_frequency(case: &Value, table: &FrequencyTable) -> Row {
    let printed =
        list(&case["expected"]).iter().find_map(|want| want.get("gust_frequency_response_CL_ref_LE"));
    let each = list(printed.expect("the case has one")).iter().flat_map(|want| {
        let (k, want) = (number(&want["k"]), numbers(&want["CL"]));
        let ours = table.at(2.0 * k, 0.0).expect("within the table")[(0, 0)];
        [("real", ours.re, want[0]), ("imaginary", ours.im, want[1])]
            .map(|(part, ours, want)| Row::absolute(format!("{part} part at k = {k}"), ours, want, 0.043))
    });
    worst("lift in an oscillating gust", each.collect())
}
