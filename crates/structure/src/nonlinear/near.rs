//! What acts on a structure near a state, for the differences that make its stiffness.

use super::state::State;

/// What acts near the state it was made for.
pub trait Near {
    /// Forces and moments on the nodes at that state, N and Nm (g-set, basic axes, moments over spins).
    fn forces(&self) -> Vec<f64>;

    /// The part of these that follows the structure.
    fn following_here(&self) -> Vec<f64>;

    /// At a state beside it, the part that follows the structure: its differences are the stiffness of the load.
    fn following(&self, state: &State) -> Vec<f64>;
}
