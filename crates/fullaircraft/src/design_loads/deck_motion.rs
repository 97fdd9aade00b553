//! What waves of a gust do to the stations and grids of a user's deck, in time and in turbulence: changes from level flight.
//!
//! ```text
//! y(t) = dw/pi sum_j Re[H(w_j) F(w_j) exp(i w_j t)],   w_j = (j + 1/2) dw,   F(w) = int u(t) exp(-i w t) dt
//! ```
//! Half a step of frequency lies before the first, so that nothing is asked of a free aircraft at rest; what comes back after the
//! period `2 pi/dw` is the answer with its sign turned, and there must be nothing left of it.

use crate::deck::gust::waves::{GustWaves, Waves};
use crate::deck::modal::ModalDeck;
use crate::deck::structure::box_displacements;
use crate::design_loads::instants::FlownInstant;
use crate::error::AircraftError;
use crate::stations::nodal::{Component, NodalLoads};
use crate::stations::places::Station;
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatRef, Par, c64};
use loads::turbulence::Response;
use std::f64::consts::{PI, TAU};

/// Loads of a station.
const SIX: usize = 6;
/// Times that are worked on together: what thousands of frequencies add to all times of a flight would be hundreds of megabytes.
const TOGETHER: usize = 32;

/// A deck's stations and grids by its modes and its air.
#[derive(Debug)]
pub(super) struct DeckMotion<'a> {
    pub(super) waves: GustWaves,
    pub(super) stations: &'a [Station],
    /// Six loads of each station by masses times accelerations of the modes.
    by_modes: Mat<f64>,
    /// Masses times accelerations of the modes, g-set by modes.
    momentum: Mat<f64>,
    /// Places in the g-set of the rows behind those of the stations; none where loads at grids are not asked for.
    s_dofs: Vec<usize>,
    /// A force and a moment of the deck, N and N m.
    units: [f64; 2],
    /// Level flight: loads at stations (N, N m) by component, and at grids (the deck's units).
    level: (Vec<[[f64; SIX]; 5]>, NodalLoads),
}

/// Answers over frequency, per unit velocity of the deck.
#[derive(Debug)]
pub(super) struct Spectrum {
    pub(super) waves: Waves,
    inertia: Mat<c64>,
    damping: Mat<c64>,
    /// Net loads of the stations, six each, N and N m.
    pub(super) net: Mat<c64>,
}

/// A gust of one minus a cosine as its answer is made of.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wave {
    /// Its largest velocity, the deck's unit of length a second.
    pub(super) velocity: f64,
    /// How long it takes to pass, s.
    pub(super) lasts_s: f64,
    /// How many harmonics of that time count.
    pub(super) harmonics: f64,
}

impl Wave {
    /// What answers (by frequency, rad/s, equal steps from half a step on) add up to at times, rows by times.
    fn sums<const N: usize>(&self, of: [&Mat<c64>; N], omega_rad_s: &[f64], t_s: &[f64]) -> [Mat<f64>; N] {
        let highest = self.harmonics * TAU / self.lasts_s;
        let count = omega_rad_s.partition_point(|omega| *omega <= highest);
        let first = omega_rad_s.first().copied().unwrap_or(0.0);
        let scale = self.velocity * 2.0 * first / PI;
        let amplitudes: Vec<c64> =
            omega_rad_s[..count].iter().map(|omega| one_minus_cosine(*omega, self.lasts_s) * scale).collect();
        let part =
            |of: &Mat<c64>, part: fn(&c64) -> f64| Mat::from_fn(of.nrows(), count, |i, k| part(&of[(i, k)]));
        let parts = of.map(|of| [part(of, |value| value.re), part(of, |value| -value.im)]);
        let mut sums = of.map(|of| Mat::zeros(of.nrows(), t_s.len()));
        let mut turns = [0, 1].map(|_| Mat::<f64>::zeros(count, TOGETHER.min(t_s.len())));
        for (block, times) in t_s.chunks(TOGETHER).enumerate() {
            for (at, t_s) in times.iter().enumerate() {
                let step = c64::cis(2.0 * first * t_s);
                let mut turn = c64::cis(first * t_s);
                let [re, im] = turns.each_mut().map(|part| part.col_as_slice_mut(at));
                for ((re, im), amplitude) in re.iter_mut().zip(im).zip(&amplitudes) {
                    let value = amplitude * turn;
                    (*re, *im) = (value.re, value.im);
                    turn *= step;
                }
            }
            for (parts, sum) in parts.iter().zip(&mut sums) {
                for (at, accum) in [(0, Accum::Replace), (1, Accum::Add)] {
                    let own = sum.as_mut().subcols_mut(block * TOGETHER, times.len());
                    // gusts are side by side: more threads for a small block only wait for each other
                    matmul(own, accum, &parts[at], turns[at].subcols(0, times.len()), 1.0, Par::Seq);
                }
            }
        }
        sums
    }
}

