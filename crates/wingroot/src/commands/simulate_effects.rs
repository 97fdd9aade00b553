//! The effects of a wing's file in `simulate`: which fly, and what they add to the updated model.

use std::path::Path;

use aero::{Corrections, Flow};
use coupling::Mount;
use maneuver::effects::{Active, Beside, of_wing, without};
use maneuver::{DeflectionAt, Motion, Rig, RigError, RigModel, Run, Simulated, motion_of};
use nastran::{BulkData, InputError};

use crate::commands::simulate_result::EffectResult;
use crate::corrections::CorrectedWing;

/// The effects of a wing that fly.
pub(crate) struct WingEffects {
    active: Vec<Active>,
    off: Vec<String>,
    bulk: BulkData,
}

/// Those of a wing's file without the ones switched off.
pub(crate) fn of(corrected: &CorrectedWing, off: &[String]) -> Result<WingEffects, InputError> {
    let controls = corrected.wing.control_names();
    let active = without(&of_wing(&corrected.file, &controls)?, off)?;
    Ok(WingEffects { active, off: off.to_vec(), bulk: corrected.file.bulk(Mount::Tunnel)? })
}

impl WingEffects {
    /// At a flow; none if no effect flies.
    pub(crate) fn at(
        &self,
        rig: &Rig<'_>,
        flow: Flow,
        corrections: &Corrections,
    ) -> Result<Option<Beside>, RigError> {
        Beside::new(rig, flow, corrections, &self.active, &self.bulk)
    }

    /// What the user should know.
    pub(crate) fn remarks(&self) -> Vec<String> {
        let named = |active: &Active| active.effect.spec().name;
        let mut remarks = Vec::new();
        if !self.active.is_empty() {
            let names: Vec<&str> = self.active.iter().map(named).collect();
            remarks.push(format!(
                "the updated model flies with the wing's effects {}: they change Fz, Mx, My and the tip, not loads at \
                 stations or accelerations",
                names.join(", ")
            ));
        }
        if !self.off.is_empty() {
            remarks.push(format!("switched off: {}", self.off.join(", ")));
        }
        remarks
    }

    /// Those that fly and those switched off, as a result has them; none if the wing has none.
    pub(crate) fn result(&self) -> Option<(Vec<EffectResult>, Vec<String>)> {
        let each = |active: &Active| {
            let listed = active.to_wing();
            let parameters = listed.parameters.into_iter().collect();
            EffectResult { name: listed.name, form: listed.form, parameters }
        };
        let any = !self.active.is_empty() || !self.off.is_empty();
        any.then(|| (self.active.iter().map(each).collect(), self.off.clone()))
    }
}

/// A run flown without effects, with what they add.
pub(crate) fn added(
    effects: &Beside,
    plain: Simulated,
    run: &Run,
    file: &Path,
    model: &RigModel,
    deflection: &DeflectionAt,
) -> Result<Simulated, InputError> {
    let motion = motion_of(run, model, file)?;
    let acting = model.controls.iter().zip(&motion.controls_rad);
    let controls_rad = acting.map(|(name, commanded)| deflection.acting(name, commanded)).collect();
    let mut history = plain.history;
    effects.add(&Motion { controls_rad, ..motion }, &mut history);
    Ok(Simulated::of(run, history, model))
}
