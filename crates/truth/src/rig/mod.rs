//! The wing on its balance: the beam's modes in the lattice's air, at rest and in time.

mod coupled;
mod flight;
mod structure;
mod swing;

pub use coupled::{Coupled, Rest};
pub use flight::{Flight, Inputs};
pub use structure::Structure;

use crate::air::{Lattice, Mesh};
use crate::wing::{Polars, Wing};

/// Acceleration of gravity, m/s² (ISO 80000-3).
pub const GRAVITY_M_S2: f64 = 9.806_65;

/// What all cases of a wing share: drawing, polars, lattice.
#[derive(Debug, Clone)]
pub struct Rig {
    /// The wing as drawn.
    pub wing: Wing,
    /// Its sections; flat plates without.
    pub polars: Option<Polars>,
    /// The lattice.
    pub lattice: Lattice,
    /// Slices of the beam.
    pub slices: usize,
    /// Modes that move.
    pub modes: usize,
}

/// Rings along the chord: what the tests beside Theodorsen's function use.
const CHORDWISE: usize = 16;
/// Strips to a metre of span.
const STRIPS_PER_M: f64 = 16.0;
/// What the stream travels in a step, m: an eighth of the mean chord of a wing like the shipped one.
const STEP_OVER_CHORD: f64 = 0.1;
/// Length of the wake before its last row, half spans.
const WAKE_SPANS: f64 = 8.0;

impl Rig {
    /// Lays the lattice over a wing.
    pub fn new(wing: Wing, polars: Option<Polars>) -> Self {
        let mesh = Mesh {
            chordwise: CHORDWISE,
            edges_m: edges(&wing, STRIPS_PER_M),
            step_m: STEP_OVER_CHORD * wing.planform.mean_chord_m(),
            wake_m: WAKE_SPANS * wing.planform.semispan_m,
        };
        let lattice = Lattice::new(&wing.planform, &mesh);
        Self { wing, polars, lattice, slices: 48, modes: 16 }
    }
}

/// Edges of strips: the wall, the root, the flaps' ends, the tip, and evenly between; two narrow ones at the tip.
fn edges(wing: &Wing, per_m: f64) -> Vec<f64> {
    let tip = wing.planform.semispan_m;
    let mut fixed = vec![wing.wall_y_m, 0.0, tip - 0.5 / per_m, tip];
    fixed.extend(wing.controls.iter().flat_map(|control| [control.y_m.0, control.y_m.1]));
    fixed.sort_by(f64::total_cmp);
    fixed.dedup_by(|a, b| (*a - *b).abs() < 0.2 / per_m);
    let mut edges = vec![fixed[0]];
    for pair in fixed.windows(2) {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few strips")]
        let count = ((pair[1] - pair[0]) * per_m).round().max(1.0) as u32;
        edges.extend((1..=count).map(|i| pair[0] + (pair[1] - pair[0]) * f64::from(i) / f64::from(count)));
    }
    edges
}
