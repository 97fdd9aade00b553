//! The wing on its balance in the tunnel, moving: modes, quasi-steady aerodynamics, root loads as a sum of forces.
//!
//! Relative to the pitching support, with the kept modes Phi and the static residual of the others:
//! ```text
//! u   = Phi xi + F_r Gᵀ P + S_r c            F_r = F - Phi Omega⁻² Phiᵀ,  c = (g sin a, -g cos a, -a'')
//! P   = q W S Q (D1 G u + D2 G Phi xi'/V + alpha n_z + (x_j - x_p) n_z alpha'/V + w_camber + w_control) + q S f_e
//! xi'' + 2 zeta Omega xi' + Omega² xi = Phiᵀ (Gᵀ P + M r c)
//! root loads = R P + r_bᵀ M (r c - Phi xi'') - weight(0)
//! ```
//! S_r c is what the truncated modes do statically under the fields of acceleration c (aft, up, nose-up rotation).
//! In steady state nothing depends on the number of modes. Thin here: the air has no memory (its unsteady successor
//! keeps this interface), and the truncated modes have no inertia of their own.

use crate::air::{AirModel, AirParts, RationalAir, SharedAir, UnsteadyAir};
use crate::assemble::assemble;
use crate::load_rows::Station;
use crate::operators::{FIELDS, RigOperators};
use crate::periodic::filtered;
use crate::rig_model::RigModel;
use aero::{Corrections, Flow};
use coupling::wing_file::Servos;
use coupling::{CouplingError, ElasticWing, WingFile};
use faer::c64;
use schemars::JsonSchema;
use serde::Deserialize;
use structure::ModesError;

/// A second-order actuator between commanded and actual deflection.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Actuator {
    /// Natural frequency, Hz.
    pub frequency_hz: f64,
    /// Damping ratio.
    pub damping_ratio: f64,
}

/// How a rig is modelled.
#[derive(Debug, Clone, PartialEq)]
pub struct RigSettings {
    /// Modes kept (all, if the structure has fewer).
    pub modes: usize,
    /// Modal damping, a share of critical.
    pub damping_ratio: f64,
    /// x of the axis the wing is pitched about, m.
    pub pitch_axis_x_m: f64,
    /// Every control's actuator.
    pub actuator: Actuator,
    /// Cutoff of the smoothing of measured inputs and of the filter on loads that are compared, Hz.
    pub cutoff_hz: f64,
    /// Grids whose vertical acceleration is given: name and node index.
    pub sensors: Vec<(String, usize)>,
    /// How the air answers motion.
    pub air: AirModel,
    /// Where loads are given beside the balance.
    pub stations: Vec<Station>,
    /// Whether the lift of every strip is given.
    pub strip_loads: bool,
}

impl Actuator {
    /// Surfaces that follow at once, as far as a state space can have them.
    const AT_ONCE: Self = Self { frequency_hz: 1e4, damping_ratio: std::f64::consts::FRAC_1_SQRT_2 };

    /// Deflection per command at an angular frequency (rad/s); an infinite natural frequency is no servo.
    pub fn response(&self, omega_rad_s: f64) -> c64 {
        let w = std::f64::consts::TAU * self.frequency_hz;
        let over = omega_rad_s / w;
        c64::from(1.0) / c64::new(1.0 - over * over, 2.0 * self.damping_ratio * over)
    }

    /// The same with its period and its damping ratio changed by shares of them; without a period it follows at once.
    #[must_use]
    pub fn changed(self, period_share: f64, damping_share: f64) -> Self {
        Self {
            frequency_hz: self.frequency_hz / (1.0 + period_share),
            damping_ratio: self.damping_ratio * (1.0 + damping_share),
        }
    }

    /// How late it follows a ramp, s: `2 zeta / w`.
    pub fn delay_s(&self) -> f64 {
        2.0 * self.damping_ratio / (std::f64::consts::TAU * self.frequency_hz)
    }

    /// Deflections of a command that rests before its first sample.
    pub fn follow(&self, command: &[f64], time_step_s: f64) -> Vec<f64> {
        filtered(command, time_step_s, |omega| self.response(omega))
    }
}

impl From<Servos> for Actuator {
    fn from(servos: Servos) -> Self {
        match servos {
            Servos::None => Self::AT_ONCE,
            Servos::SecondOrder { frequency_hz, damping_ratio, .. } => Self { frequency_hz, damping_ratio },
        }
    }
}

