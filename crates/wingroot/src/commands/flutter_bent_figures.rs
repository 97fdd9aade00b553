//! Table and pictures of `flutter` with large deflections: V-g over root angle, frequencies over the tip's rise, the boundary.

use std::f64::consts::TAU;
use std::fmt::Write as _;

use maneuver::flutter::{BentPoint, BentSweep};
use report::{Figure, Panel, Series, Style};

/// Modes drawn; the table has all.
const DRAWN: usize = 7;
/// Damping g below which a mode is drawn at it: it is far from flutter and would squeeze the others.
const LEAST: f64 = -0.5;

const CURVES: &str = "Each airspeed about the equilibrium of its own; flutter is where a damping g goes above zero, and a mode may \
    become stable again. The first seven modes, named as they are at the lowest airspeed; dampings below -0.5 are drawn there.";
const FREQUENCIES: &str = "Natural frequencies of the bent wing, its air still, over the rise of the tip that airspeed gives; modes are followed \
    by their shapes.";
const BOUNDARY: &str = "Airspeeds at which a mode becomes unstable, and stable again, over the root's angle of attack and over the rise of the tip there.";

/// A sweep at one angle of attack of the root.
pub(super) struct Angle {
    /// Degrees.
    pub(super) alpha_deg: f64,
    /// What was found.
    pub(super) sweep: BentSweep,
}

/// Airspeed, tip, then natural frequency, frequency in the air (Hz) and damping g of every mode; empty where a mode does not
/// oscillate or was not followed.
pub(super) fn csv(angles: &[Angle]) -> String {
    let mut text = String::from("alpha_deg,V_m_s,tip_z_m,tip_twist_deg");
    let first = angles.first().and_then(|angle| angle.sweep.points.first());
    for mode in 1..=first.map_or(0, |point| point.roots.len()) {
        let _ = write!(text, ",natural_{mode}_hz,frequency_{mode}_hz,damping_{mode}_g");
    }
    text.push('\n');
    for angle in angles {
        for point in &angle.sweep.points {
            let (v, state) = (point.case.flow.v_m_s, &point.state);
            let _ = write!(text, "{},{v},{:.9e}", angle.alpha_deg, state.tip_m.z);
            let _ = write!(text, ",{:.9e}", state.twist_rad.to_degrees());
            for (mode, omega) in point.omega_rad_s.iter().enumerate() {
                let [hz, g] = root(point, mode);
                let _ = write!(text, ",{:.9e}", omega / TAU);
                let _ = if g.is_finite() { write!(text, ",{hz:.9e},{g:.9e}") } else { write!(text, ",,") };
            }
            text.push('\n');
        }
    }
    text
}

/// Frequency (Hz) and damping g of a mode; not a number where it does not oscillate or was not followed.
fn root(point: &BentPoint, mode: usize) -> [f64; 2] {
    match point.roots[mode] {
        Some(p) if p.im > 0.0 => [p.im / TAU, 2.0 * p.re / p.im],
        _ => [f64::NAN; 2],
    }
}

/// A damping as it is drawn; what is not a number stays none.
fn drawn(g: f64) -> f64 {
    if g < LEAST { LEAST } else { g }
}

/// Name, caption and picture of every figure.
pub(super) fn figures(angles: &[Angle]) -> Vec<(String, &'static str, Figure)> {
    let mut all = Vec::new();
    for (place, angle) in angles.iter().enumerate() {
        all.push((format!("root_angle_{}", place + 1), CURVES, curves(angle)));
    }
    all.push(("frequencies_over_tip".to_owned(), FREQUENCIES, frequencies(angles)));
    if angles.iter().any(|angle| !angle.sweep.crossings.is_empty()) {
        all.push(("flutter_boundary".to_owned(), BOUNDARY, boundary(angles)));
    }
    all
}

/// A line a mode.
fn lines(points: &[BentPoint], at: &dyn Fn(&BentPoint, usize) -> [f64; 2]) -> Vec<Series> {
    let drawn = points.first().map_or(0, |point| point.roots.len().min(DRAWN));
    let line = |mode: usize| {
        let (x, y) = points.iter().map(|point| at(point, mode)).map(|[x, y]| (x, y)).unzip();
        Series::new(format!("mode {}", mode + 1), x, y, Style::Line)
    };
    (0..drawn).map(line).collect()
}

fn curves(angle: &Angle) -> Figure {
    let points = &angle.sweep.points;
    let speed = |point: &BentPoint| point.case.flow.v_m_s;
    let damping = lines(points, &|point, mode| [speed(point), drawn(root(point, mode)[1])]);
    let frequency = lines(points, &|point, mode| [speed(point), root(point, mode)[0]]);
    let panels = vec![
        Panel::new("damping g", "airspeed (m/s)", "damping g, not below -0.5", damping),
        Panel::new("frequency", "airspeed (m/s)", "frequency (Hz)", frequency),
    ];
    Figure::new(format!("Root at {} degrees", angle.alpha_deg), panels, 2)
}

fn frequencies(angles: &[Angle]) -> Figure {
    let panel = |angle: &Angle| {
        let lines =
            lines(&angle.sweep.points, &|point, mode| [point.state.tip_m.z, point.omega_rad_s[mode] / TAU]);
        Panel::new(format!("root at {} degrees", angle.alpha_deg), "tip z (m)", "frequency (Hz)", lines)
    };
    Figure::new("Natural frequencies of the bent wing", angles.iter().map(panel).collect(), 2)
}

fn boundary(angles: &[Angle]) -> Figure {
    let panel = |title: &str, label: &str, over_tip: bool| {
        let series = |name: &str, unstable: bool| {
            let each = angles.iter().flat_map(|angle| {
                let changes = angle.sweep.crossings.iter().filter(|crossing| crossing.unstable == unstable);
                changes.map(|crossing| {
                    (if over_tip { crossing.tip_z_m } else { angle.alpha_deg }, crossing.v_m_s)
                })
            });
            let (x, y): (Vec<f64>, Vec<f64>) = each.unzip();
            (!x.is_empty()).then(|| Series::new(name, x, y, Style::Points))
        };
        let all = [series("becomes unstable", true), series("becomes stable", false)];
        Panel::new(title, label, "airspeed (m/s)", all.into_iter().flatten().collect())
    };
    let panels = vec![
        panel("over the root's angle", "angle of attack of the root (deg)", false),
        panel("over the tip's rise", "tip z (m)", true),
    ];
    Figure::new("Where stability changes", panels, 2)
}
