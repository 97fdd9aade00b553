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

/// Places of at most about `limit` of the points of curves that share their abscissae `x`: ends and extremes of all of
/// them stay, so that the curves keep their abscissae in common.
pub(crate) fn kept_together(x: &[f64], ys: &[&[f64]], limit: usize) -> Vec<usize> {
    let finite: Vec<usize> =
        (0..x.len()).filter(|&i| x[i].is_finite() && ys.iter().any(|y| y[i].is_finite())).collect();
    if finite.len() <= limit {
        return finite;
    }
    let run = ((2 + 2 * ys.len()) * finite.len()).div_ceil(limit.max(1));
    let mut kept = Vec::new();
    for places in finite.chunks(run) {
        let mut chosen = vec![places[0], places[places.len() - 1]];
        for y in ys {
            let of_this = || places.iter().copied().filter(|&i| y[i].is_finite());
            chosen.extend(of_this().min_by(|&a, &b| y[a].total_cmp(&y[b])));
            chosen.extend(of_this().max_by(|&a, &b| y[a].total_cmp(&y[b])));
        }
        chosen.sort_unstable();
        chosen.dedup();
        kept.extend(chosen);
    }
    kept
}

/// Six significant digits: more than a screen shows.
pub(crate) fn rounded(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
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
    fn curves_thinned_together_keep_the_extremes_of_each() {
        let x: Vec<f64> = (0..10_000).map(f64::from).collect();
        let [mut a, mut b] = [vec![0.0; 10_000], vec![f64::NAN; 10_000]];
        a[4321] = 1.0;
        b[1234] = 5.0;
        b[1235] = -5.0;
        let kept = kept_together(&x, &[&a, &b], 600);
        assert!(kept.len() <= 610, "{}", kept.len());
        assert!([0, 1234, 1235, 4321, 9999].iter().all(|i| kept.contains(i)));
        assert!(kept.is_sorted());
        assert_eq!(kept_together(&x[..5], &[&a[..5]], 600), [0, 1, 2, 3, 4]);
    }

    #[test]
    fn rounding_keeps_six_digits() {
        assert_eq!(
            [rounded(1.234_567_89e-7), rounded(-0.1), rounded(f64::INFINITY)],
            [1.23457e-7, -0.1, f64::INFINITY]
        );
    }

    #[test]
    fn short_histories_pass_unchanged_without_what_is_not_finite() {
        assert_eq!(thinned(&[0.0, 1.0, 2.0], &[5.0, f64::NAN, 6.0], 10), [(0.0, 5.0), (2.0, 6.0)]);
    }
}
