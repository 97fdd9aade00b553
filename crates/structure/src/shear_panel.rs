//! Shear panels (CSHEAR) after Garvey, *The Quadrilateral Shear Panel*, Aircraft Engineering, May 1951: a plate whose sides carry
//! shear flow only, one state of stress for a panel.
//!
//! That state follows from one of pure shear on a square by a projective map, under which equilibrium is kept: with a, b linear functions of
//! the place that vanish on sides 4-1 and 1-2, and c one that vanishes on the line through the two points where opposite sides meet,
//! Airy's function is a b / c. It leaves all four sides without direct stress; in a parallelogram c is constant and so is the shear flow.
//! Stiffness: the forces that the sides need, each half at its two corners, by Castigliano's theorem.

use crate::matrix_element::MatrixElement;
use crate::solid::gauss_3;
use nalgebra::{DMatrix, DVector, Matrix2, Matrix3, Point3, SVector, Vector2, Vector3};
use nastran::{InputError, Mat1, Pshear, Span};

/// Smallest sine of a corner's angle.
const FLAT: f64 = 1e-4;

/// Above this factor F1 and F2 are widths in thicknesses, up to it shares of the panel's width (PSHEAR).
const SHARE: f64 = 1.01;

/// Parts of a side between which the energy is integrated.
const PARTS: u32 = 8;

/// A panel between the `nodes` at `points`.
///
/// # Errors
/// If the corners do not go around a convex area, or the material has no shear modulus.
pub(crate) fn panel(
    id: u32,
    nodes: [usize; 4],
    points: &[Point3<f64>; 4],
    property: &Pshear,
    material: &Mat1,
    span: &Span,
) -> Result<MatrixElement, InputError> {
    let Some(place) = Place::of(points) else {
        let message = format!("CSHEAR {id} has no area, or a corner of 180 degrees or more");
        return Err(InputError::at(span, message).with_help("give its grids in order around the panel"));
    };
    let t = property.thickness;
    if !(material.g > 0.0 && material.g.is_finite() && material.nu.abs() < 1.0) {
        let message = format!("MAT1 {} has no shear modulus for CSHEAR {id}", material.id);
        return Err(InputError::at(&material.span, message).with_help("a positive G, NU between -1 and 1"));
    }
    let forces = place.corner_forces();
    let flexibility = place.flexibility(material.nu) / (material.g * t);
    let mut k = forces * forces.transpose() / flexibility;
    // What F1 and F2 leave of the panel as rods along its sides.
    for (side, factor) in property.extensional.into_iter().cycle().take(4).enumerate() {
        let ends = [side, (side + 1) % 4];
        let length = |at: usize| (points[(at + 1) % 4] - points[at]).norm();
        let along = (points[ends[1]] - points[ends[0]]) / length(side);
        let width = place.area / (0.5 * (length(side) + length((side + 2) % 4)));
        let area = 0.5 * factor * t * if factor > SHARE { t } else { width };
        let mut stretch = SVector::<f64, 12>::zeros();
        stretch.fixed_rows_mut::<3>(3 * ends[0]).copy_from(&-along);
        stretch.fixed_rows_mut::<3>(3 * ends[1]).copy_from(&along);
        k += stretch * stretch.transpose() * (material.e * area / length(side));
    }
    let dofs: Vec<usize> = nodes.iter().flat_map(|node| [0, 1, 2].map(|axis| 6 * node + axis)).collect();
    let k = DMatrix::from_fn(12, 12, |i, j| 0.5 * (k[(i, j)] + k[(j, i)]));
    let mass = (material.rho * t + property.nsm) * place.area / 4.0;
    let m = DMatrix::from_diagonal(&DVector::from_element(12, mass));
    Ok(if mass == 0.0 { MatrixElement::spring(id, &dofs, &k) } else { MatrixElement::new(id, &dofs, &k, &m) })
}

/// Where a panel lies: corners in its mean plane, and Airy's function there.
struct Place {
    /// Rows are x, y and normal of the mean plane in basic axes.
    axes: Matrix3<f64>,
    /// Corners: x, y and height above the mean plane.
    corners: [Vector3<f64>; 4],
    area: f64,
    /// Linear functions (by x, by y, constant) that vanish on side 4-1, on side 1-2, and on the line through the meeting points of
    /// opposite sides.
    lines: [Vector3<f64>; 3],
}

