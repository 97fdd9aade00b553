//! Shells (CQUAD4, CTRIA3, CTRIAR, CQUADR): flat elements of first-order shear theory with six motions a node.
//!
//! The element's plane goes through its corners' middle, normal to the cross product of its diagonals. Corners of a warped
//! quadrilateral stand off that plane; its membrane strains are those of a shallow shell. With an offset, rigid arms along
//! the normal connect the grids to the reference surface. Over the plane:
//!
//! - transverse shear is tied at the sides (MITC4, Dvorkin and Bathe 1984; MITC3, Lee and Bathe 2004), so thin shells do
//!   not lock;
//! - a quadrilateral's membrane has four incompatible modes with Taylor's correction (Taylor, Beresford and Wilson
//!   1976), condensed, so bending in its plane does not lock and the patch test holds; a CTRIA3's membrane strain is
//!   constant, as Nastran's, a CTRIAR's is bent by its corners' rotations (Felippa 2003), a CQUADR's is the mean of two pairs
//!   of CTRIAR;
//! - rotation about the normal is tied to the membrane's own rotation (Hughes and Brezzi 1989) by a weak stiffness, but
//!   in a CTRIAR, whose membrane has it, and where the rotations about the normal of all corners are held.
//!
//! Those of users' decks have Nastran's bending, transverse shear and tie ([`Shell::as_nastran`]): `nastran_quad.rs`, `nastran_triangle.rs`, `residual.rs`.
//! Local motions a node: u, v, w, rotations about x, y, z. Strains: u,x; v,y; u,y + v,x. Curvatures: ry,x; -rx,y;
//! ry,y - rx,x. Transverse shears: w,x + ry; w,y - rx.

mod andes;
mod curved;
mod element;
mod frame;
mod grid_normals;
mod nastran_quad;
mod nastran_triangle;
mod point;
mod quad;
mod residual;
mod side_shears;
mod strains;
mod triangle;

pub use curved::{CurvedPlace, CurvedShell, SectionAxis};
pub use strains::ShellStrains;

use crate::element::Element as _;
use crate::laminate::ShellSection;
use frame::Frame;
use grid_normals::bending_motions;
use nalgebra::{DMatrix, DVector, Matrix2, Matrix3, Matrix6, Point3, SMatrix, SVector, Vector3, Vector6};
use nastran::{InputError, Span};
use nastran_quad::NastranQuad;
use nastran_triangle::shear_stiffness;
use point::{Point, modes_of, stiffness, strains_at, tie_stiffness};
use residual::Residual;
use std::sync::Arc;

/// Stiffness of the rotation about the normal, in units of the membrane's shear stiffness (Hughes and Brezzi take one).
/// Less, and the kinks between flat elements turn for nothing, however fine the mesh: MacNeal and Harder's twisted
/// beam is 32 % too soft at a thousandth. More stiffens curved shells: their hemisphere is 4 % too stiff at one with
/// 16 x 16 elements. A tenth keeps both within 2 %.
const DRILLING: f64 = 0.1;

/// The part in the element's plane below which a grid's normal is the element's own.
const UPRIGHT: f64 = 1e-12;

/// A shell element.
#[derive(Debug, Clone)]
pub struct Shell {
    id: u32,
    nodes: Vec<usize>,
    /// Rows are the element's x, y and normal in basic axes.
    axes: Matrix3<f64>,
    /// Corners: x, y and height above the element's plane.
    corners: Vec<Point3<f64>>,
    /// From each grid along the normal to the reference surface.
    offset_m: f64,
    section: Arc<ShellSection>,
    /// From the element's x axis to the section's.
    angle_rad: f64,
    /// The membrane is bent by rotations about the normal ([`Self::with_drilling`]).
    drills: bool,
    /// Stiffness of the rotation about the normal against the membrane's own, in units of the membrane's shear stiffness.
    tie: f64,
    /// Bending, shear and tie are Nastran's ([`Self::as_nastran`]).
    is_nastran: bool,
    /// Thickness at the corners in units of the section's; empty if it is the section's everywhere.
    thickness: Vec<f64>,
    /// Of the corners' grids ([`Self::with_grid_normals`]), in the element's axes; empty if none has one.
    normals: Vec<Option<Vector3<f64>>>,
    /// The membranes of a quadrilateral that drills, by [`CUTS`]; else none.
    triangles: Vec<Shell>,
}

