//! The same air in steady oscillation: the response of the stepped equations themselves at a frequency, no transients.

use super::lattice::Lattice;
use super::operator::Operator;
use super::wake::Part;
use nalgebra::{Complex, DMatrix};

/// Strip loads by a motion that swings with unit amplitude, as complex amplitudes.
#[derive(Debug, Clone)]
pub struct Harmonic {
    /// Lift by strip, N.
    pub lift_n: Vec<Complex<f64>>,
    /// Moment about the quarter point by strip, N m.
    pub moment_n_m: Vec<Complex<f64>>,
}

/// Rows of [`Operator`] by all motions that swing with unit amplitude, a column a motion, and their rates.
pub(crate) struct States {
    pub(crate) state: DMatrix<Complex<f64>>,
    pub(crate) rate: DMatrix<Complex<f64>>,
}

impl States {
    /// At an angular frequency; `time_step_s` is the stepped equations' own.
    pub(crate) fn of(
        lattice: &Lattice,
        operator: &Operator,
        v_m_s: f64,
        time_step_s: f64,
        omega_rad_s: f64,
    ) -> Self {
        let (count, motions) = (operator.strips, operator.motions);
        let i_omega = Complex::new(0.0, omega_rad_s);
        let back = Complex::new(0.0, -omega_rad_s * time_step_s).exp();
        let by_motion = DMatrix::from_fn(3 * count, motions, |k, motion| {
            Complex::from(v_m_s * operator.by_motion[(k, motion)])
                + i_omega * operator.by_motion[(k, motions + motion)]
        });
        let mut wake = DMatrix::<Complex<f64>>::zeros(3 * count, count);
        if operator.by_wake.ncols() > 0 {
            for (row, strength) in strengths(lattice, back).iter().enumerate() {
                for s in 0..count {
                    for k in 0..3 * count {
                        wake[(k, s)] += strength * operator.by_wake[(k, row * count + s)];
                    }
                }
            }
        }
        let own = DMatrix::<Complex<f64>>::identity(count, count) - wake.rows(0, count);
        let shed = own.lu().solve(&by_motion.rows(0, count).into_owned());
        let shed = shed.unwrap_or_else(|| DMatrix::from_element(count, motions, Complex::new(f64::NAN, 0.0)));
        let part = wake * shed;
        let difference = (Complex::from(3.0) - 4.0 * back + back * back) / (2.0 * time_step_s);
        let state = &by_motion + &part;
        Self { state, rate: by_motion * i_omega + part * difference }
    }
}

impl Harmonic {
    /// The motion numbered `motion` at an angular frequency.
    pub fn of(
        lattice: &Lattice,
        operator: &Operator,
        motion: usize,
        rho_kg_m3: f64,
        v_m_s: f64,
        omega_rad_s: f64,
    ) -> Self {
        let count = operator.strips;
        let states = States::of(lattice, operator, v_m_s, lattice.step_m / v_m_s, omega_rad_s);
        let (state, rate) = (states.state.column(motion), states.rate.column(motion));
        let mut loads = Self { lift_n: Vec::new(), moment_n_m: Vec::new() };
        for (s, strip) in lattice.strips.iter().enumerate() {
            let scale = rho_kg_m3 * strip.width_m;
            let lift = (state[s] * v_m_s + rate[count + s]) * scale;
            let nose = (state[s] * strip.chord_m - state[count + s]) * v_m_s + rate[2 * count + s];
            loads.lift_n.push(lift);
            loads.moment_n_m.push(lift * (0.25 * strip.chord_m) - nose * scale);
        }
        loads
    }

    /// Fz, Mx, My about (`x_m`, 0), of what the balance carries.
    pub fn at_balance(&self, lattice: &Lattice, x_m: f64) -> [Complex<f64>; 3] {
        let mut sums = [Complex::from(0.0); 3];
        for (s, strip) in lattice.strips.iter().enumerate().filter(|(_, strip)| strip.metric) {
            sums[0] += self.lift_n[s];
            sums[1] += self.lift_n[s] * strip.y_m;
            sums[2] += self.moment_n_m[s] - self.lift_n[s] * (strip.quarter_x_m() - x_m);
        }
        sums
    }
}

/// What every row has of a unit circulation that swings; `back` is one step back in time.
fn strengths(lattice: &Lattice, back: Complex<f64>) -> Vec<Complex<f64>> {
    let mean = |from: usize, to: usize| {
        let inner: Complex<f64> = (from + 1..to).map(|k| power(back, k)).sum();
        (inner + 0.5 * (power(back, from) + power(back, to))) / (to - from) as f64
    };
    let part = |part: Part| match part {
        Part::Node(ago) | Part::Endless(ago) => power(back, ago),
        Part::Mean(from, to) => mean(from, to),
    };
    lattice.rows.parts().into_iter().map(part).collect()
}

fn power(back: Complex<f64>, steps: usize) -> Complex<f64> {
    let (modulus, angle) = back.to_polar();
    Complex::from_polar(modulus.powf(steps as f64), angle * steps as f64)
}
