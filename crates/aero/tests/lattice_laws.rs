//! Laws the vortex lattice must obey whatever the wing: scaling, order, symmetry, surfaces in line.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use aero::{
    AeroBox, AeroError, DlmSettings, DoubletLattice, Lattice, MirrorPlane, SteadyAero, incidence, influence,
};
use faer::{Mat, c64};
use nalgebra::{Point3, Vector3};

const NONE: MirrorPlane = MirrorPlane::None;

/// A swept, tapered half wing with dihedral, from y = 0.05 to 1.8 m.
fn swept() -> Lattice {
    Lattice::trapezoid(1001, [0.0, 0.05, 0.0], 0.3, [0.69, 1.8, 0.2], 0.15, [4, 12]).unwrap()
}

fn solve(lattice: &Lattice, plane: MirrorPlane, w: &[f64]) -> Vec<f64> {
    SteadyAero::new(lattice, plane, 0.3).unwrap().pressures_of(w)
}

fn alpha(lattice: &Lattice) -> Vec<f64> {
    incidence::angle_of_attack(lattice)
}

/// Force over q of all boxes.
fn force(lattice: &Lattice, cp: &[f64]) -> Vector3<f64> {
    lattice.boxes.iter().zip(cp).map(|(panel, cp)| panel.normal() * (panel.area_m2() * cp)).sum()
}

fn assert_same(got: &[f64], want: &[f64], relative: f64) {
    assert_eq!(got.len(), want.len());
    let size = want.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
    for (i, (got, want)) in got.iter().zip(want).enumerate() {
        assert!((got - want).abs() <= relative * size, "{i}: {got} instead of {want}");
    }
}

#[test]
fn size_changes_nothing() {
    let wing = with_tail(0.0);
    let cp = solve(&wing, NONE, &alpha(&wing));
    for factor in [0.01, 37.0] {
        let small = wing.scaled(factor);
        assert_same(&solve(&small, NONE, &alpha(&small)), &cp, 1e-12);
    }
}

#[test]
fn a_wing_given_from_tip_to_root_carries_the_same() {
    let outwards = swept();
    let inwards = Lattice::trapezoid(1001, [0.69, 1.8, 0.2], 0.15, [0.0, 0.05, 0.0], 0.3, [4, 12]).unwrap();
    let plane = MirrorPlane::Symmetric { y_m: 0.0 };
    let (a, b) = (solve(&outwards, plane, &alpha(&outwards)), solve(&inwards, plane, &alpha(&inwards)));
    // The same box, strips counted from the other end, with the opposite normal and pressure.
    let reordered: Vec<f64> = b.chunks(4).rev().flatten().map(|cp| -cp).collect();
    assert_same(&reordered, &a, 1e-12);
    assert!((force(&inwards, &b) - force(&outwards, &a)).norm() < 1e-12 * force(&outwards, &a).norm());
}

#[test]
fn a_half_with_an_image_is_the_half_of_an_explicit_pair() {
    let right = swept();
    let (left, map) = right.mirrored(0.0);
    let pair = right.joined(&left.renumbered(5000).unwrap()).unwrap();
    let w: Vec<f64> = (0..right.len()).map(|j| 0.1 + (j as f64).sin()).collect();
    for (plane, sign) in
        [(MirrorPlane::Symmetric { y_m: 0.0 }, 1.0), (MirrorPlane::Antisymmetric { y_m: 0.0 }, -1.0)]
    {
        let half = solve(&right, plane, &w);
        let both: Vec<f64> = w.iter().copied().chain(map.carry(&w).iter().map(|w| sign * w)).collect();
        let cp = solve(&pair, NONE, &both);
        assert_same(&cp[..right.len()], &half, 1e-10);
        let image: Vec<f64> = cp[right.len()..].iter().map(|cp| sign * cp).collect();
        assert_same(&image, &map.carry(&half), 1e-10);
    }
}

