//! The wing on its balance: the beam's modes in the lattice's air, at rest and in time.

mod coupled;
mod flight;
mod maneuver;
mod structure;
mod swing;

pub use coupled::{Coupled, Rest};
pub use flight::{Flight, Inputs};
pub use maneuver::Steady;
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

/// How finely a wing is divided.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fineness {
    /// Rings along the chord.
    pub chordwise: usize,
    /// Strips to a metre of span.
    pub strips_per_m: f64,
    /// What the stream travels in a step, mean chords.
    pub step_over_chord: f64,
    /// Slices of the beam.
    pub slices: usize,
    /// Modes that move.
    pub modes: usize,
}

impl Fineness {
    /// That of campaigns; `tests/convergence.rs` says what is left.
    pub const CAMPAIGN: Self =
        Self { chordwise: 16, strips_per_m: 24.0, step_over_chord: 0.1, slices: 48, modes: 16 };
}

/// Length of the wake before its last row, half spans.
const WAKE_SPANS: f64 = 8.0;

impl Rig {
    /// The same wing with its image at the other side of the root, as on an aircraft: the wall is at the root, nothing stands between.
    #[must_use]
    pub fn on_aircraft(&self) -> Self {
        Self::new(Wing { wall_y_m: 0.0, ..self.wing.clone() }, self.polars.clone())
    }

    /// Lays the lattice of campaigns over a wing.
    pub fn new(wing: Wing, polars: Option<Polars>) -> Self {
        Self::divided(wing, polars, Fineness::CAMPAIGN)
    }

    /// Lays a lattice over a wing.
    pub fn divided(wing: Wing, polars: Option<Polars>, fineness: Fineness) -> Self {
        let mesh = Mesh {
            chordwise: fineness.chordwise,
            edges_m: edges(&wing, fineness.strips_per_m),
            step_m: fineness.step_over_chord * wing.planform.mean_chord_m(),
            wake_m: WAKE_SPANS * wing.planform.semispan_m,
        };
        let lattice = Lattice::new(&wing.planform, &mesh);
        Self { wing, polars, lattice, slices: fineness.slices, modes: fineness.modes }
    }
}

/// Share of the way from even strips to those of a cosine, narrow beside flaps' ends and tip, where the lift is steep.
const CROWDED: f64 = 0.6;

/// Edges of strips: the wall, the root, the flaps' ends, the tip, and between them.
fn edges(wing: &Wing, per_m: f64) -> Vec<f64> {
    let tip = wing.planform.semispan_m;
    let mut fixed = vec![wing.wall_y_m, 0.0, tip];
    fixed.extend(wing.controls.iter().flat_map(|control| [control.y_m.0, control.y_m.1]));
    fixed.sort_by(f64::total_cmp);
    fixed.dedup_by(|a, b| (*a - *b).abs() < 0.2 / per_m);
    let mut edges = vec![fixed[0]];
    for pair in fixed.windows(2) {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few strips")]
        let count = ((pair[1] - pair[0]) * per_m).round().max(1.0) as u32;
        let place = |i: u32| {
            let even = f64::from(i) / f64::from(count);
            let crowded = 0.5 * (1.0 - (std::f64::consts::PI * even).cos());
            even + CROWDED * (crowded - even)
        };
        edges.extend((1..=count).map(|i| pair[0] + (pair[1] - pair[0]) * place(i)));
    }
    edges
}
