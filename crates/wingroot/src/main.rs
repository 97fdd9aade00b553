//! `wingroot NAME`: the program. `wingroot --help` lists its commands.

use std::process::ExitCode;

fn main() -> ExitCode {
    wingroot::main()
}
