//! Pure error by airspeed and band of frequencies: gusts, buffet and noise that have no mean gap.

use super::map::band;
use super::residuals::Residuals;
use response::FTest;

/// Pure error of a channel at an airspeed in a band.
#[derive(Debug, Clone, PartialEq)]
pub struct VarianceCell {
    /// Channel.
    pub channel: &'static str,
    /// Airspeed, m/s.
    pub v_m_s: f64,
    /// Place in [`crate::rules::LocateRules`].
    pub band: usize,
    /// Variance of a coefficient over that of the pure error that was assumed.
    pub ratio: f64,
    /// Number of coefficients.
    pub rows: usize,
}

/// See the module.
#[derive(Debug, Clone, PartialEq)]
pub struct Variances {
    /// By channel, airspeed and band.
    pub cells: Vec<VarianceCell>,
    /// Levene's test (about medians, as Brown and Forsythe have it) that the airspeeds of a channel and band have one
    /// ratio; only where two airspeeds or more have repeats.
    pub tests: Vec<(&'static str, usize, FTest)>,
}

/// Compares runs with those that they repeat, the simulations taken off.
pub fn variances(residuals: &Residuals) -> Variances {
    let mut found = Variances { cells: Vec::new(), tests: Vec::new() };
    for (c, channel) in crate::channels::LOADS.into_iter().enumerate() {
        for b in 0..residuals.rules.locate.bands_hz.len() {
            let groups = groups(residuals, c, b);
            for (v_m_s, values) in &groups {
                let ratio = values.iter().map(|value| value * value).sum::<f64>() / values.len() as f64;
                found.cells.push(VarianceCell { channel, v_m_s: *v_m_s, band: b, ratio, rows: values.len() });
            }
            let values: Vec<Vec<f64>> = groups.into_iter().map(|(_, values)| values).collect();
            found.tests.extend(levene(&values).map(|test| (channel, b, test)));
        }
    }
    found
}

/// Differences of repeats over the square root of two, by airspeed.
fn groups(residuals: &Residuals, c: usize, b: usize) -> Vec<(f64, Vec<f64>)> {
    let mut groups: Vec<(f64, Vec<f64>)> = Vec::new();
    for second in &residuals.units {
        let first = residuals.units.iter().find(|unit| second.repeat_of == Some(unit.place));
        let Some(first) = first.filter(|first| first.rows[c].len() == second.rows[c].len()) else { continue };
        let values = (1..second.rows[c].len())
            .filter(|&k| band(&residuals.rules.locate.bands_hz, second.frequency_hz[k]) == b)
            .map(|k| (second.rows[c][k] - first.rows[c][k]) * std::f64::consts::FRAC_1_SQRT_2);
        let at = groups.iter().position(|(v_m_s, _)| *v_m_s == second.v_m_s).unwrap_or_else(|| {
            groups.push((second.v_m_s, Vec::new()));
            groups.len() - 1
        });
        groups[at].1.extend(values);
    }
    groups.retain(|(_, values)| !values.is_empty());
    groups
}

/// Brown and Forsythe's form of Levene's test of equal variances: an analysis of variance of distances from medians.
pub fn levene(groups: &[Vec<f64>]) -> Option<FTest> {
    let distances: Vec<Vec<f64>> = groups
        .iter()
        .filter_map(|values| {
            let middle = crate::statistics::median(values.clone())?;
            Some(values.iter().map(|value| (value - middle).abs()).collect())
        })
        .collect();
    let rows: usize = distances.iter().map(Vec::len).sum();
    if distances.len() < 2 || rows <= distances.len() {
        return None;
    }
    let all: Vec<f64> = distances.iter().flatten().copied().collect();
    let mean = crate::statistics::mean;
    let grand = mean(&all);
    let between = distances.iter().map(|d| d.len() as f64 * (mean(d) - grand).powi(2)).sum();
    let within: f64 = distances.iter().flat_map(|d| d.iter().map(|x| (x - mean(d)).powi(2))).sum();
    (within > 0.0)
        .then(|| FTest::new(between, (distances.len() - 1) as f64, within, (rows - distances.len()) as f64))
}

#[cfg(test)]
mod tests {
    use super::levene;

    #[test]
    fn levene_is_the_analysis_of_variance_of_distances_from_medians() {
        // by hand: medians 2 and 5, distances 1 0 1 and 4 0 4; their means 2/3 and 8/3, grand mean 5/3;
        // between 3 (1 + 1) = 6; within 2/3 + 32/3 = 34/3
        let test = levene(&[vec![1.0, 2.0, 3.0], vec![1.0, 5.0, 9.0]]).expect("two groups");
        assert_eq!((test.above, test.below), (1.0, 4.0));
        assert!((test.f - 6.0 / (34.0 / 12.0)).abs() < 1e-12, "{}", test.f);
        assert!(levene(&[vec![1.0, 2.0]]).is_none());
    }
}