#[test]
fn half_a_wing_carries_half_the_lift() {
    let right = Lattice::trapezoid(1, [0.0, 0.0, 0.0], 1.0, [1.0, 4.0, 0.0], 0.5, [3, 10]).unwrap();
    let pair = right.joined(&right.mirrored(0.0).0.renumbered(1000).unwrap()).unwrap();
    let half = force(&right, &solve(&right, MirrorPlane::Symmetric { y_m: 0.0 }, &alpha(&right)));
    let whole = force(&pair, &solve(&pair, NONE, &alpha(&pair)));
    assert!((2.0 * half.z - whole.z).abs() < 1e-12 * whole.z);
}

#[test]
fn a_plane_elsewhere_is_the_same_plane() {
    let right = swept();
    let mut moved = right.clone();
    for corner in moved.boxes.iter_mut().flat_map(|panel| panel.corners.iter_mut()) {
        corner.y += 2.5;
    }
    let here = solve(&right, MirrorPlane::Symmetric { y_m: 0.0 }, &alpha(&right));
    let there = solve(&moved, MirrorPlane::Symmetric { y_m: 2.5 }, &alpha(&moved));
    assert_same(&there, &here, 1e-11);
}

#[test]
fn a_flat_wing_along_the_stream_carries_nothing() {
    let lattice = swept();
    let cp = solve(&lattice, NONE, &vec![0.0; lattice.len()]);
    assert!(cp.iter().all(|cp| *cp == 0.0));
}

#[test]
fn mirroring_twice_gives_the_lattice_back() {
    let lattice = swept();
    let (image, map) = lattice.mirrored(0.0);
    assert_eq!(image.mirrored(0.0).0, lattice);
    assert_eq!(map.original, (0..lattice.len()).collect::<Vec<_>>());
    for (panel, original) in image.boxes.iter().zip(&lattice.boxes) {
        let (n, m) = (panel.normal(), original.normal());
        assert!((n - Vector3::new(m.x, -m.y, m.z)).norm() < 1e-14);
        assert!(n.z > 0.0);
    }
}

#[test]
fn a_box_that_meets_the_plane_is_refused_by_its_number() {
    let wing = Lattice::trapezoid(7001, [0.0, -0.5, 0.0], 1.0, [0.0, 2.0, 0.0], 1.0, [1, 5]).unwrap();
    let refusal = |y_m: f64| influence(&wing, MirrorPlane::Symmetric { y_m }, 0.0).unwrap_err();
    assert_eq!(refusal(0.2), AeroError::CrossesPlane { id: 7002, y_m: 0.2 });
    assert!(matches!(refusal(0.5), AeroError::BothSides { id: 7003, other: 7001, .. }));
    let fin = Lattice::trapezoid(1, [0.0, 0.0, 0.0], 1.0, [0.0, 0.0, 1.0], 1.0, [1, 2]).unwrap();
    let within = MirrorPlane::Antisymmetric { y_m: 0.0 }.refuse_within(&fin).unwrap_err();
    assert_eq!(within, AeroError::InPlane { id: 1, y_m: 0.0 });
}

