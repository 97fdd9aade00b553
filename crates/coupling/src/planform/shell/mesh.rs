//! Grids and solids: a block of hexahedra from chord line to chord line, station to station, layer to layer.

use super::contour::{Contour, Side};
use super::settings::ShellSolid;
use super::{FIRST_MESH_GRID, Surface};
use crate::planform::Planform;
use crate::planform::cards::add_grid;
use crate::planform::panels::card_number;
use nalgebra::{Point3, Unit, Vector3};
use nastran::{
    BulkData, Coord, CoordDefinition, Expansion, InputError, Mat1, Psolid, SolidElement, SolidPoints,
    SolidShear, Span,
};

const FIRST_SOLID: u32 = 1_000_001;
/// PSOLID and MAT1 of the core.
const CORE: u32 = 1;
/// The system whose x axis is the elastic axis: plies' angles count from it.
pub(super) const AXIS_SYSTEM: u32 = 601;
/// Thinnest section the mesh is drawn on, over the chord.
const THINNEST: f64 = 1e-3;

/// The block's lines, and all that is needed to place them.
pub(super) struct Mesh<'wing> {
    pub(super) settings: &'wing ShellSolid,
    pub(super) planform: &'wing Planform,
    pub(super) contour: &'wing Contour,
    /// Span stations.
    pub(super) y_m: Vec<f64>,
    /// Chord lines, over the chord.
    pub(super) lines: Vec<f64>,
    /// Solids through the thickness.
    pub(super) layers: usize,
}

impl<'wing> Mesh<'wing> {
    pub(super) fn new(
        settings: &'wing ShellSolid,
        planform: &'wing Planform,
        contour: &'wing Contour,
    ) -> Result<Self, InputError> {
        let lines = settings.chord_lines(planform.boxes.chordwise);
        if let Some(&x) = lines.iter().find(|&&x| contour.thickness(x) < THINNEST) {
            let message = format!(
                "the section is {:.5} chords thick at {x:.4} of the chord, expected {THINNEST} at least on every \
                 chord line of the mesh",
                contour.thickness(x)
            );
            let help =
                "move `mesh: (edges_over_c: (.., ..))` away from the sharp edges, or correct the airfoil";
            return Err(InputError::in_file(&contour.path, message).with_help(help));
        }
        let y_m = subdivided(&planform.strip_edges_m(), settings.mesh.spanwise_per_strip);
        Ok(Self { settings, planform, contour, y_m, lines, layers: settings.mesh.thickness })
    }

    /// Cells along the chord.
    pub(super) fn chordwise(&self) -> usize {
        self.lines.len() - 1
    }

    /// Cells along the span.
    pub(super) fn spanwise(&self) -> usize {
        self.y_m.len() - 1
    }

    /// Number of the grid on chord line `line`, at `station`, in `layer` (0 is the lower surface).
    pub(super) fn grid(&self, line: usize, station: usize, layer: usize) -> u32 {
        FIRST_MESH_GRID + card_number((station * self.lines.len() + line) * (self.layers + 1) + layer)
    }

    /// A grid's place: layers divide the straight line from surface to surface equally.
    pub(super) fn point(&self, line: usize, station: usize, layer: usize) -> Point3<f64> {
        let x = self.lines[line];
        let share = layer as f64 / self.layers as f64;
        let (low, high) = (self.contour.height(Side::Lower, x), self.contour.height(Side::Upper, x));
        self.planform.section_point(self.y_m[station], x, low + share * (high - low))
    }

    /// The elastic axis, in the plane of the boxes.
    pub(super) fn axis_point(&self, y_m: f64) -> Point3<f64> {
        self.planform.point(y_m, self.settings.elastic_axis_over_c)
    }

