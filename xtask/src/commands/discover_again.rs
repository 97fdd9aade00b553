//! Corrections calibrated again with the effects in the model, as later steps of `discover`'s results have them.
//!
//! What effects do to static points is taken off the measurements, and what is left is calibrated. That depends on the
//! corrections themselves (a balance that bends bends the load there is), so it is done until it changes no more: with
//! one step alone an effect that bends the lift by a tenth leaves a hundredth of the lift, ten times the noise.

use calibrate::{Campaign, Schedule, Settings, calibrate};
use discover::analysis::{DiscoverError, Prepared, Rigs};
use discover::load_model::LoadModel;
use discover::simulator::Simulator;
use maneuver::effects::Active;

use crate::commands::discover::{held_out_points, leave_out};
use crate::corrections::{CorrectedWing, schedule};
use crate::failure::Failure;

/// Calibrations at most.
const MOST: usize = 8;
/// The loads of effects stay if they change by less than this of a static point's noise.
const SAME: f64 = 0.1;

/// See the module.
pub(crate) struct Again {
    /// The corrections, for the wing without the effects in its file.
    pub(crate) schedule: Schedule,
    /// The wing with them.
    pub(crate) simulator: Simulator,
}

/// Calibrates with effects in the model.
pub(crate) fn calibrated(
    (corrected, rigs): (&CorrectedWing, &Rigs<'_>),
    campaign: &Campaign,
    prepared: &Prepared,
    effects: &[Active],
) -> Result<Again, Failure> {
    let settings = Settings::of_wing(&corrected.file.correction);
    let mut loads = of_effects(&prepared.simulator, prepared, effects);
    let mut found = None;
    for _ in 0..MOST {
        let left = without(campaign, prepared, &loads);
        let schedule = schedule(&corrected.file, &calibrate(&corrected.wing, &left, &settings)?);
        let simulator = Simulator::new(&rigs.own, &schedule, &prepared.data).map_err(DiscoverError::from)?;
        let new = of_effects(&simulator, prepared, effects);
        let moved = loads
            .iter()
            .flatten()
            .zip(new.iter().flatten())
            .any(|(old, new)| (0..3).any(|c| (new[c] - old[c]).abs() > SAME * prepared.noise.point[c]));
        loads = new;
        found = Some(Again { schedule, simulator });
        if !moved {
            break;
        }
    }
    found.ok_or_else(|| Failure::Computation("nothing was calibrated".to_owned()))
}

/// What effects add to Fz, Mx, My of every point of every static group.
fn of_effects(simulator: &Simulator, prepared: &Prepared, effects: &[Active]) -> Vec<Vec<[f64; 3]>> {
    let groups: Vec<usize> = (0..prepared.data.statics.len()).collect();
    let with = simulator.fly(&simulator.models(effects, None), effects, &groups);
    let plain = simulator.fly(&simulator.models(&[], None), &[], &groups);
    let point =
        |with: &[Vec<f64>; 3], plain: &[Vec<f64>; 3], i: usize| [0, 1, 2].map(|c| with[c][i] - plain[c][i]);
    with.iter()
        .zip(&plain)
        .map(|(with, plain)| (0..with.loads[0].len()).map(|i| point(&with.loads, &plain.loads, i)).collect())
        .collect()
}

/// The campaign with these loads taken off, and without the points of held-out airspeeds.
fn without(campaign: &Campaign, prepared: &Prepared, loads: &[Vec<[f64; 3]>]) -> Campaign {
    let mut campaign = campaign.clone();
    for (group, loads) in prepared.data.statics.iter().zip(loads) {
        for (&point, loads) in group.points.iter().zip(loads) {
            for (load, effect) in campaign.points[point].loads.iter_mut().zip(loads) {
                if let Some(load) = load {
                    *load -= effect;
                }
            }
        }
    }
    leave_out(&mut campaign, &held_out_points(&prepared.data));
    campaign
}
