//! Solid elements (CHEXA, CPENTA, CTETRA) with three displacements a corner.
//!
//! Strains are B u + E a: B from isoparametric shape functions, a the amounts of strain modes that belong to the
//! element alone, chosen by least energy (K_aa a = -K_au u, static condensation). The modes are given in local
//! coordinates and turned by the Jacobian J0 in the middle, E = (det J0 / det J) J0^-T E_local J0^-1; so their mean over
//! the element is zero, a constant stress does no work on them, and any distorted mesh passes the patch test
//! (Taylor, Beresford, Wilson, Int. J. Num. Meth. Eng. 10, 1976; Simo and Rifai, same journal 29, 1990). What
//! the modes are is told in the file of each family.
//!
//! A parallelepiped bends exactly. A mesh of trapezoidal sides still locks when it is slender, as every element
//! with eight corners that passes the patch test must (MacNeal, 1987).
//!
//! With grids on the edges a solid is a [`QuadraticSolid`].
//!
//! Corners are numbered as Nastran's; as there, only their consecutive order counts, so that an element may be
//! numbered in either sense. Matrices are computed when asked for: an element keeps its corners and a reference to
//! its material.

mod hexa;
mod nastran_wedge;
mod penta;
mod quadratic;
mod shape;
mod tetra;

pub(crate) use penta::radon;
pub use quadratic::QuadraticSolid;
pub(crate) use shape::{gauss_2, gauss_3};

use crate::element::Element;
use crate::solid_material::SolidMaterial;
use nalgebra::{DMatrix, DVector, Matrix3, Matrix6xX, Point3, SMatrix, Vector3, Vector6};
use nastran::{InputError, Span};
use shape::{Gradients, ModeStrains, Shape, Values, strain_transformation};
use std::borrow::Cow;
use std::sync::Arc;

/// Smallest ratio that still counts as more than nothing: of a distance of corners to the element's size, of a
/// volume to the lengths that span it.
const SMALLEST: f64 = 1e-6;

/// The family with this number of corners.
fn base_of(corners: usize) -> Option<&'static dyn Shape> {
    match corners {
        8 => Some(&hexa::Hexa),
        6 => Some(&penta::Penta),
        4 => Some(&tetra::Tetra),
        _ => None,
    }
}

/// A solid element.
#[derive(Debug, Clone)]
pub struct Solid {
    id: u32,
    nodes: Vec<usize>,
    /// Corners relative to the first: far from the origin the strains would lose digits.
    corners: SMatrix<f64, 3, 8>,
    material: Arc<SolidMaterial>,
    shape: &'static dyn Shape,
    is_lumped: bool,
    /// Without strain modes.
    is_standard: bool,
    /// A wedge with Nastran's modes and shear.
    is_nastran: bool,
}

impl Solid {
    /// Builds the element with its corners at `points` (m, basic axes), which are the nodes at positions `nodes` of
    /// the model: eight (CHEXA), six (CPENTA) or four (CTETRA) in Nastran's order. `span` is the element's card.
    ///
    /// # Errors
    /// If the number of corners is another, two corners are one, or the Jacobian is zero or changes its sign among
    /// the points of integration. (At a corner it may: an element of the usual patch test has such a one.)
    pub fn new(
        id: u32,
        nodes: Vec<usize>,
        points: &[Point3<f64>],
        material: &Arc<SolidMaterial>,
        span: &Span,
    ) -> Result<Self, InputError> {
        let Some(shape) = base_of(nodes.len()).filter(|_| points.len() == nodes.len()) else {
            let message = format!("solid {id} has {} corners and {} points", nodes.len(), points.len());
            let help = "expected 8 (CHEXA), 6 (CPENTA) or 4 (CTETRA)";
            return Err(InputError::at(span, message).with_help(help));
        };
        let mut corners = SMatrix::<f64, 3, 8>::zeros();
        for (i, point) in points.iter().enumerate() {
            corners.set_column(i, &(point - points[0]));
        }
        let material = Arc::clone(material);
        let solid = Self {
            id,
            nodes,
            corners,
            material,
            shape,
            is_lumped: false,
            is_standard: false,
            is_nastran: false,
        };
        solid.check(span)?;
        Ok(solid)
    }

    /// The same element with its mass lumped at the corners: each gets the integral of rho times its shape function,
    /// which keeps the mass and its centre, but not the moments of inertia.
    #[must_use]
    pub fn with_lumped_mass(self) -> Self {
        Self { is_lumped: true, ..self }
    }

    /// The same element without strain modes: the isoparametric one, which is too stiff in bending (PSOLID with ISOP = FULL).
    #[must_use]
    pub fn standard(self) -> Self {
        Self { is_standard: true, ..self }
    }

    /// As Nastran has it: a CPENTA's modes and transverse shear are others (`nastran_wedge.rs`).
    #[must_use]
    pub fn as_nastran(self) -> Self {
        Self { is_nastran: self.nodes.len() == 6, ..self }
    }

