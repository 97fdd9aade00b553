//! What the calibrated wing predicts with how much certainty: `predictions.csv`, figures, and what stands in `result.json`.

use std::fmt::Write as _;

use calibrate::Reading;
use calibrate::posterior::next::Suggestion;
use calibrate::posterior::predictions::Quantity;
use calibrate::posterior::{AirspeedPosterior, Prediction};
use coupling::ElasticWing;
use nastran::InputError;
use report::{Figure, Panel, Series, Style};

use crate::commands::calibrate_numbers::speed_name;
use crate::commands::calibrate_predictions_result::{named, result};
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::pages::values::digits;

/// Band of a quantity with the data, and without them.
const BANDS: [&str; 2] = ["90 % interval with the data", "90 % interval before the data"];

/// A factor on a control that no row deflects is this near to one.
const UNTOLD: f64 = 1e-9;

/// What to measure next, for the console.
pub(crate) fn next_table(all: &[Suggestion]) -> String {
    if all.is_empty() {
        return String::new();
    }
    let columns: [report::Column<'_, &Suggestion>; 2] = [
        ("measure next", &|s| s.measure.clone()),
        ("interval narrows to (%)", &|s| {
            format!("{:.0}", 100.0 * s.sigma_then / s.sigma.max(f64::MIN_POSITIVE))
        }),
    ];
    format!("{}\n", report::Table::of(all, &columns))
}

/// What `--next` names.
pub(crate) fn wanted(words: &str, wing: &ElasticWing) -> Result<Quantity, Failure> {
    let controls = wing.control_names();
    let of = |(what, which): (&str, &str)| match what {
        "bending" => {
            let place = which.parse().ok().filter(|y| (0.0..1.0).contains(y));
            place.map(|y_over_span| Quantity::Reading(Reading::Bending { y_over_span }))
        }
        "control" => {
            controls.contains(&which.to_owned()).then(|| Quantity::ControlMx { control: which.to_owned() })
        }
        _ => None,
    };
    if words == "tip" {
        return Ok(Quantity::TipHeight);
    }
    words.split_once(':').and_then(of).ok_or_else(|| {
        let named = if controls.is_empty() { "none".to_owned() } else { controls.join(", ") };
        InputError::general(format!("--next {words} is no prediction"))
            .with_help(format!(
                "write tip, bending:0.5 (a place from 0 at the root to 1 at the tip) or control:NAME (controls of this wing: {named})"
            ))
            .into()
    })
}

/// Writes `predictions.csv` and the spanwise lift with its bands.
pub(crate) fn write(
    folder: &ResultFolder,
    wing: &ElasticWing,
    all: &[AirspeedPosterior],
) -> Result<(), Failure> {
    if all.is_empty() {
        return Ok(());
    }
    let mut text = String::from(
        "V_m_s,alpha_deg,quantity,unit,y_over_span,control,theory,value,low,high,sigma,prior_sigma,decided_by_data\n",
    );
    for at in result(wing, all) {
        for p in &at.predictions {
            let place = p.y_over_span.map_or_else(String::new, |y| format!("{y:.4}"));
            let control = p.control.as_deref().unwrap_or("");
            let _ = writeln!(
                text,
                "{},{:.4},{},{},{place},{control},{:.6},{:.6},{:.6},{:.6},{:.6},{:.6},{:.4}",
                at.v_m_s,
                at.alpha_deg,
                p.quantity,
                p.unit,
                p.theory,
                p.value,
                p.low,
                p.high,
                p.sigma,
                p.prior_sigma,
                p.decided_by_data,
            );
        }
    }
    folder.write_text("predictions.csv", &text)?;
    let caption = "At the largest angle that was measured. Before the data the prior of the wing's file says what panel models are \
                   off by; root loads decide the sum of the lift and where it acts, not how it is spread.";
    folder.write_figure("predicted_lift", caption, lift(all))
}

