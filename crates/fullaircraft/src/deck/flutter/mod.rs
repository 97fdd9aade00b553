//! Flutter of a user's deck (SOL 145): modes of METHOD, air forces of MKAERO1 and MKAERO2, roots of FLUTTER.
//!
//! ```text
//! [M p² + C p + K - q (Re Q(k) + p/(kappa V) Im Q(k))] u = 0,   kappa = omega/V = 2 k/REFC,   q = rho V²/2,   rho = RHOREF ratio
//! ```
//! in the deck's own units. C is the structural damping of TABDMP1 as viscous damping, g times the mode's frequency, which is
//! what Nastran does unless PARAM KDAMP is negative, and that of dampers (CDAMP, CVISC, CBUSH, CBUSH1D) on the modes. Beside the frequencies of the deck the steady air (k = 0) is a row of the
//! table of forces, and the doublet lattice has Nastran's approximations, so that its prints are met; roots without oscillation are of the air at rest.
//! Beyond the deck's highest k, Re Q and Im Q/k are held ([`maneuver::flutter::GeneralisedForces::split`]).

mod asked;

pub use asked::{FlutterPoints, flutter_cases};

use crate::deck::modal::ModalDeck;
use crate::deck::trim::mirror_plane;
use crate::error::AircraftError;
use aero::{DlmSettings, DoubletLattice};
use faer::Mat;
use maneuver::flutter::{
    Aeroelastic, CompleteCurves, FlutterError, GafTable, KRoot, ScheduledForces, gaf_table,
};
use nastran::{BulkData, Flutter, InputError, Subcase};

/// A deck whose flutter is looked for, under the boundary conditions of a subcase.
#[derive(Debug)]
pub struct FlutterDeck {
    /// Its modes and boxes.
    pub modal: ModalDeck,
}

/// What was found at one density and Mach number, or at a list of matched points.
#[derive(Debug)]
pub enum FlutterRoots {
    /// PK and PKNL.
    Curves(CompleteCurves),
    /// K and KE: reduced frequency, and the roots there.
    ByFrequency(Vec<(f64, Vec<KRoot>)>),
}

impl FlutterDeck {
    /// Assembles the deck under a subcase's boundary conditions, finds its modes and their motion of the boxes.
    ///
    /// # Errors
    /// If a card that flutter needs is not there, not read or wrong, no box has a spline, or the modes cannot be found.
    pub fn new(bulk: &BulkData, subcase: &Subcase) -> Result<Self, AircraftError> {
        Ok(Self { modal: ModalDeck::new(bulk, subcase, "flutter")? })
    }

    /// The points that a FLUTTER card of the deck asks for.
    ///
    /// # Errors
    /// If a list is not there, airspeeds or densities are not positive, a Mach number is not below 1, lists of matched points
    /// differ in length, or the K method is asked for reduced frequencies beyond those of MKAERO1 and MKAERO2.
    pub fn points(&self, bulk: &BulkData, card: &Flutter) -> Result<Vec<FlutterPoints>, InputError> {
        let points = asked::points(bulk, card, &self.modal.aero)?;
        let machs = points.iter().flat_map(FlutterPoints::machs).map(|mach| self.modal.nearest_mach(mach));
        if let Some(mach) = machs.into_iter().find(|mach| *mach >= 1.0) {
            let message =
                format!("FLUTTER {} asks for Mach {mach}: the doublet lattice is subsonic", card.id);
            return Err(InputError::at(&card.span, message).with_help("give Mach numbers below 1"));
        }
        for group in &points {
            let FlutterPoints::Frequencies { mach, ks, .. } = group else { continue };
            let highest = self.highest_k(*mach);
            if let Some(k) = ks.iter().copied().filter(|k| *k > highest).reduce(f64::max) {
                let message = format!(
                    "FLUTTER {} asks for k = {k} at Mach {mach}, beyond those of MKAERO1 and MKAERO2 (up to {highest})",
                    card.id
                );
                let error = InputError::at(&card.span, message);
                return Err(error.with_help(format!("list k up to {k} in MKAERO1 or MKAERO2")));
            }
        }
        Ok(points)
    }

