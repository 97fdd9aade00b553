//! The page of `flutter` with large deflections.

use report::Page;
use report::page::{Block, KeyNumber, PageTable, Plate, Section};
use serde_json::Value;

use super::plates::{figures, taken};
use super::values::{at, digits, list, short_at, text, whole_at};

pub(super) fn page(result: &Value, plates: &mut Vec<Plate>) -> Page {
    let limit = short_at(result, "highest_airspeed_m_s");
    let speed = |value: Option<f64>, limit: &str| {
        value.map_or_else(|| format!("none below {limit} m/s"), |v| format!("{} m/s", digits(v, 4)))
    };
    let note = "p-k, whatever the root's angle";
    let linear = speed(at(result, "linear/flutter_speed_m_s"), &limit);
    let mut numbers = vec![KeyNumber::new("flutter of the undeformed wing", linear, note)];
    let mut table = PageTable::new(
        "Each airspeed about an equilibrium of its own.",
        &["root (deg)", "airspeed (m/s)", "becomes", "frequency (Hz)", "mode", "tip z (m)", "remarks"],
    );
    for angle in list(result, "root_angles") {
        let alpha = short_at(angle, "alpha_deg");
        let changes = list(angle, "changes_of_stability");
        let reached =
            list(angle, "points").last().map_or_else(|| limit.clone(), |point| short_at(point, "V_m_s"));
        let first = |which: &str| {
            let found = changes.iter().find(|change| text(change, "becomes") == which)?;
            at(found, "V_m_s")
        };
        let again = first("stable").map_or_else(
            || "and not stable again".to_owned(),
            |v| format!("stable again at {} m/s", digits(v, 4)),
        );
        let began_before = angle["is_unstable_at_lowest_airspeed"] == true;
        let note =
            if began_before || first("unstable").is_some() { again } else { "bent by the air".to_owned() };
        let onset = if began_before {
            let lowest =
                list(angle, "points").first().map_or_else(String::new, |point| short_at(point, "V_m_s"));
            format!("below {lowest} m/s")
        } else {
            speed(first("unstable"), &reached)
        };
        numbers.push(KeyNumber::new(format!("flutter, root at {alpha} degrees"), onset, note));
        rows(&mut table, angle, changes);
    }
    let of_modes = taken(plates, "root_angle");
    Page {
        title: format!("Flutter of {}, bent by the air", text(result, "wing")),
        lead: vec![format!(
            "Airspeeds up to {limit} m/s at {} kg/m\u{b3}, {} tangent modes about the equilibrium of each airspeed; doublets on the \
             moved boxes, and steady loads that turn with them.",
            short_at(result, "air_density_kg_m3"),
            whole_at(result, "modes"),
        )],
        numbers,
        sections: vec![
            Section::new("Where stability changes", vec![Block::Table(table)]),
            figures("V-g and V-f curves over the root's angle", of_modes),
            figures("Bent wing", std::mem::take(plates)),
        ],
        ..Page::default()
    }
}

/// A row for each change of stability of a root angle; remarks stand in the first.
fn rows(table: &mut PageTable, angle: &Value, changes: &[Value]) {
    let alpha = short_at(angle, "alpha_deg");
    let remarks: Vec<&str> = list(angle, "remarks").iter().filter_map(Value::as_str).collect();
    let mut remarks = Some(remarks.join("; "));
    for change in changes {
        table.row([
            alpha.clone(),
            short_at(change, "V_m_s"),
            text(change, "becomes").to_owned(),
            short_at(change, "frequency_hz"),
            whole_at(change, "mode"),
            short_at(change, "tip_z_m"),
            remarks.take().unwrap_or_default(),
        ]);
    }
    if let Some(remarks) = remarks {
        let none = || "-".to_owned();
        table.row([alpha, none(), none(), none(), none(), none(), remarks]);
    }
}