fn lift(all: &[AirspeedPosterior]) -> Figure {
    let panel = |at: &AirspeedPosterior| {
        let strips: Vec<(f64, &Prediction)> = at
            .predictions
            .iter()
            .filter_map(|p| match p.quantity {
                Quantity::Reading(Reading::StripLift { y_over_span }) => Some((y_over_span, p)),
                _ => None,
            })
            .collect();
        let curve = |name: &str, style: Style, of: &dyn Fn(&Prediction) -> f64| {
            let (x, y) = strips.iter().map(|(y_norm, p)| (*y_norm, of(p))).unzip();
            Series::new(name, x, y, style)
        };
        let series = vec![
            curve(BANDS[1], Style::Line, &|p| p.interval_before()[0]),
            curve(BANDS[1], Style::Line, &|p| p.interval_before()[1]),
            curve(BANDS[0], Style::Edge, &|p| p.interval()[0]),
            curve(BANDS[0], Style::Edge, &|p| p.interval()[1]),
            curve("initial", Style::DashedLine, &|p| p.theory),
            curve("updated", Style::Line, &|p| p.value),
        ];
        let title = format!("{} m/s, {:.1} deg", speed_name(at.v_m_s), at.alpha_rad.to_degrees());
        Panel::new(title, "y over span", "lift (N/m)", series)
    };
    let columns = all.len().min(3);
    Figure::new("Spanwise lift: what the data decide", all.iter().map(panel).collect(), columns)
}

/// Lines for the console: what root loads leave open, at the highest airspeed; `is_flown` if the structure that was found stands in
/// corrections.ron.
pub(crate) fn summary(wing: &ElasticWing, all: &[AirspeedPosterior], is_flown: bool) -> String {
    let Some(at) = all.last() else { return String::new() };
    let line = |p: &Prediction| {
        let (_, unit, y_norm, control) = named(&p.quantity);
        let name = match (&p.quantity, y_norm, control) {
            (Quantity::Reading(Reading::Bending { .. }), Some(0.5), _) => "bending at mid-span".to_owned(),
            (Quantity::TipHeight, ..) => "tip".to_owned(),
            (_, _, Some(control)) => format!("root bending by {control}"),
            _ => return None,
        };
        let [low, high] = p.interval();
        let [value, low, high] = [p.value, low, high].map(|x| digits(x, 3));
        Some(format!("{name} {value} ({low} to {high}) {unit}"))
    };
    let lines: Vec<String> = at.predictions.iter().filter_map(line).collect();
    let mut text = format!(
        "with 90 % intervals, at {} m/s and {:.1} degrees: {}\n",
        speed_name(at.v_m_s),
        at.alpha_rad.to_degrees(),
        lines.join("; ")
    );
    let beside: Vec<String> = all.iter().filter_map(|at| beside(wing, at)).collect();
    if !beside.is_empty() {
        let _ = writeln!(
            text,
            "note: more than root loads was measured: corrections are next to what all of it and the prior leave most likely, with the \
             root loads met by the structure as given. Found beside them, {}: {}",
            if is_flown {
                "in `found` of corrections.ron and flown by the updated model"
            } else {
                "other at each airspeed, so that the updated model flies the structure as given"
            },
            beside.join("; ")
        );
    }
    text
}

/// What goes with the corrections of an airspeed where more than root loads was measured; a control only if it was deflected.
fn beside(wing: &ElasticWing, at: &AirspeedPosterior) -> Option<String> {
    let mean = at.mean.as_ref()?;
    let [bending, torsion] = mean.log_flexibility.map(|log| format!("{:+.1} %", 100.0 * log.exp_m1()));
    let mut text =
        format!("{} m/s: flexibility {bending} in bending, {torsion} in torsion", speed_name(at.v_m_s));
    for (name, factor) in wing.control_names().iter().zip(&mean.controls) {
        if (factor - 1.0).abs() > UNTOLD {
            let _ = write!(text, ", {name} {factor:.3} times its effect");
        }
    }
    Some(text)
}
