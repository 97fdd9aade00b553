//! Cubic splines through matrices: exact at the knots, two derivatives continuous (de Boor, *A Practical Guide to Splines*,
//! ch. IV).
//!
//! The ends are "not a knot": the first two pieces are one cubic, and so are the last two. No slope is assumed at rest,
//! because the forces of a wing without ends have none there (their imaginary part goes as k ln k).

use super::FlutterError;
use faer::linalg::solvers::Solve;
use faer::{Mat, MatRef, Scale, c64};

/// A spline through complex matrices of one size.
#[derive(Debug, Clone)]
pub struct MatrixSpline {
    knots: Vec<f64>,
    values: Vec<Mat<c64>>,
    /// Second derivatives at the knots.
    bends: Vec<Mat<c64>>,
}

impl MatrixSpline {
    /// Through `values` at rising `knots`. Two knots give a line, three a parabola.
    ///
    /// # Errors
    /// If there is no knot, the knots do not rise, or sizes differ.
    pub fn new(knots: Vec<f64>, values: Vec<Mat<c64>>) -> Result<Self, FlutterError> {
        let Some(first) = values.first() else { return Err(FlutterError::Empty("a table of matrices")) };
        if let Some(pair) =
            knots.windows(2).find(|pair| pair[0].partial_cmp(&pair[1]) != Some(std::cmp::Ordering::Less))
        {
            return Err(FlutterError::NotRising { first: pair[0], second: pair[1] });
        }
        let odd = values.iter().find(|v| (v.nrows(), v.ncols()) != (first.nrows(), first.ncols()));
        if let Some(value) = odd {
            let (rows, columns, expected) = (value.nrows(), value.ncols(), first.nrows());
            return Err(FlutterError::Size { what: "a matrix of the table", rows, columns, expected });
        }
        if knots.len() != values.len() {
            let (rows, columns, expected) = (values.len(), 1, knots.len());
            return Err(FlutterError::Size { what: "the list of matrices", rows, columns, expected });
        }
        let weights = bend_weights(&knots);
        let bends = (0..knots.len()).map(|i| sum(&values, |j| weights[(i, j)])).collect();
        Ok(Self { knots, values, bends })
    }

    /// First and last knot.
    pub fn range(&self) -> (f64, f64) {
        (self.knots[0], self.knots[self.knots.len() - 1])
    }

    /// The first matrix, for its size.
    pub fn first(&self) -> MatRef<'_, c64> {
        self.values[0].as_ref()
    }

    /// The value at `x`; `None` outside of the knots.
    pub fn at(&self, x: f64) -> Option<Mat<c64>> {
        let (low, high) = self.range();
        if !(low..=high).contains(&x) {
            return None;
        }
        let above = self.knots.partition_point(|knot| *knot < x);
        if self.knots[above] == x {
            return Some(self.values[above].clone());
        }
        let i = above - 1;
        let h = self.knots[above] - self.knots[i];
        let (a, b) = ((self.knots[above] - x) / h, (x - self.knots[i]) / h);
        let bend = |s: f64| (s * s * s - s) * h * h / 6.0;
        let terms = [
            (&self.values[i], a),
            (&self.values[above], b),
            (&self.bends[i], bend(a)),
            (&self.bends[above], bend(b)),
        ];
        let mut total = Mat::zeros(self.values[i].nrows(), self.values[i].ncols());
        for (matrix, factor) in terms {
            total += matrix * Scale(c64::from(factor));
        }
        Some(total)
    }
}

fn sum(values: &[Mat<c64>], weight: impl Fn(usize) -> f64) -> Mat<c64> {
    let mut total = Mat::zeros(values[0].nrows(), values[0].ncols());
    for (j, value) in values.iter().enumerate() {
        total += value * Scale(c64::from(weight(j)));
    }
    total
}

