//! Offsets of blocks of rows (days, mountings): one a block and channel, common to all airspeeds.
//!
//! Cells (airspeed and angle) are eliminated, so only cells that several blocks share say anything. The estimates sum
//! to zero and are then shrunk as random effects.

use crate::campaign::StaticPoint;
use crate::statics::cells::{Cell, block_name};
use faer::Mat;

/// Fixed-effects estimate of the block offsets of one channel (cells eliminated, offsets sum to zero).
pub(crate) struct BlockFit {
    offsets: Vec<f64>,
    /// Variance of each offset per unit noise variance.
    variance: Vec<f64>,
    pub(crate) residual_squares: f64,
    pub(crate) dof: usize,
}

impl BlockFit {
    pub(crate) fn new(cells: &[Cell<'_>], names: &[&str], channel: usize) -> Self {
        let blocks = names.len();
        let mut normal = Mat::<f64>::zeros(blocks, blocks);
        let mut right = vec![0.0; blocks];
        let mut squares = 0.0;
        let mut rows = 0;
        for cell in cells {
            let count = cell.rows.len() as f64;
            let value = |row: &&StaticPoint| row.reading(channel);
            let mean = cell.rows.iter().map(value).sum::<f64>() / count;
            let mut in_block = vec![0.0; blocks];
            for row in &cell.rows {
                let block = names.iter().position(|name| *name == block_name(row)).unwrap_or(0);
                in_block[block] += 1.0;
                right[block] += value(row) - mean;
                squares += (value(row) - mean).powi(2);
            }
            for a in 0..blocks {
                normal[(a, a)] += in_block[a];
                for b in 0..blocks {
                    normal[(a, b)] -= in_block[a] * in_block[b] / count;
                }
            }
            rows += cell.rows.len();
        }
        let inverse = pseudo_inverse(&normal);
        let rank = (0..blocks)
            .map(|a| (0..blocks).map(|b| normal[(a, b)] * inverse[(b, a)]).sum::<f64>())
            .sum::<f64>();
        let offsets: Vec<f64> =
            (0..blocks).map(|a| (0..blocks).map(|b| inverse[(a, b)] * right[b]).sum()).collect();
        let explained: f64 = offsets.iter().zip(&right).map(|(b, r)| b * r).sum();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a rank is a small whole number"
        )]
        let rank = rank.round().max(0.0) as usize;
        Self {
            variance: (0..blocks).map(|a| inverse[(a, a)]).collect(),
            offsets,
            residual_squares: (squares - explained).max(0.0),
            dof: (rows - cells.len()).saturating_sub(rank),
        }
    }

    /// Standard deviation of the offsets beyond noise (method of moments), and the offsets shrunk accordingly.
    pub(crate) fn shrunk(&self, sigma: f64) -> (f64, Vec<f64>) {
        if self.offsets.len() < 2 {
            return (0.0, vec![0.0; self.offsets.len()]);
        }
        let noise: Vec<f64> = self.variance.iter().map(|v| v * sigma * sigma).collect();
        let total = self.offsets.iter().map(|b| b * b).sum::<f64>() / (self.offsets.len() - 1) as f64;
        let expected = noise.iter().sum::<f64>() / (self.offsets.len() - 1) as f64;
        let spread = (total - expected).max(0.0);
        // Offsets that sum to zero scatter less about their mean than about the mean of all days there could be: this
        // share of the spread, as the noise of theirs is already smaller.
        let own = spread * (1.0 - 1.0 / self.offsets.len() as f64);
        let shrink = |(b, n): (&f64, &f64)| if spread > 0.0 { b * own / (own + n) } else { 0.0 };
        let mut shrunk: Vec<f64> = self.offsets.iter().zip(&noise).map(shrink).collect();
        let mean = shrunk.iter().sum::<f64>() / shrunk.len() as f64;
        for offset in &mut shrunk {
            *offset -= mean;
        }
        (spread.sqrt(), shrunk)
    }
}

/// Pseudo-inverse of a small symmetric positive semi-definite matrix.
fn pseudo_inverse(matrix: &Mat<f64>) -> Mat<f64> {
    let size = matrix.nrows();
    let Ok(eigen) = matrix.self_adjoint_eigen(faer::Side::Lower) else { return Mat::zeros(size, size) };
    let values: Vec<f64> = (0..size).map(|i| eigen.S()[i]).collect();
    let largest = values.iter().copied().fold(0.0, f64::max);
    Mat::from_fn(size, size, |a, b| {
        (0..size)
            .filter(|&i| values[i] > 1e-9 * largest)
            .map(|i| eigen.U()[(a, i)] * eigen.U()[(b, i)] / values[i])
            .sum()
    })
}
