//! The choice of terms in few numbers: candidates and response once the terms that always stay (the constant, offsets of
//! blocks) are taken out, in the coordinates of the orthogonalised candidates. With n candidates every sum of squares of a
//! subset is then a computation with vectors of n numbers, however many points there are.

use crate::columns::Columns;
use crate::fault::Fault;
use crate::qr::{Qr, divide, dot, subtract};
use crate::term::Term;

/// Sets of candidates are bits of a number.
pub(crate) type Set = u64;

/// Candidates and response in n coordinates.
pub(crate) struct Reduced {
    /// Of each candidate, unit length.
    pub(crate) candidates: Vec<Vec<f64>>,
    /// Of the response.
    target: Vec<f64>,
    /// Residual sum of squares with all candidates.
    pub(crate) rest: f64,
    /// Of each candidate, those that must be in wherever it is.
    below: Vec<Set>,
    /// Of each candidate, those that need it.
    above: Vec<Set>,
    /// Orthonormal columns of what always stays, then of the candidates.
    pub(super) qr: Qr,
    /// Columns that always stay.
    pub(super) always: usize,
}

/// A subset fitted: its residual sum, and what it would grow by without each of its members.
pub(crate) struct Drops {
    /// Residual sum of squares.
    pub(crate) sum: f64,
    /// Member and growth of the residual sum without it.
    pub(crate) growth: Vec<(usize, f64)>,
}

impl Reduced {
    /// Takes out what always stays. `hierarchical`: a term needs those below it ([`Term::is_above`]).
    pub(crate) fn new(
        always: &Columns,
        candidates: &Columns,
        terms: &[Term],
        y: &[f64],
        hierarchical: bool,
    ) -> Result<Self, Fault> {
        let qr = always.clone().before(candidates).orthogonalised()?;
        let (rest, shares) = qr.remainder(y);
        let coordinates = |column: &Vec<f64>| {
            let mut own = qr.remainder(column).1.split_off(always.len());
            let norm = dot(&own, &own).sqrt();
            divide(&mut own, norm);
            own
        };
        let set = |of: &dyn Fn(&Term) -> bool| -> Set {
            terms.iter().enumerate().filter(|(_, term)| hierarchical && of(term)).map(|(k, _)| 1 << k).sum()
        };
        Ok(Self {
            candidates: candidates.values.iter().map(coordinates).collect(),
            target: shares[always.len()..].to_vec(),
            rest: dot(&rest, &rest),
            below: terms.iter().map(|term| set(&|other| term.is_above(other))).collect(),
            above: terms.iter().map(|term| set(&|other| other.is_above(term))).collect(),
            always: always.len(),
            qr,
        })
    }

    /// Number of candidates.
    pub(crate) fn count(&self) -> usize {
        self.candidates.len()
    }

    /// All candidates.
    pub(crate) fn all(&self) -> Set {
        (0..self.count()).map(|k| 1 << k).sum()
    }

    /// Those that must be in wherever a candidate is.
    pub(crate) fn needs(&self, candidate: usize) -> Set {
        self.below[candidate]
    }

    /// True if a candidate may join a set.
    pub(crate) fn may_join(&self, candidate: usize, set: Set) -> bool {
        set >> candidate & 1 == 0 && self.below[candidate] & !set == 0
    }

    /// True if a candidate may leave a set.
    pub(crate) fn may_leave(&self, candidate: usize, set: Set) -> bool {
        set >> candidate & 1 == 1 && self.above[candidate] & set == 0
    }

    /// What orthonormal vectors leave of a candidate, and their shares in it.
    fn beyond(&self, candidate: usize, q: &[Vec<f64>]) -> (Vec<f64>, Vec<f64>) {
        let (mut rest, mut shares) = (self.candidates[candidate].clone(), vec![0.0; q.len()]);
        for _ in 0..2 {
            for (q, share) in q.iter().zip(&mut shares) {
                let part = plain_dot(q, &rest);
                *share += part;
                subtract(&mut rest, part, q);
            }
        }
        (rest, shares)
    }

    /// Orthonormal vectors of the members of a set, and R by columns.
    pub(crate) fn orthogonalised(&self, set: Set) -> (Vec<Vec<f64>>, Vec<Vec<f64>>) {
        let (mut q, mut r): (Vec<Vec<f64>>, Vec<Vec<f64>>) = (Vec::new(), Vec::new());
        for member in members(set) {
            let (mut rest, mut shares) = self.beyond(member, &q);
            let norm = plain_dot(&rest, &rest).sqrt();
            divide(&mut rest, norm);
            shares.push(norm);
            q.push(rest);
            r.push(shares);
        }
        (q, r)
    }

    /// Residual sum of squares of a set, and what every member that may leave is worth in it.
    pub(crate) fn drops(&self, set: Set) -> Drops {
        let (q, r) = self.orthogonalised(set);
        let mut rest = self.target.clone();
        let mut shares = Vec::with_capacity(q.len());
        for q in &q {
            let part = plain_dot(q, &rest);
            shares.push(part);
            subtract(&mut rest, part, q);
        }
        let mut growth = Vec::new();
        for (position, member) in members(set).enumerate() {
            if self.may_leave(member, set) {
                // column of R^-T: (R^-T e)' z is the coefficient, its square norm that of the inverse's diagonal
                let white = unit_whitened(&r, position);
                let value = plain_dot(&white, &shares);
                growth.push((member, value * value / plain_dot(&white, &white)));
            }
        }
        Drops { sum: self.rest + plain_dot(&rest, &rest), growth }
    }

    /// Of each candidate that may join a set, what it takes off the residual sum: the square of the response's share of
    /// the candidate's part that is orthogonal to the set (Morelli).
    pub(crate) fn gains(&self, set: Set) -> Vec<(usize, f64)> {
        let (q, _) = self.orthogonalised(set);
        let mut gains = Vec::new();
        for candidate in (0..self.count()).filter(|k| self.may_join(*k, set)) {
            let (part, _) = self.beyond(candidate, &q);
            let share = plain_dot(&part, &self.target);
            gains.push((candidate, share * share / plain_dot(&part, &part)));
        }
        gains
    }
}

/// The members of a set in order.
pub(crate) fn members(set: Set) -> impl Iterator<Item = usize> {
    (0..Set::BITS as usize).filter(move |k| set >> k & 1 == 1)
}

/// R^-T e of the unit vector of a position.
fn unit_whitened(r: &[Vec<f64>], position: usize) -> Vec<f64> {
    let mut x = vec![0.0; r.len()];
    for (k, column) in r.iter().enumerate().skip(position) {
        let known = plain_dot(&column[position..k], &x[position..k]);
        x[k] = (f64::from(u8::from(k == position)) - known) / column[k];
    }
    x
}

fn plain_dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
