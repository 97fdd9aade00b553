//! Flat half wings beside a plane of symmetry at y = 0, and their coefficients.

use aero::{AeroBox, Lattice, MirrorPlane, SteadyAero, incidence};
use nalgebra::Point3;

/// The plane of symmetry.
pub const WALL: MirrorPlane = MirrorPlane::Symmetric { y_m: 0.0 };

/// Half wing: semispan, root and tip chord, x of the tip's leading edge.
#[derive(Debug, Clone, Copy)]
pub struct Planform {
    /// From the plane of symmetry to the tip.
    pub semispan: f64,
    /// Chord at the plane of symmetry.
    pub root: f64,
    /// Chord at the tip.
    pub tip: f64,
    /// x of the tip's leading edge; the root's is at 0.
    pub tip_x: f64,
}

impl Planform {
    /// Untapered wing of chord 1.
    pub fn constant_chord(aspect_ratio: f64, sweep_deg: f64) -> Self {
        let semispan = aspect_ratio / 2.0;
        Self { semispan, root: 1.0, tip: 1.0, tip_x: semispan * sweep_deg.to_radians().tan() }
    }

    /// Area of the half.
    pub fn area(&self) -> f64 {
        self.semispan * f64::midpoint(self.root, self.tip)
    }

    /// Boxes with the given fractions of span and chord.
    ///
    /// # Panics
    /// If the fractions do not ascend.
    pub fn lattice(&self, eta: &[f64], xi: &[f64]) -> Lattice {
        let point = |e: f64, x: f64| {
            let chord = self.root + (self.tip - self.root) * e;
            Point3::new(self.tip_x * e + chord * x, self.semispan * e, 0.0)
        };
        let mut boxes = Vec::new();
        for e in eta.windows(2) {
            for x in xi.windows(2) {
                let corners = [point(e[0], x[0]), point(e[0], x[1]), point(e[1], x[1]), point(e[1], x[0])];
                boxes.push(AeroBox {
                    id: 1 + u32::try_from(boxes.len()).expect("fewer boxes than numbers"),
                    corners,
                });
            }
        }
        Lattice::from_corners("wing", xi.len() - 1, boxes).expect("a flat wing of proper boxes")
    }
}

/// `n + 1` equidistant fractions from 0 to 1.
pub fn uniform(n: u32) -> Vec<f64> {
    (0..=n).map(|i| f64::from(i) / f64::from(n)).collect()
}

/// Pressure coefficients under the normalwash `w`.
///
/// # Panics
/// If the lattice crosses the plane or the Mach number is not below 1.
pub fn pressures(lattice: &Lattice, plane: MirrorPlane, mach: f64, w: &[f64]) -> Vec<f64> {
    SteadyAero::new(lattice, plane, mach).expect("a flat wing beside its plane of symmetry").pressures_of(w)
}

/// Sum over the boxes of area cp times something.
pub fn sum(lattice: &Lattice, cp: &[f64], weight: impl Fn(&AeroBox) -> f64) -> f64 {
    lattice.boxes.iter().zip(cp).map(|(panel, cp)| panel.area_m2() * cp * weight(panel)).sum()
}

/// Section lift coefficients.
pub fn strips(lattice: &Lattice, cp: &[f64]) -> Vec<f64> {
    let chordwise = lattice.surfaces[0].chordwise;
    let of = |(boxes, cp): (&[AeroBox], &[f64])| {
        let lift: f64 = boxes.iter().zip(cp).map(|(panel, cp)| panel.area_m2() * cp).sum();
        lift / boxes.iter().map(AeroBox::area_m2).sum::<f64>()
    };
    lattice.boxes.chunks(chordwise).zip(cp.chunks(chordwise)).map(of).collect()
}

/// y of the strips' middles.
pub fn strip_places(lattice: &Lattice) -> Vec<f64> {
    lattice.boxes.iter().step_by(lattice.surfaces[0].chordwise).map(|panel| panel.mid_point().y).collect()
}

/// Lift slope, moment slope about the leading edge of the root (per unit of length) and pressures per rad.
pub fn slopes(planform: Planform, lattice: &Lattice, mach: f64) -> (f64, f64, Vec<f64>) {
    let cp = pressures(lattice, WALL, mach, &incidence::angle_of_attack(lattice));
    let lift = sum(lattice, &cp, |_| 1.0) / planform.area();
    let moment = -sum(lattice, &cp, |panel| panel.quarter_point().x) / planform.area();
    (lift, moment, cp)
}

/// Lift slope per rad, uniform boxes, incompressible.
pub fn lift_slope(planform: Planform, nchord: u32, nspan: u32) -> f64 {
    slopes(planform, &planform.lattice(&uniform(nspan), &uniform(nchord)), 0.0).0
}
