//! Declared maneuvers flown with the initial and the updated model; part of `simulate`.

use std::path::PathBuf;

use aero::{Corrections, Flow};
use maneuver::growth::growing;
use maneuver::{DeflectionAt, ManeuverFile, Motion, Rig, RigSettings, Run, Simulated, fly_commanded};
use nastran::InputError;
use rayon::prelude::*;

use crate::commands::simulate_effects::WingEffects;
use crate::commands::simulate_flown::{Flown, at_airspeed};
use crate::corrections::CorrectedWing;
use crate::failure::Failure;

/// Reads maneuvers and checks them against the wing, before anything is computed with them.
pub(crate) fn read(
    files: &[PathBuf],
    corrected: &CorrectedWing,
) -> Result<Vec<(ManeuverFile, Vec<String>)>, Failure> {
    let controls = corrected.wing.control_names();
    let checked = |path: &PathBuf| {
        let file = ManeuverFile::read(path)?;
        let remarks = file.checked(&corrected.file, &controls)?;
        Ok((file, remarks))
    };
    files.iter().map(checked).collect::<Result<_, InputError>>().map_err(Failure::from)
}

/// Flies them with the rigs of the initial and of the updated model: one of each for each actuator.
pub(crate) fn fly(
    maneuvers: &[(ManeuverFile, Vec<String>)],
    bases: [&Rig<'_>; 2],
    settings: &RigSettings,
    corrected: &CorrectedWing,
    effects: &WingEffects,
) -> Result<Vec<Flown>, Failure> {
    let [given, updated] = bases;
    let mut rigs: Vec<(RigSettings, Rig<'_>, Option<Rig<'_>>)> = Vec::new();
    for (file, _) in maneuvers {
        let own = file.settings(settings);
        if own != *settings && !rigs.iter().any(|(known, ..)| *known == own) {
            let is_other = !std::ptr::eq(given, updated);
            let found = is_other.then(|| Rig::new(updated.wing(), own.clone())).transpose()?;
            rigs.push((own.clone(), Rig::new(given.wing(), own)?, found));
        }
    }
    let flown = |(file, remarks): &(ManeuverFile, Vec<String>)| {
        let own = file.settings(settings);
        let known = rigs.iter().find(|(known, ..)| *known == own);
        let rigs = known.map_or(bases, |(_, given, found)| [given, found.as_ref().unwrap_or(given)]);
        fly_one(file, remarks.clone(), rigs, corrected, effects)
    };
    maneuvers.par_iter().map(flown).collect()
}

fn fly_one(
    file: &ManeuverFile,
    mut remarks: Vec<String>,
    [given, rig]: [&Rig<'_>; 2],
    corrected: &CorrectedWing,
    effects: &WingEffects,
) -> Result<Flown, Failure> {
    let flow = Flow { v_m_s: file.v_m_s, rho_kg_m3: file.rho_kg_m3 };
    let (corrections, deflection) = at_airspeed(&file.path, file.v_m_s, corrected)?;
    let neutral = Corrections::neutral(corrected.wing.correctable.len());
    let initial = given.at(flow, &neutral)?;
    let updated = rig.at(flow, &corrections)?;
    for (model, name) in [(&initial, "initial"), (&updated, "updated")] {
        remarks.extend(growing(model).map(|growing| format!("{name} model at {} m/s {growing}", file.v_m_s)));
    }
    let motion = file.motion(&updated);
    for (control, commanded) in updated.controls.iter().zip(&motion.controls_rad) {
        remarks.extend(deflection.beyond(control, commanded).map(|beyond| beyond.to_string()));
    }
    let mut flown = fly_commanded(&updated, &motion, &deflection);
    if let Some(effects) = effects.at(rig, flow, &corrections)? {
        let acting = updated.controls.iter().zip(&motion.controls_rad);
        let controls_rad = acting.map(|(name, commanded)| deflection.acting(name, commanded)).collect();
        effects.add(&Motion { controls_rad, ..motion.clone() }, &mut flown);
    }
    let simulated = |history| Simulated { history, residual_rms: None, residual_percent: None };
    let run = Run {
        name: file.name(),
        t_s: file.times(),
        time_step_s: motion.time_step_s,
        v_m_s: file.v_m_s,
        alpha_rad: motion.alpha.value.clone(),
        loads: None,
        some_loads: [None, None, None],
        controls_rad: updated.controls.iter().cloned().zip(motion.controls_rad.iter().cloned()).collect(),
        tip_z_m: None,
        accelerations: Vec::new(),
    };
    Ok(Flown {
        file: file.path.clone(),
        initial: simulated(fly_commanded(&initial, &motion, &DeflectionAt::default())),
        updated: simulated(flown),
        as_commanded: None,
        run,
        remarks,
        spread: None,
    })
}
