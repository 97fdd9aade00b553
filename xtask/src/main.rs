//! `cargo xtask NAME`: every command of `wingroot`, on the repository's example where nothing is named, and those that only
//! developers need.

use std::process::ExitCode;

fn main() -> ExitCode {
    xtask::main()
}
