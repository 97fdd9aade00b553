//! Strip theory from the doublet lattice: sections of a wing so long that it has no ends, beside Theodorsen's, Sears',
//! Wagner's and Kuessner's functions (data/published/unsteady2d__*.json).
//!
//! All strips of an endless wing carry the same, so the influences of all strips on the middle one are summed, and the
//! section's few pressures solved for. The strips widen outwards, to 2000 chords; the innermost are two boxes' chords wide.
//! A lattice's error halves when its boxes are doubled, so twice the finer result less the coarser is better than both.

use crate::registry::Case;
use crate::row::{Row, worst};
use crate::theodorsen::{sears, theodorsen};
use crate::{list, number};
use aero::{AeroBox, DlmSettings, DoubletLattice, KernelIntegral, Lattice, MirrorPlane, SpanFit};
use faer::linalg::solvers::Solve;
use faer::{Mat, c64};
use maneuver::flutter::MatrixSpline;
use nalgebra::Point3;
use serde_json::Value;
use std::f64::consts::PI;

/// The cases of this file.
pub const CASES: &[Case] = &[
    Case { file: "unsteady2d__theodorsen", run: in_frequency },
    Case { file: "unsteady2d__wagner_kussner", run: in_time },
];

const SETTINGS: DlmSettings = DlmSettings { integral: KernelIntegral::Fine, fit: SpanFit::Quartic };

/// Half of the endless wing, chord 2, `n` boxes along it.
fn endless(n: u32) -> Lattice {
    let mut edges = vec![0.0];
    let (mut last, mut width) = (0.0, 4.0 / f64::from(n));
    while last < 4000.0 {
        last += width;
        edges.push(last);
        width *= 1.6;
    }
    let x = |i: u32| 2.0 * f64::from(i) / f64::from(n);
    let boxes = edges.windows(2).flat_map(|sides| {
        (0..n).map(|i| {
            [(i, sides[0]), (i + 1, sides[0]), (i + 1, sides[1]), (i, sides[1])]
                .map(|(i, y)| Point3::new(x(i), y, 0.0))
        })
    });
    let boxes = (1..).zip(boxes).map(|(id, corners)| AeroBox { id, corners }).collect();
    Lattice::from_corners("endless", n as usize, boxes).expect("rectangles")
}

/// Lift coefficients of a section of chord 2 (so that omega/V is k) with `n` boxes for columns of incidence by x.
fn section(n: u32, k: f64, w: impl Fn(f64, usize) -> c64) -> [c64; 2] {
    let lattice = endless(n);
    let plane = MirrorPlane::Symmetric { y_m: 0.0 };
    let doublets = DoubletLattice::new(&lattice, plane, 0.0, &SETTINGS).expect("a half wing");
    let all = doublets.influence(k).expect("a frequency");
    let n = n as usize;
    let section =
        Mat::from_fn(n, n, |i, j| (0..lattice.len() / n).map(|strip| all[(i, strip * n + j)]).sum::<c64>());
    let right = Mat::from_fn(n, 2, |i, column| w(lattice.boxes[i].three_quarter_point().x, column));
    let cp = section.partial_piv_lu().solve(right);
    [0, 1].map(|column| (0..n).map(|i| cp[(i, column)]).sum::<c64>() / c64::from(n as f64))
}

/// C(k) from the lift of a section in heave, and Sears' function from that in a gust met at mid-chord.
fn functions(n: u32, k: f64) -> [c64; 2] {
    let i = c64::new(0.0, 1.0);
    let [heave, gust] =
        section(n, k, |x, column| if column == 0 { -i * k } else { (-i * (k * (x - 1.0))).exp() });
    // lift = pi b (omega/V)^2 - 2 pi i (omega/V) C for a displacement of 1 upwards, b = 1
    [(c64::from(PI * k * k) - heave) / (i * (2.0 * PI * k)), gust / (2.0 * PI)]
}

