//! Ticks of the axes and colour bars of our own pictures.

/// Least and largest of values; infinities of the wrong sign if there is none.
pub fn extent(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)))
}

/// Round numbers that cover a range: about `count` ticks at steps of 1, 2 or 5 times a power of ten, inside it.
pub(crate) fn ticks(low: f64, high: f64, count: usize) -> Vec<f64> {
    let span = high - low;
    if !(span > 0.0 && span.is_finite()) {
        return vec![low];
    }
    let rough = span / count.max(1) as f64;
    let power = 10.0_f64.powf(rough.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].into_iter().map(|m| m * power).find(|s| *s >= rough).unwrap_or(rough);
    let first = (low / step - 1e-9).ceil();
    let mut values = Vec::new();
    let mut i = first;
    while i * step <= high + 1e-9 * span {
        values.push(i * step);
        i += 1.0;
    }
    values
}

/// Tick labels with just the decimals their step needs.
pub(crate) fn tick_labels(values: &[f64]) -> Vec<String> {
    let step = values.windows(2).map(|w| w[1] - w[0]).fold(f64::INFINITY, f64::min);
    let largest = values.iter().fold(0.0_f64, |a, v| a.max(v.abs()));
    if largest >= 1e5 || (largest > 0.0 && largest < 1e-3) {
        return values.iter().map(|v| format!("{v:.1e}")).collect();
    }
    let step = if step.is_finite() { step } else { largest.max(1.0) / 100.0 };
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 0..9")]
    let decimals = (-(step * 1.0001).log10().floor()).clamp(0.0, 9.0) as usize;
    values.iter().map(|v| format!("{:.decimals$}", if *v == 0.0 { 0.0 } else { *v })).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_inside() {
        assert_eq!(tick_labels(&ticks(0.83, 1.21, 4)), ["0.9", "1.0", "1.1", "1.2"]);
        assert_eq!(tick_labels(&ticks(-3.0, 3.0, 3)), ["-2", "0", "2"]);
        assert_eq!(tick_labels(&ticks(0.0, 0.004, 4)), ["0.000", "0.001", "0.002", "0.003", "0.004"]);
        assert_eq!(ticks(2.0, 2.0, 4), [2.0]);
    }
}
