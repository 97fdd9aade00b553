//! The command line: every command with its options and defaults, in one place.

mod discover;
mod flutter;
mod new;
mod response;

pub use discover::{DiscoverArgs, HiddenArgs};
pub use flutter::FlutterArgs;
pub use new::NewArgs;
pub use response::ResponseArgs;

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};

use crate::paths;

/// The command line.
#[derive(Debug, Parser)]
#[command(name = "xtask", bin_name = "cargo xtask", version, disable_help_subcommand = true)]
#[command(about = "Calibrate an aeroelastic wing from loads measured at its root, and fly it")]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
    /// Options of every command.
    #[command(flatten)]
    pub common: Common,
}

/// Options of every command.
#[derive(Debug, Clone, Default, Args)]
pub struct Common {
    /// Folder for the results [default: out/NAME]; replaced as a whole once all results are complete
    #[arg(long, global = true, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Print result.json to standard output, and nothing else there
    #[arg(long, global = true)]
    pub json: bool,
    /// No progress and no summary
    #[arg(long, global = true)]
    pub quiet: bool,
    /// Number of threads [default: all processors]
    #[arg(long, global = true, value_name = "N", value_parser = threads)]
    pub threads: Option<usize>,
    /// Seed of whatever is random
    #[arg(long, global = true, value_name = "N")]
    pub seed: Option<u64>,
}

impl Common {
    /// The folder for the results of a command.
    pub fn out(&self, command: &str) -> PathBuf {
        self.out.clone().unwrap_or_else(|| paths::in_repository(&format!("out/{command}")))
    }
}

fn threads(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(number @ 1..=1024) => Ok(number),
        _ => Err("expected a number from 1 to 1024".into()),
    }
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Corrections per airspeed from static loads measured at the wing root
    Calibrate(CalibrateArgs),
    /// Time histories of wind-tunnel runs, simulated from their inputs and set beside what was measured
    Simulate(SimulateArgs),
    /// How much of a commanded deflection acts, by surface, airspeed and deflection, from measured doublets
    Deflection(DeflectionArgs),
    /// Where simulation and measurements disagree, which effect is missing, the wing with it, the gap before and after
    Discover(DiscoverArgs),
    /// The blind benchmark of `discover`: effects hidden in campaigns of another program's wing
    Hidden(HiddenArgs),
    /// Trim, pull-up, push-down, chirp and doublet of the full aircraft, initial beside updated model
    Fullaircraft(FullaircraftArgs),
    /// Calibrate, simulate and fullaircraft, one after the other
    Pipeline(PipelineArgs),
    /// The virtual wind tunnel: writes a campaign folder
    Tunnel(TunnelArgs),
    /// Natural frequencies and shapes of a structure; with measurements, their fit by factors of regions
    Modes(ModesArgs),
    /// The wing as a Nastran deck: structure, boxes and splines
    Deck(DeckArgs),
    /// Response surfaces of measured coefficients: terms chosen by the predicted squared error, and their tests
    Response(Box<ResponseArgs>),
    /// Flutter and divergence speeds of the wing, initial beside updated, by two methods, with V-g and V-f curves
    Flutter(FlutterArgs),
    /// A commented folder for a wing of your own, that runs at once
    New(NewArgs),
    /// Our results beside every published reference
    Validate(ValidateArgs),
    /// Time of the main steps
    Bench(BenchArgs),
    /// Check the house rules of the repository
    Tidy(TidyArgs),
}

impl Command {
    /// Its name on the command line.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Calibrate(_) => "calibrate",
            Self::Simulate(_) => "simulate",
            Self::Deflection(_) => "deflection",
            Self::Discover(_) => "discover",
            Self::Hidden(_) => "hidden",
            Self::Fullaircraft(_) => "fullaircraft",
            Self::Pipeline(_) => "pipeline",
            Self::Tunnel(_) => "tunnel",
            Self::Modes(_) => "modes",
            Self::Deck(_) => "deck",
            Self::Response(_) => "response",
            Self::Flutter(_) => "flutter",
            Self::New(_) => "new",
            Self::Validate(_) => "validate",
            Self::Bench(_) => "bench",
            Self::Tidy(_) => "tidy",
        }
    }
}

/// Options of `calibrate`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  cargo xtask calibrate
  cargo xtask calibrate --wing my_wing/wing.ron --campaign my_wing/campaign --out out/my_wing
  cargo xtask calibrate --wing data/pazy/wing.ron --campaign data/pazy/tip_5deg --out out/pazy

