//! V-g and V-f curves of the flutter command, as a table and as a picture.

use std::fmt::Write as _;

use maneuver::flutter::{FlutterCurves, Root};
use report::{Figure, Panel, Series, Style};

/// Modes drawn; the table has all.
const DRAWN: usize = 7;
/// Damping g below which a mode is drawn at it: it is far from flutter and would squeeze the others.
const LEAST: f64 = -0.5;

/// What stands below a figure.
pub(super) const CAPTION: &str = "The first seven modes; flutter is where a damping g goes above zero. A curve of the frequency ends \
    where its mode no longer oscillates or was not followed further, and dampings below -0.5 are drawn there; the CSV \
    files of each method have all modes.";

/// Label of an axis, and what of a root is drawn on it.
type Quantity = (&'static str, fn(&Root) -> f64);

/// A model's stability by both methods.
pub(super) struct Stability {
    /// Name of the model: `initial` or `updated`.
    pub(super) name: &'static str,
    /// Eigenvalues of the state matrix.
    pub(super) state_matrix: FlutterCurves,
    /// p-k on the doublet lattice.
    pub(super) p_k: FlutterCurves,
    /// Divergence speed of the flexible wing, and of its kept modes, m/s.
    pub(super) divergence: [Option<f64>; 2],
}

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
        let quantities: [Quantity; 2] = [
            ("damping g, not below -0.5", |root| root.damping_g().map_or(f64::NAN, |g| g.max(LEAST))),
            ("frequency (Hz)", |root| if root.p.im > 0.0 { root.frequency_hz() } else { f64::NAN }),
        ];
        for (label, value) in quantities {
            let series = curves.branches.iter().take(DRAWN).enumerate().map(|(mode, branch)| {
                let x = curves.flows.iter().take(branch.len()).map(|flow| flow.v_m_s).collect();
                let y = branch.iter().map(value).collect();
                Series::new(format!("mode {}", mode + 1), x, y, Style::Line)
            });
            panels.push(Panel::new(name, "airspeed (m/s)", label, series.collect()));
        }
    }
    Figure::new(format!("Stability of the {} model", model.name), panels, 2)
}
