//! The wing flown through all of a campaign's points and runs, with any effects.

use crate::data::Dataset;
use crate::load_model::{LoadModel, Models};
use crate::model_form::{LatticeVariant, matched, picked};
use crate::rules::{Rules, VariantRules};
use aero::{Corrections, Flow};
use calibrate::Schedule;
use coupling::{CouplingError, ElasticWing, Mount, WingFile};
use maneuver::effects::{Active, Flown, Model, Stimulus, fly, fly_beside, fly_first};
use maneuver::rom::{ReducedOrderModel, StiffnessParts};
use maneuver::{AirModel, DeflectionCorrection, Rig, RigError, RigSettings, SharedAir};
use nastran::InputError;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, OnceLock};

/// Why a wing cannot be flown through a campaign.
#[derive(Debug, thiserror::Error)]
pub enum SimulatorError {
    /// A file is wrong.
    #[error(transparent)]
    Input(#[from] InputError),
    /// The rig cannot be set up.
    #[error(transparent)]
    Rig(#[from] RigError),
    /// The wing cannot be solved.
    #[error(transparent)]
    Wing(#[from] CouplingError),
}

/// See the module.
#[derive(Debug)]
pub struct Simulator {
    /// The wing at every airspeed of the data set.
    pub rigs: Vec<ReducedOrderModel>,
    /// As [`Dataset::stimuli`] has them: airspeed and stimulus.
    stimuli: Vec<(usize, Stimulus)>,
    /// Directions of corrections with which a model-form variant has the static loads of the own.
    matched: Vec<Active>,
    runs: AtomicUsize,
}

/// A wing's rig with its stiffness in parts: what does not depend on a campaign.
#[derive(Debug)]
pub struct SplitRig<'a> {
    file: &'a WingFile,
    wing: &'a ElasticWing,
    rig: Rig<'a>,
    parts: Option<StiffnessParts>,
    /// Boxes whose corrections are taken, if they are another wing's.
    boxes: Option<&'a [usize]>,
}

impl<'a> SplitRig<'a> {
    /// Sets up the rig: modes, and the doublet lattice's table.
    ///
    /// # Errors
    /// If the modes do not converge or the lattice cannot be solved.
    pub fn new(
        file: &'a WingFile,
        wing: &'a ElasticWing,
        air: AirModel,
        rules: &VariantRules,
    ) -> Result<Self, SimulatorError> {
        Self::in_air(file, wing, air, rules, None)
    }

    /// The same with a doublet lattice that other rigs use, too, if it is the wing's own.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn in_air(
        file: &'a WingFile,
        wing: &'a ElasticWing,
        air: AirModel,
        rules: &VariantRules,
        shared: Option<&SharedAir>,
    ) -> Result<Self, SimulatorError> {
        let settings = RigSettings { modes: rules.modes, air, ..RigSettings::of_wing(file) };
        let rig = Rig::in_air(wing, settings, shared)?;
        let parts = StiffnessParts::new(&rig, &file.bulk(Mount::Tunnel)?)?;
        Ok(Self { file, wing, rig, parts, boxes: None })
    }

    /// The same wing in other air.
    ///
    /// # Errors
    /// If the lattice cannot be solved.
    pub fn in_other_air(&self, air: AirModel, shared: Option<&SharedAir>) -> Result<Self, SimulatorError> {
        let rig = self.rig.in_other_air(air, shared)?;
        Ok(Self { file: self.file, wing: self.wing, rig, parts: self.parts.clone(), boxes: self.boxes })
    }

    /// Sets up the rig of a wing on another lattice.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn on_lattice(
        other: &'a LatticeVariant,
        air: AirModel,
        rules: &VariantRules,
    ) -> Result<Self, SimulatorError> {
        Ok(Self { boxes: Some(&other.boxes), ..Self::new(&other.file, &other.wing, air, rules)? })
    }

    /// Names of the wing's controls.
    pub fn controls(&self) -> Vec<String> {
        self.wing.controls.iter().map(|control| control.name.clone()).collect()
    }

    /// The wing's file.
    pub fn file(&self) -> &'a WingFile {
        self.file
    }

    /// The wing.
    pub fn wing(&self) -> &'a ElasticWing {
        self.wing
    }
}

