//! Points, areas and normals of boxes of any shape, the plane of symmetry at any size, and conditions of the stream.

use aero::flow::{SAME_ANGLE_RAD, same_airspeed, same_angle};
use aero::{AeroBox, AeroError, Flow, Lattice, MirrorPlane};
use nalgebra::{Point3, Rotation3, Vector3};

/// A twisted quadrilateral far from the origin, shorter on side 1.
fn twisted() -> AeroBox {
    let corners = [[3.1, -1.2, 0.4], [3.7, -1.1, 0.3], [4.2, -0.3, 0.9], [3.3, -0.4, 0.5]];
    AeroBox { id: 1, corners: corners.map(Point3::from) }
}

fn moved(panel: &AeroBox, by: impl Fn(&Point3<f64>) -> Point3<f64>) -> AeroBox {
    AeroBox { id: panel.id, corners: panel.corners.each_ref().map(by) }
}

fn assert_near(got: &Point3<f64>, want: &Point3<f64>) {
    assert!((got - want).norm() < 1e-13, "{got} instead of {want}");
}

/// What the boxes of PanelAero are made of: means of edges. The vector area is half the cross product of the diagonals.
#[test]
fn points_and_sizes_of_a_twisted_box_are_means_of_its_corners() {
    let panel = twisted();
    let [c1, c2, c3, c4] = panel.corners.map(|corner| corner.coords);
    let (lead, trail) = ((c1 + c4) / 2.0, (c2 + c3) / 2.0);
    assert_near(&panel.quarter_point(), &(lead * 0.75 + trail * 0.25).into());
    assert_near(&panel.mid_point(), &((c1 + c2 + c3 + c4) / 4.0).into());
    assert_near(&panel.three_quarter_point(), &(lead * 0.25 + trail * 0.75).into());
    let [from, to] = panel.bound_vortex();
    assert_near(&from, &(c1 * 0.75 + c2 * 0.25).into());
    assert_near(&to, &(c4 * 0.75 + c3 * 0.25).into());
    let area = (c3 - c1).cross(&(c4 - c2)).norm() / 2.0;
    assert!((panel.area_m2() - area).abs() < 1e-14);
    assert!((panel.chord_m() - (trail - lead).x).abs() < 1e-14);
    let across = (c3 + c4 - c1 - c2) / 2.0;
    assert!((panel.width_m() - across.y.hypot(across.z)).abs() < 1e-14);
    let normal = (c2 - c1).cross(&(c4 - c1)).normalize();
    assert!((panel.normal() - normal).norm() < 1e-14);
    // Along y as the normal is along z: level, across the normal, to the right, and a unit vector.
    let axis = panel.pitch_axis();
    assert!(axis.x.abs() < 1e-15 && axis.dot(&normal).abs() < 1e-15 && axis.y > 0.0);
    assert!((axis.norm() - 1.0).abs() < 1e-15);
}

#[test]
fn a_normal_does_not_depend_on_size_and_that_of_a_triangle_is_that_of_its_plane() {
    let panel = twisted();
    for size in [1e-7, 1e-5, 1e-3, 1e3, 1e5] {
        let small = moved(&panel, |p| p * size);
        assert!((small.normal() - panel.normal()).norm() < 1e-9, "size {size}");
        assert!((small.area_m2() / panel.area_m2() / (size * size) - 1.0).abs() < 1e-8);
    }
    let turn = Rotation3::from_euler_angles(0.6, 0.2, -0.3);
    let place = Vector3::new(3.0, -2.0, 5.0);
    let corner = |x: f64, y: f64| turn * Point3::new(x, y, 0.0) + place;
    let (a, b, c) = (corner(0.0, 0.0), corner(1.3, 0.0), corner(0.4, 2.0));
    // With its point at side 2 and at side 1.
    for corners in [[a, b, c, c], [a, a, corner(1.5, 1.0), corner(-0.3, 1.0)]] {
        let normal = AeroBox { id: 1, corners }.normal();
        assert!((normal - turn * Vector3::z()).norm() < 1e-12, "{normal}");
    }
}

