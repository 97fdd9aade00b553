//! Flutter of a user's deck (SOL 145): modes of METHOD, air forces of MKAERO1 and MKAERO2, roots of FLUTTER.
//!
//! ```text
//! [M p² + C p + K - q (Re Q(k) + p/(kappa V) Im Q(k))] u = 0,   kappa = omega/V = 2 k/REFC,   q = rho V²/2,   rho = RHOREF ratio
//! ```
//! in the deck's own units. C is the structural damping of TABDMP1 as viscous damping, g times the mode's frequency, which is
//! what Nastran does unless PARAM KDAMP is negative. Beside the frequencies of the deck the steady air (k = 0) is a row of the
//! table of forces, and the doublet lattice has Nastran's approximations, so that its prints are met; roots without oscillation are of the air at rest.

mod asked;

pub use asked::{FlutterPoints, flutter_cases};

use crate::deck::cases::unread_cards;
use crate::deck::spline::{self, Splined};
use crate::deck::structure::{assembled, corrections};
use crate::deck::trim::mirror_plane;
use crate::error::AircraftError;
use aero::{Corrections, DlmSettings, DoubletLattice, Lattice, StreamAxes};
use faer::Mat;
use maneuver::flutter::{
    Aeroelastic, CompleteCurves, FlutterError, GafTable, KRoot, ScheduledForces, gaf_table,
};
use nastran::{Aero, BulkData, EigenMethod, Flutter, Frames, InputError, Subcase};
use std::f64::consts::TAU;
use structure::{Modes, ModesError, System, count_below, normal_modes};

/// Modes of a deck that asks for none in particular.
const MODES: usize = 10;
/// Cards that are not read and would change flutter.
const NEEDED: &[&str] = &["CAERO2", "CAERO3", "CAERO4", "CAERO5", "DMIK", "SPLINE3", "SPLINE6", "SPLINE7"];

/// A deck whose flutter is looked for, under the boundary conditions of a subcase.
#[derive(Debug)]
pub struct FlutterDeck {
    /// Boxes, in the axes of the stream (ACSID).
    pub lattice: Lattice,
    /// Natural frequencies, rad/s; zero for rigid motions.
    pub omega_rad_s: Vec<f64>,
    /// Viscous damping of each mode, per unit of its mass, 1/s.
    pub damping: Vec<f64>,
    /// References: chord, density, symmetry.
    pub aero: Aero,
    /// Boxes without a spline, which neither move nor load the structure.
    pub loose_boxes: Vec<u32>,
    /// Heave along the normal and nose-up angle of each box (rows, two a box) by mode.
    motion: Mat<f64>,
    corrections: Corrections,
    /// Mach number and reduced frequency.
    pairs: Vec<(f64, f64)>,
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
        let bulk = &bulk.in_subcase(subcase)?;
        let unread = unread_cards(bulk, NEEDED);
        if !unread.is_empty() {
            let message = format!(
                "the deck has {}, which would change its flutter and which are not read",
                unread.join(", ")
            );
            return Err(InputError::general(message)
                .with_help("write panels as CAERO1 and splines as SPLINE1, 2, 4 or 5")
                .into());
        }
        let aero = bulk.unsteady_reference.clone();
        let aero = aero.ok_or_else(|| InputError::general("the deck has no AERO, which flutter needs"))?;
        let frames = Frames::resolve(bulk)?;
        let stream = StreamAxes::of_deck(&frames, aero.acsid, &aero.span)?;
        let lattice = Lattice::in_axes(bulk, &stream)?;
        if lattice.is_empty() {
            return Err(InputError::general("the deck has no CAERO1, which flutter needs").into());
        }
        let system = assembled(bulk)?;
        let modes = modes(bulk, subcase, &system)?;
        let Splined { spline, loose } =
            spline::splines(bulk, &lattice, system.node_ids(), system.points(), &stream)?;
        let motion = spline.displace(system.expand(modes.shapes.as_ref()).as_ref());
        let pairs: Vec<(f64, f64)> =
            bulk.reduced_frequencies.iter().flat_map(|card| card.pairs.iter().copied()).collect();
        if pairs.is_empty() {
            let error = InputError::general("the deck has no MKAERO1 or MKAERO2, which flutter needs");
            return Err(error.with_help("list Mach numbers and reduced frequencies").into());
        }
        Ok(Self {
            damping: damping(bulk, subcase, &modes)?,
            omega_rad_s: modes.omega_rad_s,
            corrections: corrections(bulk, lattice.len())?,
            lattice,
            aero,
            loose_boxes: loose,
            motion,
            pairs,
        })
    }

    /// The points that a FLUTTER card of the deck asks for.
    ///
    /// # Errors
    /// If a list is not there, airspeeds or densities are not positive, a Mach number is not below 1, or lists of matched points
    /// differ in length.
    pub fn points(&self, bulk: &BulkData, card: &Flutter) -> Result<Vec<FlutterPoints>, InputError> {
        let points = asked::points(bulk, card, &self.aero)?;
        let machs = points.iter().flat_map(FlutterPoints::machs).map(|mach| self.nearest_mach(mach));
        if let Some(mach) = machs.into_iter().find(|mach| *mach >= 1.0) {
            let message =
                format!("FLUTTER {} asks for Mach {mach}: the doublet lattice is subsonic", card.id);
            return Err(InputError::at(&card.span, message).with_help("give Mach numbers below 1"));
        }
        Ok(points)
    }

    /// Mach number of MKAERO1 and MKAERO2 that is nearest.
    pub fn nearest_mach(&self, mach: f64) -> f64 {
        let machs = self.pairs.iter().map(|pair| pair.0);
        machs.min_by(|a, b| (a - mach).abs().total_cmp(&(b - mach).abs())).unwrap_or(mach)
    }

    /// Generalised forces at a Mach number of MKAERO1 and MKAERO2, at rest and at its reduced frequencies.
    ///
    /// # Errors
    /// If the Mach number is not subsonic or the lattice cannot be solved.
    pub fn forces(&self, mach: f64) -> Result<GafTable, FlutterError> {
        let mut ks: Vec<f64> =
            self.pairs.iter().filter(|pair| pair.0 == mach).map(|pair| pair.1).chain([0.0]).collect();
        ks.sort_by(f64::total_cmp);
        ks.dedup();
        let kappa: Vec<f64> = ks.iter().map(|k| self.kappa(*k)).collect();
        let plane = mirror_plane(self.aero.symmetry, 0.0);
        let doublets = DoubletLattice::new(&self.lattice, plane, mach, &DlmSettings::NASTRAN)?;
        gaf_table(&self.lattice, &doublets, self.motion.as_ref(), Some(&self.corrections), &kappa)
    }

    /// omega/V of a reduced frequency, one over the deck's unit of length.
    pub fn kappa(&self, k: f64) -> f64 {
        2.0 * k / self.aero.chord
    }

    /// The roots at a list of points, `forces` from [`FlutterDeck::forces`] for the Mach number, or by airspeed for several.
    ///
    /// # Errors
    /// If eigenvalues do not converge or a reduced frequency is beyond the table.
    pub fn roots(
        &self,
        points: &FlutterPoints,
        tables: &[(f64, GafTable)],
    ) -> Result<FlutterRoots, FlutterError> {
        let table = |mach: f64| {
            let near = self.nearest_mach(mach);
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
                let at = |k: &f64| Ok((*k, system.k_roots(self.kappa(*k), *density)?));
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
        let n = self.omega_rad_s.len();
        let diagonal =
            |value: &dyn Fn(usize) -> f64| Mat::from_fn(n, n, |i, j| if i == j { value(i) } else { 0.0 });
        let damping = diagonal(&|i| if is_damped { self.damping[i] } else { 0.0 });
        Aeroelastic::new(diagonal(&|_| 1.0), damping, diagonal(&|i| self.omega_rad_s[i].powi(2)), forces)
    }
}

