//! The tests of `discover` that need no process of their own, as one program: linked once, and both cores busy to the end.

mod common;
mod data_checks;
mod held_out;
mod known;
mod locate;
mod null_key;
mod rules;
mod search;
mod stated_noise;
mod verdict;
