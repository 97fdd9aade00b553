//! Small parts by hand: rows of loads, bent boxes, strips, divergence of a loop, structures given as numbers.

use aero::{AeroBox, Lattice};
use coupling::divergence::lowest_pressure;
use coupling::shape::deformed_boxes;
use coupling::{
    Balance, ByLoad, CorrectableBoxes, Load, RootLoads, Spline, SupportedStructure, root_rows, station_rows,
    strip_rows,
};
use faer::{Mat, c64};
use nalgebra::{Point3, Vector3};

/// Two by three boxes of 0.5 m chord and 1 m width, from x = 1, y = 2, z = 0.5, flat.
fn flat() -> Lattice {
    Lattice::trapezoid(101, [1.0, 2.0, 0.5], 1.0, [1.0, 5.0, 0.5], 1.0, [2, 3]).expect("boxes")
}

fn boxes_of(lattice: &Lattice) -> CorrectableBoxes {
    let count = lattice.len();
    CorrectableBoxes {
        places: (0..count).collect(),
        chord_row: (0..count).map(|b| b % 2).collect(),
        chord_rows: vec![2; count],
        strip: (0..count).map(|b| b / 2).collect(),
        y_norm: (0..count).map(|b| ((b / 2) as f64 + 0.5) / 3.0).collect(),
        area_share: vec![1.0 / 6.0; count],
        area_m2: 3.0,
        ends_m: [2.0, 5.0],
    }
}

#[test]
fn rows_weigh_a_box_by_its_arm_about_the_point() {
    let lattice = flat();
    let balance =
        Balance { point: Point3::new(0.5, 1.0, 0.0), metric: vec![true, true, true, false, true, true] };
    let rows = root_rows(&lattice, &balance);
    let station = station_rows(&lattice, &balance, &Point3::new(0.25, 3.5, 0.0));
    for j in 0..6 {
        let (x, y) = (1.25 + 0.5 * (j % 2) as f64, 2.5 + (j / 2) as f64);
        let counts = f64::from(u8::from(j != 3));
        // up by 1 N at the middle: Mx = y Fz, My = -x Fz; a moment of 1 Nm nose up
        let expected = [counts, counts * (y - 1.0), -counts * (x - 0.5)];
        // y = 3.5 is not outboard of 3.5
        let outboard = f64::from(u8::from(j > 3));
        let beyond = [outboard, outboard * (y - 3.5), -outboard * (x - 0.25)];
        for row in 0..3 {
            assert!((rows[(row, 2 * j)] - expected[row]).abs() < 1e-12, "box {j} row {row}");
            assert!((station[(row, 2 * j)] - beyond[row]).abs() < 1e-12, "box {j} row {row}");
            let moment = |all: f64| if row == 2 { all } else { 0.0 };
            assert!((rows[(row, 2 * j + 1)] - moment(counts)).abs() < 1e-12);
            assert!((station[(row, 2 * j + 1)] - moment(outboard)).abs() < 1e-12);
        }
    }
}

#[test]
fn rows_of_a_slanted_box_take_the_part_of_its_normal() {
    let lattice = Lattice::trapezoid(1, [0.0, 0.0, 0.0], 1.0, [0.0, 3.0, 4.0], 1.0, [1, 1]).expect("a box");
    let balance = Balance { point: Point3::origin(), metric: vec![true] };
    let rows = root_rows(&lattice, &balance);
    // normal (0, -4, 3)/5 at (0.5, 1.5, 2): moment r x n = (y n_z - z n_y, z n_x - x n_z, ..)
    let expected = [0.6, 1.5 * 0.6 + 2.0 * 0.8, -0.5 * 0.6];
    (0..3).for_each(|row| assert!((rows[(row, 0)] - expected[row]).abs() < 1e-12, "{row}"));
    assert!((rows[(2, 1)] - 0.6).abs() < 1e-12 && rows[(0, 1)] == 0.0 && rows[(1, 1)] == 0.0);
    let boxes = CorrectableBoxes {
        places: vec![0],
        chord_row: vec![0],
        chord_rows: vec![1],
        strip: vec![0],
        y_norm: vec![0.5],
        area_share: vec![1.0],
        area_m2: 5.0,
        ends_m: [0.0, 3.0],
    };
    let per_metre = strip_rows(&lattice, &boxes);
    assert!((per_metre[(0, 0)] - 0.6 / lattice.boxes[0].width_m()).abs() < 1e-12);
}

