//! The tests of `loads` that need no process of their own, as one program: linked once, and both cores busy to the end.

mod close;
mod common;
mod compare;
mod flight;
mod matrix;
mod plan;
mod plunge;
mod rules;
mod select;
mod turbulence;
