//! Shells with grids at the middle of their sides (CQUAD8, CTRIA6): curved, of first-order shear theory, six motions a grid.
//!
//! The surface and its directors (each grid's normal, from the element's own surface) are interpolated by the quadratic functions
//! of `serendipity.rs`; with a for the surface's tangents and d for the director, whose change is t x d under a rotation t,
//!
//! - membrane strains are (a_i . u,_j + a_j . u,_i) / 2,
//! - curvatures (a_i . (t x d),_j + d,_j . u,_i) and their mirror (which leaves rigid motions free of strain),
//! - transverse shears a_i . (t x d) + d . u,_i
//!
//! (the degenerated shell of Ahmad, Irons and Zienkiewicz, Int. J. Num. Meth. Eng. 2, 1970, integrated through its thickness). Membrane and
//! bending are sampled at 2 x 2 or at three points, where they do not lock (Zienkiewicz, Taylor and Too, same journal 3, 1971); a small share of
//! the quadrilateral's is integrated in full ([`FULL`]), for its motions without energy at the 2 x 2 points. Its transverse shears are
//! those of the 2 x 2 points; a triangle's are tied along its sides and in its middle (Lee and Bathe, Comput. Struct. 82, 2004: MITC6). A constant
//! curvature is exact in any triangle with straight sides and in parallelograms, not in other quadrilaterals.
//! Rotations about the normal are tied as in the flat shells. Each grid of a side may be missing; the side is straight then.

mod shears;

use super::point::{Point, mass_of, stiffness, strains_at};
use super::{DRILLING, ShellStrains, triangle};
use crate::element::Element;
use crate::laminate::ShellSection;
use crate::serendipity::{self, Edge, Functions, with_midsides};
use nalgebra::{
    DMatrix, DVector, Matrix2, Matrix3, Point3, RowSVector, RowVector3, SMatrix, SVector, Vector3,
};
use nastran::{InputError, Span};
use std::borrow::Cow;
use std::sync::Arc;

/// Motions of eight grids; columns of grids that are not there stay zero.
const D: usize = 48;

/// Share of the quadrilateral's membrane and bending that is integrated at 3 x 3 points.
const FULL: f64 = 0.05;

/// Smallest sine that still spans a surface.
const FLAT: f64 = 1e-4;

/// Points of integration (local coordinates) and their weights.
type Rule = Vec<([f64; 2], f64)>;

/// Where the section's x axis points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SectionAxis {
    /// Turned by this angle, rad, from the line along which the first local coordinate grows (THETA).
    Angle(f64),
    /// Along this direction (basic axes) projected onto the surface (MCID).
    Along(Vector3<f64>),
}

/// A curved shell element.
#[derive(Debug, Clone)]
pub struct CurvedShell {
    id: u32,
    nodes: Vec<usize>,
    /// Grids relative to the first, moved to the reference surface.
    points: Vec<Vector3<f64>>,
    /// Directors: the surface's normals at the grids.
    normals: Vec<Vector3<f64>>,
    sides: Vec<Edge>,
    offset_m: f64,
    section: Arc<ShellSection>,
    axis: SectionAxis,
    tie: f64,
}

/// Where a curved shell is: its grids, which sides have one, and its offset.
#[derive(Debug, Clone)]
pub struct CurvedPlace {
    /// Positions in the model's list of nodes: corners, then grids of the sides.
    pub nodes: Vec<usize>,
    /// Their places, m, basic axes.
    pub points: Vec<Point3<f64>>,
    /// The sides that have a grid, counted from zero in the order of the card.
    pub sides: Vec<usize>,
    /// From each grid along the normal to the reference surface, m.
    pub offset_m: f64,
}

