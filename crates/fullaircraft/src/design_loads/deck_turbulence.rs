//! Continuous turbulence of a plan on a user's deck: limit loads about level flight, and the loads that go with each at its limit.

use crate::design_loads::deck_gusts::InGusts;
use crate::design_loads::deck_motion::{Changes, Spectrum};
use crate::design_loads::fly::{Done, Nodal, refused};
use crate::design_loads::instants::{FlownCase, FlownInstant};
use crate::design_loads::turbulence::{at_limit, facts, limits};
use crate::error::AircraftError;
use crate::flight::turbulence::{AtLimit, NetLoads, PANELS_A_DECADE};
use faer::c64;
use loads::matrix::{Action, Case};
use loads::turbulence::{Grid, Turbulence};

impl InGusts<'_> {
    /// A case in turbulence: statistics of all loads, and an instant for each of those that are looked at, at both of its limits.
    pub(super) fn rough<E: From<AircraftError>>(&self, case: &Case, done: &mut Done<'_, E>) -> Result<(), E> {
        let Action::Turbulence { u_sigma_m_s, scale_m, cut_off_hz, spectrum: shape, .. } = case.action else {
            return Ok(());
        };
        let grid = Grid::new(self.v_m_s, scale_m, cut_off_hz, &self.modes, PANELS_A_DECADE);
        let spectrum = match self.motion.spectrum(grid.omega_rad_s.clone()) {
            Ok(spectrum) => spectrum,
            Err(error) => return done(refused(case, self.which, &error), &|_| None),
        };
        let turbulence = Turbulence { v_m_s: self.v_m_s, scale_m, spectrum: shape };
        let net = NetLoads::new(grid, turbulence, self.motion.stations.len(), self.per_m_s(&spectrum));
        let facts = facts(case, &net, &|station| self.motion.level(station), self.axis);
        let limits = limits(&facts, self.motion.stations.len(), self.axis);
        let wanted: Vec<AtLimit> = limits.iter().map(|limit| at_limit(*limit, self.axis)).collect();
        let changes = self.at_limits(&spectrum, &net, &wanted, u_sigma_m_s);
        let instant = |(sample, limit)| FlownInstant {
            limit: Some(limit),
            ..self.motion.instant(&changes, 0.0, sample)
        };
        let instants = limits.into_iter().enumerate().map(instant).collect();
        let turbulence = Some(facts);
        let flown = FlownCase { number: case.number, model: self.which, refused: None, instants, turbulence }
            .if_finite();
        let nodal: &Nodal<'_> = &|instant| {
            let limit = at_limit(instant.limit?, self.axis);
            Some(self.motion.nodal(&self.at_limits(&spectrum, &net, &[limit], u_sigma_m_s), 0))
        };
        done(flown, nodal)
    }

    /// Net loads of all stations, then the load factor if the whole is one of them, per m/s.
    fn per_m_s(&self, spectrum: &Spectrum) -> Vec<Vec<c64>> {
        let mut loads: Vec<Vec<c64>> = spectrum
            .net
            .row_iter()
            .map(|row| row.iter().map(|value| *value / self.length_m).collect())
            .collect();
        let grids = self.motion.waves.modal.system.node_count();
        if let Some(whole) = self.motion.stations.iter().position(|station| station.nodes.len() == grids) {
            let scale = 1.0 / (self.length_m * self.weight_n);
            loads.push(self.motion.air(spectrum, whole, 2).iter().map(|value| *value * scale).collect());
        }
        loads
    }

    fn at_limits(
        &self,
        spectrum: &Spectrum,
        net: &NetLoads,
        limits: &[AtLimit],
        u_sigma_m_s: f64,
    ) -> Changes {
        let wanted = net.at_limits(limits);
        let factor = |limit: &AtLimit| {
            let sign = if limit.is_largest { 1.0 } else { -1.0 };
            sign * u_sigma_m_s / self.length_m
        };
        let factors: Vec<f64> = limits.iter().map(factor).collect();
        spectrum.with_loads(&net.response_of(&wanted), &factors)
    }
}
