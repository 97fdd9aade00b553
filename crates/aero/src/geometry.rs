//! One box: its points, normal, pitch axis and area.
//!
//! Corner order, seen from above: 1 leading edge side 1, 2 trailing edge side 1, 3 trailing edge side 2, 4 leading
//! edge side 2. The averages of opposite edges define everything else, as in PanelAero and Loads Kernel:
//! lm = ((c2-c1) + (c3-c4))/2 and bm = ((c4-c1) + (c3-c2))/2.

use nalgebra::{Point3, Vector3};

/// One box of a lattice.
#[derive(Debug, Clone, PartialEq)]
pub struct AeroBox {
    /// Identification number, unique in the lattice.
    pub id: u32,
    /// Corners 1 to 4 in m, basic axes: see the module.
    pub corners: [Point3<f64>; 4],
}

impl AeroBox {
    /// Mean of the two side chords, m.
    fn mean_chord(&self) -> Vector3<f64> {
        let [c1, c2, c3, c4] = &self.corners;
        ((c2 - c1) + (c3 - c4)) / 2.0
    }

    /// Mean of leading and trailing edge from side 1 to side 2, m.
    fn mean_span(&self) -> Vector3<f64> {
        let [c1, c2, c3, c4] = &self.corners;
        ((c4 - c1) + (c3 - c2)) / 2.0
    }

    /// Chord at mid-strip along x, m.
    pub fn chord_m(&self) -> f64 {
        self.mean_chord().x
    }

    /// Area, m2.
    pub fn area_m2(&self) -> f64 {
        self.mean_chord().cross(&self.mean_span()).norm()
    }

    /// Width across the stream, m.
    pub fn width_m(&self) -> f64 {
        let b = self.mean_span();
        b.y.hypot(b.z)
    }

    /// Unit normal (c2-c1) x (c4-c1): up if side 2 is right of side 1. Pressure jumps along it are positive.
    pub fn normal(&self) -> Vector3<f64> {
        let [c1, c2, c3, c4] = &self.corners;
        // A triangle with its point at side 1 has no c2-c1; the mean edges give the same direction.
        let n = (c2 - c1).cross(&(c4 - c1));
        let scale = self.area_m2();
        if n.norm() > 1e-9 * scale { n.normalize() } else { (c3 - c4).cross(&(c4 - c1)).normalize() }
    }

    /// Unit pitch axis n x x: a rotation about it is nose up with respect to the normal.
    pub fn pitch_axis(&self) -> Vector3<f64> {
        self.normal().cross(&Vector3::x()).normalize()
    }

    /// The point at `fraction` of the chord at mid-strip.
    fn chord_point(&self, fraction: f64) -> Point3<f64> {
        let [c1, _, _, c4] = &self.corners;
        c1 + self.mean_chord() * fraction + (c4 - c1) * 0.5
    }

    /// Quarter-chord point at mid-strip: loads act here.
    pub fn quarter_point(&self) -> Point3<f64> {
        self.chord_point(0.25)
    }

    /// Midpoint: k-set displacements and moments refer to it.
    pub fn mid_point(&self) -> Point3<f64> {
        self.chord_point(0.5)
    }

    /// Three-quarter-chord point at mid-strip: incidences are taken here.
    pub fn three_quarter_point(&self) -> Point3<f64> {
        self.chord_point(0.75)
    }

    /// Ends of the bound vortex at the quarter points of side 1 and side 2.
    pub fn bound_vortex(&self) -> [Point3<f64>; 2] {
        let [c1, c2, c3, c4] = &self.corners;
        [c1 + (c2 - c1) * 0.25, c4 + (c3 - c4) * 0.25]
    }
}
