//! Whether the boxes are small enough for unsteady aerodynamics, by the two usual rules of the doublet-lattice
//! method: box length below 0.08 V/f (a dozen boxes a wave length), and box aspect ratio below 3.

use super::Planform;

/// Longest allowed box as a share of the wave length V/f.
const LENGTH_PER_WAVE: f64 = 0.08;
/// Largest allowed width over length of a box.
const LARGEST_ASPECT_RATIO: f64 = 3.0;

impl Planform {
    /// Length of the longest box, at the longer of root and tip chord.
    pub fn longest_box_m(&self) -> f64 {
        self.root_chord_m.max(self.tip_chord_m) / self.boxes.chordwise as f64
    }

    /// Largest width over length of a box, the length taken at the shorter of its two sides.
    pub fn largest_box_aspect_ratio(&self) -> f64 {
        let slant = self.dihedral_deg.to_radians().cos();
        let aspect_ratio = |edges: &[f64]| {
            let chord_m = self.chord_m(edges[0]).min(self.chord_m(edges[1]));
            (edges[1] - edges[0]) / slant * self.boxes.chordwise as f64 / chord_m
        };
        self.strip_edges_m().windows(2).map(aspect_ratio).fold(0.0, f64::max)
    }

    /// Sentences about boxes too coarse for unsteady loads up to `f_max_hz` at `v_min_m_s` and above.
    pub fn warnings(&self, v_min_m_s: f64, f_max_hz: f64) -> Vec<String> {
        let mut warnings = Vec::new();
        let limit_m = LENGTH_PER_WAVE * v_min_m_s / f_max_hz;
        let longest_m = self.longest_box_m();
        if longest_m >= limit_m {
            warnings.push(format!(
                "the longest box is {longest_m:.4} m, but {f_max_hz} Hz at {v_min_m_s} m/s need boxes shorter than \
                 0.08 V/f = {limit_m:.4} m: use more chordwise boxes"
            ));
        }
        let ratio = self.largest_box_aspect_ratio();
        if ratio >= LARGEST_ASPECT_RATIO {
            warnings.push(format!(
                "the widest box is {ratio:.2} times as wide as long, expected less than {LARGEST_ASPECT_RATIO}: use \
                 more strips or fewer chordwise boxes"
            ));
        }
        warnings
    }
}
