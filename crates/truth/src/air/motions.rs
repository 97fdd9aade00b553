//! How the wing moves in the air: columns of incidence by position and by velocity.

use super::lattice::Lattice;
use nalgebra::DMatrix;

/// Pairs of columns: the downwash that a unit of a motion asks for at the points of the lattice, per airspeed (`by_position`,
/// the slope) and by its rate (`by_rate`, m/s per unit rate).
#[derive(Debug, Clone, Default)]
pub struct Motions {
    by_position: Vec<Vec<f64>>,
    by_rate: Vec<Vec<f64>>,
}

impl Motions {
    /// Adds a motion in which every strip's quarter point rises by `height_m` and the strip turns nose up by `pitch_rad`.
    pub fn push_strips(&mut self, lattice: &Lattice, height_m: &[f64], pitch_rad: &[f64]) {
        let of = |ring: usize| ring / lattice.chordwise;
        let rings = 0..lattice.points_x_m.len();
        self.by_position.push(rings.clone().map(|ring| pitch_rad[of(ring)]).collect());
        let falling = |ring: usize| {
            let aft_m = lattice.points_x_m[ring] - lattice.strips[of(ring)].quarter_x_m();
            pitch_rad[of(ring)] * aft_m - height_m[of(ring)]
        };
        self.by_rate.push(rings.map(falling).collect());
    }

    /// Adds pitch about an axis.
    pub fn push_pitch(&mut self, lattice: &Lattice, axis_x_m: f64) {
        let height: Vec<f64> = lattice.strips.iter().map(|strip| axis_x_m - strip.quarter_x_m()).collect();
        self.push_strips(lattice, &height, &vec![1.0; lattice.strips.len()]);
    }

    /// Adds a flap: the rear `chord_share` of the strips between two places of the span, trailing edge down about its hinge,
    /// whose sweep has the cosine `hinge_cos`: along the stream the slope is that much less than the deflection. A point speaks for the stretch from its ring's vortex to the next, and moves by the share of it behind the hinge; strips
    /// that an end of the flap cuts likewise.
    pub fn push_flap(&mut self, lattice: &Lattice, y_m: (f64, f64), chord_share: f64, hinge_cos: f64) {
        let n = lattice.chordwise as f64;
        let (mut turned, mut falling) = (Vec::new(), Vec::new());
        for (ring, x_m) in lattice.points_x_m.iter().enumerate() {
            let strip = &lattice.strips[ring / lattice.chordwise];
            let (inner, outer) = (strip.y_m - 0.5 * strip.width_m, strip.y_m + 0.5 * strip.width_m);
            let beside = ((outer.min(y_m.1) - inner.max(y_m.0)) / strip.width_m).clamp(0.0, 1.0);
            let rear = (lattice.share(ring) + 0.5 / n - (1.0 - chord_share)) * n;
            let share = hinge_cos * beside * rear.clamp(0.0, 1.0);
            let hinge_m = strip.leading_x_m + (1.0 - chord_share) * strip.chord_m;
            turned.push(share);
            falling.push(share * (x_m - hinge_m));
        }
        self.by_position.push(turned);
        self.by_rate.push(falling);
    }

    /// Adds a gust-like incidence of single strips, by strip.
    pub fn push_incidence(&mut self, lattice: &Lattice, by_strip: &[f64]) {
        let of = |ring: usize| by_strip[ring / lattice.chordwise];
        self.by_position.push((0..lattice.points_x_m.len()).map(of).collect());
        self.by_rate.push(vec![0.0; lattice.points_x_m.len()]);
    }

    /// Number of motions.
    pub fn len(&self) -> usize {
        self.by_position.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.by_position.is_empty()
    }

    /// All columns: positions, then rates.
    pub(crate) fn columns(&self) -> DMatrix<f64> {
        let all: Vec<&Vec<f64>> = self.by_position.iter().chain(&self.by_rate).collect();
        let rows = all.first().map_or(0, |column| column.len());
        DMatrix::from_fn(rows, all.len(), |i, j| all[j][i])
    }
}
