//! Laminates of the published plates: one ply material, angles, simply supported edges.

use super::{Mesh, span};
use nastran::{Expansion, LaminateOption, Mat8, Pcomp, Ply};

/// A ply's elastic constants and density.
#[derive(Debug, Clone, Copy)]
pub struct PlyConstants {
    /// Young's modulus along the fibres.
    pub e1: f64,
    /// Young's modulus across.
    pub e2: f64,
    /// Poisson's ratio.
    pub nu12: f64,
    /// Shear moduli 12, 13, 23.
    pub g: [f64; 3],
    /// Density.
    pub rho: f64,
}

impl PlyConstants {
    /// With E2 = 1 and density 1: ratios as tables give them.
    pub fn ratios(e1: f64, g: [f64; 3]) -> Self {
        Self { e1, e2: 1.0, nu12: 0.25, g, rho: 1.0 }
    }

    /// The material card.
    pub fn card(&self) -> Mat8 {
        let [g12, g1z, g2z] = self.g;
        Mat8 {
            id: 1,
            e1: self.e1,
            e2: self.e2,
            nu12: self.nu12,
            g12,
            g1z,
            g2z,
            rho: self.rho,
            expansion: Expansion::default(),
            span: span(),
        }
    }
}

/// How the edges of a simply supported laminate move in its plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Support {
    /// SS-1: along the edge fixed, normal to it free (cross-ply solutions).
    AlongFixed,
    /// SS-2: normal to the edge fixed, along it free (angle-ply solutions).
    NormalFixed,
}

impl Mesh {
    /// Property 1 as a laminate of plies (angle in degrees, thickness).
    #[must_use]
    pub fn of_plies(mut self, ply: PlyConstants, plies: &[(f64, f64)]) -> Self {
        self.bulk.ply_materials.insert(1, ply.card());
        let plies = plies
            .iter()
            .map(|(angle_deg, thickness)| Ply {
                material: 1,
                thickness: *thickness,
                angle_deg: *angle_deg,
                global_id: None,
            })
            .collect();
        let laminate = Pcomp {
            id: 1,
            z0: None,
            nsm: 0.0,
            reference: 0.0,
            plies,
            option: LaminateOption::All,
            is_global: false,
            span: span(),
        };
        self.bulk.laminates.insert(1, laminate);
        self
    }

    /// Simple supports of all four edges of a rectangle along x (first coordinate) and y.
    #[must_use]
    pub fn simply_supported(self, support: Support) -> Self {
        let (nx, ny) = (self.nx, self.ny);
        // The rotation along an edge normal to x is the one about x, component 4.
        let (x_edge, y_edge): ([u8; 3], [u8; 3]) = match support {
            Support::AlongFixed => ([2, 3, 4], [1, 3, 5]),
            Support::NormalFixed => ([1, 3, 4], [2, 3, 5]),
        };
        self.clamped(&x_edge, |i, _| i == 0 || i == nx).clamped(&y_edge, |_, j| j == 0 || j == ny)
    }
}
