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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::{RHO, Toy, near};
    use aero::Flow;
    use coupling::{SteadyCase, SteadyModel};

    /// Coefficients without a pattern.
    fn coefficients(basis: &Basis) -> Vec<f64> {
        (0..basis.size()).map(|k| 0.3 + 0.7 * ((k * k + 3 * k) % 11) as f64 / 11.0).collect()
    }

    #[test]
    fn polynomials_are_those_that_legendre_printed() {
        for t in [-1.0, -0.6, 0.0, 0.3, 0.8, 1.0_f64] {
            let printed = [
                1.0,
                t,
                0.5 * (3.0 * t * t - 1.0),
                0.5 * (5.0 * t.powi(3) - 3.0 * t),
                (35.0 * t.powi(4) - 30.0 * t * t + 3.0) / 8.0,
                (63.0 * t.powi(5) - 70.0 * t.powi(3) + 15.0 * t) / 8.0,
            ];
            for (k, value) in printed.into_iter().enumerate() {
                assert!((legendre(k, t) - value).abs() < 1e-14, "P_{k}({t}): {} {value}", legendre(k, t));
            }
        }
    }

    #[test]
    fn corrections_of_a_box_are_the_polynomial_of_its_strip_and_family() {
        let toy = Toy::new(5, 6);
        let basis = Basis::new(&toy.boxes, 3, 2);
        assert_eq!(basis.strip_of[..6], [0, 0, 1, 1, 2, 2]);
        assert_eq!((basis.size(), basis.terms), (27, 3));
        let places: Vec<usize> =
            (0..3).flat_map(|f| (0..3).map(move |s| (f, s))).map(|(f, s)| 9 * f + 3 * s).collect();
        let columns = (0..3).flat_map(|f| (0..3).map(move |s| (f, s))).map(|(f, s)| basis.column(f, s));
        assert_eq!(columns.collect::<Vec<_>>(), places);
        assert_eq!(basis.corrections(&basis.neutral()), Corrections::neutral(30));
        let x = coefficients(&basis);
        let found = basis.corrections(&x);
        for b in 0..30 {
            let (t, strip) = (2.0 * toy.boxes.y_norm[b] - 1.0, (b % 6) / 2);
            for (family, values) in
                [&found.force, &found.moment, &found.pressure_offset].into_iter().enumerate()
            {
                let c = &x[9 * family + 3 * strip..];
                near(values[b], c[0] + c[1] * t + c[2] * (1.5 * t * t - 0.5), 1e-14);
            }
        }
    }

    #[test]
    fn gradients_are_differences_of_readings_and_the_metric_is_the_mean_square_over_the_area() {
        let mut toy = Toy::new(4, 3);
        toy.boxes.area_share = (1..=12).map(|b| f64::from(b) / 78.0).collect();
        let basis = Basis::new(&toy.boxes, 3, 1);
        let case = SteadyCase::new(Flow { v_m_s: 10.0, rho_kg_m3: RHO }, 0.1);
        let x = coefficients(&basis);
        let at = |x: &[f64]| {
            toy.sensitivities(std::slice::from_ref(&case), &basis.corrections(x))
                .expect("it is linear")
                .swap_remove(0)
        };
        let gradient = basis.gradient(&at(&x));
        assert_eq!((gradient.nrows(), gradient.ncols()), (4, basis.size()));
        for k in 0..basis.size() {
            let mut moved = x.clone();
            moved[k] += 1.0;
            for c in 0..4 {
                let difference = at(&moved).readings()[c] - at(&x).readings()[c];
                assert!((gradient[(c, k)] - difference).abs() < 1e-10, "{c} {k}: {difference}");
            }
        }
        let weights = [2.0, 3.0, 0.5];
        let metric = basis.change_metric(&toy.boxes.area_share, weights);
        let size = basis.size();
        let square: f64 =
            (0..size).map(|i| (0..size).map(|j| x[i] * metric[(i, j)] * x[j]).sum::<f64>()).sum();
        let Corrections { force, moment, pressure_offset } = basis.corrections(&x);
        let mean = |values: &[f64]| {
            values.iter().zip(&toy.boxes.area_share).map(|(v, share)| share * v * v).sum::<f64>()
        };
        near(square, 2.0 * mean(&force) + 3.0 * mean(&moment) + 0.5 * mean(&pressure_offset), 1e-12);
        near(metric[(1, 0)], metric[(0, 1)], 1e-14);
    }
}
