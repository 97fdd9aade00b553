//! Cards of general finite elements, as plain data: shells, solids, springs, scalar masses, their properties and
//! materials, rigid elements and constraint equations. One struct a card, every number as the deck gives it.

use crate::cards::Orientation;
use crate::source::Span;

/// The direction a shell's material axes are measured from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MaterialDirection {
    /// THETA: degrees from the side between the first two grids.
    AngleDeg(f64),
    /// MCID: the x axis of this coordinate system, projected onto the element.
    System(u32),
}

/// A shell element (CQUAD4 with four grids, CTRIA3 with three).
#[derive(Debug, Clone, PartialEq)]
pub struct ShellElement {
    /// Identification number.
    pub id: u32,
    /// Property (PSHELL, PCOMP or PCOMPG).
    pub property: u32,
    /// Corner grids in order around the element: three or four.
    pub grids: Vec<u32>,
    /// Where the material's axes come from.
    pub direction: MaterialDirection,
    /// ZOFFS: distance from the plane of the grids to the reference plane, along the element's normal.
    pub offset: f64,
    /// Where the card stands.
    pub span: Span,
}

/// A shell of one thickness (PSHELL).
#[derive(Debug, Clone, PartialEq)]
pub struct Pshell {
    /// Identification number.
    pub id: u32,
    /// MID1: membrane material; none means no membrane stiffness.
    pub membrane: Option<u32>,
    /// T.
    pub thickness: f64,
    /// MID2: bending material; none means no bending stiffness.
    pub bending: Option<u32>,
    /// 12I/T^3.
    pub bending_ratio: f64,
    /// MID3: transverse shear material; none means no shear flexibility.
    pub shear: Option<u32>,
    /// TS/T.
    pub shear_ratio: f64,
    /// NSM: non-structural mass per area.
    pub nsm: f64,
    /// MID4: material that couples membrane and bending.
    pub coupling: Option<u32>,
    /// Where the card stands.
    pub span: Span,
}

/// One ply of a laminate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ply {
    /// Material (MAT1, MAT2 or MAT8).
    pub material: u32,
    /// Thickness.
    pub thickness: f64,
    /// Angle of the fibres from the element's material direction, degrees.
    pub angle_deg: f64,
    /// GPLYID of PCOMPG, kept to be written again.
    pub global_id: Option<u32>,
}

/// A laminate (PCOMP, PCOMPG), plies from bottom to top.
#[derive(Debug, Clone, PartialEq)]
pub struct Pcomp {
    /// Identification number.
    pub id: u32,
    /// Z0: from the reference plane to the bottom surface; none means half the total thickness below.
    pub z0: Option<f64>,
    /// NSM: non-structural mass per area.
    pub nsm: f64,
    /// The plies the card lists. With `is_symmetric` these are the lower half only.
    pub plies: Vec<Ply>,
    /// LAM = SYM.
    pub is_symmetric: bool,
    /// True for PCOMPG.
    pub is_global: bool,
    /// Where the card stands.
    pub span: Span,
}

/// A solid element (CHEXA with eight grids, CPENTA with six, CTETRA with four).
#[derive(Debug, Clone, PartialEq)]
pub struct SolidElement {
    /// Identification number.
    pub id: u32,
    /// PSOLID.
    pub property: u32,
    /// Corner grids: eight, six or four.
    pub grids: Vec<u32>,
    /// Where the card stands.
    pub span: Span,
}

/// A solid's property (PSOLID).
#[derive(Debug, Clone, PartialEq)]
pub struct Psolid {
    /// Identification number.
    pub id: u32,
    /// MAT1 or MAT9.
    pub material: u32,
    /// CORDM: material axes; 0 is basic, a positive number a coordinate system. (-1, element axes, is refused for
    /// materials that are not isotropic.)
    pub cordm: i32,
    /// Where the card stands.
    pub span: Span,
}

/// A rod with axial and torsional stiffness (CROD).
#[derive(Debug, Clone, PartialEq)]
pub struct Crod {
    /// Identification number.
    pub id: u32,
    /// PROD.
    pub property: u32,
    /// End grids.
    pub grids: [u32; 2],
    /// Where the card stands.
    pub span: Span,
}

