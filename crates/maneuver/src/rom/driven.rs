//! What drives the linear wing in a record.

use crate::periodic::continued;
use faer::c64;
use std::sync::OnceLock;

/// What the first and the second of two real records count in the complex one that holds both.
const ONE: c64 = c64::new(1.0, 0.0);
/// See above.
pub(super) const SECOND: c64 = c64::new(0.0, 1.0);

/// A drive of one record: which column of the responses, and how it goes. Its spectrum is found once, whatever it drives.
#[derive(Debug)]
pub struct Driven {
    pub(super) column: usize,
    values: Vec<f64>,
    spectrum: OnceLock<Vec<c64>>,
}

/// A record as one period of a periodic one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Period {
    /// Number of samples, those behind the record's end included.
    pub(super) length: usize,
    /// Bins of a spectrum that are looked at, from zero on.
    pub(super) bins: usize,
    /// Time step, s.
    pub(super) time_step_s: f64,
}

impl Driven {
    /// A drive (column of the response) sample by sample, in the units of that column.
    pub fn new(column: usize, values: Vec<f64>) -> Self {
        Self { column, values, spectrum: OnceLock::new() }
    }

    /// The column of the responses.
    pub fn column(&self) -> usize {
        self.column
    }

    /// The samples.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// What it goes beyond another of the same column.
    #[must_use]
    pub fn less(&self, other: &Self) -> Self {
        let beyond = self.values.iter().zip(&other.values).map(|(own, other)| own - other);
        Self::new(self.column, beyond.collect())
    }

    pub(super) fn moves(&self) -> bool {
        self.values.iter().any(|value| *value != self.values[0])
    }

    /// Its spectrum, once it was among those of [`transform`].
    pub(super) fn spectrum(&self) -> &[c64] {
        self.spectrum.get().map_or(&[], Vec::as_slice)
    }
}

/// Finds the spectra that are not known yet, two in one transform.
pub(super) fn transform(drives: &[&Driven], period: Period) {
    let unknown: Vec<&Driven> =
        drives.iter().copied().filter(|drive| drive.spectrum().len() != period.bins).collect();
    for pair in unknown.chunks(2) {
        let mut both = vec![c64::new(0.0, 0.0); period.length];
        for (one, drive) in [ONE, SECOND].into_iter().zip(pair) {
            let values = continued(&drive.values, period.length, period.time_step_s);
            both.iter_mut().zip(values).for_each(|(both, value)| *both += one * value);
        }
        fourier::forward(&mut both);
        for (drive, spectrum) in pair.iter().zip(parted(&both, pair.len(), period.bins)) {
            // who finds it at the same time finds the same
            let _ = drive.spectrum.set(spectrum);
        }
    }
}

/// The first bins of the spectra of one or two real records from that of both in one: that of a real record is its own mirror
/// image, conjugate.
pub(super) fn parted(both: &[c64], count: usize, bins: usize) -> Vec<Vec<c64>> {
    let length = both.len();
    let mirrored = |bin: usize| both[(length - bin) % length].conj();
    let first = |bin: usize| 0.5 * (both[bin] + mirrored(bin));
    let second = |bin: usize| c64::new(0.0, -0.5) * (both[bin] - mirrored(bin));
    match count {
        1 => vec![both[..bins].to_vec()],
        _ => vec![(0..bins).map(first).collect(), (0..bins).map(second).collect()],
    }
}
