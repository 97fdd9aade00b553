//! What a section of the lay-up is as a beam, by the formulas of thin-walled closed sections: bending stiffness by
//! integrals along the contour, torsion by Bredt (one cell between two webs each), the core as a thin solid.
//!
//! The section is cut along x. A cut square to a swept axis is shorter by the cosine of the sweep, and so are its
//! stiffnesses and its mass per length of that axis; mass per unit of y is the same.

use super::contour::{Contour, SIDES, Side};
use super::layup::Layup;
use super::settings::{ShellSolid, Surface};
use crate::planform::Planform;
use nalgebra::{DMatrix, DVector, Matrix3};
use nastran::{InputError, Ply};
use std::path::Path;

/// Stiffness and mass of one section.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SectionIntegrals {
    /// Bending stiffness about the chord direction through the tension centre, N m².
    pub ei_flap_nm2: f64,
    /// Bending stiffness about the normal of the chord, N m².
    pub ei_lag_nm2: f64,
    /// Torsional stiffness, N m².
    pub gj_nm2: f64,
    /// Mass per unit of y, kg/m.
    pub mass_kg_m: f64,
    /// Centre of gravity over the chord.
    pub centre_of_gravity: f64,
    /// Tension centre over the chord.
    pub tension_centre: f64,
}

/// Sums over the section, z up and x aft from the leading edge, m.
#[derive(Default)]
struct Sums {
    ea: f64,
    ea_x: f64,
    ea_z: f64,
    ea_xx: f64,
    ea_zz: f64,
    mass: f64,
    mass_x: f64,
}

impl Sums {
    fn add(&mut self, [x, z]: [f64; 2], ea: f64, mass: f64) {
        self.ea += ea;
        self.ea_x += ea * x;
        self.ea_z += ea * z;
        self.ea_xx += ea * x * x;
        self.ea_zz += ea * z * z;
        self.mass += mass;
        self.mass_x += mass * x;
    }
}

/// A section while it is integrated.
struct Cut<'wing> {
    layup: Layup<'wing>,
    contour: Contour,
    y_m: f64,
    chord_m: f64,
}

impl ShellSolid {
    /// The lay-up's beam properties at a span station; the airfoil's name is relative to `folder`.
    ///
    /// # Errors
    /// If the airfoil cannot be read.
    pub fn section_integrals(
        &self,
        planform: &Planform,
        folder: &Path,
        y_m: f64,
    ) -> Result<SectionIntegrals, InputError> {
        let contour = Contour::read(planform, folder)?;
        let chord_m = planform.chord_m(y_m);
        let cut = Cut { layup: Layup { settings: self, planform }, contour, y_m, chord_m };
        let mut sums = Sums::default();
        cut.add_skin(&mut sums);
        cut.add_webs(&mut sums);
        cut.add_core(&mut sums);
        for item in &self.line_masses {
            sums.add([item.x_over_c * chord_m, 0.0], 0.0, item.mass_kg_m);
        }
        Ok(SectionIntegrals {
            ei_flap_nm2: sums.ea_zz - sums.ea_z.powi(2) / sums.ea,
            ei_lag_nm2: sums.ea_xx - sums.ea_x.powi(2) / sums.ea,
            gj_nm2: cut.bredt() + cut.core_torsion(),
            mass_kg_m: sums.mass,
            centre_of_gravity: sums.mass_x / sums.mass / chord_m,
            tension_centre: sums.ea_x / sums.ea / chord_m,
        })
    }
}

