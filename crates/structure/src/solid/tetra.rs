//! CTETRA with four corners: linear shape functions, constant strain, no modes.
//!
//! Local coordinates r, s, t run from corner 1 to corners 2, 3, 4. The element is stiff in bending; it is there to
//! fill corners of meshes.

use super::shape::{Gradients, ModeStrains, QuadraturePoint, Shape, Values};

/// The family of the tetrahedron.
#[derive(Debug)]
pub(crate) struct Tetra;

impl Shape for Tetra {
    fn card(&self) -> &'static str {
        "CTETRA"
    }

    fn middle(&self) -> [f64; 3] {
        [0.25; 3]
    }

    fn values(&self, [r, s, t]: [f64; 3]) -> Values {
        Values::from([1.0 - r - s - t, r, s, t, 0.0, 0.0, 0.0, 0.0])
    }

    fn gradients(&self, _: [f64; 3]) -> Gradients {
        Gradients::from_fn(|row, i| match i {
            0 => -1.0,
            i if i == row + 1 => 1.0,
            _ => 0.0,
        })
    }

    fn mode_count(&self) -> usize {
        0
    }

    fn mode_strains(&self, _: [f64; 3]) -> ModeStrains {
        ModeStrains::zeros()
    }

    fn stiffness_points(&self) -> Vec<QuadraturePoint> {
        vec![QuadraturePoint { at: self.middle(), weight: 1.0 / 6.0 }]
    }

    /// Four points, exact to degree 2 (Hammer and Stroud, 1956): N N^T has that degree, det J is constant.
    fn mass_points(&self) -> Vec<QuadraturePoint> {
        let far = (5.0 + 3.0 * 5.0_f64.sqrt()) / 20.0;
        let near = (5.0 - 5.0_f64.sqrt()) / 20.0;
        [[near, near, near], [far, near, near], [near, far, near], [near, near, far]]
            .map(|at| QuadraturePoint { at, weight: 1.0 / 24.0 })
            .to_vec()
    }

    /// Five points, exact to degree 3 (Hammer and Stroud, 1956), with which two curved tetrahedra have the displacements of a print of Nastran to seven
    /// digits; where edges are straight, strains are linear and four points are the same.
    fn quadratic_points(&self) -> Vec<QuadraturePoint> {
        let (near, far) = (1.0 / 6.0, 0.5);
        let mut points = vec![QuadraturePoint { at: self.middle(), weight: -2.0 / 15.0 }];
        let places = [[near, near, near], [far, near, near], [near, far, near], [near, near, far]];
        points.extend(places.map(|at| QuadraturePoint { at, weight: 3.0 / 40.0 }));
        points
    }

    /// Fifteen points, exact to degree 5 (Stroud, *Approximate Calculation of Multiple Integrals*, T3: 5-1).
    fn quadratic_mass_points(&self) -> Vec<QuadraturePoint> {
        let root = 15.0_f64.sqrt();
        let mut points = vec![QuadraturePoint { at: [0.25; 3], weight: 8.0 / 405.0 }];
        for sign in [1.0, -1.0] {
            let (near, weight) =
                ((7.0 - sign * root) / 34.0, (2665.0 + sign * 14.0 * root) / (6.0 * 37800.0));
            let far = 1.0 - 3.0 * near;
            let places = [[near, near, near], [far, near, near], [near, far, near], [near, near, far]];
            points.extend(places.map(|at| QuadraturePoint { at, weight }));
        }
        let (a, b) = ((10.0 - 2.0 * root) / 40.0, (10.0 + 2.0 * root) / 40.0);
        let pairs = [[a, a, b], [a, b, a], [b, a, a], [b, b, a], [b, a, b], [a, b, b]];
        points.extend(pairs.map(|at| QuadraturePoint { at, weight: 10.0 / (6.0 * 189.0) }));
        points
    }
}
