//! One file per command: its options, and `run`. The list below is all that the rest of the program knows of them.

use clap::Subcommand;

use crate::args::Common;
use crate::failure::Failure;

/// Declares the commands.
macro_rules! commands {
    ($($(#[$doc:meta])* $file:ident: $name:ident($options:ty)),* $(,)?) => {
        $(pub mod $file;)*

        /// The commands.
        #[derive(Debug, Subcommand)]
        pub enum Command {
            $($(#[$doc])* $name($options)),*
        }

        impl Command {
            /// Its name on the command line.
            pub fn name(&self) -> &'static str {
                match self { $(Self::$name(_) => stringify!($file)),* }
            }

            /// Runs it.
            ///
            /// # Errors
            /// Bad input, or a computation that could not be completed.
            pub fn run(&self, common: &Common) -> Result<(), Failure> {
                match self { $(Self::$name(options) => $file::run(options, common)),* }
            }
        }
    };
}

commands! {
    /// Corrections per airspeed from static loads measured at the wing root
    calibrate: Calibrate(calibrate::CalibrateArgs),
    /// Time histories of wind-tunnel runs, simulated from their inputs and set beside what was measured
    simulate: Simulate(simulate::SimulateArgs),
    /// How much of a commanded deflection acts, by surface, airspeed and deflection, from measured doublets
    deflection: Deflection(deflection::DeflectionArgs),
    /// Where simulation and measurements disagree, which effect is missing, the wing with it, the gap before and after
    discover: Discover(discover::DiscoverArgs),
    /// What a measured rig on two springs that nobody drives lacks, and its cycles at airspeeds that were not fitted
    free: Free(free::FreeArgs),
    /// The blind benchmark of `discover`: effects hidden in campaigns of a wing with another discretisation
    hidden: Hidden(hidden::HiddenArgs),
    /// What all cases of a sweep share, computed once before many processes take their parts of it
    prepare: Prepare(Box<prepare::PrepareArgs>),
    /// The results of a sweep that many processes computed, as one process would write them
    merge: Merge(Box<merge::MergeArgs>),
    /// How far a sweep is: finished cases, failures, the slowest
    status: Status(Box<status::StatusArgs>),
    /// A script for Slurm or a manifest for Kubernetes that runs a sweep in parts, from an estimate by a few cases
    cluster: Cluster(Box<cluster::ClusterArgs>),
    /// Trim, pull-up, push-down, chirp and doublet of the full aircraft, initial beside updated model
    fullaircraft: Fullaircraft(Box<fullaircraft_prepared::FullaircraftArgs>),
    /// Cases of a plan of design loads: V-n, gusts, envelope, selection, and cards for a stress model
    loads: Loads(loads::LoadsArgs),
    /// Calibrate, simulate and fullaircraft, one after the other
    pipeline: Pipeline(pipeline::PipelineArgs),
    /// The virtual wind tunnel: writes a campaign folder
    tunnel: Tunnel(tunnel::TunnelArgs),
    /// Natural frequencies and shapes of a structure; with measurements, their fit by factors of regions
    modes: Modes(modes::ModesArgs),
    /// Displacements of a deck's structure under its loads or of a wing in steady air, with small or large deflections
    statics: Statics(statics::StaticsArgs),
    /// Measured against calculated loads, initial beside updated model: slopes with intervals, and verdicts
    flightloads: Flightloads(flightloads::FlightloadsArgs),
    /// The wing as a Nastran deck: structure, boxes and splines
    deck: Deck(deck::DeckArgs),
    /// Response surfaces of measured coefficients: terms chosen by the predicted squared error, and their tests
    response: Response(Box<crate::args::ResponseArgs>),
    /// Flutter and divergence speeds of the wing, initial beside updated, by two methods, with V-g and V-f curves
    flutter: Flutter(flutter::FlutterArgs),
    /// A Nastran deck in discrete and random gusts: motions of grids and loads of its monitoring stations
    gust: Gust(gust::GustArgs),
    /// The documents that came with the program, as pages to read without a network
    docs: Docs(docs::DocsArgs),
    /// What a shell needs to complete commands and options
    completions: Completions(completions::CompletionsArgs),
    /// Manual pages of the program and of each command
    man: Man(man::ManArgs),
    /// The JSON schema of a file that is read, or of a command's result.json
    schema: Schema(schema::SchemaArgs),
    /// A folder to start from: a commented wing of your own that runs at once, or a shipped example
    new: New(new::NewArgs),
}

impl Command {
    /// The folder of results that it writes, which takes the place of an earlier one.
    pub fn results(&self) -> Option<&'static str> {
        match self {
            Self::Pipeline(_)
            | Self::New(_)
            | Self::Completions(_)
            | Self::Man(_)
            | Self::Schema(_)
            | Self::Prepare(_)
            | Self::Status(_)
            | Self::Cluster(_) => None,
            Self::Merge(options) => Some(options.what.results()),
            Self::Fullaircraft(options) => Some(options.results()),
            Self::Loads(options) => Some(options.results()),
            _ => Some(self.name()),
        }
    }
}

mod calibrate_common;
mod calibrate_figures;
mod calibrate_model;
mod calibrate_numbers;
mod calibrate_predictions;
pub(crate) mod calibrate_predictions_result;
pub(crate) mod calibrate_result;
mod calibrate_shapes;
mod calibrate_strips;
mod deck_hdf5;
pub(crate) mod deck_result;
mod deflection_figures;
pub(crate) mod deflection_result;
mod deflection_results;
mod discover_campaigns;
pub(crate) mod discover_campaigns_result;
mod discover_figures;
mod discover_nulls;
mod discover_results;
mod discover_search;
mod flightloads_aircraft;
mod flightloads_campaign;
mod flightloads_coverage;
mod flightloads_figures;
mod flightloads_measured;
pub(crate) mod flightloads_result;
mod flightloads_sections;
mod flightloads_span;
mod flightloads_wing;
mod flutter_bent;
mod flutter_bent_figures;
pub(crate) mod flutter_bent_result;
mod flutter_common;
mod flutter_deck;
mod flutter_deck_beyond;
pub(crate) mod flutter_deck_result;
mod flutter_figures;
pub(crate) mod flutter_result;
mod free_figures;
pub(crate) mod free_result;
mod fullaircraft_cases;
mod fullaircraft_cases_figures;
mod fullaircraft_cases_flown;
pub(crate) mod fullaircraft_cases_merged;
pub(crate) mod fullaircraft_cases_table;
pub(crate) mod fullaircraft_deck;
mod fullaircraft_derivatives;
mod fullaircraft_draws;
mod fullaircraft_effects;
mod fullaircraft_figures;
mod fullaircraft_prepared;
mod given_deck;
mod gust_files;
pub(crate) mod gust_result;
mod gust_text;
mod hidden_judge;
mod hidden_truth;
mod loads_deck;
mod loads_deck_package;
mod loads_draws;
mod loads_export;
mod loads_figures;
mod loads_flights;
mod loads_gusts;
mod loads_kept;
mod loads_on_deck;
mod loads_package;
mod loads_package_files;
mod loads_plan;
pub(crate) mod loads_result;
mod loads_states;
mod loads_sweep;
mod loads_tables;
mod loads_turbulence;
mod modes_pictures;
pub(crate) mod modes_result;
mod modes_shapes;
mod modes_update;
mod pipeline_figures;
pub(crate) mod pipeline_result;
mod response_asymmetry;
mod response_figures;
mod response_files;
mod response_missing;
pub(crate) mod response_missing_result;
mod response_missing_text;
mod response_models;
mod response_points;
pub(crate) mod response_result;
mod response_source;
mod response_text;
mod result_parts;
mod simulate_effects;
mod simulate_files;
mod simulate_flown;
mod simulate_maneuvers;
pub(crate) mod simulate_result;
mod statics_air;
pub(crate) mod statics_air_result;
mod statics_cases;
mod statics_files;
pub(crate) mod statics_result;
mod swept;
pub(crate) mod tunnel_result;

pub(crate) use calibrate_numbers::speed_name;
