//! The tests of `calibrate` that need no process of their own, as one program: linked once, and both cores busy to the end.

mod bent_wing;
mod centres;
mod checks;
mod common;
mod dead_weights;
mod ensemble;
#[path = "../../coupling/tests/large/mod.rs"]
mod large;
mod left_out;
mod planted;
mod posterior;
mod schedule;
mod sensors;
mod tip;
mod together;
mod weber_brebner;
mod weighting;
