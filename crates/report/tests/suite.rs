//! The tests of `report` that need no process of their own, as one program: linked once, and both cores busy to the end.

mod pages;
mod pictures;