/// Changes from level flight, a column a sample: the air's loads on the rows, and the forces on the modes by inertia and by damping.
#[derive(Debug)]
pub(super) struct Changes {
    rows: Mat<f64>,
    inertia: Mat<f64>,
    damping: Mat<f64>,
}

/// Rows of box loads that are asked of the air: six of each station, then the grids that splines reach.
pub(super) fn rows_of(modal: &ModalDeck, stations: &[Station], s_dofs: &[usize]) -> Mat<f64> {
    let count = SIX * stations.len();
    let mut rows = Mat::zeros(count + s_dofs.len(), 2 * modal.lattice.len());
    for (at, station) in stations.iter().enumerate() {
        let moved = modal.spline.displace(motions(modal, station).as_ref());
        rows.subrows_mut(SIX * at, SIX).copy_from(moved.transpose());
    }
    if !s_dofs.is_empty() {
        let on_grids = box_displacements(&modal.spline, s_dofs);
        rows.subrows_mut(count, s_dofs.len()).copy_from(on_grids.transpose());
    }
    rows
}

/// Motions of a station's grids along and about its axes, g-set by 6.
fn motions(modal: &ModalDeck, station: &Station) -> Mat<f64> {
    let basic = station.motions(&modal.system, &station.point);
    Mat::from_fn(basic.nrows(), SIX, |dof, load| {
        (0..3).map(|k| basic[(dof, 3 * (load / 3) + k)] * station.axes[(k, load % 3)]).sum()
    })
}

impl Spectrum {
    /// What a gust (velocity in the deck's unit of length, the aircraft's speed in m/s) does at times, s, by answers at equal steps.
    pub(super) fn in_time(&self, wave: &Wave, t_s: &[f64]) -> Changes {
        let of = [&self.waves.rows, &self.inertia, &self.damping];
        let [rows, inertia, damping] = wave.sums(of, &self.waves.omega_rad_s, t_s);
        Changes { rows, inertia, damping }
    }

    /// Changes of the stations' net loads alone, six rows each, N and N m, a column a time.
    pub(super) fn net_in_time(&self, wave: &Wave, t_s: &[f64]) -> Mat<f64> {
        let [net] = wave.sums([&self.net], &self.waves.omega_rad_s, t_s);
        net
    }

    /// The same, and those of the air alone, in the deck's units.
    pub(super) fn net_and_air_in_time(&self, wave: &Wave, t_s: &[f64]) -> [Mat<f64>; 2] {
        let [net, air] = wave.sums([&self.net, &self.waves.rows], &self.waves.omega_rad_s, t_s);
        let stations = net.nrows();
        [net, air.subrows(0, stations).to_owned()]
    }

    /// What goes with each of some loads in turbulence, per their root mean squares times `factors`.
    pub(super) fn with_loads(&self, of: &Response<'_>, factors: &[f64]) -> Changes {
        let goes = |all: &Mat<c64>| {
            let mut found = Mat::zeros(all.nrows(), factors.len());
            for row in 0..all.nrows() {
                let list: Vec<c64> = all.row(row).iter().copied().collect();
                for (at, factor) in factors.iter().enumerate() {
                    found[(row, at)] = factor * of.companion(&list, at);
                }
            }
            found
        };
        Changes { rows: goes(&self.waves.rows), inertia: goes(&self.inertia), damping: goes(&self.damping) }
    }
}

impl<'a> DeckMotion<'a> {
    /// Of waves whose rows are [`rows_of`] these stations and grids.
    pub(super) fn new(
        waves: GustWaves,
        stations: &'a [Station],
        s_dofs: Vec<usize>,
        units: [f64; 2],
        level: (Vec<[[f64; SIX]; 5]>, NodalLoads),
    ) -> Self {
        let modal = &waves.modal;
        let momentum = modal.system.inertia_loads(modal.shapes.as_ref());
        let mut by_modes = Mat::zeros(SIX * stations.len(), momentum.ncols());
        for (at, station) in stations.iter().enumerate() {
            let own = motions(modal, station).transpose() * &momentum;
            by_modes.subrows_mut(SIX * at, SIX).copy_from(&own);
        }
        Self { waves, stations, by_modes, momentum, s_dofs, units, level }
    }

