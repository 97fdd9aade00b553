//! Flat half wings beside a plane of symmetry at y = 0, and their coefficients.

use aero::{AeroBox, Lattice, MirrorPlane, SteadyAero, incidence};
use nalgebra::Point3;

/// The plane of symmetry.
pub(crate) const WALL: MirrorPlane = MirrorPlane::Symmetric { y_m: 0.0 };

/// Half wing: semispan, root and tip chord, x of the tip's leading edge.
#[derive(Clone, Copy)]
pub(crate) struct Planform {
    pub(crate) semispan: f64,
    pub(crate) root: f64,
    pub(crate) tip: f64,
    pub(crate) tip_x: f64,
}

impl Planform {
    /// Untapered wing of chord 1.
    pub(crate) fn constant_chord(aspect_ratio: f64, sweep_deg: f64) -> Self {
        let semispan = aspect_ratio / 2.0;
        Self { semispan, root: 1.0, tip: 1.0, tip_x: semispan * sweep_deg.to_radians().tan() }
    }

    pub(crate) fn area(&self) -> f64 {
        self.semispan * f64::midpoint(self.root, self.tip)
    }

    /// Boxes with the given fractions of span and chord.
    pub(crate) fn lattice(&self, eta: &[f64], xi: &[f64]) -> Lattice {
        let point = |e: f64, x: f64| {
            let chord = self.root + (self.tip - self.root) * e;
            Point3::new(self.tip_x * e + chord * x, self.semispan * e, 0.0)
        };
        let mut boxes = Vec::new();
        for e in eta.windows(2) {
            for x in xi.windows(2) {
                let corners = [point(e[0], x[0]), point(e[0], x[1]), point(e[1], x[1]), point(e[1], x[0])];
                boxes.push(AeroBox { id: 1 + u32::try_from(boxes.len()).unwrap(), corners });
            }
        }
        Lattice::from_corners("wing", xi.len() - 1, boxes).unwrap()
    }
}

pub(crate) fn uniform(n: u32) -> Vec<f64> {
    (0..=n).map(|i| f64::from(i) / f64::from(n)).collect()
}

pub(crate) fn pressures(lattice: &Lattice, plane: MirrorPlane, mach: f64, w: &[f64]) -> Vec<f64> {
    SteadyAero::new(lattice, plane, mach).unwrap().pressures_of(w)
}

/// Sum over the boxes of area cp times something.
pub(crate) fn sum(lattice: &Lattice, cp: &[f64], weight: impl Fn(&AeroBox) -> f64) -> f64 {
    lattice.boxes.iter().zip(cp).map(|(panel, cp)| panel.area_m2() * cp * weight(panel)).sum()
}

/// Section lift coefficients.
pub(crate) fn strips(lattice: &Lattice, cp: &[f64]) -> Vec<f64> {
    let chordwise = lattice.surfaces[0].chordwise;
    let of = |(boxes, cp): (&[AeroBox], &[f64])| {
        let lift: f64 = boxes.iter().zip(cp).map(|(panel, cp)| panel.area_m2() * cp).sum();
        lift / boxes.iter().map(AeroBox::area_m2).sum::<f64>()
    };
    lattice.boxes.chunks(chordwise).zip(cp.chunks(chordwise)).map(of).collect()
}

/// y of the strips' middles.
pub(crate) fn strip_places(lattice: &Lattice) -> Vec<f64> {
    lattice.boxes.iter().step_by(lattice.surfaces[0].chordwise).map(|panel| panel.mid_point().y).collect()
}

/// Lift slope, moment slope about the leading edge of the root (per unit of length) and pressures per rad.
pub(crate) fn slopes(planform: Planform, lattice: &Lattice, mach: f64) -> (f64, f64, Vec<f64>) {
    let cp = pressures(lattice, WALL, mach, &incidence::angle_of_attack(lattice));
    let lift = sum(lattice, &cp, |_| 1.0) / planform.area();
    let moment = -sum(lattice, &cp, |panel| panel.quarter_point().x) / planform.area();
    (lift, moment, cp)
}

pub(crate) fn lift_slope(planform: Planform, nchord: u32, nspan: u32) -> f64 {
    slopes(planform, &planform.lattice(&uniform(nspan), &uniform(nchord)), 0.0).0
}
