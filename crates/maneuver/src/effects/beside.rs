//! What effects add to a rig's flight: the reduced-order model flown with them less the same model flown without, put on
//! the histories of the rig itself. So a wing without effects flies as the rig does, bit for bit.

use super::active::Active;
use super::flight::fly;
use super::model::{Model, Stimulus};
use super::place::Inputs;
use crate::history::TimeHistory;
use crate::rig::{Rig, RigError};
use crate::rig_model::Motion;
use crate::rom::{ReducedOrderModel, StiffnessParts};
use aero::{Corrections, Flow};
use nastran::BulkData;

/// Channels that effects change, in the order of [`super::Flown`].
const CHANNELS: [&str; 4] = ["Fz_N", "Mx_Nm", "My_Nm", "tip_z_m"];

/// Effects at one flow, ready to fly.
#[derive(Debug, Clone)]
pub struct Beside {
    rom: ReducedOrderModel,
    with: Model,
    plain: Model,
    effects: Vec<Active>,
}

impl Beside {
    /// The effects on a rig whose structure is `bulk`; none if there are no effects.
    ///
    /// # Errors
    /// As [`ReducedOrderModel::new`] and [`StiffnessParts::new`].
    pub fn new(
        rig: &Rig<'_>,
        flow: Flow,
        corrections: &Corrections,
        effects: &[Active],
        bulk: &BulkData,
    ) -> Result<Option<Self>, RigError> {
        if effects.is_empty() {
            return Ok(None);
        }
        let split = effects.iter().any(|active| active.effect.splits_stiffness());
        let parts = if split { StiffnessParts::new(rig, bulk)? } else { None };
        let rom = ReducedOrderModel::new(rig, flow, corrections, parts.as_ref())?;
        Ok(Some(Self {
            with: Model::new(&rom, effects, None),
            plain: Model::new(&rom, &[], None),
            effects: effects.to_vec(),
            rom,
        }))
    }

    /// Adds to the loads of the balance and the tip's height what the effects make of a motion, whose controls are those
    /// that act. Loads at stations, of strips and accelerations stay as they are.
    pub fn add(&self, motion: &Motion, history: &mut TimeHistory) {
        let stimulus = Stimulus {
            inputs: Inputs {
                alpha: motion.alpha.clone(),
                incidence_rad: vec![0.0; motion.alpha.value.len()],
                controls_rad: motion.controls_rad.clone(),
            },
            time_step_s: motion.time_step_s,
            steady: false,
            clock_h: 0.0,
        };
        let with = fly(&self.rom, &self.with, &self.effects, &stimulus);
        let plain = fly(&self.rom, &self.plain, &[], &stimulus);
        let changed = with.loads.iter().chain([&with.tip_m]);
        let plain = plain.loads.iter().chain([&plain.tip_m]);
        for (name, (with, plain)) in CHANNELS.iter().zip(changed.zip(plain)) {
            let Some(channel) = history.channels.iter_mut().find(|channel| channel.name == *name) else {
                continue;
            };
            for (value, (with, plain)) in channel.values.iter_mut().zip(with.iter().zip(plain)) {
                *value += with - plain;
            }
        }
    }
}
