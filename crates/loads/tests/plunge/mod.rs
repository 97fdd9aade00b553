//! Aircraft that only plunge, rigid and with flexible wings, with strip lift and R. T. Jones's lags: the models of the references.

use loads::turbulence::Complex64;
use serde_json::Value;

/// Lags over semichords: shares and rates of the lift after a step of the angle (Wagner) and of a gust (Kussner), by R. T. Jones.
const WAGNER: [(f64, f64); 2] = [(0.165, 0.0455), (0.335, 0.3)];
const KUSSNER: [(f64, f64); 2] = [(0.5, 0.13), (0.5, 1.0)];

/// A lag's transfer function at a frequency in radians a semichord.
fn lag(terms: &[(f64, f64); 2], kappa: f64) -> Complex64 {
    let i_kappa = Complex64::new(0.0, kappa);
    terms.iter().fold(Complex64::new(1.0, 0.0), |sum, (share, rate)| sum - share * i_kappa / (i_kappa + rate))
}

/// A rigid aircraft; lengths in chords, speeds in airspeeds.
#[derive(Clone, Copy)]
pub(crate) struct Rigid {
    pub(crate) mu_g: f64,
    pub(crate) lagged: bool,
}

impl Rigid {
    /// z'' over the gust at a frequency in radians a chord.
    pub(crate) fn acceleration(self, omega: f64) -> Complex64 {
        let one = Complex64::new(1.0, 0.0);
        let [psi, phi] =
            [&KUSSNER, &WAGNER].map(|terms| if self.lagged { lag(terms, omega / 2.0) } else { one });
        let i_omega = Complex64::new(0.0, omega);
        // The same divided by omega where it is large, so that nothing overflows.
        psi / (self.mu_g + phi / i_omega)
    }

    /// Peak of z'' over that of a sharp edge, through a gust over time in chords, by Runge and Kutta's steps.
    pub(crate) fn peak(self, gust: &dyn Fn(f64) -> f64, until: f64) -> f64 {
        let rate = |tau: f64, x: &[f64; 5]| -> ([f64; 5], f64) {
            let w = gust(tau);
            // Velocity, two lags of the gust, two of the motion.
            let lift_of_gust =
                if self.lagged { w - (0..2).map(|k| KUSSNER[k].0 * (w - x[1 + k])).sum::<f64>() } else { w };
            let lift_of_motion = if self.lagged {
                x[0] - (0..2).map(|k| WAGNER[k].0 * (x[0] - x[3 + k])).sum::<f64>()
            } else {
                x[0]
            };
            let load = lift_of_gust - lift_of_motion;
            let mut dx = [load / self.mu_g, 0.0, 0.0, 0.0, 0.0];
            for k in 0..2 {
                dx[1 + k] = 2.0 * KUSSNER[k].1 * (w - x[1 + k]);
                dx[3 + k] = 2.0 * WAGNER[k].1 * (x[0] - x[3 + k]);
            }
            (dx, load)
        };
        let (steps, mut x, mut largest) = (40_000, [0.0; 5], 0.0f64);
        let step = until / f64::from(steps);
        for at in 0..steps {
            let tau = f64::from(at) * step;
            let moved = |x: &[f64; 5], dx: &[f64; 5], by: f64| -> [f64; 5] {
                std::array::from_fn(|k| x[k] + by * dx[k])
            };
            let (k1, load) = rate(tau, &x);
            largest = largest.max(load);
            let (k2, _) = rate(tau + step / 2.0, &moved(&x, &k1, step / 2.0));
            let (k3, _) = rate(tau + step / 2.0, &moved(&x, &k2, step / 2.0));
            let (k4, _) = rate(tau + step, &moved(&x, &k3, step));
            x = std::array::from_fn(|k| x[k] + step / 6.0 * (k1[k] + 2.0 * k2[k] + 2.0 * k3[k] + k4[k]));
        }
        largest
    }
}

/// A body and two masses a half wing on a massless cantilever.
pub(crate) struct Flexible {
    pub(crate) v_m_s: f64,
    /// Half of the body, and the masses of a wing, kg.
    mass: [f64; 3],
    area: [f64; 3],
    y: [f64; 2],
    x_lift: [f64; 2],
    x_mass: [f64; 2],
    stiffness: [[f64; 2]; 2],
    lift_slope: f64,
    chord_m: f64,
    rho: f64,
}

