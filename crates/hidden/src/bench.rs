//! The benchmark's bench: one truth geometry, whose expensive parts are computed once and shared by all cases.

use crate::air::StripAir;
use crate::detect::{Loads, Metric, clean};
use crate::effects::Effect;
use crate::jitter::{self, Jitter};
use crate::modal::ModalStructure;
use crate::physics::Physics;
use crate::simulate::TrueWing;
use crate::strips::Strips;
use crate::system::Parts;
use crate::truth_wing::{elements, file, same_beam, wing};
use coupling::planform::Planform;
use nastran::InputError;
use rayon::prelude::*;
use std::path::Path;
use std::sync::OnceLock;
use tunnel::TunnelError;

/// How fine the truth is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fineness {
    /// Boxes along the chord over the model's.
    pub chordwise: f64,
    /// Strips over the model's.
    pub spanwise: f64,
    /// Modes, all of them moving.
    pub modes: usize,
}

impl Fineness {
    /// That of the benchmark: 1.9 times the model's boxes, more modes than the model keeps.
    pub const BENCHMARK: Self = Self { chordwise: 4.0 / 3.0, spanwise: 10.0 / 7.0, modes: 26 };
    /// Coarse and quick, for tests of the machinery: not a truth.
    pub const TEST: Self = Self { chordwise: 0.67, spanwise: 0.25, modes: 10 };
}

/// See the module.
#[derive(Debug)]
pub struct Bench {
    pub(crate) parts: Parts,
    /// Names of the control surfaces.
    pub controls: Vec<String>,
    /// Number of boxes of the true lattice.
    pub boxes: usize,
    damping_ratio: f64,
    metric: OnceLock<Metric>,
    /// The tunnel of the second truth, if cases are flown there.
    pub(crate) vortices: Option<truth::Tunnel>,
}

impl Bench {
    /// Builds the truth of a wing's file: lattice, doublet lattice, modes.
    ///
    /// # Errors
    /// A file that cannot be read, or a wing that is a deck or rigid.
    pub fn new(path: &Path, fineness: Fineness) -> Result<Self, TunnelError> {
        let (file, planform) = file(path)?;
        let fine = planform.mesh(fineness.chordwise, fineness.spanwise);
        let truth = wing(path, fine, same_beam(elements(&planform), file.damping_ratio))?;
        let true_planform: Planform = truth.file.planform().cloned().unwrap_or(planform.clone());
        let axis_m = file.pitch_axis_x();
        let structure = ModalStructure::new(path, &planform, &truth.wing, axis_m, fineness.modes)?;
        let strips = Strips::new(&truth.wing, &true_planform, &structure)?;
        let air = StripAir::new(&truth.wing, &strips, axis_m, planform.mean_chord_m())
            .map_err(coupling::CouplingError::from)?;
        let (modal_rows, balance_rows) = strips.gather(&structure);
        Ok(Self {
            controls: truth.wing.controls.iter().map(|control| control.name.clone()).collect(),
            boxes: truth.wing.lattice.len(),
            damping_ratio: file.damping_ratio,
            metric: OnceLock::new(),
            vortices: None,
            parts: Parts {
                structure,
                strips,
                air,
                modal_rows,
                balance_rows,
                gravity_m_s2: truth.wing.gravity_m_s2,
            },
        })
    }

    /// Cases are flown by the program of vortices (`truth`) from here on; plans, sizes and detectabilities stay those of this one.
    ///
    /// # Errors
    /// A wing that program cannot fly.
    pub fn with_vortices(mut self, path: &Path) -> Result<Self, InputError> {
        self.vortices = Some(crate::vortices::tunnel(path)?);
        Ok(self)
    }

    /// Natural frequencies of the unchanged true structure, rad/s.
    pub fn omega_rad_s(&self) -> &[f64] {
        &self.parts.structure.omega_rad_s
    }

    /// The wing as lattice and beam are.
    pub(crate) fn neutral(&self) -> Physics {
        let parts = &self.parts;
        Physics::neutral(&parts.structure, &parts.strips, self.controls.len(), self.damping_ratio)
    }

    /// The wing of a jitter at an airspeed, before effects.
    pub(crate) fn jittered(&self, jitter: &Jitter, v_m_s: f64) -> Physics {
        let mut physics = self.neutral();
        jitter.apply(&self.parts.strips, v_m_s, &mut physics);
        physics
    }

    /// Noise-free training loads of a jittered wing with effects.
    pub(crate) fn clean_loads(&self, jitter: &Jitter, effects: &[Effect]) -> Loads {
        let physics = |v_m_s: f64| self.jittered(jitter, v_m_s);
        let wing = TrueWing { parts: &self.parts, jittered: &physics, effects, servo: jitter.servo() };
        clean(&wing, &self.controls)
    }

    /// What differences are measured with; computed when it is first needed.
    pub(crate) fn metric(&self) -> &Metric {
        self.metric.get_or_init(|| {
            let middle = self.clean_loads(&Jitter::none(), &[]);
            let off = |parameter: usize| self.clean_loads(&Jitter::unit(parameter), &[]);
            let jittered: Vec<Loads> = (0..jitter::COUNT).into_par_iter().map(off).collect();
            Metric::new(&middle, &jittered, &self.controls)
        })
    }
}
