//! A parametric wing: a trapezoidal half wing with a swept beam, or shells around a solid core, turned into the same
//! [`BulkData`] a deck gives.
//!
//! Axes: x aft, y to the right tip, z up; the root leading edge is at (`root_leading_edge_x_m`, 0, 0). Spans are
//! measured along y. The straight quarter-chord line carries the sweep, so the leading edge of the chord at y is
//! `x_le(y) = x_root + c_root/4 + y tan(sweep) - c(y)/4`.
//!
//! Numbering: wing panel and first box 100001, fairing 200001, control surfaces (AESURF, AELIST, CORD2R) from
//! 501, grids of the elastic axis from 1001, sensors from 3001, point masses from 4001, beams from 2001.
//! SET1 1 lists the axis grids (the spline's), SET1 2 the grid that holds the root. The shells' own numbers are in
//! `shell`.

mod beam;
pub mod cards;
pub(crate) mod check;
mod controls;
mod distribution;
mod mesh;
mod panels;
mod point_mass;
mod shell;
mod structure;
mod warnings;

pub use beam::BeamStructure;
pub(crate) use check::Fault;
pub use mesh::Mesh;
pub use point_mass::PointMass;
pub use shell::{
    BALANCE_BUSH, BALANCE_GRID, Band, FIRST_MESH_GRID, Foam, LineMass, MeshCounts, MeshSettings, PlyMaterial,
    PlySettings, Profile, ROOT_GRID, SectionIntegrals, ShellSolid, Surface,
};
pub use structure::Structure;

use nalgebra::Point3;
use nastran::{BulkData, InputError, Span};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// First box of the wing panel, and the panel's own number.
pub const WING_PANEL: u32 = 100_001;
/// First box of the fairing panel, and the panel's own number.
pub const FAIRING_PANEL: u32 = 200_001;
/// The root's grid on the elastic axis; the others count up from it.
pub const FIRST_AXIS_GRID: u32 = 1001;
/// First grid of a sensor; the others count up in the file's order.
pub const FIRST_SENSOR_GRID: u32 = 3001;
/// First grid of a point mass.
pub const FIRST_MASS_GRID: u32 = 4001;
/// SET1 with the grids of the elastic axis.
pub const AXIS_SET: u32 = 1;
/// SET1 with the grid alone that holds the root.
pub const ROOT_SET: u32 = 2;

/// How the wing is held, which decides what belongs to the model besides the wing itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mount {
    /// On the balance of a wind tunnel: fairing present, root clamped, root monitor point.
    Tunnel,
    /// As one half of an aircraft: wing alone and free.
    Aircraft,
}

/// A trapezoidal half wing. Angles in degrees as in the file; lengths in metres.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Planform {
    /// From root to tip along y.
    pub semispan_m: f64,
    /// Chord at the root, along x.
    pub root_chord_m: f64,
    /// Chord at the tip, along x.
    pub tip_chord_m: f64,
    /// Sweep of the quarter-chord line in the x-y plane, aft positive.
    pub quarter_chord_sweep_deg: f64,
    /// Dihedral, tip up positive: z = y tan(dihedral).
    #[serde(default)]
    pub dihedral_deg: f64,
    /// Twist at root and tip, nose up positive, linear between; boxes stay flat and have it as incidence, the
    /// sections of a shell-and-solid wing are turned by it.
    #[serde(default)]
    pub twist_deg: (f64, f64),
    /// x of the leading edge at the root.
    #[serde(default)]
    pub root_leading_edge_x_m: f64,
    /// Coordinate file of the section, relative to the wing file; `None` is an uncambered wing.
    #[serde(default)]
    pub airfoil: Option<String>,
    /// The vortex lattice.
    pub boxes: Boxes,
    /// Boxes inboard of the root that disturb the flow but do not belong to the wing.
    #[serde(default)]
    pub fairing: Option<Fairing>,
    /// Trailing edge control surfaces.
    #[serde(default)]
    pub controls: Vec<Control>,
    /// What it is made of; `None` is a rigid wing.
    #[serde(default)]
    pub structure: Option<Structure>,
}

/// Numbers of boxes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Boxes {
    /// Boxes along the chord, equally long.
    pub chordwise: usize,
    /// Strips along the span, equally wide unless `strip_edges` says otherwise.
    pub spanwise: usize,
    /// Edges of the strips as fractions of the half span: `spanwise + 1` ascending numbers from 0 to 1.
    #[serde(default)]
    pub strip_edges: Option<Vec<f64>>,
}

