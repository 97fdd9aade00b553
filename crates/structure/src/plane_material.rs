//! Materials in plane stress: what a shell is made of.
//!
//! Stresses and strains are (x, y, xy) with the engineering shear strain; transverse ones are (xz, yz). Jones,
//! *Mechanics of Composite Materials*, ch. 2.

use nalgebra::{Matrix2, Matrix3, Rotation2};
use nastran::{InputError, Mat1, Mat2, Mat8};

/// A material in plane stress, in its own axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlaneMaterial {
    /// Q: stresses (x, y, xy) by strains, Pa.
    pub stiffness: Matrix3<f64>,
    /// Transverse shear moduli (xz, yz), Pa; a plane without shear flexibility has infinity.
    pub shear: [f64; 2],
    /// Density, kg/m^3.
    pub density: f64,
}

impl PlaneMaterial {
    /// An isotropic material (MAT1). In its plane E and NU decide, across it G, where a card gives all three and they differ: so Simcenter Nastran's
    /// print of pyNastran's `static_solid_shell_bar`.
    ///
    /// # Errors
    /// If its constants are not those of a material that stores energy.
    pub fn isotropic(card: &Mat1) -> Result<Self, InputError> {
        let g = card.g;
        let share = card.e / (1.0 - card.nu * card.nu);
        let in_plane = 0.5 * card.e / (1.0 + card.nu);
        let stiffness =
            Matrix3::new(share, card.nu * share, 0.0, card.nu * share, share, 0.0, 0.0, 0.0, in_plane);
        let material = Self { stiffness, shear: [g, g], density: card.rho };
        let is_sound = card.e > 0.0 && card.nu.abs() < 1.0 && g > 0.0 && g.is_finite();
        if is_sound && material.stiffness.iter().all(|v| v.is_finite()) {
            return Ok(material);
        }
        let message = format!(
            "MAT1 {} (E {}, G {}, NU {}) cannot be a shell's material",
            card.id, card.e, card.g, card.nu
        );
        Err(InputError::at(&card.span, message).with_help("E and G must be positive, NU between -1 and 1"))
    }

    /// An orthotropic ply (MAT8).
    ///
    /// # Errors
    /// As [`PlaneMaterial::isotropic`].
    pub fn ply(card: &Mat8) -> Result<Self, InputError> {
        let nu21 = card.nu12 * card.e2 / card.e1;
        let share = 1.0 - card.nu12 * nu21;
        let (q11, q22) = (card.e1 / share, card.e2 / share);
        let q12 = card.nu12 * q22;
        let stiffness = Matrix3::new(q11, q12, 0.0, q12, q22, 0.0, 0.0, 0.0, card.g12);
        let shear = [card.g1z, card.g2z].map(|g| if g == 0.0 { f64::INFINITY } else { g });
        let is_sound = card.e1 > 0.0 && card.e2 > 0.0 && card.g12 > 0.0 && share > 0.0;
        if is_sound && shear.iter().all(|g| *g > 0.0) && stiffness.iter().all(|v| v.is_finite()) {
            return Ok(Self { stiffness, shear, density: card.rho });
        }
        let message = format!(
            "MAT8 {} (E1 {}, E2 {}, NU12 {}, G12 {}) is not a material that stores energy",
            card.id, card.e1, card.e2, card.nu12, card.g12
        );
        let help = "E1, E2 and G12 must be positive, and NU12^2 less than E1/E2";
        Err(InputError::at(&card.span, message).with_help(help))
    }

    /// An anisotropic plane material (MAT2). As transverse shear material its G11, G12, G22 are the shear moduli;
    /// as a ply it has no transverse shear flexibility.
    ///
    /// # Errors
    /// If its matrix is not positive definite.
    pub fn anisotropic(card: &Mat2) -> Result<Self, InputError> {
        let [g11, g12, g13, g22, g23, g33] = card.g;
        let stiffness = Matrix3::new(g11, g12, g13, g12, g22, g23, g13, g23, g33);
        if stiffness.cholesky().is_some() {
            return Ok(Self { stiffness, shear: [f64::INFINITY; 2], density: card.rho });
        }
        let message = format!("MAT2 {}: its matrix is not positive definite", card.id);
        Err(InputError::at(&card.span, message).with_help("a strain in any direction must store energy"))
    }

    /// The same material seen from axes in which it is turned by `angle_rad` (from x towards y).
    #[must_use]
    pub fn turned(&self, angle_rad: f64) -> Self {
        let strain = strain_rotation(angle_rad);
        let stiffness = strain.transpose() * self.stiffness * strain;
        // Infinite moduli cannot be turned; a laminate treats them as none.
        Self { stiffness: 0.5 * (stiffness + stiffness.transpose()), ..*self }
    }

    /// Transverse shear moduli (xz, yz) as a matrix in axes from which the material is turned by `angle_rad`. A
    /// modulus that is infinite beside a finite one is taken as a thousand times that.
    pub fn turned_shear(&self, angle_rad: f64) -> Matrix2<f64> {
        let least = self.shear[0].min(self.shear[1]);
        if self.shear[0] == self.shear[1] {
            return Matrix2::new(least, 0.0, 0.0, least);
        }
        let [xz, yz] = self.shear.map(|g| if g.is_finite() { g } else { 1e3 * least });
        let turn = Rotation2::new(angle_rad);
        turn.matrix() * Matrix2::new(xz, 0.0, 0.0, yz) * turn.matrix().transpose()
    }
}

/// Strains (x, y, xy) in axes turned by `angle_rad` from those given.
pub fn strain_rotation(angle_rad: f64) -> Matrix3<f64> {
    let (s, c) = angle_rad.sin_cos();
    Matrix3::new(c * c, s * s, c * s, s * s, c * c, -c * s, -2.0 * c * s, 2.0 * c * s, c * c - s * s)
}
