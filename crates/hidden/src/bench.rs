//! The benchmark's bench: one truth geometry, whose expensive parts are computed once and shared by all cases.

use crate::air::StripAir;
use crate::modal::ModalStructure;
use crate::physics::Physics;
use crate::strips::Strips;
use crate::system::Parts;
use crate::truth_wing::{elements, file, mesh, same_beam, wing};
use coupling::planform::Planform;
use std::path::Path;
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
}

impl Bench {
    /// Builds the truth of a wing's file: lattice, doublet lattice, modes.
    ///
    /// # Errors
    /// A file that cannot be read, or a wing that is a deck or rigid.
    pub fn new(path: &Path, fineness: Fineness) -> Result<Self, TunnelError> {
        let (file, planform) = file(path)?;
        let fine = mesh(&planform, (fineness.chordwise, fineness.spanwise));
        let truth = wing(path, fine, same_beam(elements(&planform), file.damping_ratio))?;
        let true_planform: Planform = truth.file.planform().cloned().unwrap_or(planform.clone());
        let axis_m = file.pitch_axis_x();
        let structure = ModalStructure::new(path, &planform, (&truth.wing, axis_m), fineness.modes)?;
        let strips = Strips::new(&truth.wing, &true_planform, &structure)?;
        let air = StripAir::new(&truth.wing, &strips, axis_m, planform.mean_chord_m())
            .map_err(coupling::CouplingError::from)?;
        let (modal_rows, balance_rows) = strips.gather(&structure);
        Ok(Self {
            controls: truth.wing.controls.iter().map(|control| control.name.clone()).collect(),
            boxes: truth.wing.lattice.len(),
            damping_ratio: file.damping_ratio,
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

    /// Natural frequencies of the unchanged true structure, rad/s.
    pub fn omega_rad_s(&self) -> &[f64] {
        &self.parts.structure.omega_rad_s
    }

    /// The wing as lattice and beam are.
    pub(crate) fn neutral(&self) -> Physics {
        let parts = &self.parts;
        Physics::neutral(&parts.structure, &parts.strips, self.controls.len(), self.damping_ratio)
    }
}

#[cfg(test)]
mod probe {
    use super::*;
    use crate::design;
    use crate::jitter::Jitter;
    use crate::simulate::{Commands, TrueWing};
    use std::time::Instant;

    #[test]
    fn probe() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex/wing_beam.ron");
        let start = Instant::now();
        let bench = Bench::new(&path, Fineness::BENCHMARK).unwrap();
        println!("bench {:.1} s, {} boxes, {} strips", start.elapsed().as_secs_f64(), bench.boxes, bench.parts.strips.len());
        println!("Hz {:?}", bench.omega_rad_s().iter().map(|o| (o / 6.283_185_3 * 100.0).round() / 100.0).collect::<Vec<_>>());
        let jitter = Jitter::none();
        let strips = &bench.parts.strips;
        let jittered = |v: f64| { let mut p = bench.neutral(); jitter.apply(strips, v, &mut p); p };
        let effects = Vec::new();
        let wing = TrueWing { parts: &bench.parts, jittered: &jittered, effects: &effects, servo: jitter.servo() };
        let start = Instant::now();
        let speeds: Vec<_> = design::STATIC_AIRSPEEDS_M_S.iter().map(|v| wing.at(*v)).collect();
        println!("at speeds {:.2} s", start.elapsed().as_secs_f64());
        for at in &speeds {
            let e = at.linear.a.eigenvalues().unwrap();
            let worst = e.iter().map(|z| z.re).fold(f64::MIN, f64::max);
            print!("{} m/s {} states, largest re {worst:.3}:", at.v_m_s, at.linear.a.nrows());
            for a in [-4.0_f64, 0.0, 8.0] {
                let f = wing.fly(at, &Commands::steady(a.to_radians(), 3), (0.0, 0));
                print!("  {a}: {:.2} {:.2} {:.2} tip {:.4}", f.loads[0][0], f.loads[1][0], f.loads[2][0], f.tip_z_m[0]);
            }
            println!();
        }
        let start = Instant::now();
        let mut steps = 0;
        for run in design::runs(&bench.controls) {
            let at = speeds.iter().find(|at| at.v_m_s == run.v_m_s).unwrap();
            let f = wing.fly(at, &Commands::of(&run, 3), (0.0, 0));
            steps += f.tip_z_m.len();
            let ends = |v: &[f64]| (v.iter().copied().fold(f64::MAX, f64::min), v.iter().copied().fold(f64::MIN, f64::max));
            println!("{} {:.1?} {:.1?} {:.1?}", run.name, ends(&f.loads[0]), ends(&f.loads[1]), ends(&f.loads[2]));
        }
        println!("runs {:.2} s, {steps} steps", start.elapsed().as_secs_f64());
    }
}