#[test]
fn boxes_that_are_no_boxes_are_refused_one_by_one() {
    let flat = |x: [f64; 4], y: [f64; 2]| AeroBox {
        id: 7,
        corners: [[x[0], y[0], 0.0], [x[1], y[0], 0.0], [x[2], y[1], 0.0], [x[3], y[1], 0.0]]
            .map(Point3::from),
    };
    let good = |id: u32| AeroBox { id, ..flat([0.0, 1.0, 1.2, 0.2], [0.0, 1.0]) };
    let lattice = Lattice::from_corners("hand", 2, vec![good(3), good(4), good(5), good(6)]).unwrap();
    let surface = &lattice.surfaces[0];
    assert_eq!((surface.id, surface.chordwise, surface.spanwise, surface.first_box), (3, 2, 2, 0));
    assert_eq!((lattice.len(), lattice.index_of(5), lattice.index_of(8)), (4, Some(2), None));
    let refusal = |chordwise: usize, boxes: Vec<AeroBox>| {
        Lattice::from_corners("hand", chordwise, boxes).unwrap_err().to_string()
    };
    assert!(refusal(0, vec![]).contains("do not fill strips of 0 boxes"));
    assert!(refusal(2, vec![good(1), good(2), good(3)]).contains("3 boxes of hand do not fill strips of 2"));
    assert!(refusal(1, vec![good(1), good(1)]).contains("box number 1 is used twice"));
    let upright = [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [0.0, 1.0, 0.0]].map(Point3::from);
    for bad in [
        flat([0.0, f64::NAN, 1.0, 0.0], [0.0, 1.0]),
        flat([0.0, 1.0, f64::INFINITY, 0.0], [0.0, 1.0]),
        flat([1.0, 0.0, 0.2, 1.2], [0.0, 1.0]),
        flat([0.0, 1.0, 1.0, 0.0], [0.5, 0.5]),
        AeroBox { id: 7, corners: upright },
    ] {
        assert!(refusal(1, vec![good(1), bad]).contains("box 7 of hand has no area or no chord along x"));
    }
}

#[test]
fn panels_are_triangles_or_trapezoids_of_at_most_fifty_thousand_boxes() {
    let of = |chords: [f64; 2], tip: [f64; 3], divisions: [u32; 2]| {
        Lattice::trapezoid(1, [0.0; 3], chords[0], tip, chords[1], divisions)
            .map_err(|error| error.to_string())
    };
    for (chords, area) in [([1.0, 0.0], 1.0), ([0.0, 1.0], 1.0), ([0.5, 1.0], 1.5), ([1.0, 0.5], 1.5)] {
        for tip in [[0.3, 2.0, 0.0], [0.3, 0.0, 2.0], [0.3, -1.2, 1.6]] {
            let lattice = of(chords, tip, [3, 4]).unwrap();
            let sum: f64 = lattice.boxes.iter().map(AeroBox::area_m2).sum();
            assert!((sum - area).abs() < 1e-12, "{chords:?}: {sum}");
        }
    }
    let (tip, one) = ([0.3, 2.0, 0.0], [1, 1]);
    for chords in
        [[0.0, 0.0], [-0.5, 1.0], [1.0, -0.5], [f64::NAN, 1.0], [1.0, f64::NAN], [f64::INFINITY, 1.0]]
    {
        assert!(of(chords, tip, one).unwrap_err().contains("has no area"), "{chords:?}");
    }
    for tip in [[0.3, 0.0, 0.0], [0.3, f64::NAN, 1.0], [0.3, f64::INFINITY, 0.0]] {
        assert!(of([1.0, 0.5], tip, one).unwrap_err().contains("has no area"), "{tip:?}");
    }
    let none = of([1.0, 1.0], tip, [0, 3]).unwrap_err();
    assert!(none.contains("0 chordwise divisions, expected 1 to 50000"), "{none}");
    let many = of([1.0, 1.0], tip, [1, 50_001]).unwrap_err();
    assert!(many.contains("50001 spanwise divisions, expected 1 to 50000"), "{many}");
    let many = of([1.0, 1.0], tip, [3, 16_667]).unwrap_err();
    assert!(many.contains("50001 boxes, and 50000 are the most"), "{many}");
    // Fifty thousand are no more than that; memory may be too little for them.
    let most = of([1.0, 1.0], tip, [1, 50_000]).err().unwrap_or_default();
    assert!(!most.contains("are the most") && !most.contains("expected 1 to"), "{most}");
}

