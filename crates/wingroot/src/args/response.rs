//! Options of `response`.

use std::path::PathBuf;

use clap::Args;

/// Options of `response`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  wingroot response
  wingroot response --data runs.csv --factors alpha,q --responses CL,CM --blocks day --at points.csv
  wingroot response --displacement flexible.csv --rigid rigid.csv
  wingroot response --missing
  wingroot response --missing --hide q*delta
  wingroot response --missing --hide block
  wingroot response --missing --data runs.csv --factors alpha,q --responses CL --blocks day --model alpha,q,day

--missing fits the model's terms to three quarters of the points, says in which family of regressors the rest sits
(mean square over pure error), names the candidate that explains it, or all that these points do not tell apart, adds it
and shows the gap before and after, on those points and on the others. It names nothing that 200 campaigns drawn from the
model itself would let it name, and says so: none (nothing is missing), unknown (something is that no candidate explains).
Candidates are all products up to --order, --terms, and offsets of block columns that are not in the model.")]
pub struct ResponseArgs {
    /// A CSV file, a RON file that names tables, or a folder with response.ron or CSV files [default: response.ron of the current folder]
    #[arg(long, value_name = "PATH")]
    pub(crate) data: Option<PathBuf>,
    /// Columns of factors, instead of what a RON file says
    #[arg(long, value_name = "A,B", value_delimiter = ',', requires = "data", requires = "responses")]
    pub(crate) factors: Vec<String>,
    /// Columns of responses
    #[arg(long, value_name = "CL,CM", value_delimiter = ',', requires = "factors")]
    pub(crate) responses: Vec<String>,
    /// Columns of blocks: runs, days, mountings
    #[arg(long, value_name = "DAY", value_delimiter = ',', requires = "factors")]
    pub(crate) blocks: Vec<String>,
    /// Candidates: all products of powers of the factors up to this order [default: 2, or the terms only]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(0..=9))]
    pub(crate) order: Option<u32>,
    /// Candidates by name, such as n^2/q, besides those of --order if that is given
    #[arg(long, value_name = "TERMS", value_delimiter = ',')]
    pub(crate) terms: Vec<String>,
    /// What is done with blocks: fixed or random offsets, or not looked at [default: fixed]
    #[arg(long, value_name = "HOW", value_parser = ["fixed", "random", "ignored"])]
    pub(crate) blocking: Option<String>,
    /// How sets of terms are looked for [default: best]
    #[arg(long, value_name = "HOW", value_parser = ["best", "stepwise", "ranked"])]
    pub(crate) search: Option<String>,
    /// sigma0^2 of the predicted squared error is T^2/2 times the variance of errors: terms stay from |t| = T on
    /// [default: 3]
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    pub(crate) least_t: Option<f64>,
    /// Level of tests and intervals [default: 0.95]
    #[arg(long, value_name = "P")]
    pub(crate) level: Option<f64>,
    /// Columns of two-level factors whose effects are computed [default: all factors, if all have two levels]
    #[arg(long, value_name = "A,B", value_delimiter = ',', requires = "factors")]
    pub(crate) effects: Vec<String>,
    /// Columns that are blocks for the effects [default: those of --blocks]
    #[arg(long, value_name = "DAY", value_delimiter = ',', requires = "effects")]
    pub(crate) effect_blocks: Vec<String>,
    /// Points (a CSV with the columns of the factors) at which the surfaces are predicted
    #[arg(long, value_name = "FILE")]
    pub(crate) at: Option<PathBuf>,
    /// Instead: which term a model lacks
    #[arg(long, conflicts_with_all = ["at", "effects", "search", "least_t", "blocking"])]
    pub(crate) missing: bool,
    /// Terms of the model, and block columns whose offsets it has; the constant is always in it [default: the published
    /// equations, if the data are theirs, with offsets of all block columns]
    #[arg(long, value_name = "TERMS", value_delimiter = ',', requires = "missing")]
    pub(crate) model: Vec<String>,
    /// Take a term, or the offsets of a block column, out of the model first
    #[arg(long, value_name = "TERM", requires = "missing")]
    pub(crate) hide: Option<String>,
    /// Standard deviation of one reading, where nothing was measured twice [default: from replicates]
    #[arg(long, value_name = "S", requires = "missing")]
    pub(crate) noise: Option<f64>,
    /// Instead: displacement fields (CSV, `x_mm,y_mm,w_mm`) whose ratio of left to right side is computed
    #[arg(long, value_name = "FILE", num_args = 1.., conflicts_with_all = ["data", "factors", "order", "terms", "at", "missing"])]
    pub(crate) displacement: Vec<PathBuf>,
    /// Fields of a rigid wing in the same set-up [default: the paper's mean ratio, 0.956]
    #[arg(long, value_name = "FILE", num_args = 1.., requires = "displacement")]
    pub(crate) rigid: Vec<PathBuf>,
    /// Plane of symmetry of the fields, mm [default: 0]
    #[arg(long, value_name = "Y", allow_negative_numbers = true, requires = "displacement")]
    pub(crate) centre_y_mm: Option<f64>,
    /// Standard deviation of the error of a point of the fields, mm [default: 0.05]
    #[arg(long, value_name = "W", requires = "displacement")]
    pub(crate) sigma_w_mm: Option<f64>,
}
