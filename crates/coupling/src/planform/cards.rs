//! Cards that made models have in common: grids, rigid ties, lumped masses and slender beams, all in basic axes.

use nalgebra::{Point3, Vector3};
use nastran::{
    BeamElement, BeamProperty, BeamStation, BulkData, Conm2, Expansion, Grid, Mat1, Orientation, Rbe2, Span,
};

/// A free grid.
pub fn add_grid(bulk: &mut BulkData, id: u32, point: &Point3<f64>, span: &Span) {
    bulk.grids.insert(id, Grid { id, cp: 0, xyz: *point, cd: 0, ps: Vec::new(), span: span.clone() });
}

/// Grids that move as one with another.
pub fn add_tie(bulk: &mut BulkData, id: u32, independent: u32, dependent: Vec<u32>, span: &Span) {
    let components = vec![1, 2, 3, 4, 5, 6];
    bulk.rigid.insert(id, Rbe2 { id, independent, components, dependent, span: span.clone() });
}

/// A mass (kg) at a grid.
pub fn add_mass(bulk: &mut BulkData, id: u32, grid: u32, mass: f64, span: &Span) {
    let (offset, inertia) = (Vector3::zeros(), [0.0; 6]);
    bulk.masses.insert(id, Conm2 { id, grid, cid: 0, mass, offset, inertia, span: span.clone() });
}

/// A material by its moduli, Pa, without mass.
pub fn add_material(bulk: &mut BulkData, id: u32, e: f64, g: f64, span: &Span) {
    let nu = e / (2.0 * g) - 1.0;
    bulk.materials
        .insert(id, Mat1 { id, e, g, nu, rho: 0.0, expansion: Expansion::default(), span: span.clone() });
}

/// The section of a slender beam: area (m²), second moments of plane 1 and 2, torsion constant (m⁴).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlenderSection {
    /// Area.
    pub area: f64,
    /// Plane 1.
    pub i1: f64,
    /// Plane 2.
    pub i2: f64,
    /// Torsion.
    pub j: f64,
}

/// A PBEAM of one section all along, without shear flexibility.
pub fn add_section(bulk: &mut BulkData, id: u32, material: u32, section: SlenderSection, span: &Span) {
    let SlenderSection { area, i1, i2, j } = section;
    let station = |x_over_l| BeamStation { x_over_l, area, i1, i2, i12: 0.0, j, nsm: 0.0 };
    let card = BeamProperty {
        id,
        material,
        stations: vec![station(0.0), station(1.0)],
        shear_factors: [0.0; 2],
        nsi: [0.0; 2],
        nsm_offset: [[0.0; 2]; 2],
        neutral_axis: [[0.0; 2]; 2],
        is_beam: true,
        span: span.clone(),
    };
    bulk.beam_properties.insert(id, card);
}

/// A CBEAM between two grids; `orientation` lies in plane 1.
pub fn add_beam(
    bulk: &mut BulkData,
    id: u32,
    property: u32,
    grids: [u32; 2],
    orientation: Vector3<f64>,
    span: &Span,
) {
    let card = BeamElement {
        id,
        property,
        grids,
        orientation: Orientation::Vector(orientation),
        pins: [Vec::new(), Vec::new()],
        offsets: [Vector3::zeros(); 2],
        offt: nastran::Offt::default(),
        is_beam: true,
        span: span.clone(),
    };
    bulk.beams.insert(id, card);
}
