//! What there is to explain: the sum of squares of a response about its mean, offsets of fixed blocks taken out.

use crate::columns::Columns;
use crate::data::{Blocking, Data};
use crate::fault::Fault;
use crate::qr::{Qr, dot};
use crate::term::Term;

/// Sum of squares that the terms have to explain; about zero if the constant is not among them.
pub(crate) fn total_sum(data: &Data, y: &[f64], terms: &[Term], blocking: Blocking) -> Result<f64, Fault> {
    let constant: Vec<Term> = terms.iter().filter(|term| term.is_constant()).cloned().collect();
    let mut columns = Columns::of_terms(data, &constant)?;
    if blocking == Blocking::Fixed {
        columns = columns.with_blocks(data.blocks());
    }
    let qr = Qr::new(&columns.values, &columns.names)?;
    let (rest, _) = qr.remainder(y);
    Ok(dot(&rest, &rest))
}