/// A rod's property (PROD).
#[derive(Debug, Clone, PartialEq)]
pub struct Prod {
    /// Identification number.
    pub id: u32,
    /// MAT1.
    pub material: u32,
    /// Area.
    pub area: f64,
    /// Torsional constant.
    pub j: f64,
    /// Non-structural mass per length.
    pub nsm: f64,
    /// Where the card stands.
    pub span: Span,
}

/// The axes of a bush.
#[derive(Debug, Clone, PartialEq)]
pub enum BushAxes {
    /// CID: a coordinate system; 0 is basic.
    System(u32),
    /// x from end A to end B, the plane x-y by an orientation vector.
    Oriented(Orientation),
    /// Neither is given: x from end A to end B, only K1 and K4 may be there.
    Line,
}

/// A generalised spring (CBUSH).
#[derive(Debug, Clone, PartialEq)]
pub struct Cbush {
    /// Identification number.
    pub id: u32,
    /// PBUSH.
    pub property: u32,
    /// End grids; without a second one the bush ends at the ground.
    pub grids: (u32, Option<u32>),
    /// Axes of the stiffnesses.
    pub axes: BushAxes,
    /// S: place of the spring between A (0) and B (1).
    pub location: f64,
    /// OCID and S1 to S3: place of the spring in a coordinate system, instead of S, from end A.
    pub offset: Option<(u32, [f64; 3])>,
    /// Where the card stands.
    pub span: Span,
}

/// A bush's property (PBUSH): six stiffnesses.
#[derive(Debug, Clone, PartialEq)]
pub struct Pbush {
    /// Identification number.
    pub id: u32,
    /// K1 to K6.
    pub stiffness: [f64; 6],
    /// Where the card stands.
    pub span: Span,
}

/// One motion of a grid: (grid, component 1 to 6).
pub type Motion = (u32, u8);

/// What a scalar element's number is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ScalarValue {
    /// Given on the element (CELAS2, CMASS2).
    Given(f64),
    /// Given by a property (CELAS1: PELAS, CMASS1: PMASS).
    Property(u32),
}

/// A scalar spring (CELAS1, CELAS2) or mass (CMASS1, CMASS2) between two motions, or a motion and the ground.
#[derive(Debug, Clone, PartialEq)]
pub struct ScalarElement {
    /// Identification number.
    pub id: u32,
    /// Stiffness or mass.
    pub value: ScalarValue,
    /// The motions at both ends; none is the ground.
    pub ends: [Option<Motion>; 2],
    /// Where the card stands.
    pub span: Span,
}

/// The value of a scalar property (PELAS K1, PMASS M1).
#[derive(Debug, Clone, PartialEq)]
pub struct ScalarProperty {
    /// Identification number.
    pub id: u32,
    /// Stiffness or mass.
    pub value: f64,
    /// Where the card stands.
    pub span: Span,
}

/// A general element (GENEL).
#[derive(Debug, Clone, PartialEq)]
pub struct Genel {
    /// Identification number.
    pub id: u32,
    /// Motions the matrix belongs to.
    pub ui: Vec<Motion>,
    /// Motions of the support.
    pub ud: Vec<Motion>,
    /// True for a flexibility (Z), false for a stiffness (K).
    pub is_flexibility: bool,
    /// The matrix, square and symmetric, of the size of `ui`.
    pub matrix: Vec<Vec<f64>>,
    /// S: rigid motion of each of `ui` by each of `ud`; empty if not given.
    pub s: Vec<Vec<f64>>,
    /// Where the card stands.
    pub span: Span,
}

/// A mass given as a 6 x 6 matrix (CONM1).
#[derive(Debug, Clone, PartialEq)]
pub struct Conm1 {
    /// Identification number.
    pub id: u32,
    /// Grid.
    pub grid: u32,
    /// Coordinate system of the matrix; 0 is basic.
    pub cid: u32,
    /// The matrix, symmetric.
    pub mass: [[f64; 6]; 6],
    /// Where the card stands.
    pub span: Span,
}

