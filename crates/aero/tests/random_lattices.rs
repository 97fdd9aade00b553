//! Laws of any lattice, on wings and tails drawn at random: the place, size and roll of a frame mean nothing, and neither does
//! the side of a mirror; air that can be pressed together is a stretched wing in air that cannot (Prandtl, Glauert, Göthert).

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use aero::{DlmSettings, Lattice, MirrorPlane, influence, oscillatory};
use faer::{Mat, c64};
use nalgebra::{Point3, Rotation3, Vector3};
use proptest::prelude::*;

const NONE: MirrorPlane = MirrorPlane::None;

/// A trapezoid: leading edge inboard, chord there, span, sweep and rise over the span, taper; 3 by 4 boxes.
fn trapezoid(id: u32, place: [f64; 3], [chord, span, sweep, rise, taper]: [f64; 5]) -> Lattice {
    let tip = [place[0] + sweep * span, place[1] + span, place[2] + rise * span];
    Lattice::trapezoid(id, place, chord, tip, chord * taper, [3, 4]).unwrap()
}

fn shapes() -> impl Strategy<Value = [f64; 5]> {
    (0.1..1.0, 0.5..3.0, -0.7..1.0, -0.8..0.8, 0.3..1.0).prop_map(|(a, b, c, d, e)| [a, b, c, d, e])
}

/// A wing to the right of y = 0 and a tail behind and above it, whose strips are not in line with the wing's.
fn lattices() -> impl Strategy<Value = Lattice> {
    (shapes(), shapes(), 0.05..0.4_f64, 0.3..1.0_f64).prop_map(|(wing, tail, side, height)| {
        let behind = wing[0] + wing[1].max(0.0) * 1.1 + 1.0;
        let tail = trapezoid(1001, [behind + 3.0, side * 1.37, 3.0 + height], tail);
        trapezoid(1, [0.0, side, 0.0], wing).joined(&tail).unwrap()
    })
}

fn moved(lattice: &Lattice, by: impl Fn(&Point3<f64>) -> Point3<f64>) -> Lattice {
    let mut other = lattice.clone();
    for corner in other.boxes.iter_mut().flat_map(|panel| panel.corners.iter_mut()) {
        *corner = by(corner);
    }
    other
}

fn steady(lattice: &Lattice, mach: f64) -> Mat<f64> {
    influence(lattice, NONE, mach).unwrap()
}

fn unsteady(lattice: &Lattice, kappa: f64) -> Mat<c64> {
    oscillatory(lattice, NONE, 0.4, kappa, &DlmSettings::default()).unwrap()
}

/// How far matrices are apart, in parts of the greater one's largest element.
fn apart<T: faer::traits::ComplexField>(a: &Mat<T>, b: &Mat<T>) -> f64
where
    T::Real: Into<f64>,
{
    (a - b).norm_max().into() / b.norm_max().into()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_frame_means_nothing(
        lattice in lattices(),
        by in (-5.0..5.0, -5.0..5.0, -5.0..5.0),
        roll in -3.0..3.0_f64,
        size in 0.05..20.0_f64,
    ) {
        let turn = Rotation3::from_axis_angle(&Vector3::x_axis(), roll);
        let there = moved(&lattice, |p| (turn * p + Vector3::new(by.0, by.1, by.2)) * size);
        prop_assert!(apart(&steady(&there, 0.5), &steady(&lattice, 0.5)) < 1e-9);
        let kappa = 1.5;
        prop_assert!(apart(&unsteady(&there, kappa / size), &unsteady(&lattice, kappa)) < 1e-7);
    }

    #[test]
    fn a_mirror_image_has_the_influence_of_the_original(lattice in lattices()) {
        let (image, map) = lattice.mirrored(0.0);
        let n = lattice.len();
        let indices: Vec<usize> = (0..n).collect();
        let from = map.carry(&indices);
        let in_order = |matrix: &Mat<f64>| Mat::from_fn(n, n, |i, j| matrix[(from[i], from[j])]);
        prop_assert!(apart(&steady(&image, 0.3), &in_order(&steady(&lattice, 0.3))) < 1e-10);
        let own = unsteady(&lattice, 2.0);
        let ordered = Mat::from_fn(n, n, |i, j| own[(from[i], from[j])]);
        prop_assert!(apart(&unsteady(&image, 2.0), &ordered) < 1e-8);
    }

    #[test]
    fn a_subsonic_wing_is_a_stretched_one_without_mach_number(lattice in lattices(), mach in 0.05..0.85_f64) {
        // cp = cp0 / beta at the same incidence, on x / beta: Göthert's rule for small disturbances
        let beta = (1.0 - mach * mach).sqrt();
        let stretched = moved(&lattice, |p| Point3::new(p.x / beta, p.y, p.z));
        let scaled = steady(&stretched, 0.0) * faer::Scale(beta);
        prop_assert!(apart(&steady(&lattice, mach), &scaled) < 1e-9);
    }
}
