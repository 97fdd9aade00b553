//! Stream axes and control surfaces: the deck's systems mean nothing, a hinge is a rotation, columns have the
//! boxes' places.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use aero::{ControlSurface, Lattice, StreamAxes};
use nalgebra::{Point3, Rotation3, Unit, Vector3};
use nastran::{BulkData, Frames, Span, parse_deck};

/// Origin, a point on z and one in the plane of x and z of two hinges, whose y axes are skew to everything.
const HINGES: [[[f64; 3]; 3]; 2] = [
    [[0.7, 0.5, 0.2], [0.7, 0.6, 1.2], [1.5, 0.9, 0.1]],
    [[1.1, -0.3, 0.0], [0.9, -0.3, 1.0], [2.0, -0.1, 0.4]],
];
const EFF: f64 = 0.8;

fn numbers(points: &[[f64; 3]]) -> Vec<String> {
    points.iter().flatten().map(|number| format!("{number:?}")).collect()
}

/// A panel of 3 strips of 2 boxes with a flap whose two hinges share box 4, all in coordinates of a system; 7
/// is a skew one.
fn deck(system: u32) -> BulkData {
    let mut cards = format!(
        "CORD2R,7,0,1.,2.,3.,1.3,1.8,4.\n,2.,2.5,2.7\nPAERO1,1\n\
         CAERO1,1,1,{system},3,2,,,1\n,0.2,0.5,0.1,1.,0.9,2.,0.6,.5\n\
         AESURF,5,FLAP,51,61,52,62,{EFF:?}\nAELIST,61,4,2,2\nAELIST,62,4,6\n"
    );
    for (id, points) in [51, 52].iter().zip(&HINGES) {
        let words = numbers(points);
        let (first, rest) = words.split_at(6);
        let lines = format!("CORD2R,{id},{system},{}\n,{}\n", first.join(","), rest.join(","));
        cards.push_str(&lines);
    }
    parse_deck("flap.bdf", &format!("BEGIN BULK\n{cards}ENDDATA\n")).unwrap()
}

/// Of the deck as it stands in basic axes.
fn basic() -> (Lattice, ControlSurface) {
    let bulk = deck(0);
    let lattice = Lattice::from_bulk(&bulk).unwrap();
    let flap = ControlSurface::all_from_bulk(&bulk, &lattice).unwrap().remove(0);
    (lattice, flap)
}

#[test]
fn a_wing_seen_from_the_axes_of_its_stream_is_where_its_coordinates_say() {
    let bulk = deck(7);
    let axes = StreamAxes::of_deck(&Frames::resolve(&bulk).unwrap(), 7, &Span::generated("AERO")).unwrap();
    assert!(!axes.is_basic() && StreamAxes::basic().is_basic());
    let place = Point3::new(0.3, -0.7, 2.1);
    assert_eq!(StreamAxes::basic().seen(&place), place);
    // The system's own origin, and a point one metre along its z.
    assert!(axes.seen(&Point3::new(1.0, 2.0, 3.0)).coords.norm() < 1e-14);
    let up = Vector3::new(0.3, -0.2, 1.0).normalize();
    assert!((axes.seen(&(Point3::new(1.0, 2.0, 3.0) + up)).coords - Vector3::z()).norm() < 1e-14);

    let (want, flap) = basic();
    let seen = Lattice::in_axes(&bulk, &axes).unwrap();
    assert_eq!(seen.surfaces, want.surfaces);
    for (got, want) in seen.boxes.iter().zip(&want.boxes) {
        assert_eq!(got.id, want.id);
        assert!(got.corners.iter().zip(&want.corners).all(|(a, b)| (a - b).norm() < 1e-13), "box {}", got.id);
    }
    let got = ControlSurface::all_in_axes(&bulk, &seen, &axes).unwrap().remove(0);
    assert_eq!((&got.name, &got.boxes), (&flap.name, &flap.boxes));
    for (got, want) in got.slope.iter().chain(&got.lever_m).zip(flap.slope.iter().chain(&flap.lever_m)) {
        assert!((got - want).abs() < 1e-13, "{got} instead of {want}");
    }
}

/// A box on a hinge turns as a rigid body; small rotations about two hinges add.
#[test]
fn a_deflection_turns_normals_and_moves_points_as_a_rigid_rotation_about_its_hinges() {
    let (lattice, flap) = basic();
    assert_eq!(flap.boxes, [1, 3, 5]);
    let hinges_of = [vec![0], vec![0, 1], vec![1]];
    let angle = 1e-5;
    for (i, hinges) in hinges_of.iter().enumerate() {
        let panel = &lattice.boxes[flap.boxes[i]];
        let (normal, point) = (panel.normal(), panel.three_quarter_point());
        let (mut slope, mut lever_m) = (0.0, 0.0);
        for hinge in hinges {
            let [origin, on_z, in_xz] = HINGES[*hinge].map(Point3::from);
            let axis = Unit::new_normalize((on_z - origin).cross(&(in_xz - origin)));
            let [up, down] = [angle, -angle].map(|angle| {
                let turn = Rotation3::from_axis_angle(&axis, angle);
                ((turn * normal).x, (turn * (point - origin)).dot(&normal))
            });
            slope += EFF * (up.0 - down.0) / (2.0 * angle);
            lever_m -= EFF * (up.1 - down.1) / (2.0 * angle);
        }
        assert!((flap.slope[i] - slope).abs() < 1e-9, "{}: {} instead of {slope}", panel.id, flap.slope[i]);
        assert!((flap.lever_m[i] - lever_m).abs() < 1e-9, "{}: {}, not {lever_m}", panel.id, flap.lever_m[i]);
    }
}

#[test]
fn columns_of_incidence_and_of_its_rate_have_values_at_the_boxes_of_the_surface_only() {
    let flap = ControlSurface {
        name: "FLAP".to_owned(),
        boxes: vec![1, 3],
        slope: vec![0.9, 0.7],
        lever_m: vec![0.25, -0.5],
    };
    assert_eq!(flap.column(5), [0.0, 0.9, 0.0, 0.7, 0.0]);
    assert_eq!(flap.rate_column_m(5), [0.0, 0.25, 0.0, -0.5, 0.0]);
    // Fewer boxes: those of the surface that are not there have no row.
    assert_eq!(flap.column(2), [0.0, 0.9]);
    assert_eq!(flap.rate_column_m(3), [0.0, 0.25, 0.0]);
}

#[test]
fn a_label_stands_for_one_surface() {
    let mut bulk = deck(0);
    let mut other = bulk.surfaces.values().next().unwrap().clone();
    other.id = 6;
    bulk.surfaces.insert(6, other.clone());
    let lattice = Lattice::from_bulk(&bulk).unwrap();
    let twice = ControlSurface::all_from_bulk(&bulk, &lattice).unwrap_err().to_string();
    assert!(twice.contains("the label FLAP is used by two AESURF"), "{twice}");
    bulk.surfaces.insert(6, nastran::Aesurf { label: "RUDDER".to_owned(), ..other });
    let both = ControlSurface::all_from_bulk(&bulk, &lattice).unwrap();
    assert_eq!(both.iter().map(|one| one.name.as_str()).collect::<Vec<_>>(), ["FLAP", "RUDDER"]);
}
