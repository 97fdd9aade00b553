//! `cargo xtask NAME`: the commands of wingroot. `cargo xtask --help` lists them.

use std::process::ExitCode;

fn main() -> ExitCode {
    xtask::main()
}
