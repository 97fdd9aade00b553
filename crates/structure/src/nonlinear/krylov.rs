//! Linear equations with a small unsymmetric part: (K + L) x = b by GMRES, preconditioned with the factor of K.
//!
//! K^-1 L has few eigenvalues that are not small (loads that follow the structure are few), so some steps are enough (Saad and
//! Schultz, SIAM J. Sci. Stat. Comput. 7, 1986).

/// Steps at most.
const STEPS: usize = 30;

/// -(K + L)^-1 r: `solve` is -K^-1, `product` is L v, `residual` that of the preconditioned equations, relative.
pub(super) fn solve(
    r: &[f64],
    solve: &impl Fn(&[f64]) -> Vec<f64>,
    product: impl Fn(&[f64]) -> Vec<f64>,
    residual: f64,
) -> Vec<f64> {
    let b = solve(r);
    let size = norm(&b);
    if size == 0.0 || !size.is_finite() {
        return b;
    }
    let mut basis = vec![b.iter().map(|v| v / size).collect::<Vec<f64>>()];
    // Columns of the Hessenberg matrix turned to triangular form, the rotations, and the right side.
    let (mut columns, mut turns): (Vec<Vec<f64>>, Vec<[f64; 2]>) = (Vec::new(), Vec::new());
    let mut right = vec![size];
    for step in 0..STEPS {
        let own = &basis[step];
        // (1 + K^-1 L) v
        let mut next: Vec<f64> = own.iter().zip(solve(&product(own))).map(|(v, minus)| v - minus).collect();
        let mut column = Vec::with_capacity(step + 2);
        for other in &basis {
            let share: f64 = other.iter().zip(&next).map(|(a, b)| a * b).sum();
            next.iter_mut().zip(other).for_each(|(next, other)| *next -= share * other);
            column.push(share);
        }
        let rest = norm(&next);
        for (i, [cosine, sine]) in turns.iter().enumerate() {
            let (a, b) = (column[i], column[i + 1]);
            (column[i], column[i + 1]) = (cosine * a + sine * b, cosine * b - sine * a);
        }
        let length = column[step].hypot(rest).max(f64::MIN_POSITIVE);
        let turn = [column[step] / length, rest / length];
        column[step] = length;
        turns.push(turn);
        columns.push(column);
        let last = right[step];
        right[step] = turn[0] * last;
        right.push(-turn[1] * last);
        if right[step + 1].abs() <= residual * size || rest <= 1e-14 * length {
            break;
        }
        basis.push(next.iter().map(|v| v / rest).collect());
    }
    let count = columns.len();
    let mut factors = vec![0.0; count];
    for i in (0..count).rev() {
        let known: f64 = (i + 1..count).map(|j| columns[j][i] * factors[j]).sum();
        factors[i] = (right[i] - known) / columns[i][i];
    }
    let mut x = vec![0.0; r.len()];
    for (factor, vector) in factors.iter().zip(&basis) {
        x.iter_mut().zip(vector).for_each(|(x, v)| *x += factor * v);
    }
    x
}

fn norm(v: &[f64]) -> f64 {
    v.iter().map(|v| v * v).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    #[test]
    fn an_unsymmetric_part_is_solved_exactly() {
        // K = diag(2, 3, 4, 5), L unsymmetric.
        let k = [2.0, 3.0, 4.0, 5.0];
        let l = [[0.1, 1.0, 0.0, 0.3], [-0.5, 0.0, 0.7, 0.0], [0.0, 0.2, 0.4, -1.0], [0.6, 0.0, 0.0, 0.2]];
        let product = |v: &[f64]| -> Vec<f64> {
            l.iter().map(|row| row.iter().zip(v).map(|(l, v)| l * v).sum()).collect()
        };
        let r = [1.0, -2.0, 3.0, 0.5];
        let x = super::solve(&r, &|b: &[f64]| b.iter().zip(k).map(|(b, k)| -b / k).collect(), product, 1e-8);
        for (at, (applied, r)) in product(&x).iter().zip(r).enumerate() {
            let short = k[at] * x[at] + applied + r;
            assert!(short.abs() < 1e-7, "equation {at}: {short:e}");
        }
    }
}
