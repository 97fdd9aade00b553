//! What a point mass more adds to loads at stations: force is mass times acceleration, wherever loads are summed.

use crate::aircraft::assembly::Aircraft;
use crate::aircraft::file::AircraftFile;
use crate::flight::modes::FreeModes;
use crate::flight::rows::{LoadParts, PRODUCTS, momentum};
use crate::trim::case::TrimTools;
use coupling::WingFile;
use coupling::wing_file::{Source, StationAt};
use nalgebra::{Point3, Vector3};
use std::path::Path;

const MORE_KG: f64 = 0.3;

/// The shipped aircraft with a station inboard of the outer servo, which is so much heavier.
fn aircraft(more_kg: f64) -> Aircraft {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex");
    let mut file = AircraftFile::read(&data.join("aircraft.ron")).expect("shipped files are right");
    // enough for the body that closes the masses
    file.total.ixx_kg_m2 += 3.0;
    file.total.iyy_kg_m2 += 3.0;
    file.total.izz_kg_m2 += 6.0;
    let mut wing = WingFile::read(&data.join("wing_beam.ron")).expect("shipped files are right");
    wing.stations = vec![StationAt { name: "half".to_owned(), x_m: Some(0.3), y_m: 0.9, z_m: Some(-0.1) }];
    let Source::Parametric(planform) = &mut wing.source else { panic!("it is parametric") };
    let structure = planform.structure.as_mut().expect("it has a structure");
    let servo = structure.point_masses_mut().iter_mut().find(|mass| mass.name == "servo_outer");
    servo.expect("the outer servo").mass_kg += more_kg;
    Aircraft::new(file, wing).expect("an aircraft")
}

/// Fz, Mx, My about a point of the servo's additional mass on one side under an acceleration by its arm from the centre of gravity.
fn load(side: f64, about: &Point3<f64>, acceleration: impl Fn(Vector3<f64>) -> Vector3<f64>) -> [f64; 3] {
    let (y_m, x_over_c) = (1.545, 0.6);
    let chord_m = 0.30 - 0.15 * y_m / 1.8;
    let x_m = 0.075 + y_m * 20.0_f64.to_radians().tan() + (x_over_c - 0.25) * chord_m;
    let place = Point3::new(x_m, side * y_m, 0.0);
    let force = acceleration(place - Point3::new(0.40, 0.0, 0.0)) * MORE_KG;
    let moment = (place - about).cross(&force);
    [force.z, moment.x, moment.y]
}

/// Sides and points of both roots and of the station on both sides.
fn places() -> [(f64, Point3<f64>); 4] {
    let point = |x, y, z| Point3::new(x, y, z);
    [
        (1.0, point(0.075, 0.0, 0.0)),
        (-1.0, point(0.075, 0.0, 0.0)),
        (1.0, point(0.3, 0.9, -0.1)),
        (-1.0, point(0.3, -0.9, -0.1)),
    ]
}

fn assert_added(what: &str, added: f64, law: f64) {
    assert!((added - law).abs() < 1e-10, "{what}: {added} added, mass times acceleration is {law}");
}

#[test]
fn a_mass_outboard_of_a_station_adds_its_mass_times_its_acceleration() {
    let [before, after] = [0.0, MORE_KG].map(aircraft);
    let [stations, with_mass] =
        [&before, &after].map(|aircraft| TrimTools::new(aircraft, &[]).expect("stations"));
    let [parts, parts_with_mass] = [&before, &after]
        .map(|a| LoadParts::new(a, &momentum(a, &FreeModes::new(a).expect("modes"))).expect("parts"));
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    for (at, (side, point)) in places().iter().enumerate() {
        for motion in 0..6 {
            let expected = load(*side, point, |arm| match motion {
                0..3 => axes[motion],
                turn => axes[turn - 3].cross(&arm),
            });
            for (row, expected) in expected.into_iter().enumerate() {
                let (place, of_six) = ((3 * at + row, motion), (6 * at + 2 + row, motion));
                let what = format!("place {at}, row {row}, acceleration {motion}");
                assert_added(&what, with_mass.inertia[of_six] - stations.inertia[of_six], expected);
                assert_added(&what, parts_with_mass.inertia[place] - parts.inertia[place], expected);
            }
        }
        // omega x (omega x r) by each product of rates, its cross terms by the polarisation of that square
        let [first, other] = [&parts, &parts_with_mass].map(|parts| parts.inertia.ncols() - PRODUCTS.len());
        let square = |rate: Vector3<f64>| load(*side, point, move |arm| rate.cross(&rate.cross(&arm)));
        for (product, &(i, j)) in PRODUCTS.iter().enumerate() {
            let (one, two, both) = (square(axes[i]), square(axes[j]), square(axes[i] + axes[j]));
            for row in 0..3 {
                let expected = if i == j { one[row] } else { both[row] - one[row] - two[row] };
                let added = parts_with_mass.inertia[(3 * at + row, other + product)]
                    - parts.inertia[(3 * at + row, first + product)];
                assert_added(&format!("place {at}, row {row}, product {i}{j}"), added, expected);
            }
        }
    }
}
