//! One number for the lift: the factor on all box loads of the theory that fits best, and its standard uncertainty.
//!
//! Few data do not determine a distribution of corrections, but they do determine this: with `W = s` at every box and no
//! pressure offset, `s` is the least-squares solution over all fitted channels, each row in its standard deviation, free
//! zeros of the tip eliminated (Gauss-Newton from s = 1, on the exact derivative). Its uncertainty is
//!
//! ```text
//! sigma(s) = sqrt(max(1, chi²/dof)) sqrt((1 + rho) / (1 - rho)) / sqrt(sum (dr/ds / sigma_r)²)
//! ```
//! where rho is the correlation of neighbouring residuals in the order of the file (not below zero): the rows of a sweep
//! come from one slow process and say less than as many independent ones.
//!
//! Whether one factor serves all deflections is asked by a second unknown about the solution, `s + b z/z_max` with the model's
//! height z of the tip: b is zero within its uncertainty where the model's deflections grow as the measured ones do.

use crate::campaign::TIP;
use crate::fit::Problem;
use aero::Corrections;
use coupling::{CouplingError, RootSensitivity, SteadyModel};

/// Gauss-Newton steps at most; the problem is one smooth curve, and three or four do.
const MOST_STEPS: usize = 20;
/// Share of the growing part that one factor does not explain, below which the two are not told apart.
const LEAST_APART: f64 = 1e-6;

/// The uniform factor on lift.
#[derive(Debug, Clone, PartialEq)]
pub struct LiftFactor {
    /// Factor on the theoretical load of every box.
    pub factor: f64,
    /// Its standard uncertainty from the scatter of the data alone, no prior.
    pub sigma: f64,
    /// Correlation rho of neighbouring residuals.
    pub correlation: f64,
    /// Root mean square of the residuals that are left, by channel (N, N m, N m, m).
    pub rmse: [f64; 4],
    /// Free zeros of the tip reading by block: what the reading shows when the tip has not moved, m, and its standard
    /// uncertainty; empty if the zero is known.
    pub tip_zeros: Vec<(f64, f64)>,
    /// By how much the factor would change from no to the largest deflection of the tip, and its standard uncertainty; none if the
    /// tip is not fitted, or the data do not tell the two apart.
    pub trend: Option<(f64, f64)>,
}

impl LiftFactor {
    /// How much wider correlated rows make every uncertainty than independent ones.
    pub fn widening(&self) -> f64 {
        ((1.0 + self.correlation) / (1.0 - self.correlation)).sqrt()
    }
}

/// One channel at one factor, by row, in standard deviations; the tip's about its zero.
struct Channel {
    /// Its place among Fz, Mx, My and the tip.
    place: usize,
    residuals: Vec<f64>,
    /// By the factor.
    slopes: Vec<f64>,
    /// By the part of the factor that grows with the height of the tip.
    growing: Vec<f64>,
}

/// Rows at one factor.
struct At {
    channels: Vec<Channel>,
    /// Means by block of simulated minus measured tip and of its derivative, m.
    tip_means: (Vec<f64>, Vec<f64>),
}

/// Finds the factor; none if nothing hangs on it.
pub(crate) fn lift_factor<M: SteadyModel>(
    problem: &Problem<'_, M>,
    point_sigma: [f64; 4],
) -> Result<Option<LiftFactor>, CouplingError> {
    let mut factor = 1.0;
    let mut at = at(problem, point_sigma, factor)?;
    for _ in 0..MOST_STEPS {
        let (slope, information) = at.normal();
        if information <= 0.0 {
            return Ok(None);
        }
        let step = -slope / information;
        factor += step;
        at = self::at(problem, point_sigma, factor)?;
        if step.abs() < 1e-10 {
            break;
        }
    }
    let (_, information) = at.normal();
    let count: usize = at.channels.iter().map(|channel| channel.residuals.len()).sum();
    let squares: f64 = at.channels.iter().flat_map(|channel| &channel.residuals).map(|r| r * r).sum();
    let freedom = count.saturating_sub(1 + problem.zero.count()).max(1) as f64;
    let scatter = (squares / freedom).max(1.0).sqrt();
    let mut found = LiftFactor {
        factor,
        sigma: 0.0,
        correlation: at.correlation(problem),
        rmse: [0.0; 4],
        tip_zeros: Vec::new(),
        trend: None,
    };
    let wide = scatter * found.widening();
    found.sigma = wide / information.sqrt();
    found.trend = at.trend(freedom - 1.0, found.widening()).filter(|_| problem.channels[TIP]);
    for Channel { place, residuals, .. } in &at.channels {
        let squares: f64 =
            residuals.iter().zip(problem.angles()).map(|(r, a)| r * r / a.replicates as f64).sum();
        found.rmse[*place] = point_sigma[*place] * (squares / residuals.len() as f64).sqrt();
    }
    if problem.zero.count() > 0 {
        let (zeros, arms) = &at.tip_means;
        let shares = problem.zero.means_of_inverse(problem.angles().map(|angle| angle.replicates as f64));
        found.tip_zeros = (0..zeros.len())
            .map(|b| {
                let own = wide * point_sigma[TIP] * shares[b].sqrt();
                (-zeros[b], own.hypot(arms[b] * found.sigma))
            })
            .collect();
    }
    Ok(Some(found))
}

