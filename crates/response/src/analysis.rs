//! Everything that is said of one response: the chosen terms, their tests, pure error, blocks and lack of fit. What the data
//! do not allow (no replicates, one block) is kept as the reason why.

use crate::choice::{Choice, Rules, choose};
use crate::cross_validation::cross_validation;
use crate::data::{Blocking, Data};
use crate::f_test::FTest;
use crate::fault::Fault;
use crate::pure_error::{BlockShare, PureError, block_share, lack_of_fit, pure_error};
use crate::regression::Regression;
use crate::term::Term;

/// A response analysed.
#[derive(Debug, Clone, PartialEq)]
pub struct Analysis {
    /// The chosen surface and the curve over the number of terms.
    pub choice: Choice,
    /// F test of all its terms but the constant against the residual; the fault if there are none.
    pub all_terms: Result<FTest, Fault>,
    /// Scatter of replicates, offsets of blocks taken out unless they are ignored.
    pub pure_error: Result<PureError, Fault>,
    /// F test of lack of fit.
    pub lack_of_fit: Result<FTest, Fault>,
    /// What blocks explain of the pure error; none without blocks.
    pub block_share: Option<Result<BlockShare, Fault>>,
    /// The same terms with random blocks; none unless there is one column of them.
    pub random_blocks: Option<Result<Regression, Fault>>,
    /// Mean square of predicting each block from the others; none without blocks.
    pub left_out_blocks: Option<Result<f64, Fault>>,
    /// Least significant difference of the surface at the level.
    pub least_significant_difference: f64,
}

/// Chooses among the candidates and tests what was chosen, at a level such as 0.95.
///
/// # Errors
/// As [`choose`], and if the level is not between 0 and 1.
pub fn analyse(
    data: &Data,
    response: &str,
    candidates: &[Term],
    rules: Rules,
    level: f64,
) -> Result<Analysis, Fault> {
    let choice = choose(data, response, candidates, rules)?;
    let terms = choice.fitted.terms();
    let varying: Vec<Term> = terms.iter().filter(|term| !term.is_constant()).cloned().collect();
    // pure error and lack of fit know no random blocks
    let blocking = if rules.blocking == Blocking::Random { Blocking::Fixed } else { rules.blocking };
    let fixed = Regression::fit(data, response, &terms, blocking);
    let first = data.blocks().first();
    let one = data.blocks().len() == 1;
    Ok(Analysis {
        all_terms: choice.fitted.family_test(&varying),
        pure_error: pure_error(data, response, blocking),
        lack_of_fit: fixed.and_then(|fitted| lack_of_fit(data, &fitted, blocking)),
        block_share: first.map(|_| block_share(data, response)),
        random_blocks: one.then(|| Regression::fit(data, response, &terms, Blocking::Random)),
        left_out_blocks: first
            .map(|blocks| cross_validation(data, response, &terms, blocking, &blocks.of_point)),
        least_significant_difference: choice.fitted.mean_least_significant_difference(level)?,
        choice,
    })
}
