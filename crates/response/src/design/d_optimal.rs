//! D-optimal designs: the points of a candidate list, repeats allowed, that make det(X'X) of given terms largest, and so the
//! joint confidence region of the coefficients smallest. Exchange after Fedorov (Theory of Optimal Experiments, 1972): of all
//! exchanges of a point for a candidate the one that multiplies the determinant most, until none does; from several
//! starts, each made point by point, the same ones every time.

use super::Design;
use crate::fault::Fault;
use crate::qr::{Qr, dot};
use crate::term::Term;

/// Starts of the exchange.
const STARTS: usize = 10;
/// Small multiple of the unit matrix that starts a design with fewer points than terms.
const RIDGE: f64 = 1e-6;
/// Exchanges of one start, at most.
const MOST_EXCHANGES: usize = 1000;

/// A D-optimal design.
#[derive(Debug, Clone, PartialEq)]
pub struct DOptimal {
    /// The points.
    pub design: Design,
    /// Which candidate each of them is.
    pub chosen: Vec<usize>,
    /// ln det(X'X).
    pub log_determinant: f64,
    /// det(X'X)^(1/p) / n: 1 for an orthogonal design with all values -1 or 1.
    pub efficiency: f64,
}

/// Chooses `points` of the candidates for the terms.
///
/// # Errors
/// If a term has a factor that is not in the candidates, there are fewer points than terms, or the candidates cannot tell
/// the terms apart.
pub fn d_optimal(candidates: &Design, terms: &[Term], points: usize) -> Result<DOptimal, Fault> {
    if points < terms.len() {
        return Err(Fault::TooFewPoints { points, terms: terms.len(), needs: "" });
    }
    let columns = candidates.columns(terms)?;
    // orthonormal over the candidates: no term is large only because of its unit
    let basis = columns.orthogonalised()?.q;
    let rows: Vec<Vec<f64>> =
        (0..candidates.points.len()).map(|i| basis.iter().map(|q| q[i]).collect()).collect();
    let mut best: Option<(Vec<usize>, f64)> = None;
    for start in 0..STARTS.min(rows.len()) {
        let chosen = exchanged(&rows, grown(&rows, start * rows.len() / STARTS.min(rows.len()), points));
        let subset: Vec<Vec<f64>> =
            columns.values.iter().map(|column| chosen.iter().map(|i| column[*i]).collect()).collect();
        let Ok(qr) = Qr::new(&subset, &columns.names) else { continue };
        let value = qr.log_determinant();
        if best.as_ref().is_none_or(|(_, known)| value > known + 1e-9) {
            best = Some((chosen, value));
        }
    }
    let (mut chosen, log_determinant) = best
        .ok_or_else(|| Fault::Design { why: "no subset of the candidates tells the terms apart".into() })?;
    chosen.sort_unstable();
    let taken = chosen.iter().map(|i| candidates.points[*i].clone()).collect();
    let design = Design::new(&candidates.factors(), taken)?;
    let efficiency = (log_determinant / terms.len() as f64).exp() / points as f64;
    Ok(DOptimal { design, chosen, log_determinant, efficiency })
}

/// A symmetric matrix: the inverse of X'X, kept up to date by single rows.
struct Inverse(Vec<Vec<f64>>);

impl Inverse {
    fn times(&self, x: &[f64]) -> Vec<f64> {
        self.0.iter().map(|row| dot(row, x)).collect()
    }

    /// A row joins (sign 1) or leaves (sign -1), Sherman and Morrison.
    fn update(&mut self, x: &[f64], sign: f64) {
        let white = self.times(x);
        let share = sign / (1.0 + sign * dot(&white, x));
        for (row, a) in self.0.iter_mut().zip(&white) {
            for (value, b) in row.iter_mut().zip(&white) {
                *value -= share * a * b;
            }
        }
    }

    fn of(rows: &[Vec<f64>], chosen: &[usize]) -> Self {
        let size = rows[0].len();
        let unit = |i: usize| (0..size).map(|j| if i == j { 1.0 / RIDGE } else { 0.0 }).collect();
        let mut inverse = Self((0..size).map(unit).collect());
        for i in chosen {
            inverse.update(&rows[*i], 1.0);
        }
        inverse
    }
}

/// Point by point: always the candidate that multiplies the determinant most.
fn grown(rows: &[Vec<f64>], first: usize, points: usize) -> Vec<usize> {
    let mut chosen = vec![first];
    let mut inverse = Inverse::of(rows, &chosen);
    while chosen.len() < points {
        let gain = |i: usize| dot(&inverse.times(&rows[i]), &rows[i]);
        let better = |best: (usize, f64), i: usize| {
            let value = gain(i);
            if value > best.1 * (1.0 + 1e-9) { (i, value) } else { best }
        };
        let (next, _) = (0..rows.len()).fold((first, 0.0), better);
        inverse.update(&rows[next], 1.0);
        chosen.push(next);
    }
    chosen
}

fn exchanged(rows: &[Vec<f64>], mut chosen: Vec<usize>) -> Vec<usize> {
    for _ in 0..MOST_EXCHANGES {
        let inverse = Inverse::of(rows, &chosen);
        let white: Vec<Vec<f64>> = rows.iter().map(|row| inverse.times(row)).collect();
        let variance: Vec<f64> = rows.iter().zip(&white).map(|(row, white)| dot(row, white)).collect();
        let mut best = (0, 0, 1e-9);
        for (position, &out) in chosen.iter().enumerate() {
            for new in 0..rows.len() {
                let common = dot(&rows[new], &white[out]);
                let gain = variance[new] - variance[out] - variance[new] * variance[out] + common * common;
                if gain > best.2 {
                    best = (position, new, gain);
                }
            }
        }
        if best.2 <= 1e-9 {
            break;
        }
        chosen[best.0] = best.1;
    }
    chosen
}
