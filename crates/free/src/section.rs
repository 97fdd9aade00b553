//! A rigid section on a heave and a pitch spring in a stream: its equations as a dynamic stiffness and as states.

use crate::air::{JONES, Strip};
use nalgebra::{Complex, Matrix2, SMatrix};

/// The state: heave (m), pitch (rad), their rates, the two lags of the circulation (m/s).
pub type State = SMatrix<f64, 6, 1>;

/// Numbers of the linear section. Heave is positive down, pitch nose up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Section {
    /// Everything that heaves, kg.
    pub mass_kg: f64,
    /// Mass times distance of the centre of gravity behind the axis, kg m.
    pub unbalance_kgm: f64,
    /// Moment of inertia about the axis, kg m2.
    pub inertia_kg_m2: f64,
    /// Heave spring, N/m.
    pub heave_stiffness_n_per_m: f64,
    /// Heave damper, N s/m.
    pub heave_damping_n_s_per_m: f64,
    /// Pitch spring, N m/rad.
    pub pitch_stiffness_nm: f64,
    /// Pitch damper, N m s/rad.
    pub pitch_damping_nm_s: f64,
    /// Its air.
    pub strip: Strip,
}

/// The stream.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stream {
    /// Density, kg/m3.
    pub rho_kg_m3: f64,
    /// Airspeed, m/s.
    pub v_m_s: f64,
}

impl Stream {
    /// Dynamic pressure, Pa.
    pub fn q_pa(&self) -> f64 {
        0.5 * self.rho_kg_m3 * self.v_m_s * self.v_m_s
    }
}

impl Section {
    fn mass(&self) -> Matrix2<f64> {
        Matrix2::new(self.mass_kg, self.unbalance_kgm, self.unbalance_kgm, self.inertia_kg_m2)
    }

    fn damping(&self) -> Matrix2<f64> {
        Matrix2::new(self.heave_damping_n_s_per_m, 0.0, 0.0, self.pitch_damping_nm_s)
    }

    fn springs(&self) -> Matrix2<f64> {
        Matrix2::new(self.heave_stiffness_n_per_m, 0.0, 0.0, self.pitch_stiffness_nm)
    }

    /// `[force, moment]` per `[heave, pitch]` at the Laplace variable `p`, 1/s.
    pub fn dynamic_stiffness(&self, stream: Stream, p: Complex<f64>) -> Matrix2<Complex<f64>> {
        let own = Matrix2::from_fn(|i, j| {
            p * p * self.mass()[(i, j)] + p * self.damping()[(i, j)] + self.springs()[(i, j)]
        });
        own + self.strip.stiffness(stream.rho_kg_m3, stream.v_m_s, p)
    }

    /// The matrix of `x' = A x` at an airspeed above zero, and the inverse of the mass with its air.
    pub fn state_matrix(&self, stream: Stream) -> (SMatrix<f64, 6, 6>, Matrix2<f64>) {
        let air = self.strip.matrices(stream.rho_kg_m3, stream.v_m_s);
        let inverse = (self.mass() + air.mass).try_inverse().unwrap_or_else(Matrix2::zeros);
        let downwash = [0.0, air.downwash_pitch, air.downwash_rate[0], air.downwash_rate[1]];
        // Jones: w_effective = phi(0) w + sum of a b V/half chord z, z' = w - b V/half chord z
        let direct = 1.0 - self.strip.lag * JONES.iter().map(|(a, _)| a).sum::<f64>();
        let pace = stream.v_m_s / self.strip.semichord_m;
        let mut force = SMatrix::<f64, 2, 6>::zeros();
        for i in 0..2 {
            for j in 0..2 {
                force[(i, j)] -= self.springs()[(i, j)];
                force[(i, 2 + j)] -= self.damping()[(i, j)] + air.damping[(i, j)];
            }
            for (j, w) in downwash.iter().enumerate() {
                force[(i, j)] -= air.circulatory[i] * direct * w;
            }
            for (lag, (a, b)) in JONES.iter().enumerate() {
                force[(i, 4 + lag)] -= air.circulatory[i] * self.strip.lag * a * b * pace;
            }
        }
        let mut matrix = SMatrix::<f64, 6, 6>::zeros();
        matrix[(0, 2)] = 1.0;
        matrix[(1, 3)] = 1.0;
        matrix.fixed_view_mut::<2, 6>(2, 0).copy_from(&(inverse * force));
        for (lag, (_, b)) in JONES.iter().enumerate() {
            for (j, w) in downwash.iter().enumerate() {
                matrix[(4 + lag, j)] = *w;
            }
            matrix[(4 + lag, 4 + lag)] = -b * pace;
        }
        (matrix, inverse)
    }

    /// Roots of the linear section, 1/s, the fastest growing oscillation first.
    pub fn roots(&self, stream: Stream) -> Vec<Complex<f64>> {
        let eigenvalues = self.state_matrix(stream).0.complex_eigenvalues();
        let mut roots: Vec<_> = eigenvalues.iter().copied().filter(|root| root.im > 0.0).collect();
        roots.sort_by(|a, b| b.re.total_cmp(&a.re));
        roots
    }

    /// The lowest airspeed of a range (m/s) at which an oscillation grows, found to a millimetre a second; none without one.
    pub fn onset_m_s(&self, rho_kg_m3: f64, range_m_s: [f64; 2]) -> Option<f64> {
        let growth =
            |v_m_s: f64| self.roots(Stream { rho_kg_m3, v_m_s }).first().map_or(-1.0, |root| root.re);
        let steps: usize = 400;
        let at = |k: usize| range_m_s[0] + (range_m_s[1] - range_m_s[0]) * k as f64 / steps as f64;
        let first = (1..=steps).find(|k| growth(at(*k)) > 0.0)?;
        let (mut low, mut high) = (at(first - 1), at(first));
        while high - low > 1e-3 {
            let middle = 0.5 * (low + high);
            if growth(middle) > 0.0 { high = middle } else { low = middle }
        }
        Some(0.5 * (low + high))
    }
}