/// Second derivatives at the knots per unit value at each knot.
fn bend_weights(knots: &[f64]) -> Mat<f64> {
    let n = knots.len();
    if n < 3 {
        return Mat::zeros(n, n);
    }
    let step = |i: usize| knots[i + 1] - knots[i];
    let (mut left, mut right) = (Mat::<f64>::zeros(n, n), Mat::<f64>::zeros(n, n));
    for i in 1..n - 1 {
        let (before, after) = (step(i - 1), step(i));
        left[(i, i - 1)] = before / 6.0;
        left[(i, i)] = (before + after) / 3.0;
        left[(i, i + 1)] = after / 6.0;
        right[(i, i - 1)] = 1.0 / before;
        right[(i, i)] = -1.0 / before - 1.0 / after;
        right[(i, i + 1)] = 1.0 / after;
    }
    if n == 3 {
        // one parabola: the same second derivative throughout
        for end in [0, 2] {
            left[(end, end)] = 1.0;
            left[(end, 1)] = -1.0;
        }
    } else {
        // the third derivative does not jump at the second knot and at the last but one
        for (end, a) in [(0, 0), (n - 1, n - 3)] {
            left[(end, a)] = 1.0 / step(a);
            left[(end, a + 1)] = -1.0 / step(a) - 1.0 / step(a + 1);
            left[(end, a + 2)] = 1.0 / step(a + 1);
        }
    }
    left.partial_piv_lu().solve(&right)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scalar(value: c64) -> Mat<c64> {
        Mat::from_fn(1, 1, |_, _| value)
    }

    fn through(knots: &[f64], f: impl Fn(f64) -> c64) -> MatrixSpline {
        MatrixSpline::new(knots.to_vec(), knots.iter().map(|x| scalar(f(*x))).collect()).unwrap()
    }

    #[test]
    fn a_cubic_comes_back_exactly_and_knots_to_the_last_bit() {
        let knots = [0.0, 0.1, 0.3, 0.35, 1.0, 2.0];
        let f = |x: f64| c64::new(1.0 - 2.0 * x + 0.5 * x.powi(3), x * x - 0.3 * x);
        let spline = through(&knots, f);
        for x in [0.02, 0.2, 0.34, 0.7, 1.9] {
            assert!((spline.at(x).unwrap()[(0, 0)] - f(x)).norm() < 1e-14, "{x}");
        }
        for x in knots {
            assert_eq!(spline.at(x).unwrap()[(0, 0)], f(x));
        }
    }

    #[test]
    fn few_knots_give_lines_and_parabolas() {
        let line = through(&[1.0, 3.0], |x| c64::new(2.0 * x, -x));
        assert!((line.at(2.5).unwrap()[(0, 0)] - c64::new(5.0, -2.5)).norm() < 1e-14);
        let parabola = through(&[1.0, 2.0, 4.0], |x| c64::new(x * x, 1.0 - x * x));
        assert!((parabola.at(3.0).unwrap()[(0, 0)] - c64::new(9.0, -8.0)).norm() < 1e-13);
        let one = through(&[1.0], |x| c64::new(x, 0.0));
        assert_eq!(one.at(1.0).unwrap()[(0, 0)], c64::new(1.0, 0.0));
    }

    #[test]
    fn nothing_is_given_outside_of_the_knots() {
        let spline = through(&[1.0, 2.0, 4.0, 5.0], |x| c64::new(x, 0.0));
        for x in [0.999, 5.001, f64::NAN] {
            assert!(spline.at(x).is_none(), "{x}");
        }
    }

    #[test]
    fn tables_that_do_not_rise_or_fit_are_refused() {
        let values = |n: usize| vec![scalar(c64::new(1.0, 0.0)); n];
        assert!(MatrixSpline::new(vec![], vec![]).is_err());
        assert!(MatrixSpline::new(vec![1.0, 1.0], values(2)).is_err());
        assert!(MatrixSpline::new(vec![1.0, f64::NAN], values(2)).is_err());
        assert!(MatrixSpline::new(vec![1.0, 2.0], values(3)).is_err());
        assert!(
            MatrixSpline::new(vec![1.0, 2.0], vec![scalar(c64::new(1.0, 0.0)), Mat::zeros(2, 2)]).is_err()
        );
    }
}
