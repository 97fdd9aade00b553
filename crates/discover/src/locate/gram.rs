//! Products of a unit's columns, and least squares from their sums.

/// Products of columns with each other and with the residual.
#[derive(Debug, Clone)]
pub(super) struct Gram {
    pub(super) xx: Vec<Vec<f64>>,
    pub(super) xy: Vec<f64>,
    pub(super) yy: f64,
}

/// A column counts as new if this share of it is left without those before.
const NEW: f64 = 1e-7;

impl Gram {
    pub(super) fn new(columns: &[Vec<f64>], y: &[f64]) -> Self {
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let mut xx = vec![vec![0.0; columns.len()]; columns.len()];
        for i in 0..columns.len() {
            for j in 0..=i {
                let product = dot(&columns[i], &columns[j]);
                (xx[i][j], xx[j][i]) = (product, product);
            }
        }
        Self { xx, xy: columns.iter().map(|column| dot(column, y)).collect(), yy: dot(y, y) }
    }

    pub(super) fn add(&mut self, other: &Self) {
        for (row, theirs) in self.xx.iter_mut().zip(&other.xx) {
            row.iter_mut().zip(theirs).for_each(|(a, b)| *a += b);
        }
        self.xy.iter_mut().zip(&other.xy).for_each(|(a, b)| *a += b);
        self.yy += other.yy;
    }

    /// Coefficients of the residual on some columns; zero for the others and for those that depend on others.
    pub(super) fn fit(&self, used: &[usize]) -> Vec<f64> {
        self.solve(used, &self.xy)
    }

    /// Coefficients of a column on some others.
    pub(super) fn regress(&self, column: usize, on: &[usize]) -> Vec<f64> {
        self.solve(on, &self.xx[column])
    }

    /// Sum of squares of the residual that coefficients leave.
    pub(super) fn left(&self, b: &[f64]) -> f64 {
        self.quadratic(self.yy, &self.xy, b)
    }

    /// Sum of squares of a column that coefficients on others leave.
    pub(super) fn column_left(&self, column: usize, b: &[f64]) -> f64 {
        self.quadratic(self.xx[column][column], &self.xx[column], b)
    }

    fn quadratic(&self, own: f64, with: &[f64], b: &[f64]) -> f64 {
        let mut sum = own;
        for (i, bi) in b.iter().enumerate().filter(|(_, bi)| **bi != 0.0) {
            let row: f64 = b.iter().zip(&self.xx[i]).map(|(bj, x)| bj * x).sum();
            sum += bi * (row - 2.0 * with[i]);
        }
        sum.max(0.0)
    }

    /// Those of some columns of which more than a share is left without the ones before them in the list.
    pub(super) fn independent(&self, columns: &[usize], share: f64) -> Vec<usize> {
        let mut kept: Vec<usize> = Vec::new();
        for &column in columns {
            let own = self.xx[column][column];
            let b = self.solve(&kept, &self.xx[column]);
            let explained: f64 = kept.iter().map(|&j| b[j] * self.xx[column][j]).sum();
            if own > 0.0 && own - explained > share * own {
                kept.push(column);
            }
        }
        kept
    }

    /// Normal equations scaled to a unit diagonal, by elimination with dependent columns left out.
    fn solve(&self, used: &[usize], right: &[f64]) -> Vec<f64> {
        let n = used.len();
        let scale: Vec<f64> = used.iter().map(|&i| self.xx[i][i].sqrt()).collect();
        let mut a: Vec<Vec<f64>> = (0..n)
            .map(|i| {
                let entry = |j: usize| match scale[i] * scale[j] {
                    0.0 => 0.0,
                    scale => self.xx[used[i]][used[j]] / scale,
                };
                (0..n).map(entry).collect()
            })
            .collect();
        let mut y: Vec<f64> =
            (0..n).map(|i| if scale[i] > 0.0 { right[used[i]] / scale[i] } else { 0.0 }).collect();
        let mut alive = vec![true; n];
        for k in 0..n {
            if a[k][k] <= NEW {
                alive[k] = false;
                continue;
            }
            for i in k + 1..n {
                let factor = a[i][k] / a[k][k];
                if factor != 0.0 {
                    let (upper, lower) = a.split_at_mut(i);
                    lower[0].iter_mut().zip(&upper[k]).skip(k).for_each(|(x, p)| *x -= factor * p);
                    y[i] -= factor * y[k];
                }
            }
        }
        let mut b = vec![0.0; right.len()];
        let mut x = vec![0.0; n];
        for k in (0..n).rev().filter(|&k| alive[k]) {
            let above: f64 = (k + 1..n).map(|j| a[k][j] * x[j]).sum();
            x[k] = (y[k] - above) / a[k][k];
            b[used[k]] = x[k] / scale[k];
        }
        b
    }
}
