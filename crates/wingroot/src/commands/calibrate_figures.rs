//! The figures of `calibrate`: root loads over the angle of attack (Fig. 8 of the paper), factors on the planform
//! (Fig. 7).

use aero::{Corrections, Flow};
use calibrate::campaign::TIP;
use calibrate::{AirspeedCalibration, Calibration};
use coupling::{ElasticWing, SteadyCase, SteadyState};
use std::fmt::Write as _;

use report::{DrawError, Drawing, Figure, Panel, PlanformView, Series, Style};

use crate::commands::calibrate_numbers::speed_name;
use crate::failure::Failure;
use crate::output::ResultFolder;

/// Singular values below this of the largest are rounding errors.
const LEAST: f64 = 1e-12;

/// The curves of [`static_loads`] as CSV: a row for every airspeed and angle.
pub(crate) fn static_loads_csv(wing: &ElasticWing, calibration: &Calibration) -> Result<String, Failure> {
    let names = ["Fz_N", "Mx_Nm", "My_Nm", "tip_z_m"];
    let channels: Vec<usize> = (0..names.len()).filter(|&c| calibration.data.channels[c]).collect();
    let mut text = String::from("V_m_s,alpha_deg");
    for c in &channels {
        for of in ["measured", "initial", "updated"] {
            let _ = write!(text, ",{of}_{}", names[*c]);
        }
    }
    text.push('\n');
    let neutral = Corrections::neutral(wing.correctable.len());
    for airspeed in &calibration.airspeeds {
        let initial = simulated(wing, airspeed, &neutral, calibration)?;
        let updated = simulated(wing, airspeed, &airspeed.corrections, calibration)?;
        for (i, angle) in airspeed.data.angles.iter().enumerate() {
            let _ = write!(text, "{},{:.6}", airspeed.data.v_m_s, angle.alpha_rad.to_degrees());
            for &c in &channels {
                let _ = write!(text, ",{:.7},{:.7},{:.7}", angle.readings()[c], initial[i][c], updated[i][c]);
            }
            text.push('\n');
        }
    }
    Ok(text)
}

/// Writes root loads, what is left of them, and singular values.
pub(crate) fn write(
    folder: &ResultFolder,
    wing: &ElasticWing,
    calibration: &Calibration,
) -> Result<(), Failure> {
    let loads = static_loads(wing, calibration)?;
    let caption = "Figure 8 of the paper. Initial: theory. Updated: with the corrections. Points: means of the replicates at \
                   an angle.";
    let left = residuals(&loads);
    folder.write_figure_of("static_loads", caption, loads, "static_loads.csv")?;
    folder.write_figure("residuals", "Model less measurement.", left)?;
    match singular_values(calibration) {
        Some(figure) => {
            let caption = "Of the sensitivities of the measured loads, scaled by their noise and by the spread of the \
                           corrections before the data: above one (zero on this scale) the data say more than was assumed.";
            folder.write_figure("singular_values", caption, figure)
        }
        None => Ok(()),
    }
}

/// What is left of measured loads: each model less the measurement.
fn residuals(loads: &Figure) -> Figure {
    let panel = |panel: &Panel| {
        let measured = panel.series.iter().find(|series| series.name == "measured");
        let less = |series: &Series| {
            let y = measured
                .map(|measured| series.y.iter().zip(&measured.y).map(|(y, m)| y - m).collect())
                .unwrap_or_default();
            Series::new(series.name.clone(), series.x.clone(), y, series.style)
        };
        let series = panel.series.iter().filter(|series| series.name != "measured").map(less).collect();
        Panel { series, ..panel.clone() }
    };
    let title = "Residuals: initial and updated model less the measurements";
    Figure::new(title, loads.panels.iter().map(panel).collect(), loads.columns)
}

