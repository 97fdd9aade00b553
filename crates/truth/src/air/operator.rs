//! The lattice with its sections, solved: strips' circulations and integrals by motions and by the wake's memory.

use super::lattice::Lattice;
use super::motions::Motions;
use crate::wing::Section;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// Rows of all matrices: circulation of the strips, then the two integrals over their chords. Motions are multiplied by
/// the airspeed, rates by one.
#[derive(Debug, Clone)]
pub struct Operator {
    /// By positions, then by rates; what is in the wake is remembered apart.
    pub by_motion: DMatrix<f64>,
    /// By the parts of the wake's memory, part after part.
    pub(crate) by_wake: DMatrix<f64>,
    /// By positions at rest.
    pub(crate) steady: DMatrix<f64>,
    /// By an incidence of every strip at rest.
    pub(crate) steady_by_strip: DMatrix<f64>,
    /// By an incidence of every strip in motion.
    pub(crate) by_strip: DMatrix<f64>,
    /// Number of strips.
    pub(crate) strips: usize,
    /// Number of motions.
    pub motions: usize,
}

impl Operator {
    /// Solves a lattice whose strips have sections: each lacks or gains the incidence that brings its lift from that of a flat
    /// plate to its polar's, `(1/(2 pi) - 1/slope) cl`; angles of zero lift are incidences of strips.
    ///
    /// `wake`: whether there is one, as in a stream.
    pub fn new(lattice: &Lattice, sections: &[Section], motions: &Motions, wake: bool) -> Self {
        let (count, n) = (lattice.strips.len(), lattice.chordwise);
        // downwash by the strips' last rings, beside that of the rings alone
        let mut moving = DMatrix::zeros(count * n, count);
        for (s, section) in sections.iter().enumerate() {
            let lacks = 1.0 / TAU - 1.0 / section.slope_per_rad;
            moving.view_mut((s * n, s), (n, 1)).fill(-2.0 * lacks / lattice.strips[s].chord_m);
        }
        let mut steady = moving.clone();
        if wake {
            moving += &lattice.present;
            steady += &lattice.present;
            lattice.wake.iter().for_each(|part| steady += part);
        }
        let columns = motions.columns();
        let of_strips = DMatrix::from_fn(count * n, count, |i, s| f64::from(u8::from(i / n == s)));
        let [read, at_rest] = [moving, steady].map(|more| lattice.read_with(&more));
        let rows = if wake { lattice.wake.len() } else { 0 };
        let mut by_wake = DMatrix::zeros(3 * count, count * rows);
        for row in 0..rows {
            by_wake.columns_mut(row * count, count).copy_from(&(-&read * &lattice.wake[row]));
        }
        Self {
            by_motion: &read * &columns,
            by_wake,
            steady: &at_rest * columns.columns(0, motions.len()),
            steady_by_strip: &at_rest * &of_strips,
            by_strip: &read * &of_strips,
            strips: count,
            motions: motions.len(),
        }
    }

    /// Changes the effect of a motion's position and rate.
    pub fn scale_motion(&mut self, motion: usize, factor: f64) {
        self.by_motion.column_mut(motion).scale_mut(factor);
        self.by_motion.column_mut(self.motions + motion).scale_mut(factor);
        self.steady.column_mut(motion).scale_mut(factor);
    }

    /// Circulations and integrals of a motion by `position`, times the airspeed, at rest.
    pub fn at_rest(&self, motion: usize, position_v_m_s: f64) -> DVector<f64> {
        self.steady.column(motion) * position_v_m_s
    }
}

/// Lift and nose-up moment about the quarter point of every strip, N and N m.
#[derive(Debug, Clone)]
pub struct Loads {
    /// Lift by strip.
    pub lift_n: DVector<f64>,
    /// Moment by strip.
    pub moment_n_m: DVector<f64>,
}

impl Loads {
    /// Of circulations and integrals, and the rates of the integrals (rows as of [`Operator`]).
    pub fn of(
        lattice: &Lattice,
        rho_kg_m3: f64,
        v_m_s: f64,
        state: &DVector<f64>,
        rate: &DVector<f64>,
    ) -> Self {
        let count = lattice.strips.len();
        let mut loads = Self { lift_n: DVector::zeros(count), moment_n_m: DVector::zeros(count) };
        for (s, strip) in lattice.strips.iter().enumerate() {
            let scale = rho_kg_m3 * strip.width_m;
            let lift = scale * (v_m_s * state[s] + rate[count + s]);
            let about_nose = v_m_s * (state[s] * strip.chord_m - state[count + s]) + rate[2 * count + s];
            loads.lift_n[s] = lift;
            loads.moment_n_m[s] = 0.25 * strip.chord_m * lift - scale * about_nose;
        }
        loads
    }

    /// Fz, Mx, My about (`x_m`, 0), of what the balance carries.
    pub fn at_balance(&self, lattice: &Lattice, x_m: f64) -> [f64; 3] {
        let mut sums = [0.0; 3];
        for (s, strip) in lattice.strips.iter().enumerate().filter(|(_, strip)| strip.metric) {
            sums[0] += self.lift_n[s];
            sums[1] += self.lift_n[s] * strip.y_m;
            sums[2] += self.moment_n_m[s] - self.lift_n[s] * (strip.quarter_x_m() - x_m);
        }
        sums
    }
}
