//! Straight beams of tail and fuselage as cards: grids, CBEAM, PBEAM, MAT1 and the masses of half an element each way.

use crate::aircraft::file::RoundBeam;
use nalgebra::{Point3, Vector3};
use nastran::{BeamElement, BeamProperty, BeamStation, BulkData, Conm2, Grid, Mat1, Orientation, Rbe2, Span};

/// Young's modulus of the cards, Pa; sections are made so that EI and GJ come out, so the choice is free.
const E_PA: f64 = 70e9;
/// Shear modulus of the cards, Pa.
const G_PA: f64 = 27e9;
/// Radius of gyration of the section, m: makes axial motion stiff (EA = EI / radius squared).
const RADIUS_M: f64 = 0.01;

/// Adds a beam through `points` with grids from `first` on; gives the grids. `first` numbers all its cards.
pub(crate) fn add(
    bulk: &mut BulkData,
    first: u32,
    points: &[Point3<f64>],
    beam: &RoundBeam,
    across: &Vector3<f64>,
    span: &Span,
) -> Vec<u32> {
    let ids: Vec<u32> = (first..).take(points.len()).collect();
    let (id, nu) = (first, E_PA / (2.0 * G_PA) - 1.0);
    bulk.materials.insert(id, Mat1 { id, e: E_PA, g: G_PA, nu, rho: 0.0, span: span.clone() });
    bulk.beam_properties.insert(id, property(id, beam, span));
    for (at, (&id, point)) in ids.iter().zip(points).enumerate() {
        add_grid(bulk, id, point, span);
        let length =
            |a: usize, b: usize| points.get(a).zip(points.get(b)).map_or(0.0, |(a, b)| (b - a).norm());
        let before = if at == 0 { 0.0 } else { length(at - 1, at) };
        let mass = beam.mass_kg_m * 0.5 * (before + length(at, at + 1));
        let (offset, inertia) = (Vector3::zeros(), [0.0; 6]);
        bulk.masses.insert(id, Conm2 { id, grid: id, cid: 0, mass, offset, inertia, span: span.clone() });
    }
    for pair in ids.windows(2) {
        let element = BeamElement {
            id: pair[0],
            property: first,
            grids: [pair[0], pair[1]],
            orientation: Orientation::Vector(*across),
            pins: [Vec::new(), Vec::new()],
            offsets: [Vector3::zeros(); 2],
            is_beam: true,
            span: span.clone(),
        };
        bulk.beams.insert(pair[0], element);
    }
    ids
}

/// Adds a grid in basic axes.
pub(crate) fn add_grid(bulk: &mut BulkData, id: u32, point: &Point3<f64>, span: &Span) {
    bulk.grids.insert(id, Grid { id, cp: 0, xyz: *point, cd: 0, ps: Vec::new(), span: span.clone() });
}

/// Ties grids rigidly to another.
pub(crate) fn tie(bulk: &mut BulkData, id: u32, independent: u32, dependent: Vec<u32>, span: &Span) {
    let components = vec![1, 2, 3, 4, 5, 6];
    bulk.rigid.insert(id, Rbe2 { id, independent, components, dependent, span: span.clone() });
}

fn property(id: u32, beam: &RoundBeam, span: &Span) -> BeamProperty {
    let (i, j) = (beam.ei_nm2 / E_PA, beam.gj_nm2 / G_PA);
    let station = |x_over_l| BeamStation {
        x_over_l,
        area: i / (RADIUS_M * RADIUS_M),
        i1: i,
        i2: i,
        i12: 0.0,
        j,
        nsm: 0.0,
    };
    BeamProperty {
        id,
        material: id,
        stations: vec![station(0.0), station(1.0)],
        shear_factors: [0.0; 2],
        nsi: [0.0; 2],
        nsm_offset: [[0.0; 2]; 2],
        neutral_axis: [[0.0; 2]; 2],
        is_beam: true,
        span: span.clone(),
    }
}