/// Logarithms of the singular values by airspeed; none if the data determine nothing.
fn singular_values(calibration: &Calibration) -> Option<Figure> {
    let series = |airspeed: &AirspeedCalibration| {
        let values = &airspeed.identifiability.as_ref()?.singular_values;
        let (x, y): (Vec<f64>, Vec<f64>) = (1..)
            .zip(values)
            .filter(|(_, value)| **value > LEAST * values[0])
            .map(|(i, value)| (f64::from(i), value.log10()))
            .unzip();
        let name = format!("{} m/s", speed_name(airspeed.data.v_m_s));
        (!x.is_empty()).then(|| Series::new(name, x, y, Style::Points))
    };
    let panel = Panel::new(
        "",
        "number of the direction",
        "log10 of the singular value",
        calibration.airspeeds.iter().filter_map(series).collect(),
    );
    (!panel.series.is_empty())
        .then(|| Figure::new("Singular values: what the data determine", vec![panel], 1))
}

/// Measured, initial and updated root loads at every airspeed.
fn static_loads(wing: &ElasticWing, calibration: &Calibration) -> Result<Figure, Failure> {
    let names = [("Fz (N)", 0), ("Mx (N m)", 1), ("My (N m)", 2), ("tip (m)", TIP)];
    let neutral = Corrections::neutral(wing.correctable.len());
    let mut panels = Vec::new();
    for airspeed in &calibration.airspeeds {
        let measured: Vec<f64> =
            airspeed.data.angles.iter().map(|angle| angle.alpha_rad.to_degrees()).collect();
        let initial = simulated(wing, airspeed, &neutral, calibration)?;
        let updated = simulated(wing, airspeed, &airspeed.corrections, calibration)?;
        for (label, c) in names.into_iter().filter(|&(_, c)| calibration.data.channels[c]) {
            let of = |loads: &[[f64; 4]]| loads.iter().map(|load| load[c]).collect::<Vec<f64>>();
            let points = airspeed.data.angles.iter().map(|angle| angle.readings()[c]).collect();
            panels.push(Panel::new(
                format!("{} m/s", speed_name(airspeed.data.v_m_s)),
                "angle of attack (deg)",
                label,
                vec![
                    Series::new("initial", measured.clone(), of(&initial), Style::DashedLine),
                    Series::new("updated", measured.clone(), of(&updated), Style::Line),
                    Series::new("measured", measured.clone(), points, Style::Points),
                ],
            ));
        }
    }
    let columns = calibration.data.channels.iter().filter(|&&measured| measured).count();
    Ok(Figure::new("Root loads: initial and updated model beside the measurements", panels, columns))
}

fn simulated(
    wing: &ElasticWing,
    airspeed: &AirspeedCalibration,
    corrections: &Corrections,
    calibration: &Calibration,
) -> Result<Vec<[f64; 4]>, Failure> {
    let flow = Flow { v_m_s: airspeed.data.v_m_s, rho_kg_m3: calibration.rho_kg_m3 };
    let cases: Vec<SteadyCase> =
        airspeed.data.angles.iter().map(|angle| SteadyCase::new(flow, angle.alpha_rad)).collect();
    let reading = |state: &SteadyState| {
        let [fz, mx, my] = state.root.to_array();
        [fz, mx, my, state.tip_z_m]
    };
    Ok(wing.at(flow, corrections)?.solve(&cases).iter().map(reading).collect())
}

/// Three corrections on the planform; `at` names the airspeed or airspeeds.
pub(crate) fn corrections(wing: &ElasticWing, c: &Corrections, at: &str) -> Result<Drawing, DrawError> {
    let corners: Vec<[(f64, f64); 4]> = wing
        .correctable
        .places
        .iter()
        .map(|&place| wing.lattice.boxes[place].corners.map(|corner| (corner.x, corner.y)))
        .collect();
    let view = |title: &str, label: &str, values: &[f64], neutral: f64| {
        let reach = values.iter().map(|value| (value - neutral).abs()).fold(0.05, f64::max);
        PlanformView {
            corners: corners.clone(),
            values: values.to_vec(),
            label: label.into(),
            title: title.into(),
            range: Some((neutral - reach, neutral + reach)),
        }
    };
    let views = [
        view("force factor", "W force (-)", &c.force, 1.0),
        view("moment factor", "W moment (-)", &c.moment, 1.0),
        view("pressure offset", "f_e/q (-)", &c.pressure_offset, 0.0),
    ];
    report::heatmap::draw(&format!("Corrections at {at}"), &views)
}
