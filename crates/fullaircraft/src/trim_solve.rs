//! The balance as a small linear system, solved with the variable that cannot be determined named.

use faer::Mat;
use nastran::InputError;

/// A pivot smaller than this share of its column has no meaning.
const SINGULAR: f64 = 1e-9;

/// Values of all variables with `balance x = 0`, those given in `x` fixed.
///
/// # Errors
/// If there are not as many free variables as rows, or one cannot be determined.
pub(crate) fn solve(balance: &Mat<f64>, x: &[Option<f64>], names: &[String]) -> Result<Vec<f64>, InputError> {
    let free: Vec<usize> = (0..x.len()).filter(|&j| x[j].is_none()).collect();
    let n = balance.nrows();
    let list = free.iter().map(|&j| names[j].as_str()).collect::<Vec<_>>().join(", ");
    if free.len() != n {
        let message = format!("{n} equations of balance for {} free variables ({list})", free.len());
        return Err(
            InputError::general(message).with_help("leave as many variables free as motions are supported")
        );
    }
    let mut a: Vec<Vec<f64>> = (0..n)
        .map(|i| {
            let fixed: f64 = x.iter().enumerate().filter_map(|(j, v)| v.map(|v| balance[(i, j)] * v)).sum();
            free.iter().map(|&j| balance[(i, j)]).chain([-fixed]).collect()
        })
        .collect();
    // rows scaled to one, so that forces and moments weigh the same
    for row in &mut a {
        let size = row[..n].iter().fold(0.0_f64, |size, value| size.max(value.abs()));
        if size > 0.0 {
            for value in row.iter_mut() {
                *value /= size;
            }
        }
    }
    for k in 0..n {
        let size = |row: &Vec<f64>| row[k].abs();
        let pivot = (k..n).max_by(|i, j| size(&a[*i]).total_cmp(&size(&a[*j]))).unwrap_or(k);
        let column = a.iter().map(size).fold(0.0, f64::max);
        if size(&a[pivot]).is_nan() || size(&a[pivot]) <= SINGULAR * column {
            let message = format!("{} cannot be determined beside {list}", names[free[k]]);
            return Err(InputError::general(message)
                .with_help("it does nothing, or the same as the others; give its value"));
        }
        a.swap(k, pivot);
        let row = a[k].clone();
        for (i, other) in a.iter_mut().enumerate() {
            if i != k {
                let factor = other[k] / row[k];
                other.iter_mut().zip(&row).for_each(|(value, pivot)| *value -= factor * pivot);
            }
        }
    }
    let mut values: Vec<f64> = x.iter().map(|value| value.unwrap_or(0.0)).collect();
    for (k, &j) in free.iter().enumerate() {
        values[j] = a[k][n] / a[k][k];
    }
    Ok(values)
}
