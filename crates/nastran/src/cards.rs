//! The cards a deck is made of, as plain data: one struct a card, every number as the deck gives it.
//!
//! Numbers are in the deck's own units (SI for wingroot's wings) and, for points, in the coordinate system the
//! card names; [`crate::geometry`] resolves them to the basic system.

pub use crate::bulk_data::BulkData;
use crate::source::Span;

/// A grid point (GRID).
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    /// Identification number.
    pub id: u32,
    /// Coordinate system of `xyz`; 0 is basic.
    pub cp: u32,
    /// Coordinates in `cp` (as its [`CoordKind`] says).
    pub xyz: [f64; 3],
    /// Displacement coordinate system; 0 is basic.
    pub cd: u32,
    /// Permanently fixed components, digits 1 to 6.
    pub ps: Vec<u8>,
    /// Where the card stands.
    pub span: Span,
}

/// What the three coordinates of a system are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum CoordKind {
    /// x, y, z (CORD1R, CORD2R).
    #[default]
    Rectangular,
    /// r, theta in degrees from x, z (CORD1C, CORD2C).
    Cylindrical,
    /// r, theta in degrees from z, phi in degrees from x about z (CORD1S, CORD2S).
    Spherical,
}

/// How a coordinate system is given.
#[derive(Debug, Clone, PartialEq)]
pub enum CoordDefinition {
    /// CORD2R, CORD2C, CORD2S: origin, a point on the z axis, a point in the xz plane, all in system `rid`.
    Points {
        /// Reference system.
        rid: u32,
        /// Origin.
        a: [f64; 3],
        /// On the z axis.
        b: [f64; 3],
        /// In the xz plane.
        c: [f64; 3],
    },
    /// CORD1R, CORD1C, CORD1S: the same three points given by grids.
    Grids([u32; 3]),
}

/// A coordinate system (CORD1R, CORD1C, CORD1S, CORD2R, CORD2C, CORD2S).
#[derive(Debug, Clone, PartialEq)]
pub struct Coord {
    /// Identification number.
    pub id: u32,
    /// Rectangular, cylindrical or spherical.
    pub kind: CoordKind,
    /// The three points that define it.
    pub definition: CoordDefinition,
    /// Where the card stands.
    pub span: Span,
}

/// A bar or beam element (CBAR, CBEAM).
#[derive(Debug, Clone, PartialEq)]
pub struct BeamElement {
    /// Identification number.
    pub id: u32,
    /// Property (PBAR or PBEAM).
    pub property: u32,
    /// End grids A and B.
    pub grids: [u32; 2],
    /// Orientation: a vector in end A's displacement system, or a grid.
    pub orientation: Orientation,
    /// Pin flags at ends A and B, digits 1 to 6.
    pub pins: [Vec<u8>; 2],
    /// Offset vectors from grid to element end, in the grids' displacement systems.
    pub offsets: [[f64; 3]; 2],
    /// True for CBEAM, false for CBAR.
    pub is_beam: bool,
    /// Where the card stands.
    pub span: Span,
}

/// The vector that, with the element axis, spans plane 1.
#[derive(Debug, Clone, PartialEq)]
pub enum Orientation {
    /// X1, X2, X3.
    Vector([f64; 3]),
    /// G0.
    Grid(u32),
}

/// One station of a beam section. Plane 1 is spanned by the element axis x and the orientation vector (element y).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BeamStation {
    /// Position x/L along the element.
    pub x_over_l: f64,
    /// Area.
    pub area: f64,
    /// I1 = Izz: bending in plane 1 (x-y).
    pub i1: f64,
    /// I2 = Iyy: bending in plane 2 (x-z).
    pub i2: f64,
    /// I12.
    pub i12: f64,
    /// Torsional constant J.
    pub j: f64,
    /// Non-structural mass per unit length.
    pub nsm: f64,
}

/// A bar or beam property (PBAR, PBEAM).
#[derive(Debug, Clone, PartialEq)]
pub struct BeamProperty {
    /// Identification number.
    pub id: u32,
    /// MAT1.
    pub material: u32,
    /// Stations in ascending x/L, at least one; PBAR has one, PBEAM at least ends A (0) and B (1).
    pub stations: Vec<BeamStation>,
    /// Shear stiffness factors K1, K2; zero means no shear flexibility.
    pub shear_factors: [f64; 2],
    /// Non-structural mass moment of inertia per length at ends A and B (PBEAM NSI).
    pub nsi: [f64; 2],
    /// Non-structural mass centre offsets (y, z) at ends A and B (PBEAM M1, M2).
    pub nsm_offset: [[f64; 2]; 2],
    /// Neutral axis offsets (y, z) from the shear centre at ends A and B (PBEAM N1, N2).
    pub neutral_axis: [[f64; 2]; 2],
    /// True for PBEAM.
    pub is_beam: bool,
    /// Where the card stands.
    pub span: Span,
}

