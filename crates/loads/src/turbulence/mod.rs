//! Continuous turbulence in the frequency domain (CS 25.341(b)): root mean squares, crossings of zero, correlations, limit loads and the
//! loads that go with them.
//!
//! `A_i^2 = int |H_i|^2 Phi dOmega`, `rho_ij = int Re(H_i conj H_j) Phi dOmega/(A_i A_j)`; with load i at its limit load j is
//! `P_j,1g +- rho_ij U_sigma A_j`. All of it is linear in H, so that forces of grids that go with load i sum up to it exactly.

pub mod grid;
mod spectrum;

use crate::design::Spectrum;
pub use grid::{Grid, Mode};
pub use num_complex::Complex64;
use std::f64::consts::PI;

/// Air that an aircraft flies through.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turbulence {
    /// True airspeed, m/s.
    pub v_m_s: f64,
    /// Scale, m.
    pub scale_m: f64,
    /// Spectrum.
    pub spectrum: Spectrum,
}

/// Responses of loads to a gust of 1 m/s at the frequencies of a grid.
#[derive(Debug, Clone)]
pub struct Response<'a> {
    grid: &'a Grid,
    turbulence: Turbulence,
    /// A list a load, in the order of frequencies, load per m/s.
    loads: &'a [Vec<Complex64>],
    /// Phi dOmega at each frequency.
    shares: Vec<f64>,
    /// A of each load, load per m/s.
    a: Vec<f64>,
}

impl<'a> Response<'a> {
    /// Responses of loads: a list a load, as long as the grid's frequencies.
    pub fn new(grid: &'a Grid, turbulence: Turbulence, loads: &'a [Vec<Complex64>]) -> Self {
        let share = |(omega, weight): (&f64, &f64)| {
            let density = turbulence.spectrum.density(omega / turbulence.v_m_s, turbulence.scale_m);
            density * weight / turbulence.v_m_s
        };
        let shares: Vec<f64> = grid.omega_rad_s.iter().zip(&grid.weight_rad_s).map(share).collect();
        let mut response = Self { grid, turbulence, loads, shares, a: Vec::new() };
        response.a = loads.iter().map(|load| response.product(load, load).sqrt()).collect();
        response
    }

    /// int Re(x conj y) Phi dOmega.
    fn product(&self, x: &[Complex64], y: &[Complex64]) -> f64 {
        let terms = x.iter().zip(y).zip(&self.shares);
        terms.map(|((x, y), share)| (x.re * y.re + x.im * y.im) * share).sum()
    }

    /// A of a load: root mean square for turbulence of 1 m/s.
    pub fn a_bar(&self, load: usize) -> f64 {
        self.a[load]
    }

    /// Crossings of zero upwards, Hz. Depends on the cut-off much more than A does: no number to compare without it.
    pub fn n0_hz(&self, load: usize) -> f64 {
        let terms = self.loads[load].iter().zip(&self.shares).zip(&self.grid.omega_rad_s);
        let square: f64 = terms.map(|((h, share), omega)| h.norm_sqr() * share * omega * omega).sum();
        square.sqrt() / self.a[load] / (2.0 * PI)
    }

    /// Correlation of two loads.
    pub fn rho(&self, i: usize, j: usize) -> f64 {
        let (a, b) = (self.a[i], self.a[j]);
        if a == 0.0 || b == 0.0 { 0.0 } else { self.product(&self.loads[i], &self.loads[j]) / (a * b) }
    }

    /// By how much A of a load could grow beyond the cut-off, share of A: the largest |H| of the last octave held. None if a mode lies
    /// beyond it, where |H| would grow again.
    pub fn tail_bound(&self, load: usize) -> Option<f64> {
        if self.grid.mode_beyond {
            return None;
        }
        let from = self.grid.cut_off_rad_s / 2.0;
        let last = self.loads[load].iter().zip(&self.grid.omega_rad_s).filter(|(_, omega)| **omega >= from);
        let held = last.map(|(h, _)| h.norm_sqr()).fold(0.0, f64::max);
        let Turbulence { v_m_s, scale_m, spectrum } = self.turbulence;
        let tail = held * spectrum.beyond(self.grid.cut_off_rad_s / v_m_s, scale_m);
        Some((1.0 + tail / self.a[load].powi(2)).sqrt() - 1.0)
    }

    /// What another response (of a grid's force, of another station) is per m/s when a load is at its root mean square:
    /// int Re(H conj H_i) Phi dOmega/A_i. For a load of this response that is rho_ij A_j.
    pub fn companion(&self, of: &[Complex64], load: usize) -> f64 {
        if self.a[load] == 0.0 { 0.0 } else { self.product(of, &self.loads[load]) / self.a[load] }
    }

    /// Limit loads of a load for an intensity, m/s TAS: largest and smallest about what it is in steady flight.
    pub fn limits(&self, load: usize, one_g: f64, u_sigma_m_s: f64) -> [f64; 2] {
        [1.0, -1.0].map(|sign| one_g + sign * u_sigma_m_s * self.a[load])
    }

    /// Pairs of two loads on the ellipse of equal probability for an intensity, m/s TAS, about steady flight: the four points where one is
    /// at its limit, and the four on its axes in units of the limits (U A sqrt((1 +- rho)/2) in both).
    pub fn design_points(&self, pair: [usize; 2], one_g: [f64; 2], u_sigma_m_s: f64) -> [[f64; 2]; 8] {
        let rho = self.rho(pair[0], pair[1]);
        let (with, against) =
            (f64::midpoint(1.0, rho).max(0.0).sqrt(), f64::midpoint(1.0, -rho).max(0.0).sqrt());
        let units = [
            [1.0, rho],
            [rho, 1.0],
            [-1.0, -rho],
            [-rho, -1.0],
            [with, with],
            [-with, -with],
            [against, -against],
            [-against, against],
        ];
        units.map(|unit| [0, 1].map(|at| one_g[at] + unit[at] * u_sigma_m_s * self.a[pair[at]]))
    }
}
