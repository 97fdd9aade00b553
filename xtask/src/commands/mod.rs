//! Commands of developers: one file each, with its options and `run`.

pub(crate) mod bench;
mod bench_aircraft;
mod bench_chirp;
mod bench_clock;
mod bench_discover;
mod bench_dlm;
mod bench_general;
mod bench_structure;
mod bench_trim;
pub(crate) mod decks;
mod decks_broken;
mod decks_factorised;
pub(crate) mod mutants;
pub(crate) mod tidy;
pub(crate) mod trust;
mod trust_campaign;
mod trust_flight;
mod trust_generator;
mod trust_judged;
pub(crate) mod validate;
