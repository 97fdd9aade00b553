//! A wing mirrored is the mirror image: of masses, of displacements under mirrored loads, of boxes, incidences and pressures.
//! Nothing on this wing is its own image: unequal strips, products of inertia, sections on the skew, offsets.

use aero::{ControlSurface, Lattice, MirrorPlane, SteadyAero, camber_and_twist, incidence};
use faer::{Mat, MatRef};
use fullaircraft::model::mirror::Image;
use nalgebra::{Matrix3, Vector3};
use nastran::{BulkData, parse_deck};
use structure::{Flexibility, MassProperties, Model, System};

const WING: &str = "\
GRID,1,,.1,0.,0.
GRID,2,,.16,.5,.02
GRID,3,,.23,.9,.05
GRID,4,,.31,1.4,.06
CBEAM,21,31,1,2,.1,.2,1.
,,,.01,.02,.03,.03,.01,-.02
CBEAM,22,31,2,3,.3,.1,1.
CBAR,23,32,3,4,.2,.1,1.
PBEAM,31,40,1.-3,4.-7,9.-7,2.-7,6.-7,.4
,,,,,,,,
,,,,,,,,
,.8,.7,,,3.-3,2.-3,4.-3,1.-3
,.02,.01,.03,-.01,.01,.02,-.01,.015
PBAR,32,40,8.-4,3.-7,7.-7,5.-7,.3
,,,,,,,,
,,,2.-7
MAT1,40,7.+10,,.3,2700.
CONM2,51,3,,2.,.1,.2,-.3
,.5,.11,.6,.07,-.13,.8
CONM2,52,4,,.7,-.05,.03,.08
,.05,-.01,.06,.02,.015,.07
SPC1,1,123456,1
PAERO1,5
CAERO1,1001,5,,,,61,62,1
,0.,0.,0.,.4,.2,1.4,.1,.25
AEFACT,61,0.,.2,.5,1.
AEFACT,62,0.,.4,1.
AESURF,71,AIL,0,72
AELIST,72,1004,1006
DMI,W2GJ,0,2,1,0,,6,1
DMI,W2GJ,1,1,.01,-.02,.04,.03,-.05
,.06
";

fn wing() -> (BulkData, Image) {
    let bulk = parse_deck("wing.bdf", WING).expect("a deck");
    let image = Image::of(&bulk).expect("every card has an image");
    (bulk, image)
}

fn assert_same(what: &str, ours: &[f64], law: &[f64], share: f64) {
    let most =
        |values: &mut dyn Iterator<Item = f64>| values.fold(0.0_f64, |most, value| most.max(value.abs()));
    let apart = most(&mut ours.iter().zip(law).map(|(a, b)| a - b));
    assert!(
        apart <= share * most(&mut law.iter().copied()),
        "{what}: {ours:?} where the mirror says {law:?}"
    );
}

/// Signs of a point's or a force's components, and of a rotation's or a moment's, in the mirror y = 0.
const FORCES: [f64; 3] = [1.0, -1.0, 1.0];
const MOTIONS: [f64; 6] = [1.0, -1.0, 1.0, -1.0, 1.0, -1.0];

#[test]
fn the_image_has_the_mirrored_centre_of_gravity_and_the_opposite_products_of_inertia_with_y() {
    let (bulk, image) = wing();
    let [one, other] =
        [&bulk, &image.bulk].map(|bulk| MassProperties::of_model(&Model::from_bulk(bulk).expect("a model")));
    assert_same("mass", &[other.mass_kg], &[one.mass_kg], 1e-14);
    let signs = Vector3::from(FORCES);
    let centre = one.centre.coords.component_mul(&signs);
    assert_same("centre of gravity", other.centre.coords.as_slice(), centre.as_slice(), 1e-14);
    let turn = Matrix3::from_diagonal(&signs);
    let inertia = turn * one.inertia_kg_m2 * turn;
    assert!(inertia[(0, 1)].abs() > 0.1 && inertia[(1, 2)].abs() > 0.1, "there are products with y");
    assert_same("inertia", other.inertia_kg_m2.as_slice(), inertia.as_slice(), 1e-13);
}