impl Cut<'_> {
    /// Axial and shear stiffness per width of a laminate, and its mass.
    fn laminate(&self, surface: Surface, cell: [f64; 2]) -> (f64, f64, f64) {
        let plies = self.layup.plies(surface, self.y_m, Some(cell));
        let stiffness: Matrix3<f64> = plies.iter().map(|ply| self.membrane(ply)).sum();
        let flexibility = stiffness.try_inverse().unwrap_or_else(Matrix3::zeros);
        let inverse = |f: f64| if f > 0.0 { 1.0 / f } else { 0.0 };
        (inverse(flexibility[(0, 0)]), inverse(flexibility[(2, 2)]), self.layup.mass_kg_m2(&plies))
    }

    /// A ply's plane stress stiffness times its thickness, turned by its angle (Jones, Mechanics of Composite
    /// Materials, eq. 2.85): stresses along and across the axis and in shear.
    fn membrane(&self, ply: &Ply) -> Matrix3<f64> {
        let Some(material) = self.layup.material(ply) else { return Matrix3::zeros() };
        let nu21 = material.nu12 * material.e2_pa / material.e1_pa;
        let scale = 1.0 / (1.0 - material.nu12 * nu21);
        let q12 = scale * material.nu12 * material.e2_pa;
        let q = Matrix3::new(
            scale * material.e1_pa,
            q12,
            0.0,
            q12,
            scale * material.e2_pa,
            0.0,
            0.0,
            0.0,
            material.g12_pa,
        );
        let (s, c) = ply.angle_deg.to_radians().sin_cos();
        let strain =
            Matrix3::new(c * c, s * s, s * c, s * s, c * c, -s * c, -2.0 * s * c, 2.0 * s * c, c * c - s * s);
        strain.transpose() * q * strain * ply.thickness
    }

    /// Each piece of the contour with its surface, ends (over the chord) and length in m.
    fn pieces(&self, side: Side, from: f64, to: f64) -> impl Iterator<Item = ([[f64; 2]; 2], f64)> {
        let points = self.contour.points(side, from, to);
        let chord_m = self.chord_m;
        (1..points.len()).map(move |end| {
            let ends = [points[end - 1], points[end]];
            (ends, chord_m * (ends[1][0] - ends[0][0]).hypot(ends[1][1] - ends[0][1]))
        })
    }

    fn add_skin(&self, sums: &mut Sums) {
        let finish = self.layup.settings.finish_kg_m2;
        for side in SIDES {
            for (ends, length_m) in self.pieces(side, 0.0, 1.0) {
                let (axial, _, mass) = self.laminate(surface(side), [ends[0][0], ends[1][0]]);
                let middle = [0, 1].map(|axis| 0.5 * (ends[0][axis] + ends[1][axis]) * self.chord_m);
                sums.add(middle, axial * length_m, (mass + finish) * length_m);
            }
        }
    }

    fn add_webs(&self, sums: &mut Sums) {
        for x in self.webs() {
            let (axial, _, mass) = self.laminate(Surface::Webs, [0.0, 1.0]);
            let (low, high) = (self.contour.height(Side::Lower, x), self.contour.height(Side::Upper, x));
            let length_m = (high - low) * self.chord_m;
            // Two points have a web's first and second moment.
            for share in [0.5 - 0.5 / 3.0_f64.sqrt(), 0.5 + 0.5 / 3.0_f64.sqrt()] {
                let z_m = (low + share * (high - low)) * self.chord_m;
                sums.add([x * self.chord_m, z_m], 0.5 * axial * length_m, 0.5 * mass * length_m);
            }
        }
    }

    fn add_core(&self, sums: &mut Sums) {
        let foam = self.layup.settings.foam;
        let [low, high] = SIDES.map(|side| self.contour.points(side, 0.0, 1.0));
        for (low, high) in low.windows(2).zip(high.windows(2)) {
            let width_m = (low[1][0] - low[0][0]) * self.chord_m;
            let x_m = 0.5 * (low[0][0] + low[1][0]) * self.chord_m;
            let z = |pair: &[[f64; 2]]| 0.5 * (pair[0][1] + pair[1][1]) * self.chord_m;
            let (z_low, z_high) = (z(low), z(high));
            let area = width_m * (z_high - z_low);
            for share in [0.5 - 0.5 / 3.0_f64.sqrt(), 0.5 + 0.5 / 3.0_f64.sqrt()] {
                let z_m = z_low + share * (z_high - z_low);
                sums.add([x_m, z_m], 0.5 * foam.e_pa * area, 0.5 * foam.rho_kg_m3 * area);
            }
        }
    }

    /// Places of the webs on the chord, ascending.
    fn webs(&self) -> Vec<f64> {
        let settings = self.layup.settings;
        let lines = settings.chord_lines(self.layup.planform.boxes.chordwise);
        let mut webs: Vec<f64> = settings.web_lines(&lines).into_iter().map(|line| lines[line]).collect();
        webs.sort_by(f64::total_cmp);
        webs
    }

    /// Bredt's formula for a row of cells: the shear flows q of all cells under unit twist satisfy
    /// `sum over the walls of (q - q beyond) ds/(G t) = 2 A`, and GJ is twice the sum of q A.
    fn bredt(&self) -> f64 {
        let mut edges = vec![0.0];
        edges.extend(self.webs());
        edges.push(1.0);
        let cells = edges.len() - 1;
        let (mut walls, mut areas) = (DMatrix::<f64>::zeros(cells, cells), DVector::<f64>::zeros(cells));
        for (cell, ends) in edges.windows(2).enumerate() {
            for side in SIDES {
                for (piece, length_m) in self.pieces(side, ends[0], ends[1]) {
                    let (_, shear, _) = self.laminate(surface(side), [piece[0][0], piece[1][0]]);
                    walls[(cell, cell)] += length_m / shear;
                    let sign = if side == Side::Upper { 1.0 } else { -1.0 };
                    let mean = 0.5 * (piece[0][1] + piece[1][1]);
                    areas[cell] += sign * mean * (piece[1][0] - piece[0][0]) * self.chord_m.powi(2);
                }
            }
            if cell + 1 < cells {
                let (_, shear, _) = self.laminate(Surface::Webs, [0.0, 1.0]);
                let web = self.contour.thickness(ends[1]) * self.chord_m / shear;
                walls[(cell, cell)] += web;
                walls[(cell + 1, cell + 1)] += web;
                walls[(cell, cell + 1)] -= web;
                walls[(cell + 1, cell)] -= web;
            }
        }
        let flows = walls.lu().solve(&(&areas * 2.0)).unwrap_or_else(|| DVector::zeros(cells));
        2.0 * flows.dot(&areas)
    }

    /// A thin solid's torsional stiffness, G/3 times the integral of the cubed thickness along the chord.
    fn core_torsion(&self) -> f64 {
        let foam = self.layup.settings.foam;
        let points = self.contour.points(Side::Upper, 0.0, 1.0);
        let cubed = |pair: &[[f64; 2]]| {
            let middle = 0.5 * (pair[0][0] + pair[1][0]);
            self.contour.thickness(middle).powi(3) * (pair[1][0] - pair[0][0])
        };
        let integral: f64 = points.windows(2).map(cubed).sum();
        foam.e_pa / (2.0 * (1.0 + foam.nu)) * integral * self.chord_m.powi(4) / 3.0
    }
}

fn surface(side: Side) -> Surface {
    match side {
        Side::Lower => Surface::Lower,
        Side::Upper => Surface::Upper,
    }
}

#[cfg(test)]
mod tests;
