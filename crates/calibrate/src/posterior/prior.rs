//! What corrections are before any data, by the wing's file: smooth and local parts along the span, about theory.

use coupling::wing_file::CorrectionPrior;
use coupling::{ElasticWing, Readings};
use faer::{Mat, Side};

/// Corrections per unit of independent standard Gaussians.
pub(super) struct Modes {
    /// Boxes by unknowns, by family: force, moment, pressure offset.
    families: [Mat<f64>; 3],
    /// Standard deviation of the logarithm of the flexibility, the last unknown.
    flexibility: f64,
}

impl Modes {
    pub(super) fn new(wing: &ElasticWing, prior: &CorrectionPrior) -> Self {
        let boxes = &wing.correctable;
        let strips = boxes.strip.iter().copied().max().map_or(0, |last| last + 1);
        let mut y_norm = vec![0.0; strips];
        boxes.strip.iter().zip(&boxes.y_norm).for_each(|(&strip, &y)| y_norm[strip] = y);
        let local = prior.local_over_chord * boxes.mean_chord_m() / boxes.span_m();
        let field = |parts: [f64; 3]| root_of(&y_norm, parts, [prior.smooth_over_span, local]);
        let along = |b: usize| (boxes.chord_row[b] as f64 + 0.5) / boxes.chord_rows[b] as f64 - 0.5;
        let by_alpha = wing.pressures_by_alpha();
        let shapes: [(usize, Mat<f64>, Vec<f64>); 5] = [
            (0, field(prior.force), vec![1.0; boxes.len()]),
            (0, field([0.0, prior.force_along_chord, 0.0]), (0..boxes.len()).map(along).collect()),
            (1, field([0.0, prior.moment, 0.0]), vec![1.0; boxes.len()]),
            (
                2,
                field(prior.zero_lift_deg.map(f64::to_radians)),
                boxes.places.iter().map(|&place| by_alpha[place]).collect(),
            ),
            (
                2,
                field([0.0, prior.moment_offset_cp, 0.0]),
                (0..boxes.len()).map(|b| -2.0 * along(b)).collect(),
            ),
        ];
        // the last unknown is the flexibility, which is no correction
        let size = shapes.len() * strips + 1;
        let mut families = [0; 3].map(|_| Mat::zeros(boxes.len(), size));
        for (i, (family, root, shape)) in shapes.iter().enumerate() {
            for (b, &strip) in boxes.strip.iter().enumerate() {
                for k in 0..strips {
                    families[*family][(b, i * strips + k)] = shape[b] * root[(strip, k)];
                }
            }
        }
        Self { families, flexibility: prior.flexibility }
    }

    /// Derivatives of a reading by the unknowns.
    pub(super) fn gradient(&self, read: &Readings, row: usize) -> Vec<f64> {
        let mut gradient = vec![0.0; self.families[0].ncols()];
        for (modes, by) in self.families.iter().zip([&read.by_force, &read.by_moment, &read.by_offset]) {
            for (k, value) in gradient.iter_mut().enumerate() {
                *value += (0..modes.nrows()).map(|b| by[(row, b)] * modes[(b, k)]).sum::<f64>();
            }
        }
        if let Some(last) = gradient.last_mut() {
            *last += read.by_flexibility[row] * self.flexibility;
        }
        gradient
    }
}

/// A root of the covariance along the span: common part, and Gaussian correlations over two lengths.
fn root_of(y_norm: &[f64], [common, smooth, local]: [f64; 3], lengths: [f64; 2]) -> Mat<f64> {
    let n = y_norm.len();
    let covariance = Mat::from_fn(n, n, |i, j| {
        let alike = |length: f64| (-0.5 * ((y_norm[i] - y_norm[j]) / length).powi(2)).exp();
        common * common + smooth * smooth * alike(lengths[0]) + local * local * alike(lengths[1])
    });
    let Ok(eigen) = covariance.self_adjoint_eigen(Side::Lower) else { return Mat::zeros(n, n) };
    Mat::from_fn(n, n, |i, k| eigen.U()[(i, k)] * eigen.S()[k].max(0.0).sqrt())
}
