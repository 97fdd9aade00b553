//! The figures of `calibrate`: root loads over the angle of attack (Fig. 8 of the paper), factors on the planform
//! (Fig. 7).

use aero::{Corrections, Flow};
use calibrate::campaign::TIP;
use calibrate::{AirspeedCalibration, Calibration};
use coupling::{ElasticWing, SteadyCase, SteadyModel};
use std::fmt::Write as _;

use report::{Figure, Panel, PlanformView, Series, Style};

use crate::commands::calibrate_model::{Fitted, Seen};
use crate::commands::calibrate_numbers::speed_name;
use crate::failure::Failure;
use crate::output::ResultFolder;

/// What noise may leave.
const NOISE: &str = "noise: 2 standard deviations of a mean to either side";
/// Singular values below this of the largest are rounding errors.
const LEAST: f64 = 1e-12;

/// The curves of [`static_loads`] as CSV: a row for every airspeed and angle.
pub(crate) fn static_loads_csv(wing: &Fitted<'_>, calibration: &Calibration) -> Result<String, Failure> {
    let names = ["Fz_N", "Mx_Nm", "My_Nm", "tip_z_m"];
    let channels: Vec<usize> = (0..names.len()).filter(|&c| calibration.data.channels[c]).collect();
    let mut text = String::from("V_m_s,alpha_deg");
    for c in &channels {
        for of in ["measured", "initial", "updated"] {
            let _ = write!(text, ",{of}_{}", names[*c]);
        }
    }
    text.push('\n');
    let neutral = Corrections::neutral(wing.correctable().len());
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
    wing: &Fitted<'_>,
    calibration: &Calibration,
) -> Result<(), Failure> {
    let loads = static_loads(wing, calibration)?;
    let caption = "Figure 8 of the paper. Initial: theory. Updated: with the corrections. Points: means of the replicates at \
                   an angle.";
    let left = residuals(&loads, calibration);
    folder.write_figure_of("static_loads", caption, loads, "static_loads.csv")?;
    let caption = "Model less measurement.";
    folder.write_figure("residuals", caption, left.clone())?;
    let noise = if calibration.data.point_sigma.is_some() {
        " The band is what noise does to the mean of an angle's replicates: two standard deviations to either side."
    } else {
        ""
    };
    folder.write_figure("residuals_updated", &format!("{caption}{noise}"), of_updated(left))?;
    match singular_values(calibration) {
        Some(figure) => {
            let caption = "Of the sensitivities of the measured loads, scaled by their noise and by the spread of the \
                           corrections before the data: above one (zero on this scale) the data say more than was assumed.";
            folder.write_figure("singular_values", caption, figure)
        }
        None => Ok(()),
    }
}

/// What is left of measured loads: each model less the measurement, and what noise may leave.
fn residuals(loads: &Figure, calibration: &Calibration) -> Figure {
    let data = &calibration.data;
    let channels: Vec<usize> = (0..4).filter(|&c| data.channels[c]).collect();
    let panel = |(place, panel): (usize, &Panel)| {
        let measured = panel.series.iter().find(|series| series.name == "measured");
        let less = |series: &Series| {
            let y = measured
                .map(|measured| series.y.iter().zip(&measured.y).map(|(y, m)| y - m).collect())
                .unwrap_or_default();
            Series::new(series.name.clone(), series.x.clone(), y, Style::Marked)
        };
        // panels are filled row by row: an airspeed a row, a channel a column
        let (airspeed, c) =
            (&calibration.airspeeds[place / channels.len()], channels[place % channels.len()]);
        let sigmas: Option<Vec<f64>> =
            airspeed.data.angles.iter().map(|angle| data.mean_sigma(angle).map(|sigma| sigma[c])).collect();
        let edge = |sigmas: &[f64], side: f64| {
            let x = airspeed.data.angles.iter().map(|angle| angle.alpha_rad.to_degrees()).collect();
            Series::new(NOISE, x, sigmas.iter().map(|sigma| side * sigma).collect(), Style::Edge)
        };
        let band = sigmas.iter().flat_map(|sigmas| [-2.0, 2.0].map(|side| edge(sigmas, side)));
        let left = panel.series.iter().filter(|series| series.name != "measured").map(less);
        Panel { series: band.chain(left).collect(), ..panel.clone() }
    };
    let title = "Residuals: initial and updated model less the measurements";
    Figure::new(title, loads.panels.iter().enumerate().map(panel).collect(), loads.columns)
}

