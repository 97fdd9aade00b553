//! Consistent and lumped mass of a beam element.
//!
//! M = int N^T m N dx with the Euler-Bernoulli shape functions (cubic bending, linear axial and twist) at the
//! line on which the mass stands: material mass rho A on the neutral axis, non-structural mass on its own line.
//! Twisting inertia is rho (I1 + I2) + NSI. The rotary inertia of bending (rho I per length) is left out, as
//! Euler-Bernoulli theory does; so is the influence of shear factors and pin flags on the shape functions.
//! Any rigid motion is contained in the shape functions, so mass, centre and moments of inertia are those of the
//! mass line itself.

use crate::beam::Matrix12;
use crate::section::Section;
use nalgebra::{SMatrix, Vector2};

type Row = SMatrix<f64, 1, 12>;

/// Mass in element axes about the element's ends.
pub(crate) fn consistent(section: Section, length: f64) -> Matrix12 {
    let mut mass = of_lines(section, length);
    for (x, weight) in section.quadrature() {
        let station = section.at(x);
        let twist = Shape::at(x, length).twist;
        let twisting = section.material.rho * (station.i1 + station.i2) + section.nsi(x);
        mass += twist.transpose() * twist * (twisting * weight * length);
    }
    mass
}

/// As CBAR of a deck, whose mass in Nastran has no twisting inertia (unless the NASTRAN statement says BARMASS=1) and along the bar is the mean of the
/// lumped and the consistent one: 5/12 and 1/12 of it for 1/3 and 1/6.
pub(crate) fn of_bar(section: Section, length: f64) -> Matrix12 {
    let mut mass = of_lines(section, length);
    let stretch = row(&[(0, -1.0), (6, 1.0)]);
    for (x, weight) in section.quadrature() {
        let station = section.at(x);
        let per_length = section.material.rho * station.area + station.nsm;
        mass += stretch.transpose() * stretch * (per_length * weight * length / 12.0);
    }
    mass
}

/// Of the lines on which the mass stands, without twisting inertia.
fn of_lines(section: Section, length: f64) -> Matrix12 {
    let mut mass = Matrix12::zeros();
    for (x, weight) in section.quadrature() {
        let station = section.at(x);
        let shape = Shape::at(x, length);
        let dx = weight * length;
        let material = (section.material.rho * station.area, section.neutral_axis(x));
        for (per_length, offset) in [material, (station.nsm, section.nsm_offset(x))] {
            for row in shape.displacement(offset) {
                mass += row.transpose() * row * (per_length * dx);
            }
        }
    }
    mass
}

/// Mass as points at the ends, in element axes: each line's mass goes to the ends by its lever, where it stands off the axis with
/// the inertia that it has there. A beam (PBEAM) also has its twisting inertia at the ends, a bar (PBAR) has none: what Nastran's
/// lumped mass has.
pub(crate) fn lumped(section: Section, length: f64) -> Matrix12 {
    let mut mass = Matrix12::zeros();
    for (x, weight) in section.quadrature() {
        let station = section.at(x);
        let dx = weight * length;
        let rho = section.material.rho;
        for (end, share) in [(0, 1.0 - x), (6, x)] {
            for (per_length, offset) in
                [(rho * station.area, section.neutral_axis(x)), (station.nsm, section.nsm_offset(x))]
            {
                let rows = [
                    row(&[(end, 1.0), (end + 4, offset.y), (end + 5, -offset.x)]),
                    row(&[(end + 1, 1.0), (end + 3, -offset.y)]),
                    row(&[(end + 2, 1.0), (end + 3, offset.x)]),
                ];
                for row in rows {
                    mass += row.transpose() * row * (per_length * dx * share);
                }
            }
            if section.property.is_beam {
                let twisting = rho * (station.i1 + station.i2) + section.nsi(x);
                mass[(end + 3, end + 3)] += twisting * dx * share;
            }
        }
    }
    mass
}

/// Displacements and slopes of the element axis at one place, as rows over the twelve end displacements.
struct Shape {
    u: Row,
    v: Row,
    w: Row,
    twist: Row,
    theta_y: Row,
    theta_z: Row,
}

impl Shape {
    fn at(x: f64, length: f64) -> Self {
        let (x2, x3) = (x * x, x * x * x);
        let cubic = [
            1.0 - 3.0 * x2 + 2.0 * x3,
            length * (x - 2.0 * x2 + x3),
            3.0 * x2 - 2.0 * x3,
            length * (x3 - x2),
        ];
        let slope =
            [6.0 * (x2 - x) / length, 1.0 - 4.0 * x + 3.0 * x2, 6.0 * (x - x2) / length, 3.0 * x2 - 2.0 * x];
        let linear = |at: usize| row(&[(at, 1.0 - x), (at + 6, x)]);
        // theta_z = dv/dx, theta_y = -dw/dx
        let plane_1 = |f: [f64; 4]| row(&[(1, f[0]), (5, f[1]), (7, f[2]), (11, f[3])]);
        let plane_2 = |f: [f64; 4]| row(&[(2, f[0]), (4, -f[1]), (8, f[2]), (10, -f[3])]);
        Self {
            u: linear(0),
            v: plane_1(cubic),
            w: plane_2(cubic),
            twist: linear(3),
            theta_y: -plane_2(slope),
            theta_z: plane_1(slope),
        }
    }

    /// The three displacements of a line at (y, z) of the section: u + theta x (0, y, z).
    fn displacement(&self, offset: Vector2<f64>) -> [Row; 3] {
        let (y, z) = (offset.x, offset.y);
        [self.u + self.theta_y * z - self.theta_z * y, self.v - self.twist * z, self.w + self.twist * y]
    }
}

fn row(entries: &[(usize, f64)]) -> Row {
    let mut row = Row::zeros();
    for (at, value) in entries {
        row[*at] = *value;
    }
    row
}
