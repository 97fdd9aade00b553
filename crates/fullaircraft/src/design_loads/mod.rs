//! Cases of a plan of design loads, flown: an aircraft for each state of loading, densities by altitude, loads at stations and nodes.

pub mod aircraft;
pub mod cost;
pub mod deck;
pub mod deck_gusts;
mod deck_motion;
mod deck_turbulence;
pub mod fly;
pub mod in_time;
pub mod instants;
mod search;
mod slowest;
#[cfg(test)]
mod small;
mod turbulence;
