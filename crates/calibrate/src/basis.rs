//! The unknowns: a polynomial in span for each chordwise strip and each kind of correction (paper 1, Eq. 9).
//!
//! The paper writes monomials of `y_norm`; the same polynomials are kept here in Legendre form on 0..1, whose
//! coefficients are of like size, which the cone solver needs.

use aero::Corrections;
use coupling::{CorrectableBoxes, RootSensitivity};
use faer::Mat;

/// The three independent families of corrections, in the order of the unknowns.
pub const FAMILIES: [&str; 3] = ["force", "moment", "pressure_offset"];

/// Coefficients to corrections and back: `families x strips x (order + 1)` unknowns.
#[derive(Debug, Clone)]
pub struct Basis {
    /// Chordwise strips.
    pub strips: usize,
    /// Polynomials a strip (order + 1).
    pub terms: usize,
    /// Chordwise strip of each box.
    pub strip_of: Vec<usize>,
    /// Boxes by polynomials: P_k(2 y_norm - 1).
    pub polynomials: Mat<f64>,
}

impl Basis {
    /// The basis for a wing's boxes.
    pub fn new(boxes: &CorrectableBoxes, strips: usize, order: usize) -> Self {
        let strip_of =
            boxes.chord_row.iter().zip(&boxes.chord_rows).map(|(row, rows)| row * strips / rows).collect();
        let polynomials =
            Mat::from_fn(boxes.len(), order + 1, |b, k| legendre(k, 2.0 * boxes.y_norm[b] - 1.0));
        Self { strips, terms: order + 1, strip_of, polynomials }
    }

    /// Number of unknowns: 180 for twelve strips and quartics.
    pub fn size(&self) -> usize {
        FAMILIES.len() * self.strips * self.terms
    }

    /// First unknown of a family's strip.
    pub fn column(&self, family: usize, strip: usize) -> usize {
        (family * self.strips + strip) * self.terms
    }

    /// The start: factors one, offsets zero.
    pub fn neutral(&self) -> Vec<f64> {
        let mut x = vec![0.0; self.size()];
        for family in 0..2 {
            for strip in 0..self.strips {
                x[self.column(family, strip)] = 1.0;
            }
        }
        x
    }

    /// Evaluates the polynomials at every box.
    pub fn corrections(&self, x: &[f64]) -> Corrections {
        let family = |family: usize| (0..self.strip_of.len()).map(|b| self.value(x, family, b)).collect();
        Corrections { force: family(0), moment: family(1), pressure_offset: family(2) }
    }

    /// One family's correction at one box.
    pub fn value(&self, x: &[f64], family: usize, b: usize) -> f64 {
        let from = self.column(family, self.strip_of[b]);
        (0..self.terms).map(|k| x[from + k] * self.polynomials[(b, k)]).sum()
    }

    /// Chain rule: 4 (Fz, Mx, My, tip height) by unknowns from derivatives by the corrections of each box.
    pub fn gradient(&self, sensitivity: &RootSensitivity) -> Mat<f64> {
        let mut gradient = Mat::zeros(4, self.size());
        let families = [&sensitivity.by_force, &sensitivity.by_moment, &sensitivity.by_offset];
        for (family, by_box) in families.into_iter().enumerate() {
            for b in 0..self.strip_of.len() {
                let from = self.column(family, self.strip_of[b]);
                for k in 0..self.terms {
                    for channel in 0..4 {
                        gradient[(channel, from + k)] += by_box[(channel, b)] * self.polynomials[(b, k)];
                    }
                }
            }
        }
        gradient
    }

    /// The metric of change, one block a strip and family: the sum over boxes of the area share times P P',
    /// times `family_weight` (c² for the factors, 1 for the offset). Block diagonal, as a dense matrix.
    pub fn change_metric(&self, area_share: &[f64], family_weight: [f64; 3]) -> Mat<f64> {
        let mut metric = Mat::zeros(self.size(), self.size());
        for (family, weight) in family_weight.into_iter().enumerate() {
            for (b, share) in area_share.iter().enumerate() {
                let from = self.column(family, self.strip_of[b]);
                for i in 0..self.terms {
                    for j in 0..self.terms {
                        metric[(from + i, from + j)] +=
                            weight * share * self.polynomials[(b, i)] * self.polynomials[(b, j)];
                    }
                }
            }
        }
        metric
    }
}

/// Legendre polynomial P_k at t in -1..1 (Bonnet's recursion).
fn legendre(k: usize, t: f64) -> f64 {
    let (mut before, mut now) = (1.0, t);
    if k == 0 {
        return before;
    }
    for n in 1..k {
        let next = ((2 * n + 1) as f64 * t * now - n as f64 * before) / (n + 1) as f64;
        before = now;
        now = next;
    }
    now
}
