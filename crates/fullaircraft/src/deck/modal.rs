//! The modes of a user's deck in its air, as flutter (SOL 145) and gusts (SOL 146) share them: modes of METHOD, their motion of the
//! boxes, damping of TABDMP1, the pairs of MKAERO1 and MKAERO2.

use crate::deck::cases::unread_cards;
use crate::deck::spline::{self, Splined};
use crate::deck::structure::{assembled, corrections};
use crate::error::AircraftError;
use aero::{Corrections, Lattice, StreamAxes};
use coupling::Spline;
use faer::Mat;
use nastran::{Aero, BulkData, Dmig, EigenMethod, Frames, InputError, Subcase};
use std::f64::consts::TAU;
use structure::{
    Damper, Modes, ModesError, Reduced, System, count_below, dampers, modal_damping,
    modal_structural_damping, normal_modes, reduced,
};

/// Modes of a deck that asks for none in particular.
const MODES: usize = 10;
/// Cards that are not read and would change the answers.
const NEEDED: &[&str] = &["CAERO2", "CAERO3", "CAERO4", "CAERO5", "DMIK", "SPLINE3", "SPLINE6", "SPLINE7"];

/// A deck's modes and boxes under the boundary conditions of a subcase.
#[derive(Debug)]
pub struct ModalDeck {
    /// Boxes, in the axes of the stream (ACSID).
    pub lattice: Lattice,
    /// Natural frequencies, rad/s; zero for rigid motions.
    pub omega_rad_s: Vec<f64>,
    /// Viscous damping of the modes, forces by velocities per unit of their masses, 1/s: that of TABDMP1 (diagonal) and of dampers.
    pub damping: Mat<f64>,
    /// Dampers of the deck, such as `CDAMP 12`.
    pub dampers: Vec<Damper>,
    /// References: chord, density, symmetry.
    pub aero: Aero,
    /// Boxes without a spline, which neither move nor load the structure.
    pub loose_boxes: Vec<u32>,
    /// Which motions the modes are computed of, or why ASET and OMIT are not followed; nothing of a deck without them.
    pub reduction: Option<String>,
    /// The deck as the subcase sees it.
    pub(crate) bulk: BulkData,
    /// Its structure.
    pub(crate) system: System,
    /// Shapes of the modes, g-set by modes.
    pub(crate) shapes: Mat<f64>,
    /// Motion of the boxes by that of the structure.
    pub(crate) spline: Spline,
    /// Heave along the normal and nose-up angle of each box (rows, two a box) by mode.
    pub(crate) motion: Mat<f64>,
    pub(crate) corrections: Corrections,
    /// Mach number and reduced frequency.
    pub(crate) pairs: Vec<(f64, f64)>,
}

impl ModalDeck {
    /// Assembles the deck under a subcase's boundary conditions, finds its modes and their motion of the boxes; `of` names what they
    /// are for in messages.
    ///
    /// # Errors
    /// If a card that is needed is not there, not read or wrong, no box has a spline, or the modes cannot be found.
    pub fn new(bulk: &BulkData, subcase: &Subcase, of: &str) -> Result<Self, AircraftError> {
        refuse_direct(bulk, subcase)?;
        let bulk = bulk.in_subcase(subcase)?;
        bulk.refuse_unread_elements()?;
        let unread = unread_cards(&bulk, NEEDED);
        if !unread.is_empty() {
            let message = format!(
                "the deck has {}, which would change its {of} and which are not read",
                unread.join(", ")
            );
            return Err(InputError::general(message)
                .with_help("write panels as CAERO1 and splines as SPLINE1, 2, 4 or 5")
                .into());
        }
        let aero = bulk.unsteady_reference.clone();
        let aero =
            aero.ok_or_else(|| InputError::general(format!("the deck has no AERO, which {of} needs")))?;
        let frames = Frames::resolve(&bulk)?;
        let stream = StreamAxes::of_deck(&frames, aero.acsid, &aero.span)?;
        let lattice = Lattice::in_axes(&bulk, &stream)?;
        if lattice.is_empty() {
            return Err(InputError::general(format!("the deck has no CAERO1, which {of} needs")).into());
        }
        let Reduced { system, remark: reduction } = reduced(&bulk, assembled(&bulk)?)?;
        let modes = modes(&bulk, subcase, &system)?;
        let Splined { spline, loose } =
            spline::splines(&bulk, &lattice, system.node_ids(), system.points(), &stream)?;
        let shapes = system.expand(modes.shapes.as_ref());
        let motion = spline.displace(shapes.as_ref());
        let dampers = dampers(&bulk)?;
        let pairs: Vec<(f64, f64)> =
            bulk.reduced_frequencies.iter().flat_map(|card| card.pairs.iter().copied()).collect();
        if pairs.is_empty() {
            let error = InputError::general(format!("the deck has no MKAERO1 or MKAERO2, which {of} needs"));
            return Err(error.with_help("list Mach numbers and reduced frequencies").into());
        }
        Ok(Self {
            damping: damping(&bulk, subcase, &modes)? + modal_damping(&dampers, shapes.as_ref()),
            dampers,
            omega_rad_s: modes.omega_rad_s,
            corrections: corrections(&bulk, lattice.len())?,
            lattice,
            aero,
            loose_boxes: loose,
            reduction,
            bulk,
            system,
            shapes,
            spline,
            motion,
            pairs,
        })
    }

