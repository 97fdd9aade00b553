//! Numbers that are not finite never enter a result: JSON has none of them and writes `null`, so that a `null` is refused
//! wherever the format does not say what it means. What it means is said here, and in docs/results.md.

use serde_json::Value;

/// Keys that may be `null`, and what that says; `a/b` is `b` of `a`, and `*` any key or place in a list.
pub const MEANT: &[(&str, &str)] = &[
    ("adjusted_r2", "no degree of freedom is left for it"),
    ("air", "the air is quasi-steady"),
    ("at", "no points were asked for"),
    ("beside_others", "the family has no rival to be set beside"),
    ("block", "the zero belongs to points without a named block"),
    ("block_degrees_of_freedom", "the data have no blocks"),
    ("block_sum", "the data have no blocks"),
    ("blocks", "the data have no blocks"),
    ("confidence", "the campaign's floor is not known"),
    ("corrections_at_m_s", "the deck was written without corrections"),
    ("covariance/*/*", "the data do not determine the value"),
    ("defects/*/channel", "the defect is not of one load"),
    ("defects/*/run", "the defect is not of one run"),
    ("determined_directions", "the noise of the measurements is not known"),
    ("difference", "the case gave no finite number"),
    ("divergence_speed_m_s", "no divergence up to the highest airspeed"),
    ("effects", "the response has no two-level design"),
    ("error", "the case was computed"),
    ("error_standard_deviation", "no degree of freedom is left for it"),
    ("f", "what it is set beside is zero"),
    ("flutter_frequency_hz", "no flutter up to the highest airspeed"),
    ("flutter_speed_m_s", "no flutter up to the highest airspeed"),
    ("found_with_90_percent_from", "there is no test"),
    ("gap", "the run has no measurement of one of the loads, or no noise is known"),
    ("by_channel/*/*", "the campaign has no such load"),
    ("gap/*/floor", "no null distribution says what is left where nothing is missing"),
    ("gap/holdout/after", "nothing is held out"),
    ("gap/holdout/before", "nothing is held out"),
    ("gust", "the aircraft's file has no gust"),
    ("hidden", "no term was hidden"),
    ("high", "no interval is defined"),
    ("identifiability", "the noise of the measurements is not known"),
    ("initial", "the run has no measurement"),
    ("interval", "the interval is open"),
    ("least_significant_difference", "there is no test"),
    ("leave_one_out", "a point determines a term alone"),
    ("left_out", "nothing could be left out"),
    ("left_out_airspeed", "no airspeed beside this one was left out"),
    ("left_out_blocks_rms", "the data have no blocks"),
    ("lenth", "there are too few effects for Lenth's margin"),
    ("lift", "the subcase was refused"),
    ("lift_factor", "the lift was not scaled"),
    ("low", "no interval is defined"),
    ("mean_interval", "no degree of freedom is left for it"),
    ("measurements/*/after", "no mode is paired with the measured one"),
    ("measurements/*/before", "no mode is paired with the measured one"),
    ("model", "no HDF5 file was asked for"),
    ("neutral_point_x/*", "pitching changes no lift"),
    ("next_experiment", "nothing is left to be told apart"),
    ("noise_floor", "the noise of the measurements is not known"),
    ("not_named", "no candidate came near the threshold"),
    ("ours", "the case gave no finite number"),
    ("p_k_over_state_matrix", "one of the methods finds no flutter"),
    ("p_value", "there is no test"),
    ("pairs/*", "no mode is paired with the measured one"),
    ("peak_MB", "the system does not say"),
    ("peer_peak_MB", "the other program does not say"),
    ("point_sigma", "the noise of the measurements is not known"),
    ("published_coefficient", "no published model says it"),
    ("published_figures", "the data are not those of a published model"),
    ("pure_error_standard_deviation", "no point was repeated"),
    ("random_blocks", "the data have no blocks"),
    ("raw_percent/*/*", "the load never moves, so that no part of it can be given"),
    ("reading_interval", "no degree of freedom is left for it"),
    ("reason", "the verdict needs none"),
    ("refused", "the case was computed"),
    ("residual_sum", "no degree of freedom is left for it"),
    ("rms_over_noise", "the noise of the measurements is not known"),
    ("scatter", "there is one field only"),
    ("sigma", "the data do not determine the value"),
    ("sigma_before_the_data", "the noise of the measurements is not known"),
    ("sigma_if_the_distribution_is_free", "the noise of the measurements is not known"),
    ("significant", "there is no test"),
    ("detection_limits/*/value", "no size within the effect's bounds would have been detected"),
    ("split", "the campaign says which runs are held out"),
    ("standard_error", "there is no test"),
    ("t", "there is no test, or the error is zero"),
    ("tilt_tare", "the campaign has no points without wind"),
    ("tip_load", "the structure is not held"),
    ("updated", "the run has no measurement"),
    ("value", "no case of the kind"),
];

/// The path of the first number that should be there and is not.
pub(crate) fn missing(value: &Value) -> Option<String> {
    let mut path = Vec::new();
    search(value, &mut path).then(|| path.join("/"))
}

/// Leaves the path of what was found in `path`.
fn search(value: &Value, path: &mut Vec<String>) -> bool {
    let entries: Vec<(String, &Value)> = match value {
        Value::Null => return !is_meant(path),
        Value::Object(entries) => entries.iter().map(|(key, value)| (key.clone(), value)).collect(),
        Value::Array(entries) => {
            entries.iter().enumerate().map(|(i, value)| (i.to_string(), value)).collect()
        }
        _ => return false,
    };
    for (key, value) in entries {
        path.push(key);
        if search(value, path) {
            return true;
        }
        path.pop();
    }
    false
}

fn is_meant(path: &[String]) -> bool {
    let matches = |pattern: &str| {
        let parts: Vec<&str> = pattern.split('/').collect();
        parts.len() <= path.len()
            && parts
                .iter()
                .zip(&path[path.len() - parts.len()..])
                .all(|(part, key)| *part == "*" || part == key)
    };
    MEANT.iter().any(|(pattern, _)| matches(pattern))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn a_number_that_is_not_finite_is_found_with_its_path() {
        let value = json!({ "a": [1.0, { "rms_N": f64::NAN }], "error": null });
        assert_eq!(missing(&value).as_deref(), Some("a/1/rms_N"));
        assert_eq!(missing(&json!([0.0, f64::INFINITY])).as_deref(), Some("1"));
    }

    #[test]
    fn what_the_format_leaves_open_is_no_mistake() {
        let floor = json!({ "gap": { "holdout": { "before": 2.0, "floor": f64::NAN } } });
        assert_eq!(missing(&floor), None);
        assert_eq!(missing(&json!({ "floor": f64::NAN })).as_deref(), Some("floor"));
        assert_eq!(missing(&json!({ "neutral_point_x": [1.0, null, 2.0], "refused": null })), None);
    }

    #[test]
    fn every_null_that_is_meant_is_documented() {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/results.md");
        let text = std::fs::read_to_string(path).unwrap();
        for (key, meaning) in MEANT {
            assert!(text.contains(&format!("| `{key}` | {meaning} |")), "{key} is not in docs/results.md");
        }
    }
}
