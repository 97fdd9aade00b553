//! Selection of the cases that go to stress, apart from flying and enveloping them.

pub mod file;
mod hull;
