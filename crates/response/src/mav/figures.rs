//! Curves of Figs. 9 to 12 from the published models. The paper does not print every constant of its plots (angle of
//! attack, airspeed), nor are all coefficients printed: what was chosen and what is lacking stands in the notes.

use nastran::InputError;

use super::factor::Condition;
use super::model::{Model, NoValue, Rules, Status};
use super::points::{AIRSPEEDS_M_S, NEGATIVE_ELEVATOR_AIRSPEEDS_M_S, dynamic_pressure_pa};
use super::published::Published;

/// A figure of the paper.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// What it shows, with its number in the paper.
    pub title: String,
    /// Its panels.
    pub panels: Vec<Panel>,
    /// What was assumed, left out or extrapolated; one sentence each.
    pub notes: Vec<String>,
}

/// A panel of curves.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// Abscissa with its unit.
    pub x_label: String,
    /// Ordinate.
    pub y_label: String,
    /// The curves.
    pub curves: Vec<Curve>,
}

/// A curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Its name in the legend.
    pub name: String,
    /// Abscissae.
    pub x: Vec<f64>,
    /// Ordinates.
    pub y: Vec<f64>,
}

/// Numbers of the figures there are.
pub const FIGURES: [u8; 4] = [9, 10, 11, 12];

/// Dynamic pressure where the paper names none, Pa.
const Q_PA: f64 = 60.0;
/// Angle of attack where the paper names none, degrees.
const ALPHA_DEG: f64 = 10.0;

/// The curves of a figure.
///
/// # Errors
/// If there is no such figure, or an equation it needs is not there or has no value.
pub fn figure(published: &Published, number: u8) -> Result<Figure, InputError> {
    match number {
        9 => elevator_and_pressure(published),
        10 => powered_lift(published),
        11 => elevator_and_voltage(published),
        12 => three_voltages(published),
        _ => Err(InputError::general(format!("there are no curves of Fig. {number}; expected 9 to 12"))),
    }
}

fn elevator_and_pressure(published: &Published) -> Result<Figure, InputError> {
    let deltas = steps(-30.0, 0.0);
    let mut notes =
        vec![format!("alpha is taken as {ALPHA_DEG} deg; the paper does not say at which it draws")];
    let mut panels = Vec::new();
    for equation in [8, 9, 10] {
        let model = published.equation(equation, "BR")?;
        let rules = note_missing(model, &mut notes);
        let of = |v_m_s: f64| {
            let state = |delta| Condition::unpowered(dynamic_pressure_pa(v_m_s), ALPHA_DEG, delta);
            curve(published, model, rules, format!("{v_m_s} m/s"), &deltas, state)
        };
        let curves = NEGATIVE_ELEVATOR_AIRSPEEDS_M_S.into_iter().map(of).collect::<Result<_, _>>()?;
        panels.push(panel("delta [deg]", model, curves));
    }
    let title = "Fig. 9: elevator and dynamic pressure, BR wing without propeller (Eqs. 8 to 10)".into();
    Ok(Figure { title, panels, notes })
}

fn powered_lift(published: &Published) -> Result<Figure, InputError> {
    let alphas = steps(4.0, 18.0);
    let mut notes = vec!["delta is 0 and the lift with power is that of Eq. 12 with Eq. 4".to_string()];
    let powered = published.equation(12, "")?;
    let rules = note_missing(powered, &mut notes);
    let at = |v_m_s: f64, alpha: f64| Condition::unpowered(dynamic_pressure_pa(v_m_s), alpha, 0.0);
    let mut curves = Vec::new();
    for v_m_s in AIRSPEEDS_M_S {
        let state = |alpha| at(v_m_s, alpha).at_voltage(7.4);
        curves.push(curve(published, powered, rules, format!("{v_m_s} m/s, 7.4 V"), &alphas, state)?);
    }
    let unpowered = published.equation(5, "PR")?;
    let rules = note_missing(unpowered, &mut notes);
    let name = "13 m/s, no propeller".to_string();
    curves.push(curve(published, unpowered, rules, name, &alphas, |alpha| at(13.0, alpha))?);
    let title = "Fig. 10: lift at four airspeeds, PR wing, 7.4 V (Eq. 12; without propeller Eq. 5)".into();
    Ok(Figure { title, panels: vec![panel("alpha [deg]", powered, curves)], notes })
}

