//! The tests of `hidden` that need no process of their own, as one program: linked once, and both cores busy to the end.

mod laws;
mod scoring;
mod two_lattices;
