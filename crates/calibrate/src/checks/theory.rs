//! What is further from theory than panel models are, and what a campaign leaves open.

use super::finding::Finding;
use super::lines::{Line, Lines};
use crate::campaign::{Campaign, Sets, TipReading};
use aero::flow::same_airspeed;
use coupling::{ByLoad, Load, RootLoads};

/// Measured over theory's lift slope that panel models of attached flow are off by.
const LIFT: std::ops::Range<f64> = 0.85..1.15;
/// The same of the arm of lift along the span.
const ARM: std::ops::Range<f64> = 0.9..1.1;

/// Lift slope and arm of the lift, all airspeeds together, where they are far from theory's.
pub(super) fn far_from_theory(lines: &[Lines]) -> Vec<Finding> {
    let mut found = Vec::new();
    let median = |of: &dyn Fn(&Lines) -> f64| {
        let mut values: Vec<f64> = lines.iter().map(of).collect();
        values.sort_by(f64::total_cmp);
        values.get(values.len() / 2).copied().filter(|value| value.is_finite())
    };
    let ByLoad { fz, mx, .. } = lines.first().map_or(ByLoad::default(), |line| line.channels);
    let load = if fz { Load::Fz } else { Load::Mx };
    if !fz && !mx {
        return found;
    }
    if let Some(lift) =
        median(&|l| l.measured[load].slope / l.theory[load].slope).filter(|lift| !LIFT.contains(lift))
    {
        found.push(Finding::suspicion(format!(
            "loads grow with the angle {lift:.2} times as much as theory says: the lift slope, or a dynamic pressure {:+.0} % off \
             (airspeed {:+.0} %); static cases do not tell them apart",
            100.0 * (lift - 1.0),
            100.0 * (lift.abs().sqrt() - 1.0),
        )));
    }
    let arm = |line: &ByLoad<Line>| line.mx.slope / line.fz.slope;
    let arm_ratio = median(&|l| arm(&l.measured) / arm(&l.theory)).filter(|ratio| !ARM.contains(ratio));
    if let Some(ratio) = arm_ratio.filter(|_| fz && mx) {
        let theory_m = median(&|l| arm(&l.theory)).unwrap_or_default();
        let measured_m = ratio * theory_m;
        found.push(Finding::open(format!(
            "lift by the angle acts {measured_m:.3} m from the balance's axis, {theory_m:.3} m by theory: the spanwise lift, the \
             place of the balance, or the span; root loads do not tell them apart"
        )));
    }
    found
}

/// Load at zero angle that the weight explains as well as camber does, where no row at V = 0 tells them apart.
pub(super) fn weight_or_camber(weight: RootLoads, campaign: &Campaign, lines: &[Lines]) -> Option<Finding> {
    let wind_off = campaign.points.iter().any(|point| point.is_tare(&campaign.sensors));
    let slowest = lines.first().filter(|line| line.channels.fz && !wind_off)?;
    let less_n = slowest.theory.fz.at_zero - slowest.measured.fz.at_zero;
    let weight_n = -weight.fz_n;
    let is_alike = weight_n > 0.0 && less_n > 0.5 * weight_n && less_n < 1.5 * weight_n;
    is_alike.then(|| {
        Finding::suspicion(format!(
            "at {} m/s and zero angle Fz_N is {less_n:.1} N less than theory: the wing's weight ({weight_n:.1} N) that was not tared, \
             or a zero-lift angle {:+.2} degrees off; rows at V_m_s = 0 would tell them apart",
            slowest.v_m_s,
            (less_n / slowest.theory.fz.slope).to_degrees(),
        ))
    })
}

/// Columns that are not there or not used, and what stays at theory for it.
pub(super) fn not_told(campaign: &Campaign) -> Vec<Finding> {
    let missing = [
        ("Fz_N", "the lift is known from its moments only"),
        ("Mx_Nm", "where the lift acts along the span stays at theory"),
        ("My_Nm", "where the lift acts along the chord, moment factors and twist stay at theory"),
    ];
    let mut found: Vec<Finding> = missing
        .iter()
        .zip(campaign.channels)
        .filter(|(_, is_there)| !is_there)
        .map(|((name, open), _)| Finding::open(format!("the static cases have no {name}: {open}")))
        .collect();
    let further = || campaign.points.iter().filter(|point| point.says_more(&campaign.sensors));
    if campaign.sets == Sets::Common && further().next().is_some() {
        found.push(Finding::open(
            "sensors and rows with a control deflected are not used: campaign.ron asks for one set of corrections for all airspeeds"
                .to_owned(),
        ));
    }
    let is_neutral = |v_m_s: f64| {
        let mut rows = campaign.points.iter().filter(|point| point.controls_rad.is_empty());
        rows.any(|point| same_airspeed(point.v_m_s, v_m_s))
    };
    let alone = further().filter(|point| point.v_m_s > 0.0 && !is_neutral(point.v_m_s)).count();
    if alone > 0 {
        found.push(Finding::open(format!(
            "{alone} rows with a control deflected are not used: there are no rows with neutral controls at their airspeed"
        )));
    }
    if campaign.tip == TipReading::Unused && campaign.points.iter().any(|point| point.tip_z_m.is_some()) {
        found.push(Finding::open(
            "tip_z_m of the static cases is not used: `tip: FreeZero` in campaign.ron fits it, and bending along the span is then \
             measured"
                .to_owned(),
        ));
    }
    found
}

#[cfg(test)]
mod tests;