fn elevator_and_voltage(published: &Published) -> Result<Figure, InputError> {
    let mut notes =
        vec![format!("alpha is taken as {ALPHA_DEG} deg and q as {Q_PA} Pa; the paper names neither")];
    let model = published.equation(11, "")?;
    let rules = note_missing(model, &mut notes);
    let of = |voltage: f64| {
        let state = |delta| Condition::unpowered(Q_PA, ALPHA_DEG, delta).at_voltage(voltage);
        curve(published, model, rules, format!("{voltage} V"), &steps(0.0, 30.0), state)
    };
    let curves = [6.6, 7.4].into_iter().map(of).collect::<Result<_, _>>()?;
    let title = "Fig. 11: elevator and motor voltage (Eq. 11)".into();
    Ok(Figure { title, panels: vec![panel("delta [deg]", model, curves)], notes })
}

fn three_voltages(published: &Published) -> Result<Figure, InputError> {
    let mut notes = vec![
        format!("q is taken as {Q_PA} Pa; over alpha delta is 0, over delta alpha is {ALPHA_DEG} deg"),
        "6 and 8 V, which the paper draws, are outside the 6.6 to 7.4 V that Eq. 4 was fitted to".to_string(),
    ];
    let mut panels = Vec::new();
    for equation in [12, 13, 14] {
        let model = published.equation(equation, "")?;
        let rules = note_missing(model, &mut notes).extrapolating();
        let over = |x_label: &str, values: &[f64], state: fn(f64) -> Condition| {
            let of = |voltage: f64| {
                let state = |x| state(x).at_voltage(voltage);
                curve(published, model, rules, format!("{voltage} V"), values, state)
            };
            let curves = [6.0, 7.0, 8.0].into_iter().map(of).collect::<Result<_, NoValue>>()?;
            Ok::<Panel, NoValue>(panel(x_label, model, curves))
        };
        let of_alpha = |alpha| Condition::unpowered(Q_PA, alpha, 0.0);
        panels.push(over("alpha [deg]", &steps(4.0, 18.0), of_alpha)?);
        let of_delta = |delta| Condition::unpowered(Q_PA, ALPHA_DEG, delta);
        panels.push(over("delta [deg]", &steps(-30.0, 30.0), of_delta)?);
    }
    let title = "Fig. 12: with propeller at 6, 7 and 8 V (Eqs. 12 to 14 with Eq. 4)".into();
    Ok(Figure { title, panels, notes })
}

/// Notes what the paper lacks of an equation, and gives rules that leave it out.
fn note_missing(model: &Model, notes: &mut Vec<String>) -> Rules {
    let list = |status: Status| -> String {
        let chosen = model.coefficients.iter().filter(|coefficient| coefficient.status == status);
        chosen.map(|c| format!("{} ({})", c.name, c.term)).collect::<Vec<_>>().join(", ")
    };
    let equation = model.equation;
    let (missing, assumed) = (list(Status::Missing), list(Status::ExponentAssumed));
    if !assumed.is_empty() {
        notes.push(format!("Eq. {equation}: the exponent of {assumed} is assumed"));
    }
    if missing.is_empty() {
        return Rules::STRICT;
    }
    notes.push(format!("Eq. {equation} is drawn without {missing}, of which the paper has no value"));
    Rules::STRICT.leaving_out_missing()
}

/// An equation at the states that belong to some abscissae.
fn curve(
    published: &Published,
    model: &Model,
    rules: Rules,
    name: String,
    over: &[f64],
    state: impl Fn(f64) -> Condition,
) -> Result<Curve, NoValue> {
    let values = over.iter().map(|x| published.value(model, &state(*x), rules));
    Ok(Curve { name, x: over.to_vec(), y: values.collect::<Result<_, _>>()? })
}

fn panel(x_label: &str, model: &Model, curves: Vec<Curve>) -> Panel {
    Panel { x_label: x_label.to_string(), y_label: format!("{} [-]", model.response), curves }
}

/// 29 values from end to end.
fn steps(from: f64, to: f64) -> Vec<f64> {
    (0..=28).map(|k| from + (to - from) * f64::from(k) / 28.0).collect()
}
