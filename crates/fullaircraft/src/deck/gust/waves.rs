//! A deck's answers to waves of a gust, by frequency: amplitudes of the modes, and the air's loads on rows of its boxes.
//!
//! ```text
//! [-omega² + i omega C + K + i D - q Q(omega/V)] x = q Q_g(omega/V) w/V,   p = q (P x + P_g w/V)
//! ```
//! The equations of SOL 146 per unit velocity w of the gust, its phase zero where the foremost box feels it.

use super::air::GustAir;
use crate::deck::modal::ModalDeck;
use crate::error::AircraftError;
use aero::Flow;
use faer::{Mat, MatRef, Scale, c64};
use maneuver::flutter::Aeroelastic;
use maneuver::gust::elastic_response;

/// A deck in one flow, ready for waves of a gust.
#[derive(Debug)]
pub(crate) struct GustWaves {
    /// Its modes and boxes.
    pub(crate) modal: ModalDeck,
    air: GustAir,
    flow: Flow,
    /// Structural damping forces on the modes by their displacements (PARAM G, GE).
    structural: Mat<f64>,
    /// Where the foremost box feels a gust, the deck's unit of length.
    foremost: f64,
}

/// Amplitudes per unit velocity of a gust, a column a frequency.
#[derive(Debug, Clone)]
pub(crate) struct Waves {
    /// Frequencies, rad/s.
    pub(crate) omega_rad_s: Vec<f64>,
    /// Modes.
    pub(crate) modes: Mat<c64>,
    /// The air's loads on the rows.
    pub(crate) rows: Mat<c64>,
}

impl GustWaves {
    /// Of a deck whose MKAERO pairs are those of the flow's Mach number; `rows` weigh box loads (two columns a box).
    ///
    /// # Errors
    /// If the lattice cannot be solved.
    pub(crate) fn new(
        modal: ModalDeck,
        rows: MatRef<'_, f64>,
        (flow, mach): (Flow, f64),
        highest_rad_s: f64,
        direction: [f64; 3],
    ) -> Result<Self, AircraftError> {
        let air = GustAir::new(&modal, rows, mach, highest_rad_s / flow.v_m_s, direction)?;
        let places = modal.lattice.boxes.iter().map(|panel| panel.three_quarter_point().x);
        let foremost = places.fold(f64::INFINITY, f64::min);
        let structural = modal.structural_damping()?;
        Ok(Self { modal, air, flow, structural, foremost })
    }

    /// Share of the air forces by which their splines over frequency miss them at worst.
    pub(crate) fn missed(&self) -> f64 {
        self.air.missed
    }

    fn system(&self) -> Result<Aeroelastic<'_>, AircraftError> {
        let modal = &self.modal;
        let n = modal.omega_rad_s.len();
        let diagonal =
            |value: &dyn Fn(usize) -> f64| Mat::from_fn(n, n, |i, j| if i == j { value(i) } else { 0.0 });
        let stiffness = diagonal(&|i| modal.omega_rad_s[i].powi(2));
        Ok(Aeroelastic::new(diagonal(&|_| 1.0), modal.damping.clone(), stiffness, &self.air.modal)?)
    }

    /// Roots of the deck in the flow by the p-k method, 1/s.
    ///
    /// # Errors
    /// If eigenvalues do not converge.
    pub(crate) fn roots(&self) -> Result<Vec<c64>, AircraftError> {
        let found = self.system()?.pk_complete(&[self.flow])?;
        Ok(found.branches.iter().filter_map(|branch| Some(branch.at(0)?.p)).collect())
    }

    /// Answers at frequencies above zero, rad/s.
    ///
    /// # Errors
    /// If one is beyond those of the air.
    pub(crate) fn at(&self, omega_rad_s: Vec<f64>) -> Result<Waves, AircraftError> {
        let system = self.system()?;
        let n = self.modal.omega_rad_s.len();
        let q = c64::from(self.flow.dynamic_pressure_pa());
        let mut modes = Mat::zeros(n, omega_rad_s.len());
        let mut rows = Mat::<c64>::zeros(0, omega_rad_s.len());
        for (at, omega) in omega_rad_s.iter().enumerate() {
            let kappa = omega / self.flow.v_m_s;
            let incidence = c64::from(1.0 / self.flow.v_m_s);
            let by_gust = self.air.of_gust(kappa, self.foremost, incidence)? * Scale(q);
            let x = elastic_response(
                &system,
                self.flow,
                *omega,
                self.structural.as_ref(),
                by_gust.subrows(0, n),
            )?;
            let mut on_rows = by_gust.subrows(n, by_gust.nrows() - n).to_owned();
            if let Some(by_motion) = self.air.on_stations(kappa, x.as_ref()) {
                on_rows += by_motion * Scale(q);
            }
            if at == 0 {
                rows = Mat::zeros(on_rows.nrows(), omega_rad_s.len());
            }
            modes.col_mut(at).copy_from(x.col(0));
            rows.col_mut(at).copy_from(on_rows.col(0));
        }
        Ok(Waves { omega_rad_s, modes, rows })
    }
}

impl Waves {
    /// The modes' accelerations against their inertia (`omega² x`).
    pub(crate) fn inertia(&self) -> Mat<c64> {
        Mat::from_fn(self.modes.nrows(), self.modes.ncols(), |i, k| {
            self.modes[(i, k)] * self.omega_rad_s[k].powi(2)
        })
    }

    /// The modes' damping forces per unit of their masses (`-(i omega C + i D) x`).
    pub(crate) fn damping(&self, of: &GustWaves) -> Mat<c64> {
        let n = self.modes.nrows();
        let complex = |of: &Mat<f64>| Mat::from_fn(n, n, |i, j| c64::from(of[(i, j)]));
        let by_rate = complex(&of.modal.damping) * &self.modes;
        let by_place = complex(&of.structural) * &self.modes;
        Mat::from_fn(n, self.modes.ncols(), |i, k| {
            (by_rate[(i, k)] * self.omega_rad_s[k] + by_place[(i, k)]) * c64::new(0.0, -1.0)
        })
    }
}
