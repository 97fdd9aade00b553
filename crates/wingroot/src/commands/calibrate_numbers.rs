//! Numbers of `calibrate` as `result.json` has them.

use calibrate::campaign::TIP;

use crate::commands::calibrate_result::IdentifiabilityResult;
use crate::commands::result_parts::Channels;

/// 18 m/s -> `18`, 22.5 m/s -> `22.5`.
pub(crate) fn speed_name(v_m_s: f64) -> String {
    let text = format!("{v_m_s:.3}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// What the data determine.
pub(crate) fn identifiability(
    told: &calibrate::Identifiability,
    measured: [bool; 4],
) -> IdentifiabilityResult {
    IdentifiabilityResult {
        singular_values: told.singular_values.clone(),
        leverage: told.leverage.map(|values| channels(values, measured)),
        remaining_spread: told.remaining_spread,
        posterior_sigma: told.posterior_sigma,
        predicted_sigma: channels(told.predicted_sigma, measured),
        undetermined: told.undetermined(),
    }
}

/// All root loads, and the tip's height if it is fitted.
pub(crate) fn channels(values: [f64; 4], measured: [bool; 4]) -> Channels {
    Channels::of(values, [true, true, true, measured[TIP]])
}