/// Corners of the triangles that the two diagonals cut a quadrilateral into.
const CUTS: [[usize; 3]; 4] = [[0, 1, 2], [2, 3, 0], [0, 1, 3], [1, 2, 3]];

impl Shell {
    /// A shell between the nodes at `points` (three or four), its reference surface `offset_m` off the grids along
    /// the normal. The section's x axis is turned by `angle_rad` from the side between the first two corners.
    ///
    /// # Errors
    /// If the corners do not span an area, or a corner's angle is 180 degrees or more.
    pub fn new(
        id: u32,
        nodes: Vec<usize>,
        points: &[Point3<f64>],
        offset_m: f64,
        section: Arc<ShellSection>,
        angle_rad: f64,
        span: &Span,
    ) -> Result<Self, InputError> {
        let frame = Frame::of(points).filter(Frame::is_convex);
        let Some(frame) = frame else {
            let name = if points.len() == 4 { "CQUAD4" } else { "CTRIA3" };
            let message = format!("{name} {id} has no area, or a corner of 180 degrees or more");
            let help = "give its grids in order around the element, each once";
            return Err(InputError::at(span, message).with_help(help));
        };
        Ok(Self {
            id,
            nodes,
            axes: frame.axes,
            corners: frame.corners,
            offset_m,
            section,
            angle_rad,
            drills: false,
            tie: DRILLING,
            is_nastran: false,
            thickness: Vec::new(),
            normals: Vec::new(),
            triangles: Vec::new(),
        })
    }

    /// With the corners' rotations about the normal as motions of the membrane (CTRIAR, CQUADR), which then bends in its plane: a triangle's own,
    /// a quadrilateral's as the mean of its two cuts into triangles. A quadrilateral whose section couples membrane and bending, or one of whose
    /// triangles is degenerate, stays as it is. Its rotations about the normal being its own, it has no use for normals of its grids.
    #[must_use]
    pub fn with_drilling(self) -> Self {
        if self.corners.len() == 3 {
            return Self { drills: true, normals: Vec::new(), ..self };
        }
        let triangles: Option<Vec<_>> = CUTS.iter().map(|corners| self.membrane_of(*corners)).collect();
        match triangles {
            Some(triangles) if !self.section.is_coupled() => {
                Self { drills: true, triangles, normals: Vec::new(), ..self }
            }
            _ => self,
        }
    }

    /// The membrane of three corners, with drilling rotations.
    fn membrane_of(&self, corners: [usize; 3]) -> Option<Self> {
        let points = corners.map(|at| Point3::from(self.axes.transpose() * self.corners[at].coords));
        let frame = Frame::of(&points)?;
        let (sin, cos) = self.angle_rad.sin_cos();
        let along = frame.axes * (self.axes.transpose() * Vector3::new(cos, sin, 0.0));
        Some(Self {
            nodes: corners.map(|at| self.nodes[at]).into(),
            axes: frame.axes,
            corners: frame.corners,
            section: Arc::new(self.section.membrane_alone()),
            angle_rad: along.y.atan2(along.x),
            drills: true,
            thickness: corners.iter().filter_map(|at| self.thickness.get(*at).copied()).collect(),
            normals: Vec::new(),
            triangles: Vec::new(),
            ..*self
        })
    }

    /// A quadrilateral's stiffness with drilling: its own in bending and shear, half of each triangle's membrane.
    fn drilled_stiffness(&self) -> DMatrix<f64> {
        let bending = ShellSection { membrane: Matrix3::zeros(), ..self.section() };
        let mut k = self.basic(&stiffness(&self.quad_points(), &bending, self.residual(&bending), 0.0));
        for (triangle, corners) in self.triangles.iter().zip(CUTS) {
            let own = triangle.stiffness().unwrap_or_default();
            let place = |index: usize| 6 * corners[index / 6] + index % 6;
            for (row, column) in (0..18 * 18).map(|at| (at / 18, at % 18)) {
                k[(place(row), place(column))] += 0.5 * own[(row, column)];
            }
        }
        k
    }

    /// With another stiffness that ties the corners' rotations about the normal to the membrane's own, in units of the membrane's shear stiffness: none
    /// for an element all of whose rotations about the normal are held, whose membrane they would hold as well.
    #[must_use]
    pub fn with_drilling_tie(self, tie: f64) -> Self {
        Self { tie, ..self }
    }

