//! Units of a run that were probably mistaken: a warning, as the numbers could be meant.
//!
//! What moves in a run changes the loads, in the measurement and in the model, by amounts that are alike within a factor
//! of a few. If lift and bending moment both change 57.3 times as much as in the model, the angles were in radians;
//! a thousandth: the loads were in kN.

use crate::run::Run;
use crate::simulate::Simulated;

/// A factor is taken for another within this one.
const NEAR: f64 = 1.8;

/// A sentence about the units of a run, if both its lift and its bending moment speak.
pub fn of_run(run: &Run, simulated: &Simulated) -> Option<String> {
    let measured = run.loads.as_ref()?;
    if run.v_m_s == 0.0 {
        return None;
    }
    let ratio = |c: usize| {
        let model = simulated.history.get(["Fz_N", "Mx_Nm"][c])?;
        Some(variation(&measured[c]) / variation(model)).filter(|ratio| ratio.is_finite() && *ratio > 0.0)
    };
    let (fz, mx) = (ratio(0)?, ratio(1)?);
    let near = |a: f64, b: f64| (1.0 / NEAR..NEAR).contains(&(a / b));
    if !near(fz, mx) {
        return None;
    }
    let both = (fz * mx).sqrt();
    let said = [
        (57.3, "are its angles in radians instead of degrees?"),
        (1e-3, "are its loads in kN and kN m instead of N and N m?"),
        (1e3, "are its loads in mN and N mm instead of N and N m?"),
    ];
    let (_, question) = said.into_iter().find(|(factor, _)| near(both, *factor))?;
    Some(format!("loads change {both:.3} times as much as in the model: {question}"))
}

/// Root mean square distance from the mean.
fn variation(values: &[f64]) -> f64 {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    (values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / values.len() as f64).sqrt()
}

#[cfg(test)]
mod tests;
