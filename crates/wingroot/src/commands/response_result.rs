//! `result.json` of `response`, and of `response --displacement`.

use response::asymmetry::Asymmetry;
use response::{BlockOffset, FTest, Fault, Lenth, Prediction, Step, Term};
use schemars::JsonSchema;
use serde::Serialize;

/// Response surfaces of measured coefficients.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct ResponseResult {
    /// Name of the command.
    pub(crate) command: &'static str,
    /// Name of the study.
    pub(crate) name: String,
    /// By table and response.
    pub(crate) responses: Vec<SurfaceResult>,
    /// What the surfaces say at the points of `--at`.
    pub(crate) at: Vec<PredictionsResult>,
    /// The published model's figures; null if there is none.
    pub(crate) published_figures: Option<Vec<FigureNotes>>,
    /// Wall clock.
    pub(crate) seconds: f64,
}

/// The surface of one response. Numbers without a unit in their name are in the unit of the response, or its square.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct SurfaceResult {
    /// The response.
    pub(crate) name: String,
    /// The table.
    pub(crate) data: String,
    /// Number of points.
    pub(crate) points: usize,
    /// The chosen terms with their tests.
    pub(crate) terms: Vec<TermResult>,
    /// Share of the variance that is explained.
    pub(crate) r2: f64,
    /// The same by degrees of freedom; null if none is left.
    #[schemars(with = "Option<f64>")]
    pub(crate) adjusted_r2: f64,
    /// Predicted squared error.
    pub(crate) pse: f64,
    /// Mean squared error.
    pub(crate) mse: f64,
    /// Schwarz's criterion.
    pub(crate) bic: f64,
    /// Mean square of leave-one-out residuals; null if a point determines a term alone.
    #[schemars(with = "Option<f64>")]
    pub(crate) leave_one_out: f64,
    /// sigma0^2 of the predicted squared error.
    pub(crate) sigma0_squared: f64,
    /// Level of tests and intervals.
    pub(crate) level: f64,
    /// Of the error.
    pub(crate) degrees_of_freedom: f64,
    /// Standard deviation of errors within blocks; null if no degree of freedom is left.
    #[schemars(with = "Option<f64>")]
    pub(crate) error_standard_deviation: f64,
    /// Whether no other set of terms can have a lower predicted squared error.
    pub(crate) search_complete: bool,
    /// Whether the same is known for every size on the curve.
    pub(crate) curve_complete: bool,
    /// Terms that could be chosen.
    pub(crate) candidates: Vec<Term>,
    /// Terms that these points do not tell from others.
    pub(crate) candidates_left_out: Vec<CandidateLeftOut>,
    /// The best set of each size.
    pub(crate) curve: Vec<Step>,
    /// Tests of the surface.
    pub(crate) tests: Tests,
    /// Offsets of blocks.
    pub(crate) block_offsets: Vec<BlockOffset>,
    /// Two-level effects; null if the response has no such design.
    pub(crate) effects: Option<EffectsResult>,
}

/// A term with its test.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct TermResult {
    /// The term.
    pub(crate) term: Term,
    /// Its coefficient, unit of the response over that of the term.
    pub(crate) coefficient: f64,
    /// Standard error of the coefficient; null if there is no test.
    #[schemars(with = "Option<f64>")]
    pub(crate) standard_error: f64,
    /// Coefficient over standard error; null if there is no test.
    #[schemars(with = "Option<f64>")]
    pub(crate) t: f64,
    /// Probability of a |t| as large by chance; null if there is no test.
    #[schemars(with = "Option<f64>")]
    pub(crate) p_value: f64,
    /// Interval of the coefficient; null if there is no test.
    pub(crate) interval: Option<(f64, f64)>,
}

/// A term that is not told from others.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct CandidateLeftOut {
    /// The term.
    pub(crate) term: Term,
    /// The others.
    pub(crate) not_told_from: String,
}

/// A number, or why there is none.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub(crate) enum OrReason<T> {
    /// It is known.
    Known(T),
    /// It is not.
    NotKnown {
        /// Why.
        not_known: String,
    },
}

impl<T> OrReason<T> {
    /// Of what was computed.
    pub(crate) fn of<S>(result: &Result<S, Fault>, value: impl Fn(&S) -> T) -> Self {
        match result {
            Ok(known) => Self::Known(value(known)),
            Err(fault) => Self::NotKnown { not_known: fault.to_string() },
        }
    }
}

/// Tests of a surface.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Tests {
    /// All terms but the constant together.
    pub(crate) all_terms: OrReason<FTest>,
    /// Error of points that were repeated.
    pub(crate) pure_error: OrReason<PureErrorResult>,
    /// What the surface misses beside pure error.
    pub(crate) lack_of_fit: OrReason<FTest>,
    /// What offsets of blocks take out of pure error; null without blocks.
    pub(crate) blocks: Option<OrReason<BlocksResult>>,
    /// Variances if the offsets are drawn; null without blocks.
    pub(crate) random_blocks: Option<OrReason<RandomBlocks>>,
    /// Root mean square error of predicting a block from the others; null without blocks.
    pub(crate) left_out_blocks_rms: Option<OrReason<f64>>,
    /// The smallest difference of two points that is significant; null if there is no test.
    #[schemars(with = "Option<f64>")]
    pub(crate) least_significant_difference: f64,
}