impl Flexible {
    pub(crate) fn of(inputs: &Value) -> Self {
        let one = |name: &str| inputs[name].as_f64().expect("a number");
        let two = |name: &str| [0, 1].map(|at| inputs[name][at].as_f64().expect("a number"));
        let (y, ei) = (two("y_m"), one("ei_nm2"));
        let flexibility = |a: f64, b: f64| {
            let (u, w) = (a.min(b), a.max(b));
            u * u * (3.0 * w - u) / (6.0 * ei)
        };
        let f = [
            [flexibility(y[0], y[0]), flexibility(y[0], y[1])],
            [flexibility(y[1], y[0]), flexibility(y[1], y[1])],
        ];
        let det = f[0][0] * f[1][1] - f[0][1] * f[1][0];
        let stiffness = [[f[1][1] / det, -f[0][1] / det], [-f[1][0] / det, f[0][0] / det]];
        let [masses, areas] = [two("wing_masses_kg"), two("wing_areas_m2")];
        Self {
            v_m_s: one("V_m_s"),
            mass: [one("body_mass_kg") / 2.0, masses[0], masses[1]],
            area: [one("body_area_m2") / 2.0, areas[0], areas[1]],
            y,
            x_lift: two("x_lift_m"),
            x_mass: two("x_mass_m"),
            stiffness,
            lift_slope: one("lift_slope"),
            chord_m: one("chord_m"),
            rho: one("rho_kg_m3"),
        }
    }

    /// Fz, Mx, My at the right wing's root and n_z of the body for a gust of 1 m/s at a frequency, rad/s.
    pub(crate) fn loads(&self, omega: f64) -> [Complex64; 4] {
        let kappa = omega * self.chord_m / (2.0 * self.v_m_s);
        let (psi, phi) = (lag(&KUSSNER, kappa), lag(&WAGNER, kappa));
        let i_omega = Complex64::new(0.0, omega);
        let damping = 0.5 * self.rho * self.v_m_s * self.lift_slope;
        // Velocities: mass i omega + lift + springs/(i omega).
        let mut matrix = [[Complex64::new(0.0, 0.0); 3]; 3];
        let mut right = [Complex64::new(0.0, 0.0); 3];
        for at in 0..3 {
            matrix[at][at] = self.mass[at] * i_omega + damping * self.area[at] * phi;
            right[at] = damping * self.area[at] * psi;
        }
        // Wings move against the body.
        let relative = [[-1.0, 1.0, 0.0], [-1.0, 0.0, 1.0]];
        for (row, one) in matrix.iter_mut().enumerate() {
            for (column, value) in one.iter_mut().enumerate() {
                let sum: f64 = (0..2)
                    .flat_map(|a| (0..2).map(move |b| (a, b)))
                    .map(|(a, b)| relative[a][row] * self.stiffness[a][b] * relative[b][column])
                    .sum();
                *value += sum / i_omega;
            }
        }
        let velocity = solve(matrix, right);
        let lift: [Complex64; 3] =
            std::array::from_fn(|at| damping * self.area[at] * (psi - phi * velocity[at]));
        let inertia: [Complex64; 3] = std::array::from_fn(|at| self.mass[at] * i_omega * velocity[at]);
        let sum = |of: &dyn Fn(usize) -> Complex64| of(0) + of(1);
        [
            sum(&|k| lift[k + 1] - inertia[k + 1]),
            sum(&|k| self.y[k] * (lift[k + 1] - inertia[k + 1])),
            sum(&|k| self.x_mass[k] * inertia[k + 1] - self.x_lift[k] * lift[k + 1]),
            i_omega * velocity[0] / 9.80665,
        ]
    }
}

/// Three equations by Cramer's rule.
fn solve(matrix: [[Complex64; 3]; 3], right: [Complex64; 3]) -> [Complex64; 3] {
    let det = |m: &[[Complex64; 3]; 3]| {
        m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
            + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
    };
    let whole = det(&matrix);
    std::array::from_fn(|column| {
        let mut own = matrix;
        (0..3).for_each(|row| own[row][column] = right[row]);
        det(&own) / whole
    })
}
