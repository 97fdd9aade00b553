//! Whether a section with effects moves as was measured: what is left of its equations at the first three harmonics of an
//! oscillation (harmonic balance), in standard deviations of what was measured.

use crate::effect::{Active, Instant};
use crate::points::Point;
use crate::rig::{LinearRig, Scatter};
use crate::section::{Section, Stream};
use crate::window::HARMONICS;
use nalgebra::{Complex, Matrix4, Vector4};
use std::f64::consts::TAU;
use std::sync::LazyLock;

/// Turned by so much at each instant.
static TURNS: LazyLock<[Complex<f64>; INSTANTS]> =
    LazyLock::new(|| std::array::from_fn(|k| Complex::from_polar(1.0, TAU * k as f64 / INSTANTS as f64)));
/// Relative step of a difference quotient along the Laplace variable.
const QUOTIENT: f64 = 1e-6;
/// Instants of a cycle at which effects are evaluated.
const INSTANTS: usize = 32;
/// Steps of Newton's method at most.
const MOST_STEPS: usize = 30;
/// Residuals of a point: real and imaginary parts of growth and frequency, of heave per pitch, of the pitch's
/// second and third harmonic.
pub const RESIDUALS: usize = 8;

/// A section that is judged by a point.
#[derive(Debug, Clone)]
pub struct Model {
    /// The linear part.
    pub rig: LinearRig,
    /// What acts beside it.
    pub effects: Vec<Active>,
    /// Angle from the mean of a day's motion to where the pitch spring is at rest, rad.
    pub centre_rad: f64,
    /// Factor on the pitch spring on this day.
    pub stiffness: f64,
    /// Factor on pitch damping and friction on this day.
    pub damping: f64,
}

/// By what residuals are divided: roots of their covariances.
#[derive(Debug, Clone, PartialEq)]
pub struct Whitening {
    first: Matrix4<f64>,
    harmonics: f64,
    /// Logarithm of what densities are divided by.
    pub log_volume: f64,
}

/// What of a motion is taken as it is.
#[derive(Debug, Clone, Copy)]
struct Shape<'a> {
    stream: Stream,
    mean_rad: f64,
    pitch: &'a [Complex<f64>; HARMONICS],
}

impl<'a> Shape<'a> {
    fn of(point: &'a Point) -> Self {
        Self { stream: point.stream, mean_rad: point.mean_rad, pitch: &point.measured.pitch }
    }
}

/// What of a point is measured at its first harmonic: log amplitude, growth, frequency, heave ratio, log airspeed.
fn seen(point: &Point) -> [f64; 6] {
    let m = &point.measured;
    [m.amplitude_rad.ln(), m.p.re, m.p.im, m.heave[0].re, m.heave[0].im, point.stream.v_m_s]
}

fn scatter_of(point: &Point, scatter: &Scatter) -> [f64; 6] {
    let m = &point.measured;
    let stirred = scatter.turbulence_rad / m.amplitude_rad;
    let ratio = m.heave[0].norm() * scatter.heave_ratio.hypot(stirred / 6.0);
    let growth = scatter.growth_per_s.hypot(if m.p.re == 0.0 { 0.0 } else { stirred });
    let omega = (scatter.frequency * m.p.im).hypot(if m.p.re == 0.0 { 0.0 } else { stirred });
    [scatter.amplitude, growth, omega, ratio, ratio, scatter.airspeed_m_s]
}

impl Model {
    /// Residuals of a point, not whitened, N/rad and N m/rad.
    fn residuals(&self, shape: &Shape<'_>, at: &[f64; 6]) -> [Complex<f64>; 4] {
        let section = self.section();
        let p = Complex::new(at[1], at[2]);
        let mut stream = shape.stream;
        stream.v_m_s = at[5];
        let seen = (-p * self.rig.heave_delay_s).exp() * self.rig.heave_gain;
        let heave = Complex::new(at[3], at[4]) / seen;
        let loads = self.loads(shape, at, heave);
        let own = section.dynamic_stiffness(stream, p);
        let equations = [
            own[(0, 0)] * heave + own[(0, 1)] + loads[0][0],
            own[(1, 0)] * heave + own[(1, 1)] + loads[0][1],
        ];
        // one step of Newton: growth and frequency, and heave per pitch, with which the equations would hold
        let slope = (section.dynamic_stiffness(stream, p * (1.0 + QUOTIENT)) - own) / (p * QUOTIENT);
        let of_p = [slope[(0, 0)] * heave + slope[(0, 1)], slope[(1, 0)] * heave + slope[(1, 1)]];
        let determinant = of_p[0] * own[(1, 0)] - of_p[1] * own[(0, 0)];
        let mut left = [Complex::default(); 4];
        left[0] = (equations[0] * own[(1, 0)] - equations[1] * own[(0, 0)]) / determinant;
        left[1] = (of_p[0] * equations[1] - of_p[1] * equations[0]) / determinant * seen;
        for n in [2, 3] {
            let own = section.dynamic_stiffness(stream, p * n as f64);
            // heave as a linear guide makes it
            let condensed = own[(1, 1)] - own[(1, 0)] * own[(0, 1)] / own[(0, 0)];
            let moved = loads[n - 1][1] - own[(1, 0)] / own[(0, 0)] * loads[n - 1][0];
            left[n] = shape.pitch[n - 1] + moved / condensed;
        }
        left
    }

