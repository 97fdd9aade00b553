//! What corrections are before any data, by the wing's file: smooth and local parts along the span, about theory.

use super::data::Hung;
use super::off::WingOff;
use super::read::CaseRead;
use aero::Corrections;
use coupling::wing_file::CorrectionPrior;
use coupling::{ByLoad, ElasticWing};
use faer::{Mat, Side};

/// A field of corrections along the span, times a shape that every strip has.
struct Field {
    /// Index of the family: force, moment, pressure offset.
    family: usize,
    /// Strips by unknowns.
    root: Mat<f64>,
    /// By box.
    shape: Vec<f64>,
}

/// The unknowns of a wing, each a standard Gaussian before the data: fields of corrections, what controls do (common, each),
/// flexibility.
pub(crate) struct Unknowns {
    fields: Vec<Field>,
    /// Strip of every box.
    strip: Vec<usize>,
    /// Number of strips.
    strips: usize,
    controls: usize,
    /// Standard deviation of the factor on controls: common, of each, of each in one channel of the balance alone.
    control: [f64; 3],
    /// Standard deviation of the logarithm of the flexibility in bending and in torsion.
    flexibility: [f64; 2],
    /// What any reading is off by, as a share of it.
    pub(super) reading: f64,
}

impl Unknowns {
    pub(crate) fn new(wing: &ElasticWing, prior: &CorrectionPrior) -> Self {
        let boxes = &wing.correctable;
        let strips = boxes.strip.iter().copied().max().map_or(0, |last| last + 1);
        let mut y_norm = vec![0.0; strips];
        boxes.strip.iter().zip(&boxes.y_norm).for_each(|(&strip, &y)| y_norm[strip] = y);
        let local = prior.local_over_chord * boxes.mean_chord_m() / boxes.span_m();
        let along = |b: usize| (boxes.chord_row[b] as f64 + 0.5) / boxes.chord_rows[b] as f64 - 0.5;
        let by_alpha = wing.pressures_by_alpha();
        let field = |family: usize, parts: [f64; 3], shape: &dyn Fn(usize) -> f64| Field {
            family,
            root: root_of(&y_norm, parts, [prior.smooth_over_span, local]),
            shape: (0..boxes.len()).map(shape).collect(),
        };
        let smooth = |size: f64| [0.0, size, 0.0];
        let fields = vec![
            field(0, prior.force, &|_| 1.0),
            field(0, smooth(prior.force_along_chord), &along),
            field(1, smooth(prior.moment), &|_| 1.0),
            field(2, prior.zero_lift_deg.map(f64::to_radians), &|b| by_alpha[boxes.places[b]]),
            field(2, smooth(prior.moment_offset_cp), &|b| -2.0 * along(b)),
        ];
        Self {
            fields,
            strip: boxes.strip.clone(),
            strips,
            controls: wing.controls.len(),
            control: prior.control,
            flexibility: prior.flexibility,
            reading: prior.reading,
        }
    }

    /// Unknowns of corrections, the first; the controls' are behind them.
    pub(super) fn of_corrections(&self) -> usize {
        self.fields.len() * self.strips
    }

    /// The unknown of a control in a channel of the balance; the last two unknowns are the flexibility's.
    fn of_channel(&self, control: usize, channel: usize) -> usize {
        self.of_corrections() + 1 + self.controls + 3 * control + channel
    }

    /// Number of unknowns.
    pub(crate) fn count(&self) -> usize {
        self.of_corrections() + 1 + 4 * self.controls + 2
    }

    /// The wing that unknowns stand for.
    pub(crate) fn wing(&self, z: &[f64]) -> WingOff {
        let boxes = self.strip.len();
        let mut families = [vec![1.0; boxes], vec![1.0; boxes], vec![0.0; boxes]];
        for (field, z) in self.fields.iter().zip(z.chunks(self.strips)) {
            for (b, value) in families[field.family].iter_mut().enumerate() {
                let along: f64 = z.iter().enumerate().map(|(k, z)| field.root[(self.strip[b], k)] * z).sum();
                *value += field.shape[b] * along;
            }
        }
        let [force, moment, pressure_offset] = families;
        let [common, each, _] = self.control;
        let first = self.of_corrections();
        WingOff {
            corrections: Corrections { force, moment, pressure_offset },
            controls: (0..self.controls).map(|c| 1.0 + common * z[first] + each * z[first + 1 + c]).collect(),
            in_channels: (0..self.controls)
                .map(|c| ByLoad::from_fn(|load| self.control[2] * z[self.of_channel(c, load as usize)]))
                .collect(),
            log_flexibility: [0, 1].map(|i| self.flexibility[i] * z[self.count() - 2 + i]),
        }
    }

    /// What is read under a dead weight, and its derivatives by the unknowns.
    pub(super) fn under_weight(&self, hung: &Hung, off: &WingOff) -> (f64, Vec<f64>) {
        let mut gradient = vec![0.0; self.count()];
        let mut value = hung.value;
        for (i, by) in hung.by_flexibility.iter().enumerate() {
            value += by * off.log_flexibility[i];
            gradient[self.count() - 2 + i] = by * self.flexibility[i];
        }
        (value, gradient)
    }

    /// Derivatives of a reading by the unknowns.
    pub(super) fn gradient(&self, read: &CaseRead, row: usize) -> Vec<f64> {
        let readings = &read.readings;
        let by = [&readings.by_force, &readings.by_moment, &readings.by_offset];
        let mut gradient = vec![0.0; self.count()];
        for (field, gradient) in self.fields.iter().zip(gradient.chunks_mut(self.strips)) {
            let mut by_strip = vec![0.0; self.strips];
            for (b, &strip) in self.strip.iter().enumerate() {
                by_strip[strip] += by[field.family][(row, b)] * field.shape[b];
            }
            for (k, value) in gradient.iter_mut().enumerate() {
                *value = by_strip.iter().enumerate().map(|(strip, by)| by * field.root[(strip, k)]).sum();
            }
        }
        let first = self.of_corrections();
        for (c, by_control) in read.by_control.iter().enumerate() {
            gradient[first] += self.control[0] * by_control[row];
            gradient[first + 1 + c] = self.control[1] * by_control[row];
            // where a lattice lets a deflection act is off as well
            if let Some(channel) = read.channels[row] {
                gradient[self.of_channel(c, channel)] = self.control[2] * by_control[row];
            }
        }
        for (i, by_flexibility) in readings.by_flexibility.iter().enumerate() {
            gradient[self.count() - 2 + i] = self.flexibility[i] * by_flexibility[row];
        }
        gradient
    }
}

/// A root of the covariance along the span: a common part, a smooth one (Gaussian correlation), and a local one that may have
/// steps (exponential correlation).
fn root_of(y_norm: &[f64], [common, smooth, local]: [f64; 3], lengths: [f64; 2]) -> Mat<f64> {
    let n = y_norm.len();
    let covariance = Mat::from_fn(n, n, |i, j| {
        let apart = (y_norm[i] - y_norm[j]).abs();
        let smoothly = (-0.5 * (apart / lengths[0]).powi(2)).exp();
        common * common + smooth * smooth * smoothly + local * local * (-apart / lengths[1]).exp()
    });
    let Ok(eigen) = covariance.self_adjoint_eigen(Side::Lower) else { return Mat::zeros(n, n) };
    Mat::from_fn(n, n, |i, k| eigen.U()[(i, k)] * eigen.S()[k].max(0.0).sqrt())
}
