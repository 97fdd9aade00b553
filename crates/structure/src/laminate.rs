//! A shell's section: stiffness per width of membrane, bending, their coupling and transverse shear, and mass.
//!
//! Classical lamination theory with first-order shear deformation: N = A e + B k, M = B e + D k, V = S g, with
//! e + z k the strain at height z above the reference surface. Jones, *Mechanics of Composite Materials*, ch. 4.

use crate::plane_material::{PlaneMaterial, strain_rotation};
use nalgebra::{Matrix2, Matrix3, Matrix6, Vector6};

/// Coupling of membrane and bending below which it is rounding, over the geometric mean of both.
const COUPLED: f64 = 1e-9;

/// How transverse shear stiffness follows from the plies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ShearModel {
    /// From the equilibrium of the bending stresses in each plane (energy equivalence; for one isotropic layer this is
    /// 5/6 of G t). What Nastran does for PCOMP.
    Equilibrium,
    /// This factor times the sum of the plies' shear moduli times thickness (5/6 in most published tables).
    Factor(f64),
}

/// One ply where it lies: material, angle from the section's x axis, lower and upper surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlacedPly {
    /// Material in its own axes.
    pub material: PlaneMaterial,
    /// From the section's x axis to the fibres, towards y.
    pub angle_rad: f64,
    /// Height of its lower surface above the reference surface, m.
    pub z_low_m: f64,
    /// Height of its upper surface, m.
    pub z_high_m: f64,
}

/// A shell's section, in axes of its own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShellSection {
    /// A: membrane forces by membrane strains, N/m.
    pub membrane: Matrix3<f64>,
    /// B: membrane forces by curvatures, N.
    pub coupling: Matrix3<f64>,
    /// D: moments by curvatures, Nm.
    pub bending: Matrix3<f64>,
    /// S: transverse forces (xz, yz) by shear strains, N/m. Without shear flexibility it is a thousand times the
    /// membrane's shear stiffness, which is rigid beside bending and does not spoil the digits.
    pub shear: Matrix2<f64>,
    /// Mass per area, kg/m^2.
    pub mass_kg_m2: f64,
    /// The part of it that is not structural, kg/m^2.
    pub nsm_kg_m2: f64,
    /// First moment of the mass about the reference surface, kg/m.
    pub mass_moment_kg_m: f64,
    /// Second moment of the mass about the reference surface, kg.
    pub mass_inertia_kg: f64,
}

/// Shear stiffness of a section without shear flexibility, in units of its membrane shear stiffness.
const RIGID: f64 = 1e3;

impl ShellSection {
    /// Whether membrane and bending are coupled beyond rounding: a symmetric laminate of several plies sums to 1e-16 of its parts.
    pub fn is_coupled(&self) -> bool {
        self.coupling.amax() > COUPLED * (self.membrane.amax() * self.bending.amax()).sqrt()
    }

    /// Of plies from bottom to top; `nsm_kg_m2` is non-structural mass on the reference surface.
    pub fn laminate(plies: &[PlacedPly], nsm_kg_m2: f64, shear: ShearModel) -> Self {
        let mut section = Self {
            membrane: Matrix3::zeros(),
            coupling: Matrix3::zeros(),
            bending: Matrix3::zeros(),
            shear: Matrix2::zeros(),
            mass_kg_m2: nsm_kg_m2,
            nsm_kg_m2,
            mass_moment_kg_m: 0.0,
            mass_inertia_kg: 0.0,
        };
        for ply in plies {
            let q = ply.material.turned(ply.angle_rad).stiffness;
            let (low, high) = (ply.z_low_m, ply.z_high_m);
            let moments =
                [high - low, 0.5 * (high.powi(2) - low.powi(2)), (high.powi(3) - low.powi(3)) / 3.0];
            section.membrane += q * moments[0];
            section.coupling += q * moments[1];
            section.bending += q * moments[2];
            section.mass_kg_m2 += ply.material.density * moments[0];
            section.mass_moment_kg_m += ply.material.density * moments[1];
            section.mass_inertia_kg += ply.material.density * moments[2];
        }
        section.shear = match shear {
            ShearModel::Factor(factor) => {
                plies.iter().map(|ply| ply.shear() * (ply.z_high_m - ply.z_low_m)).sum::<Matrix2<f64>>()
                    * factor
            }
            ShearModel::Equilibrium => {
                Matrix2::new(by_equilibrium(plies, 0), 0.0, 0.0, by_equilibrium(plies, 1))
            }
        };
        section.with_finite_shear(plies.iter().map(|ply| ply.z_high_m - ply.z_low_m).sum())
    }

    /// The same section, `thickness_m` thick, with a rigid shear stiffness in the place of an infinite one and of any that is stiffer still (decks
    /// write moduli such as 1e15, beside which a membrane has no stiffness and AUTOSPC would hold it). What only bends
    /// has no membrane stiffness to measure it by: G t is then that of the bending stiffness, 12/t² G t³/12.
    #[must_use]
    pub fn with_finite_shear(mut self, thickness_m: f64) -> Self {
        let of_bending = 12.0 * self.bending[(2, 2)] / thickness_m.powi(2);
        let rigid = RIGID * if self.membrane[(2, 2)] > 0.0 { self.membrane[(2, 2)] } else { of_bending };
        if !self.shear.iter().all(|value| value.is_finite()) || self.shear.determinant() <= 0.0 {
            self.shear = Matrix2::identity() * rigid;
        }
        let share = [0, 1].map(|at| (rigid / self.shear[(at, at)]).min(1.0).sqrt());
        if share.iter().any(|share| *share < 1.0) {
            self.shear = Matrix2::from_fn(|i, j| share[i] * self.shear[(i, j)] * share[j]);
        }
        self
    }

