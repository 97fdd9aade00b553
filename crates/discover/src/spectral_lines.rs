//! Spectral lines that do not repeat: a narrow peak in what runs and their repeats differ by. Vortices that the wing sheds, a
//! tunnel's fan or the mains have a phase of their own in every record, so that no mean gap shows them and a
//! noise taken from repeats swallows them.
//!
//! Per airspeed and channel, squares of the cosine coefficients of half the differences are pooled in narrow bins; a bin
//! that stands above the median of its neighbours by more than chance allows is a line (Fisher 1929 asks the same of one
//! record).

use crate::channels::LOADS;
use crate::data::Dataset;
use crate::noise::pairs;
use crate::rules::SpectralLineRules;
use crate::transform::{first_cosines, frequency_hz};
use maneuver::effects::Flown;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use statrs::distribution::{ChiSquared, ContinuousCDF};
use std::borrow::Cow;

/// See the module.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SpectralLine {
    /// Channel.
    pub channel: Cow<'static, str>,
    /// Airspeed, m/s.
    pub v_m_s: f64,
    /// Middle of the bin, Hz.
    pub frequency_hz: f64,
    /// Mean square over the median of its neighbours.
    #[serde(rename = "times_its_neighbourhood")]
    pub times: f64,
}

/// Lines of the training runs, the strongest first; `simulated` are all runs as the model flies them.
pub fn spectral_lines(data: &Dataset, simulated: &[Flown]) -> Vec<SpectralLine> {
    let rules = &data.rules.spectral_lines;
    let pairs = pairs(data);
    let mut found: Vec<SpectralLine> = Vec::new();
    for (airspeed, v_m_s) in data.airspeeds_m_s.iter().enumerate() {
        for (c, channel) in LOADS.into_iter().enumerate() {
            let mut bins: Vec<(f64, usize)> = Vec::new();
            for &(a, b) in pairs.iter().filter(|pair| data.runs[pair.0].airspeed == airspeed) {
                let residual = |i: usize| {
                    data.runs[i].measured[c].iter().zip(&simulated[i].loads[c]).map(|(m, s)| m - s)
                };
                let half: Vec<f64> = residual(a)
                    .zip(residual(b))
                    .map(|(a, b)| (a - b) * std::f64::consts::FRAC_1_SQRT_2)
                    .collect();
                pool(rules, &mut bins, &half, data.runs[a].stimulus.time_step_s);
            }
            found.extend(peaks(rules, &bins).into_iter().map(|(bin, times)| SpectralLine {
                channel: channel.into(),
                v_m_s: *v_m_s,
                frequency_hz: (bin as f64 + 0.5) * rules.bin_hz,
                times,
            }));
        }
    }
    // a load on the wing is in several channels, a fault of the noise's estimate in one
    let in_another = |line: &SpectralLine| {
        let same = |other: &&SpectralLine| {
            other.channel != line.channel
                && other.v_m_s == line.v_m_s
                && (other.frequency_hz - line.frequency_hz).abs() < 2.0 * rules.bin_hz
        };
        found.iter().any(|other| same(&other))
    };
    let mut found: Vec<SpectralLine> = found.iter().filter(|line| in_another(line)).cloned().collect();
    found.sort_by(|a, b| b.times.total_cmp(&a.times));
    found
}

/// Adds the squares of a record's coefficients to their bins.
fn pool(rules: &SpectralLineRules, bins: &mut Vec<(f64, usize)>, record: &[f64], time_step_s: f64) {
    for (k, value) in first_cosines(&[record], record.len()).remove(0).into_iter().enumerate() {
        let f_hz = frequency_hz(k, record.len(), time_step_s);
        if (rules.slowest_hz..rules.fastest * 0.5 / time_step_s).contains(&f_hz) {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "not negative")]
            let bin = (f_hz / rules.bin_hz) as usize;
            if bins.len() <= bin {
                bins.resize(bin + 1, (0.0, 0));
            }
            bins[bin] = (bins[bin].0 + value * value, bins[bin].1 + 1);
        }
    }
}

