//! The figures of `deflection`: equivalent over commanded deflection (Fig. 15 of the paper) and the factor (Fig. 16), a
//! panel for each control surface and a line for each airspeed. Standard errors are smaller than the points as a rule, and
//! in `deflection.csv`.

use maneuver::deflection_fit::FittedFactor;
use report::{Figure, Panel, Series, Style};

use super::calibrate_numbers::speed_name;

/// Equivalent over commanded deflection, with the straight line of a linear model.
pub(crate) fn equivalents(factors: &[FittedFactor]) -> Figure {
    let mut figure =
        figure(factors, "equivalent deflection (deg)", |fitted, k| k * fitted.commanded_rad.to_degrees());
    figure.title = "Deflections that give the measured loads, over commanded ones".into();
    for panel in &mut figure.panels {
        let most = panel.series.iter().flat_map(|series| &series.x).fold(0.0, |most: f64, x| most.max(*x));
        panel.series.insert(0, Series::new("linear", vec![0.0, most], vec![0.0, most], Style::DashedLine));
        for series in panel.series.iter_mut().filter(|series| series.style == Style::Line) {
            series.x.insert(0, 0.0);
            series.y.insert(0, 0.0);
        }
    }
    figure
}

/// K over deflection.
pub(crate) fn factors(factors: &[FittedFactor]) -> Figure {
    let mut figure = figure(factors, "K (-)", |_, k| k);
    figure.title = "Deflection correction K: equivalent over commanded deflection".into();
    figure
}

fn figure(factors: &[FittedFactor], y_label: &str, y: impl Fn(&FittedFactor, f64) -> f64) -> Figure {
    let speed = |fitted: &FittedFactor| format!("{} m/s", speed_name(fitted.v_m_s));
    let mut controls: Vec<&str> = factors.iter().map(|fitted| fitted.control.as_str()).collect();
    controls.dedup();
    let panel = |control: &str| {
        let of: Vec<&FittedFactor> = factors.iter().filter(|fitted| fitted.control == control).collect();
        let mut speeds: Vec<String> = of.iter().map(|fitted| speed(fitted)).collect();
        speeds.dedup();
        let mut series = Vec::new();
        for of_speed in speeds {
            let at: Vec<&&FittedFactor> = of.iter().filter(|fitted| speed(fitted) == of_speed).collect();
            let x: Vec<f64> = at.iter().map(|fitted| fitted.commanded_rad.to_degrees()).collect();
            let values: Vec<f64> = at.iter().map(|fitted| y(fitted, fitted.factor)).collect();
            series.push(Series::new(of_speed.clone(), x.clone(), values.clone(), Style::Line));
            series.push(Series::new(of_speed, x, values, Style::Points));
        }
        Panel::new(format!("{control} aileron"), "commanded deflection (deg)", y_label, series)
    };
    let panels: Vec<Panel> = controls.into_iter().map(panel).collect();
    Figure { title: String::new(), columns: panels.len(), panels }
}
