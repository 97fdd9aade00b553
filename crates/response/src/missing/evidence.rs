//! Evidence for a candidate: what it takes off the residual sum of the model, S, as the log Bayes factor against the model without it,
//! S / 2 s^2 - d/2 ln N, with s^2 the pure error, d the candidate's degrees of freedom and N the points (Schwarz, Annals of
//! Statistics 6 (1978), with a known error). Candidates are compared by differences of it: 5 are odds of 150 to 1.

use crate::columns::Columns;
use crate::data::Data;
use crate::fault::Fault;
use crate::qr::{Qr, dot};
use crate::regression::Regression;
use crate::term::Term;

/// Share of a candidate's column that the model's terms must leave.
const LEAST_REST: f64 = 1e-7;

/// What may be missing.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Candidate {
    /// A term.
    Term(Term),
    /// Offsets of the blocks of a column.
    Blocks(String),
}

impl Candidate {
    pub(super) fn name(&self) -> String {
        match self {
            Self::Term(term) => term.to_string(),
            Self::Blocks(name) => name.clone(),
        }
    }

    pub(super) fn columns(&self, data: &Data) -> Result<Vec<Vec<f64>>, Fault> {
        match self {
            Self::Term(term) => Ok(vec![data.column(term)?]),
            Self::Blocks(name) => {
                let blocks = data.blocks().iter().filter(|blocks| blocks.name == *name);
                let blocks: Vec<_> = blocks.cloned().collect();
                Ok(Columns::default().with_blocks(&blocks).values)
            }
        }
    }
}

/// What columns say beyond the model: an orthonormal basis of what the model's terms leave of them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Beyond {
    /// Empty if the model's terms explain the columns.
    pub(super) basis: Vec<Vec<f64>>,
    /// Length of what is left of the first column.
    pub(super) length: f64,
}

impl Beyond {
    pub(super) fn of(fitted: &Regression, columns: &[Vec<f64>]) -> Result<Self, Fault> {
        let (mut kept, mut length) = (Qr::new(&[], &[])?, 0.0);
        let mut names: Vec<String> = Vec::new();
        for (index, column) in columns.iter().enumerate() {
            let rest = fitted.remainder(column);
            let after = dot(&rest, &rest).sqrt();
            if after <= LEAST_REST * dot(column, column).sqrt() {
                continue;
            }
            if index == 0 {
                length = after;
            }
            match kept.add(&rest, "", &names) {
                Ok(()) => names.push(String::new()),
                Err(Fault::Aliased { .. }) => {}
                Err(other) => return Err(other),
            }
        }
        Ok(Self { basis: kept.q, length })
    }

    /// What the columns take off the residual sum.
    pub(super) fn explained(&self, rest: &[f64]) -> f64 {
        self.basis.iter().map(|q| dot(q, rest).powi(2)).sum()
    }

    /// Log Bayes factor against the model without them.
    pub(super) fn log_bayes_factor(&self, rest: &[f64], variance: f64) -> f64 {
        let freedom = self.basis.len() as f64;
        0.5 * self.explained(rest) / variance - 0.5 * freedom * (rest.len() as f64).ln()
    }

    /// Correlation of two single columns once the model's terms are out; the largest canonical one of several.
    pub(super) fn correlation(&self, other: &Self) -> f64 {
        let largest = |q: &Vec<f64>| other.explained(q).sqrt();
        self.basis.iter().map(largest).fold(0.0, f64::max).min(1.0)
    }
}
