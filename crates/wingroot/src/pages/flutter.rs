//! The page of `flutter`.

use report::Page;
use report::page::{Block, KeyNumber, PageTable, Plate, Section};
use serde_json::Value;

use super::flutter_bent;
use super::plates::figures;
use super::values::{at, digits, list, short_at, text};

const METHODS: [(&str, &str); 2] = [("state_matrix", "state matrix"), ("p_k", "p-k, doublet lattice")];

pub(super) fn page(result: &Value, plates: &mut Vec<Plate>) -> Page {
    if !result["root_angles"].is_null() {
        return flutter_bent::page(result, plates);
    }
    let limit = short_at(result, "highest_airspeed_m_s");
    let mut numbers = Vec::new();
    for (model, label) in [("initial", "initial model"), ("updated", "updated model")] {
        for (what, word) in [("flutter_speed_m_s", "flutter"), ("divergence_speed_m_s", "divergence")] {
            let speeds = METHODS.map(|(method, _)| at(result, &format!("{model}/{method}/{what}")));
            let value = speeds[0]
                .map_or_else(|| format!("none below {limit} m/s"), |v| format!("{} m/s", digits(v, 4)));
            let other = speeds[1].map_or_else(|| format!("none below {limit}"), |v| digits(v, 4));
            let note = format!("eigenvalues of the state matrix; p-k: {other} m/s");
            numbers.push(KeyNumber::new(format!("{word}, {label}"), value, note));
        }
    }
    let mut table = PageTable::new(
        "",
        &["model", "method", "flutter (m/s)", "frequency (Hz)", "divergence (m/s)", "remarks"],
    );
    for model in ["initial", "updated"] {
        for (method, name) in METHODS {
            let of = |what: &str| short_at(result, &format!("{model}/{method}/{what}"));
            let remarks: Vec<&str> =
                list(result, &format!("{model}/{method}/remarks")).iter().filter_map(Value::as_str).collect();
            table.row([
                model.to_owned(),
                name.to_owned(),
                of("flutter_speed_m_s"),
                of("flutter_frequency_hz"),
                of("divergence_speed_m_s"),
                remarks.join("; "),
            ]);
        }
    }
    let held = list(result, "corrections_held_outside_m_s");
    let held: Vec<String> = held.iter().filter_map(Value::as_f64).map(|v| digits(v, 3)).collect();
    Page {
        title: "Flutter and divergence".into(),
        lead: vec![format!(
            "Airspeeds up to {limit} m/s at {} kg/m\u{b3}, {} modes, two independent methods. Corrections come from {} and were \
             found from {} m/s; outside, those of the nearest end are held.",
            at(result, "air_density_kg_m3").map_or_else(|| "-".into(), |rho| digits(rho, 4)),
            short_at(result, "modes"),
            text(result, "corrections"),
            held.join(" to ")
        )],
        numbers,
        sections: vec![
            figures("V-g and V-f curves", std::mem::take(plates)),
            Section::new("Both methods", vec![Block::Table(table)]),
        ],
        ..Page::default()
    }
}
