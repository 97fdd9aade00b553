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
use nastran::BeamStation;

type Row = SMatrix<f64, 1, 12>;

/// Mass in element axes about the element's ends.
pub(crate) fn consistent(section: Section, length: f64) -> Matrix12 {
    let mut mass = Matrix12::zeros();
    for (x, weight) in section.quadrature() {
        let (station, shape, dx) = (section.at(x), Shape::at(x, length), weight * length);
        let material = (section.material.rho * station.area, section.neutral_axis(x));
        for (per_length, offset) in [material, (station.nsm, section.nsm_offset(x))] {
            for row in shape.displacement(offset) {
                mass += row.transpose() * row * (per_length * dx);
            }
        }
        mass += shape.twist.transpose() * shape.twist * (twisting(section, x) * dx);
    }
    mass
}

/// As Nastran has it in decks: each line of mass is a beam of its own (cubic across, linear along) between what rigid arms make of the
/// element's ends. A bar without twisting inertia has along itself the mean of the lumped and the consistent mass: 5/12 and 1/12 of it
/// for 1/3 and 1/6.
pub(crate) fn as_nastran(section: Section, length: f64, has_twisting: bool) -> Matrix12 {
    type Line<'a> = (&'a dyn Fn(&BeamStation) -> f64, &'a dyn Fn(f64) -> Vector2<f64>);
    let rho = section.material.rho;
    let lines: [Line; 2] = [
        (&|station| rho * station.area, &|x| section.neutral_axis(x)),
        (&|station| station.nsm, &|x| section.nsm_offset(x)),
    ];
    let mut mass = Matrix12::zeros();
    for (per_length, offset) in lines {
        let mut own = Matrix12::zeros();
        for (x, weight) in section.quadrature() {
            for row in Shape::at(x, length).displacement(Vector2::zeros()) {
                own += row.transpose() * row * (per_length(&section.at(x)) * weight * length);
            }
        }
        let arms = rigid_arms([0.0, 1.0].map(offset));
        mass += arms.transpose() * own * arms;
    }
    let stretch = row(&[(0, -1.0), (6, 1.0)]);
    for (x, weight) in section.quadrature() {
        let (station, dx) = (section.at(x), weight * length);
        if has_twisting {
            let twist = row(&[(3, 1.0 - x), (9, x)]);
            mass += twist.transpose() * twist * (twisting(section, x) * dx);
        } else {
            mass += stretch.transpose() * stretch * ((rho * station.area + station.nsm) * dx / 12.0);
        }
    }
    mass
}

/// Motions of a line at both ends by those of the element, whose ends carry it on rigid arms (y, z).
fn rigid_arms(offsets: [Vector2<f64>; 2]) -> Matrix12 {
    let mut arms = Matrix12::identity();
    for (end, offset) in [0, 6].into_iter().zip(offsets) {
        (arms[(end, end + 4)], arms[(end, end + 5)]) = (offset.y, -offset.x);
        (arms[(end + 1, end + 3)], arms[(end + 2, end + 3)]) = (-offset.y, offset.x);
    }
    arms
}

/// Twisting inertia per length: rho (I1 + I2) + NSI.
fn twisting(section: Section, x: f64) -> f64 {
    let station = section.at(x);
    section.material.rho * (station.i1 + station.i2) + section.nsi(x)
}

/// Mass as points at the ends, in element axes: each line's mass goes to the ends by its lever, where it stands off the axis with
/// the inertia that it has there. A beam (PBEAM) also has its twisting inertia at the ends, a bar (PBAR) has none unless the NASTRAN
/// statement says BARMASS=1: what Nastran's lumped mass has.
pub(crate) fn lumped(section: Section, length: f64, has_twisting: bool) -> Matrix12 {
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
            if has_twisting {
                mass[(end + 3, end + 3)] += twisting(section, x) * dx * share;
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
