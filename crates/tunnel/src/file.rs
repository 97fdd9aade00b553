//! The file of the virtual wind tunnel: what it measures, with what noise, and the truth it hides.

use crate::run_file::{Dynamics, RunPlan};
use calibrate::Noise;
use coupling::ByLoad;
use coupling::planform::Mesh;
use coupling::wing_file::DeflectionTable;
use maneuver::motion::ANGLE;
use nastran::{InputError, ron_file};
use schemars::JsonSchema;
use serde::Deserialize;
use std::path::{Path, PathBuf};

/// What the tunnel measures and hides.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename = "Tunnel")]
pub struct TunnelFile {
    /// Name of the campaign.
    pub name: String,
    /// Wing file of the model that will be calibrated, relative to this file; the truth starts from it.
    pub wing: String,
    /// Seed of all random numbers, unless the command line gives one.
    pub seed: u64,
    /// Air density, kg/m³.
    pub rho_kg_m3: f64,
    /// Whether the sections follow the curvature of the viscous polars, or straight lines through them.
    pub curvature: bool,
    /// How the truth differs from the wing file.
    pub truth: TruthSettings,
    /// Static cases.
    pub statics: Statics,
    /// Declared (and true) noise.
    pub noise: Noise<ByLoad<f64>>,
    /// How runs are measured; needed only for runs.
    #[serde(default)]
    pub dynamics: Option<Dynamics>,
    /// Runs in time.
    #[serde(default)]
    pub runs: Vec<RunPlan>,
    /// How the runs are split into training and held-out ones, in words, for the campaign's README.
    #[serde(default)]
    pub split: Option<String>,
    /// The file as it was named when read.
    #[serde(skip)]
    pub path: PathBuf,
}

/// How the truth differs from the wing file; everything left out is as in the wing file.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TruthSettings {
    /// Another lattice.
    #[serde(default)]
    pub mesh: Option<Mesh>,
    /// Another beam.
    #[serde(default)]
    pub beam: Option<BeamChange>,
    /// Section aerodynamics that thin-airfoil theory does not have.
    #[serde(default)]
    pub sections: Option<Sections>,
}

/// A beam with other numbers: factors at root and tip, linear between.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BeamChange {
    /// Number of elements.
    pub elements: usize,
    /// Factor of the bending stiffness EI (flap and lag).
    pub bending: (f64, f64),
    /// Factor of the torsional stiffness GJ.
    pub torsion: (f64, f64),
    /// Factor of distributed mass and inertia.
    pub mass: (f64, f64),
    /// Elastic axis further aft by this share of the chord.
    pub axis_aft_over_c: f64,
    /// Centre of gravity of the distributed mass further aft by this share of the chord.
    pub mass_aft_over_c: f64,
    /// Modal damping ratio.
    pub damping_ratio: f64,
}

/// Values at leading and trailing edge, at root and tip.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Corners {
    /// Root, leading and trailing edge.
    pub root: (f64, f64),
    /// Tip, leading and trailing edge.
    pub tip: (f64, f64),
}

impl Corners {
    /// The value at `eta` (0 root, 1 tip) and `xi` (0 leading edge, 1 trailing edge): linear along the chord,
    /// with `eta^power` along the span.
    pub fn at(&self, eta: f64, xi: f64, power: f64) -> f64 {
        let along = |ends: (f64, f64)| ends.0 + xi * (ends.1 - ends.0);
        along(self.root) + eta.powf(power) * (along(self.tip) - along(self.root))
    }
}

/// What real sections do.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sections {
    /// Viscous polars of the section: `V_mps,Re,alpha_deg,cl,cd,cm_c4`.
    pub polars: String,
    /// Share of the polars' change with Reynolds number that enters (1 all, 0 none).
    pub polar_share: f64,
    /// Airspeed at which, with the mean chord, the polars change nothing.
    pub reference_v_m_s: f64,
    /// Angles between which straight lines are laid through the polars, degrees.
    pub angles_in_use_deg: (f64, f64),
    /// Force factor at all airspeeds.
    pub force_factor: Corners,
    /// Power of the span in `force_factor`.
    pub force_power: f64,
    /// What changes with airspeed, ascending; linear between, constant outside.
    pub by_airspeed: Vec<AirspeedSections>,
}

/// The part of the sections' behaviour that is given airspeed by airspeed.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AirspeedSections {
    /// Airspeed.
    #[serde(rename = "V_m_s")]
    pub v_m_s: f64,
    /// Factor of the boxes' own moment at root and tip.
    pub moment_factor: (f64, f64),
    /// Pressure coefficient added at every angle.
    pub pressure_offset: Corners,
}

/// Static cases to measure.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Statics {
    /// Airspeeds.
    pub airspeeds_m_s: Vec<f64>,
    /// Angles of attack.
    pub angles_deg: Vec<f64>,
    /// Days with their number of replicates of every point.
    pub blocks: Blocks,
    /// Angles of the wind-off weight tares, measured once a block.
    pub tilt_deg: Vec<f64>,
    /// One standard deviation of the tip's height, m.
    pub tip_z_sigma_m: f64,
}

