//! The commands of wingroot.
fn main() {}
