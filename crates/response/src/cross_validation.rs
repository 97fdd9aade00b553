//! Cross-validation by folds: the points of one fold predicted by a fit to the others, each in turn. A fold may be a whole
//! block: its offset is then unknown, and its points are predicted at the mean of the other blocks.

use crate::columns::Columns;
use crate::data::{Blocking, Data};
use crate::fault::Fault;
use crate::qr::{Qr, residuals};
use crate::term::Term;

/// Mean square of what the fits to the other folds leave at the points of each, unit of the response squared. `fold` has a
/// number for every point. Offsets of fixed blocks are fitted; random blocks are treated as fixed.
///
/// # Errors
/// If there is not one fold for every point or only one fold, or what is left of the points without a fold cannot carry the
/// terms.
pub fn cross_validation(
    data: &Data,
    response: &str,
    terms: &[Term],
    blocking: Blocking,
    fold: &[usize],
) -> Result<f64, Fault> {
    if fold.len() != data.points() {
        let (name, found) = ("the list of folds".to_string(), fold.len());
        return Err(Fault::Length { name, found, expected: data.points() });
    }
    let mut folds = fold.to_vec();
    folds.sort_unstable();
    folds.dedup();
    Fault::unless(folds.len() >= 2, "the number of folds", folds.len() as f64, "2 or more")?;
    let y = data.response_values(response)?;
    let of_terms = Columns::of_terms(data, terms)?;
    let mut sum = 0.0;
    for out in folds {
        let pick = |values: &[f64], inside: bool| -> Vec<f64> {
            values.iter().zip(fold).filter(|(_, of)| (**of == out) == inside).map(|(v, _)| *v).collect()
        };
        let mut columns = of_terms.clone();
        if blocking != Blocking::Ignored {
            for blocks in data.blocks() {
                // of the blocks with points that are fitted; others are at the mean of these
                let has_points = |label: &usize| {
                    blocks.of_point.iter().zip(fold).any(|(of, fold)| of == label && *fold != out)
                };
                let known: Vec<usize> = (0..blocks.labels.len()).filter(has_points).collect();
                columns.add_offsets(blocks, &known);
            }
        }
        let left: Vec<Vec<f64>> = columns.values.iter().map(|column| pick(column, false)).collect();
        let held: Vec<Vec<f64>> = columns.values.iter().map(|column| pick(column, true)).collect();
        let solution = Qr::new(&left, &columns.names)?.solve(&left, &pick(y, false));
        sum += residuals(&held, &solution, &pick(y, true)).iter().map(|rest| rest * rest).sum::<f64>();
    }
    Ok(sum / y.len() as f64)
}
