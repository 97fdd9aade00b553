//! The tests of `response` that need no process of their own, as one program: linked once, and both cores busy to the end.

mod criteria;
mod designs;
mod factorial_examples;
mod laws;
mod mav_asymmetry;
mod mav_claims;
mod mav_coverage;
mod mav_generator;
mod mav_models;
mod missing;
mod nist;
mod random_blocks;
mod recovery;
mod wrong_data;
