//! The tests of `xtask` that need no process of their own, as one program: linked once, and both cores busy to the end.

mod contributing;
mod kept;
mod tidy;
mod tidy_rules;
mod validate;
