//! The tests of `free` that need no process of their own, as one program: linked once, and both cores busy to the end.

mod files;
mod independent;
mod nulls;
mod search;
mod section;
