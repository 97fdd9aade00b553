//! The zero of the tip reading: known, or free, one for each block.
//!
//! A free zero is eliminated, not estimated: the least root mean square over an offset `b` is that of the values about
//! their mean, `min_b |r + b| = |r - mean(r)|`, so residuals and every column of the Jacobian lose their block means and
//! no unknown is added. What the data say about corrections is then what they say without knowing the zero.

/// Which rows share a zero.
#[derive(Debug, Clone)]
pub(crate) struct TipZero {
    block_of: Vec<usize>,
    blocks: usize,
    free: bool,
}

impl TipZero {
    /// `block_of` names each row's block, 0 to `blocks - 1`; a zero that is not free changes nothing.
    pub(crate) fn new(block_of: Vec<usize>, free: bool) -> Self {
        let blocks = block_of.iter().max().map_or(0, |last| last + 1);
        Self { block_of, blocks, free }
    }

    /// Mean by block of `value(row)`: minus the best zero, if the values are simulated minus measured. Zero for a
    /// block without rows, and for all if the zero is known.
    pub(crate) fn means(&self, value: impl Fn(usize) -> f64) -> Vec<f64> {
        let (mut sums, mut counts) = (vec![0.0; self.blocks], vec![0.0_f64; self.blocks]);
        if self.free {
            for (row, &block) in self.block_of.iter().enumerate() {
                sums[block] += value(row);
                counts[block] += 1.0;
            }
        }
        sums.iter().zip(&counts).map(|(sum, count)| sum / count.max(1.0)).collect()
    }

    /// Takes the block means out of values by row.
    pub(crate) fn centre(&self, values: &mut [f64]) {
        if !self.free {
            return;
        }
        let means = self.means(|row| values[row]);
        for (value, &block) in values.iter_mut().zip(&self.block_of) {
            *value -= means[block];
        }
    }

    /// By block, the variance of the mean of rows whose own variances are one over these numbers.
    pub(crate) fn means_of_inverse(&self, replicates: impl Iterator<Item = f64>) -> Vec<f64> {
        let (mut sums, mut counts) = (vec![0.0; self.blocks], vec![0.0_f64; self.blocks]);
        for (number, &block) in replicates.zip(&self.block_of) {
            sums[block] += 1.0 / number;
            counts[block] += 1.0;
        }
        sums.iter().zip(&counts).map(|(sum, count)| sum / count.max(1.0).powi(2)).collect()
    }

    /// Number of free zeros.
    pub(crate) fn count(&self) -> usize {
        if self.free { self.blocks } else { 0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_free_zero_is_the_mean_of_its_block_and_a_known_one_is_none() {
        let values = [1.0, 5.0, 3.0, 10.0];
        let free = TipZero::new(vec![0, 2, 0, 2], true);
        assert_eq!(free.means(|row| values[row]), [2.0, 0.0, 7.5]);
        let mut centred = values;
        free.centre(&mut centred);
        assert_eq!(centred, [-1.0, -2.5, 1.0, 2.5]);
        assert_eq!(free.count(), 3);
        let known = TipZero::new(vec![0, 2, 0, 2], false);
        assert_eq!(known.means(|row| values[row]), [0.0; 3]);
        let mut left = values;
        known.centre(&mut left);
        assert_eq!((left, known.count()), (values, 0));
    }

    /// Var(mean) = sum of variances over the square of their number.
    #[test]
    fn the_mean_of_a_block_is_as_uncertain_as_its_rows_say() {
        let zero = TipZero::new(vec![0, 0, 0, 1], true);
        let variances = zero.means_of_inverse([1.0, 2.0, 4.0, 5.0].into_iter());
        assert!(
            (variances[0] - 1.75 / 9.0).abs() < 1e-15 && (variances[1] - 0.2).abs() < 1e-15,
            "{variances:?}"
        );
        assert_eq!(TipZero::new(vec![1, 1], true).means_of_inverse([2.0, 2.0].into_iter()), [0.0, 0.25]);
    }
}
