//! Which degrees of freedom hold motions that cannot be told from loose ones.

use super::panels::{Row, TOGETHER};
use crate::sparse;
use faer::sparse::SparseColMatRef;
use faer::{Mat, MatRef};

/// The energy of a motion must exceed the effect of rounding the entries by this factor.
const MARGIN: f64 = 4.0;

/// Whether an energy is more than rounding its terms, whose magnitudes sum up to `size`, may have made.
pub(super) fn stands_out(energy: f64, size: f64) -> bool {
    energy.abs() > MARGIN * f64::EPSILON * size
}

/// One degree of freedom for each of those motions that cannot be told from a loose one.
pub(super) fn loose_among(a: SparseColMatRef<'_, usize, f64>, motions: &Mat<f64>) -> Vec<usize> {
    let forces = sparse::multiply(a, motions.as_ref());
    let diagonal = sparse::diagonal(a);
    let sizes = absolute_energies(a, motions.as_ref());
    let mut loose = Vec::new();
    for (j, size) in (0..motions.ncols()).zip(sizes) {
        let x = motions.col(j);
        let energy: f64 = x.iter().zip(forces.col(j).iter()).map(|(x, f)| x * f).sum();
        if size > 0.0 && !stands_out(energy, size) {
            loose.push(x.iter().zip(&diagonal).map(|(x, d)| x * d.max(0.0).sqrt()).collect());
        }
    }
    pivots_of(loose)
}

/// Rows of absolute values side by side, in an order of rows: what is summed over all columns reads a matrix once.
pub(super) fn sizes(x: MatRef<'_, f64>, order: impl Iterator<Item = usize>) -> Vec<Row> {
    let of_row = |at: usize| {
        let mut row = [0.0; TOGETHER];
        row.iter_mut().zip(x.row(at).iter()).for_each(|(own, x)| *own = x.abs());
        row
    };
    order.map(of_row).collect()
}

/// |x|^T |A| |x| of each column, at most [`TOGETHER`].
pub(super) fn absolute_energies(a: SparseColMatRef<'_, usize, f64>, x: MatRef<'_, f64>) -> Row {
    let sizes = sizes(x, 0..x.nrows());
    let mut energies = [0.0; TOGETHER];
    for (j, own) in sizes.iter().enumerate() {
        let mut sums = [0.0; TOGETHER];
        for (i, value) in a.row_idx_of_col(j).zip(a.val_of_col(j)) {
            sums.iter_mut().zip(&sizes[i]).for_each(|(sum, x)| *sum += value.abs() * x);
        }
        energies.iter_mut().zip(own.iter().zip(sums)).for_each(|(energy, (x, sum))| *energy += x * sum);
    }
    energies
}

/// One place for each of some independent motions, so that holding these places holds them all: elimination with the
/// largest entry as pivot.
pub(super) fn pivots_of(mut motions: Vec<Vec<f64>>) -> Vec<usize> {
    let mut places = Vec::new();
    while !motions.is_empty() {
        let peak = |x: &Vec<f64>| {
            x.iter()
                .enumerate()
                .max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))
                .map_or((0, 0.0), |(at, v)| (at, *v))
        };
        let largest = (0..motions.len())
            .max_by(|a, b| peak(&motions[*a]).1.abs().total_cmp(&peak(&motions[*b]).1.abs()));
        let pivot = motions.swap_remove(largest.unwrap_or(0));
        let (place, value) = peak(&pivot);
        if value == 0.0 {
            break;
        }
        places.push(place);
        for motion in &mut motions {
            let share = motion[place] / value;
            motion.iter_mut().zip(&pivot).for_each(|(x, p)| *x -= share * p);
        }
    }
    places
}