Written: corrections.ron, DMI cards wkk_V.bdf and fa2j_V.bdf for each airspeed, figures, result.json. An airspeed needs
three angles of attack (docs/guide.md explains the columns and how to read the result).")]
pub struct CalibrateArgs {
    /// The wing [default: data/tuflex/wing.ron]
    #[arg(long, value_name = "FILE")]
    pub wing: Option<PathBuf>,
    /// The folder of measurements [default: data/tuflex/measured]
    #[arg(long, value_name = "DIR")]
    pub campaign: Option<PathBuf>,
}

/// Options of `simulate`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  cargo xtask simulate
  cargo xtask simulate --run data/tuflex/measured/aoa_2hz_30.csv
  cargo xtask simulate --maneuver data/tuflex/maneuvers/doublet.ron data/tuflex/maneuvers/chirp.ron
  cargo xtask simulate --wing out/deflection/wing.ron --corrections out/deflection/corrections.ron

The initial model is theory; the updated one has the corrections, and the wing's deflection correction if its file
has one (commanded deflection, times K(deflection, V), actuator, surface). Deflections in results are commands.")]
pub struct SimulateArgs {
    /// Runs to simulate [default: all runs of the campaign, unless maneuvers are named]
    #[arg(long, value_name = "FILE", num_args = 1..)]
    pub run: Vec<PathBuf>,
    /// Maneuvers declared in RON to fly (data/tuflex/maneuvers/doublet.ron explains every field)
    #[arg(long, value_name = "FILE", num_args = 1..)]
    pub maneuver: Vec<PathBuf>,
    /// The wing [default: data/tuflex/wing.ron]
    #[arg(long, value_name = "FILE")]
    pub wing: Option<PathBuf>,
    /// Corrections from `calibrate` [default: out/calibrate's if of the same wing, else calibrated first]
    #[arg(long, value_name = "FILE")]
    pub corrections: Option<PathBuf>,
    /// The folder of measurements [default: data/tuflex/measured]
    #[arg(long, value_name = "DIR")]
    pub campaign: Option<PathBuf>,
    /// Give the lift of every strip, too: NAME_stations.csv
    #[arg(long)]
    pub strips: bool,
    /// Switch off an effect of the wing's file (may be repeated)
    #[arg(long, value_name = "EFFECT")]
    pub without: Vec<String>,
}

/// Options of `deflection`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  cargo xtask deflection
  cargo xtask deflection --campaign my_campaign --wing my_wing.ron --out out/my_deflection
  cargo xtask simulate --wing out/deflection/wing.ron --corrections out/deflection/corrections.ron

Runs that are doublets of one control surface are fitted if they are marked `use: Train` or not marked at all; those
marked Holdout only judge.
Writes wing.ron (the given wing with the correction), corrections.ron (the given ones, for that wing), deflection.csv,
equivalent.svg, factors.svg and result.json. The factor is linear between measured deflections and airspeeds, kept
below the smallest and above the largest deflection, and refused beyond the measured airspeeds.")]
pub struct DeflectionArgs {
    /// The wing [default: data/tuflex/wing.ron]
    #[arg(long, value_name = "FILE")]
    pub wing: Option<PathBuf>,
    /// The folder of measurements [default: data/tuflex/measured]
    #[arg(long, value_name = "DIR")]
    pub campaign: Option<PathBuf>,
    /// Corrections from `calibrate` [default: out/calibrate's if of the same wing, else calibrated first]
    #[arg(long, value_name = "FILE")]
    pub corrections: Option<PathBuf>,
}

/// Options of `fullaircraft`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  cargo xtask fullaircraft
  cargo xtask fullaircraft --cases data/tuflex/cases.ron
  cargo xtask fullaircraft --deck data/published/decks/ha144a_fsw.bdf

With --cases: every maneuver of the file at every airspeed, with both models, and the load envelope (cases.csv,
envelope.csv, envelope.svg, result.json in out/fullaircraft_cases). Finished cases are kept beside that folder until all are
done: a run that was stopped goes on where it was when it is started again with the same inputs.")]
pub struct FullaircraftArgs {
    /// The aircraft [default: data/tuflex/aircraft.ron]
    #[arg(long, value_name = "FILE")]
    pub aircraft: Option<PathBuf>,
    /// Corrections from `calibrate` [default: out/calibrate's if of the same wing, else calibrated first]
    #[arg(long, value_name = "FILE")]
    pub corrections: Option<PathBuf>,
    /// The wing [default: data/tuflex/wing.ron]
    #[arg(long, value_name = "FILE")]
    pub wing: Option<PathBuf>,
    /// A grid of airspeeds, load factors and maneuvers (data/tuflex/cases.ron explains every field)
    #[arg(long, value_name = "FILE.ron")]
    pub cases: Option<PathBuf>,
    /// The trims of a whole-aircraft Nastran deck (SOL 144) instead of the aircraft
    #[arg(long, value_name = "FILE.bdf", conflicts_with_all = ["cases", "aircraft", "wing", "corrections"])]
    pub deck: Option<PathBuf>,
}

