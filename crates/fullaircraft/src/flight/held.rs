//! Answers to waves of a gust by frequency, with airspeed and attitude held: as gust analyses in the frequency domain are made, with
//! plunge, sideslip and the three rates free. No phugoid and no spiral, which a pilot holds and whose damping is not the model's.
//!
//! ```text
//! i w x = A x + sum_j A_j z_j + B u      x: plunge, sideslip, rates, modes, their rates
//! z_j   = V rho/(i w + V g_j)            lags of pole g_j, rho: rates over V of all motions the air answers
//! rho   = R x + sum_j R_j z_j + R_u u
//! u     = exp(-i w b/V), i w exp(-i w b/V)   at stations b behind the foremost, for 1 m/s
//! ```
//! With the lags gone a frequency costs some hundred equations. All of it is read off the state space of small motions, so that
//! loads have the rows they have in flight.

use crate::flight::air::RIGID;
use crate::flight::small_motions::FreeFlight;
use crate::flight::state::mode_state;
use faer::linalg::solvers::Solve;
use faer::{Mat, c64};
use loads::turbulence::Mode;
use structure::unsymmetric::eigenvalues;

/// Place of the lags' first state in small motions, and of the first mode's: one before the full state's.
const LESS: usize = 1;
/// Poles with less damping than this share of their size are modes that a grid of frequencies is refined around.
const NARROW: f64 = 0.25;

/// See the module.
#[derive(Debug)]
pub struct Held<'a> {
    free: &'a FreeFlight,
    /// States that are free, beside lags, as small states.
    kept: Mat<f64>,
    /// `A`, and by the lags of each pole.
    own: Mat<f64>,
    by_lags: Vec<Mat<f64>>,
    by_input: Mat<f64>,
    /// Rates over V by free states, by the lags of each pole, by inputs.
    rates: Mat<f64>,
    rates_by_lags: Vec<Mat<f64>>,
    rates_by_input: Mat<f64>,
}

/// States (small ones, in the order of small motions) and inputs at frequencies, a list each, per m/s of the gust.
#[derive(Debug)]
pub(crate) struct Waves {
    pub(crate) states: Vec<Vec<c64>>,
    pub(crate) inputs: Vec<Vec<c64>>,
}

impl<'a> Held<'a> {
    /// Of an aircraft that meets gusts.
    pub(crate) fn new(free: &'a FreeFlight) -> Self {
        let equations = &free.flying.equations;
        let layout = equations.layout;
        let v = equations.reference.v_m_s;
        let kept = kept(free);
        let lag = |pole: usize| layout.lag(pole, 0) - LESS;
        let to_own = kept.transpose();
        let rates_of = |from: &Mat<f64>| from.as_ref().subrows(lag(0), layout.motions) * faer::Scale(1.0 / v);
        let mut by_states = rates_of(&free.a);
        for motion in 0..layout.motions {
            by_states[(motion, lag(0) + motion)] += equations.poles_per_m[0];
        }
        let poles = 0..layout.poles;
        let columns = |of: &Mat<f64>, pole: usize| of.as_ref().subcols(lag(pole), layout.motions).to_owned();
        Self {
            own: to_own * &free.a * &kept,
            by_lags: poles.clone().map(|pole| to_own * columns(&free.a, pole)).collect(),
            by_input: to_own * &free.b,
            rates: &by_states * &kept,
            rates_by_lags: poles.map(|pole| columns(&by_states, pole)).collect(),
            rates_by_input: rates_of(&free.b),
            kept,
            free,
        }
    }

    /// Eigenvalues, 1/s; none if they do not converge.
    fn eigenvalues(&self) -> Option<Vec<c64>> {
        let layout = self.free.flying.equations.layout;
        let answering = RIGID + layout.modes;
        let first = self.kept.ncols();
        let lags = layout.poles * answering;
        let n = self.free.a.nrows();
        let place = |lag: usize| layout.lag(lag / answering, lag % answering) - LESS;
        let mut chosen = Mat::zeros(n, first + lags);
        chosen.as_mut().subcols_mut(0, first).copy_from(&self.kept);
        (0..lags).for_each(|at| chosen[(place(at), first + at)] = 1.0);
        eigenvalues((chosen.transpose() * &self.free.a * &chosen).as_ref())
    }

    /// Its modes that are narrow, or how long the fastest growing motion takes to double, s.
    ///
    /// # Errors
    /// The time to double, s, if a motion grows; not a number if eigenvalues do not converge.
    pub fn modes(&self) -> Result<Vec<Mode>, f64> {
        let all = self.eigenvalues().ok_or(f64::NAN)?;
        let fastest = all.iter().map(|value| value.re).fold(f64::NEG_INFINITY, f64::max);
        if fastest > 0.0 {
            return Err(std::f64::consts::LN_2 / fastest);
        }
        let narrow = all.iter().filter(|value| value.im > 0.0 && -value.re < NARROW * value.im);
        Ok(narrow.map(|value| Mode { omega_rad_s: value.im, decay_rad_s: -value.re }).collect())
    }