/// An isotropic material (MAT1).
#[derive(Debug, Clone, PartialEq)]
pub struct Mat1 {
    /// Identification number.
    pub id: u32,
    /// Young's modulus.
    pub e: f64,
    /// Shear modulus (E/2(1+nu) if the field is blank).
    pub g: f64,
    /// Poisson's ratio.
    pub nu: f64,
    /// Density.
    pub rho: f64,
    /// Where the card stands.
    pub span: Span,
}

/// A concentrated mass (CONM2).
#[derive(Debug, Clone, PartialEq)]
pub struct Conm2 {
    /// Identification number.
    pub id: u32,
    /// Grid.
    pub grid: u32,
    /// Coordinate system of offset and inertia; -1 means the offset is a point in the basic system.
    pub cid: i32,
    /// Mass.
    pub mass: f64,
    /// Offset from the grid to the centre of gravity.
    pub offset: [f64; 3],
    /// I11, I21, I22, I31, I32, I33 about the centre of gravity.
    pub inertia: [f64; 6],
    /// Where the card stands.
    pub span: Span,
}

/// A rigid element (RBE2).
#[derive(Debug, Clone, PartialEq)]
pub struct Rbe2 {
    /// Identification number.
    pub id: u32,
    /// Independent grid.
    pub independent: u32,
    /// Dependent components, digits 1 to 6.
    pub components: Vec<u8>,
    /// Dependent grids.
    pub dependent: Vec<u32>,
    /// Where the card stands.
    pub span: Span,
}

/// Clamped components of grids (SPC1).
#[derive(Debug, Clone, PartialEq)]
pub struct Spc1 {
    /// Set identification.
    pub set: u32,
    /// Components, digits 1 to 6.
    pub components: Vec<u8>,
    /// Grids.
    pub grids: Vec<u32>,
    /// Where the card stands.
    pub span: Span,
}

/// Divisions of a panel: a number of equal ones, or the boundaries listed on an AEFACT.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Divisions {
    /// NSPAN or NCHORD.
    Equal(u32),
    /// LSPAN or LCHORD: identification of an AEFACT with fractions from 0 to 1.
    Aefact(u32),
}

/// A lifting panel (CAERO1).
#[derive(Debug, Clone, PartialEq)]
pub struct Caero1 {
    /// Identification number; boxes are numbered from it.
    pub id: u32,
    /// PAERO1.
    pub property: u32,
    /// Coordinate system of the points.
    pub cp: u32,
    /// Spanwise divisions.
    pub span_divisions: Divisions,
    /// Chordwise divisions.
    pub chord_divisions: Divisions,
    /// Interference group.
    pub group: u32,
    /// Leading edge at side 1.
    pub point_1: [f64; 3],
    /// Chord at side 1, along x of the aerodynamic system.
    pub chord_1: f64,
    /// Leading edge at side 4.
    pub point_4: [f64; 3],
    /// Chord at side 4.
    pub chord_4: f64,
    /// Where the card stands.
    pub span: Span,
}

/// A list of numbers (AEFACT), in the card's order.
#[derive(Debug, Clone, PartialEq)]
pub struct Aefact {
    /// Identification number.
    pub id: u32,
    /// The numbers.
    pub values: Vec<f64>,
    /// Where the card stands.
    pub span: Span,
}

/// A control surface (AESURF): one or two hinge systems, each with its box list.
#[derive(Debug, Clone, PartialEq)]
pub struct Aesurf {
    /// Identification number.
    pub id: u32,
    /// Label.
    pub label: String,
    /// (CID, AELIST) pairs; the hinge is the y axis of CID.
    pub parts: Vec<(u32, u32)>,
    /// EFF.
    pub effectiveness: f64,
    /// Where the card stands.
    pub span: Span,
}

/// A list of boxes (AELIST), THRU expanded.
#[derive(Debug, Clone, PartialEq)]
pub struct Aelist {
    /// Identification number.
    pub id: u32,
    /// Box identification numbers.
    pub boxes: Vec<u32>,
    /// Where the card stands.
    pub span: Span,
}

/// A list of grids (SET1), THRU expanded.
#[derive(Debug, Clone, PartialEq)]
pub struct Set1 {
    /// Identification number.
    pub id: u32,
    /// Identification numbers.
    pub ids: Vec<u32>,
    /// Where the card stands.
    pub span: Span,
}

/// A monitoring station (MONPNT1, MONPNT3).
#[derive(Debug, Clone, PartialEq)]
pub struct MonitorPoint {
    /// NAME.
    pub name: String,
    /// LABEL.
    pub label: String,
    /// Component digits of the axes.
    pub axes: Vec<u8>,
    /// COMP of MONPNT1 (an AECOMP), GRIDSET of MONPNT3.
    pub set: String,
    /// Coordinate system of the point.
    pub cp: u32,
    /// The point.
    pub xyz: [f64; 3],
    /// Output coordinate system.
    pub cd: u32,
    /// True for MONPNT3 (structural grid point forces), false for MONPNT1.
    pub is_structural: bool,
    /// Where the card stands.
    pub span: Span,
}
