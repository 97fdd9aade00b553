//! What acts on a structure that bends far, seen by Newton's method: forces at a state, and how they follow a small motion.

use super::loads::Loads;
use super::near::Near;
use super::state::State;
use super::structure::LargeDeflection;

/// Loads of any kind: a set of load cards, the air around a wing.
pub trait Acting: Sync {
    /// What acts at a state; nothing if it cannot be computed there (the step to it was too long).
    fn at<'a>(&'a self, structure: &'a LargeDeflection, state: &State) -> Option<Box<dyn Near + 'a>>;

    /// Whether it changes with the state (weight does not).
    fn follows(&self) -> bool;
}

/// A set of loads at a state.
struct Given<'a> {
    loads: &'a Loads,
    forces: Vec<f64>,
    following: Vec<f64>,
}

impl Acting for Loads {
    fn at<'a>(&'a self, structure: &'a LargeDeflection, state: &State) -> Option<Box<dyn Near + 'a>> {
        let (forces, following) = (structure.load_forces(state, self), self.following_at(state));
        Some(Box::new(Given { loads: self, forces, following }))
    }

    fn follows(&self) -> bool {
        !self.following.is_empty()
    }
}

impl Near for Given<'_> {
    fn forces(&self) -> Vec<f64> {
        self.forces.clone()
    }

    fn following_here(&self) -> Vec<f64> {
        self.following.clone()
    }

    fn following(&self, state: &State) -> Vec<f64> {
        self.loads.following_at(state)
    }
}
