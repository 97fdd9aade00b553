//! The tests of `truth` that need no process of their own, as one program: linked once, and both cores busy to the end.

mod beam;
mod convergence;
mod hidden_effects;
mod published;
mod steady_air;
mod steady_maneuvers;
mod unsteady_air;
mod wing_in_time;