#[test]
fn lift_of_a_strip_is_that_of_its_boxes_over_its_width() {
    let lattice = Lattice::trapezoid(1, [0.0; 3], 1.0, [0.0, 6.0, 0.0], 1.0, [2, 3]).expect("boxes");
    let mut boxes = boxes_of(&lattice);
    let rows = strip_rows(&lattice, &boxes);
    assert_eq!((rows.nrows(), rows.ncols()), (3, 12));
    for strip in 0..3 {
        for column in 0..12 {
            let own = column % 2 == 0 && column / 4 == strip;
            let expected = if own { 0.5 } else { 0.0 };
            assert!((rows[(strip, column)] - expected).abs() < 1e-12, "{strip} {column}");
        }
    }
    // boxes that are not corrected are in no strip
    boxes.places.truncate(4);
    boxes.strip.truncate(4);
    assert_eq!(strip_rows(&lattice, &boxes).nrows(), 2);
    boxes.strip.clear();
    boxes.places.clear();
    assert!(strip_rows(&lattice, &boxes).nrows() == 0 && boxes.is_empty());
}

#[test]
fn between_the_middles_of_two_strips_their_shares_are_by_distance() {
    let boxes = boxes_of(&flat());
    // middles at 1/6, 1/2, 5/6; first boxes 0, 2, 4
    let at = |y: f64| -> Vec<(usize, f64)> {
        boxes.strips_at(y).into_iter().filter(|(_, share)| *share > 1e-12).collect()
    };
    for (y, expected) in [
        (0.0, vec![(0, 1.0)]),
        (1.0, vec![(4, 1.0)]),
        (0.25, vec![(0, 0.75), (2, 0.25)]),
        (0.75, vec![(2, 0.25), (4, 0.75)]),
        (0.5, vec![(2, 1.0)]),
    ] {
        let found = at(y);
        assert_eq!(found.len(), expected.len(), "{y}: {found:?}");
        for (a, b) in found.iter().zip(&expected) {
            assert!(a.0 == b.0 && (a.1 - b.1).abs() < 1e-12, "{y}: {found:?}");
        }
    }
    assert_eq!(boxes.len(), 6);
    assert!(!boxes.is_empty());
    assert!((boxes.span_m() - 3.0).abs() < 1e-15 && (boxes.mean_chord_m() - 1.0).abs() < 1e-15);
    let mut one = boxes_of(&flat());
    one.places.truncate(2);
    for y in [0.0, 1.0 / 6.0, 1.0] {
        let shares: f64 = one.strips_at(y).iter().map(|(first, share)| share * (1.0 + *first as f64)).sum();
        assert!((shares - 1.0).abs() < 1e-12);
    }
}

#[test]
fn a_loop_diverges_at_one_over_its_largest_real_positive_gain() {
    let of = |values: &[(f64, f64)]| {
        lowest_pressure(&values.iter().map(|(re, im)| c64::new(*re, *im)).collect::<Vec<_>>())
    };
    let about = |found: Option<f64>, expected: f64| {
        assert!(found.is_some_and(|q| (q / expected - 1.0).abs() < 1e-12), "{found:?} {expected}");
    };
    about(of(&[(0.02, 0.0), (0.05, 0.0), (-0.5, 0.0)]), 20.0);
    // swinging pairs and gains that are round-off beside the rest close no loop
    about(of(&[(0.02, 0.0), (0.9, 0.3), (0.9, -0.3)]), 50.0);
    about(of(&[(0.02, 1e-13)]), 50.0);
    assert_eq!(of(&[(-0.5, 0.0), (1e-12, 0.0)]), None);
    assert_eq!(of(&[(-0.5, 0.0)]), None);
    assert_eq!(of(&[]), None);
}

