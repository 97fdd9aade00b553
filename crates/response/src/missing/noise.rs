//! The error of a reading, from replicates or as stated, and errors drawn from it for pseudo-campaigns in which nothing is
//! missing.

use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

use crate::data::{Blocking, Data};
use crate::fault::Fault;
use crate::pure_error::{Scatter, scatter};
use crate::qr::dot;
use crate::regression::Regression;

/// Scatter of one reading.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Noise {
    pub(super) variance: f64,
    /// Degrees of freedom; very many for a stated noise.
    pub(super) freedom: f64,
    /// Sum of squares and degrees of freedom of replicates, which no term can explain.
    pure: (f64, f64),
    /// Standard deviation at each point as its own replicates show it, right on average.
    of_point: Vec<f64>,
}

/// A model fitted to the training points, and their noise.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Base {
    pub(super) fitted: Regression,
    pub(super) noise: Noise,
}

impl Noise {
    pub(super) fn of(data: &Data, response: &str, stated: Option<f64>) -> Result<Self, Fault> {
        let points = data.points();
        if let Some(sigma) = stated {
            let of_point = vec![sigma; points];
            return Ok(Self { variance: sigma * sigma, freedom: 1e6, pure: (0.0, 0.0), of_point });
        }
        let Scatter { rest, freedom } = scatter(data, response, Blocking::Fixed)?;
        let sum = dot(&rest, &rest);
        let scale = (points as f64 / freedom).sqrt();
        let of_point = rest.iter().map(|rest| scale * rest.abs()).collect();
        Ok(Self { variance: sum / freedom, freedom, pure: (sum, freedom), of_point })
    }

    /// Errors of one size at all points.
    pub(super) fn draw(&self, random: &mut ChaCha8Rng) -> Vec<f64> {
        let sigma = self.variance.sqrt();
        self.of_point.iter().map(|_| sigma * normal(random)).collect()
    }

    /// Errors as large at each point as its replicates scatter: forces, not coefficients, scatter alike at all airspeeds.
    pub(super) fn draw_own(&self, random: &mut ChaCha8Rng) -> Vec<f64> {
        self.of_point.iter().map(|sigma| sigma * normal(random)).collect()
    }

    /// Sum of squares of replicates.
    pub(super) fn pure_sum(&self) -> f64 {
        self.pure.0
    }

    /// Mean square of what a surface leaves beyond replicates, in units of pure error.
    pub(super) fn misfit(&self, rest: &[f64], freedom: f64) -> f64 {
        let (sum, own) = self.pure;
        let beyond = freedom - own;
        if beyond > 0.0 { (dot(rest, rest) - sum).max(0.0) / beyond / self.variance } else { 0.0 }
    }
}

fn normal(random: &mut ChaCha8Rng) -> f64 {
    StandardNormal.sample(random)
}