    /// The oscillation that the model has at an amplitude (rad): growth and frequency (1/s) and heave per pitch (m/rad), by
    /// Newton's method from a guess; none without convergence.
    pub fn respond(
        &self,
        stream: Stream,
        amplitude_rad: f64,
        guess: [Complex<f64>; 2],
    ) -> Option<[Complex<f64>; 2]> {
        let [mut p, mut heave] = guess;
        let mut pitch = [Complex::default(); HARMONICS];
        pitch[0] = Complex::new(1.0, 0.0);
        let plain = Shape { stream, mean_rad: 0.0, pitch: &pitch };
        for _ in 0..MOST_STEPS {
            let at = [amplitude_rad.ln(), p.re, p.im, heave.re, heave.im, stream.v_m_s];
            let left = self.residuals(&plain, &at);
            p -= left[0];
            heave -= left[1];
            if left[0].norm() < 1e-9 * p.norm() {
                return Some([p, heave]);
            }
        }
        None
    }

    /// The section of this day.
    pub fn section(&self) -> Section {
        let mut section = self.rig.section;
        section.pitch_stiffness_nm *= self.stiffness;
        section.pitch_damping_nm_s *= self.damping;
        section
    }

    /// Harmonics of force and moment of the effects per amplitude of pitch.
    fn loads(&self, shape: &Shape<'_>, at: &[f64; 6], heave: Complex<f64>) -> [[Complex<f64>; 2]; 3] {
        let mut sums = [[Complex::default(); 2]; 3];
        if self.effects.is_empty() {
            return sums;
        }
        let amplitude = at[0].exp();
        let strip = &self.rig.section.strip;
        let chord_m = 2.0 * strip.semichord_m;
        let q = 0.5 * shape.stream.rho_kg_m3 * at[5] * at[5];
        for turn in TURNS.iter() {
            let (mut pitch, mut rate) = (self.centre_rad + shape.mean_rad, 0.0);
            let mut wave = Complex::new(amplitude, 0.0);
            for (n, harmonic) in shape.pitch.iter().enumerate() {
                wave *= turn;
                let moved = wave * harmonic;
                pitch += moved.re;
                rate -= (n + 1) as f64 * at[2] * moved.im;
            }
            let instant = Instant {
                heave_rate_m_s: -at[2] * amplitude * (heave * turn).im,
                pitch_rad: pitch,
                pitch_rate_rad_s: rate,
                v_m_s: at[5],
                pressed_n: q * strip.lifting_span_m * chord_m,
                chord_m,
                omega_rad_s: at[2],
            };
            let mut back = Complex::new(2.0 / (INSTANTS as f64 * amplitude), 0.0);
            let [force, moment] = self.at_instant(&instant);
            for sum in &mut sums {
                back *= turn.conj();
                sum[0] += back * force;
                sum[1] += back * moment;
            }
        }
        sums
    }

    /// Force and moment of all effects.
    fn at_instant(&self, instant: &Instant) -> [f64; 2] {
        self.effects.iter().fold([0.0, 0.0], |sum, active| {
            let stiffness = self.rig.section.pitch_stiffness_nm;
            let [force, moment] = active.effect.loads(&active.values, instant, stiffness);
            [sum[0] + force, sum[1] + moment]
        })
    }

    /// What residuals of a point are divided by, from how far each thing measured may be off, `width` times as far.
    pub fn whitening(&self, point: &Point, scatter: &Scatter, width: f64) -> Whitening {
        let (at, spread) = (seen(point), scatter_of(point, scatter).map(|sd| sd * width));
        let outcomes = |at: &[f64; 6]| {
            let left = self.residuals(&Shape::of(point), at);
            Vector4::new(left[0].re, left[0].im, left[1].re, left[1].im)
        };
        let mut covariance =
            Matrix4::from_diagonal(&Vector4::from_column_slice(&spread[1..5])).map(|v| v * v);
        for k in [0, 5] {
            let [mut up, mut down] = [at, at];
            up[k] += 0.5 * spread[k];
            down[k] -= 0.5 * spread[k];
            let moved = outcomes(&up) - outcomes(&down);
            covariance += moved * moved.transpose();
        }
        let factor = covariance.cholesky().map_or_else(Matrix4::identity, |factor| factor.l());
        let stirred = scatter.turbulence_rad / point.measured.amplitude_rad;
        let log_volume = factor.diagonal().iter().map(|v| v.ln()).sum::<f64>();
        let first = factor.try_inverse().unwrap_or_else(Matrix4::identity);
        Whitening { first, harmonics: scatter.harmonics.hypot(stirred / 6.0), log_volume }
    }

    /// Residuals of a point in standard deviations.
    pub fn whitened(&self, point: &Point, whitening: &Whitening) -> [f64; RESIDUALS] {
        let left = self.residuals(&Shape::of(point), &seen(point));
        let first = whitening.first * Vector4::new(left[0].re, left[0].im, left[1].re, left[1].im);
        let [second, third] = [left[2] / whitening.harmonics, left[3] / whitening.harmonics];
        [first[0], first[1], first[2], first[3], second.re, second.im, third.re, third.im]
    }
}