impl CurvedShell {
    /// A shell at `place`; the section's x axis is `axis`.
    ///
    /// # Errors
    /// If there are not three or four corners, two grids are one, or the surface has no area or turns over in a part of it.
    pub fn new(
        id: u32,
        place: CurvedPlace,
        section: Arc<ShellSection>,
        axis: SectionAxis,
        span: &Span,
    ) -> Result<Self, InputError> {
        let CurvedPlace { nodes, points, sides, offset_m } = place;
        let bad = |what: &str| {
            let help = "give the corners in order around the element, then the grids of the sides in the order of the card, each in the \
                        middle half of its side";
            InputError::at(span, format!("shell {id} {what}")).with_help(help)
        };
        let all: &[Edge] = match nodes.len().saturating_sub(sides.len()) {
            4 => &serendipity::QUADRILATERAL,
            3 => &serendipity::TRIANGLE,
            _ => return Err(bad("has not three or four corners")),
        };
        let mut different = nodes.clone();
        different.sort_unstable();
        different.dedup();
        if different.len() < nodes.len()
            || points.len() != nodes.len()
            || sides.iter().any(|side| *side >= all.len())
        {
            return Err(bad("names a grid twice"));
        }
        let own = points.iter().map(|point| point - points[0]).collect();
        let sides = sides.iter().map(|side| all[*side]).collect();
        let mut shell = Self {
            id,
            nodes,
            points: own,
            normals: Vec::new(),
            sides,
            offset_m,
            section,
            axis,
            tie: DRILLING,
        };
        let normal = |at: &[f64; 2]| shell.normal(*at);
        let normals: Option<Vec<_>> = shell.places().iter().map(normal).collect();
        shell.normals = normals.ok_or_else(|| bad("has a grid at which its surface is not smooth"))?;
        for (point, normal) in shell.points.iter_mut().zip(&shell.normals) {
            *point += normal * offset_m;
        }
        let is_one_way = |at: &[f64; 2]| {
            let middle = shell.normal(shell.middle());
            let director: Vector3<f64> =
                shell.functions(*at).values.iter().zip(&shell.normals).map(|(n, own)| own * *n).sum();
            let normal = shell.normal(*at);
            middle.is_some_and(|middle| {
                normal.is_some_and(|own| own.dot(&middle) > 0.0 && own.dot(&director) > 0.0)
            })
        };
        if !shell.rules().iter().flatten().all(|(at, _)| is_one_way(at)) {
            return Err(bad("has no area in a part of it, or turns over there"));
        }
        Ok(shell)
    }

    /// Without the stiffness that ties rotations about the normal to the membrane's own (as [`super::Shell::with_drilling_tie`] of zero).
    #[must_use]
    pub fn without_drilling_tie(self) -> Self {
        Self { tie: 0.0, ..self }
    }

    /// The surface's unit normals at the grids.
    pub fn normals(&self) -> &[Vector3<f64>] {
        &self.normals
    }

    /// Area of the reference surface, m^2.
    pub fn area_m2(&self) -> f64 {
        self.mass_points().iter().map(|point| point.area_m2).sum()
    }

    /// The axes that [`Self::strains`] is given in, at local coordinates `at`: rows x (the section's), y and normal, basic axes.
    /// Nothing where the surface has no normal.
    pub fn axes(&self, at: [f64; 2]) -> Option<Matrix3<f64>> {
        let [along, across] = self.tangents(&self.functions(at));
        let normal = along.cross(&across).try_normalize(0.0)?;
        let from = match self.axis {
            SectionAxis::Angle(_) => along,
            SectionAxis::Along(direction) => direction - normal * normal.dot(&direction),
        };
        // A direction normal to the surface there leaves the line of the local coordinate.
        let x = from.try_normalize(1e-9 * from.norm().max(1e-300)).or_else(|| along.try_normalize(0.0))?;
        let y = normal.cross(&x);
        let turn = if let SectionAxis::Angle(angle) = self.axis { angle } else { 0.0 };
        let (sin, cos) = turn.sin_cos();
        let rows: [RowVector3<f64>; 3] =
            [(x * cos + y * sin).transpose(), (y * cos - x * sin).transpose(), normal.transpose()];
        Some(Matrix3::from_rows(&rows))
    }

    /// Strains under `displacements` (six a grid, basic axes) at local coordinates `at`, in [`Self::axes`] there: -1 to 1 in a
    /// quadrilateral; 0 to 1 along the sides from corner 1 in a triangle. Nothing where the surface has no normal.
    ///
    /// # Panics
    /// If there are not six displacements a grid.
    pub fn strains(&self, displacements: &[f64], at: [f64; 2]) -> Option<ShellStrains> {
        assert_eq!(displacements.len(), 6 * self.nodes.len(), "six displacements a grid");
        let mut all = SVector::<f64, D>::zeros();
        all.rows_mut(0, displacements.len()).copy_from_slice(displacements);
        Some(strains_at(&self.point(at, 0.0)?, &all, &SVector::zeros()))
    }

