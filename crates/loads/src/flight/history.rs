//! Extremes of a load over time.

/// Rows of the `n` largest peaks and the `n` smallest valleys, in rising order. A reading turns where it comes back by `back`.
pub(super) fn extremes(values: &[f64], back: f64, n: usize) -> Vec<usize> {
    let (mut peaks, mut valleys) = (Vec::new(), Vec::new());
    let (mut high, mut low) = (0, 0);
    let mut rises: Option<bool> = None;
    for (row, &value) in values.iter().enumerate() {
        if value > values[high] {
            high = row;
        }
        if value < values[low] {
            low = row;
        }
        if rises != Some(false) && values[high] - value > back {
            peaks.push(high);
            (rises, low) = (Some(false), row);
        } else if rises != Some(true) && value - values[low] > back {
            valleys.push(low);
            (rises, high) = (Some(true), row);
        }
    }
    // The way to the end of the record is an extreme, too.
    match rises {
        Some(false) => valleys.push(low),
        Some(true) | None => peaks.push(high),
    }
    peaks.sort_by(|a, b| values[*b].total_cmp(&values[*a]));
    valleys.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    let mut rows: Vec<usize> = peaks.into_iter().take(n).chain(valleys.into_iter().take(n)).collect();
    rows.sort_unstable();
    rows.dedup();
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn peaks_and_valleys_are_found_through_noise_smaller_than_the_way_back() {
        let wave = |row: usize| (row as f64 * 0.1).sin() * (1.0 + 0.01 * row as f64);
        let noisy = |row: usize| wave(row) + if row.is_multiple_of(2) { 0.02 } else { -0.02 };
        let values: Vec<f64> = (0..190).map(noisy).collect();
        let rows = extremes(&values, 0.2, 2);
        // sin is largest at 0.1 row = pi/2 + 2 pi k: rows 15.7, 78.5, 141.4; smallest at 47.1, 110.0, 172.8.
        let near = |row: usize, expected: f64| (row as f64 - expected).abs() < 5.0;
        assert_eq!(rows.len(), 4, "{rows:?}");
        for (row, expected) in rows.iter().zip([78.5, 110.0, 141.4, 172.8]) {
            assert!(near(*row, expected), "{rows:?}");
        }
        assert_eq!(extremes(&[3.0, 3.0], 1.0, 2), [0]);
    }
}