/// The same without the initial model, in whose scale the noise would not be seen.
fn of_updated(mut residuals: Figure) -> Figure {
    residuals.title = "Residuals of the updated model beside the noise".into();
    for panel in &mut residuals.panels {
        panel.series.retain(|series| series.name != "initial");
    }
    residuals
}

/// Logarithms of the singular values by airspeed: first those of which the data say enough to be seen apart, then all; none
/// if the data determine nothing.
fn singular_values(calibration: &Calibration) -> Option<Figure> {
    let panel = |title: &str, least: f64| {
        let series = |airspeed: &AirspeedCalibration| {
            let values = &airspeed.identifiability.as_ref()?.singular_values;
            let (x, y): (Vec<f64>, Vec<f64>) = (1..)
                .zip(values)
                .filter(|(_, value)| **value > least.max(LEAST * values[0]))
                .map(|(i, value)| (f64::from(i), value.log10()))
                .unzip();
            let name = format!("{} m/s", speed_name(airspeed.data.v_m_s));
            (!x.is_empty()).then(|| Series::new(name, x, y, Style::Marked))
        };
        let series: Vec<Series> = calibration.airspeeds.iter().filter_map(series).collect();
        let panel = Panel::new(title, "number of the direction", "log10 of the singular value", series);
        (!panel.series.is_empty()).then_some(panel)
    };
    let panels: Vec<Panel> = [panel("above one", 1.0), panel("all", 0.0)].into_iter().flatten().collect();
    (!panels.is_empty()).then(|| Figure::new("Singular values: what the data determine", panels, 2))
}

/// Measured, initial and updated root loads at every airspeed.
fn static_loads(wing: &Fitted<'_>, calibration: &Calibration) -> Result<Figure, Failure> {
    let names = [("Fz (N)", 0), ("Mx (N m)", 1), ("My (N m)", 2), ("tip (m)", TIP)];
    let neutral = Corrections::neutral(wing.correctable().len());
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
    wing: &Fitted<'_>,
    airspeed: &AirspeedCalibration,
    corrections: &Corrections,
    calibration: &Calibration,
) -> Result<Vec<[f64; 4]>, Failure> {
    let flow = Flow { v_m_s: airspeed.data.v_m_s, rho_kg_m3: calibration.rho_kg_m3 };
    let cases: Vec<SteadyCase> =
        airspeed.data.angles.iter().map(|angle| SteadyCase::new(flow, angle.alpha_rad)).collect();
    Ok(wing.solve(&cases, corrections)?.iter().map(Seen::readings).collect())
}

/// Farthest that force factors, moment factors and offsets of any set are from theory: the reach of their colours, which
/// mean the same on every map.
pub(crate) fn reaches<'a>(sets: impl Iterator<Item = &'a Corrections>) -> [f64; 3] {
    let mut reaches = [0.05; 3];
    for set in sets {
        for (reach, (values, neutral)) in reaches.iter_mut().zip(families(set)) {
            *reach = values.iter().map(|value| (value - neutral).abs()).fold(*reach, f64::max);
        }
    }
    reaches
}

/// Three corrections on the planform.
pub(crate) fn planforms(wing: &ElasticWing, set: &Corrections, reaches: [f64; 3]) -> Vec<PlanformView> {
    let corners: Vec<[(f64, f64); 4]> = wing
        .correctable
        .places
        .iter()
        .map(|&place| wing.lattice.boxes[place].corners.map(|corner| (corner.x, corner.y)))
        .collect();
    let names = [
        ("force factor", "W force (-)"),
        ("moment factor", "W moment (-)"),
        ("pressure offset", "f_e/q (-)"),
    ];
    let mut views = Vec::new();
    for (((values, neutral), reach), (title, label)) in families(set).into_iter().zip(reaches).zip(names) {
        views.push(PlanformView {
            corners: corners.clone(),
            values: values.to_vec(),
            label: label.into(),
            title: title.into(),
            range: Some((neutral - reach, neutral + reach)),
        });
    }
    views
}

/// Corrections with what leaves theory as it is.
fn families(set: &Corrections) -> [(&[f64], f64); 3] {
    [(&set.force, 1.0), (&set.moment, 1.0), (&set.pressure_offset, 0.0)]
}