/// A half with a fin in its plane is the whole aircraft: symmetric flow does not press the fin, whatever its incidence, and of antisymmetric flow it and
/// its image carry half each.
#[test]
fn a_fin_in_the_plane_of_a_half_is_that_of_the_whole() {
    let wing = Lattice::trapezoid(101, [0.0, 0.3, 0.1], 1.0, [0.6, 2.5, 0.4], 0.5, [2, 3]).unwrap();
    let fin = Lattice::trapezoid(1, [0.2, 0.0, 0.2], 1.0, [0.5, 0.0, 1.2], 0.6, [2, 2]).unwrap();
    let half = fin.joined(&wing).unwrap();
    let whole = half.joined(&wing.mirrored(0.0).0.renumbered(1000).unwrap()).unwrap();
    let (fins, wings) = (fin.len(), wing.len());
    for (plane, sign) in
        [(MirrorPlane::Symmetric { y_m: 0.0 }, 1.0), (MirrorPlane::Antisymmetric { y_m: 0.0 }, -1.0)]
    {
        let of_wing = |at: usize| 0.1 + 0.02 * at as f64;
        let of_fin = |at: usize| 0.05 - 0.01 * at as f64;
        let w_half: Vec<f64> = (0..fins).map(of_fin).chain((0..wings).map(of_wing)).collect();
        // The whole's fin sees the antisymmetric part of its incidence alone.
        let seen = (0..fins).map(|at| if sign < 0.0 { of_fin(at) } else { 0.0 });
        let w_whole: Vec<f64> =
            seen.chain((0..wings).map(of_wing)).chain((0..wings).map(|at| sign * of_wing(at))).collect();
        let of_half = SteadyAero::new(&half, plane, 0.3).unwrap().pressures_of(&w_half);
        let of_whole = SteadyAero::new(&whole, NONE, 0.3).unwrap().pressures_of(&w_whole);
        for at in 0..fins + wings {
            let share = if at < fins { 0.5 } else { 1.0 };
            assert!(
                (of_half[at] - share * of_whole[at]).abs() < 1e-10,
                "{at}: {} {}",
                of_half[at],
                of_whole[at]
            );
        }
        let settings = DlmSettings::default();
        let at = |lattice: &Lattice, plane, w: &[f64]| {
            let w = Mat::from_fn(w.len(), 1, |i, _| c64::from(w[i]));
            DoubletLattice::new(lattice, plane, 0.3, &settings)
                .unwrap()
                .at(0.8)
                .unwrap()
                .pressures(w.as_ref())
        };
        let (of_half, of_whole) = (at(&half, plane, &w_half), at(&whole, NONE, &w_whole));
        for at in 0..fins + wings {
            let share = if at < fins { 0.5 } else { 1.0 };
            assert!((of_half[(at, 0)] - of_whole[(at, 0)] * share).norm() < 1e-9, "{at}");
        }
    }
}

#[test]
fn mach_numbers_that_are_not_subsonic_are_refused() {
    for mach in [-0.1, 1.0, f64::NAN] {
        assert!(matches!(SteadyAero::new(&swept(), NONE, mach), Err(AeroError::Mach { .. })));
    }
    assert_eq!(influence(&Lattice::default(), NONE, 0.0), Err(AeroError::Empty));
}

#[test]
fn boxes_on_top_of_each_other_are_reported_as_singular() {
    let wing = swept();
    let double = wing.joined(&wing.renumbered(500).unwrap()).unwrap();
    assert!(matches!(SteadyAero::new(&double, NONE, 0.0), Err(AeroError::Singular { .. })));
}

/// A rectangular wing, 10 strips of 0.4 m, and in its plane a tail of 4 strips of 0.4 m, moved by `shift_m` along
/// y from where the middles of its strips lie behind strip edges of the wing.
fn with_tail(shift_m: f64) -> Lattice {
    let wing = Lattice::trapezoid(1, [0.0, -2.0, 0.0], 1.0, [0.0, 2.0, 0.0], 1.0, [4, 10]).unwrap();
    let ends = [-0.6 + shift_m, 1.0 + shift_m];
    let tail = Lattice::trapezoid(101, [3.0, ends[0], 0.0], 0.5, [3.0, ends[1], 0.0], 0.5, [3, 4]).unwrap();
    wing.joined(&tail).unwrap()
}

#[test]
fn a_tail_behind_strip_edges_of_the_wing_is_the_mean_of_its_neighbours() {
    let lift = |shift_m: f64| {
        let lattice = with_tail(shift_m);
        let matrix = influence(&lattice, NONE, 0.0).unwrap();
        for i in 40..lattice.len() {
            let row: f64 = (0..lattice.len()).map(|j| matrix[(i, j)].abs()).sum();
            assert!(row.is_finite() && row > 1.0, "row {i} sums to {row}");
        }
        let steady = SteadyAero::new(&lattice, NONE, 0.0).unwrap();
        let cp = steady.pressures_of(&alpha(&lattice));
        lattice.boxes.iter().zip(&cp).skip(40).map(|(panel, cp)| panel.area_m2() * cp).sum::<f64>()
    };
    // Outside the cores (1 % of the smaller box) the velocity is 1/distance, odd about the strip edge.
    let (aligned, left, right) = (lift(0.0), lift(-0.02), lift(0.02));
    assert!(aligned > 0.0 && aligned.is_finite());
    assert!((aligned - f64::midpoint(left, right)).abs() < 0.01 * aligned, "{left} {aligned} {right}");
    // Rounding of the geometry does not matter.
    assert!((lift(1e-9) - aligned).abs() < 1e-5 * aligned);
}

