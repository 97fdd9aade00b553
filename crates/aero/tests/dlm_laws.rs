//! Laws the doublet lattice must obey whatever the wing: size, direction, symmetry, surfaces in line, threads.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use aero::{AeroBox, AeroError, DlmSettings, DoubletLattice, KernelIntegral, Lattice, MirrorPlane, SpanFit};
use aero::{influence, oscillatory};
use faer::{Mat, c64};
use nalgebra::Point3;
use std::sync::Arc;

const NONE: MirrorPlane = MirrorPlane::None;
const WALL: MirrorPlane = MirrorPlane::Symmetric { y_m: 0.0 };
const MACH: f64 = 0.4;
/// omega/V, 1/m: k = 0.6 with a chord of 0.3 m.
const KAPPA: f64 = 4.0;

/// A swept, tapered half wing with dihedral, from y = 0.05 to 1.8 m.
fn swept() -> Lattice {
    Lattice::trapezoid(1001, [0.0, 0.05, 0.0], 0.3, [0.69, 1.8, 0.2], 0.15, [4, 12]).unwrap()
}

/// A flat wing of ten strips and, behind it, a tail whose middles of strips lie behind edges of the wing's strips.
fn with_tail(shift_m: f64, z_m: f64) -> Lattice {
    let wing = Lattice::trapezoid(1, [0.0, -2.5, 0.0], 1.0, [0.0, 2.5, 0.0], 1.0, [4, 10]).unwrap();
    let tail = [[3.0, -0.75 + shift_m, z_m], [3.0, 0.75 + shift_m, z_m]];
    wing.joined(&Lattice::trapezoid(1001, tail[0], 0.6, tail[1], 0.6, [3, 3]).unwrap()).unwrap()
}

fn matrix(lattice: &Lattice, plane: MirrorPlane, kappa: f64) -> Mat<c64> {
    oscillatory(lattice, plane, MACH, kappa, &DlmSettings::default()).unwrap()
}

/// Pressures for incidence and a gust.
fn pressures(lattice: &Lattice, plane: MirrorPlane, kappa: f64) -> Mat<c64> {
    let aero = DoubletLattice::new(lattice, plane, MACH, &DlmSettings::default()).unwrap().at(kappa).unwrap();
    aero.pressures(incidences(lattice, kappa).as_ref())
}

fn incidences(lattice: &Lattice, kappa: f64) -> Mat<c64> {
    Mat::from_fn(lattice.len(), 2, |i, column| {
        let phase = if column == 0 { 0.0 } else { -kappa * lattice.boxes[i].three_quarter_point().x };
        c64::new(phase.cos(), phase.sin()) * lattice.boxes[i].normal().z
    })
}

fn assert_same(got: &Mat<c64>, want: &Mat<c64>, relative: f64) {
    assert_eq!((got.nrows(), got.ncols()), (want.nrows(), want.ncols()));
    let off = (got - want).norm_max() / want.norm_max();
    assert!(off <= relative, "off by {off:.2e}");
}

#[test]
fn size_changes_nothing() {
    for lattice in [swept(), with_tail(0.0, 0.0), with_tail(0.1, 0.3)] {
        let want = matrix(&lattice, NONE, KAPPA);
        for factor in [0.001, 0.2, 37.0] {
            assert_same(&matrix(&lattice.scaled(factor), NONE, KAPPA / factor), &want, 1e-10);
        }
    }
}

#[test]
fn a_wing_given_from_tip_to_root_carries_the_same() {
    let outwards = swept();
    let inwards = Lattice::trapezoid(1001, [0.69, 1.8, 0.2], 0.15, [0.0, 0.05, 0.0], 0.3, [4, 12]).unwrap();
    for plane in [NONE, WALL] {
        let (a, b) = (pressures(&outwards, plane, KAPPA), pressures(&inwards, plane, KAPPA));
        // The same box, strips counted from the other end, with the opposite normal and pressure.
        let reordered = Mat::from_fn(48, 2, |i, column| -b[((11 - i / 4) * 4 + i % 4, column)]);
        assert_same(&reordered, &a, 1e-12);
    }
}

