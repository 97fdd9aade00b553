//! Numbers by which models of different size are compared.

use schemars::JsonSchema;
use serde::Serialize;

use crate::qr::{dot, subtract};

use super::reduced::Reduced;
use super::search::Found;

/// The criteria of one model. N points, m terms, p parameters (terms and offsets of blocks), RSS the residual sum.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Criteria {
    /// Terms, the constant included.
    pub terms: usize,
    /// RSS.
    #[serde(skip)]
    pub residual_sum: f64,
    /// RSS / N, unit of the response squared.
    pub mse: f64,
    /// MSE + 2 sigma0^2 m / N, the same unit.
    pub pse: f64,
    /// 1 - RSS / TSS, with TSS about the mean of each fixed block.
    #[serde(rename = "r2")]
    pub r_squared: f64,
    /// The same with both sums over their degrees of freedom.
    #[serde(rename = "adjusted_r2")]
    #[schemars(with = "Option<f64>")]
    pub adjusted_r_squared: f64,
    /// N ln(RSS / N) + p ln N (Schwarz), errors taken as normal.
    pub bic: f64,
    /// Mean square of the residuals of leave-one-out cross-validation (PRESS over N), from the leverages h: r / (1 - h).
    #[schemars(with = "Option<f64>")]
    pub leave_one_out: f64,
}

/// What the criteria of all models of a choice share.
pub(super) struct Shared {
    /// Terms that always stay: the constant, or none.
    pub(super) constant: usize,
    /// Sum of squares that the terms have to explain, unit of the response squared.
    pub(super) total_sum: f64,
    /// Of the predicted squared error, the same unit.
    pub(super) sigma0_squared: f64,
}

impl Shared {
    pub(super) fn criteria(&self, problem: &Reduced, found: Found, y: &[f64]) -> Criteria {
        let members = found.set.count_ones() as usize;
        let (n, terms, parameters) = (y.len() as f64, members + self.constant, members + problem.always);
        let mse = found.sum / n;
        let left = n - parameters as f64;
        let free = n - problem.always as f64;
        Criteria {
            terms,
            residual_sum: found.sum,
            mse,
            pse: mse + 2.0 * self.sigma0_squared * terms as f64 / n,
            r_squared: 1.0 - found.sum / self.total_sum,
            adjusted_r_squared: 1.0 - (found.sum / left) / (self.total_sum / free),
            bic: n * mse.ln() + parameters as f64 * n.ln(),
            leave_one_out: leave_one_out(problem, found, y) / n,
        }
    }
}

/// Sum of squares of the residuals, each over one minus its leverage.
fn leave_one_out(problem: &Reduced, found: Found, y: &[f64]) -> f64 {
    let (fixed, free) = problem.qr.q.split_at(problem.always);
    let mut columns = fixed.to_vec();
    for coordinates in problem.orthogonalised(found.set).0 {
        let mut column = vec![0.0; y.len()];
        for (share, q) in coordinates.iter().zip(free) {
            subtract(&mut column, -share, q);
        }
        columns.push(column);
    }
    let mut rest = y.to_vec();
    for column in &columns {
        let share = dot(column, &rest);
        subtract(&mut rest, share, column);
    }
    let of_point = |(i, rest): (usize, &f64)| {
        let leverage: f64 = columns.iter().map(|column| column[i] * column[i]).sum();
        (rest / (1.0 - leverage)).powi(2)
    };
    rest.iter().enumerate().map(of_point).sum()
}
