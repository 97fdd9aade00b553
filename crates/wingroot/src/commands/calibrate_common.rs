//! What `calibrate` says and draws of one set of corrections for all airspeeds.

use aero::{Corrections, Flow};
use calibrate::campaign::{CHANNELS, TIP};
use calibrate::{Calibration, CommonCalibration, LiftFactor};
use coupling::{SteadyCase, SteadyModel};
use report::{Figure, Panel, Series, Style};

use crate::commands::calibrate_model::Fitted;
use crate::commands::calibrate_numbers::{identifiability, speed_name};
use crate::commands::calibrate_result::{
    CommonResult, LiftFactorResult, MeanForceFactor, TipZeroResult, TrendResult,
};
use crate::commands::result_parts::Channels;
use crate::failure::Failure;

/// The set in `result.json`.
pub(crate) fn result(common: &CommonCalibration, calibration: &Calibration) -> CommonResult {
    let (fit, measured) = (&common.fit, calibration.data.channels);
    let told = common.identifiability.as_ref();
    CommonResult {
        v_m_s: common.v_range_m_s,
        rows: common.rows,
        objective_before: fit.objective[0],
        objective_after: fit.objective[1],
        curve_floor: common.curve_floor,
        weights: Channels::of(common.weights, measured),
        iterations: fit.cone_programs,
        ending: format!("{:?}", fit.ending),
        rmse_before: Channels::of(fit.rmse[0], measured),
        rmse_after: Channels::of(fit.rmse[1], measured),
        curve_rmse: Channels::of(common.curve_rmse, measured),
        point_sigma: Channels::of(common.point_sigma, measured),
        lift_factor: common.lift.as_ref().map(|found| lift_factor(found, calibration)),
        mean_force_factor: MeanForceFactor {
            value: common.mean_force_factor,
            sigma_if_the_distribution_is_free: told.map(|told| told.mean_force_sigma[1]),
            sigma_before_the_data: told.map(|told| told.mean_force_sigma[0]),
        },
        determined_directions: told.map(|told| told.determined_directions),
        neighbour_bound_active: fit.neighbour_bound_active,
        identifiability: told.map(|told| identifiability(told, measured)),
    }
}

/// The uniform factor on lift in `result.json`.
pub(crate) fn lift_factor(found: &LiftFactor, calibration: &Calibration) -> LiftFactorResult {
    let tip_zeros = found
        .tip_zeros
        .iter()
        .enumerate()
        .map(|(block, &(tip_zero_m, sigma_m))| TipZeroResult {
            block: calibration.data.block_names.get(block).cloned(),
            tip_zero_m,
            sigma_m,
        })
        .collect();
    LiftFactorResult {
        value: found.factor,
        sigma: found.sigma,
        correlation_of_rows: found.correlation,
        rmse: Channels::of(found.rmse, calibration.data.channels),
        change_up_to_largest_deflection: found.trend.map(|(value, sigma)| TrendResult { value, sigma }),
        tip_zeros,
    }
}

/// The table for the terminal.
pub(crate) fn table(common: &CommonCalibration, calibration: &Calibration) -> String {
    let head = ["V (m/s)", "rows", "F before", "F after", "curve floor", "programs", "lift factor", "ending"];
    let mut table = report::Table::new(&head);
    let [slow, fast] = common.v_range_m_s;
    table.row([
        format!("{slow:.1} to {fast:.1}"),
        common.rows.to_string(),
        format!("{:.4}", common.fit.objective[0]),
        format!("{:.4}", common.fit.objective[1]),
        format!("{:.4}", common.curve_floor),
        common.fit.cone_programs.to_string(),
        common
            .lift
            .as_ref()
            .map_or_else(|| "-".into(), |found| format!("{:.3} +- {:.3}", found.factor, found.sigma)),
        format!("{:?}", common.fit.ending),
    ]);
    let mut lines = vec![table.to_string()];
    for (block, (zero_m, sigma_m)) in common.lift.iter().flat_map(|found| found.tip_zeros.iter().enumerate())
    {
        let name = match calibration.data.block_names.get(block).map(String::as_str) {
            None | Some("") => String::new(),
            Some(name) => format!(" of block {name}"),
        };
        lines.push(format!("zero of the tip reading{name}: {:.1} +- {:.1} mm", 1e3 * zero_m, 1e3 * sigma_m));
    }
    if let Some(told) = &common.identifiability {
        let [before, after] = told.mean_force_sigma;
        lines.push(format!(
            "area-weighted force factor {:.3}; were its distribution free, {after:.2} uncertain ({before:.2} before the data); \
             directions determined: {}",
            common.mean_force_factor, told.determined_directions
        ));
    }
    lines.join("\n") + "\n"
}

/// Measured readings, zeros taken out, and the model's over the airspeed, a panel for each channel.
///
/// # Errors
/// If the wing diverges.
pub(crate) fn figure(
    wing: &Fitted<'_>,
    common: &CommonCalibration,
    calibration: &Calibration,
) -> Result<Figure, Failure> {
    let rows: Vec<_> = calibration
        .data
        .airspeeds
        .iter()
        .flat_map(|a| a.angles.iter().map(|angle| (a.v_m_s, angle)))
        .collect();
    let zeros = common.lift.as_ref().map_or(&[][..], |found| &found.tip_zeros);
    let neutral = Corrections::neutral(wing.correctable().len());
    let readings = |corrections: &Corrections| -> Result<Vec<[f64; 4]>, Failure> {
        rows.iter()
            .map(|&(v_m_s, angle)| {
                let flow = Flow { v_m_s, rho_kg_m3: calibration.rho_kg_m3 };
                let case = SteadyCase::new(flow, angle.alpha_rad);
                Ok(wing.solve(&[case], corrections)?[0].readings())
            })
            .collect()
    };
    let (initial, updated) = (readings(&neutral)?, readings(&common.corrections)?);
    let airspeeds: Vec<f64> = rows.iter().map(|row| row.0).collect();
    let mut panels = Vec::new();
    for c in (0..4).filter(|&c| calibration.data.channels[c]) {
        let of = |values: &[[f64; 4]]| values.iter().map(|value| value[c]).collect::<Vec<f64>>();
        let measured = rows.iter().map(|(_, angle)| {
            let zero = if c == TIP { zeros.get(angle.block).map_or(0.0, |zero| zero.0) } else { 0.0 };
            angle.readings()[c] - zero
        });
        let series =
            |name: &str, values: Vec<f64>| Series::new(name, airspeeds.clone(), values, Style::Points);
        panels.push(Panel::new(
            "",
            "airspeed (m/s)",
            CHANNELS[c],
            vec![
                series("measured", measured.collect()),
                series("initial", of(&initial)),
                series("updated", of(&updated)),
            ],
        ));
    }
    let [slow, fast] = common.v_range_m_s.map(speed_name);
    Ok(Figure::new(format!("One set of corrections, {slow} to {fast} m/s"), panels, 1))
}
