//! The command line.

use clap::Parser;

use crate::args::Common;
use crate::commands::Command;
use crate::version::VERSION;

/// The command line.
#[derive(Debug, Parser)]
#[command(name = "wingroot", version = VERSION, disable_help_subcommand = true)]
#[command(about = "Calibrate an aeroelastic wing from loads measured at its root, and fly it")]
pub(crate) struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub(crate) command: Command,
    /// Options of every command.
    #[command(flatten)]
    pub(crate) common: Common,
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        Cli::command().debug_assert();
    }

    #[test]
    fn every_command_has_help_with_examples() {
        for command in Cli::command().get_subcommands_mut() {
            let name = command.get_name().to_owned();
            let help = command.render_long_help().to_string();
            let (_, examples) =
                help.split_once("Examples:\n").unwrap_or_else(|| panic!("{name} has no examples"));
            let first = examples.lines().next().unwrap_or("");
            assert!(first.starts_with(&format!("  wingroot {name}")), "{name}: {first}");
            assert!(examples.lines().all(|line| line.len() <= 132), "{name}: a line is too long");
        }
    }

    #[test]
    fn every_example_is_understood() {
        for command in Cli::command().get_subcommands_mut() {
            let help = command.render_long_help().to_string();
            for line in help.lines().filter_map(|line| line.strip_prefix("  wingroot ")) {
                // what stands behind is the shell's
                let line = line.split(" > ").next().unwrap_or(line);
                let words = std::iter::once("x").chain(line.split_whitespace());
                assert!(Cli::try_parse_from(words).is_ok(), "{line}");
            }
        }
    }

    #[test]
    fn options_stand_before_or_after_the_command() {
        let cli =
            Cli::try_parse_from(["x", "--json", "simulate", "--run", "a.csv", "b.csv", "--threads", "2"]);
        let cli = cli.unwrap();
        assert!(cli.common.json);
        assert_eq!(cli.common.threads, Some(2));
        assert!(matches!(cli.command, Command::Simulate(args) if args.run.len() == 2));
    }

    #[test]
    fn airspeeds_that_none_can_fly_are_refused() {
        for v in ["0", "-5", "nan", "1e4", "fast"] {
            assert!(Cli::try_parse_from(["x", "flutter", &format!("--to={v}")]).is_err(), "{v}");
        }
    }

    #[test]
    fn no_threads_at_all_are_refused() {
        assert!(Cli::try_parse_from(["x", "modes", "--threads", "0"]).is_err());
    }
}