/// Options of `pipeline`: none of its own.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  cargo xtask pipeline
  cargo xtask pipeline --threads 1 --quiet")]
pub struct PipelineArgs {}

/// Options of `tunnel`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  cargo xtask tunnel
  cargo xtask tunnel --runs data/tuflex/tunnel.ron --seed 2 --out out/another_tunnel

What it writes is generated, and its README.md says so: a campaign to try commands on, no measurement.")]
pub struct TunnelArgs {
    /// What the tunnel measures and hides [default: data/tuflex/tunnel.ron]
    #[arg(long, value_name = "FILE")]
    pub runs: Option<PathBuf>,
}

/// Options of `modes`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  cargo xtask modes
  cargo xtask modes --deck my_wing.bdf --count 20
  cargo xtask modes --wing my_wing/wing.ron --measured my_wing/vibration_test.ron")]
pub struct ModesArgs {
    /// The wing [default: data/tuflex/wing.ron]
    #[arg(long, value_name = "FILE", conflicts_with = "deck")]
    pub wing: Option<PathBuf>,
    /// A Nastran deck instead of a wing
    #[arg(long, value_name = "FILE")]
    pub deck: Option<PathBuf>,
    /// Number of modes [default: 10, or as many as there are]
    #[arg(long, value_name = "N")]
    pub count: Option<usize>,
    /// Measured frequencies, shapes and deflections, and the regions whose stiffness and mass are fitted to them
    #[arg(long, value_name = "FILE")]
    pub measured: Option<PathBuf>,
}

/// Options of `deck`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  cargo xtask deck
  cargo xtask deck --wing my_wing/wing.ron --corrections out/my_wing/corrections.ron --airspeed 20
  cargo xtask deck --bars --count 6 --hdf5

With corrections the deck has them as WKK and FA2J, and beside it stand, for programs without these, w2gj.bdf (camber
plus what acts as the pressure offsets) and qjj.op4 (pressures per incidence with the force factors in them); what
they leave out is in result.json under `left_out`.")]
pub struct DeckArgs {
    /// The wing [default: data/tuflex/wing.ron]
    #[arg(long, value_name = "FILE")]
    pub wing: Option<PathBuf>,
    /// Corrections from `calibrate` to write as WKK and FA2J
    #[arg(long, value_name = "FILE")]
    pub corrections: Option<PathBuf>,
    /// Airspeed of the corrections, m/s [default: the first of the file]
    #[arg(long, value_name = "V", requires = "corrections")]
    pub airspeed: Option<f64>,
    /// Number of modes asked for in the case control
    #[arg(long, value_name = "N", default_value_t = 10)]
    pub count: usize,
    /// Write CBAR and PBAR instead of CBEAM and PBEAM where the section is uniform and has no offsets (for programs
    /// without CBEAM)
    #[arg(long)]
    pub bars: bool,
    /// Write model.h5, too: boxes, pressures, modes, and with corrections these and the linear systems that `simulate` flies
    #[arg(long)]
    pub hdf5: bool,
}

/// Options of `validate`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  cargo xtask validate
  cargo xtask validate --only dlm")]
pub struct ValidateArgs {
    /// The folder of published cases [default: data/published]
    #[arg(long, value_name = "DIR")]
    pub data: Option<PathBuf>,
    /// Only cases whose name begins with this
    #[arg(long, value_name = "NAME")]
    pub only: Option<String>,
}

/// Options of `bench`.
#[derive(Debug, Clone, Args)]
#[command(after_help = "Examples:
  cargo xtask bench
  cargo xtask bench --peer-python venv/bin/python")]
pub struct BenchArgs {
    /// A Python with PanelAero, timed on the same boxes in the same run [default: python3, if it has it]
    #[arg(long, value_name = "PYTHON", default_value = "python3")]
    pub peer_python: PathBuf,
}

/// Options of `tidy`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  cargo xtask tidy
  cargo xtask tidy --lines")]
pub struct TidyArgs {
    /// Count lines of code by crate (no blank lines, no comments) instead
    #[arg(long)]
    pub lines: bool,
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
            assert!(first.starts_with(&format!("  cargo xtask {name}")), "{name}: {first}");
            assert!(examples.lines().all(|line| line.len() <= 132), "{name}: a line is too long");
        }
    }

    #[test]
    fn every_example_is_understood() {
        for command in Cli::command().get_subcommands_mut() {
            let help = command.render_long_help().to_string();
            for line in help.lines().filter_map(|line| line.strip_prefix("  cargo xtask ")) {
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
        assert!(Cli::try_parse_from(["x", "tidy", "--threads", "0"]).is_err());
    }
}