/// Bins that stand out: the highest of each group of neighbours, with how far.
fn peaks(rules: &SpectralLineRules, bins: &[(f64, usize)]) -> Vec<(usize, f64)> {
    let mean = |i: usize| (bins[i].1 > 0).then(|| bins[i].0 / bins[i].1 as f64);
    let stands_out = |i: usize| {
        let own = mean(i)?;
        let around = i.saturating_sub(rules.neighbours)..(i + rules.neighbours + 1).min(bins.len());
        let mut others: Vec<f64> = around.filter(|j| j.abs_diff(i) > 1).filter_map(mean).collect();
        if others.len() < rules.neighbours {
            return None;
        }
        others.sort_by(f64::total_cmp);
        let times = own / others[others.len() / 2].max(f64::MIN_POSITIVE);
        let freedom = bins[i].1 as f64;
        let chance = ChiSquared::new(freedom).ok()?.sf(times * freedom);
        (times > rules.times_neighbours && chance < rules.chance).then_some((i, times))
    };
    let mut found: Vec<(usize, f64)> = (0..bins.len()).filter_map(stands_out).collect();
    let all = found.clone();
    found.retain(|(i, times)| all.iter().all(|(j, other)| j.abs_diff(*i) > 2 || other <= times));
    found
}

/// What the lines say together, in one sentence; none without a line.
pub fn sentence(rules: &SpectralLineRules, spectral_lines: &[SpectralLine]) -> Option<String> {
    let first = spectral_lines.first()?;
    let SpectralLine { channel, v_m_s, frequency_hz, times } = first;
    let at_others: Vec<&SpectralLine> =
        spectral_lines.iter().filter(|line| line.v_m_s != *v_m_s && line.channel == *channel).collect();
    let follows = |line: &&&SpectralLine| {
        (line.frequency_hz / line.v_m_s / (frequency_hz / v_m_s) - 1.0).abs() < rules.same_frequency
    };
    let stays = |line: &&&SpectralLine| (line.frequency_hz / frequency_hz - 1.0).abs() < rules.same_frequency;
    let kind = if at_others.iter().any(|line| follows(&line)) {
        format!(
            "; its frequency follows the airspeed ({:.2} Hz for each m/s), as vortices do",
            frequency_hz / v_m_s
        )
    } else if at_others.iter().any(|line| stays(&line)) {
        "; it is the same at other airspeeds: a mode that turbulence moves, a fan or the mains".to_owned()
    } else {
        String::new()
    };
    Some(format!(
        "{channel} has a line of {frequency_hz:.1} Hz at {v_m_s:.0} m/s that does not repeat from run to run, \
         {times:.0} times its neighbourhood{kind}"
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::SeedableRng;
    use rand_distr::{Distribution, StandardNormal};

    fn noise_with(tone_hz: Option<f64>, seed: u64) -> Vec<(f64, usize)> {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mut bins = Vec::new();
        for record in 0..10 {
            let values: Vec<f64> = (0..500)
                .map(|i| {
                    let noise: f64 = StandardNormal.sample(&mut random);
                    let turns = tone_hz.unwrap_or(0.0) * f64::from(i) * 0.01 + 0.17 * f64::from(record);
                    noise
                        + 0.8 * (std::f64::consts::TAU * turns).sin() * f64::from(u8::from(tone_hz.is_some()))
                })
                .collect();
            pool(&SpectralLineRules::default(), &mut bins, &values, 0.01);
        }
        bins
    }

    #[test]
    fn a_tone_in_noise_is_found_where_it_is_and_noise_alone_has_none() {
        for seed in 0..40 {
            assert!(peaks(&SpectralLineRules::default(), &noise_with(None, seed)).is_empty(), "{seed}");
        }
        let found = peaks(&SpectralLineRules::default(), &noise_with(Some(9.6), 1));
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(((found[0].0 as f64 + 0.5) * 0.25 - 9.6).abs() < 0.25, "{found:?}");
    }

    #[test]
    fn the_sentence_says_what_follows_the_airspeed() {
        let line = |v_m_s: f64, frequency_hz: f64, times: f64| SpectralLine {
            channel: "Fz".into(),
            v_m_s,
            frequency_hz,
            times,
        };
        let follows = sentence(&SpectralLineRules::default(), &[line(30.0, 9.6, 20.0), line(18.0, 5.8, 9.0)])
            .expect("two lines");
        assert!(follows.contains("follows the airspeed (0.32"), "{follows}");
        let stays = sentence(&SpectralLineRules::default(), &[line(30.0, 12.5, 20.0), line(18.0, 12.5, 9.0)])
            .expect("two lines");
        assert!(stays.contains("the same at other airspeeds"), "{stays}");
        assert_eq!(sentence(&SpectralLineRules::default(), &[]), None);
    }
}