/// Blocks of measurements.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Blocks {
    /// Name and number of replicates of each.
    pub replicates: Vec<(String, usize)>,
    /// One standard deviation of a block's offset, common to all its wind-on points.
    pub offset_sigma: ByLoad<f64>,
}

impl TunnelFile {
    /// Reads and checks a tunnel file.
    ///
    /// # Errors
    /// A missing or misspelt field, a number that cannot be: with file and, where known, line.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let mut file: Self = ron_file::read(path)?;
        file.path = path.to_path_buf();
        for run in &mut file.runs {
            run.motion.complete(run.alpha_deg.to_radians(), path)?;
        }
        match file.fault() {
            None => Ok(file),
            Some((what, help)) => Err(InputError::in_file(path, what).with_help(help)),
        }
    }

    /// A file named in this one.
    pub(crate) fn beside(&self, name: &str) -> PathBuf {
        self.path.parent().unwrap_or_else(|| Path::new("")).join(name)
    }

    /// The first number that cannot be, with what to do about it.
    fn fault(&self) -> Option<(String, &'static str)> {
        let statics = &self.statics;
        let positive = |value: &f64| value.is_finite() && *value > 0.0;
        let Noise { sample, static_point } = self.noise;
        let offsets = statics.blocks.offset_sigma;
        let rules = [
            (
                positive(&self.rho_kg_m3),
                "rho_kg_m3 must be a positive number",
                "air at sea level has 1.225 kg/m3",
            ),
            (
                statics.airspeeds_m_s.iter().all(positive),
                "airspeeds_m_s must be positive",
                "V = 0 rows come from tilt_deg",
            ),
            (
                statics.angles_deg.iter().chain(&statics.tilt_deg).all(|angle| angle.abs() <= 30.0),
                "an angle is beyond 30 degrees",
                "the model is linear in the angle of attack",
            ),
            (
                sample.iter().chain(static_point.iter()).all(positive),
                "noise must be positive standard deviations",
                "write small numbers for a quiet balance",
            ),
            (
                sample.iter().chain(static_point.iter()).chain(offsets.iter()).all(|s| *s <= 1e6),
                "a standard deviation is beyond a million",
                "loads are in N and N m",
            ),
            (
                offsets.iter().chain([&statics.tip_z_sigma_m]).all(|s| s.is_finite() && *s >= 0.0),
                "a standard deviation is negative or not a number",
                "zero is allowed here",
            ),
        ];
        let broken = rules.into_iter().find(|(holds, ..)| !holds);
        let fault = broken.map(|(_, what, help)| (what.to_owned(), help));
        fault.or_else(|| self.size_fault()).or_else(|| self.run_fault()).or_else(|| self.section_fault())
    }

    /// The first thing about runs that cannot be.
    fn run_fault(&self) -> Option<(String, &'static str)> {
        if self.runs.is_empty() {
            return None;
        }
        let Some(dynamics) = self.dynamics.as_ref().filter(|dynamics| dynamics.sample_rate_hz > 0.0) else {
            let what = "runs need `dynamics` with a positive sample_rate_hz";
            return Some((what.into(), "see the shipped file"));
        };
        if let Some(complaint) = dynamics.deflection.iter().find_map(DeflectionTable::complaint) {
            return Some((complaint, "a table is that of a wing's file"));
        }
        for run in &self.runs {
            let motion = &run.motion;
            let flies = motion.of.is_some() && (!motion.moves(ANGLE) || motion.kind().has_derivatives());
            if let Some(fault) = motion.fault(dynamics.sample_rate_hz) {
                return Some((format!("{}: {}", run.file, fault.message), fault.help));
            } else if !flies {
                let what =
                    format!("{}: {} of the angle has no smooth acceleration", run.file, motion.shape.name());
                return Some((what, "move a control surface so, or let the angle move smoothly"));
            }
        }
        let days = &self.statics.blocks.replicates;
        let unknown = |block: &String| !days.iter().any(|(day, _)| day == block);
        if let Some(block) =
            self.runs.iter().filter_map(|run| run.block.as_ref()).find(|block| unknown(block))
        {
            return Some((
                format!("no block of the static cases is called {block}"),
                "runs share the days' offsets",
            ));
        }
        let named = |file: &String| self.runs.iter().any(|run| run.file == *file);
        let lost = self.runs.iter().filter_map(|run| run.repeat_of.as_ref()).find(|file| !named(file));
        lost.map(|file| (format!("no run is called {file}, which another repeats"), "give a run's file name"))
    }

    /// The first thing about sections that cannot be.
    fn section_fault(&self) -> Option<(String, &'static str)> {
        let sections = self.truth.sections.as_ref()?;
        let rising = sections.by_airspeed.windows(2).all(|pair| pair[0].v_m_s < pair[1].v_m_s);
        if sections.by_airspeed.is_empty() || !rising {
            return Some((
                "by_airspeed must list ascending airspeeds".into(),
                "at least one entry is needed",
            ));
        }
        let (low, high) = sections.angles_in_use_deg;
        if !(low < high && sections.reference_v_m_s > 0.0 && sections.force_power > 0.0) {
            return Some((
                "angles_in_use_deg must rise, reference_v_m_s and force_power be positive".into(),
                "see the comments in the shipped file",
            ));
        }
        None
    }
}
