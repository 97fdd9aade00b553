//! Numbers of `calibrate` as `result.json` has them.

use calibrate::campaign::TIP;
use serde_json::{Value, json};

/// 18 m/s -> `18`, 22.5 m/s -> `22.5`.
pub(crate) fn speed_name(v_m_s: f64) -> String {
    let text = format!("{v_m_s:.3}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// What the data determine.
pub(crate) fn identifiability(told: &calibrate::Identifiability, measured: [bool; 4]) -> Value {
    let channels = |values: [f64; 4]| channels(values, measured);
    let by_family =
        |values: [f64; 3]| json!({ "force": values[0], "moment": values[1], "pressure_offset": values[2] });
    json!({
        "singular_values": told.singular_values,
        "leverage": { "force": channels(told.leverage[0]), "moment": channels(told.leverage[1]),
                      "pressure_offset": channels(told.leverage[2]) },
        "remaining_spread": by_family(told.remaining_spread),
        "posterior_sigma": by_family(told.posterior_sigma),
        "predicted_sigma": channels(told.predicted_sigma),
        "undetermined": told.undetermined(),
    })
}

/// All root loads, and the tip's height if it is fitted.
pub(crate) fn channels(values: [f64; 4], measured: [bool; 4]) -> Value {
    measured_channels(values, [true, true, true, measured[TIP]])
}

/// Those that are fitted.
pub(crate) fn measured_channels(values: [f64; 4], measured: [bool; 4]) -> Value {
    let named = (0..4)
        .filter(|&c| measured[c])
        .map(|c| (calibrate::campaign::CHANNELS[c].to_owned(), json!(values[c])));
    Value::Object(named.collect())
}