/// The strip-edge case has a smooth neighbour that no vortex touches: the tail a hair above the wing's wake.
#[test]
fn a_tail_in_the_plane_of_the_wing_is_the_limit_of_one_just_above() {
    let tail_lift = |z: f64| {
        let mut lattice = with_tail(0.0);
        for corner in lattice.boxes.iter_mut().skip(40).flat_map(|panel| panel.corners.iter_mut()) {
            corner.z += z;
        }
        let cp = solve(&lattice, NONE, &alpha(&lattice));
        force(&lattice, &[vec![0.0; 40], cp[40..].to_vec()].concat()).z
    };
    let in_plane = tail_lift(0.0);
    assert!((tail_lift(1e-3) - in_plane).abs() < 2e-3 * in_plane, "{} {in_plane}", tail_lift(1e-3));
}

#[test]
fn t_tails_and_crossing_fins_give_finite_symmetric_pressures() {
    let fin = Lattice::trapezoid(1, [0.0, 0.0, 0.0], 1.0, [0.5, 0.0, 2.0], 0.8, [3, 6]).unwrap();
    let plane = Lattice::trapezoid(101, [0.5, -1.5, 2.0], 0.8, [0.5, 1.5, 2.0], 0.8, [3, 6]).unwrap();
    let crossing = Lattice::trapezoid(201, [0.2, -1.0, 1.0], 0.6, [0.2, 1.0, 1.0], 0.6, [3, 4]).unwrap();
    let all = fin.joined(&plane).unwrap().joined(&crossing).unwrap();
    let cp = solve(&all, NONE, &alpha(&all));
    assert!(cp.iter().all(|cp| cp.is_finite()));
    let pull = force(&all, &cp);
    // A symmetric arrangement in symmetric flow: no side force, and nothing on the fin.
    assert!(pull.y.abs() < 1e-10 * pull.z, "{pull}");
    assert!(cp[..18].iter().all(|cp| cp.abs() < 1e-10));
}

#[test]
fn incidence_columns_have_the_signs_of_flight_mechanics() {
    let wing = swept();
    let about = Point3::new(0.1, 0.0, 0.0);
    let right = wing.len() - 1;
    assert!(incidence::angle_of_attack(&wing)[right] > 0.0);
    // Wind from the right lifts a right wing with dihedral.
    assert!(incidence::sideslip(&wing)[right] > 0.0);
    // Nose-up rotation sinks what is aft of the axis: more incidence there.
    let pitch = incidence::pitch_rate(&wing, 0.1, 20.0);
    let aft = wing.boxes[right].three_quarter_point();
    let n = wing.boxes[right].normal();
    assert!((pitch[right] - ((aft.x - 0.1) * n.z - aft.z * n.x) / 20.0).abs() < 1e-15);
    // Right wing down: more incidence on the right.
    assert!(incidence::rotation_rate(&wing, &-Vector3::x(), &about, 20.0)[right] > 0.0);
}

#[test]
fn the_points_of_a_box_are_those_of_its_mean_edges() {
    let corner = |x, y| Point3::new(x, y, 0.0);
    let panel =
        AeroBox { id: 1, corners: [corner(0.0, 0.0), corner(2.0, 0.0), corner(1.5, 1.0), corner(0.5, 1.0)] };
    assert_eq!((panel.chord_m(), panel.width_m(), panel.area_m2()), (1.5, 1.0, 1.5));
    assert_eq!(panel.quarter_point(), corner(0.625, 0.5));
    assert_eq!(panel.mid_point(), corner(1.0, 0.5));
    assert_eq!(panel.three_quarter_point(), corner(1.375, 0.5));
    assert_eq!(panel.bound_vortex(), [corner(0.5, 0.0), corner(0.75, 1.0)]);
    assert_eq!((panel.normal(), panel.pitch_axis()), (Vector3::z(), Vector3::y()));
}
