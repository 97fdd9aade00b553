//! The tests of `maneuver` that need no process of their own, as one program: linked once, and both cores busy to the end.

mod bent_flutter;
mod bent_wings;
mod common;
mod decay;
mod deflection;
mod deflection_fit;
mod effects;
mod effects_closed_forms;
mod effects_contract;
mod effects_in_file;
mod effects_in_flight;
mod effects_laws;
mod flutter;
mod flutter_complete;
mod frequency_response;
#[path = "../../coupling/tests/large/mod.rs"]
mod large;
mod maneuver_files;
mod motion_kinds;
mod parts;
mod rig;
mod rom;
mod roots_that_begin;
mod runs;
mod small_laws;
mod stations;
mod unsteady;