impl RigSettings {
    /// As a wing's file has damping, pitch axis and servos; twenty modes, 25 Hz, no sensors.
    pub fn of_wing(file: &WingFile) -> Self {
        Self { actuator: file.servos.into(), ..Self::new(file.damping_ratio, file.pitch_axis_x()) }
    }

    /// Twenty modes, 25 Hz, the servos of a file that does not mention them, no sensors.
    pub fn new(damping_ratio: f64, pitch_axis_x_m: f64) -> Self {
        Self {
            modes: 20,
            damping_ratio,
            pitch_axis_x_m,
            actuator: Servos::default().into(),
            cutoff_hz: 25.0,
            sensors: Vec::new(),
            air: AirModel::default(),
            stations: Vec::new(),
            strip_loads: false,
        }
    }
}

/// Why a rig cannot be set up.
#[derive(Debug, thiserror::Error)]
pub enum RigError {
    /// The wing cannot be solved at this flow.
    #[error(transparent)]
    Coupling(#[from] CouplingError),
    /// Its modes cannot be found.
    #[error("{0}")]
    Modes(#[from] ModesError),
}

/// A wing with everything that depends on neither airspeed nor corrections.
#[derive(Debug)]
pub struct Rig<'a> {
    pub(crate) wing: &'a ElasticWing,
    pub(crate) settings: RigSettings,
    pub(crate) operators: RigOperators,
}

impl<'a> Rig<'a> {
    /// Finds the modes and the pressures of motion.
    ///
    /// # Errors
    /// If the modes do not converge.
    pub fn new(wing: &'a ElasticWing, settings: RigSettings) -> Result<Self, RigError> {
        Self::in_air(wing, settings, None)
    }

    /// The same with a doublet lattice that other wings use, too, if it is this wing's own.
    ///
    /// # Errors
    /// If the modes do not converge.
    pub fn in_air(
        wing: &'a ElasticWing,
        settings: RigSettings,
        shared: Option<&SharedAir>,
    ) -> Result<Self, RigError> {
        let operators = RigOperators::new(wing, &settings, shared)?;
        Ok(Self { wing, settings, operators })
    }

    /// The same rig in other air: its modes are not computed again.
    ///
    /// # Errors
    /// If the lattice cannot be solved.
    pub fn in_other_air(&self, air: AirModel, shared: Option<&SharedAir>) -> Result<Self, RigError> {
        let settings = RigSettings { air, ..self.settings.clone() };
        let operators = self.operators.in_air(self.wing, &settings, shared)?;
        Ok(Self { wing: self.wing, settings, operators })
    }

    /// The wing.
    pub fn wing(&self) -> &'a ElasticWing {
        self.wing
    }

    /// Natural frequencies of the kept modes, rad/s.
    pub fn omega_rad_s(&self) -> &[f64] {
        &self.operators.omega_rad_s
    }

    /// Pressures of motion: modes, root pitch, controls.
    pub fn air(&self) -> &UnsteadyAir {
        &self.operators.air
    }

    /// The rig at a flow with corrections (one entry for each correctable box): a linear system.
    ///
    /// # Errors
    /// If the wing diverges there, or the corrections have the wrong length.
    pub fn at(&self, flow: Flow, corrections: &Corrections) -> Result<RigModel, RigError> {
        // refuses divergence, with both pressures in its message
        self.wing.at(flow, corrections)?;
        let padded = self.wing.padded(corrections)?;
        let air = self.operators.air.at_airspeed(&self.operators.omega_rad_s, flow.v_m_s);
        Ok(assemble(self, flow, &padded, &air))
    }

    /// The rig with the air of one frequency alone, straight from the doublet lattice: [`RigModel::transfer`] is exact at
    /// `omega_rad_s` and means nothing elsewhere.
    ///
    /// # Errors
    /// As [`Rig::at`]; without a stream or at rest there is no such model.
    pub fn at_frequency(
        &self,
        flow: Flow,
        corrections: &Corrections,
        omega_rad_s: f64,
    ) -> Result<RigModel, RigError> {
        self.wing.at(flow, corrections)?;
        let padded = self.wing.padded(corrections)?;
        let kappa = omega_rad_s / flow.v_m_s;
        let cp = self.operators.air.exact(kappa).map_err(CouplingError::from)?;
        let frozen = RationalAir::frozen(&cp, kappa);
        let air = AirParts { families: [&frozen; 2], slow_modes: 0 };
        Ok(assemble(self, flow, &padded, &air))
    }

    /// Number of acceleration fields (aft, up, nose-up rotation about the pitch axis).
    pub(crate) fn fields() -> usize {
        FIELDS
    }
}