    /// Its membrane stiffness and nothing else.
    #[must_use]
    pub fn membrane_alone(&self) -> Self {
        let (none, shear) = (Matrix3::zeros(), Matrix2::zeros());
        let (mass_kg_m2, nsm_kg_m2, mass_moment_kg_m, mass_inertia_kg) = (0.0, 0.0, 0.0, 0.0);
        let (membrane, coupling, bending) = (self.membrane, none, none);
        Self { membrane, coupling, bending, shear, mass_kg_m2, nsm_kg_m2, mass_moment_kg_m, mass_inertia_kg }
    }

    /// Whether membrane strains and curvatures together store energy, to rounding.
    pub fn stores_energy(&self) -> bool {
        let (a, b, d) = (&self.membrane, &self.coupling, &self.bending);
        let all = Matrix6::from_fn(|i, j| match (i / 3, j / 3) {
            (0, 0) => a[(i, j)],
            (1, 1) => d[(i - 3, j - 3)],
            (0, _) => b[(i, j - 3)],
            _ => b[(i - 3, j)],
        });
        let scale = Vector6::from_fn(|i, _| all[(i, i)].max(f64::MIN_POSITIVE).sqrt().recip());
        let scaled = Matrix6::from_fn(|i, j| scale[i] * all[(i, j)] * scale[j]);
        scaled.symmetric_eigenvalues().min() > -1e-9
    }

    /// The same section with all heights times `ratio`, as where a plate's thickness varies; non-structural mass stays.
    #[must_use]
    pub fn thickened(&self, ratio: f64) -> Self {
        Self {
            membrane: self.membrane * ratio,
            coupling: self.coupling * ratio.powi(2),
            bending: self.bending * ratio.powi(3),
            shear: self.shear * ratio,
            mass_kg_m2: (self.mass_kg_m2 - self.nsm_kg_m2) * ratio + self.nsm_kg_m2,
            nsm_kg_m2: self.nsm_kg_m2,
            mass_moment_kg_m: self.mass_moment_kg_m * ratio.powi(2),
            mass_inertia_kg: self.mass_inertia_kg * ratio.powi(3),
        }
    }

    /// The section in axes from which its own x axis is turned by `angle_rad` (from x towards y).
    #[must_use]
    pub fn turned(&self, angle_rad: f64) -> Self {
        let strain = strain_rotation(angle_rad);
        let plane = |matrix: &Matrix3<f64>| {
            let turned = strain.transpose() * matrix * strain;
            0.5 * (turned + turned.transpose())
        };
        let turn = nalgebra::Rotation2::new(angle_rad);
        let shear = turn.matrix() * self.shear * turn.matrix().transpose();
        Self {
            membrane: plane(&self.membrane),
            coupling: plane(&self.coupling),
            bending: plane(&self.bending),
            shear: 0.5 * (shear + shear.transpose()),
            ..*self
        }
    }
}

impl PlacedPly {
    fn shear(&self) -> Matrix2<f64> {
        self.material.turned_shear(self.angle_rad)
    }
}

/// Shear stiffness in plane `axis` (0: xz, 1: yz): the shear stress that balances the bending stress of a unit
/// transverse force, tau(z) = -(1/R) int E (z - z0) dz from the bottom, stores the energy 1/(2 S).
fn by_equilibrium(plies: &[PlacedPly], axis: usize) -> f64 {
    let modulus = |ply: &PlacedPly| ply.material.turned(ply.angle_rad).stiffness[(axis, axis)];
    let sum = |power: i32| -> f64 {
        plies
            .iter()
            .map(|ply| modulus(ply) * (ply.z_high_m.powi(power) - ply.z_low_m.powi(power)) / f64::from(power))
            .sum()
    };
    let neutral = sum(2) / sum(1);
    let rigidity = sum(3) - neutral * neutral * sum(1);
    let mut flexibility = 0.0;
    let mut flow = 0.0;
    for ply in plies {
        let (e, g) = (modulus(ply), ply.shear()[(axis, axis)]);
        let (low, high) = (ply.z_low_m - neutral, ply.z_high_m - neutral);
        // Within the ply tau is quadratic in z, its square quartic: three Gauss points are exact.
        for (point, weight) in [(-0.6_f64.sqrt(), 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.6_f64.sqrt(), 5.0 / 9.0)] {
            let z = 0.5 * (low + high) + 0.5 * (high - low) * point;
            let tau = (flow + 0.5 * e * (z * z - low * low)) / rigidity;
            flexibility += 0.5 * (high - low) * weight * tau * tau / g;
        }
        flow += 0.5 * e * (high * high - low * low);
    }
    1.0 / flexibility
}