    /// Structural damping forces on the modes by their displacements, per unit of their masses, 1/s²: PARAM G and GE of the elements.
    ///
    /// # Errors
    /// As where the elements are made.
    pub(crate) fn structural_damping(&self) -> Result<Mat<f64>, InputError> {
        let g = self.bulk.parameters.get("G").copied().unwrap_or(0.0);
        let mut damping = modal_structural_damping(&self.bulk, self.shapes.as_ref())?;
        for (mode, omega) in self.omega_rad_s.iter().enumerate() {
            damping[(mode, mode)] += g * omega.powi(2);
        }
        Ok(damping)
    }

    /// Grid and component of the motions that AUTOSPC holds; their masses and loads act on nothing.
    pub fn auto_held(&self) -> &[(u32, u8)] {
        self.system.auto_held()
    }

    /// Mach number of MKAERO1 and MKAERO2 that is nearest.
    pub fn nearest_mach(&self, mach: f64) -> f64 {
        let machs = self.pairs.iter().map(|pair| pair.0);
        machs.min_by(|a, b| (a - mach).abs().total_cmp(&(b - mach).abs())).unwrap_or(mach)
    }

    /// Reduced frequencies of MKAERO1 and MKAERO2 at one of their Mach numbers, and rest, rising.
    pub(crate) fn reduced_frequencies(&self, mach: f64) -> Vec<f64> {
        let mut ks: Vec<f64> =
            self.pairs.iter().filter(|pair| pair.0 == mach).map(|pair| pair.1).chain([0.0]).collect();
        ks.sort_by(f64::total_cmp);
        ks.dedup();
        ks
    }

    /// omega/V of a reduced frequency, one over the deck's unit of length.
    pub fn kappa(&self, k: f64) -> f64 {
        2.0 * k / self.aero.chord
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

/// Viscous damping of the modes by SDAMPING, 1/s: g omega on the diagonal.
fn damping(bulk: &BulkData, subcase: &Subcase, modes: &Modes) -> Result<Mat<f64>, InputError> {
    let n = modes.omega_rad_s.len();
    let Some(id) = subcase.damping else { return Ok(Mat::zeros(n, n)) };
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
    Ok(Mat::from_fn(n, n, |i, j| if i == j { all[i] } else { 0.0 }))
}

/// Refuses direct matrices that join points of the structure, and transfer functions; those of extra points alone change nothing.
fn refuse_direct(bulk: &BulkData, case: &Subcase) -> Result<(), InputError> {
    for selection in &case.direct {
        let (command, name) = selection.split_once(' ').unwrap_or((selection, ""));
        let of_name = bulk.direct_matrices.iter().filter(|card| card.name == name);
        let joined = of_name.flat_map(Dmig::points).find(|id| !bulk.extra_points.contains_key(id));
        if let (Some(_), _) | (None, "TFL") = (joined, command) {
            let message = format!("`{command} = {name}` changes the equations of motion and is not read");
            return Err(InputError::general(message)
                .with_help("take it out, or write what it adds as elements and masses"));
        }
    }
    Ok(())
}