#[test]
fn mirrored_loads_displace_the_image_to_the_mirror_image() {
    let (bulk, image) = wing();
    let [one, other] = [&bulk, &image.bulk].map(|bulk| {
        let system = System::assemble(&Model::from_bulk(bulk).expect("a model")).expect("a system");
        let flexibility = Flexibility::new(&system).expect("it is held");
        move |loads: MatRef<'_, f64>| {
            system.expand(flexibility.displacements(system.reduce(loads).as_ref()).as_ref())
        }
    });
    // a unit of each force and moment at every grid, and the same seen in the mirror
    let units = Mat::<f64>::identity(24, 24);
    let mirrored = Mat::from_fn(24, 24, |i, j| MOTIONS[i % 6] * units[(i, j)]);
    let (u, seen) = (one(units.as_ref()), other(mirrored.as_ref()));
    let scale = |i: usize| if i % 6 < 3 { 1.0 } else { 0.1 };
    for j in 6..24 {
        let law: Vec<f64> = (0..24).map(|i| scale(i) * MOTIONS[i % 6] * u[(i, j)]).collect();
        let ours: Vec<f64> = (0..24).map(|i| scale(i) * seen[(i, j)]).collect();
        assert_same(&format!("column {j}"), &ours, &law, 1e-9);
    }
}

#[test]
fn boxes_incidences_and_pressures_of_the_image_stand_where_the_mirror_shows_them() {
    let (bulk, image) = wing();
    let [one, other] = [&bulk, &image.bulk].map(|bulk| Lattice::from_bulk(bulk).expect("a lattice"));
    let places = image.check(&one, &other, 0).expect("each box has its image");
    assert_eq!(places, [4, 5, 2, 3, 0, 1], "strips of .2, .3 and .5 of the span count from the other side");
    for (panel, &at) in one.boxes.iter().zip(&places) {
        let (here, there) = (panel.three_quarter_point(), other.boxes[at].three_quarter_point());
        assert_same("control point", &[there.x, there.y, there.z], &[here.x, -here.y, here.z], 1e-14);
    }
    let seen = |values: &[f64]| places.iter().map(|&at| values[at]).collect::<Vec<f64>>();
    let [camber, mirrored] = [(&bulk, &one), (&image.bulk, &other)]
        .map(|(bulk, lattice)| camber_and_twist(bulk, lattice).expect("one slope a box"));
    assert_eq!(seen(&mirrored), camber, "W2GJ goes with its box");
    assert_eq!(image.bulk.box_lists[&72].boxes, [1002, 1004], "rear boxes of the outer two strips");
    let [aileron, other_aileron] = [(&bulk, &one), (&image.bulk, &other)].map(|(bulk, lattice)| {
        ControlSurface::all_from_bulk(bulk, lattice).expect("a surface").swap_remove(0).column(6)
    });
    assert_same("aileron", &seen(&other_aileron), &aileron, 1e-13);
    // the air on both: angle of attack with camber, and a roll one way against a roll the other way
    let [air, other_air] = [&one, &other]
        .map(|lattice| SteadyAero::new(lattice, MirrorPlane::None, 0.0).expect("it can be solved"));
    let add = |a: Vec<f64>, b: &[f64]| a.iter().zip(b).map(|(a, b)| 0.1 * a + b).collect::<Vec<f64>>();
    let with_camber = air.pressures_of(&add(incidence::angle_of_attack(&one), &camber));
    let image_of_it = other_air.pressures_of(&add(incidence::angle_of_attack(&other), &mirrored));
    assert_same("pressures", &seen(&image_of_it), &with_camber, 1e-11);
    let origin = nalgebra::Point3::origin();
    let roll = |lattice: &Lattice, sign: f64| {
        incidence::rotation_rate(lattice, &(sign * Vector3::x()), &origin, 1.0)
    };
    let (right, left) = (air.pressures_of(&roll(&one, 1.0)), other_air.pressures_of(&roll(&other, -1.0)));
    assert_same("pressures of a roll", &seen(&left), &right, 1e-11);
}