    /// With the normals that the shells at its corners' grids share, where they do; unit vectors in basic axes. Rotations about them bend nothing.
    #[must_use]
    pub fn with_grid_normals(self, normals: impl IntoIterator<Item = Option<Vector3<f64>>>) -> Self {
        // The element's own normal changes nothing.
        let turned = |n: Vector3<f64>| Some(self.axes * n).filter(|n| n.xy().norm() > UPRIGHT);
        let own = normals.into_iter().map(|normal| normal.and_then(turned)).collect();
        Self { normals: own, ..self }
    }

    /// As Nastran has it: a quadrilateral's bending with incompatible modes, transverse shear with the flexibility that makes up for the linear
    /// rotations' lack of bending (strips bend as beams do, whatever their number), rotations about the normal tied at the corners.
    #[must_use]
    pub fn as_nastran(self) -> Self {
        Self { is_nastran: true, ..self }
    }

    /// With thicknesses at the corners (T1 to T4), in units of the section's, linear between.
    #[must_use]
    pub fn with_thickness(self, ratios: Vec<f64>) -> Self {
        Self { thickness: ratios, ..self }
    }

    /// Axes of the element: rows x (along the side between the first two corners), y and normal, in basic axes.
    pub fn axes(&self) -> &Matrix3<f64> {
        &self.axes
    }

    /// The element's axes for corners at `points`; `None` if they span no area. A material direction is turned
    /// into an angle with these.
    pub fn axes_of(points: &[Point3<f64>]) -> Option<Matrix3<f64>> {
        Frame::of(points).map(|frame| frame.axes)
    }

    /// Area of the reference surface, m^2.
    pub fn area_m2(&self) -> f64 {
        match self.corners.len() {
            4 => quad::points(&self.corners).iter().map(|point| point.area_m2).sum(),
            _ => triangle::points(&self.corners).iter().map(|point| point.area_m2).sum(),
        }
    }

    /// The section in the element's axes.
    pub fn section(&self) -> ShellSection {
        self.section.turned(self.angle_rad)
    }

    /// Strains under `displacements` (six a node, basic axes) at natural coordinates `at`: -1 to 1 in a
    /// quadrilateral; 0 to 1 along the first two sides from corner 1 in a triangle.
    ///
    /// # Panics
    /// If there are not six displacements a node.
    pub fn strains(&self, displacements: &[f64], at: [f64; 2]) -> ShellStrains {
        assert_eq!(displacements.len(), 6 * self.nodes.len(), "six displacements a node");
        let (turn, grids) = (self.turn(), displacements.chunks_exact(6));
        let local = DVector::from_iterator(
            displacements.len(),
            grids.flat_map(|grid| (turn * Vector6::from_column_slice(grid)).data.0[0]),
        );
        let section = self.section();
        if self.corners.len() == 4 {
            let local = SVector::<f64, 24>::from_column_slice(local.as_slice());
            let local = self.quad_motions().map_or(local, |motions| motions * local);
            let modes = modes_of(&self.quad_points(), &section, self.tie, &local);
            strains_at(&quad::point(&self.corners, at, 0.0), &local, &modes)
        } else {
            let local = SVector::<f64, 18>::from_column_slice(local.as_slice());
            let local = self.triangle_motions().map_or(local, |motions| motions * local);
            let point = if self.drills {
                andes::point(&self.corners, at, 0.0, &section.membrane)
            } else {
                triangle::point(&self.corners, at, 0.0)
            };
            strains_at(&point, &local, &SVector::zeros())
        }
    }

    fn quad_points(&self) -> Vec<Point<24>> {
        self.thickened(quad::points(&self.corners))
    }

    fn triangle_points(&self) -> Vec<Point<18>> {
        self.thickened(triangle::points(&self.corners))
    }

    /// What bends a quadrilateral, by the motions of its corners ([`Self::with_grid_normals`]).
    fn quad_motions(&self) -> Option<SMatrix<f64, 24, 24>> {
        let at = |corner| quad::point(&self.corners, quad::CORNERS[corner], 0.0).drilling;
        bending_motions(&self.normals, at)
    }

    /// As [`Self::quad_motions`], of a triangle.
    fn triangle_motions(&self) -> Option<SMatrix<f64, 18, 18>> {
        let at = |corner| triangle::point(&self.corners, triangle::CORNERS[corner], 0.0).drilling;
        bending_motions(&self.normals, at)
    }

