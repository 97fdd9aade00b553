//! Candidate terms for data: all up to an order, without those that the points cannot tell from simpler ones (the square of
//! a factor with two levels). Those are reported, not silently dropped. Terms that a user asks for by name are never left
//! out: a fit refuses them.

use crate::columns::Columns;
use crate::data::{Blocking, Data};
use crate::fault::Fault;
use crate::term::Term;

/// Candidate terms.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidates {
    /// Terms that the points tell apart, the constant first.
    pub terms: Vec<Term>,
    /// Terms that they do not, each with the terms that it cannot be told from.
    pub left_out: Vec<(Term, String)>,
}

/// All products of powers of the factors up to an order that these points tell apart, simple ones first, and from offsets of
/// blocks if those are fitted.
///
/// # Errors
/// If a factor is not in the data, or the points do not carry the offsets of blocks.
pub fn candidates(
    data: &Data,
    factors: &[&str],
    order: u32,
    blocking: Blocking,
) -> Result<Candidates, Fault> {
    estimable(data, &Term::up_to_order(factors, order), blocking)
}

/// Those of the given terms whose coefficients these points can estimate: each is told from the earlier ones, and from offsets
/// of blocks if those are fitted.
/// The constant is always among them.
///
/// # Errors
/// If a factor is not in the data, or the points do not carry the offsets of blocks.
pub fn estimable(data: &Data, terms: &[Term], blocking: Blocking) -> Result<Candidates, Fault> {
    let constant = Columns::of_model(data, &[Term::constant()], blocking)?;
    let mut kept = constant.orthogonalised()?;
    let mut names = constant.names;
    let (mut told, mut left_out) = (vec![Term::constant()], Vec::new());
    for term in terms.iter().filter(|term| !term.is_constant()).cloned() {
        let column = data.column(&term)?;
        // one point has to be left for the error
        let room = names.len() + 1 < data.points();
        let mut with = kept.clone();
        match with.add(&column, &term.to_string(), &names) {
            Ok(()) if room => {
                kept = with;
                names.push(term.to_string());
                told.push(term);
            }
            Ok(()) => left_out.push((term, "any other: there are no more points".to_string())),
            Err(Fault::Aliased { others, .. }) => left_out.push((term, others)),
            Err(other) => return Err(other),
        }
    }
    Ok(Candidates { terms: told, left_out })
}