#[test]
fn loads_keep_their_order_and_names() {
    let mut loads = ByLoad::from_array([1.0, 2.0, 3.0]);
    assert_eq!((loads[Load::Fz], loads[Load::Mx], loads[Load::My]), (1.0, 2.0, 3.0));
    loads[Load::Fz] = 4.0;
    loads[Load::Mx] += 3.0;
    loads[Load::My] *= 2.0;
    assert_eq!(loads.to_array(), [4.0, 5.0, 6.0]);
    assert_eq!(loads.iter().copied().collect::<Vec<_>>(), [4.0, 5.0, 6.0]);
    assert_eq!(loads.map(|value| value + 1.0).to_array(), [5.0, 6.0, 7.0]);
    assert_eq!(ByLoad::from_fn(Load::column).to_array(), ["Fz_N", "Mx_Nm", "My_Nm"]);
    let (a, b) = (RootLoads::from_array([1.0, 2.0, 3.0]), RootLoads { fz_n: 10.0, mx_nm: 30.0, my_nm: 50.0 });
    assert_eq!((a + b).to_array(), [11.0, 32.0, 53.0]);
    assert_eq!((a - b).to_array(), [-9.0, -28.0, -47.0]);
    assert_eq!(ByLoad::from(b).to_array(), [10.0, 30.0, 50.0]);
}

/// One node that carries all boxes.
fn carried(lattice: &Lattice, node: Point3<f64>) -> (Spline, SupportedStructure) {
    let spline = Spline::nearest_node(lattice, &[Point3::origin(), node], &[1]);
    let dofs: Vec<usize> = (6..12).collect();
    let size = dofs.len();
    let held = SupportedStructure::from_parts(
        dofs,
        Mat::from_fn(size, size, |i, j| f64::from(u8::from(i == j))),
        Mat::zeros(size, 3),
        Mat::zeros(3, 3),
        &spline,
        1,
    );
    (spline, held.expect("all degrees of freedom are there"))
}

/// Heave, pitch and roll of all boxes on one node leave a plane, at every corner of inner and outer boxes alike.
#[test]
fn boxes_that_move_as_one_stay_a_plane() {
    let lattice = flat();
    let (_, held) = carried(&lattice, Point3::new(1.5, 3.0, 0.5));
    assert_eq!(held.tip_z, 2);
    let (rise, roll, pitch) = (0.1, 0.02, 0.03);
    let motion = [0.0, 0.0, rise, 0.0, pitch, 0.0];
    let deformed = deformed_boxes(&lattice, &held, &motion);
    assert_eq!(deformed.len(), 6);
    for (panel, corners) in lattice.boxes.iter().zip(&deformed) {
        for (before, after) in panel.corners.iter().zip(corners) {
            let expected = rise - pitch * (before.x - 1.5);
            let moved = after - before;
            assert!((moved - Vector3::z() * expected).norm() < 1e-12, "{before}: {moved}");
        }
    }
    // rolling, boxes rise as their middles do: corners have the mean of the strips on both sides
    let deformed = deformed_boxes(&lattice, &held, &[0.0, 0.0, 0.0, roll, 0.0, 0.0]);
    for (j, corners) in deformed.iter().enumerate() {
        let strip = (j / 2) as f64;
        let mean = |other: f64| roll * (0.5 * (strip + other) - 0.5);
        let sides = [mean((strip - 1.0).max(0.0)), mean((strip + 1.0).min(2.0))];
        for (corner, side) in [0, 0, 1, 1].into_iter().enumerate() {
            let rise = (corners[corner] - lattice.boxes[j].corners[corner]).z;
            assert!((rise - sides[side]).abs() < 1e-12, "box {j} corner {corner}: {rise}");
        }
    }
}

