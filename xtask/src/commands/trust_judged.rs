//! Predictions of a calibrated wing beside what the true one has, and the table of how often intervals hold it.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use super::trust_campaign::{Flown, Sensors};
use super::trust_flight::InFlight;
use calibrate::Reading;
use calibrate::posterior::Prediction;
use calibrate::posterior::predictions::Quantity;
use truth::lift::Kind;

/// A number of a true wing.
#[derive(Debug, Clone, Copy)]
pub(super) struct True {
    pub(super) quantity: &'static str,
    pub(super) value: f64,
    /// Size that errors are over.
    pub(super) scale: f64,
}

/// What is predicted of a true wing, by theory too.
pub(super) struct Predicted {
    value: f64,
    theory: f64,
    interval: [f64; 2],
}

/// A prediction beside the truth, over the truth's size.
pub(super) struct Judged {
    quantity: &'static str,
    held: bool,
    error: f64,
    theory_error: f64,
    half_width: f64,
    score: f64,
    /// Of the best that whoever knows the generator could say.
    generators_score: f64,
}

/// One truth with one set of sensors.
pub(super) struct Outcome {
    pub(super) kind: Kind,
    pub(super) sensors: Sensors,
    pub(super) judged: Vec<Judged>,
    /// Whether something was said about the data.
    pub(super) flagged: bool,
}

/// What a true wing has of quantities at an angle, then in its maneuvers; none for what is not judged.
pub(super) fn truths(flown: &Flown<'_>, asked: &[Quantity], alpha_rad: f64) -> Vec<Option<True>> {
    let carried = flown.at(alpha_rad);
    let lift = |quantity: &Quantity| match quantity {
        Quantity::Reading(Reading::StripLift { y_over_span }) => Some(carried.strip_lift(*y_over_span)),
        _ => None,
    };
    let lifts: Vec<f64> = asked.iter().filter_map(lift).collect();
    let typical = (lifts.iter().map(|lift| lift * lift).sum::<f64>() / lifts.len() as f64).sqrt();
    let one = |asked: &Quantity| {
        let (quantity, value) = match asked {
            Quantity::Reading(Reading::Bending { y_over_span }) if *y_over_span > 0.0 => {
                let name = if *y_over_span == 0.5 { "bending at mid-span" } else { "bending elsewhere" };
                (name, carried.bending(*y_over_span))
            }
            Quantity::TipHeight => ("tip", carried.tip_m()),
            Quantity::ControlMx { control } => ("aileron power", flown.power(alpha_rad, control)),
            Quantity::Reading(_) => {
                return lift(asked).map(|value| True { quantity: "strip lift", value, scale: typical });
            }
        };
        Some(True { quantity, value, scale: value.abs() })
    };
    let in_flight = flown
        .in_flight()
        .into_iter()
        .map(|flown| flown.map(|(quantity, [value, scale])| True { quantity, value, scale }));
    asked.iter().map(one).chain(in_flight).collect()
}

/// Predictions in the order of [`truths`].
pub(super) fn predicted(predictions: &[Prediction], in_flight: &[InFlight]) -> Vec<Predicted> {
    let on_balance =
        predictions.iter().map(|p| Predicted { value: p.value, theory: p.theory, interval: p.interval() });
    let flown =
        in_flight.iter().map(|f| Predicted { value: f.value, theory: f.theory, interval: f.interval });
    on_balance.chain(flown).collect()
}

/// Interval score of a 90 % interval (Gneiting and Raftery, J. Am. Stat. Assoc. 102, 2007, Eq. 43): its width, and 2/0.1 times by how much the truth
/// is outside.
fn score([low, high]: [f64; 2], value: f64) -> f64 {
    high - low + 20.0 * (low - value).max(value - high).max(0.0)
}

