//! The benchmark's bench: one truth geometry, whose expensive parts are computed once and shared by all cases.

use crate::air::StripAir;
use crate::detect::{Loads, Metric, clean};
use crate::effects::Effect;
use crate::jitter::Jitter;
use crate::modal::ModalStructure;
use crate::physics::Physics;
use crate::servo::Servo;
use crate::simulate::TrueWing;
use crate::strips::Strips;
use crate::system::Parts;
use crate::truth_wing::{elements, file, same_beam, wing};
use coupling::planform::Planform;
use coupling::wing_file::{KnownTo, Servos};
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
    /// What the wing's file leaves open.
    known_to: KnownTo,
    servos: Servos,
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
            known_to: file.known_to,
            servos: file.servos,
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
        self.clean_loads_with(jitter, jitter.servo(), effects)
    }

    fn clean_loads_with(&self, jitter: &Jitter, servo: Servo, effects: &[Effect]) -> Loads {
        let physics = |v_m_s: f64| self.jittered(jitter, v_m_s);
        clean(&TrueWing { parts: &self.parts, jittered: &physics, effects, servo }, &self.controls)
    }

    /// What differences are measured with; computed when it is first needed.
    pub(crate) fn metric(&self) -> &Metric {
        self.metric.get_or_init(|| {
            let middle = self.clean_loads(&Jitter::none(), &[]);
            let nuisances = Jitter::nuisances(&self.known_to, &self.servos);
            let off = |(jitter, servo): (Jitter, Servo)| self.clean_loads_with(&jitter, servo, &[]);
            let off: Vec<Loads> = nuisances.into_par_iter().map(off).collect();
            Metric::new(&middle, &off, &self.controls)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_servo_within_what_the_wing_s_file_leaves_open_cannot_be_seen_and_one_beyond_can() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex/wing_beam.ron");
        let bench = Bench::new(&path, Fineness::TEST).expect("the shipped wing");
        let middle = bench.clean_loads(&Jitter::none(), &[]);
        let servo = Jitter::none().servo();
        let d2 = |off: f64, damped: f64| {
            let servo = Servo {
                frequency_hz: servo.frequency_hz * (1.0 + off),
                damping_ratio: servo.damping_ratio + damped,
            };
            bench.metric().d2(&bench.clean_loads_with(&Jitter::none(), servo, &[]), &middle)
        };
        // the file knows 15 Hz to one and .8 to .05; one standard deviation of what explains a difference is one at most, and what it does
        // beyond in proportion little more
        for (off, damped) in [(-1.0 / 15.0, 0.0), (1.0 / 15.0, 0.0), (0.0, 0.05), (0.0, -0.05)] {
            let within = d2(off, damped);
            assert!((0.1..4.0).contains(&within), "{off} {damped}: {within}");
            let beyond = d2(6.0 * off, 6.0 * damped);
            assert!(beyond > 20.0, "{off} {damped}: {beyond}");
        }
    }
}
