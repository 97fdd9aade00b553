//! One root of F(p, kappa) u = 0 by Newton's method on p, u and kappa together.
//!
//! For a given kappa the bordered system [F, F_p u; cᴴ, 0] gives the steps of (u, p), and once more with the right-hand
//! side -F_kappa u their derivatives with respect to kappa. Im(p + dp) = (kappa + dkappa) V then fixes dkappa. kappa enters through
//! Im p, so p is no analytic unknown; this takes the real equation for it. A real root keeps kappa = 0.

use super::FlutterError;
use super::system::Aeroelastic;
use aero::Flow;
use faer::linalg::solvers::Solve;
use faer::{Mat, c64};

/// Newton steps at most; a root that needs more is not near.
const STEPS: usize = 12;
/// Step of p over its modulus at which a root is found.
const CLOSE: f64 = 1e-12;
/// A step no smaller than the one before is round-off below this share of the modulus.
const ROUND_OFF: f64 = 1e-8;
/// Share of kappa by which it is moved for derivatives.
const NUDGE: f64 = 1e-5;

/// Where roots are looked for: the stream, and by what share the air acts (one, but on the way from a vacuum).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Place {
    pub(super) flow: Flow,
    pub(super) share: f64,
}

/// A root with its shape.
#[derive(Debug, Clone)]
pub(super) struct State {
    /// Root, 1/s.
    pub(super) p: c64,
    /// Shape, with uᴴ M u near one.
    pub(super) u: Vec<c64>,
    /// Whether the root does not oscillate.
    pub(super) real: bool,
    /// Whether its frequency is beyond the table of forces.
    pub(super) beyond: bool,
}

/// Why Newton's method stopped without a root.
#[derive(Debug)]
pub(super) enum Missed {
    /// It does not converge from here.
    Far,
    /// The frequency goes to zero.
    Collapsed,
    /// The forces cannot be computed.
    Failed(FlutterError),
}

impl From<FlutterError> for Missed {
    fn from(error: FlutterError) -> Self {
        Self::Failed(error)
    }
}

/// What a Newton step needs at a point.
struct Point {
    matrix: Mat<c64>,
    slope: Mat<c64>,
    by_kappa: Mat<c64>,
    beyond: bool,
}

impl Aeroelastic<'_> {
    fn point(&self, p: c64, kappa: f64, real: bool, place: Place) -> Result<Point, FlutterError> {
        let v = place.flow.v_m_s;
        let at = |kappa: f64| self.split(kappa, v);
        let forces = at(kappa)?;
        let matrix = self.matrix(p, &forces, place.flow, place.share);
        let by_kappa = if real {
            Mat::zeros(self.size(), self.size())
        } else {
            let (low, high) = (kappa * (1.0 - NUDGE), kappa * (1.0 + NUDGE));
            let difference = self.matrix(p, &at(high)?, place.flow, place.share)
                - self.matrix(p, &at(low)?, place.flow, place.share);
            difference * faer::Scale(c64::from(1.0 / (high - low)))
        };
        let slope = self.slope(p, &forces, place.flow, place.share);
        Ok(Point { matrix, slope, by_kappa, beyond: forces.beyond })
    }

    /// The root that Newton's method reaches from a guess.
    pub(super) fn root(&self, guess: &State, place: Place) -> Result<State, Missed> {
        let mut state = guess.clone();
        let v = place.flow.v_m_s;
        let mut kappa = if state.real { 0.0 } else { state.p.im / v };
        let mut last = f64::INFINITY;
        for _ in 0..STEPS {
            if !state.real && kappa <= 0.0 {
                return Err(Missed::Collapsed);
            }
            let point = self.point(state.p, kappa, state.real, place)?;
            state.beyond = point.beyond;
            let (steps, dp) = bordered(&point, &state.u);
            let dkappa =
                if state.real { 0.0 } else { ((state.p + dp[0]).im / v - kappa) / (1.0 - dp[1].im / v) };
            let step = dp[0] + dp[1] * dkappa;
            if !step.norm().is_finite() {
                return Err(Missed::Far);
            }
            state.p += step;
            for (i, u) in state.u.iter_mut().enumerate() {
                *u += steps[(i, 0)] + steps[(i, 1)] * dkappa;
            }
            kappa += dkappa;
            if state.real {
                state.p.im = 0.0;
            } else {
                // on the line Im p = kappa V to the last bit
                state.p.im = kappa * v;
            }
            self.normalise(&mut state.u);
            let size = step.norm() / self.modulus(state.p);
            if size < CLOSE || (size < ROUND_OFF && size >= last) {
                return if state.real || kappa > 0.0 { Ok(state) } else { Err(Missed::Collapsed) };
            }
            last = size;
        }
        Err(Missed::Far)
    }

    /// Scales a shape to uᴴ M u = 1 (its plain length where that is not positive).
    fn normalise(&self, u: &mut [c64]) {
        let size = self.product(u, u).norm();
        if size > 0.0 && size.is_finite() {
            let factor = 1.0 / size.sqrt();
            for value in u.iter_mut() {
                *value *= factor;
            }
        }
    }

    /// aᴴ M b.
    pub(super) fn product(&self, a: &[c64], b: &[c64]) -> c64 {
        let mass = self.mass();
        let row = |i: usize| b.iter().enumerate().map(|(j, value)| *value * mass[(i, j)]).sum::<c64>();
        a.iter().enumerate().map(|(i, value)| value.conj() * row(i)).sum()
    }

    /// Modal assurance: |aᴴ M b|² over both sizes; one for the same shape.
    pub(super) fn likeness(&self, a: &[c64], b: &[c64]) -> f64 {
        let sizes = self.product(a, a).norm() * self.product(b, b).norm();
        if sizes > 0.0 { self.product(a, b).norm().powi(2) / sizes } else { 0.0 }
    }
}

/// Steps of (u, p): first those of Newton's method at fixed kappa, then their derivatives with respect to kappa.
fn bordered(point: &Point, u: &[c64]) -> (Mat<c64>, [c64; 2]) {
    let n = u.len();
    let times = |matrix: &Mat<c64>, i: usize| -> c64 { (0..n).map(|j| matrix[(i, j)] * u[j]).sum() };
    // rows and the border are brought to the size of F: the border's own units do not matter
    let size = point.matrix.norm_max().max(f64::MIN_POSITIVE);
    let slope_size = point.slope.norm_max().max(f64::MIN_POSITIVE);
    let system = Mat::from_fn(n + 1, n + 1, |i, j| match (i < n, j < n) {
        (true, true) => point.matrix[(i, j)] / size,
        (true, false) => times(&point.slope, i) / slope_size,
        (false, true) => u[j].conj(),
        (false, false) => c64::default(),
    });
    let right = Mat::from_fn(n + 1, 2, |i, column| match (i < n, column) {
        (true, 0) => -times(&point.matrix, i) / size,
        (true, _) => -times(&point.by_kappa, i) / size,
        (false, _) => c64::default(),
    });
    let steps = system.partial_piv_lu().solve(&right);
    let dp = [0, 1].map(|column| steps[(n, column)] * (size / slope_size));
    (steps, dp)
}

#[cfg(test)]
mod tests;