/// Judges predictions; `by_generator` are the intervals of whoever knows the generator.
pub(super) fn judge(
    truths: &[Option<True>],
    predicted: &[Predicted],
    by_generator: &[[f64; 2]],
) -> Vec<Judged> {
    let one = |(truth, (p, by_generator)): (&Option<True>, (&Predicted, &[f64; 2]))| {
        let True { quantity, value, scale } = (*truth)?;
        let [low, high] = p.interval;
        Some(Judged {
            quantity,
            held: (low..=high).contains(&value),
            error: (p.value - value) / scale,
            theory_error: (p.theory - value) / scale,
            half_width: 0.5 * (high - low) / scale,
            score: score(p.interval, value) / scale,
            generators_score: score(*by_generator, value) / scale,
        })
    };
    truths.iter().zip(predicted.iter().zip(by_generator)).filter_map(one).collect()
}

/// Rows of the table: by quantity and sensors, attached flow and separated, and pooled over sensors.
pub(super) fn rows(outcomes: &[Outcome]) -> Vec<Value> {
    let mut cells: BTreeMap<(&str, &str, &str), Vec<&Judged>> = BTreeMap::new();
    for outcome in outcomes {
        let flow = if outcome.kind == Kind::Separated { "separated" } else { "attached" };
        for judged in &outcome.judged {
            for sensors in [outcome.sensors.name(), "pooled"] {
                cells.entry((flow, judged.quantity, sensors)).or_default().push(judged);
            }
        }
    }
    let row = |((flow, quantity, sensors), all): ((&str, &str, &str), Vec<&Judged>)| {
        let count = all.len() as f64;
        let mean = |of: &dyn Fn(&Judged) -> f64| all.iter().map(|judged| of(judged)).sum::<f64>() / count;
        let (own, generators) = (mean(&|judged| judged.score), mean(&|judged| judged.generators_score));
        json!({
            "flow": flow, "quantity": quantity, "sensors": sensors, "count": all.len(),
            "held": mean(&|judged| f64::from(u8::from(judged.held))),
            "rms_error": mean(&|judged| judged.error.powi(2)).sqrt(),
            "rms_error_of_theory": mean(&|judged| judged.theory_error.powi(2)).sqrt(),
            "half_width": mean(&|judged| judged.half_width),
            "interval_score": own,
            "interval_score_over_generators": own / generators,
        })
    };
    cells.into_iter().map(row).collect()
}

/// Share of the campaigns of a kind, by what is measured, in which something is said about the data.
pub(super) fn flags(outcomes: &[Outcome]) -> Value {
    let mut shares: BTreeMap<String, (f64, f64)> = BTreeMap::new();
    for outcome in outcomes {
        let share = shares.entry(format!("{}, {}", outcome.kind.name(), outcome.sensors.name())).or_default();
        share.0 += f64::from(u8::from(outcome.flagged));
        share.1 += 1.0;
    }
    shares.into_iter().map(|(kind, (flagged, all))| (kind, flagged / all)).collect()
}

/// The table for people.
pub(super) fn summary(rows: &[Value], outcomes: &[Outcome]) -> String {
    let number = |row: &Value, key: &str| row[key].as_f64().unwrap_or(f64::NAN);
    let percent = |row: &Value, key: &str| format!("{:.2}", 100.0 * number(row, key));
    let word = |row: &Value, key: &str| row[key].as_str().unwrap_or_default().to_owned();
    let columns: [report::Column<'_, &Value>; 9] = [
        ("flow", &|row| word(row, "flow")),
        ("quantity", &|row| word(row, "quantity")),
        ("measured", &|row| word(row, "sensors")),
        ("predictions", &|row| row["count"].to_string()),
        ("held by 90 % (%)", &|row| format!("{:.1}", 100.0 * number(row, "held"))),
        ("rms error (%)", &|row| percent(row, "rms_error")),
        ("theory's (%)", &|row| percent(row, "rms_error_of_theory")),
        ("half width (%)", &|row| percent(row, "half_width")),
        ("score over the generator's", &|row| {
            format!("{:.2}", number(row, "interval_score_over_generators"))
        }),
    ];
    format!("{}\nsomething is said about the data: {}\n", report::Table::of(rows, &columns), flags(outcomes))
}