    /// The highest reduced frequency that MKAERO1 and MKAERO2 have at the Mach number of theirs that is nearest.
    pub fn highest_k(&self, mach: f64) -> f64 {
        self.modal.reduced_frequencies(self.modal.nearest_mach(mach)).last().copied().unwrap_or(0.0)
    }

    /// Generalised forces at a Mach number of MKAERO1 and MKAERO2, at rest and at its reduced frequencies.
    ///
    /// # Errors
    /// If the Mach number is not subsonic or the lattice cannot be solved.
    pub fn forces(&self, mach: f64) -> Result<GafTable, FlutterError> {
        let modal = &self.modal;
        let kappa: Vec<f64> = modal.reduced_frequencies(mach).iter().map(|k| modal.kappa(*k)).collect();
        let plane = mirror_plane(modal.aero.symmetry);
        let doublets = DoubletLattice::new(&modal.lattice, plane, mach, &DlmSettings::NASTRAN)?;
        gaf_table(&modal.lattice, &doublets, modal.motion.as_ref(), Some(&modal.corrections), &kappa)
    }

    /// The roots at a list of points, `forces` from [`FlutterDeck::forces`] for the Mach number, or by airspeed for several.
    ///
    /// # Errors
    /// If eigenvalues do not converge.
    pub fn roots(
        &self,
        points: &FlutterPoints,
        tables: &[(f64, GafTable)],
    ) -> Result<FlutterRoots, FlutterError> {
        let table = |mach: f64| {
            let near = self.modal.nearest_mach(mach);
            let found = tables.iter().find(|(mach, _)| *mach == near).map(|(_, table)| table);
            found.ok_or(FlutterError::Empty("the table of air forces"))
        };
        match points {
            FlutterPoints::Speeds { mach, flows } => {
                let curves = self.system(table(*mach)?)?.pk_complete(flows)?;
                Ok(FlutterRoots::Curves(curves))
            }
            FlutterPoints::Matched { machs, flows } => {
                let of = |(mach, flow): (&f64, &aero::Flow)| Ok((flow.v_m_s, table(*mach)?.clone()));
                let sets = machs.iter().zip(flows).map(of).collect::<Result<Vec<_>, FlutterError>>()?;
                let forces = ScheduledForces::new(sets)?;
                Ok(FlutterRoots::Curves(self.system(&forces)?.pk_complete(flows)?))
            }
            FlutterPoints::Frequencies { mach, density, ks, is_damped } => {
                let system = self.system_with(table(*mach)?, *is_damped)?;
                let at = |k: &f64| Ok((*k, system.k_roots(self.modal.kappa(*k), *density)?));
                Ok(FlutterRoots::ByFrequency(ks.iter().map(at).collect::<Result<_, FlutterError>>()?))
            }
        }
    }

    fn system<'a>(
        &self,
        forces: &'a dyn maneuver::flutter::GeneralisedForces,
    ) -> Result<Aeroelastic<'a>, FlutterError> {
        self.system_with(forces, true)
    }

    fn system_with<'a>(
        &self,
        forces: &'a dyn maneuver::flutter::GeneralisedForces,
        is_damped: bool,
    ) -> Result<Aeroelastic<'a>, FlutterError> {
        let n = self.modal.omega_rad_s.len();
        let diagonal =
            |value: &dyn Fn(usize) -> f64| Mat::from_fn(n, n, |i, j| if i == j { value(i) } else { 0.0 });
        let damping = if is_damped { self.modal.damping.clone() } else { Mat::zeros(n, n) };
        Aeroelastic::new(
            diagonal(&|_| 1.0),
            damping,
            diagonal(&|i| self.modal.omega_rad_s[i].powi(2)),
            forces,
        )
    }
}
