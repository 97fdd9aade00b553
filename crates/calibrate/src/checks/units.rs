//! Units of a campaign that were probably mistaken: warnings, as the numbers could be meant.
//!
//! A load grows with the angle of attack by q times a slope that any lattice gives within some tens of percent, less where
//! flow separates. So a measured slope over the model's that is 57.3, a thousandth or a twelfth, in two loads alike, is
//! no aerodynamics: the angle was in radians, the loads in kN, the airspeed in km/h. The same for the tip's height.
//! Only slopes that stand clear of their scatter speak.

use crate::campaign::Campaign;
use crate::statics::{AirspeedData, StaticData};
use aero::{Corrections, Flow};
use coupling::{CouplingError, SteadyCase, SteadyModel};

/// Density of gases that wings are tested in, kg/m^3: thin air up to pressurised nitrogen.
const DENSITIES_KG_M3: std::ops::Range<f64> = 0.02..30.0;
/// Measured over modelled slopes that need no explanation: separated flow, poor models, strong corrections.
const PLAUSIBLE: std::ops::Range<f64> = 0.2..5.0;
/// A factor is taken for another within this one.
const NEAR: f64 = 1.8;
/// A slope speaks if the load's change over the angles is this many times its scatter about a straight line.
const CLEAR: f64 = 5.0;

/// What a factor between measured and modelled slopes means, by what it is a factor of.
const LOADS: [(f64, &str); 5] = [
    (57.3, "are the angles of attack in radians instead of degrees?"),
    (1e-3, "are the loads in kN and kN m instead of N and N m?"),
    (1e3, "are the loads in mN and N mm instead of N and N m, or the wing's lengths in other units?"),
    (1.0 / 12.96, "are airspeeds in km/h instead of m/s, or loads in kg instead of N?"),
    (1.0 / 57.3, "is the angle of attack converted to degrees twice?"),
];
const MOMENT_ALONE: [(f64, &str); 2] = [
    (1e3, "is the moment in N mm instead of N m, or its arm in millimetres?"),
    (1e-3, "is the moment in kN m instead of N m?"),
];
const TIP_ALONE: [(f64, &str); 2] = [
    (1e3, "is the tip's height in millimetres instead of metres?"),
    (1e-3, "is the tip's height in kilometres?"),
];

