//! A place for what takes long to compute and depends on few inputs, so that many processes need not compute it each.

use faer::Mat;

/// Keeps matrices by name, with what they were computed of.
pub trait Keep {
    /// What is kept under a name and was computed of the same inputs, to the last bit as it was put there. `inputs` is a text
    /// that is another whenever the matrices would be.
    fn get(&self, name: &str, inputs: &str) -> Option<Vec<Mat<f64>>>;

    /// Keeps matrices. A place that cannot does not say so here: it costs time, no result.
    fn put(&self, name: &str, inputs: &str, matrices: &[Mat<f64>]);
}

/// Nothing is kept.
impl Keep for () {
    fn get(&self, _: &str, _: &str) -> Option<Vec<Mat<f64>>> {
        None
    }

    fn put(&self, _: &str, _: &str, _: &[Mat<f64>]) {}
}
