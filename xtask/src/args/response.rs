//! Options of `response`.

use std::path::PathBuf;

use clap::Args;

/// Options of `response`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  cargo xtask response
  cargo xtask response --data runs.csv --factors alpha,q --responses CL,CM --blocks day
  cargo xtask response --data runs.csv --factors alpha,q --responses CL --at points.csv
  cargo xtask response --displacement flexible.csv --rigid rigid.csv")]
pub struct ResponseArgs {
    /// A CSV file, a RON file that names tables, or a folder with response.ron or CSV files [default: data/mav]
    #[arg(long, value_name = "PATH")]
    pub data: Option<PathBuf>,
    /// Columns of factors, instead of what a RON file says
    #[arg(long, value_name = "A,B", value_delimiter = ',', requires = "data", requires = "responses")]
    pub factors: Vec<String>,
    /// Columns of responses
    #[arg(long, value_name = "CL,CM", value_delimiter = ',', requires = "factors")]
    pub responses: Vec<String>,
    /// Columns of blocks: runs, days, mountings
    #[arg(long, value_name = "DAY", value_delimiter = ',', requires = "factors")]
    pub blocks: Vec<String>,
    /// Candidates: all products of powers of the factors up to this order [default: 2, or the terms only]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(0..=9))]
    pub order: Option<u32>,
    /// Candidates by name, such as n^2/q, besides those of --order if that is given
    #[arg(long, value_name = "TERMS", value_delimiter = ',')]
    pub terms: Vec<String>,
    /// What is done with blocks: fixed or random offsets, or not looked at [default: fixed]
    #[arg(long, value_name = "HOW", value_parser = ["fixed", "random", "ignored"])]
    pub blocking: Option<String>,
    /// How sets of terms are looked for [default: best]
    #[arg(long, value_name = "HOW", value_parser = ["best", "stepwise", "ranked"])]
    pub search: Option<String>,
    /// sigma0^2 of the predicted squared error is T^2/2 times the variance of errors: terms stay from |t| = T on
    /// [default: 3]
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    pub least_t: Option<f64>,
    /// Level of tests and intervals [default: 0.95]
    #[arg(long, value_name = "P")]
    pub level: Option<f64>,
    /// Columns of two-level factors whose effects are computed [default: all factors, if all have two levels]
    #[arg(long, value_name = "A,B", value_delimiter = ',', requires = "factors")]
    pub effects: Vec<String>,
    /// Columns that are blocks for the effects [default: those of --blocks]
    #[arg(long, value_name = "DAY", value_delimiter = ',', requires = "effects")]
    pub effect_blocks: Vec<String>,
    /// Points (a CSV with the columns of the factors) at which the surfaces are predicted
    #[arg(long, value_name = "FILE")]
    pub at: Option<PathBuf>,
    /// Instead: displacement fields (CSV, `x_mm,y_mm,w_mm`) whose ratio of left to right side is computed
    #[arg(long, value_name = "FILE", num_args = 1.., conflicts_with_all = ["data", "factors", "order", "terms", "at"])]
    pub displacement: Vec<PathBuf>,
    /// Fields of a rigid wing in the same set-up [default: the paper's mean ratio, 0.956]
    #[arg(long, value_name = "FILE", num_args = 1.., requires = "displacement")]
    pub rigid: Vec<PathBuf>,
    /// Plane of symmetry of the fields, mm [default: 0]
    #[arg(long, value_name = "Y", allow_negative_numbers = true, requires = "displacement")]
    pub centre_y_mm: Option<f64>,
    /// Standard deviation of the error of a point of the fields, mm [default: 0.05]
    #[arg(long, value_name = "W", requires = "displacement")]
    pub sigma_w_mm: Option<f64>,
}