/// A rigid bar (RBAR).
#[derive(Debug, Clone, PartialEq)]
pub struct Rbar {
    /// Identification number.
    pub id: u32,
    /// End grids.
    pub grids: [u32; 2],
    /// CNA, CNB: independent components at the ends, six in all.
    pub independent: [Vec<u8>; 2],
    /// CMA, CMB: dependent components at the ends; both empty means all that are not independent.
    pub dependent: [Vec<u8>; 2],
    /// Where the card stands.
    pub span: Span,
}

/// One group of an RBE3: weight, components, grids.
#[derive(Debug, Clone, PartialEq)]
pub struct Rbe3Group {
    /// WT.
    pub weight: f64,
    /// C: components, digits 1 to 6.
    pub components: Vec<u8>,
    /// G.
    pub grids: Vec<u32>,
}

/// A motion that is the weighted mean of others (RBE3).
#[derive(Debug, Clone, PartialEq)]
pub struct Rbe3 {
    /// Identification number.
    pub id: u32,
    /// REFGRID.
    pub reference: u32,
    /// REFC: its components that follow.
    pub components: Vec<u8>,
    /// What they follow.
    pub groups: Vec<Rbe3Group>,
    /// UM: the motions to be made dependent instead of the reference's, grid and components.
    pub um: Vec<(u32, Vec<u8>)>,
    /// Where the card stands.
    pub span: Span,
}

/// A constraint equation (MPC): the sum of coefficient times motion is zero; the first motion is dependent.
#[derive(Debug, Clone, PartialEq)]
pub struct Mpc {
    /// Set identification.
    pub set: u32,
    /// Motion and coefficient.
    pub terms: Vec<(Motion, f64)>,
    /// Where the card stands.
    pub span: Span,
}

/// An anisotropic plane material (MAT2).
#[derive(Debug, Clone, PartialEq)]
pub struct Mat2 {
    /// Identification number.
    pub id: u32,
    /// G11, G12, G13, G22, G23, G33.
    pub g: [f64; 6],
    /// Density.
    pub rho: f64,
    /// Where the card stands.
    pub span: Span,
}

/// An orthotropic plane material (MAT8).
#[derive(Debug, Clone, PartialEq)]
pub struct Mat8 {
    /// Identification number.
    pub id: u32,
    /// E1, along the fibres.
    pub e1: f64,
    /// E2, across.
    pub e2: f64,
    /// NU12.
    pub nu12: f64,
    /// G12.
    pub g12: f64,
    /// G1Z; none or zero means no shear flexibility in that plane.
    pub g1z: f64,
    /// G2Z.
    pub g2z: f64,
    /// Density.
    pub rho: f64,
    /// Where the card stands.
    pub span: Span,
}

/// An anisotropic solid material (MAT9), stresses x, y, z, xy, yz, zx.
#[derive(Debug, Clone, PartialEq)]
pub struct Mat9 {
    /// Identification number.
    pub id: u32,
    /// The upper triangle of the 6 x 6 matrix, row by row: G11, G12, ... G16, G22, ... G66.
    pub g: [f64; 21],
    /// Density.
    pub rho: f64,
    /// Where the card stands.
    pub span: Span,
}

/// The way a surface spline works.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SplineKind {
    /// SPLINE1: infinite plate.
    Plate,
    /// SPLINE2: beam along the y axis of a system; DTOR is the ratio of bending to torsional flexibility.
    Beam {
        /// CID.
        system: u32,
        /// DTOR.
        torsional_ratio: f64,
        /// DTHX, DTHY: flexibility with which rotations about the spline's x and y axes are attached; 0 rigidly,
        /// -1 not at all.
        attachment: [f64; 2],
    },
}

/// A spline from a set of grids to boxes: a range (SPLINE1, SPLINE2) or a list (SPLINE4, SPLINE5).
#[derive(Debug, Clone, PartialEq)]
pub struct SplineCard {
    /// Identification number.
    pub id: u32,
    /// CAERO1 whose boxes follow.
    pub panel: u32,
    /// First and last box; twice the panel's number if there is a list.
    pub boxes: (u32, u32),
    /// AELIST of the boxes.
    pub list: Option<u32>,
    /// SET1 of the grids.
    pub set: u32,
    /// Plate or beam.
    pub kind: SplineKind,
    /// Where the card stands.
    pub span: Span,
}
