//! Changes by small motions where no closed form is worth its lines.

/// Largest entry (m, rad) of the motions of differences.
const STEP: f64 = 1e-5;

/// The change of something by a motion, by central differences.
pub fn differenced(motion: &[f64], of: impl Fn(&[f64]) -> Vec<f64>) -> Vec<f64> {
    let size = motion.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    let step = if size == 0.0 { 1.0 } else { STEP / size };
    let [up, down] = [step, -step].map(|step| of(&motion.iter().map(|v| v * step).collect::<Vec<f64>>()));
    up.iter().zip(&down).map(|(up, down)| (up - down) / (2.0 * step)).collect()
}