    /// With its answers at frequencies, rad/s.
    pub(super) fn spectrum(&self, omega_rad_s: Vec<f64>) -> Result<Spectrum, AircraftError> {
        let waves = self.waves.at(omega_rad_s)?;
        let (inertia, damping) = (waves.inertia(), waves.damping(&self.waves));
        let on_modes = &inertia + &damping;
        let by_modes =
            Mat::from_fn(self.by_modes.nrows(), on_modes.nrows(), |i, j| c64::from(self.by_modes[(i, j)]));
        let moved = by_modes * on_modes;
        let net = Mat::from_fn(moved.nrows(), moved.ncols(), |i, k| {
            (waves.rows[(i, k)] + moved[(i, k)]) * self.units[i % SIX / 3]
        });
        Ok(Spectrum { waves, inertia, damping, net })
    }

    /// The air's load of a station over frequency, N or N m per unit velocity of the deck.
    pub(super) fn air(&self, spectrum: &Spectrum, station: usize, load: usize) -> Vec<c64> {
        let row = SIX * station + load;
        let unit = self.units[load / 3];
        (0..spectrum.waves.rows.ncols()).map(|k| spectrum.waves.rows[(row, k)] * unit).collect()
    }

    /// The change of a station's air, inertia and damping at a sample, N and N m.
    fn change(&self, changes: &Changes, station: usize, sample: usize) -> [[f64; SIX]; 3] {
        let by = |of: &Mat<f64>, row: usize| -> f64 {
            (0..of.nrows()).map(|mode| self.by_modes[(row, mode)] * of[(mode, sample)]).sum()
        };
        let each = |part: usize, load: usize| {
            let row = SIX * station + load;
            let value = match part {
                0 => changes.rows[(row, sample)],
                1 => by(&changes.inertia, row),
                _ => by(&changes.damping, row),
            };
            value * self.units[load / 3]
        };
        std::array::from_fn(|part| std::array::from_fn(|load| each(part, load)))
    }

    /// Net loads of a station in level flight, N and N m.
    pub(super) fn level(&self, station: usize) -> [f64; SIX] {
        self.level.0[station][Component::ALL.len() - 1]
    }

    /// Loads of all stations at a sample.
    pub(super) fn instant(&self, changes: &Changes, t_s: f64, sample: usize) -> FlownInstant {
        let at = |station: usize| {
            let mut all = self.level.0[station];
            let parts = self.change(changes, station, sample);
            for (part, component) in [(0, 0), (1, 1), (2, 3)] {
                for load in 0..SIX {
                    all[component][load] += parts[part][load];
                    all[Component::ALL.len() - 1][load] += parts[part][load];
                }
            }
            all
        };
        let loads = (0..self.stations.len()).map(at).collect();
        FlownInstant { t_s, tips_m: [0.0; 2], gradient_m: None, limit: None, loads }
    }

    /// Loads at all grids at a sample, the deck's units.
    pub(super) fn nodal(&self, changes: &Changes, sample: usize) -> NodalLoads {
        let mut all = self.level.1.clone();
        let first = SIX * self.stations.len();
        for (row, dof) in self.s_dofs.iter().enumerate() {
            all.air[*dof] += changes.rows[(first + row, sample)];
        }
        let column = |of: &Mat<f64>| Mat::from_fn(of.nrows(), 1, |mode, _| of[(mode, sample)]);
        let add = |list: &mut [f64], of: MatRef<'_, f64>| {
            list.iter_mut().enumerate().for_each(|(dof, sum)| *sum += of[(dof, 0)]);
        };
        add(&mut all.inertia, (&self.momentum * column(&changes.inertia)).as_ref());
        add(&mut all.damping, (&self.momentum * column(&changes.damping)).as_ref());
        all
    }
}

/// Fourier's integral of one minus a cosine of size one that lasts `lasts_s`: `int (1 - cos(2 pi t/T))/2 exp(-i w t) dt`.
fn one_minus_cosine(omega_rad_s: f64, lasts_s: f64) -> c64 {
    let wave = |nu: f64| {
        let half = 0.5 * nu * lasts_s;
        let size = if half.abs() < 1e-8 { 1.0 } else { half.sin() / half };
        c64::cis(-half) * (size * lasts_s)
    };
    let turn = TAU / lasts_s;
    wave(omega_rad_s) * 0.5 - (wave(omega_rad_s - turn) + wave(omega_rad_s + turn)) * 0.25
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_transform_of_one_minus_a_cosine_is_its_integral() {
        let lasts_s = 0.7;
        for omega in [0.0, 0.3, TAU / lasts_s, 11.0, 60.0] {
            let steps = 20_000;
            let step = lasts_s / f64::from(steps);
            let one = |k: i32| {
                let t = step * (f64::from(k) + 0.5);
                c64::cis(-omega * t) * (0.5 * (1.0 - (TAU * t / lasts_s).cos()) * step)
            };
            let sum: c64 = (0..steps).map(one).sum();
            let off = (sum - one_minus_cosine(omega, lasts_s)).norm();
            assert!(off < 1e-8, "{omega}: {off}");
        }
    }
}
