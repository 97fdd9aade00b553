//! The wing on its balance in steady oscillation.

use super::coupled::Coupled;
use crate::air::States;
use nalgebra::{Complex, DMatrix};

impl Coupled<'_> {
    /// Fz, Mx, My by unit swings of pitch and of the controls' deflections (columns) at an angular frequency: air and inertia,
    /// no weight.
    pub fn swing(&self, omega_rad_s: f64) -> DMatrix<Complex<f64>> {
        let structure = &self.structure;
        let modes = structure.omega_rad_s.len();
        let states = States::of(&self.rig.lattice, &self.operator, self.v_m_s, self.time_step_s, omega_rad_s);
        let complex = |matrix: &DMatrix<f64>| matrix.map(Complex::from);
        let strip = complex(&self.by_state) * &states.state + complex(&self.by_rate) * &states.rate;
        let forces = complex(&self.generalised) * &strip;
        let others = strip.ncols() - modes;
        let square = Complex::from(-omega_rad_s * omega_rad_s);
        let dynamic = DMatrix::from_fn(modes, modes, |i, j| {
            let omega = structure.omega_rad_s[i];
            let damped = Complex::new(0.0, 2.0 * structure.damping[i] * omega * omega_rad_s);
            let own = square + damped + omega * omega;
            if i == j { own - forces[(i, j)] } else { -forces[(i, j)] }
        });
        let forced = DMatrix::from_fn(modes, others, |i, j| {
            let inertia = if j == 0 { square * structure.fields[(i, 1)] } else { Complex::from(0.0) };
            forces[(i, modes + j)] + inertia
        });
        let modal = dynamic.lu().solve(&forced);
        let modal =
            modal.unwrap_or_else(|| DMatrix::from_element(modes, others, Complex::new(f64::NAN, 0.0)));
        let mut all = DMatrix::<Complex<f64>>::zeros(strip.ncols(), others);
        all.rows_mut(0, modes).copy_from(&modal);
        for other in 0..others {
            all[(modes + other, other)] = Complex::from(1.0);
        }
        let mut loads = complex(&self.balance) * strip * all - complex(&structure.balance) * modal * square;
        for channel in 0..3 {
            loads[(channel, 0)] += square * structure.rigid[1][channel];
        }
        loads
    }
}