#[test]
fn a_half_with_an_image_is_the_half_of_an_explicit_pair() {
    let right = swept();
    let pair = right.joined(&right.mirrored(0.0).0.renumbered(1000).unwrap()).unwrap();
    let n = right.len();
    let whole = explicit(&pair);
    for (plane, sign) in [(WALL, 1.0), (MirrorPlane::Antisymmetric { y_m: 0.0 }, -1.0)] {
        let half = pressures(&right, plane, KAPPA);
        let w = incidences(&right, KAPPA);
        let both = Mat::from_fn(2 * n, 2, |i, c| if i < n { w[(i, c)] } else { w[(i - n, c)] * sign });
        let cp = faer::linalg::solvers::Solve::solve(&whole.partial_piv_lu(), both);
        assert_same(&cp.submatrix(0, 0, n, 2).to_owned(), &half, 1e-12);
    }
    for y_m in [0.0, -0.3] {
        let plane = MirrorPlane::Symmetric { y_m };
        let image = right.mirrored(y_m).0.renumbered(1000).unwrap();
        let all = explicit(&right.joined(&image).unwrap());
        let folded = Mat::from_fn(n, n, |i, j| all[(i, j)] + all[(i, n + j)]);
        assert_same(&matrix(&right, plane, KAPPA), &folded, 1e-12);
    }
}

/// The matrix of a lattice box by box: a hair of asymmetry, far below round-off of the result, keeps it whole.
fn explicit(lattice: &Lattice) -> Mat<c64> {
    let far = Lattice::trapezoid(900_001, [0.0, 1e7, 0.0], 0.1, [0.0, 1e7 + 0.1, 0.0], 0.1, [1, 1]).unwrap();
    let all = matrix(&lattice.joined(&far).unwrap(), NONE, KAPPA);
    all.submatrix(0, 0, lattice.len(), lattice.len()).to_owned()
}

/// Wing and tail with a fin in the plane of symmetry, halves in any order and direction.
fn aircraft(left_from_tip: bool) -> Lattice {
    let right = swept();
    let left = if left_from_tip {
        right.mirrored(0.0).0.renumbered(1000).unwrap()
    } else {
        Lattice::trapezoid(2001, [0.0, -0.05, 0.0], 0.3, [0.69, -1.8, 0.2], 0.15, [4, 12]).unwrap()
    };
    let fin = Lattice::trapezoid(3001, [1.2, 0.0, 0.1], 0.3, [1.4, 0.0, 0.6], 0.2, [3, 4]).unwrap();
    let tail = Lattice::trapezoid(4001, [1.4, -0.5, 0.6], 0.2, [1.4, 0.5, 0.6], 0.2, [3, 6]).unwrap();
    left.joined(&fin).unwrap().joined(&right).unwrap().joined(&tail).unwrap()
}

#[test]
fn a_symmetric_lattice_solved_in_halves_is_the_same_as_solved_whole() {
    for left_from_tip in [true, false] {
        let lattice = aircraft(left_from_tip);
        let whole = explicit(&lattice);
        assert_same(&matrix(&lattice, NONE, KAPPA), &whole, 1e-12);
        // Incidences of no symmetry, on the fin as well.
        let w = Mat::from_fn(lattice.len(), 3, |i, j| c64::new((i * (j + 1)) as f64 % 7.0, (i as f64).sin()));
        let aero =
            DoubletLattice::new(&lattice, NONE, MACH, &DlmSettings::default()).unwrap().at(KAPPA).unwrap();
        let want = faer::linalg::solvers::Solve::solve(&whole.partial_piv_lu(), &w);
        assert_same(&aero.pressures(w.as_ref()), &want, 1e-11);
    }
}

#[test]
fn a_tail_behind_strip_edges_of_the_wing_is_the_mean_of_its_neighbours() {
    let lift = |shift_m: f64| {
        let lattice = with_tail(shift_m, 0.0);
        let increment = &matrix(&lattice, NONE, KAPPA) - &matrix(&lattice, NONE, 0.0);
        for i in 40..lattice.len() {
            let row: f64 = (0..lattice.len()).map(|j| increment[(i, j)].norm()).sum();
            assert!(row.is_finite() && row > 0.1, "row {i} sums to {row}");
        }
        let cp = pressures(&lattice, NONE, KAPPA);
        (40..lattice.len()).map(|i| cp[(i, 0)] * lattice.boxes[i].area_m2()).sum::<c64>()
    };
    let (aligned, left, right) = (lift(0.0), lift(-0.01), lift(0.01));
    assert!((aligned - (left + right) * 0.5).norm() < 0.01 * aligned.norm(), "{left} {aligned} {right}");
    // Rounding of the geometry does not matter.
    assert!((lift(1e-9) - aligned).norm() < 1e-5 * aligned.norm());
}

