//! What a fit came to: factors that no panel model is off by, and deflections beyond what is linear.

use super::finding::Finding;
use crate::calibration::Context;
use crate::campaign::TIP;
use crate::common::CommonCalibration;
use crate::statics::{AirspeedData, StaticData};
use aero::Corrections;
use coupling::{CouplingError, SteadyModel};

/// Force factors of panel models in attached flow, box by box, the loads at tips and corners included.
const PLAUSIBLE: std::ops::Range<f64> = 0.3..2.0;
/// Factors this close to the least that is allowed are held by it, as a share of it.
const AT_BOUND: f64 = 1.5;
/// Deflections of the tip over the span that a linear model follows to about a per cent.
const LINEAR: f64 = 0.1;
/// The lift of small and of all deflections differ by so many standard deviations of the former, and by this ...
const DIFFERENT: f64 = 3.0;
/// ... at least.
const LEAST_DIFFERENCE: f64 = 0.03;
/// Rows that a lift factor of small deflections needs.
const LEAST_ROWS: usize = 8;

/// Factors of one set; `at` says whose.
pub(crate) fn factors(corrections: &Corrections, at: &str, least_factor: f64) -> Option<Finding> {
    let ends =
        |values: &[f64]| values.iter().fold([f64::INFINITY, 0.0_f64], |[a, b], w| [a.min(*w), b.max(*w)]);
    let [least, most] = ends(&corrections.force);
    if least <= AT_BOUND * least_factor {
        return Some(Finding::defect(format!(
            "force factors {at} fall to {least:.2}, the least that is allowed: no wing loses so much lift there, so the data are not \
             of this wing as the model has it, or do not determine where the lift acts",
        )));
    }
    let is_plausible = PLAUSIBLE.contains(&least) && PLAUSIBLE.contains(&most);
    (!is_plausible).then(|| {
        Finding::suspicion(format!(
            "force factors {at} are between {least:.2} and {most:.2}: panel models of attached flow are rarely off by more than {} \
             to {} at any box",
            PLAUSIBLE.start, PLAUSIBLE.end,
        ))
    })
}

/// Whether the lift that fits depends on how far the tip deflects, which a linear model does not have.
///
/// # Errors
/// If the wing cannot be solved.
pub(crate) fn deflections<M: SteadyModel>(
    context: &Context<'_, M>,
    set: &CommonCalibration,
) -> Result<Option<Finding>, CouplingError> {
    let data = context.data;
    let Some(lift) = set.lift.as_ref().filter(|_| data.channels[TIP]) else { return Ok(None) };
    let zero_m = |block: usize| lift.tip_zeros.get(block).map_or(0.0, |zero| zero.0);
    let span_m = context.model.correctable().span_m();
    let angles = data.airspeeds.iter().flat_map(|airspeed| &airspeed.angles);
    let most_m = angles.map(|angle| (angle.tip_z_m - zero_m(angle.block)).abs()).fold(0.0, f64::max);
    if most_m < LINEAR * span_m {
        return Ok(None);
    }
    let small = |airspeed: &AirspeedData| {
        let mut airspeed = airspeed.clone();
        airspeed.angles.retain(|angle| (angle.tip_z_m - zero_m(angle.block)).abs() < 0.5 * most_m);
        airspeed
    };
    let mut of_small = StaticData { airspeeds: data.airspeeds.iter().map(small).collect(), ..data.clone() };
    of_small.airspeeds.retain(|airspeed| !airspeed.angles.is_empty());
    if of_small.airspeeds.iter().map(|airspeed| airspeed.angles.len()).sum::<usize>() < LEAST_ROWS {
        return Ok(None);
    }
    let context = Context::new(context.model, context.rho_kg_m3, &of_small, context.settings);
    let Some(first) = context.common_lift()? else { return Ok(None) };
    let difference = (first.factor - lift.factor).abs();
    // the larger set holds the smaller: their difference scatters by no more than the smaller's
    let is_different = difference > DIFFERENT * first.sigma && difference > LEAST_DIFFERENCE;
    Ok(is_different.then(|| {
        Finding::suspicion(format!(
            "the lift factor is {:.3} +- {:.3} of tip deflections below {:.0} % of the span and {:.3} +- {:.3} of all, up to {:.0} %: {}",
            first.factor,
            first.sigma,
            50.0 * most_m / span_m,
            lift.factor,
            lift.sigma,
            100.0 * most_m / span_m,
            if context.model.bends_far() {
                "deflections are large in the model, so it is not they that the factor mends: stall, a stiffness or a reading that \
                 changes"
            } else {
                "a linear model does not have this, so it is the deflection and not the lift that the factor mends; fit small \
                 deflections alone, or write `geometry: Nonlinear` in the wing's file"
            },
        ))
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::finding::Weight;

    #[test]
    fn force_factors_are_judged_by_their_least_and_most() {
        let judged = |force: [f64; 3]| {
            let corrections =
                Corrections { force: force.to_vec(), moment: vec![9.0; 3], pressure_offset: vec![9.0; 3] };
            factors(&corrections, "at 30 m/s", 0.1).map(|found| (found.weight, found.sentence))
        };
        for good in [[1.0, 0.3, 1.9], [1.99, 1.0, 1.0]] {
            assert_eq!(judged(good), None, "{good:?}");
        }
        for odd in [[1.0, 0.29, 1.0], [1.0, 2.0, 1.0], [0.151, 1.0, 2.5]] {
            let (weight, said) = judged(odd).expect("odd");
            let [least, most] = [odd.into_iter().fold(9.0, f64::min), odd.into_iter().fold(0.0, f64::max)];
            assert_eq!(weight, Weight::Suspicion);
            assert!(said.contains(&format!("at 30 m/s are between {least:.2} and {most:.2}")), "{said}");
        }
        for least in [0.149, 0.1] {
            let (weight, said) = judged([1.0, 1.0, least]).expect("held by the least");
            assert_eq!(weight, Weight::Defect);
            assert!(said.contains(&format!("at 30 m/s fall to {least:.2}, the least")), "{said}");
        }
    }
}
