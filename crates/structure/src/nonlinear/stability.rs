//! The mode that loses its stiffness where an equilibrium becomes unstable.

use super::state::State;
use super::structure::LargeDeflection;
use crate::blocks::Noise;
use crate::factor::Factor;
use faer::Mat;

/// Inverse iterations: near a limit of the load the mode stands out after the first.
const ITERATIONS: usize = 6;

/// The mode of least stiffness in size (g-set, largest entry one), and the free motion that moves most.
pub(super) fn weakest(structure: &LargeDeflection, state: &State, factor: &Factor) -> (Vec<f64>, usize) {
    let n = structure.free_count();
    let mut x = Noise::new().extend(Mat::zeros(n, 0).as_ref(), 1);
    for _ in 0..ITERATIONS {
        x = factor.solve(x.as_ref());
        let size = x.col(0).iter().fold(0.0, |most: f64, v| most.max(v.abs()));
        (0..n).for_each(|i| x[(i, 0)] /= size.max(f64::MIN_POSITIVE));
    }
    let most = (0..n).max_by(|a, b| x[(*a, 0)].abs().total_cmp(&x[(*b, 0)].abs())).unwrap_or(0);
    let rows = structure.map(state).rows;
    (rows.iter().map(|row| row.iter().map(|(at, factor)| factor * x[(*at, 0)]).sum()).collect(), most)
}