impl Place {
    fn of(points: &[Point3<f64>; 4]) -> Option<Self> {
        let (one, other) = (points[2] - points[0], points[3] - points[1]);
        let normal = one.cross(&other).try_normalize(FLAT * one.norm() * other.norm())?;
        let x = (one - normal * normal.dot(&one)).try_normalize(0.0)?;
        let axes = Matrix3::from_rows(&[x.transpose(), normal.cross(&x).transpose(), normal.transpose()]);
        let middle = points.iter().map(|point| point.coords).sum::<Vector3<f64>>() / 4.0;
        let corners = [0, 1, 2, 3].map(|at: usize| axes * (points[at].coords - middle));
        let line = |from: usize| {
            let (a, b) = (corners[from], corners[(from + 1) % 4]);
            // Positive on the left, where the panel is.
            let by = Vector2::new(a.y - b.y, b.x - a.x).normalize();
            Vector3::new(by.x, by.y, -by.x * a.x - by.y * a.y)
        };
        let sides = [line(0), line(1), line(2), line(3)];
        let is_convex = (0..4).all(|side| {
            let size = one.norm() + other.norm();
            [2, 3].iter().all(|step| at(&sides[side], &corners[(side + step) % 4]) > FLAT * size)
        });
        let third = sides[3].cross(&sides[1]).cross(&sides[0].cross(&sides[2]));
        // The corners' middle is the origin.
        let third = third / third.z;
        let is_sound = is_convex && third.iter().all(|value| value.is_finite());
        let area = 0.5 * one.cross(&other).norm();
        is_sound.then_some(Self { axes, corners, area, lines: [sides[3], sides[0], third] })
    }

    /// Gradient and second derivatives of Airy's function.
    fn airy(&self, place: &Vector3<f64>) -> (Vector2<f64>, Matrix2<f64>) {
        let [a, b, c] = self.lines.map(|line| at(&line, place));
        let [by_a, by_b, by_c] = self.lines.map(|line| line.xy());
        let mixed = by_b * a + by_a * b;
        let twice =
            |one: &Vector2<f64>, other: &Vector2<f64>| one * other.transpose() + other * one.transpose();
        let gradient = mixed / c - by_c * (a * b / (c * c));
        let second = twice(&by_a, &by_b) / c - twice(&mixed, &by_c) / (c * c)
            + by_c * by_c.transpose() * (2.0 * a * b / c.powi(3));
        (gradient, second)
    }

    /// Forces on the corners (basic axes) that hold the state of stress, of unit thickness: half of those on the two sides that meet there.
    /// On opposite corners they are opposite, and these are equally high above the mean plane: a warped panel is in balance as it is.
    fn corner_forces(&self) -> SVector<f64, 12> {
        let gradients = self.corners.map(|corner| self.airy(&corner).0);
        let mut all = SVector::<f64, 12>::zeros();
        for corner in 0..4 {
            let change = gradients[(corner + 1) % 4] - gradients[(corner + 3) % 4];
            let force = Vector3::new(change.y, -change.x, 0.0) * 0.5;
            all.fixed_rows_mut::<3>(3 * corner).copy_from(&(self.axes.transpose() * force));
        }
        all
    }

    /// Twice the complementary energy of the state, times shear modulus and thickness.
    fn flexibility(&self, nu: f64) -> f64 {
        let mut sum = 0.0;
        // In parts: the function is rational where the panel tapers.
        let along: Vec<(f64, f64)> = (0..PARTS)
            .flat_map(|part| {
                let middle = (2.0 * f64::from(part) + 1.0) / f64::from(PARTS) - 1.0;
                gauss_3().map(|(x, weight)| (middle + x / f64::from(PARTS), weight / f64::from(PARTS)))
            })
            .collect();
        for (x, wx) in &along {
            for (y, wy) in &along {
                let signs = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
                let by = |of: &dyn Fn(f64, f64) -> f64| -> Vector3<f64> {
                    self.corners.iter().zip(signs).map(|(corner, (a, b))| corner * (0.25 * of(a, b))).sum()
                };
                let place = by(&|a, b| (1.0 + a * x) * (1.0 + b * y));
                let (along, across) = (by(&|a, b| a * (1.0 + b * y)), by(&|a, b| b * (1.0 + a * x)));
                let area = (along.x * across.y - along.y * across.x) * wx * wy;
                let second = self.airy(&place).1;
                let (x_x, y_y, x_y) = (second[(1, 1)], second[(0, 0)], -second[(0, 1)]);
                sum +=
                    area * (x_y * x_y + (x_x * x_x + y_y * y_y - 2.0 * nu * x_x * y_y) / (2.0 * (1.0 + nu)));
            }
        }
        sum
    }
}

/// A linear function at a place.
fn at(line: &Vector3<f64>, place: &Vector3<f64>) -> f64 {
    line.x * place.x + line.y * place.y + line.z
}
