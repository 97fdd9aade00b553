//! Thinning of long time histories: a picture is a thousand points wide, so more points only make the file larger.
//!
//! Of each run of consecutive points the first, lowest, highest and last are kept, in their order, so no peak is lost.

/// At most about `limit` of the points, and every extreme among them. Points that are not finite are dropped.
pub(crate) fn thinned(x: &[f64], y: &[f64], limit: usize) -> Vec<(f64, f64)> {
    let points: Vec<(f64, f64)> =
        x.iter().copied().zip(y.iter().copied()).filter(|(x, y)| x.is_finite() && y.is_finite()).collect();
    if points.len() <= limit {
        return points;
    }
    let run = (4 * points.len()).div_ceil(limit);
    points.chunks(run).flat_map(extremes).collect()
}

/// First, lowest, highest and last of a run, in the run's order and each once.
fn extremes(run: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut lowest = 0;
    let mut highest = 0;
    for (i, point) in run.iter().enumerate() {
        if point.1 < run[lowest].1 {
            lowest = i;
        }
        if point.1 > run[highest].1 {
            highest = i;
        }
    }
    let mut kept = vec![0, lowest, highest, run.len() - 1];
    kept.sort_unstable();
    kept.dedup();
    kept.into_iter().map(|i| run[i]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_single_spike_among_many_points_is_kept() {
        let x: Vec<f64> = (0..100_000).map(f64::from).collect();
        let mut y = vec![0.0; x.len()];
        y[54_321] = 9.0;
        y[77_777] = -4.0;
        let points = thinned(&x, &y, 1000);
        assert!(points.len() <= 1000);
        assert!(points.contains(&(54_321.0, 9.0)));
        assert!(points.contains(&(77_777.0, -4.0)));
        assert_eq!(points.first(), Some(&(0.0, 0.0)));
        assert_eq!(points.last(), Some(&(99_999.0, 0.0)));
    }

    #[test]
    fn short_histories_pass_unchanged_without_what_is_not_finite() {
        assert_eq!(thinned(&[0.0, 1.0, 2.0], &[5.0, f64::NAN, 6.0], 10), [(0.0, 5.0), (2.0, 6.0)]);
    }
}
