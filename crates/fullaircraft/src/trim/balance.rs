//! The balance of a trim as a small linear system, and what limits it where it has no solution, in words.
//!
//! Rows (equations) are scaled by their largest entry over all variables, free or not, and columns by their largest entry
//! over all equations, asked for or not. So what is left of an entry after cancellation (an elevator's rolling moment) counts as
//! the zero it is, and thresholds have a meaning.

use faer::Mat;
use nalgebra::{DMatrix, DVector};

/// Scaled entries and singular values below this are zero.
const ZERO: f64 = 1e-9;
/// Parts of a singular direction above this share of its largest are named.
const NAMED: f64 = 0.1;

/// The equations of a trim: `matrix x = 0` in the `rows` asked for.
#[derive(Debug)]
pub(crate) struct Balance<'a> {
    /// All equations by all variables.
    pub(crate) matrix: &'a Mat<f64>,
    /// Equations asked for.
    pub(crate) rows: &'a [usize],
    /// What each equation balances.
    pub(crate) row_names: &'a [&'a str],
    /// What each variable is called.
    pub(crate) names: &'a [String],
}

impl Balance<'_> {
    /// Values of all variables; those given in `x` stay as they are.
    ///
    /// # Errors
    /// A sentence, if there are not as many free variables as equations or they do not determine each other.
    pub(crate) fn solve(&self, x: &[Option<f64>]) -> Result<Vec<f64>, String> {
        let free: Vec<usize> = (0..x.len()).filter(|&j| x[j].is_none()).collect();
        let n = self.rows.len();
        if free.len() != n {
            return Err(format!(
                "{n} equations of balance for {} free variables ({})",
                free.len(),
                self.list(&free)
            ));
        }
        if n == 0 {
            // all is given, and nothing has to balance: a held aircraft
            return Ok(x.iter().map(|value| value.unwrap_or(0.0)).collect());
        }
        if self.matrix.col_iter().any(|column| column.iter().any(|value| !value.is_finite())) {
            return Err("the forces on the aircraft are not finite".to_owned());
        }
        let largest = |values: Vec<f64>| {
            let size = values.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
            if size > 0.0 { size } else { 1.0 }
        };
        let all = 0..self.matrix.nrows();
        let row: Vec<f64> =
            all.clone().map(|i| largest((0..x.len()).map(|j| self.matrix[(i, j)]).collect())).collect();
        let column: Vec<f64> = free
            .iter()
            .map(|&j| largest(all.clone().map(|i| self.matrix[(i, j)] / row[i]).collect()))
            .collect();
        let a = DMatrix::from_fn(n, n, |i, k| {
            self.matrix[(self.rows[i], free[k])] / (row[self.rows[i]] * column[k])
        });
        let b = DVector::from_fn(n, |i, _| {
            let at = self.rows[i];
            -x.iter().enumerate().filter_map(|(j, v)| v.map(|v| self.matrix[(at, j)] * v)).sum::<f64>()
                / row[at]
        });
        self.check(&a, &free)?;
        let solution = a.lu().solve(&b).ok_or_else(|| "the equations of balance are singular".to_owned())?;
        let mut values: Vec<f64> = x.iter().map(|value| value.unwrap_or(0.0)).collect();
        for (k, &j) in free.iter().enumerate() {
            values[j] = solution[k] / column[k];
        }
        Ok(values)
    }

    fn list(&self, places: &[usize]) -> String {
        places.iter().map(|&j| self.names[j].as_str()).collect::<Vec<_>>().join(", ")
    }

    /// Refuses a singular system and says what limits it.
    fn check(&self, a: &DMatrix<f64>, free: &[usize]) -> Result<(), String> {
        let zero = |values: Vec<f64>| values.iter().all(|value| value.abs() <= ZERO);
        let idle: Vec<usize> = (0..free.len())
            .filter(|&k| zero(a.column(k).iter().copied().collect()))
            .map(|k| free[k])
            .collect();
        let still: Vec<&str> = (0..a.nrows())
            .filter(|&i| zero(a.row(i).iter().copied().collect()))
            .map(|i| self.row_names[self.rows[i]])
            .collect();
        let mut why = Vec::new();
        if !still.is_empty() {
            why.push(format!(
                "none of the free variables ({}) acts on the {}",
                self.list(free),
                still.join(", ")
            ));
        }
        if !idle.is_empty() {
            why.push(format!("{} has no effect on what is asked for", self.list(&idle)));
        }
        if why.is_empty() && !free.is_empty() {
            why.extend(self.same(a, free));
        }
        if why.is_empty() { Ok(()) } else { Err(why.join(", and ")) }
    }

    /// A sentence if variables do the same.
    fn same(&self, a: &DMatrix<f64>, free: &[usize]) -> Option<String> {
        let svd = a.clone().svd(false, true);
        let values = &svd.singular_values;
        let (least, smallest) = values.iter().copied().enumerate().min_by(|x, y| x.1.total_cmp(&y.1))?;
        if smallest > ZERO * values.max() {
            return None;
        }
        let direction = svd.v_t?.row(least).transpose();
        let named: Vec<usize> = (0..free.len())
            .filter(|&k| direction[k].abs() > NAMED * direction.amax())
            .map(|k| free[k])
            .collect();
        Some(format!(
            "{} cannot be told apart: moved together in some proportion, nothing asked for changes",
            self.list(&named)
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::Balance;
    use faer::mat;

    fn names() -> Vec<String> {
        ["one", "alpha", "elevator", "rudder"].map(str::to_owned).to_vec()
    }

    const ROWS: [&str; 3] = ["vertical force", "pitching moment", "yawing moment"];

    #[test]
    fn two_equations_are_solved_as_by_hand() {
        // 2 alpha + elevator = 5, alpha - elevator = 1: 2 and 1.
        let matrix = mat![[-5.0, 2.0, 1.0, 0.0], [-1.0, 1.0, -1.0, 1e-17], [0.0, 1e-16, 0.0, 1.0]];
        let (names, rows) = (names(), [0, 1]);
        let balance = Balance { matrix: &matrix, rows: &rows, row_names: &ROWS, names: &names };
        let x = balance.solve(&[Some(1.0), None, None, Some(0.0)]).unwrap();
        assert!((x[1] - 2.0).abs() < 1e-15 && (x[2] - 1.0).abs() < 1e-15, "{x:?}");
    }

    #[test]
    fn what_limits_a_balance_is_named() {
        let matrix = mat![[-5.0, 2.0, 4.0, 0.0], [-1.0, 1.0, 2.0, 1e-17], [0.0, 1e-16, 0.0, 1.0]];
        let (names, all) = (names(), [0, 1, 2]);
        let solve = |rows: usize, x: &[Option<f64>]| {
            let balance = Balance { matrix: &matrix, rows: &all[..rows], row_names: &ROWS, names: &names };
            balance.solve(x).unwrap_err()
        };
        let same = solve(2, &[Some(1.0), None, None, Some(0.0)]);
        assert!(same.contains("alpha, elevator cannot be told apart"), "{same}");
        let idle = solve(2, &[Some(1.0), None, Some(0.0), None]);
        assert!(idle.contains("rudder has no effect"), "{idle}");
        let count = solve(2, &[Some(1.0), None, None, None]);
        assert!(count.contains("2 equations of balance for 3 free variables"), "{count}");
        let matrix = mat![[-5.0, 2.0, 1.0, 0.0], [-1.0, 1.0, -1.0, 0.0], [0.0, 1e-16, 0.0, 1.0]];
        let balance = Balance { matrix: &matrix, rows: &[0, 2], row_names: &ROWS, names: &names };
        let still = balance.solve(&[Some(1.0), None, None, Some(0.0)]).unwrap_err();
        assert!(still.contains("acts on the yawing moment"), "{still}");
    }

    #[test]
    fn where_all_is_given_and_nothing_has_to_balance_values_stay_as_they_are() {
        let names = ["alpha".to_owned(), "elevator".to_owned()];
        let matrix = mat![[-5.0, 2.0], [-1.0, 1.0]];
        let balance = Balance { matrix: &matrix, rows: &[], row_names: &ROWS, names: &names };
        assert_eq!(balance.solve(&[Some(2.0), Some(-1.0)]), Ok(vec![2.0, -1.0]));
    }
}