/// Sentences about units of a campaign that were probably mistaken.
///
/// # Errors
/// If the wing cannot be solved.
pub(super) fn of_campaign<M: SteadyModel>(
    model: &M,
    campaign: &Campaign,
    data: &StaticData,
) -> Result<Vec<String>, CouplingError> {
    let mut found = Vec::new();
    let rho = campaign.rho_kg_m3;
    if !DENSITIES_KG_M3.contains(&rho) {
        found.push(format!(
            "rho_kg_m3 is {rho}, which is no gas that wings are tested in (air at sea level has 1.225): is it in g/m3 or g/cm3?"
        ));
    }
    let mut ratios: [Vec<f64>; 4] = std::array::from_fn(|_| Vec::new());
    for airspeed in &data.airspeeds {
        for (all, ratio) in ratios.iter_mut().zip(slope_ratios(model, rho, airspeed, data)?) {
            all.extend(ratio);
        }
    }
    let [fz, mx, my, tip] = ratios.map(median);
    let mut say =
        |what: &str, ratio: f64, table: &[(f64, &'static str)]| {
            let said = meaning(table, ratio);
            found.extend(said.map(|said| {
                format!("{what} with the angle {ratio:.3} times as much as the model says: {said}")
            }));
        };
    let other = if mx.is_some() { mx } else { my };
    if let Some((a, b)) = fz.zip(other).filter(|(a, b)| near(a / b, 1.0)) {
        say("loads change", (a * b).abs().sqrt().copysign(a), &LOADS);
    } else {
        if let Some(ratio) = fz {
            say("Fz_N changes", ratio, &LOADS);
        }
        // a sign of its own is judged with the other channels: see `causes`
        if let Some(ratio) = mx.filter(|ratio| *ratio > 0.0) {
            say("Mx_Nm changes", ratio, &MOMENT_ALONE);
        }
    }
    if let Some(ratio) = tip {
        say("tip_z_m changes", ratio, &TIP_ALONE);
    }
    Ok(found)
}

/// What a factor probably means; nothing if it needs no explanation.
fn meaning(table: &[(f64, &'static str)], ratio: f64) -> Option<&'static str> {
    if PLAUSIBLE.contains(&ratio) {
        return None;
    }
    if ratio < 0.0 {
        return PLAUSIBLE.contains(&-ratio).then_some("has it, or the angle of attack, the opposite sign?");
    }
    let known = table.iter().find(|(factor, _)| near(ratio, *factor));
    Some(known.map_or(
        "a factor that no unit explains; look at the wing's size, the air's density and the units",
        |(_, said)| said,
    ))
}

fn near(a: f64, b: f64) -> bool {
    (1.0 / NEAR..NEAR).contains(&(a / b))
}

fn median(mut values: Vec<f64>) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied()
}

/// Measured over modelled slopes of Fz, Mx, My and the tip's height at one airspeed, where they speak.
fn slope_ratios<M: SteadyModel>(
    model: &M,
    rho_kg_m3: f64,
    airspeed: &AirspeedData,
    data: &StaticData,
) -> Result<[Option<f64>; 4], CouplingError> {
    let flow = Flow { v_m_s: airspeed.v_m_s, rho_kg_m3 };
    let neutral = Corrections::neutral(model.correctable().len());
    let cases = [-0.01, 0.01].map(|alpha_rad| SteadyCase::new(flow, alpha_rad));
    let loads = model.root_loads(&cases, &neutral)?;
    let tips = if data.channels[3] { model.tip_deflections(&cases, &neutral)? } else { vec![0.0; 2] };
    let arm_m = model_arm(&loads);
    Ok(std::array::from_fn(|c| {
        let modelled = match c {
            3 => tips[1] - tips[0],
            _ => loads[1].to_array()[c] - loads[0].to_array()[c],
        } / 0.02;
        // A pitching moment about a point near the centre of lift is small and says nothing.
        let small = c == 2 && modelled.abs() < 0.1 * arm_m * (loads[1].fz_n - loads[0].fz_n).abs() / 0.02;
        if !data.channels[c] || modelled == 0.0 || small {
            return None;
        }
        Some(clear_slope(airspeed, c)? / modelled)
    }))
}

/// The arm of the lift along the span, m.
fn model_arm(loads: &[coupling::RootLoads]) -> f64 {
    ((loads[1].mx_nm - loads[0].mx_nm) / (loads[1].fz_n - loads[0].fz_n)).abs()
}

/// Slope of a channel by the angle of attack, per rad, by least squares, if it stands clear of the scatter.
fn clear_slope(airspeed: &AirspeedData, channel: usize) -> Option<f64> {
    let points: Vec<(f64, f64)> =
        airspeed.angles.iter().map(|angle| (angle.alpha_rad, angle.readings()[channel])).collect();
    let n = points.len() as f64;
    let (x_mean, y_mean) = points.iter().fold((0.0, 0.0), |(x, y), point| (x + point.0 / n, y + point.1 / n));
    let sxx: f64 = points.iter().map(|(x, _)| (x - x_mean).powi(2)).sum();
    let sxy: f64 = points.iter().map(|(x, y)| (x - x_mean) * (y - y_mean)).sum();
    if points.len() < 3 || sxx <= 0.0 {
        return None;
    }
    let slope = sxy / sxx;
    let scatter = points.iter().map(|(x, y)| (y - y_mean - slope * (x - x_mean)).powi(2)).sum::<f64>();
    (slope * slope * sxx > CLEAR * CLEAR * scatter).then_some(slope)
}

#[cfg(test)]
mod tests;
