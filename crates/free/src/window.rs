//! A piece of a run as one oscillation: growth, frequency, amplitude, and the other sensor beside it, harmonics of both.

use crate::least_squares::minimise;
use nalgebra::{Complex, DMatrix, DVector};
use std::f64::consts::TAU;

/// Harmonics that are fitted.
pub const HARMONICS: usize = 3;

/// An oscillation `Re sum of X_n exp(n p t)` about a mean, p = growth + i omega; t from the middle of the window.
#[derive(Debug, Clone, PartialEq)]
pub struct Oscillation {
    /// Growth and circular frequency, 1/s.
    pub p: Complex<f64>,
    /// Amplitude of the pitch's first harmonic in the middle, rad.
    pub amplitude_rad: f64,
    /// Harmonics of the pitch per amplitude; the first is 1.
    pub pitch: [Complex<f64>; HARMONICS],
    /// Harmonics of the heave per amplitude of pitch, m/rad.
    pub heave: [Complex<f64>; HARMONICS],
    /// Mean of the pitch, rad.
    pub pitch_mean_rad: f64,
    /// What is left of the pitch, root mean square, rad.
    pub left_rad: f64,
    /// What is left of the heave, m.
    pub left_m: f64,
}

/// Finds the oscillation in samples `dt_s` apart from a first guess of its frequency (rad/s); a steady one does not grow.
pub fn oscillation(pitch: &[f64], heave: &[f64], dt_s: f64, omega: f64, steady: bool) -> Oscillation {
    let scale = [rms(pitch).max(1e-9), rms(heave).max(1e-9)];
    let misfit = |x: &[f64]| {
        let p = exponent(x, omega, steady);
        let basis = basis(pitch.len(), dt_s, p);
        let mut left = DVector::zeros(2 * pitch.len());
        for (k, (data, scale)) in [pitch, heave].iter().zip(scale).enumerate() {
            let data = DVector::from_column_slice(data);
            let part = (&data - &basis * solved(&basis, &data)) / scale;
            left.rows_mut(k * pitch.len(), pitch.len()).copy_from(&part);
        }
        left
    };
    let bounds = [[-2.0, 2.0], [-20.0, 20.0]];
    let parameters = if steady { 1 } else { 2 };
    let found = minimise(&misfit, &vec![0.0; parameters], &bounds[..parameters]);
    let p = exponent(&found, omega, steady);
    described(pitch, heave, &basis(pitch.len(), dt_s, p), p)
}

/// The first parameter moves the frequency by a tenth, the second is the growth, 1/s.
fn exponent(x: &[f64], omega: f64, steady: bool) -> Complex<f64> {
    Complex::new(if steady { 0.0 } else { x[1] }, omega * (1.0 + 0.1 * x[0]))
}

fn rms(x: &[f64]) -> f64 {
    (x.iter().map(|v| v * v).sum::<f64>() / x.len() as f64).sqrt()
}

fn basis(samples: usize, dt_s: f64, p: Complex<f64>) -> DMatrix<f64> {
    DMatrix::from_fn(samples, 1 + 2 * HARMONICS, |i, j| {
        let t = dt_s * (i as f64 - 0.5 * (samples as f64 - 1.0));
        match j {
            0 => 1.0,
            j => {
                let wave = (p * (j.div_ceil(2) as f64) * t).exp();
                if j % 2 == 1 { wave.re } else { -wave.im }
            }
        }
    })
}

fn solved(basis: &DMatrix<f64>, data: &DVector<f64>) -> DVector<f64> {
    let normal = basis.tr_mul(basis);
    normal
        .cholesky()
        .map_or_else(|| DVector::zeros(basis.ncols()), |factor| factor.solve(&basis.tr_mul(data)))
}

fn described(pitch: &[f64], heave: &[f64], basis: &DMatrix<f64>, p: Complex<f64>) -> Oscillation {
    let [pitch, heave] = [pitch, heave].map(DVector::from_column_slice);
    let [of_pitch, of_heave] = [&pitch, &heave].map(|data| solved(basis, data));
    let left = |data: &DVector<f64>, found: &DVector<f64>| rms((data - basis * found).as_slice());
    let harmonic = |found: &DVector<f64>, n: usize| Complex::new(found[2 * n - 1], found[2 * n]);
    let first = harmonic(&of_pitch, 1);
    // time from where the pitch is largest: the n-th harmonic turns n times as fast
    let turned = |found: &DVector<f64>| {
        std::array::from_fn(|k| {
            harmonic(found, k + 1) * Complex::from_polar(1.0 / first.norm(), -first.arg() * (k + 1) as f64)
        })
    };
    Oscillation {
        p,
        amplitude_rad: first.norm(),
        pitch: turned(&of_pitch),
        heave: turned(&of_heave),
        pitch_mean_rad: of_pitch[0],
        left_rad: left(&pitch, &of_pitch),
        left_m: left(&heave, &of_heave),
    }
}

/// The circular frequency (rad/s) of a range (Hz) at which a sine takes most off the samples.
pub fn strongest(samples: &[f64], dt_s: f64, range_hz: [f64; 2]) -> f64 {
    let power = |hz: f64| {
        let turns = samples.iter().enumerate();
        let sum: Complex<f64> =
            turns.map(|(i, x)| Complex::from_polar(*x, -TAU * hz * dt_s * i as f64)).sum();
        sum.norm()
    };
    let steps = 200;
    let hz = (0..=steps).map(|k| range_hz[0] + (range_hz[1] - range_hz[0]) * f64::from(k) / f64::from(steps));
    TAU * hz.max_by(|a, b| power(*a).total_cmp(&power(*b))).unwrap_or(range_hz[0])
}