/// Residuals and derivatives at a factor.
fn at<M: SteadyModel>(
    problem: &Problem<'_, M>,
    point_sigma: [f64; 4],
    factor: f64,
) -> Result<At, CouplingError> {
    let boxes = problem.model.correctable().len();
    let corrections = Corrections {
        force: vec![factor; boxes],
        moment: vec![factor; boxes],
        pressure_offset: vec![0.0; boxes],
    };
    let sensitivities = problem.sensitivities(&corrections)?;
    let misses = problem.misses(&sensitivities);
    let slope = |at: &RootSensitivity, channel: usize| -> f64 {
        (0..boxes).map(|b| at.by_force[(channel, b)] + at.by_moment[(channel, b)]).sum()
    };
    let means = (
        problem.zero.means(|row| misses[row][TIP]),
        problem.zero.means(|row| slope(&sensitivities[row], TIP)),
    );
    let highest_m = sensitivities.iter().map(|at| at.tip_z_m.abs()).fold(f64::MIN_POSITIVE, f64::max);
    let channels = (0..4).filter(|&c| problem.channels[c]).map(|channel| {
        let mut residuals: Vec<f64> = misses.iter().map(|row| row[channel]).collect();
        let mut slopes: Vec<f64> = sensitivities.iter().map(|at| slope(at, channel)).collect();
        let mut growing: Vec<f64> =
            slopes.iter().zip(&sensitivities).map(|(slope, at)| slope * at.tip_z_m / highest_m).collect();
        let columns = [&mut residuals, &mut slopes, &mut growing];
        let sigma = point_sigma[channel].max(f64::MIN_POSITIVE);
        for column in columns {
            if channel == TIP {
                problem.zero.centre(column);
            }
            for (value, angle) in column.iter_mut().zip(problem.angles()) {
                *value *= (angle.replicates as f64).sqrt() / sigma;
            }
        }
        Channel { place: channel, residuals, slopes, growing }
    });
    Ok(At { channels: channels.collect(), tip_means: means })
}

impl At {
    /// Gradient and curvature of half the sum of squares.
    fn normal(&self) -> (f64, f64) {
        (self.product(|at| &at.residuals, |at| &at.slopes), self.product(|at| &at.slopes, |at| &at.slopes))
    }

    fn product(&self, a: impl Fn(&Channel) -> &Vec<f64>, b: impl Fn(&Channel) -> &Vec<f64>) -> f64 {
        self.channels.iter().flat_map(|at| a(at).iter().zip(b(at))).map(|(a, b)| a * b).sum()
    }

    /// The growing part of the factor by least squares, with its standard uncertainty.
    fn trend(&self, freedom: f64, widening: f64) -> Option<(f64, f64)> {
        let ss = self.product(|at| &at.slopes, |at| &at.slopes);
        let sg = self.product(|at| &at.slopes, |at| &at.growing);
        let gg = self.product(|at| &at.growing, |at| &at.growing);
        let rs = self.product(|at| &at.residuals, |at| &at.slopes);
        let rg = self.product(|at| &at.residuals, |at| &at.growing);
        let rr = self.product(|at| &at.residuals, |at| &at.residuals);
        let apart = gg - sg * sg / ss;
        if freedom < 1.0 || apart <= LEAST_APART * gg {
            return None;
        }
        let trend = -(rg - sg / ss * rs) / apart;
        let squares = rr - rs * rs / ss - trend * trend * apart;
        let scatter = (squares / freedom).max(1.0).sqrt();
        Some((trend, scatter * widening / apart.sqrt()))
    }

    /// Correlation of residuals that follow one another in the file, blocks apart, all channels together.
    fn correlation<M: SteadyModel>(&self, problem: &Problem<'_, M>) -> f64 {
        let place: Vec<(usize, usize)> = problem.angles().map(|angle| (angle.block, angle.line)).collect();
        let mut order: Vec<usize> = (0..place.len()).collect();
        order.sort_by_key(|&row| place[row]);
        let (mut products, mut squares) = (0.0, 0.0);
        for Channel { residuals, .. } in &self.channels {
            for pair in order.windows(2).filter(|pair| place[pair[0]].0 == place[pair[1]].0) {
                products += residuals[pair[0]] * residuals[pair[1]];
                squares += 0.5 * (residuals[pair[0]].powi(2) + residuals[pair[1]].powi(2));
            }
        }
        (products / f64::max(squares, f64::MIN_POSITIVE)).clamp(0.0, 0.99)
    }
}

#[cfg(test)]
mod tests;
