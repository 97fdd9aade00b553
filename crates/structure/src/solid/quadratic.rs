//! Solids with grids at the middle of their edges: CHEXA (to 20 grids), CPENTA (to 15), CTETRA (to 10).
//!
//! Isoparametric, three displacements a grid, the stiffness integrated in full (27, 21 and 5 points). Any of the grids on the edges may
//! be missing; the edge is straight then and its displacement linear.

use super::shape::{QuadraturePoint, Shape};
use super::{SMALLEST, base_of, write_strains};
use crate::element::Element;
use crate::serendipity::{self, Edge, Functions, with_midsides};
use crate::solid_material::SolidMaterial;
use nalgebra::{DMatrix, DVector, Matrix3, Matrix6xX, Point3, Vector3, Vector6};
use nastran::{InputError, Span};
use std::borrow::Cow;
use std::sync::Arc;

/// A solid element with grids on its edges.
#[derive(Debug, Clone)]
pub struct QuadraticSolid {
    id: u32,
    nodes: Vec<usize>,
    /// Grids relative to the first.
    points: Vec<Vector3<f64>>,
    /// The edges that have a grid.
    edges: Vec<Edge>,
    material: Arc<SolidMaterial>,
    shape: &'static dyn Shape,
}

impl QuadraticSolid {
    /// Builds the element with its grids at `points` (m, basic axes), which are the nodes at positions `nodes` of the model: the
    /// corners in Nastran's order, then the grids on those `edges` (counted from zero in the order of the card) that have one.
    ///
    /// # Errors
    /// If the number of corners is another, two grids are one, an edge is none of the element's, or the Jacobian is zero or changes its sign among the
    /// points of integration.
    pub fn new(
        id: u32,
        nodes: Vec<usize>,
        points: &[Point3<f64>],
        edges: &[usize],
        material: &Arc<SolidMaterial>,
        span: &Span,
    ) -> Result<Self, InputError> {
        let corners = nodes.len().saturating_sub(edges.len());
        let own: Option<(&'static dyn Shape, &[Edge])> = base_of(corners).map(|shape| match corners {
            8 => (shape, &serendipity::HEXAHEDRON[..]),
            6 => (shape, &serendipity::WEDGE[..]),
            _ => (shape, &serendipity::TETRAHEDRON[..]),
        });
        let found = own.and_then(|(shape, all)| {
            let edges: Option<Vec<Edge>> = edges.iter().map(|edge| all.get(*edge).copied()).collect();
            Some((shape, edges?))
        });
        let Some((shape, edges)) = found.filter(|_| points.len() == nodes.len()) else {
            let message = format!("solid {id} has {corners} corners and grids on {} edges", edges.len());
            return Err(InputError::at(span, message).with_help("expected CHEXA, CPENTA or CTETRA"));
        };
        let points = points.iter().map(|point| point - points[0]).collect();
        let solid = Self { id, nodes, points, edges, material: Arc::clone(material), shape };
        solid.check(span)?;
        Ok(solid)
    }

    /// Volume, m^3.
    pub fn volume_m3(&self) -> f64 {
        self.mass_points()
            .iter()
            .map(|point| point.weight * self.jacobian(&self.functions(point.at)).1.abs())
            .sum()
    }

    /// Stress (xx, yy, zz, xy, yz, zx; Pa, basic axes) at local coordinates `at` (as [`super::Solid::stress`]) under `displacements` (three
    /// a grid, m).
    ///
    /// # Panics
    /// If there are not three displacements a grid.
    pub fn stress(&self, displacements: &DVector<f64>, at: [f64; 3]) -> [f64; 6] {
        assert_eq!(displacements.len(), 3 * self.nodes.len(), "three displacements a grid");
        (self.material.stiffness * (self.strains(at).0 * displacements)).into()
    }

    /// Refuses an element that encloses no proper volume.
    fn check(&self, span: &Span) -> Result<(), InputError> {
        let bad = |what: &str, help: &str| {
            let message = format!("{} {}: {what}", self.shape.card(), self.id);
            Err(InputError::at(span, message).with_help(help))
        };
        let mut nodes = self.nodes.clone();
        nodes.sort_unstable();
        if nodes.windows(2).any(|pair| pair[0] == pair[1]) {
            return bad("two of its grids are the same", "name each grid once");
        }
        let mut sense = 0.0;
        for point in self.mass_points().into_iter().chain(self.stiffness_points()) {
            let (edges, volume) = self.jacobian(&self.functions(point.at));
            let relative = volume / edges.column_iter().map(|edge| edge.norm()).product::<f64>();
            let help = "look for grids in the wrong order, and for midside grids far from the middle of their edge: first all corners, \
                        then the grids on the edges in the order of the card";
            if !(relative.abs() > SMALLEST && volume.is_finite()) {
                return bad("it is flat, at least in a part of it", help);
            }
            if sense * volume < 0.0 {
                return bad("it is turned inside out in a part of it", help);
            }
            sense = volume;
        }
        Ok(())
    }

    fn corners(&self) -> usize {
        self.nodes.len() - self.edges.len()
    }

    fn functions(&self, at: [f64; 3]) -> Functions {
        let (values, slopes) = (self.shape.values(at), self.shape.gradients(at));
        let corners = self.corners();
        let linear = Functions {
            values: values.iter().take(corners).copied().collect(),
            slopes: slopes.column_iter().take(corners).map(Into::into).collect(),
        };
        with_midsides(linear, self.edges.iter().copied(), at)
    }

    /// The Jacobian dx/dxi (columns: local coordinates) and its determinant.
    fn jacobian(&self, functions: &Functions) -> (Matrix3<f64>, f64) {
        let sum = |sum: Matrix3<f64>, (point, slope): (&Vector3<f64>, &Vector3<f64>)| {
            sum + point * slope.transpose()
        };
        let jacobian = self.points.iter().zip(&functions.slopes).fold(Matrix3::zeros(), sum);
        (jacobian, jacobian.determinant())
    }

    /// B, and the size of a unit of local volume.
    fn strains(&self, at: [f64; 3]) -> (Matrix6xX<f64>, f64) {
        let functions = self.functions(at);
        let (jacobian, volume) = self.jacobian(&functions);
        // The check has made sure that it is not singular at points of integration.
        let inverse = jacobian.try_inverse().unwrap_or_else(Matrix3::zeros).transpose();
        let mut strains = Matrix6xX::zeros(3 * self.nodes.len());
        for (node, slope) in functions.slopes.iter().enumerate() {
            write_strains(&mut strains, 3 * node, &(inverse * slope));
        }
        (strains, volume.abs())
    }

    /// Forces at the grids (three each, N) that hold the element where it is warmer by `rises` at its grids; `strain` is the free strain a degree
    /// (basic axes).
    pub(crate) fn thermal_forces(&self, strain: &Vector6<f64>, rises: &[f64]) -> DVector<f64> {
        let mut forces = DVector::zeros(3 * self.nodes.len());
        for point in self.stiffness_points() {
            let (strains, volume) = self.strains(point.at);
            let values = self.functions(point.at).values;
            let rise: f64 = values.iter().zip(rises).map(|(n, rise)| n * rise).sum();
            forces +=
                strains.transpose() * (self.material.stiffness * strain) * (rise * point.weight * volume);
        }
        forces
    }

    fn stiffness_points(&self) -> Vec<QuadraturePoint> {
        self.shape.quadratic_points()
    }

    fn mass_points(&self) -> Vec<QuadraturePoint> {
        self.shape.quadratic_mass_points()
    }

    /// The integral of rho N N^T.
    fn mass_by_node(&self) -> DMatrix<f64> {
        let count = self.nodes.len();
        let mut by_node = DMatrix::zeros(count, count);
        for point in self.mass_points() {
            let functions = self.functions(point.at);
            let values = DVector::from_column_slice(&functions.values);
            let mass = self.material.density * point.weight * self.jacobian(&functions).1.abs();
            by_node.ger(mass, &values, &values, 1.0);
        }
        0.5 * (&by_node + by_node.transpose())
    }
}

