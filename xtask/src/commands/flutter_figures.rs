//! V-g and V-f curves of the flutter command, as a table and as a picture.

use std::fmt::Write as _;

use maneuver::flutter::{FlutterCurves, Root};
use report::{Figure, Panel, Series, Style};

use super::flutter::Stability;

/// Modes drawn; the table has all.
const DRAWN: usize = 8;
/// Damping g below which a mode is not drawn: it is far from flutter and would squeeze the others.
const LEAST: f64 = -0.5;

/// Airspeed, then frequency (Hz) and damping g of every mode; empty where a mode does not oscillate or was not followed.
pub(super) fn csv(curves: &FlutterCurves) -> String {
    let mut text = String::from("V_m_s");
    for mode in 1..=curves.branches.len() {
        let _ = write!(text, ",frequency_{mode}_hz,damping_{mode}_g");
    }
    text.push('\n');
    for (place, flow) in curves.flows.iter().enumerate() {
        let _ = write!(text, "{}", flow.v_m_s);
        for branch in &curves.branches {
            match branch.get(place).and_then(|root| Some((root.frequency_hz(), root.damping_g()?))) {
                Some((hz, g)) => {
                    let _ = write!(text, ",{hz},{g}");
                }
                None => text.push_str(",,"),
            }
        }
        text.push('\n');
    }
    text
}

/// Damping and frequency over airspeed, the state matrix above, p-k below.
pub(super) fn figure(model: &Stability) -> Figure {
    let methods = [("state matrix", &model.state_matrix), ("p-k on the doublet lattice", &model.p_k)];
    let mut panels = Vec::new();
    for (name, curves) in methods {
        let drawn = curves.branches.iter().filter(|branch| branch.iter().any(visible)).take(DRAWN);
        let drawn: Vec<&Vec<Root>> = drawn.collect();
        for (label, value) in [
            ("damping g", (|root: &Root| root.damping_g().unwrap_or(f64::NAN)) as fn(&Root) -> f64),
            ("frequency (Hz)", Root::frequency_hz),
        ] {
            let series = drawn.iter().enumerate().map(|(i, branch)| {
                let seen = |root: &Root| if visible(root) { value(root) } else { f64::NAN };
                let y: Vec<f64> = branch.iter().map(seen).collect();
                let x = curves.flows.iter().take(y.len()).map(|flow| flow.v_m_s).collect();
                Series::new(format!("mode {}", i + 1), x, y, Style::Line)
            });
            panels.push(Panel {
                title: name.into(),
                x_label: "airspeed (m/s)".into(),
                y_label: label.into(),
                series: series.collect(),
            });
        }
    }
    Figure { title: format!("Stability of the {} model", model.name), panels, columns: 2 }
}

fn visible(root: &Root) -> bool {
    root.damping_g().is_some_and(|g| g > LEAST)
}