    fn is_triangle(&self) -> bool {
        self.nodes.len() - self.sides.len() == 3
    }

    /// Local coordinates of the grids.
    fn places(&self) -> Vec<[f64; 2]> {
        let corners: &[[f64; 2]] = if self.is_triangle() {
            &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]
        } else {
            &[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
        };
        let middle = |side: &Edge| {
            let [a, b] = side.ends().map(|end| corners[end]);
            [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]
        };
        corners.iter().copied().chain(self.sides.iter().map(middle)).collect()
    }

    fn middle(&self) -> [f64; 2] {
        if self.is_triangle() { [1.0 / 3.0; 2] } else { [0.0; 2] }
    }

    /// Points of integration and weights: those of the stiffness, and those that integrate in full.
    fn rules(&self) -> [Rule; 2] {
        if self.is_triangle() {
            let few = triangle::PLACES.map(|at| (at, triangle::WEIGHT)).into();
            return [few, crate::solid::radon().map(|(r, s, weight)| ([r, s], weight)).into()];
        }
        let square = |line: &[(f64, f64)]| {
            let along = |(x, wx): &(f64, f64)| {
                line.iter().map(move |(y, wy)| ([*x, *y], wx * wy)).collect::<Vec<_>>()
            };
            line.iter().flat_map(along).collect()
        };
        [square(&crate::solid::gauss_2()), square(&crate::solid::gauss_3())]
    }

    fn functions(&self, at: [f64; 2]) -> Functions {
        let linear =
            if self.is_triangle() { serendipity::triangle(at) } else { serendipity::quadrilateral(at) };
        with_midsides(linear, self.sides.iter().copied(), [at[0], at[1], 0.0])
    }

    /// Derivatives of the surface by the local coordinates.
    fn tangents(&self, functions: &Functions) -> [Vector3<f64>; 2] {
        let by = |axis: usize| {
            self.points.iter().zip(&functions.slopes).map(|(point, slope)| point * slope[axis]).sum()
        };
        [by(0), by(1)]
    }

    fn normal(&self, at: [f64; 2]) -> Option<Vector3<f64>> {
        let [along, across] = self.tangents(&self.functions(at));
        along.cross(&across).try_normalize(FLAT * along.norm() * across.norm())
    }

    /// The operators at local coordinates `at` with integration weight `weight`.
    fn point(&self, at: [f64; 2], weight: f64) -> Option<Point<D>> {
        let axes = self.axes(at)?;
        let functions = self.functions(at);
        let [along, across] = self.tangents(&functions);
        let [x, y, normal] = [0, 1, 2].map(|row| axes.row(row).into_owned());
        let [x_t, y_t] = [x.transpose(), y.transpose()];
        // Rows: the local coordinates; columns: x, y.
        let jacobian = Matrix2::new(along.dot(&x_t), along.dot(&y_t), across.dot(&x_t), across.dot(&y_t));
        let inverse = jacobian.try_inverse()?;
        let slopes: Vec<_> = functions.slopes.iter().map(|slope| inverse * slope.xy()).collect();
        let bent = [0, 1].map(|axis| -> RowVector3<f64> {
            self.normals.iter().zip(&slopes).map(|(d, slope)| d.transpose() * slope[axis]).sum()
        });
        let mut point = Point::<D> {
            area_m2: weight * jacobian.determinant(),
            thickness: 1.0,
            shape: functions.values.clone(),
            membrane: SMatrix::zeros(),
            bending: SMatrix::zeros(),
            shear: inverse * self.shears(at),
            drilling: RowSVector::zeros(),
            modes: SMatrix::zeros(),
            mode_drilling: RowSVector::zeros(),
        };
        for (node, (slope, value)) in slopes.iter().zip(&functions.values).enumerate() {
            let (sx, sy) = (slope.x, slope.y);
            let six = |by_u, by_d| self.six(node, by_u, by_d);
            let zero = RowVector3::zeros();
            let c = 6 * node;
            let membrane = [six(x * sx, zero), six(y * sy, zero), six(y * sx + x * sy, zero)];
            let bending = [
                six(bent[0] * sx, x * sx),
                six(bent[1] * sy, y * sy),
                six(bent[0] * sy + bent[1] * sx, x * sy + y * sx),
            ];
            point.membrane.fixed_columns_mut::<6>(c).copy_from(&SMatrix::<f64, 3, 6>::from_rows(&membrane));
            point.bending.fixed_columns_mut::<6>(c).copy_from(&SMatrix::<f64, 3, 6>::from_rows(&bending));
            point.drilling.fixed_columns_mut::<6>(c).copy_from(&six((x * sy - y * sx) * 0.5, zero));
            for axis in 0..3 {
                point.drilling[c + 3 + axis] += normal[axis] * value;
            }
        }
        Some(point)
    }