#[test]
fn neighbours_along_the_chord_meet_half_way() {
    let lattice = flat();
    // the node's pitch moves only the boxes of a strip that is tied to it: rows by hand
    let rows = (0..12).map(|row| if row % 4 == 0 { vec![(2, 1.0)] } else { Vec::new() }).collect();
    let spline = Spline::from_rows(rows, 6);
    let zeros = |rows, columns| Mat::<f64>::zeros(rows, columns);
    let held = SupportedStructure::from_parts(vec![2], zeros(1, 1), zeros(1, 3), zeros(3, 3), &spline, 0);
    let deformed = deformed_boxes(&lattice, &held.expect("heights"), &[1.0]);
    // forward boxes rise by one, those behind stay
    for (j, corners) in deformed.iter().enumerate() {
        let rises = [0, 1, 2, 3].map(|corner| (corners[corner] - lattice.boxes[j].corners[corner]).z);
        let expected = if j % 2 == 0 { [1.0, 0.5, 0.5, 1.0] } else { [0.5, 0.0, 0.0, 0.5] };
        assert!(rises.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "box {j}: {rises:?}");
    }
}

#[test]
fn loads_and_displacements_of_given_structures_do_the_same_work() {
    let lattice = flat();
    let (spline, held) = carried(&lattice, Point3::new(1.5, 3.0, 0.5));
    let motion = Mat::from_fn(6, 1, |i, _| (0.9 * i as f64).sin());
    // more columns than are gathered together
    let loads = Mat::from_fn(12, 19, |i, column| (0.7 * i as f64 + 0.3 * column as f64).cos());
    let on_boxes = &held.k_displacements() * &motion;
    let gathered = held.gather(loads.as_ref());
    let work = |a: &Mat<f64>, b: &Mat<f64>| -> f64 { (0..a.nrows()).map(|i| a[(i, 0)] * b[(i, 0)]).sum() };
    assert!((work(&on_boxes, &loads) - work(&gathered, &motion)).abs() < 1e-12);
    let by_hand = held.k_displacements().transpose() * &loads;
    assert_eq!([gathered.nrows(), gathered.ncols()], [6, 19]);
    assert!((&gathered - by_hand).norm_max() < 1e-12);
    // resultants about the node: all forces and moments of the boxes
    let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
    for (j, panel) in lattice.boxes.iter().enumerate() {
        let f = panel.normal() * loads[(2 * j, 0)];
        force += f;
        moment += (panel.mid_point() - Point3::new(1.5, 3.0, 0.5)).cross(&f)
            + panel.pitch_axis() * loads[(2 * j + 1, 0)];
    }
    for i in 0..3 {
        assert!(
            (gathered[(i, 0)] - force[i]).abs() < 1e-12 && (gathered[(3 + i, 0)] - moment[i]).abs() < 1e-12
        );
    }
    // a degree of freedom that the structure lacks
    let short = |dofs: Vec<usize>| {
        let size = dofs.len();
        let (f, sag) = (Mat::zeros(size, size), Mat::zeros(size, 3));
        SupportedStructure::from_parts(dofs, f, sag, Mat::zeros(3, 3), &spline, 1)
    };
    assert!(short((6..11).collect()).is_ok() && short((7..12).collect()).is_ok());
    assert!(short(vec![6, 7, 9, 10, 11]).is_err());
}