/// The closed forms of this package meet the table's 1e-10. The lattice comes to it with the number of boxes: held to 1e-3 up
/// to k = 2 with 16 and 32 boxes, and its error must halve (below k = 0.001 the wave is as long as the wing, and its ends show
/// by 5e-5).
fn in_frequency(case: &Value) -> Vec<Row> {
    let rel = number(&case["tolerance"]["rel"]);
    let mut rows = Vec::new();
    for (which, table, names, formula) in [
        (0, "C", ["F", "G"], theodorsen as fn(f64) -> c64),
        (1, "sears_midchord", ["re", "im"], sears as fn(f64) -> c64),
    ] {
        let [mut closed, mut lattice, mut halving] = [Vec::new(), Vec::new(), Vec::new()];
        for row in list(&case["expected"][table]) {
            let (k, want) = (number(&row["k"]), c64::new(number(&row[names[0]]), number(&row[names[1]])));
            let what = format!("k = {k}");
            closed.push(Row::absolute(what.clone(), (formula(k) - want).norm(), 0.0, rel * want.norm()));
            if k > 2.0 {
                continue;
            }
            let [coarse, fine] = [16, 32].map(|n| functions(n, k)[which]);
            let off = [coarse, fine, fine * 2.0 - coarse].map(|value| (value - want).norm());
            lattice.push(Row::absolute(what.clone(), off[2], 0.0, 1e-3));
            let left = if off[1] < 5e-5 { 0.0 } else { off[1] / off[0] };
            halving.push(Row::band(what, left, 0.5, -0.5, 0.1));
        }
        rows.push(worst(&format!("{table}, closed form: error"), closed));
        rows.push(worst(&format!("{table}, doublet lattice: error"), lattice));
        rows.push(worst(&format!("{table}, error left by doubling the boxes"), halving));
    }
    rows
}

/// Frequencies of the tables for the functions of time, closer where the wake's logarithm bends them.
const K: [f64; 26] = [
    0.001, 0.003, 0.006, 0.01, 0.016, 0.025, 0.04, 0.06, 0.09, 0.13, 0.18, 0.25, 0.35, 0.5, 0.7, 1.0, 1.4,
    1.9, 2.5, 3.2, 4.0, 4.8, 5.6, 6.4, 7.2, 8.0,
];

/// Garrick's integral (NACA TR 629, 1938): the answer to a step from the real part of that to oscillation,
/// `f(s) = h + 2/pi int_0^K (Re F - h) sin(k s)/k dk`, h the value that F comes to at high frequencies.
fn step_response(table: &MatrixSpline, which: usize, high: f64, s: f64) -> f64 {
    let (low, top) = table.range();
    let n = 8000;
    let value = |k: f64| {
        let at = if k < low {
            // from one at rest
            1.0 + (table.at(low).expect("a knot")[(which, 0)].re - 1.0) * k / low
        } else {
            table.at(k).expect("within the table")[(which, 0)].re
        };
        (at - high) * if k == 0.0 { s } else { (k * s).sin() / k }
    };
    let step = top / f64::from(n);
    let simpson: f64 = (0..=n)
        .map(|i| {
            let weight = if i == 0 || i == n { 1.0 } else { f64::from(2 + 2 * (i % 2)) };
            weight * value((step * f64::from(i)).min(top))
        })
        .sum();
    high + 2.0 / PI * simpson * step / 3.0
}

/// The case asks for 3 % from s = 2 on.
fn in_time(case: &Value) -> Vec<Row> {
    let column = |k: f64| {
        let [coarse, fine] = [8, 16].map(|n| functions(n, k));
        let at = |which: usize| fine[which] * 2.0 - coarse[which];
        // the gust's phase from mid-chord to the leading edge
        let gust = at(1) * c64::new(k.cos(), -k.sin());
        Mat::from_fn(2, 1, |row, _| if row == 0 { at(0) } else { gust })
    };
    let table = MatrixSpline::new(K.to_vec(), K.iter().map(|k| column(*k)).collect()).expect("rising");
    let function = |which: usize, list_name: &str, key: &str, high: f64| {
        let late = list(&case["expected"][list_name]).iter().filter(|row| number(&row["s"]) >= 2.0);
        let rows = late.map(|row| {
            let s = number(&row["s"]);
            Row::relative(format!("s = {s}"), step_response(&table, which, high, s), number(&row[key]), 0.03)
        });
        worst(list_name, rows.collect())
    };
    vec![function(0, "wagner", "phi", 0.5), function(1, "kussner", "psi", 0.0)]
}
