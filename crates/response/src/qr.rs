//! Least squares by orthogonalised columns, X = Q R: Gram-Schmidt done twice, which leaves Q orthogonal to rounding
//! (Giraud, Langou, Rozloznik, van den Eshof, Numer. Math. 101 (2005), "twice is enough"), with dot products in twice the
//! precision (Ogita, Rump, Oishi, SIAM J. Sci. Comput. 26 (2005), Dot2). Gram-Schmidt and no other factorisation because Q
//! is wanted itself: its columns are Morelli's orthogonal regressors. Columns need no scaling: each is normalised.

use crate::fault::{Fault, list};

/// Share of a column that must remain once the others are taken out; the rounding of data to a few digits leaves more.
const LEAST_REMAINDER: f64 = 1e-9;

/// Columns orthogonalised in their order.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Qr {
    /// Orthonormal columns.
    pub(crate) q: Vec<Vec<f64>>,
    /// Columns of R: `r[j][i]` for i <= j.
    r: Vec<Vec<f64>>,
}

/// Sum of products in twice the precision.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (mut sum, mut error) = (0.0_f64, 0.0_f64);
    for (a, b) in a.iter().zip(b) {
        let product = a * b;
        let next = sum + product;
        let part = next - sum;
        error += (sum - (next - part)) + (product - part) + a.mul_add(*b, -product);
        sum = next;
    }
    sum + error
}

/// `y -= factor * x`.
pub(crate) fn subtract(y: &mut [f64], factor: f64, x: &[f64]) {
    y.iter_mut().zip(x).for_each(|(y, x)| *y = factor.mul_add(-x, *y));
}

/// `x /= by`.
pub(crate) fn divide(x: &mut [f64], by: f64) {
    for value in x {
        *value /= by;
    }
}

impl Qr {
    /// Orthogonalises columns, each against those before it; `names` are for the faults.
    pub(crate) fn new(columns: &[Vec<f64>], names: &[String]) -> Result<Self, Fault> {
        let points = columns.first().map_or(0, Vec::len);
        if points < columns.len() {
            return Err(Fault::TooFewPoints { points, terms: columns.len(), needs: "" });
        }
        let mut qr = Self { q: Vec::new(), r: Vec::new() };
        for (column, name) in columns.iter().zip(names) {
            qr.add(column, name, names)?;
        }
        Ok(qr)
    }

    /// Orthogonalises one column more; `names` are those of the columns before it (or more), for the fault.
    pub(crate) fn add(&mut self, column: &[f64], name: &str, names: &[String]) -> Result<(), Fault> {
        let (mut rest, mut shares) = self.remainder(column);
        let (before, after) = (dot(column, column).sqrt(), dot(&rest, &rest).sqrt());
        if after <= LEAST_REMAINDER * before {
            return Err(self.aliased(name, names, &shares, before));
        }
        divide(&mut rest, after);
        shares.push(after);
        self.q.push(rest);
        self.r.push(shares);
        Ok(())
    }

    /// What is left of a column without what the others explain, and their shares.
    pub(crate) fn remainder(&self, column: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let mut rest = column.to_vec();
        let mut shares = vec![0.0; self.q.len()];
        for _ in 0..2 {
            for (q, share) in self.q.iter().zip(&mut shares) {
                let part = dot(q, &rest);
                *share += part;
                subtract(&mut rest, part, q);
            }
        }
        (rest, shares)
    }

    fn aliased(&self, name: &str, names: &[String], shares: &[f64], norm: f64) -> Fault {
        let weights = self.back_substitute(shares);
        let shown = |j: &usize| (weights[*j] * dot(&self.r[*j], &self.r[*j]).sqrt()).abs() > 1e-6 * norm;
        let others = list((0..weights.len()).filter(shown).map(|j| names[j].as_str()));
        Fault::Aliased { term: name.to_string(), others }
    }

    /// R x = b.
    fn back_substitute(&self, b: &[f64]) -> Vec<f64> {
        let mut x = b.to_vec();
        for j in (0..x.len()).rev() {
            x[j] /= self.r[j][j];
            let value = x[j];
            subtract(&mut x[..j], value, &self.r[j][..j]);
        }
        x
    }

    /// R^-T b, of which the square is b' (X'X)^-1 b.
    fn whiten(&self, b: &[f64]) -> Vec<f64> {
        let mut x: Vec<f64> = Vec::with_capacity(b.len());
        for (r, b) in self.r.iter().zip(b) {
            let known = dot(&r[..x.len()], &x);
            x.push((b - known) / r[x.len()]);
        }
        x
    }

    /// The least squares solution for y, refined twice by the solution for what it leaves.
    pub(crate) fn solve(&self, columns: &[Vec<f64>], y: &[f64]) -> Vec<f64> {
        let mut x = self.back_substitute(&self.remainder(y).1);
        for _ in 0..2 {
            let step = self.back_substitute(&self.remainder(&residuals(columns, &x, y)).1);
            x.iter_mut().zip(step).for_each(|(x, step)| *x += step);
        }
        x
    }

    /// R^-T e of the unit vector e of a column: products of two of them are covariances over the variance of errors.
    pub(crate) fn whitened_unit(&self, column: usize) -> Vec<f64> {
        self.whiten(&(0..self.q.len()).map(|j| f64::from(u8::from(j == column))).collect::<Vec<_>>())
    }

    /// The diagonal of (X'X)^-1 at a column: the variance of its coefficient over that of errors.
    pub(crate) fn leverage_of(&self, column: usize) -> f64 {
        let white = self.whitened_unit(column);
        dot(&white, &white)
    }

    /// x' (X'X)^-1 x.
    pub(crate) fn leverage(&self, x: &[f64]) -> f64 {
        let white = self.whiten(x);
        dot(&white, &white)
    }

    /// Diagonal of the hat matrix: the leverage of each point of the data.
    pub(crate) fn leverages(&self) -> Vec<f64> {
        let points = self.q.first().map_or(0, Vec::len);
        (0..points).map(|i| self.q.iter().map(|q| q[i] * q[i]).sum()).collect()
    }

    /// ln det(X'X).
    pub(crate) fn log_determinant(&self) -> f64 {
        self.r.iter().filter_map(|column| column.last()).map(|diagonal| 2.0 * diagonal.ln()).sum()
    }
}

/// y - X x, each in twice the precision.
pub(crate) fn residuals(columns: &[Vec<f64>], x: &[f64], y: &[f64]) -> Vec<f64> {
    let of_point = |(i, y): (usize, &f64)| {
        let row: Vec<f64> = columns.iter().map(|column| column[i]).chain([*y]).collect();
        let weights: Vec<f64> = x.iter().map(|x| -x).chain([1.0]).collect();
        dot(&row, &weights)
    };
    y.iter().enumerate().map(of_point).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn aliased_columns_are_named() {
        let a = vec![1.0, 2.0, 3.0, 5.0];
        let b = vec![1.0, 1.0, 0.0, 2.0];
        let c = vec![1.0, 1.0, 1.0, 1.0];
        let d: Vec<f64> = a.iter().zip(&c).map(|(a, c)| a - 3.0 * c).collect();
        let names = ["a", "b", "c", "d"].map(String::from);
        let fault = Qr::new(&[a, b, c, d], &names).expect_err("d = a - 3 c");
        assert_eq!(fault, Fault::Aliased { term: "d".into(), others: "`a`, `c`".into() });
    }

    #[test]
    fn the_dot_product_has_twice_the_precision() {
        assert_eq!(dot(&[1e16, 1.0, -1e16], &[1.0, 1.0, 1.0]), 1.0);
    }
}