    /// Number of strain modes.
    fn mode_count(&self) -> usize {
        if self.is_standard { 0 } else { self.shape.mode_count() }
    }

    /// Volume, m^3.
    pub fn volume_m3(&self) -> f64 {
        self.shape.mass_points().iter().map(|point| point.weight * self.jacobian(point.at).1.abs()).sum()
    }

    /// Stress (xx, yy, zz, xy, yz, zx; Pa, basic axes) at local coordinates `at` under `displacements` (three a
    /// corner, m), the strain modes included. Local coordinates: -1 to 1 (CHEXA); r, s over the
    /// triangle from corner 1 to 2 and 3, then -1 to 1 (CPENTA); any (CTETRA).
    ///
    /// # Panics
    /// If there are not three displacements a corner.
    pub fn stress(&self, displacements: &DVector<f64>, at: [f64; 3]) -> [f64; 6] {
        let own = 3 * self.nodes.len();
        assert_eq!(displacements.len(), own, "three displacements a corner");
        let mut motion = displacements.clone().resize_vertically(own + self.mode_count(), 0.0);
        if let Some(modes) = self.modes_by_corners(&self.with_modes()) {
            motion.rows_mut(own, modes.nrows()).copy_from(&(modes * displacements));
        }
        let stress = self.material.stiffness * (self.strains(at).0 * motion);
        stress.into()
    }

    /// Refuses an element that encloses no proper volume.
    fn check(&self, span: &Span) -> Result<(), InputError> {
        let bad = |what: String, help: &str| {
            let message = format!("{} {}: {what}", self.shape.card(), self.id);
            Err(InputError::at(span, message).with_help(help))
        };
        if let Some((i, j)) = self.pair(|i, j| self.nodes[i] == self.nodes[j]) {
            let what = format!("its corners {i} and {j} are the same grid");
            return bad(what, "use CPENTA or CTETRA for a solid with fewer corners");
        }
        let largest = self.corners.column_iter().map(|corner| corner.norm()).fold(0.0, f64::max);
        let apart = |i, j| (self.corners.column(i) - self.corners.column(j)).norm();
        if let Some((i, j)) = self.pair(|i, j| apart(i, j) <= SMALLEST * largest) {
            let what = format!("its corners {i} and {j} are at the same place");
            return bad(what, "use CPENTA or CTETRA for a solid with fewer corners");
        }
        let mut sense = 0.0;
        for point in self.shape.mass_points().into_iter().chain(self.shape.stiffness_points()) {
            let (edges, volume) = self.jacobian(point.at);
            let relative = volume / edges.column_iter().map(|edge| edge.norm()).product::<f64>();
            let help = "look for grids in the wrong order: about one face, then about the opposite one in the \
                        same sense, each grid opposite its partner";
            // What is not a number or overflows is no volume either.
            if !(relative.abs() > SMALLEST && volume.is_finite()) {
                return bad("it is flat, at least in a part of it".to_string(), help);
            }
            if sense * volume < 0.0 {
                return bad("it is turned inside out in a part of it".to_string(), help);
            }
            sense = volume;
        }
        let modes = self.modes_by_corners(&self.with_modes());
        if self.mode_count() > 0 && modes.is_none_or(|modes| !modes.iter().all(|value| value.is_finite())) {
            let what = "its stiffness cannot be computed".to_string();
            return bad(what, "look for lengths or moduli many orders of magnitude off");
        }
        Ok(())
    }

    /// The first two corners, counted from one, of which something is true.
    fn pair(&self, is_so: impl Fn(usize, usize) -> bool) -> Option<(usize, usize)> {
        let n = self.nodes.len();
        let all = (0..n).flat_map(|j| (0..j).map(move |i| (i, j)));
        all.into_iter().find(|(i, j)| is_so(*i, *j)).map(|(i, j)| (i + 1, j + 1))
    }

    /// The Jacobian dx/dxi (columns: local coordinates) and its determinant.
    fn jacobian(&self, at: [f64; 3]) -> (Matrix3<f64>, f64) {
        let jacobian = self.corners * self.shape.gradients(at).transpose();
        (jacobian, jacobian.determinant())
    }

    /// [B E]: the six strains from the corners' displacements and the modes, and the size of a unit of local volume.
    fn strains(&self, at: [f64; 3]) -> (Matrix6xX<f64>, f64) {
        let (jacobian, volume) = self.jacobian(at);
        let (middle, volume_middle) = self.jacobian(self.shape.middle());
        // The check has made sure that neither is singular.
        let inverse = |matrix: Matrix3<f64>| matrix.try_inverse().unwrap_or_else(Matrix3::zeros).transpose();
        let gradients: Gradients = inverse(jacobian) * self.shape.gradients(at);
        let modes: ModeStrains =
            strain_transformation(&inverse(middle)) * self.shape.mode_strains(at) * (volume_middle / volume);
        let (own, count) = (3 * self.nodes.len(), self.mode_count());
        let mut strains = Matrix6xX::zeros(own + count);
        for i in 0..self.nodes.len() {
            write_strains(&mut strains, 3 * i, &gradients.column(i).into_owned());
        }
        strains.columns_mut(own, count).copy_from(&modes.columns(0, count));
        (strains, volume.abs())
    }

