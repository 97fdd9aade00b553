//! Material of solid elements: the stiffness that turns strains into stresses, in basic axes.
//!
//! Components are xx, yy, zz, xy, yz, zx (Nastran's order), shear strains are engineering ones (gamma = 2 epsilon).
//! MAT1 gives the isotropic matrix of E and nu; as in Nastran, G of the card plays no part in a solid. MAT9 gives the
//! whole matrix in material axes; with sigma = R sigma' R^T written as T sigma' for the six components, the matrix
//! in basic axes is T C T^T, since strains follow from the same work (Auld, *Acoustic Fields and Waves in Solids*,
//! ch. 3: Bond's transformation).

use nalgebra::{Matrix3, Matrix6};
use nastran::{InputError, Mat1, Mat9, Span};

/// Row and column of the stress tensor for each of the six components.
pub(crate) const COMPONENTS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)];

/// Smallest pivot, relative to the diagonal, that still counts as positive.
const SMALLEST_PIVOT: f64 = 1e-12;

/// A linear elastic material, basic axes.
#[derive(Debug, Clone, PartialEq)]
pub struct SolidMaterial {
    /// Stresses xx, yy, zz, xy, yz, zx (Pa) from strains (engineering shear).
    pub stiffness: Matrix6<f64>,
    /// Density, kg/m^3.
    pub density: f64,
}

impl SolidMaterial {
    /// The isotropic material of E and nu.
    ///
    /// # Errors
    /// If E is not positive, nu not between -1 and 0.5, or the density negative.
    pub fn from_mat1(card: &Mat1) -> Result<Self, InputError> {
        let (e, nu) = (card.e, card.nu);
        let mut stiffness = Matrix6::zeros();
        let factor = e / ((1.0 + nu) * (1.0 - 2.0 * nu));
        for i in 0..3 {
            for j in 0..3 {
                stiffness[(i, j)] = factor * if i == j { 1.0 - nu } else { nu };
            }
            stiffness[(3 + i, 3 + i)] = e / (2.0 * (1.0 + nu));
        }
        let of = format!("MAT1 {} with E = {e} and nu = {nu}", card.id);
        Self { stiffness, density: card.rho }.checked(&of, "E positive and nu between -1 and 0.5", &card.span)
    }

    /// The anisotropic material of a MAT9 whose axes are the columns of `axes` (basic components).
    ///
    /// # Errors
    /// If the card's matrix is not positive definite, or the density negative.
    pub fn from_mat9(card: &Mat9, axes: &Matrix3<f64>) -> Result<Self, InputError> {
        let mut own = Matrix6::zeros();
        let places = (0..6).flat_map(|i| (i..6).map(move |j| (i, j)));
        for ((i, j), value) in places.zip(card.g) {
            own[(i, j)] = value;
            own[(j, i)] = value;
        }
        let to_basic = stress_transformation(axes);
        let turned = to_basic * own * to_basic.transpose();
        let stiffness = 0.5 * (turned + turned.transpose());
        let help = "a matrix with positive eigenvalues: G11 to G66 positive, coupling terms small enough";
        Self { stiffness, density: card.rho }.checked(&format!("MAT9 {}", card.id), help, &card.span)
    }

    /// Refuses a material that strain could draw energy from.
    fn checked(self, of: &str, expected: &str, span: &Span) -> Result<Self, InputError> {
        if !is_positive_definite(&self.stiffness) {
            let message = format!("the stiffness of {of} is not positive definite, so no solid can have it");
            return Err(InputError::at(span, message).with_help(format!("expected: {expected}")));
        }
        if !(self.density >= 0.0 && self.density.is_finite()) {
            let message = format!("{of} has the density {}", self.density);
            return Err(InputError::at(span, message).with_help("expected: zero or more"));
        }
        Ok(self)
    }
}

/// Scaled by the diagonal first, as moduli of one material may differ by orders of magnitude.
fn is_positive_definite(c: &Matrix6<f64>) -> bool {
    let scale = c.diagonal().map(|entry| 1.0 / entry.sqrt());
    let scaled = Matrix6::from_fn(|i, j| scale[i] * c[(i, j)] * scale[j]);
    scaled.iter().all(|entry| entry.is_finite())
        && scaled.cholesky().is_some_and(|factor| factor.l().diagonal().min().powi(2) > SMALLEST_PIVOT)
}

/// T: the six components of R S R^T from those of S.
fn stress_transformation(r: &Matrix3<f64>) -> Matrix6<f64> {
    let mut t = Matrix6::zeros();
    for (column, (k, l)) in COMPONENTS.into_iter().enumerate() {
        for (row, (i, j)) in COMPONENTS.into_iter().enumerate() {
            let direct = r[(i, k)] * r[(j, l)];
            t[(row, column)] = if k == l { direct } else { direct + r[(i, l)] * r[(j, k)] };
        }
    }
    t
}