#[test]
fn a_tail_in_the_plane_of_the_wing_is_the_limit_of_one_just_above() {
    let lift = |z_m: f64| {
        let lattice = with_tail(0.1, z_m);
        let cp = pressures(&lattice, NONE, KAPPA);
        (40..lattice.len()).map(|i| cp[(i, 0)] * lattice.boxes[i].area_m2()).sum::<c64>()
    };
    let (plane, above) = (lift(0.0), lift(0.01));
    assert!((above - plane).norm() < 0.02 * plane.norm(), "{plane} {above}");
}

#[test]
fn without_oscillation_there_is_the_vortex_lattice_and_nearby_little_else() {
    for lattice in [swept(), aircraft(true)] {
        let steady = influence(&lattice, NONE, MACH).unwrap();
        let steady = Mat::from_fn(lattice.len(), lattice.len(), |i, j| c64::from(steady[(i, j)]));
        assert_same(&matrix(&lattice, NONE, 0.0), &steady, 1e-13);
        assert_same(&matrix(&lattice, NONE, 1e-6), &steady, 1e-5);
    }
}

#[test]
fn sides_that_are_not_along_the_stream_give_the_same_as_strips() {
    // A millionth of a millionth of skew, and every box is a strip of its own.
    let mut skewed = swept();
    for panel in &mut skewed.boxes {
        panel.corners[1].y += 1e-12;
    }
    assert_same(&matrix(&skewed, WALL, KAPPA), &matrix(&swept(), WALL, KAPPA), 1e-9);
}

#[test]
fn the_number_of_threads_changes_nothing() {
    let lattice = aircraft(true);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| matrix(&lattice, NONE, KAPPA))
    };
    assert_eq!(on(1), on(3));
}

#[test]
fn better_integrals_and_fits_agree_where_all_are_good() {
    let matrices =
        [KernelIntegral::Desmarais, KernelIntegral::Fine, KernelIntegral::Laschka].map(|integral| {
            let settings = DlmSettings { integral, fit: SpanFit::Quartic };
            oscillatory(&swept(), WALL, MACH, KAPPA, &settings).unwrap()
        });
    assert_same(&matrices[0], &matrices[1], 1e-4);
    assert_same(&matrices[2], &matrices[1], 5e-3);
}

#[test]
fn factors_that_are_kept_are_solved_once_and_change_no_bit() {
    let fresh = DoubletLattice::new(&swept(), WALL, MACH, &DlmSettings::default()).unwrap();
    let keeping = fresh.clone().keeping_factors();
    let first = keeping.at(KAPPA).unwrap();
    assert!(Arc::ptr_eq(&first, &keeping.clone().at(KAPPA).unwrap()), "a copy knows them");
    assert!(!Arc::ptr_eq(&first, &keeping.clone().without_kept_factors().at(KAPPA).unwrap()));
    for kappa in [KAPPA, 0.5 * KAPPA] {
        let w = incidences(&swept(), kappa);
        let [kept, solved] =
            [&keeping, &fresh].map(|lattice| lattice.at(kappa).unwrap().pressures(w.as_ref()));
        assert_eq!(kept, solved, "{kappa}");
    }
    assert!(keeping.at(-1.0).is_err() && keeping.at(f64::NAN).is_err());
}

#[test]
fn what_cannot_be_computed_is_refused() {
    let at = |kappa: f64, mach: f64| oscillatory(&swept(), NONE, mach, kappa, &DlmSettings::default());
    for kappa in [-0.1, f64::NAN, f64::INFINITY] {
        assert!(matches!(at(kappa, 0.0), Err(AeroError::Frequency { .. })));
    }
    assert_eq!(at(1.0, 1.2), Err(AeroError::Mach { mach: 1.2 }));
    assert_eq!(matrix_error(&Lattice::default()), AeroError::Empty);
    // Sides that are not along the stream can leave a box no width across it.
    let corner = |x: f64, y: f64| Point3::new(x, y, 0.0);
    let corners = [corner(0.0, 0.0), corner(1.0, 1.0), corner(2.0, 1.0), corner(1.0, 0.0)];
    let thin = Lattice::from_corners("thin", 1, vec![AeroBox { id: 7, corners }]).unwrap();
    assert_eq!(matrix_error(&thin), AeroError::NoWidth { id: 7 });
    let double = swept().joined(&swept().renumbered(500).unwrap()).unwrap();
    let aero = DoubletLattice::new(&double, NONE, MACH, &DlmSettings::default()).unwrap();
    assert!(matches!(aero.at(KAPPA), Err(AeroError::Singular { .. })));
}

fn matrix_error(lattice: &Lattice) -> AeroError {
    oscillatory(lattice, NONE, 0.0, 1.0, &DlmSettings::default()).unwrap_err()
}