impl Element for QuadraticSolid {
    fn id(&self) -> u32 {
        self.id
    }

    fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    /// Displacements only.
    fn dofs(&self) -> Vec<usize> {
        self.nodes.iter().flat_map(|node| (0..3).map(move |component| 6 * node + component)).collect()
    }

    fn stiffness(&self) -> Option<Cow<'_, DMatrix<f64>>> {
        let points = self.stiffness_points();
        let order = 3 * self.nodes.len();
        // All points in one product: faster than one product a point.
        let mut strains_t = DMatrix::zeros(order, 6 * points.len());
        let mut stresses = DMatrix::zeros(6 * points.len(), order);
        for (i, point) in points.iter().enumerate() {
            let (strains, volume) = self.strains(point.at);
            let elastic = self.material.stiffness * (point.weight * volume);
            stresses.rows_mut(6 * i, 6).copy_from(&(elastic * &strains));
            strains_t.columns_mut(6 * i, 6).copy_from(&strains.transpose());
        }
        let k = strains_t * stresses;
        Some(Cow::Owned(DMatrix::from_fn(order, order, |i, j| 0.5 * (k[(i, j)] + k[(j, i)]))))
    }

    fn mass(&self) -> Option<Cow<'_, DMatrix<f64>>> {
        let by_node = self.mass_by_node();
        let order = 3 * self.nodes.len();
        let entry = |i: usize, j: usize| if i % 3 == j % 3 { by_node[(i / 3, j / 3)] } else { 0.0 };
        (self.material.density > 0.0).then(|| Cow::Owned(DMatrix::from_fn(order, order, entry)))
    }

    fn lumped_mass(&self) -> Option<DMatrix<f64>> {
        if self.material.density <= 0.0 {
            return None;
        }
        let by_node = self.mass_by_node();
        let mut own: Vec<f64> = by_node.diagonal().iter().copied().collect();
        // With grids on all edges as in MSC Nastran, whose load vectors under GRAV have nothing at corners (cube: a twelfth of the weight at each edge). How it
        // shares the mass of irregular solids among their edges is not known; here by what they have of the consistent mass.
        if 2 * self.edges.len() == 3 * self.corners() {
            own.iter_mut().take(self.corners()).for_each(|corner| *corner = 0.0);
        }
        let masses = serendipity::lumped(&own, by_node.sum());
        Some(DMatrix::from_diagonal(&DVector::from_fn(3 * masses.len(), |i, _| masses[i / 3])))
    }
}
