//! `completions`: what a shell needs to complete the commands and their options.

use clap::{Args, CommandFactory};
use clap_complete::Shell;

use crate::args::Common;
use crate::cli::Cli;
use crate::failure::Failure;
use crate::show;

/// Options of `completions`.
#[derive(Debug, Clone, Args)]
#[command(after_help = "Examples:
  wingroot completions bash > ~/.local/share/bash-completion/completions/wingroot
  wingroot completions zsh > ~/.zfunc/_wingroot
  wingroot completions fish > ~/.config/fish/completions/wingroot.fish")]
pub struct CompletionsArgs {
    /// For which shell
    #[arg(value_name = "SHELL")]
    shell: Shell,
}

/// Prints the script.
pub(crate) fn run(args: &CompletionsArgs, _: &Common) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut Cli::command(), "wingroot", &mut script);
    show::text(&String::from_utf8_lossy(&script))
}