    pub(super) fn add_grids(&self, bulk: &mut BulkData, span: &Span) {
        for station in 0..self.y_m.len() {
            for line in 0..self.lines.len() {
                for layer in 0..=self.layers {
                    add_grid(bulk, self.grid(line, station, layer), &self.point(line, station, layer), span);
                }
            }
        }
        bulk.coords.insert(AXIS_SYSTEM, self.axis_system(span));
    }

    /// x along the elastic axis to the tip, z up.
    fn axis_system(&self, span: &Span) -> Coord {
        let root = self.axis_point(0.0);
        let along = Unit::new_normalize(self.axis_point(self.planform.semispan_m) - root);
        let up = (Vector3::z() - along.into_inner() * along.z).normalize();
        let definition =
            CoordDefinition::Points { rid: 0, a: root, b: root + up, c: root + along.into_inner() };
        Coord { id: AXIS_SYSTEM, kind: nastran::CoordKind::Rectangular, definition, span: span.clone() }
    }

    /// CHEXA with its lower side first, PSOLID and MAT1. The density is raised by the share of the section that
    /// the block leaves out, so that the foam weighs what fills the contour.
    pub(super) fn add_core(&self, bulk: &mut BulkData, span: &Span) {
        let foam = self.settings.foam;
        let rho = foam.rho_kg_m3 * self.contour.area() / self.contour.area_between(&self.lines);
        let g = foam.e_pa / (2.0 * (1.0 + foam.nu));
        bulk.materials.insert(
            CORE,
            Mat1 {
                id: CORE,
                e: foam.e_pa,
                g,
                nu: foam.nu,
                rho,
                expansion: Expansion::default(),
                span: span.clone(),
            },
        );
        bulk.solid_properties.insert(
            CORE,
            Psolid {
                id: CORE,
                material: CORE,
                cordm: 0,
                points: SolidPoints::Usual,
                shear: SolidShear::Reduced,
                span: span.clone(),
            },
        );
        let cells =
            (0..self.spanwise()).flat_map(|station| (0..self.chordwise()).map(move |line| (station, line)));
        let mut id = FIRST_SOLID;
        for (station, line) in cells {
            for layer in 0..self.layers {
                let face = |layer| {
                    [
                        self.grid(line, station, layer),
                        self.grid(line + 1, station, layer),
                        self.grid(line + 1, station + 1, layer),
                        self.grid(line, station + 1, layer),
                    ]
                };
                let grids = [face(layer), face(layer + 1)].concat();
                bulk.solids.insert(
                    id,
                    SolidElement { id, property: CORE, grids, midsides: Vec::new(), span: span.clone() },
                );
                id += 1;
            }
        }
    }
}

impl ShellSolid {
    /// Chord lines: the boxes' edges subdivided, the outer ones moved off the sharp edges.
    pub(super) fn chord_lines(&self, boxes: usize) -> Vec<f64> {
        let mut edges: Vec<f64> = (0..=boxes).map(|edge| edge as f64 / boxes as f64).collect();
        (edges[0], edges[boxes]) = self.mesh.edges_over_c;
        subdivided(&edges, self.mesh.chordwise_per_box)
    }

    /// The chord lines the webs stand on.
    pub(super) fn web_lines(&self, lines: &[f64]) -> Vec<usize> {
        let distance = |line: usize, x: f64| (lines[line] - x).abs();
        let nearest = |&x: &f64| {
            (0..lines.len()).min_by(|&a, &b| distance(a, x).total_cmp(&distance(b, x))).unwrap_or(0)
        };
        self.webs_over_c.iter().map(nearest).collect()
    }

    pub(super) fn lies_on(&self, surface: Surface) -> bool {
        self.plies.iter().any(|ply| ply.on.contains(&surface))
    }
}

fn subdivided(edges: &[f64], parts: usize) -> Vec<f64> {
    let inner = edges
        .windows(2)
        .flat_map(|pair| (0..parts).map(|part| pair[0] + (pair[1] - pair[0]) * part as f64 / parts as f64));
    inner.chain(edges.last().copied()).collect()
}
