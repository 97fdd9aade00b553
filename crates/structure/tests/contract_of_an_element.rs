//! The contract of an element, run for the beam.

use crate::contract::{Specimen, contract, rigid};
use nalgebra::{Matrix3, Point3, Rotation3, Vector3};
use nastran::{BeamProperty, BeamStation, Mat1, Span};
use structure::{Beam, BeamPlacement, Element};

fn span() -> Span {
    Span::generated("test")
}

fn material() -> Mat1 {
    Mat1 {
        id: 1,
        e: 70e9,
        g: 27e9,
        nu: 0.3,
        rho: 2700.0,
        expansion: nastran::Expansion::default(),
        span: span(),
    }
}

fn station(x_over_l: f64, size: f64) -> BeamStation {
    BeamStation {
        x_over_l,
        area: 1e-3 * size,
        i1: 4e-7 * size,
        i2: 1e-7 * size,
        i12: 0.0,
        j: 2e-7 * size,
        nsm: 0.0,
    }
}

fn property(stations: Vec<BeamStation>) -> BeamProperty {
    BeamProperty {
        id: 1,
        material: 1,
        stations,
        shear_factors: [0.0; 2],
        nsi: [0.0; 2],
        nsm_offset: [[0.0; 2]; 2],
        neutral_axis: [[0.0; 2]; 2],
        is_beam: true,
        span: span(),
    }
}

fn specimen(
    rotation: &Rotation3<f64>,
    property: &BeamProperty,
    points: [Point3<f64>; 2],
    offsets: [Vector3<f64>; 2],
) -> Specimen<Beam> {
    let placement = BeamPlacement {
        grids: points.map(|point| rotation * point),
        offsets: offsets.map(|offset| rotation * offset),
        orientation: rotation * Vector3::new(0.1, 1.0, 0.3),
        pins: [Vec::new(), Vec::new()],
    };
    let beam = Beam::new(7, [0, 1], &placement, property, &material(), &span()).expect("a possible beam");
    let (a, b) = (&property.stations[0], property.stations.last().expect("has stations"));
    let per_length = 2700.0 * 0.5 * (a.area + b.area) + 0.5 * (a.nsm + b.nsm);
    Specimen { mass_kg: per_length * beam.length_m(), element: beam, points: points.to_vec(), inertia: None }
}

const ENDS: [Point3<f64>; 2] = [Point3::new(0.3, -0.2, 0.1), Point3::new(1.1, 0.7, 0.6)];

#[test]
fn a_uniform_beam_keeps_the_contract() {
    contract(|r| specimen(r, &property(vec![station(0.0, 1.0)]), ENDS, [Vector3::zeros(); 2]));
}

#[test]
fn a_tapered_beam_with_shear_offsets_and_product_of_inertia_keeps_the_contract() {
    let mut card = property(vec![station(0.0, 2.0), station(1.0, 0.7)]);
    card.stations[0].i12 = 1e-7;
    card.stations[0].nsm = 0.4;
    card.stations[1].nsm = 0.1;
    card.shear_factors = [0.8, 0.6];
    card.nsi = [1e-3, 5e-4];
    card.nsm_offset = [[0.02, -0.01], [0.01, 0.03]];
    card.neutral_axis = [[0.015, 0.004], [0.005, 0.002]];
    contract(|r| specimen(r, &card, ENDS, [Vector3::new(0.05, 0.0, -0.02), Vector3::new(0.01, 0.03, 0.04)]));
}

#[test]
fn a_uniform_bar_has_the_inertia_of_a_rod_about_its_end() {
    let points = [Point3::origin(), Point3::new(0.0, 0.0, 1.7)];
    let card = property(vec![station(0.0, 1.0)]);
    contract(|r| {
        let mut rod = specimen(r, &card, points, [Vector3::zeros(); 2]);
        let (m, l) = (rod.mass_kg, 1.7);
        let about_axis = 2700.0 * 5e-7 * l;
        let transverse = m * l * l / 3.0;
        let inertia = Matrix3::from_diagonal(&Vector3::new(transverse, transverse, about_axis));
        rod.inertia = Some((inertia, Vector3::new(0.0, 0.0, m * l / 2.0)));
        rod
    });
}

#[test]
fn the_mass_of_a_linear_taper_has_the_centre_of_a_trapezium() {
    let points = [Point3::origin(), Point3::new(2.0, 0.0, 0.0)];
    let card = property(vec![station(0.0, 3.0), station(1.0, 1.0)]);
    let beam = specimen(&Rotation3::identity(), &card, points, [Vector3::zeros(); 2]);
    let total = rigid(&points).transpose() * beam.element.mass().unwrap().into_owned() * rigid(&points);
    // Rotation about z, force along y: m x_c; a trapezium with sides 3 and 1: x_c = L/3 (3 + 2)/(3 + 1)
    let centre = total[(1, 5)] / total[(1, 1)];
    assert!((centre - 2.0 / 3.0 * 5.0 / 4.0).abs() < 1e-13, "{centre}");
}