/// A box may overlap the plane by a millionth of its size, whatever that is and wherever the plane.
#[test]
fn the_side_of_the_plane_is_told_to_a_millionth_of_a_box() {
    for size in [0.01, 1.0, 300.0] {
        for (y_m, side) in [(0.0, 1.0), (0.7, 1.0), (-0.4, -1.0)] {
            let plane = MirrorPlane::Symmetric { y_m };
            let from_to = |from: f64, to: f64, z: f64| {
                let ends = [from, to].map(|y| y_m + side * size * y);
                Lattice::trapezoid(1, [0.0, ends[0], 0.0], size, [0.0, ends[1], z * size], size, [1, 1])
                    .unwrap()
            };
            assert_eq!(plane.check(&from_to(0.0, 1.0, 0.0)), Ok(()));
            assert_eq!(plane.check(&from_to(-0.4e-6, 1.0, 0.0)), Ok(()), "size {size} at {y_m}");
            let crosses = AeroError::CrossesPlane { id: 1, y_m };
            assert_eq!(plane.check(&from_to(-3e-6, 1.0, 0.0)), Err(crosses), "size {size} at {y_m}");
            let within = AeroError::InPlane { id: 1, y_m };
            let fin = from_to(-0.4e-6, 0.4e-6, 1.0);
            assert_eq!(plane.refuse_within(&fin), Err(within), "size {size} at {y_m}");
            assert_eq!(plane.check(&fin), Ok(()), "it may stand there");
            assert_eq!(plane.refuse_within(&from_to(0.0, 1.0, 0.0)), Ok(()));
            assert_eq!(plane.check(&from_to(0.0, 3e-6, 1.0)), Ok(()), "size {size} at {y_m}");
            // Two boxes of one half are on one side; without a plane there are no sides.
            let two = from_to(0.0, 1.0, 0.0).joined(&from_to(1.0, 2.0, 0.0).renumbered(5).unwrap()).unwrap();
            assert_eq!(plane.check(&two), Ok(()));
            let both =
                from_to(0.0, 1.0, 0.0).joined(&from_to(-1.0, 0.0, 0.0).renumbered(5).unwrap()).unwrap();
            assert_eq!(plane.check(&both), Err(AeroError::BothSides { id: 6, other: 1, y_m }));
            assert_eq!(MirrorPlane::None.check(&both), Ok(()));
        }
    }
}

#[test]
fn an_image_lies_as_far_beyond_its_plane_and_numbers_rise_together() {
    let wing = Lattice::trapezoid(11, [0.1, 0.5, 0.2], 1.0, [0.6, 2.5, 0.4], 0.5, [2, 3]).unwrap();
    for y_m in [0.0, 0.7, -1.3] {
        let (image, map) = wing.mirrored(y_m);
        assert_eq!(map.carry(&[1, 2, 3, 4, 5, 6]), [1, 2, 3, 4, 5, 6]);
        for (image, own) in image.boxes.iter().zip(&wing.boxes) {
            for (a, b) in [(0, 3), (1, 2), (2, 1), (3, 0)] {
                let (a, b) = (&image.corners[a], &own.corners[b]);
                assert_eq!((a.x, a.z), (b.x, b.z));
                assert!((a.y - y_m + (b.y - y_m)).abs() < 1e-15 * 4.0);
            }
        }
    }
    let far = wing.renumbered(1000).unwrap();
    assert_eq!((far.boxes[5].id, far.surfaces[0].id, far.surfaces[0].chordwise), (1016, 1011, 2));
    assert!(wing.renumbered(u32::MAX - 12).unwrap_err().to_string().contains("cannot be raised"));
    let both = wing.joined(&far).unwrap();
    assert_eq!((both.surfaces[1].first_box, both.index_of(1011)), (6, Some(6)));
    assert!(wing.joined(&wing).unwrap_err().to_string().contains("used twice"));
}

/// 10 m/s in air at sea level press with 61.25 Pa.
#[test]
fn conditions_are_one_within_two_thousandths_of_the_faster_airspeed_and_a_twentieth_of_a_degree() {
    assert_eq!(Flow { v_m_s: 10.0, rho_kg_m3: 1.225 }.dynamic_pressure_pa(), 61.25);
    for v in [0.5, 30.0, 250.0] {
        for (share, same) in [(0.0, true), (0.0019, true), (0.0021, false), (0.1, false), (0.9, false)] {
            let slower = v * (1.0 - share);
            assert_eq!(same_airspeed(v, slower), same, "{v} and {slower}");
            assert_eq!(same_airspeed(slower, v), same, "{slower} and {v}");
        }
    }
    assert!(same_airspeed(0.0, 0.0) && same_airspeed(1000.0, 998.0));
    for angle in [-0.2, 0.0, 0.1] {
        for (step, same) in [(0.0, true), (0.00086, true), (0.00088, false), (0.3, false)] {
            assert_eq!(same_angle(angle, angle + step), same, "{angle} by {step}");
            assert_eq!(same_angle(angle + step, angle), same, "{angle} by {step}");
        }
    }
    assert!(same_angle(0.0, SAME_ANGLE_RAD) && same_angle(SAME_ANGLE_RAD, 0.0));
}