/// Error of repeated points.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct PureErrorResult {
    /// Of one reading.
    #[schemars(with = "Option<f64>")]
    pub(crate) standard_deviation: f64,
    /// Sum of squares.
    pub(crate) sum: f64,
    /// Of the sum.
    pub(crate) degrees_of_freedom: f64,
}

/// Pure error without and with offsets of blocks.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct BlocksResult {
    /// Share of the variance of pure error that the offsets take out.
    #[schemars(with = "Option<f64>")]
    pub(crate) share_of_pure_error: f64,
    /// Test of the offsets.
    pub(crate) test: FTest,
    /// Pure error without them.
    pub(crate) without: PureErrorResult,
    /// Pure error with them.
    pub(crate) with: PureErrorResult,
}

/// Standard deviations of random blocks.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct RandomBlocks {
    /// Between blocks.
    pub(crate) between: f64,
    /// Within a block.
    pub(crate) within: f64,
}

/// Two-level effects of one response.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct EffectsResult {
    /// Mean of the response.
    pub(crate) mean: f64,
    /// Of the error.
    pub(crate) degrees_of_freedom: f64,
    /// Sum of squares of the error; null if no degree of freedom is left.
    #[schemars(with = "Option<f64>")]
    pub(crate) residual_sum: f64,
    /// Of the offsets of blocks; null without blocks.
    #[schemars(with = "Option<f64>")]
    pub(crate) block_degrees_of_freedom: f64,
    /// What the offsets take off the sum of squares; null without blocks.
    #[schemars(with = "Option<f64>")]
    pub(crate) block_sum: f64,
    /// Main effects, then interactions.
    pub(crate) effects: Vec<TwoLevelEffect>,
    /// Lenth's margins; null for too few effects.
    pub(crate) lenth: Option<Lenth>,
}

/// Mean at the high level less mean at the low one.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct TwoLevelEffect {
    /// The factor or interaction.
    pub(crate) term: Term,
    /// The effect.
    pub(crate) value: f64,
    /// What the error's sum would grow by without it.
    pub(crate) sum_of_squares: f64,
    /// Its standard error; null if there is no test.
    pub(crate) standard_error: Option<f64>,
    /// Effect over standard error; null if there is no test.
    pub(crate) t: Option<f64>,
    /// Probability of a |t| as large by chance; null if there is no test.
    pub(crate) p_value: Option<f64>,
    /// Whether it is told from zero; null if there is no test.
    pub(crate) significant: Option<bool>,
    /// The effect that such a test finds nine times of ten; null if there is no test.
    pub(crate) found_with_90_percent_from: Option<f64>,
    /// What these points do not tell from it, with signs.
    pub(crate) not_told_from: Vec<String>,
}

/// What the surface of a response says at points of the user's.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct PredictionsResult {
    /// The response.
    pub(crate) name: String,
    /// The table.
    pub(crate) data: String,
    /// Names of the factors.
    pub(crate) factors: Vec<String>,
    /// The points.
    pub(crate) points: Vec<At>,
}

/// A point with what a surface says of it.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub(crate) struct At {
    /// Values of the factors.
    pub(crate) factors: Vec<f64>,
    /// The prediction.
    #[serde(flatten)]
    pub(crate) prediction: Prediction,
    /// Interval of the true mean; null if no degree of freedom is left.
    #[schemars(with = "Option<(Option<f64>, Option<f64>)>")]
    pub(crate) mean_interval: (f64, f64),
    /// Interval of one more reading; null if no degree of freedom is left.
    #[schemars(with = "Option<(Option<f64>, Option<f64>)>")]
    pub(crate) reading_interval: (f64, f64),
}

/// A figure of the published model.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct FigureNotes {
    /// Its number.
    pub(crate) figure: u8,
    /// What it shows.
    pub(crate) title: String,
    /// What was assumed, left out or extrapolated.
    pub(crate) notes: Vec<String>,
}

/// Asymmetry of displacement fields.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct DisplacementResult {
    /// Name of the command.
    pub(crate) command: &'static str,
    /// The rigid wing.
    pub(crate) rigid: RigidResult,
    /// The fields.
    pub(crate) fields: Vec<FieldResult>,
}

/// The rigid wing that fields are set beside.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct RigidResult {
    /// Mean ratio of left to right.
    pub(crate) mean: f64,
    /// One less that.
    pub(crate) bias: f64,
    /// Standard deviation of one field; null if there is one only.
    pub(crate) scatter: Option<f64>,
    /// How many fields are behind it; 0 for the paper's.
    pub(crate) fields: usize,
}

/// A field.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct FieldResult {
    /// Its file.
    pub(crate) file: String,
    /// Its asymmetry.
    #[serde(flatten)]
    pub(crate) asymmetry: Asymmetry,
    /// Whether it is told from the rigid wing's.
    pub(crate) beyond_the_rigid_wing: bool,
}