    /// A row over the motion of the surface at a grid, which is u + t x (offset n), and over the change of its director, as one over the grid's
    /// six motions.
    fn six(&self, node: usize, by_u: RowVector3<f64>, by_d: RowVector3<f64>) -> RowSVector<f64, 6> {
        let by_t = (by_u * self.offset_m + by_d) * -self.normals[node].cross_matrix();
        RowSVector::<f64, 6>::from_fn(|_, i| if i < 3 { by_u[i] } else { by_t[i - 3] })
    }

    /// Points of the stiffness, each with the root of its share.
    fn stiffness_points(&self) -> Vec<Point<D>> {
        let [few, all] = self.rules();
        let full = if self.is_triangle() { 0.0 } else { FULL };
        let scaled = |(at, weight): &([f64; 2], f64), share: f64, [shear, drilling]: [f64; 2]| {
            let mut point = self.point(*at, *weight)?;
            point.membrane *= share.sqrt();
            point.bending *= share.sqrt();
            point.shear *= shear;
            point.drilling *= drilling;
            Some(point)
        };
        let mut points: Vec<_> = few.iter().filter_map(|rule| scaled(rule, 1.0 - full, [1.0, 0.0])).collect();
        points.extend(all.iter().filter_map(|rule| scaled(rule, full, [0.0, 1.0])));
        points
    }

    fn mass_points(&self) -> Vec<Point<D>> {
        self.rules()[1].iter().filter_map(|(at, weight)| self.point(*at, *weight)).collect()
    }

    /// The integral of the mass times the products of the grids' functions.
    fn mass_by_node(&self) -> DMatrix<f64> {
        let count = self.nodes.len();
        let mut by_node = DMatrix::zeros(count, count);
        for point in self.mass_points() {
            let values = DVector::from_column_slice(&point.shape);
            by_node.ger(point.area_m2, &values, &values, 1.0);
        }
        by_node
    }
}

impl Element for CurvedShell {
    fn id(&self) -> u32 {
        self.id
    }

    fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    fn directors(&self) -> Vec<Vector3<f64>> {
        self.normals.clone()
    }

    fn stiffness(&self) -> Option<Cow<'_, DMatrix<f64>>> {
        let k = stiffness(&self.stiffness_points(), &self.section, None, self.tie);
        let order = 6 * self.nodes.len();
        Some(Cow::Owned(DMatrix::from_fn(order, order, |i, j| 0.5 * (k[(i, j)] + k[(j, i)]))))
    }

    fn mass(&self) -> Option<Cow<'_, DMatrix<f64>>> {
        let by_node = self.mass_by_node();
        let levers: Vec<Matrix3<f64>> = self.normals.iter().map(|normal| -normal.cross_matrix()).collect();
        let mut m = DMatrix::zeros(6 * self.nodes.len(), 6 * self.nodes.len());
        for (i, left) in levers.iter().enumerate() {
            for (j, right) in levers.iter().enumerate() {
                let block = mass_of(&self.section, left, right, self.offset_m) * by_node[(i, j)];
                m.view_mut((6 * i, 6 * j), (6, 6)).copy_from(&block);
            }
        }
        Some(Cow::Owned(0.5 * (&m + m.transpose())))
    }

    fn lumped_mass(&self) -> Option<DMatrix<f64>> {
        let by_node = self.mass_by_node();
        let own: Vec<f64> = by_node.diagonal().iter().copied().collect();
        let masses = serendipity::lumped(&own, by_node.sum() * self.section.mass_kg_m2);
        let entry = |i: usize, _| if i % 6 < 3 { masses[i / 6] } else { 0.0 };
        Some(DMatrix::from_diagonal(&DVector::from_fn(6 * masses.len(), entry)))
    }
}

#[cfg(test)]
mod tests;
