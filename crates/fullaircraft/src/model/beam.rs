//! Straight beams of tail and fuselage as cards: grids, CBEAM, PBEAM, MAT1 and the masses of half an element each way.

use crate::aircraft::file::RoundBeam;
use coupling::planform::cards::{self, SlenderSection};
use nalgebra::{Point3, Vector3};
use nastran::{BulkData, Span};

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
    cards::add_material(bulk, first, E_PA, G_PA, span);
    cards::add_section(bulk, first, first, section(beam), span);
    for (at, (&id, point)) in ids.iter().zip(points).enumerate() {
        cards::add_grid(bulk, id, point, span);
        let length =
            |a: usize, b: usize| points.get(a).zip(points.get(b)).map_or(0.0, |(a, b)| (b - a).norm());
        let before = if at == 0 { 0.0 } else { length(at - 1, at) };
        let mass = beam.mass_kg_m * 0.5 * (before + length(at, at + 1));
        cards::add_mass(bulk, id, id, mass, span);
    }
    for pair in ids.windows(2) {
        cards::add_beam(bulk, pair[0], first, [pair[0], pair[1]], *across, span);
    }
    ids
}

fn section(beam: &RoundBeam) -> SlenderSection {
    let (i, j) = (beam.ei_nm2 / E_PA, beam.gj_nm2 / G_PA);
    SlenderSection { area: i / (RADIUS_M * RADIUS_M), i1: i, i2: i, j }
}