    /// Stiffness over the corners' displacements and the modes.
    fn with_modes(&self) -> DMatrix<f64> {
        let order = 3 * self.nodes.len() + self.mode_count();
        let points = self.shape.stiffness_points();
        // All points in one product: faster than one product a point.
        let mut strains_t = DMatrix::zeros(order, 6 * points.len());
        let mut stresses = DMatrix::zeros(6 * points.len(), order);
        for (i, point) in points.iter().enumerate() {
            let (strains, volume) = self.strains(point.at);
            let elastic = self.material.stiffness * (point.weight * volume);
            stresses.rows_mut(6 * i, 6).copy_from(&(elastic * &strains));
            strains_t.columns_mut(6 * i, 6).copy_from(&strains.transpose());
        }
        strains_t * stresses
    }

    /// Forces at the corners (three each, N) that hold the element where it is warmer by `rises` at its corners, between them by the shape
    /// functions; `strain` is the free strain a degree (basic axes). What the modes take is condensed with them.
    pub(crate) fn thermal_forces(&self, strain: &Vector6<f64>, rises: &[f64]) -> DVector<f64> {
        let own = 3 * self.nodes.len();
        let mut all = DVector::zeros(own + self.mode_count());
        for point in self.shape.stiffness_points() {
            let (strains, volume) = self.strains(point.at);
            let rise: f64 = self.shape.values(point.at).iter().zip(rises).map(|(n, rise)| n * rise).sum();
            all += strains.transpose() * (self.material.stiffness * strain) * (rise * point.weight * volume);
        }
        let mut forces = all.rows(0, own).into_owned();
        if let Some(by_corners) = self.modes_by_corners(&self.with_modes()) {
            forces += by_corners.transpose() * all.rows(own, by_corners.nrows());
        }
        forces
    }

    /// -K_aa^-1 K_au: the modes from the corners' displacements; `None` without modes, or if they cannot be found.
    fn modes_by_corners(&self, k: &DMatrix<f64>) -> Option<DMatrix<f64>> {
        let (own, modes) = (3 * self.nodes.len(), self.mode_count());
        let factor = (modes > 0).then(|| k.view((own, own), (modes, modes)).into_owned().cholesky())??;
        Some(-factor.solve(&k.view((own, 0), (modes, own))))
    }
}

impl Element for Solid {
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
        let wedge = (self.is_nastran && !self.is_standard)
            .then(|| nastran_wedge::stiffness(&self.corners, &self.material.stiffness));
        if let Some(k) = wedge.flatten() {
            return Some(Cow::Owned(0.5 * (&k + k.transpose())));
        }
        let (own, modes) = (3 * self.nodes.len(), self.mode_count());
        let full = self.with_modes();
        let mut k = full.view((0, 0), (own, own)).into_owned();
        if let Some(by_corners) = self.modes_by_corners(&full) {
            k += full.view((0, own), (own, modes)) * by_corners;
        }
        Some(Cow::Owned(DMatrix::from_fn(own, own, |i, j| 0.5 * (k[(i, j)] + k[(j, i)]))))
    }

    fn mass(&self) -> Option<Cow<'_, DMatrix<f64>>> {
        let n = self.nodes.len();
        let mut by_corner = SMatrix::<f64, 8, 8>::zeros();
        for point in self.shape.mass_points() {
            let n: Values = self.shape.values(point.at);
            let mass = self.material.density * point.weight * self.jacobian(point.at).1.abs();
            by_corner += n * n.transpose() * mass;
        }
        if self.is_lumped {
            // The shape functions add to one, so a row's sum is the integral of its own.
            by_corner = SMatrix::from_diagonal(&by_corner.column_sum());
        }
        let mut m = DMatrix::zeros(3 * n, 3 * n);
        for i in 0..n {
            for j in 0..n {
                for axis in 0..3 {
                    m[(3 * i + axis, 3 * j + axis)] = by_corner[(i, j)];
                }
            }
        }
        (self.material.density > 0.0).then_some(Cow::Owned(m))
    }
}

/// The strains xx, yy, zz, xy, yz, zx of displacements whose amplitude has the gradient `g`.
fn write_strains(strains: &mut Matrix6xX<f64>, column: usize, g: &Vector3<f64>) {
    for axis in 0..3 {
        strains[(axis, column + axis)] = g[axis];
        // xy, yz, zx: rows 3, 4, 5 join an axis with the next
        let next = (axis + 1) % 3;
        strains[(3 + axis, column + axis)] = g[next];
        strains[(3 + axis, column + next)] = g[axis];
    }
}

#[cfg(test)]
mod tests;