    /// Answers at frequencies, rad/s.
    pub(crate) fn waves(&self, omega_rad_s: &[f64]) -> Waves {
        let (n, m) = (self.free.a.nrows(), self.free.b.ncols());
        let mut waves = Waves {
            states: vec![Vec::with_capacity(omega_rad_s.len()); n],
            inputs: vec![Vec::with_capacity(omega_rad_s.len()); m],
        };
        for omega in omega_rad_s {
            let inputs = self.inputs(*omega);
            let states = self.states(*omega, &inputs);
            waves.states.iter_mut().zip(states).for_each(|(list, value)| list.push(value));
            waves.inputs.iter_mut().zip(inputs).for_each(|(list, value)| list.push(value));
        }
        waves
    }

    /// A wave of 1 m/s at the stations, its phase zero at the foremost.
    fn inputs(&self, omega_rad_s: f64) -> Vec<c64> {
        let flying = &self.free.flying;
        let v = flying.equations.reference.v_m_s;
        let mut inputs = vec![c64::ZERO; self.free.b.ncols()];
        let (first, stations) = (flying.drives.len(), flying.gust_behind_m.len());
        for (station, behind_m) in flying.gust_behind_m.iter().enumerate() {
            let wave = c64::cis(-omega_rad_s * behind_m / v);
            inputs[first + station] = wave;
            inputs[first + stations + station] = wave * c64::new(0.0, omega_rad_s);
        }
        inputs
    }

    /// Small states at a frequency.
    fn states(&self, omega_rad_s: f64, inputs: &[c64]) -> Vec<c64> {
        let equations = &self.free.flying.equations;
        let layout = equations.layout;
        let v = equations.reference.v_m_s;
        let (own, motions) = (self.own.nrows(), layout.motions);
        let lag = |g: &f64| v / c64::new(v * g, omega_rad_s);
        let lags: Vec<c64> = equations.poles_per_m.iter().map(lag).collect();
        let sum = |of: &[Mat<f64>], i: usize, j: usize| -> c64 {
            of.iter().zip(&lags).map(|(part, lag)| lag * part[(i, j)]).sum()
        };
        let matrix = Mat::from_fn(own + motions, own + motions, |i, j| {
            let unit = f64::from(u8::from(i == j));
            match (i < own, j < own) {
                (true, true) => c64::new(-self.own[(i, j)], omega_rad_s * unit),
                (true, false) => -sum(&self.by_lags, i, j - own),
                (false, true) => c64::from(-self.rates[(i - own, j)]),
                (false, false) => c64::from(unit) - sum(&self.rates_by_lags, i - own, j - own),
            }
        });
        let driven = |rows: &Mat<f64>, i: usize| -> c64 {
            inputs.iter().enumerate().map(|(j, input)| input * rows[(i, j)]).sum()
        };
        let right = Mat::from_fn(own + motions, 1, |i, _| {
            if i < own { driven(&self.by_input, i) } else { driven(&self.rates_by_input, i - own) }
        });
        let found = matrix.partial_piv_lu().solve(&right);
        let kept = |state: usize| (0..own).map(|at| found[(at, 0)] * self.kept[(state, at)]).sum();
        let mut states: Vec<c64> = (0..self.free.a.nrows()).map(kept).collect();
        for (pole, lag) in lags.iter().enumerate() {
            for motion in 0..motions {
                states[layout.lag(pole, motion) - LESS] = lag * found[(own + motion, 0)];
            }
        }
        states
    }
}

/// States that are free, beside lags: plunge across the stream, sideslip, rates, modes and their rates.
fn kept(free: &FreeFlight) -> Mat<f64> {
    let equations = &free.flying.equations;
    let layout = equations.layout;
    let (sine, cosine) = equations.reference.alpha_rad.sin_cos();
    let first = RIGID;
    let mut kept = Mat::zeros(free.a.nrows(), first + 2 * layout.modes);
    (kept[(0, 0)], kept[(2, 0)]) = (-sine, cosine);
    (1..first).for_each(|at| kept[([1, 3, 4, 5][at - 1], at)] = 1.0);
    for mode in 0..layout.modes {
        kept[(mode_state(mode) - LESS, first + mode)] = 1.0;
        kept[(layout.mode_rate(mode) - LESS, first + layout.modes + mode)] = 1.0;
    }
    kept
}
