//! The choice of poles: those with which the least squares fit leaves the smallest errors in the rows that are looked at.
//!
//! The starts are geometric rows over the table's frequencies; from each, every pole's
//! logarithm is moved up and down by a step that halves when nothing gains (a pattern search: few unknowns, cheap fits,
//! no derivatives of a maximum).

use super::basis::Basis;
use super::rational::Weighting;
use super::table::AirTable;
use faer::{Mat, MatRef};

/// Where rows of poles to start from begin and end, in the table's highest frequency (k = 2).
const STARTS: [(f64, f64); 3] = [(0.012, 0.75), (0.02, 2.0), (0.03, 4.0)];
/// No pole lies outside these shares of the table's highest frequency: a lag far above it is a polynomial in disguise,
/// whose apparent mass and damping are not the air's and make the wing unstable at frequencies that are not in the table.
const SLOWEST: f64 = 0.005;
const FASTEST: f64 = 4.0;
/// Neighbouring poles are at least this factor apart: closer, their lags cancel in large numbers.
const APART: f64 = 1.5;
/// First and last step of the logarithms.
const COARSE: f64 = 0.4;
const FINE: f64 = 0.02;
/// Errors count with this power: the largest rule, the others still pull.
const POWER: i32 = 6;

/// Data of the rows looked at, each entry over its largest modulus: samples (real parts, imaginary parts) by entries.
struct Entries {
    data: Mat<f64>,
}

impl Entries {
    fn new(table: &AirTable, steady: MatRef<'_, f64>, rows: MatRef<'_, f64>) -> Self {
        let n = table.cp.len();
        let largest = super::accuracy::largest(rows, table.cp.iter());
        let at_rest = rows * steady;
        let part = |cp: &Mat<faer::c64>, of: fn(faer::c64) -> f64| {
            rows * Mat::from_fn(cp.nrows(), cp.ncols(), |i, j| of(cp[(i, j)]))
        };
        let parts: Vec<Mat<f64>> = table
            .cp
            .iter()
            .map(|cp| part(cp, |z| z.re) - &at_rest)
            .chain(table.cp.iter().map(|cp| part(cp, |z| z.im)))
            .collect();
        let columns = steady.ncols();
        let data = Mat::from_fn(2 * n, rows.nrows() * columns, |sample, entry| {
            let at = (entry / columns, entry % columns);
            if largest[at] > 0.0 { parts[sample][at] / largest[at] } else { 0.0 }
        });
        Self { data }
    }

    /// Sum over entries of the largest relative error to a power.
    fn misfit(&self, kappa: &[f64], logarithms: &[f64]) -> f64 {
        let poles: Vec<f64> = logarithms.iter().map(|l| l.exp()).collect();
        let basis = Basis::new(kappa, &poles, Weighting::RIG.knee, true);
        let fitted = &basis.functions * (&basis.solver * &self.data);
        let n = kappa.len();
        let error = |entry: usize| {
            let of = |k: usize| {
                let apart = |row: usize| fitted[(row, entry)] - self.data[(row, entry)];
                apart(k).hypot(apart(n + k))
            };
            (0..n).map(of).fold(0.0, f64::max).powi(POWER)
        };
        (0..self.data.ncols()).map(error).sum()
    }
}

/// Within the bounds, and apart from each other.
fn allowed(logarithms: &[f64], highest: f64) -> bool {
    let bounds = (highest * SLOWEST).ln()..=(highest * FASTEST).ln();
    let mut sorted = logarithms.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.iter().all(|l| bounds.contains(l)) && sorted.windows(2).all(|pair| pair[1] - pair[0] >= APART.ln())
}

/// `count` poles in 1/m, ascending.
pub(super) fn choose(
    table: &AirTable,
    steady: MatRef<'_, f64>,
    rows: MatRef<'_, f64>,
    count: usize,
) -> Vec<f64> {
    let kappa = &table.omega_over_v_per_m;
    let highest = kappa.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
    let entries = Entries::new(table, steady, rows);
    let searches =
        STARTS.map(|(first, last)| search(&entries, kappa, highest, start(count, highest, first, last)));
    let (_, logarithms) = searches
        .into_iter()
        .fold((f64::INFINITY, Vec::new()), |best, found| if found.0 < best.0 { found } else { best });
    let mut poles: Vec<f64> = logarithms.iter().map(|l| l.exp()).collect();
    poles.sort_by(f64::total_cmp);
    poles
}

/// Logarithms of a geometric row.
fn start(count: usize, highest: f64, first: f64, last: f64) -> Vec<f64> {
    let steps = count.saturating_sub(1).max(1) as f64;
    (0..count).map(|i| (highest * first * (last / first).powf(i as f64 / steps)).ln()).collect()
}

/// The pattern search: misfit and logarithms.
fn search(entries: &Entries, kappa: &[f64], highest: f64, mut logarithms: Vec<f64>) -> (f64, Vec<f64>) {
    let mut best = entries.misfit(kappa, &logarithms);
    let mut step = COARSE;
    while step >= FINE && !logarithms.is_empty() {
        let before = best;
        for pole in 0..logarithms.len() {
            for by in [step, -step] {
                let mut tried = logarithms.clone();
                tried[pole] += by;
                if !allowed(&tried, highest) {
                    continue;
                }
                let misfit = entries.misfit(kappa, &tried);
                if misfit < best {
                    (best, logarithms) = (misfit, tried);
                    break;
                }
            }
        }
        if best >= before {
            step *= 0.5;
        }
    }
    (best, logarithms)
}

#[cfg(test)]
mod tests;
