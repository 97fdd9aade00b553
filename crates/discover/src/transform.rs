//! Records as cosine coefficients: few numbers that hold all below a frequency, whether a record is periodic or not.
//!
//! The orthonormal DCT-II of N samples; coefficient k belongs to the frequency k/(2 N dt). White noise of standard
//! deviation sigma gives coefficients of standard deviation sigma.

/// Coefficients up to a frequency, Hz.
pub fn cosines(values: &[f64], time_step_s: f64, highest_hz: f64) -> Vec<f64> {
    first_cosines(&[values], count(values.len(), time_step_s, highest_hz)).remove(0)
}

/// The first `count` coefficients of records of one length, two of which are transformed in one; none of empty records. What is zero
/// throughout stays so exactly, whatever the others are: rounding would make a column of it that goes with anything.
pub fn first_cosines(records: &[&[f64]], count: usize) -> Vec<Vec<f64>> {
    let n = records.first().map_or(0, |record| record.len());
    if n == 0 || count == 0 {
        return vec![Vec::new(); records.len()];
    }
    let (mean, others) = ((1.0 / n as f64).sqrt(), (2.0 / n as f64).sqrt());
    let nothing = vec![0.0; n];
    let is_something = |place: &usize| records[*place].iter().any(|value| *value != 0.0);
    let places: Vec<usize> = (0..records.len()).filter(is_something).collect();
    let mut all = vec![vec![0.0; count]; records.len()];
    for pair in places.chunks(2) {
        let second = pair.get(1).map_or(nothing.as_slice(), |place| records[*place]);
        for (place, mut cosines) in pair.iter().zip(fourier::cosines([records[pair[0]], second], count)) {
            cosines
                .iter_mut()
                .enumerate()
                .for_each(|(k, value)| *value *= if k == 0 { mean } else { others });
            all[*place] = cosines;
        }
    }
    all
}

/// Number of coefficients of a record up to a frequency, Hz.
pub fn count(samples: usize, time_step_s: f64, highest_hz: f64) -> usize {
    let last = 2.0 * samples as f64 * time_step_s * highest_hz;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a number of samples")]
    let last = last.floor() as usize;
    (last + 1).min(samples)
}

/// Frequency of a coefficient, Hz.
pub fn frequency_hz(k: usize, samples: usize, time_step_s: f64) -> f64 {
    k as f64 / (2.0 * samples as f64 * time_step_s)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cosines_keep_the_energy_of_a_slow_record() {
        let values: Vec<f64> =
            (0..300).map(|i| (std::f64::consts::TAU * 3.0 * f64::from(i) * 0.01).sin() + 0.5).collect();
        let energy: f64 = values.iter().map(|v| v * v).sum();
        let kept: f64 = cosines(&values, 0.01, 12.0).iter().map(|c| c * c).sum();
        assert!((kept / energy - 1.0).abs() < 2e-3, "{}", kept / energy);
        assert_eq!(cosines(&values, 0.01, 12.0).len(), 73);
    }

    #[test]
    fn what_is_zero_stays_zero_beside_others() {
        let moving: Vec<f64> = (0..301).map(|i| (0.3 * f64::from(i)).sin()).collect();
        let still = vec![0.0; 301];
        let all = first_cosines(&[&moving, &still, &moving], 73);
        assert!(all[1].iter().all(|value| *value == 0.0), "{:?}", all[1]);
        assert!(all[0].iter().zip(&all[2]).all(|(a, b)| (a - b).abs() < 1e-12) && all[0][5].abs() > 1e-3);
    }

    #[test]
    fn a_cosine_of_the_basis_is_one_coefficient() {
        let n = 200;
        let values: Vec<f64> = (0..n)
            .map(|i| (std::f64::consts::PI * 7.0 * (f64::from(i) + 0.5) / f64::from(n)).cos())
            .collect();
        let all = cosines(&values, 0.01, 12.0);
        assert!((all[7] - 10.0).abs() < 1e-10, "sqrt(N/2): {}", all[7]);
        assert!(all.iter().enumerate().all(|(k, c)| k == 7 || c.abs() < 1e-10));
    }
}
