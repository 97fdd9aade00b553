//! Noise that is not what a campaign states: what repeats differ by, band by band, over the stated white noise. Noise of gusts and
//! of amplifiers is coloured: with the stated standard deviation of a sample it may have several times the stated power where a
//! wing moves.

use crate::channels::LOADS;
use crate::data::Dataset;
use crate::noise::{band, decimation, half_difference, pairs};
use crate::transform::frequency_hz;
use maneuver::effects::Flown;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use statrs::distribution::{ChiSquared, ContinuousCDF};

/// A band of a load in which repeats differ by more than the stated noise.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct NoiseBand {
    /// The load, as columns are called.
    pub channel: String,
    /// Lower and upper end, Hz.
    pub from_hz: f64,
    /// See above.
    pub to_hz: f64,
    /// Standard deviation of the noise over the stated one.
    pub over_stated: f64,
}

/// Bands in which chance alone does not explain what repeats differ by; none without repeats or without a statement. `simulated`
/// are the runs as the model flies them.
pub fn beyond_stated(data: &Dataset, simulated: &[Flown]) -> Vec<NoiseBand> {
    let Some(stated) = data.stated else { return Vec::new() };
    let rules = &data.rules;
    let bands_hz = rules.noise.bands_hz;
    let mut sums = [[(0.0, 0_usize); 5]; 3];
    for (first, repeat) in pairs(data) {
        let dt = data.runs[first].stimulus.time_step_s;
        for (c, sums) in sums.iter_mut().enumerate().filter(|(c, _)| data.run_loads[*c]) {
            let samples = data.runs[first].measured[c].len();
            let all = half_difference(data, simulated, (first, repeat), c);
            // the mean is the offset of a run
            for (k, value) in all.iter().enumerate().skip(1) {
                let sum = &mut sums[band(&bands_hz, frequency_hz(k, samples, dt))];
                *sum = (sum.0 + value * value, sum.1 + 1);
            }
        }
    }
    let sample = stated.sample.to_array();
    // of all bands of all loads together
    let looked_at = sums.iter().flatten().filter(|sum| sum.1 > 0).count();
    let chance = rules.locate.chance / looked_at.max(1) as f64;
    let mut found = Vec::new();
    for (c, sums) in sums.iter().enumerate() {
        let variance = sample[c] * sample[c] / decimation(data);
        for (place, (square, count)) in sums.iter().enumerate().filter(|(_, sum)| sum.1 > 0 && variance > 0.0)
        {
            let ratio = square / variance;
            let by_chance = ChiSquared::new(*count as f64).map_or(1.0, |all| all.sf(ratio));
            if by_chance < chance {
                let from_hz = if place == 0 { 0.0 } else { bands_hz[place - 1] };
                let over_stated = (ratio / *count as f64).sqrt();
                found.push(NoiseBand {
                    channel: LOADS[c].to_owned(),
                    from_hz,
                    to_hz: bands_hz[place],
                    over_stated,
                });
            }
        }
    }
    found
}

/// The bands in a sentence; none without any.
pub fn sentence(bands: &[NoiseBand]) -> Option<String> {
    let most = bands.iter().max_by(|a, b| a.over_stated.total_cmp(&b.over_stated))?;
    let NoiseBand { channel, from_hz, to_hz, over_stated } = most;
    let others = match bands.len() - 1 {
        0 => String::new(),
        more => format!(", and by more than stated in {more} more bands"),
    };
    Some(format!(
        "the noise is not what campaign.ron states: repeats of {channel} differ by {over_stated:.1} times it from {from_hz:.0} to \
         {to_hz:.0} Hz{others}; what they differ by is taken"
    ))
}