    /// The points' stiffness, bent by `motions` if these are not the corners' own.
    fn bent<const D: usize>(&self, points: &[Point<D>], motions: Option<SMatrix<f64, D, D>>) -> DMatrix<f64> {
        let section = self.section();
        let residual = self.residual(&section);
        self.basic(&match motions {
            Some(motions) => {
                let bent = motions.transpose() * stiffness(points, &section, residual, 0.0) * motions;
                bent + tie_stiffness(points, &section, self.tie)
            }
            None => stiffness(points, &section, residual, self.tie),
        })
    }

    /// That of Nastran's CTRIAR and CQUADR.
    fn residual(&self, section: &ShellSection) -> Option<Residual> {
        (self.is_nastran && self.drills).then(|| Residual::of(&self.corners, section))
    }

    /// A triangle's stiffness as Nastran has it ([`Self::as_nastran`]): membrane and bending of its points, shear of its sides, rotations
    /// about the normal tied at the corners, each with the area of its two sides' parallelogram.
    fn nastran_triangle(&self) -> DMatrix<f64> {
        let points = &self.triangle_points();
        let section = self.section();
        let ratio = points.iter().map(|point| point.thickness).sum::<f64>() / points.len() as f64;
        let in_plane = ShellSection { shear: Matrix2::zeros(), ..section };
        let across = shear_stiffness(&self.corners, self.area_m2(), &section.thickened(ratio));
        let own = stiffness(points, &in_plane, None, 0.0) + across;
        let corners = triangle::CORNERS.map(|at| triangle::point(&self.corners, at, 1.0));
        let tie = tie_stiffness(&self.thickened(corners.into()), &section, self.tie);
        self.basic(&match self.triangle_motions() {
            Some(motions) => motions.transpose() * own * motions + tie,
            None => own + tie,
        })
    }

    /// A quadrilateral's stiffness as Nastran has it ([`Self::as_nastran`]), of a section in the element's axes.
    fn nastran_stiffness(&self, section: &ShellSection) -> DMatrix<f64> {
        let points = self.quad_points();
        let quad =
            NastranQuad { corners: &self.corners, section, points: &points, thickness: &self.thickness };
        let (own, tie) = (quad.stiffness(), quad.tie(self.tie));
        self.basic(&match self.quad_motions() {
            Some(motions) => motions.transpose() * own * motions + tie,
            None => own + tie,
        })
    }

    /// The points with their thickness.
    fn thickened<const D: usize>(&self, mut points: Vec<Point<D>>) -> Vec<Point<D>> {
        for point in points.iter_mut().filter(|_| !self.thickness.is_empty()) {
            point.thickness = point.shape.iter().zip(&self.thickness).map(|(n, ratio)| n * ratio).sum();
        }
        points
    }

    /// Six motions of the reference surface at a grid, in the element's axes, by those of the grid in basic axes.
    fn turn(&self) -> Matrix6<f64> {
        let normal: Vector3<f64> = self.axes.row(2).transpose();
        let mut turn = Matrix6::zeros();
        turn.fixed_view_mut::<3, 3>(0, 0).copy_from(&self.axes);
        turn.fixed_view_mut::<3, 3>(3, 3).copy_from(&self.axes);
        // theta x r = -[r] theta
        let lever = -(self.axes * (normal * self.offset_m).cross_matrix());
        turn.fixed_view_mut::<3, 3>(0, 3).copy_from(&lever);
        turn
    }

    /// A symmetric matrix over the reference surface's motions as one over the grids', basic axes.
    fn basic<const D: usize>(&self, local: &SMatrix<f64, D, D>) -> DMatrix<f64> {
        let turn = self.turn();
        let mut matrix = DMatrix::zeros(D, D);
        for (i, j) in (0..D).step_by(6).flat_map(|i| (0..=i).step_by(6).map(move |j| (i, j))) {
            let symmetric =
                0.5 * (local.fixed_view::<6, 6>(i, j) + local.fixed_view::<6, 6>(j, i).transpose());
            let block = turn.transpose() * symmetric * turn;
            matrix.fixed_view_mut::<6, 6>(j, i).copy_from(&block.transpose());
            matrix.fixed_view_mut::<6, 6>(i, j).copy_from(&block);
        }
        // What rounding leaves of the blocks on the diagonal.
        matrix.fill_upper_triangle_with_lower_triangle();
        matrix
    }
}
