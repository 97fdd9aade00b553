//! The first cosine coefficients of records of any length, a prime number of samples too, by the chirp transform (Bluestein 1970; Rabiner,
//! Schafer and Rader 1969): with `2 k n = k² + n² - (k - n)²` the sums are one convolution, as long as the record and what is wanted
//! of it, for two records in one complex one.

use crate::{backward, fast_length, forward};
use num_complex::Complex;
use std::cell::RefCell;
use std::collections::HashMap;
use std::f64::consts::PI;
use std::rc::Rc;

thread_local! {
    /// Transforms by the number of samples and of coefficients.
    static KNOWN: RefCell<HashMap<[usize; 2], Rc<Bluestein>>> = RefCell::new(HashMap::new());
}

/// As many are kept: the runs of a campaign have few lengths, and where each has its own, memory does not grow with them.
const MOST_KEPT: usize = 32;

/// What does not depend on the records.
struct Bluestein {
    /// `exp(-i pi n² / 2N)`, as long as the longer of record and coefficients.
    turns: Vec<Complex<f64>>,
    /// `exp(-i pi k / 2N)` by coefficient.
    half_samples: Vec<Complex<f64>>,
    /// Transform of what the record is folded with, over its length.
    kernel: Vec<Complex<f64>>,
}

impl Bluestein {
    fn new(samples: usize, count: usize) -> Self {
        // n² modulo the period of the exponential, so that its angle is as exact for the last sample as for the first
        let angle = |n: usize| 0.5 * PI * ((n * n) % (4 * samples)) as f64 / samples as f64;
        let turns: Vec<Complex<f64>> = (0..samples.max(count)).map(|n| Complex::cis(-angle(n))).collect();
        let length = fast_length(samples + 2 * (count - 1));
        let mut kernel = vec![Complex::default(); length];
        for (value, turn) in kernel.iter_mut().zip(&turns[..count]) {
            *value = turn.conj();
        }
        // lags from the last sample to the coefficient -(count - 1)
        for n in 1..samples + count - 1 {
            kernel[length - n] = Complex::cis(angle(n));
        }
        forward(&mut kernel);
        for value in &mut kernel {
            *value /= length as f64;
        }
        let half_sample = |k: usize| Complex::cis(-0.5 * PI * k as f64 / samples as f64);
        Self { turns, half_samples: (0..count).map(half_sample).collect(), kernel }
    }
}

/// The first `count` sums over n of `record[n] cos(pi k (n + 1/2) / N)` (DCT-II) of two records of one length.
///
/// # Panics
/// If the records are not equally long, or `count` is zero.
pub fn cosines(records: [&[f64]; 2], count: usize) -> [Vec<f64>; 2] {
    let [first, second] = records;
    assert!(first.len() == second.len() && count > 0, "two records of one length, and a coefficient of them");
    if first.iter().chain(second).all(|value| *value == 0.0) {
        return [vec![0.0; count], vec![0.0; count]];
    }
    let transform = KNOWN.with_borrow_mut(|known| {
        let key = [first.len(), count];
        if known.len() == MOST_KEPT && !known.contains_key(&key) {
            known.clear();
        }
        Rc::clone(known.entry(key).or_insert_with(|| Rc::new(Bluestein::new(first.len(), count))))
    });
    let mut folded = vec![Complex::default(); transform.kernel.len()];
    for (((to, a), b), turn) in folded.iter_mut().zip(first).zip(second).zip(&transform.turns) {
        *to = Complex::new(*a, *b) * turn;
    }
    forward(&mut folded);
    for (value, kernel) in folded.iter_mut().zip(&transform.kernel) {
        *value *= kernel;
    }
    backward(&mut folded);
    // the sums of a real record at -k are the conjugates of those at k, which parts the two
    let at = |k: usize| {
        let forth = folded[k] * transform.turns[k] * transform.half_samples[k];
        let back =
            folded[(folded.len() - k) % folded.len()] * transform.turns[k] * transform.half_samples[k].conj();
        0.5 * (forth + back)
    };
    let both: Vec<Complex<f64>> = (0..count).map(at).collect();
    [both.iter().map(|value| value.re).collect(), both.iter().map(|value| value.im).collect()]
}
