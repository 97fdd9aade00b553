//! Figures and the table of `free`: cycles over airspeed, measured beside predicted, and portraits of some.

use std::f64::consts::TAU;
use std::fmt::Write as _;

use free::predict::Prediction;
use report::{Figure, Panel, Series, Style};

/// Below the cycles.
pub(super) const CAPTION: &str = "Pitch amplitude and frequency of steady cycles over airspeed. Held out: airspeeds and days that the fit \
    has not seen. The linear rig has no cycle.";
/// Below the portraits.
pub(super) const PORTRAIT_CAPTION: &str =
    "Heave over pitch of two seconds, of runs that were kept from the fit, lowest to highest airspeed.";
/// Portraits drawn.
const PORTRAITS: usize = 4;

/// Cycles over airspeed.
pub(super) fn cycles(predictions: &[Prediction]) -> Figure {
    let panel = |label: &str, of: fn(&free::window::Oscillation) -> f64| {
        let series = |name: &str, held_out: Option<bool>, measured: bool| {
            let chosen = predictions.iter().filter(|p| held_out.is_none_or(|held| held == p.held_out));
            let points = chosen.filter_map(|p| {
                let cycle = if measured { Some(&p.measured) } else { p.settled.cycle.as_ref() };
                cycle.map(|cycle| (p.run.airspeed_m_s, of(cycle)))
            });
            let (x, y) = points.unzip();
            Series::new(name, x, y, Style::Points)
        };
        let all = [
            series("measured, fitted", Some(false), true),
            series("measured, held out", Some(true), true),
            series("model", None, false),
        ];
        let there = all.into_iter().filter(|series| !series.x.is_empty()).collect();
        Panel::new("", "airspeed (m/s)", label, there)
    };
    let panels = vec![
        panel("pitch amplitude (deg)", |cycle| cycle.amplitude_rad.to_degrees()),
        panel("frequency (Hz)", |cycle| cycle.p.im / TAU),
    ];
    Figure::new("Cycles", panels, 2)
}

/// Heave over pitch of runs over the range of airspeeds; none without a predicted cycle.
pub(super) fn portraits(predictions: &[Prediction]) -> Option<Figure> {
    let held = predictions.iter().any(|p| p.held_out);
    let mut there: Vec<&Prediction> =
        predictions.iter().filter(|p| p.held_out == held && p.settled.cycle.is_some()).collect();
    there.sort_by(|a, b| a.run.airspeed_m_s.total_cmp(&b.run.airspeed_m_s));
    let last = there.len().checked_sub(1)?;
    let panel = |k: usize| {
        let p = there[k * last / (PORTRAITS - 1)];
        let degrees = |pitch: &[f64]| centred(pitch).into_iter().map(f64::to_degrees).collect();
        let millimetres = |heave: &[f64]| centred(heave).into_iter().map(|h| 1e3 * h).collect();
        let measured = (degrees(&p.run.pitch_rad), millimetres(&p.run.heave_m));
        let model = (degrees(&p.settled.trace[0]), millimetres(&p.settled.trace[1]));
        let series = vec![
            Series::new("measured", measured.0, measured.1, Style::Line),
            Series::new("model", model.0, model.1, Style::DashedLine),
        ];
        Panel::new(format!("{} m/s", p.run.airspeed_m_s), "pitch (deg)", "heave sensor (mm)", series)
    };
    Some(Figure::new("Portraits", (0..PORTRAITS).map(panel).collect(), 2))
}

fn centred(samples: &[f64]) -> Vec<f64> {
    let mean = samples.iter().sum::<f64>() / samples.len().max(1) as f64;
    samples.iter().map(|sample| sample - mean).collect()
}

/// A line a run; what the model does not have is empty.
pub(super) fn csv(predictions: &[Prediction]) -> String {
    let mut text = String::from(
        "run,day,airspeed_m_s,held_out,amplitude_rad,frequency_hz,predicted_amplitude_rad,predicted_frequency_hz\n",
    );
    for Prediction { run, held_out, measured, settled } in predictions {
        let _ = write!(text, "{},{},{},{held_out}", run.name, run.day, run.airspeed_m_s);
        let _ = write!(text, ",{:.6},{:.5}", measured.amplitude_rad, measured.p.im / TAU);
        let _ = match &settled.cycle {
            Some(cycle) => writeln!(text, ",{:.6},{:.5}", cycle.amplitude_rad, cycle.p.im / TAU),
            None => writeln!(text, ",,"),
        };
    }
    text
}
