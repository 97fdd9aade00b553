//! What there is to explain: the sum of squares of a response about its mean, offsets of fixed blocks taken out.

use crate::columns::Columns;
use crate::data::{Blocking, Data};
use crate::fault::Fault;
use crate::qr::dot;
use crate::term::Term;

/// Sum of squares that the terms have to explain; about zero if the constant is not among them.
pub(crate) fn total_sum(data: &Data, y: &[f64], terms: &[Term], blocking: Blocking) -> Result<f64, Fault> {
    let constant: Vec<Term> = terms.iter().filter(|term| term.is_constant()).cloned().collect();
    let (rest, _) = Columns::of_model(data, &constant, blocking)?.orthogonalised()?.remainder(y);
    Ok(dot(&rest, &rest))
}
