//! The true wing: the wing file's planform with another lattice, another beam and real sections.

use crate::curvature;
use crate::file::TunnelFile;
use crate::sections::SectionModel;
use crate::structure::change_beam;
use aero::{Corrections, Flow};
use coupling::planform::Structure;
use coupling::wing_file::Source;
use coupling::{
    CouplingError, ElasticWing, Geometry, LargeState, LargeWing, Mount, RootLoads, SteadyCase, WingFile,
};
use nastran::InputError;

/// Why the tunnel could not measure.
#[derive(Debug, thiserror::Error)]
pub enum TunnelError {
    /// A file is wrong.
    #[error(transparent)]
    Input(#[from] InputError),
    /// The true wing cannot be solved.
    #[error(transparent)]
    Wing(#[from] CouplingError),
    /// The rig cannot be set up.
    #[error(transparent)]
    Rig(#[from] maneuver::RigError),
    /// The sections' curvature did not settle.
    #[error(
        "the sections at {v_m_s} m/s and {alpha_deg} degrees do not settle: the last step was {step:.1e} rad"
    )]
    Unsettled {
        /// Airspeed.
        v_m_s: f64,
        /// Angle of attack.
        alpha_deg: f64,
        /// Largest change of a section's incidence in the last step, rad.
        step: f64,
    },
}

/// What the balance and the tip would show without noise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrueState {
    /// Root loads.
    pub loads: RootLoads,
    /// Height of the tip above its wind-off place at alpha = 0, m.
    pub tip_z_m: f64,
}

/// The wing in the tunnel.
#[derive(Debug)]
pub struct Truth {
    /// File of the wing as it is modelled by those who calibrate.
    pub baseline_file: WingFile,
    /// The wing file with the truth's lattice, beam and damping.
    pub file: WingFile,
    /// Lattice and structure.
    pub wing: ElasticWing,
    /// Air density, kg/m³.
    pub rho_kg_m3: f64,
    sections: Option<SectionModel>,
    curvature: bool,
    /// The wing that bends far, where the wing file asks for it: its static cases are measured on it.
    bent: Option<LargeWing>,
}

impl Truth {
    /// Builds the true wing.
    ///
    /// # Errors
    /// Bad files, strips that do not fit the control surfaces, a wing that is no parametric one.
    pub fn build(tunnel: &TunnelFile) -> Result<Self, TunnelError> {
        let baseline_file = WingFile::read(&tunnel.beside(&tunnel.wing))?;
        let mut file = baseline_file.clone();
        let Source::Parametric(planform) = &mut file.source else {
            return Err(InputError::in_file(
                &tunnel.path,
                "the wing is a deck; the tunnel needs a parametric wing",
            )
            .with_help("give a wing file with `source: Parametric(...)`")
            .into());
        };
        if let Some(mesh) = &tunnel.truth.mesh {
            planform.remesh(mesh).map_err(|message| InputError::in_file(&tunnel.path, message))?;
        }
        if let (Some(structure), Some(beam)) = (&mut planform.structure, &tunnel.truth.beam) {
            let Structure::Beam(structure) = structure else {
                let message = "the wing is no beam, but `truth: (beam: ...)` changes one";
                return Err(InputError::in_field(&tunnel.path, "beam", message)
                    .with_help("give a wing file with `structure: Beam((...))`")
                    .into());
            };
            structure.elements = beam.elements;
            file.damping_ratio = beam.damping_ratio;
        }
        planform.checked(&tunnel.path)?;
        let is_bent = file.geometry == Geometry::Nonlinear;
        if is_bent && (tunnel.curvature || !tunnel.runs.is_empty()) {
            let message =
                "curved polars and runs in time are of small deflections, and the wing is Nonlinear";
            return Err(InputError::in_file(&tunnel.path, message)
                .with_help("set `curvature: false` and leave `runs` out, or take `geometry` out of the wing")
                .into());
        }
        let mut bulk = file.bulk(Mount::Tunnel)?;
        if let (Some(planform), Some(beam)) = (file.planform(), &tunnel.truth.beam) {
            change_beam(&mut bulk, planform, beam);
        }
        let wing = ElasticWing::from_bulk(&file, &bulk)?;
        let bent = if is_bent { Some(LargeWing::from_bulk(&file, &bulk)?) } else { None };
        let sections = match (&tunnel.truth.sections, file.planform()) {
            (Some(sections), Some(planform)) => Some(SectionModel::new(
                sections,
                &tunnel.beside(&sections.polars),
                &wing,
                planform.mean_chord_m(),
            )?),
            _ => None,
        };
        Ok(Self {
            baseline_file,
            file,
            wing,
            rho_kg_m3: tunnel.rho_kg_m3,
            sections,
            curvature: tunnel.curvature,
            bent,
        })
    }

    /// Whether the static cases are those of the wing that bends far.
    pub fn is_bent(&self) -> bool {
        self.bent.is_some()
    }

    /// What the sections do at an airspeed, as factors and offsets of the true lattice's own boxes (curvature not
    /// included: it is no property of an airspeed alone).
    pub fn corrections(&self, v_m_s: f64) -> Corrections {
        match &self.sections {
            None => Corrections::neutral(self.wing.correctable.len()),
            Some(sections) => sections.corrections(&self.wing, v_m_s),
        }
    }

    /// The wing at an airspeed (zero: weight only) and several angles.
    ///
    /// # Errors
    /// Beyond divergence, or if sections with curvature do not settle.
    pub fn states(&self, v_m_s: f64, alphas_rad: &[f64]) -> Result<Vec<TrueState>, TunnelError> {
        let flow = Flow { v_m_s, rho_kg_m3: self.rho_kg_m3 };
        let corrections = self.corrections(v_m_s);
        let cases: Vec<SteadyCase> = alphas_rad.iter().map(|&alpha| SteadyCase::new(flow, alpha)).collect();
        if let (true, true, Some(sections)) = (self.curvature, v_m_s > 0.0, &self.sections) {
            let solve = |case| curvature::solve(&self.wing, sections, &corrections, case);
            return cases.iter().map(solve).collect();
        }
        if let Some(bent) = &self.bent {
            let states = bent.solve(&cases, &corrections)?;
            let shown = |state: &LargeState| TrueState { loads: state.root, tip_z_m: state.tip_m.z };
            return Ok(states.iter().map(shown).collect());
        }
        let states = self.wing.at(flow, &corrections)?.solve(&cases);
        Ok(states.iter().map(|state| TrueState { loads: state.root, tip_z_m: state.tip_z_m }).collect())
    }
}