/// Boxes beside and beyond an axis of unequal pieces: the foot is on the nearest piece, clamped to the ends.
#[test]
fn a_twist_that_is_linear_along_each_piece_is_splined_at_the_foot() {
    let points = [0.0, 1.0, 3.0, 6.0].map(|y| Point3::new(0.2, y, 0.0));
    let panel = |id: u32, y: f64| AeroBox {
        id,
        corners: [
            Point3::new(0.5, y - 0.1, 0.0),
            Point3::new(1.1, y - 0.1, 0.0),
            Point3::new(1.1, y + 0.1, 0.0),
            Point3::new(0.5, y + 0.1, 0.0),
        ],
    };
    let places = [-1.0, 0.4, 2.5, 3.0, 5.4, 8.0];
    let boxes = (1..).zip(places).map(|(id, y)| panel(id, y)).collect();
    let lattice = Lattice { boxes, surfaces: Vec::new() };
    let spline = Spline::beam(&lattice, &points, &[0, 1, 2, 3]);
    let twist = [0.0, 0.1, -0.2, 0.4];
    let mut u = Mat::zeros(24, 1);
    (0..4).for_each(|node| u[(6 * node + 4, 0)] = twist[node]);
    let moved = spline.displace(u.as_ref());
    for (j, expected) in [0.0, 0.04, 0.1 - 0.75 * 0.3, -0.2, -0.2 + 0.8 * 0.6, 0.4].into_iter().enumerate() {
        assert!((moved[(2 * j + 1, 0)] - expected).abs() < 1e-12, "box {j}: {}", moved[(2 * j + 1, 0)]);
        // the middle is 0.6 m behind the axis
        assert!((moved[(2 * j, 0)] + 0.6 * expected).abs() < 1e-12, "box {j}: {}", moved[(2 * j, 0)]);
    }
    assert_eq!(spline.g_size(), 24);
    let used = spline.used_dofs();
    assert!(used.windows(2).all(|pair| pair[0] < pair[1]) && used.contains(&4) && used.contains(&22));
    let both = Spline::joined([spline.clone(), Spline::nearest_node(&lattice, &points, &[2])], 24);
    assert!(both.rows().len() == 24 && both.rows()[..12] == *spline.rows() && both.g_size() == 24);
    // one node, or the first of two as near, carries as the nearest node does
    let alone = Spline::beam(&lattice, &points, &[1]);
    assert_eq!(alone.rows(), Spline::nearest_node(&lattice, &points, &[1]).rows());
    let nearest = Spline::nearest_node(&lattice, &points, &[0, 1, 2, 3]);
    for (j, node) in [0, 0, 2, 2, 3, 3].into_iter().enumerate() {
        assert!(nearest.rows()[2 * j].iter().all(|(dof, _)| dof / 6 == node), "box {j}");
    }
}

#[test]
fn servos_are_known_to_shares_of_their_period_and_damping() {
    let [period, damping] = coupling::wing_file::Servos::default().relative_sd();
    // 15 Hz +- 1, .8 +- .05
    assert!((period - 1.0 / 15.0).abs() < 1e-15 && (damping - 0.0625).abs() < 1e-15);
    assert_eq!(coupling::wing_file::Servos::None.relative_sd(), [0.0; 2]);
}

#[test]
fn beyond_divergence_and_bent_too_far_are_without_equilibrium_and_other_faults_are_not() {
    use coupling::CouplingError;
    let why = String::new();
    let bent = CouplingError::NotInEquilibrium {
        v_m_s: 60.0,
        alpha_deg: 5.0,
        reached_m_s: 50.0,
        reached_deg: 5.0,
        why,
    };
    let diverged = CouplingError::Diverged { q_pa: 1e4, divergence_pa: None };
    assert!(bent.is_without_equilibrium() && diverged.is_without_equilibrium());
    assert!(!CouplingError::SplineOutsideStructure { dof: 3 }.is_without_equilibrium());
}

#[test]
fn a_wing_built_off_its_drawing_has_controls_of_that_effectiveness() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex/wing_beam.ron");
    let mut file = coupling::WingFile::read(&path).expect("the shipped wing");
    let drawn = file.bulk(coupling::Mount::Tunnel).expect("cards");
    let label = drawn.surfaces.values().next().expect("a control").label.clone();
    file.departure = coupling::wing_file::Departure {
        controls: vec![(label.clone(), 0.8)],
        ..coupling::wing_file::Departure::default()
    };
    let built = file.bulk(coupling::Mount::Tunnel).expect("cards");
    for (id, surface) in &drawn.surfaces {
        let factor = if surface.label == label { 0.8 } else { 1.0 };
        assert!((built.surfaces[id].effectiveness - factor * surface.effectiveness).abs() < 1e-15);
    }
}