impl Simulator {
    /// The wing with corrections at the airspeeds of a data set.
    ///
    /// # Errors
    /// If the wing diverges at one of them.
    pub fn new(rig: &SplitRig<'_>, schedule: &Schedule, data: &Dataset) -> Result<Self, SimulatorError> {
        let SplitRig { file, wing, rig, parts, boxes } = rig;
        let at = |v_m_s: &f64| -> Result<ReducedOrderModel, SimulatorError> {
            let flow = Flow { v_m_s: *v_m_s, rho_kg_m3: data.rho_kg_m3 };
            let corrections = match boxes {
                _ if *v_m_s == 0.0 => Corrections::neutral(wing.correctable.len()),
                None => corrections(schedule, *v_m_s),
                Some(boxes) => picked(&corrections(schedule, *v_m_s), boxes),
            };
            Ok(ReducedOrderModel::new(rig, flow, &corrections, parts.as_ref())?)
        };
        let rigs = data.airspeeds_m_s.par_iter().map(at).collect::<Result<Vec<_>, _>>()?;
        let names: Vec<String> = wing.controls.iter().map(|control| control.name.clone()).collect();
        let deflection = DeflectionCorrection::new(file.deflection.clone());
        let commanded = |airspeed: usize, stimulus: &Stimulus| -> Result<(usize, Stimulus), SimulatorError> {
            let mut stimulus = stimulus.clone();
            let v_m_s = data.airspeeds_m_s[airspeed];
            if v_m_s > 0.0 {
                let at = deflection.at(v_m_s)?;
                for (name, values) in names.iter().zip(&mut stimulus.inputs.controls_rad) {
                    *values = at.acting(name, values);
                }
            }
            Ok((airspeed, stimulus))
        };
        let stimuli = data
            .stimuli()
            .map(|(airspeed, stimulus)| commanded(airspeed, stimulus))
            .collect::<Result<_, _>>()?;
        Ok(Self { rigs, stimuli, matched: Vec::new(), runs: AtomicUsize::new(0) })
    }

    /// The same, with the static loads of another simulator: calibrated as that one is.
    #[must_use]
    pub fn matching(self, own: &Self, rules: &Rules) -> Self {
        let pairs = self.rigs.par_iter().zip(&own.rigs).filter(|(rig, _)| rig.flow.v_m_s > 0.0);
        let matched = pairs.filter_map(|(rig, own)| matched(rules, rig, own)).collect();
        Self { matched, ..self }
    }

    /// Effects beside those that make the static loads agree.
    fn with_matched(&self, effects: &[Active]) -> Vec<Active> {
        self.matched.iter().chain(effects).cloned().collect()
    }

    /// How often all was flown so far.
    pub fn count(&self) -> usize {
        self.runs.load(Ordering::Relaxed)
    }
}

impl LoadModel for Simulator {
    fn models(&self, effects: &[Active], before: Option<&Models>) -> Models {
        let effects = &self.with_matched(effects);
        let part = |(i, rig): (usize, &ReducedOrderModel)| {
            let before = before.map(|models| &models.parts[i]).filter(|part| part.serves(rig, effects));
            before.map_or_else(|| Arc::new(Model::whole(rig, effects)), Arc::clone)
        };
        Models {
            parts: self.rigs.par_iter().enumerate().map(part).collect(),
            flights: self.stimuli.iter().map(|_| OnceLock::new()).collect(),
        }
    }

    fn fly(&self, models: &Models, effects: &[Active], wanted: &[usize]) -> Vec<Flown> {
        self.runs.fetch_add(1, Ordering::Relaxed);
        let effects = &self.with_matched(effects);
        let one = |&place: &usize| {
            let (airspeed, stimulus) = &self.stimuli[place];
            let (rig, part) = (&self.rigs[*airspeed], &models.parts[*airspeed]);
            if let Some(before) = models.flights[place].get() {
                return fly_beside(rig, part, effects, stimulus, before);
            }
            let (flown, flight) = fly_first(rig, part, effects, stimulus);
            // who flew it at the same time flew the same
            let _ = models.flights[place].set(flight);
            flown
        };
        side_by_side(wanted, one)
    }

    fn flown(&self, effects: &[Active], before: Option<&Models>, wanted: &[usize]) -> Vec<Flown> {
        self.runs.fetch_add(1, Ordering::Relaxed);
        let effects = &self.with_matched(effects);
        let mut airspeeds: Vec<usize> = wanted.iter().map(|place| self.stimuli[*place].0).collect();
        airspeeds.sort_unstable();
        airspeeds.dedup();
        let part = |airspeed: usize| {
            let rig = &self.rigs[airspeed];
            let serves =
                before.map(|before| &before.parts[airspeed]).filter(|part| part.serves(rig, effects));
            (airspeed, serves.map_or_else(|| Arc::new(Model::new(rig, effects, None)), Arc::clone))
        };
        let parts: BTreeMap<usize, Arc<Model>> = airspeeds.into_par_iter().map(part).collect();
        let one = |&place: &usize| {
            let (airspeed, stimulus) = &self.stimuli[place];
            let (rig, part) = (&self.rigs[*airspeed], &parts[airspeed]);
            match before.and_then(|before| before.flights[place].get()) {
                Some(before) => fly_beside(rig, part, effects, stimulus, before),
                None => fly(rig, part, effects, stimulus),
            }
        };
        side_by_side(wanted, one)
    }
}

/// Flies places on all threads, some at a time: a thread's waking costs more than a short run.
fn side_by_side(wanted: &[usize], one: impl Fn(&usize) -> Flown + Sync + Send) -> Vec<Flown> {
    wanted.par_iter().with_min_len(4).map(one).collect()
}

/// Corrections at an airspeed. A run outside of the calibrated airspeeds still tells of effects: the nearest set is taken,
/// and said.
fn corrections(schedule: &Schedule, v_m_s: f64) -> Corrections {
    let (corrections, said) = schedule.at_or_nearest(v_m_s);
    if let Some(said) = said {
        tracing::warn!("{said}");
    }
    corrections
}
