//! The rows of a campaign's `static.csv`.

use crate::campaign::{AIRSPEEDS_M_S, CHANNELS, StaticPoint};
use crate::sensors::{self, Sensor};
use nastran::InputError;
use nastran::table::Table;
use std::path::Path;

/// Whether `static.csv` may have a column of this name beside those of sensors.
pub(crate) fn is_static_column(name: &str) -> bool {
    ["V_m_s", "alpha_deg", "block"].contains(&name)
        || CHANNELS.contains(&name)
        || (name.starts_with("delta_") && name.ends_with("_deg"))
}

/// Controls that are deflected in a row, rad.
fn deflections(table: &Table, row: usize, columns: &[&str]) -> Result<Vec<(String, f64)>, InputError> {
    let mut controls_rad = Vec::new();
    for column in columns {
        let delta_deg = table.number(row, column)?;
        if delta_deg != 0.0 {
            let name = column.trim_start_matches("delta_").trim_end_matches("_deg");
            controls_rad.push((name.to_owned(), delta_deg.to_radians()));
        }
    }
    Ok(controls_rad)
}

/// Which of [`CHANNELS`] a `static.csv` has, and its rows.
///
/// # Errors
/// If a column is missing or unknown, or a cell is no number that can be.
pub(crate) fn static_points(
    table: &Table,
    path: &Path,
    sensors: &[Sensor],
) -> Result<([bool; 3], Vec<StaticPoint>), InputError> {
    let columns: Vec<&str> = sensors.iter().map(|sensor| sensor.column.as_str()).collect();
    table.require(&["V_m_s", "alpha_deg"])?;
    table.require(&columns)?;
    table.allow_only(
        |name| is_static_column(name) || columns.contains(&name),
        "V_m_s, alpha_deg, Fz_N, Mx_Nm, My_Nm, block, tip_z_m, delta_NAME_deg or a sensor of campaign.ron",
    )?;
    if table.is_empty() {
        return Err(InputError::in_file(path, "there are no static cases below the header")
            .with_help("calibration needs at least three angles at one airspeed"));
    }
    let has = |name: &str| table.has(name);
    let channels = [CHANNELS[0], CHANNELS[1], CHANNELS[2]].map(has);
    if !CHANNELS.into_iter().any(has) {
        return Err(InputError::at(
            &table.span(0, "V_m_s"),
            "none of the columns Fz_N, Mx_Nm, My_Nm, tip_z_m is there",
        )
        .with_help("a static case needs at least one measured load, or the tip's height"));
    }
    let read = |row: usize, name: &str| {
        let empty = table.text(row, name)?.trim().is_empty();
        (!empty).then(|| table.number(row, name)).transpose()
    };
    let controls: Vec<&str> = table.columns().filter(|name| name.starts_with("delta_")).collect();
    let optional = |row: usize, name: &str| has(name).then(|| table.number(row, name)).transpose();
    let mut points = Vec::with_capacity(table.len());
    for row in 0..table.len() {
        let v_m_s = table.number(row, "V_m_s")?;
        if v_m_s != 0.0 && !AIRSPEEDS_M_S.contains(&v_m_s) {
            let message = format!("the airspeed {v_m_s:?} m/s is neither zero nor within 0.1 to 340 m/s");
            return Err(InputError::at(&table.span(row, "V_m_s"), message)
                .with_help("zero marks a weight tare; the air is taken as incompressible"));
        }
        let alpha_deg = table.number(row, "alpha_deg")?;
        if alpha_deg.abs() > 90.0 {
            let message = format!("the angle of attack {alpha_deg:?} degrees is beyond 90 degrees");
            return Err(InputError::at(&table.span(row, "alpha_deg"), message)
                .with_help("angles are in degrees, nose up positive"));
        }
        let controls_rad = deflections(table, row, &controls)?;
        let cells = columns.iter().map(|name| read(row, name)).collect::<Result<Vec<_>, _>>()?;
        sensors::check_weights(sensors, v_m_s, &cells, |name| table.span(row, name))?;
        points.push(StaticPoint {
            v_m_s,
            alpha_rad: alpha_deg.to_radians(),
            loads: [optional(row, CHANNELS[0])?, optional(row, CHANNELS[1])?, optional(row, CHANNELS[2])?],
            block: has("block").then(|| table.text(row, "block").map(str::to_owned)).transpose()?,
            controls_rad,
            tip_z_m: optional(row, "tip_z_m")?,
            sensors: cells,
            span: table.span(row, "V_m_s"),
        });
    }
    Ok((channels, points))
}
