//! Strip theory from the doublet lattice: sections of a wing so long that it has no ends, beside Theodorsen's and Sears'
//! functions (data/published/unsteady2d__theodorsen.json).
//!
//! All strips of an endless wing carry the same, so the influences of all strips on the middle one are summed, and the
//! section's few pressures solved for. The strips widen outwards, to 2000 chords; the innermost are two boxes' chords wide.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

mod wings;

use aero::{DlmSettings, DoubletLattice, KernelIntegral, SpanFit};
use faer::linalg::solvers::Solve;
use faer::{Mat, c64};
use std::f64::consts::PI;
use validation::{list, number, published};
use wings::{Planform, WALL, uniform};

const SETTINGS: DlmSettings = DlmSettings { integral: KernelIntegral::Fine, fit: SpanFit::Quartic };

/// Lift coefficients of a section of chord 2 (so that omega/V is k) with `n` boxes for columns of incidence by x.
fn section(n: u32, k: f64, w: impl Fn(f64, usize) -> c64) -> [c64; 2] {
    let mut edges = vec![0.0];
    let mut width = 4.0 / f64::from(n);
    while edges.last().unwrap() < &4000.0 {
        edges.push(edges.last().unwrap() + width);
        width *= 1.6;
    }
    let semispan = *edges.last().unwrap();
    let eta: Vec<f64> = edges.iter().map(|y| y / semispan).collect();
    let wing = Planform { semispan, root: 2.0, tip: 2.0, tip_x: 0.0 };
    let lattice = wing.lattice(&eta, &uniform(n));
    let all = DoubletLattice::new(&lattice, WALL, 0.0, &SETTINGS).unwrap().influence(k).unwrap();
    let n = usize::try_from(n).unwrap();
    let section = Mat::from_fn(n, n, |i, j| (0..lattice.len() / n).map(|s| all[(i, s * n + j)]).sum::<c64>());
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