/// The fairing between wing root and tunnel wall: a rectangle with the root chord, from y = -width to 0.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Fairing {
    /// Strips along y.
    pub strips: usize,
    /// Width along y.
    pub width_m: f64,
    /// Whether it has the wing's section and root twist (a stub of the wing) or none (a plain body).
    #[serde(default = "yes")]
    pub camber: bool,
}

/// A trailing edge flap over whole strips and whole boxes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Control {
    /// At most eight letters and digits, as an AESURF label.
    pub name: String,
    /// First and last strip, counted from 1 at the root, both included.
    pub strips: (usize, usize),
    /// How many boxes of a strip belong to it, counted from the trailing edge.
    pub chord_boxes: usize,
    /// Largest deflection either way; left out: not known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub limit_deg: Option<f64>,
}

fn yes() -> bool {
    true
}

impl Planform {
    /// Chord at `y_m`; inboard of the root the root chord.
    pub fn chord_m(&self, y_m: f64) -> f64 {
        let fraction = (y_m / self.semispan_m).max(0.0);
        self.root_chord_m + fraction * (self.tip_chord_m - self.root_chord_m)
    }

    /// The point of the wing's plane at span station `y_m` and chord fraction `x_over_c`.
    pub fn point(&self, y_m: f64, x_over_c: f64) -> Point3<f64> {
        let outboard = y_m.max(0.0);
        let quarter = self.root_leading_edge_x_m
            + 0.25 * self.root_chord_m
            + outboard * self.quarter_chord_sweep_deg.to_radians().tan();
        let x = quarter + (x_over_c - 0.25) * self.chord_m(y_m);
        Point3::new(x, y_m, outboard * self.dihedral_deg.to_radians().tan())
    }

    /// Projected area of the half wing without fairing.
    pub fn area_m2(&self) -> f64 {
        0.5 * (self.root_chord_m + self.tip_chord_m) * self.semispan_m
    }

    /// Mean chord, area over span.
    pub fn mean_chord_m(&self) -> f64 {
        0.5 * (self.root_chord_m + self.tip_chord_m)
    }

    /// Span squared over area of the half wing by itself.
    pub fn half_wing_aspect_ratio(&self) -> f64 {
        self.semispan_m.powi(2) / self.area_m2()
    }

    /// Span squared over area of both halves together, twice the half wing's.
    pub fn full_wing_aspect_ratio(&self) -> f64 {
        2.0 * self.half_wing_aspect_ratio()
    }

    /// Edges of the strips as y, `spanwise + 1` of them.
    pub fn strip_edges_m(&self) -> Vec<f64> {
        self.strip_fractions().into_iter().map(|fraction| fraction * self.semispan_m).collect()
    }

    /// Names and grids of the sensors, in the file's order.
    pub fn sensor_grids(&self) -> Vec<(String, u32)> {
        self.structure.as_ref().map_or_else(Vec::new, Structure::sensor_grids)
    }

    /// The wing as bulk data; file names are relative to `folder`. The balance, which only a shell-and-solid wing
    /// has as an element of its own, is at the root's quarter chord.
    ///
    /// # Errors
    /// If a number makes no sense or a file it names is missing or wrong.
    pub fn bulk(&self, folder: &Path, mount: Mount) -> Result<BulkData, InputError> {
        self.bulk_on_balance(folder, mount, &self.point(0.0, 0.25))
    }

    /// As [`Planform::bulk`], held at a balance point.
    ///
    /// # Errors
    /// As [`Planform::bulk`].
    pub fn bulk_on_balance(
        &self,
        folder: &Path,
        mount: Mount,
        balance: &Point3<f64>,
    ) -> Result<BulkData, InputError> {
        let span = Span::generated("parametric wing");
        self.check().map_err(|fault| fault.at(&span))?;
        let mut bulk = BulkData::default();
        self.add_panels(&mut bulk, folder, mount, &span)?;
        self.add_controls(&mut bulk, &span);
        if let Some(structure) = &self.structure {
            structure.add_to(&mut bulk, self, folder, mount, balance)?;
        }
        Ok(bulk)
    }

    fn strip_fractions(&self) -> Vec<f64> {
        let count = self.boxes.spanwise;
        self.boxes
            .strip_edges
            .clone()
            .unwrap_or_else(|| (0..=count).map(|edge| edge as f64 / count as f64).collect())
    }
}
