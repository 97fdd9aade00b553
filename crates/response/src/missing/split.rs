//! Which points are held out: a random share of the distinct points, each with all its replicates. Random, as every fourth
//! point of a factorial design may be one level of a factor.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};

use crate::data::Data;
use crate::fault::Fault;
use crate::pure_error::distinct;

/// Rows of the data, from 0, in rising order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Split {
    /// What is fitted.
    pub training: Vec<usize>,
    /// What only judges.
    pub held_out: Vec<usize>,
}

impl Split {
    /// Holds out a share of the distinct points, rounded, at least one.
    ///
    /// # Errors
    /// If the share is not above 0 and at most a half, or there are fewer than 4 distinct points.
    pub fn draw(data: &Data, share: f64, seed: u64) -> Result<Self, Fault> {
        if !(share > 0.0 && share <= 0.5) {
            let expected = "above 0 and at most 0.5";
            return Err(Fault::Number { what: "the share held out", value: share, expected });
        }
        let (of_point, count) = distinct(data);
        if count < 4 {
            return Err(Fault::TooFewPoints { points: count, terms: 4, needs: " to hold some out" });
        }
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mut order: Vec<(u64, usize)> = (0..count).map(|point| (random.next_u64(), point)).collect();
        order.sort_unstable();
        let held = (1..=count).take_while(|held| *held as f64 <= share * count as f64 + 0.5).count().max(1);
        let mut out = vec![false; count];
        order[..held].iter().for_each(|(_, point)| out[*point] = true);
        let (held_out, training) = (0..data.points()).partition(|row| out[of_point[*row]]);
        Ok(Self { training, held_out })
    }
}
