//! Strip theory from the doublet lattice: sections of a wing so long that it has no ends, beside Theodorsen's and Sears'
//! functions (data/published/unsteady2d__theodorsen.json).
//!
//! All strips of an endless wing carry the same, so the influences of all strips on the middle one are summed, and the
//! section's few pressures solved for. The strips widen outwards, to 2000 chords; the innermost are two boxes' chords wide.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use aero::{AeroBox, DlmSettings, DoubletLattice, KernelIntegral, Lattice, MirrorPlane, SpanFit};
use faer::linalg::solvers::Solve;
use faer::{Mat, c64};
use nalgebra::Point3;
use std::f64::consts::PI;
use validation::{list, number, published};

const SETTINGS: DlmSettings = DlmSettings { integral: KernelIntegral::Fine, fit: SpanFit::Quartic };

/// Half of the endless wing, chord 2, `n` boxes along it.
fn endless(n: u32) -> Lattice {
    let mut edges = vec![0.0];
    let mut width = 4.0 / f64::from(n);
    while *edges.last().unwrap() < 4000.0 {
        edges.push(edges.last().unwrap() + width);
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
    Lattice::from_corners("endless", usize::try_from(n).unwrap(), boxes).unwrap()
}

/// Lift coefficients of a section of chord 2 (so that omega/V is k) with `n` boxes for columns of incidence by x.
fn section(n: u32, k: f64, w: impl Fn(f64, usize) -> c64) -> [c64; 2] {
    let lattice = endless(n);
    let plane = MirrorPlane::Symmetric { y_m: 0.0 };
    let all = DoubletLattice::new(&lattice, plane, 0.0, &SETTINGS).unwrap().influence(k).unwrap();
    let n = usize::try_from(n).unwrap();
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

/// The case's 1e-10 is that of its table; a lattice comes to it with the number of boxes. Its error halves when they are
/// doubled, so twice the finer result less the coarser is better than both: within 1e-3 up to k = 2.
#[test]
fn unsteady2d_theodorsen() {
    let case = published("unsteady2d__theodorsen");
    let mut rows = 0;
    for (which, table, names) in [(0, "C", ["F", "G"]), (1, "sears_midchord", ["re", "im"])] {
        for row in list(&case["expected"][table]) {
            let (k, want) = (number(&row["k"]), c64::new(number(&row[names[0]]), number(&row[names[1]])));
            if k > 2.0 {
                continue;
            }
            rows += 1;
            let [coarse, fine] = [16, 32].map(|n| functions(n, k)[which]);
            let off = [coarse, fine, fine * 2.0 - coarse].map(|value| (value - want).norm());
            println!("{table} k {k}: {off:?}");
            // At k = 0.001 the wave is as long as the wing: its ends show, by 5e-5.
            assert!(off[1] < 0.6 * off[0] || off[1] < 5e-5, "{table} k {k}: {off:?}");
            assert!(off[2] < 1e-3, "{table} k {k}: {off:?}");
        }
    }
    assert_eq!(rows, 30);
}