/// The modes that METHOD selects, as PARAM LMODES, or LFREQ and HFREQ, cut them.
fn modes(bulk: &BulkData, subcase: &Subcase, system: &System) -> Result<Modes, AircraftError> {
    let method = match subcase.method {
        Some(id) => Some(bulk.eigen_methods.get(&id).ok_or_else(|| {
            InputError::general(format!("the case control selects METHOD {id}, which is not there"))
        })?),
        None => bulk.eigen_methods.values().next().filter(|_| bulk.eigen_methods.len() == 1),
    };
    let count = wanted(method, system)?.min(system.free_count()).max(1);
    let mut modes = match normal_modes(system, count) {
        Err(ModesError::TooMany { available, .. }) if available > 0 => normal_modes(system, available)?,
        modes => modes?,
    };
    let parameter = |name: &str| bulk.parameters.get(name).copied();
    let last = parameter("LMODES").filter(|last| *last >= 1.0);
    let [low, high] = [parameter("LFREQ").unwrap_or(0.0), parameter("HFREQ").unwrap_or(f64::INFINITY)];
    let is_kept = |(mode, omega): (usize, &f64)| match last {
        Some(last) => (mode as f64) < last,
        None => (low..=high).contains(&(omega / TAU)),
    };
    let kept: Vec<usize> =
        modes.omega_rad_s.iter().enumerate().filter(|mode| is_kept(*mode)).map(|(mode, _)| mode).collect();
    modes.shapes = Mat::from_fn(modes.shapes.nrows(), kept.len(), |i, j| modes.shapes[(i, kept[j])]);
    modes.omega_rad_s = kept.iter().map(|mode| modes.omega_rad_s[*mode]).collect();
    if modes.omega_rad_s.is_empty() {
        return Err(
            InputError::general("PARAM LFREQ and HFREQ leave no mode of those that METHOD asks for").into()
        );
    }
    Ok(modes)
}

/// How many modes an EIGRL or EIGR asks for: its number, those up to its highest frequency, or both.
fn wanted(method: Option<&EigenMethod>, system: &System) -> Result<usize, ModesError> {
    let count = method.and_then(|method| method.count).map(|count| count as usize);
    match method.and_then(|method| method.highest_hz) {
        Some(hz) => {
            let below = count_below(system, hz * TAU)?;
            Ok(below.min(count.unwrap_or(below)))
        }
        None => Ok(count.unwrap_or(MODES)),
    }
}

/// Viscous damping of the modes, 1/s: g omega.
fn damping(bulk: &BulkData, subcase: &Subcase, modes: &Modes) -> Result<Vec<f64>, InputError> {
    let Some(id) = subcase.damping else { return Ok(vec![0.0; modes.omega_rad_s.len()]) };
    let missing =
        || InputError::general(format!("the case control selects SDAMPING {id}, which is not there"));
    let table = bulk.damping_tables.get(&id).ok_or_else(missing)?;
    let all: Vec<f64> =
        modes.omega_rad_s.iter().map(|omega| table.structural_damping(omega / TAU) * omega).collect();
    if bulk.parameters.get("KDAMP").is_some_and(|value| *value < 0.0) && all.iter().any(|value| *value != 0.0)
    {
        let message = "structural damping as a complex stiffness (PARAM KDAMP -1) is not read";
        return Err(InputError::at(&table.span, message)
            .with_help("leave out PARAM KDAMP: then g times a mode's frequency is its viscous damping"));
    }
    Ok(all)
}
