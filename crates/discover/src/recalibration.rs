//! Corrections calibrated again with the effects in the model.
//!
//! What effects do to static points is taken off the measurements, and what is left is calibrated. That depends on the
//! corrections themselves (a balance that bends bends the load there is), so it is done until it changes no more: with
//! one step alone an effect that bends the lift by a tenth leaves a hundredth of the lift, ten times the noise.

use crate::analysis::{DiscoverError, Prepared, Rigs};
use crate::data::Dataset;
use crate::load_model::LoadModel;
use crate::simulator::Simulator;
use calibrate::{Campaign, Schedule, Use};
use coupling::{ByLoad, Load};
use maneuver::effects::Active;

/// See the module.
#[derive(Debug)]
pub struct Recalibrated {
    /// The corrections, for the wing without the effects in its file.
    pub schedule: Schedule,
    /// The wing with them.
    pub simulator: Simulator,
}

/// Calibrates with effects in the model; `calibrate` makes corrections from a campaign's static points.
///
/// # Errors
/// Those of `calibrate`, and of a wing that cannot be flown with the corrections.
pub fn recalibrated<E: From<DiscoverError>>(
    rigs: &Rigs<'_>,
    campaign: &Campaign,
    prepared: &Prepared,
    effects: &[Active],
    calibrate: impl Fn(&Campaign) -> Result<Schedule, E>,
) -> Result<Recalibrated, E> {
    let rules = &rigs.rules.verdict;
    let mut loads = of_effects(&prepared.simulator, prepared, effects);
    let mut calibrations = 0;
    loop {
        calibrations += 1;
        let schedule = calibrate(&without(campaign, &prepared.data, &loads))?;
        let simulator = Simulator::new(&rigs.own, &schedule, &prepared.data).map_err(DiscoverError::from)?;
        let new = of_effects(&simulator, prepared, effects);
        let moved = |old: &ByLoad<f64>, new: &ByLoad<f64>| {
            let by =
                |load| (new[load] - old[load]).abs() > rules.calibrated_same * prepared.noise.point[load];
            Load::ALL.into_iter().any(by)
        };
        // points of held-out airspeeds are not calibrated with, and do not say when that is done either
        let groups = prepared.data.statics.iter().zip(loads.iter().zip(&new));
        let moved = groups
            .filter(|(group, _)| group.usage == Use::Train)
            .any(|(_, (old, new))| old.iter().zip(new).any(|(old, new)| moved(old, new)));
        if !moved || calibrations >= rules.calibrations {
            return Ok(Recalibrated { schedule, simulator });
        }
        loads = new;
    }
}

/// What effects add to Fz, Mx, My of every point of every static group.
fn of_effects(simulator: &Simulator, prepared: &Prepared, effects: &[Active]) -> Vec<Vec<ByLoad<f64>>> {
    let groups: Vec<usize> = (0..prepared.data.statics.len()).collect();
    let with = simulator.flown(effects, None, &groups);
    let plain = simulator.flown(&[], None, &groups);
    let point = |with: &[Vec<f64>; 3], plain: &[Vec<f64>; 3], i: usize| {
        ByLoad::from_fn(|load| with[load as usize][i] - plain[load as usize][i])
    };
    with.iter()
        .zip(&plain)
        .map(|(with, plain)| (0..with.loads[0].len()).map(|i| point(&with.loads, &plain.loads, i)).collect())
        .collect()
}

/// The campaign with these loads taken off, without the points of held-out airspeeds, and without sensors: what effects add to these
/// is not known.
fn without(campaign: &Campaign, data: &Dataset, loads: &[Vec<ByLoad<f64>>]) -> Campaign {
    let mut campaign = campaign.clone();
    campaign.sensors.clear();
    campaign.points.iter_mut().for_each(|point| point.sensors.clear());
    for (group, loads) in data.statics.iter().zip(loads) {
        for (&point, loads) in group.points.iter().zip(loads) {
            for (load, effect) in campaign.points[point].loads.iter_mut().zip(loads.iter()) {
                if let Some(load) = load {
                    *load -= effect;
                }
            }
        }
    }
    without_held_out(&campaign, data).unwrap_or(campaign)
}

/// The campaign without the static points of held-out airspeeds, which must not be calibrated with; none where there are none.
pub fn without_held_out(campaign: &Campaign, data: &Dataset) -> Option<Campaign> {
    let groups = data.statics.iter().filter(|group| group.usage == Use::Holdout);
    let held_out: Vec<usize> = groups.flat_map(|group| group.points.iter().copied()).collect();
    (!held_out.is_empty()).then(|| {
        let mut kept = campaign.clone();
        let mut place = 0..;
        kept.points.retain(|_| place.next().is_some_and(|place| !held_out.contains(&place)));
        kept
    })
}
