//! The tests of `tunnel` that need no process of their own, as one program: linked once, and both cores busy to the end.

mod campaign;
mod runs;
mod shipped;
