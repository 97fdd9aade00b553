//! Trim and derivatives of a user's deck: a linear problem in any set of variables.
//!
//! ```text
//! w = sum w_x x + Theta u,   f = q Gᵀ S A^-1 w,   u = F (f - M a)       (held at the SUPORT motions)
//! Dᵀ (f - M a) = 0           one equation for each SUPORT motion D
//! ```
//! F is the flexibility held at the SUPORT motions (restrained); with inertia relief in mean axes it is `R F Rᵀ`,
//! `R = 1 - D (Dᵀ M D)^-1 Dᵀ M` (unrestrained). Trim angles are those of the SUPORT grid. Source: MSC.Nastran Aeroelastic
//! Analysis User's Guide, chapter 2, quasi-steady static aeroelasticity.
//! [`BulkData::in_subcase`] gives the deck as a subcase selects it. DMI WKK and FA2J of the deck are applied:
//! their factors in S, their offsets as loads that are always there, as camber is. An antisymmetric subcase has neither camber nor
//! offsets: both are the same on the two halves.

mod derivatives;

use crate::deck::cases::refuse_unread;
use crate::deck::given_load::GivenLoad;
use crate::deck::grids::DeckGrids;
use crate::deck::mean_pitch::MeanPitch;
use crate::deck::monitors::{Monitor, monitors};
use crate::deck::net_monitors::{NetMonitor, net_monitors};
use crate::deck::spline::{self, Splined};
use crate::deck::structure::{
    Reduced, accelerations_by, assembled, box_displacements, carried, corrections, held, reference_motions,
    support_motions, support_rotations,
};
use crate::deck::variables::{ANTISYMMETRIC, Links, variables};
use crate::error::AircraftError;
use crate::trim::balance::Balance;
use aero::{Corrections, Integration, Lattice, MirrorPlane, SteadyAero, StreamAxes};
use coupling::CouplingError;
use faer::linalg::solvers::Solve;
use faer::{Mat, c64};
use nalgebra::{Matrix3, Point3};
use nastran::{Aeros, BulkData, Frames, InputError, Trim};
use std::collections::BTreeMap;
use structure::unsymmetric::eigenvalues;

/// How the elastic aircraft is held when a derivative is taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Elastic {
    /// Not elastic at all.
    Rigid,
    /// Held at the SUPORT motions.
    Restrained,
    /// Free, with inertia relief in mean axes.
    Unrestrained,
}

/// A deck ready to be trimmed at one Mach number.
#[derive(Debug)]
pub struct TrimDeck {
    /// Boxes, in the axes of the stream (ACSID).
    pub lattice: Lattice,
    /// Variable names: INTERCEPT (camber and twist, always 1), then AESTAT and AESURF in ascending number.
    pub variables: Vec<String>,
    aeros: Aeros,
    /// Origin of the reference axes, in those of the stream.
    origin: Point3<f64>,
    /// Controls in proportion to others.
    links: Links,
    /// MONPNT3 of a group that is no SET1, and MONPNT1 of a component made of grids, which are left out.
    pub skipped_monitors: Vec<String>,
    /// Boxes without a spline, which neither move nor load the structure.
    pub loose_boxes: Vec<u32>,
    monitors: Vec<Monitor>,
    net_monitors: Vec<NetMonitor>,
    /// Pressures of the undeformed aircraft, boxes by variables.
    cp_variables: Mat<f64>,
    /// Pressures by displacement of the s-set.
    cp_displacement: Mat<f64>,
    /// Load on the s-set per box cp and unit dynamic pressure, factors in.
    gather: Mat<f64>,
    /// Load on the s-set of the pressure offsets per unit dynamic pressure, one column.
    offset: Vec<f64>,
    integration: Integration,
    corrections: Corrections,
    /// Load on the s-set by its displacement and unit dynamic pressure.
    stiffness: Mat<f64>,
    /// Divergence pressures, ascending.
    divergence: Vec<f64>,
    restrained: Mat<f64>,
    unrestrained: Mat<f64>,
    /// Displacement of the s-set by each variable's inertia loads, held.
    sag: Mat<f64>,
    /// SUPORT motions by each variable's inertia, then the reference axes' six: forces to accelerate.
    inertia: Mat<f64>,
    /// A load set that acts, too.
    load: Option<GivenLoad>,
    /// The s-set part of the SUPORT motions.
    motions: Mat<f64>,
    /// By how much the mean axes pitch against the SUPORT grid.
    mean_pitch: Option<MeanPitch>,
    /// The s-set part of the six motions of the reference axes.
    axes: Mat<f64>,
    /// The same as free motions carry them.
    carried_axes: Mat<f64>,
    /// The structure whose grids carry the loads.
    pub grids: DeckGrids,
}

/// A trimmed deck.
#[derive(Debug, Clone)]
pub struct TrimmedDeck {
    /// Value of each variable; angles are those of the SUPORT grid.
    pub values: BTreeMap<String, f64>,
    /// Angle of attack of the mean axes, rad, in which the deformation has no momentum; none without ANGLEA or a SUPORT motion in pitch.
    pub mean_angle_of_attack_rad: Option<f64>,
    /// Pressure coefficient of each box, before the deck's corrections.
    pub cp: Vec<f64>,
    /// Lift of each box along its normal, the deck's unit of force.
    pub lift: Vec<f64>,
    /// Air loads of each MONPNT1 and net loads of each MONPNT3 along and about its axes: three forces, three moments.
    pub monitors: BTreeMap<String, [f64; 6]>,
    /// The air's loads on the s-set.
    pub(crate) on_grids: Vec<f64>,
}

impl TrimDeck {
    /// Grid and component of the motions that AUTOSPC holds; their masses and loads act on nothing.
    pub fn auto_held(&self) -> &[(u32, u8)] {
        self.grids.free.auto_held()
    }

    /// Assembles a deck for one Mach number.
    ///
    /// # Errors
    /// If the deck has cards that are not read and would change the trim, AEROS is missing, SUPORT names more than one grid, a variable is unknown, no box has a spline, or the structure is
    /// free to move when held at the SUPORT motions.
    pub fn new(bulk: &BulkData, mach: f64) -> Result<Self, AircraftError> {
        Self::under_load(bulk, mach, None)
    }

    /// As [`TrimDeck::new`], with a load set of the deck (LOAD of the subcase) that acts beside air and inertia.
    ///
    /// # Errors
    /// As [`TrimDeck::new`]; if the set is not there, has loads that are not read, or enforces motions.
    pub fn under_load(bulk: &BulkData, mach: f64, load: Option<u32>) -> Result<Self, AircraftError> {
        refuse_unread(bulk)?;
        let aeros = bulk.aero_reference.clone();
        let aeros = aeros.ok_or_else(|| InputError::general("the deck has no AEROS, which trim needs"))?;
        let frames = Frames::resolve(bulk)?;
        let stream = stream_axes(&frames, &aeros)?;
        let (lattice, free, held) = (Lattice::in_axes(bulk, &stream)?, assembled(bulk)?, held(bulk)?);
        let Splined { spline, loose } =
            spline::splines(bulk, &lattice, free.node_ids(), free.points(), &stream)?;
        let (axes, origin) =
            (frames.axes_at(aeros.rcsid, &aeros.span)?, frames.origin(aeros.rcsid, &aeros.span)?);
        let turned = stream.axes.transpose() * axes;
        let (variables, incidence, accelerations) =
            variables(bulk, &lattice, &aeros, &stream.seen(&origin), &turned, &stream)?;
        let integration = Integration::new(&lattice);
        let (s_dofs, d) = (spline.used_dofs(), carried(bulk, &free, &support_motions(bulk, &free)?)?);
        let d6 = reference_motions(&free, &origin, &axes);
        let a = accelerations_by(bulk, &free, &d6, &accelerations)?;
        let structure = Reduced::new(&free, &held, &d, &a, &s_dofs)?;
        let (corrections, motion) = (corrections(bulk, lattice.len())?, box_displacements(&spline, &s_dofs));
        let theta = Mat::from_fn(lattice.len(), s_dofs.len(), |j, dof| motion[(2 * j + 1, dof)]);
        let loads = integration.corrected(&corrections);
        let gather = loads.rows_by_pressure(motion.transpose());
        let offset = offset(aeros.symmetry, || loads.offset_weighed(motion.transpose()), gather.nrows());
        let aero = SteadyAero::new(&lattice, mirror_plane(aeros.symmetry), mach)?;
        let cp_displacement = aero.pressures(theta.as_ref());
        let stiffness = &gather * &cp_displacement;
        let (monitors, skipped) = stations(bulk, &lattice, &stream)?;
        let mut accelerated = free.inertia_loads(a.as_ref());
        let load = GivenLoad::relieving(bulk, load, [&free, &held], &d, &s_dofs, &mut accelerated)?;
        let (net_monitors, groups) = net_monitors(bulk, &frames, &free, &s_dofs, accelerated.as_ref())?;
        let at = |m: &Mat<f64>| coupling::supported::restrict(m.as_ref(), &s_dofs);
        Ok(Self {
            links: Links::new(bulk, &variables)?,
            monitors,
            net_monitors,
            skipped_monitors: [skipped, groups].concat(),
            loose_boxes: loose,
            cp_variables: aero.pressures(incidence.as_ref()),
            cp_displacement,
            divergence: divergence(&structure.restrained, &stiffness)?,
            stiffness,
            integration,
            motions: at(&d),
            mean_pitch: MeanPitch::new(&structure, &support_rotations(bulk, &free, &d), &stream),
            load,
            axes: at(&d6),
            carried_axes: at(&carried(bulk, &free, &d6)?),
            gather,
            offset,
            corrections,
            restrained: structure.restrained,
            unrestrained: structure.unrestrained,
            sag: structure.sag,
            inertia: structure.inertia,
            lattice,
            variables,
            aeros,
            origin: stream.seen(&origin),
            grids: DeckGrids::new(bulk, [free, held], s_dofs, [d, accelerated])?,
        })
    }

    /// Reference lengths and symmetry.
    pub fn aeros(&self) -> &Aeros {
        &self.aeros
    }

    /// Loads on the s-set of the rigid deck per unit of each variable and of dynamic pressure, without offsets.
    pub(crate) fn rigid_loads(&self) -> Mat<f64> {
        &self.gather * &self.cp_variables
    }

    /// Dynamic pressures at which the aircraft, held at the SUPORT motions, diverges, ascending: one over the positive real
    /// eigenvalues of the loop of flexibility and air.
    pub fn divergence_pressures(&self) -> &[f64] {
        &self.divergence
    }

    /// The lowest dynamic pressure at which the aircraft diverges as it flies: free in the SUPORT motions, in mean axes.
    ///
    /// # Errors
    /// If the eigenvalues do not converge.
    pub fn free_divergence(&self) -> Result<Option<f64>, AircraftError> {
        Ok(divergence(&self.unrestrained, &self.stiffness)?.first().copied())
    }

    /// Loads on the s-set of the pressures of each variable, offsets with the first (INTERCEPT), per unit dynamic pressure.
    fn loads(&self, cp: &Mat<f64>) -> Mat<f64> {
        let mut loads = &self.gather * cp;
        for i in 0..loads.nrows() {
            loads[(i, 0)] += self.offset[i];
        }
        loads
    }

    /// Pressures of each variable (boxes by variables); with a `sag`, accelerations bend the structure. Deformations count by `share`
    /// (AEQR of TRIM).
    fn pressures(&self, q: f64, elastic: Elastic, sag: Option<&Mat<f64>>, share: f64) -> Mat<f64> {
        let flexibility = match elastic {
            Elastic::Rigid => return self.cp_variables.clone(),
            Elastic::Restrained => &self.restrained,
            Elastic::Unrestrained => &self.unrestrained,
        };
        let mut u = flexibility * self.loads(&self.cp_variables) * faer::Scale(q);
        if let Some(sag) = sag {
            u -= sag;
        }
        let s = u.nrows();
        let system = Mat::<f64>::identity(s, s) - flexibility * &self.stiffness * faer::Scale(share * q);
        &self.cp_variables + &self.cp_displacement * system.partial_piv_lu().solve(&u) * faer::Scale(share)
    }

    /// The balanced aircraft: `fixed` variables as given, linked ones (AELINK of all trims) in proportion, all others from the
    /// balance of the SUPORT motions.
    ///
    /// # Errors
    /// Where the aircraft diverges both held at the SUPORT motions and free (what diverges held alone says little of flight); if a fixed variable is unknown, there are not as many free variables as SUPORT motions, or free
    /// variables cannot be determined; they are named.
    pub fn trim(&self, q: f64, fixed: &[(String, f64)]) -> Result<TrimmedDeck, AircraftError> {
        self.balanced((q, 1.0), fixed, None)
    }

    /// As [`TrimDeck::trim`], for a TRIM card and its AELINK; the deck must have been built with its Mach number.
    ///
    /// # Errors
    /// As [`TrimDeck::trim`].
    pub fn trim_card(&self, card: &Trim) -> Result<TrimmedDeck, AircraftError> {
        self.balanced((card.q, card.elastic_share), &card.fixed, Some(card.id))
    }

    /// `share`: what deformations count.
    fn balanced(
        &self,
        (q, share): (f64, f64),
        fixed: &[(String, f64)],
        trim: Option<u32>,
    ) -> Result<TrimmedDeck, AircraftError> {
        if self.divergence.first().is_some_and(|first| share * q >= *first)
            && let Some(first) = self.free_divergence()?.filter(|first| share * q >= *first)
        {
            let held = self.divergence[0];
            let message = format!(
                "it diverges: free in the motions of SUPORT at a dynamic pressure of {first:.4}, held there at {held:.4}, where {q:.4} is asked for"
            );
            return Err(InputError::general(message)
                .with_help("lower the dynamic pressure, or stiffen the structure")
                .into());
        }
        let mut x: Vec<Option<f64>> = vec![None; self.variables.len()];
        x[0] = Some(1.0);
        for (label, value) in fixed {
            let at = self.variables.iter().position(|name| name == label).ok_or_else(|| {
                InputError::general(format!("{label} is no variable of the trim"))
                    .with_help(format!("there are {}", self.variables[1..].join(", ")))
            })?;
            x[at] = Some(*value);
        }
        let (mut sag, mut inertia) = (self.sag.clone(), self.inertia.clone());
        if let Some(load) = &self.load {
            (0..sag.nrows()).for_each(|i| sag[(i, 0)] -= load.displacement[i]);
            (0..inertia.nrows()).for_each(|i| inertia[(i, 0)] -= load.on_motions[i]);
        }
        let cp = self.pressures(q, Elastic::Restrained, Some(&sag), share);
        let air = (self.motions.transpose() * self.loads(&cp)) * faer::Scale(q);
        let balance = self.links.folded(&(air - &inertia), trim, &mut x)?;
        let rows: Vec<usize> = (0..balance.nrows()).collect();
        let row_names = vec!["motions of SUPORT"; rows.len()];
        let asked = Balance { matrix: &balance, rows: &rows, row_names: &row_names, names: &self.variables };
        let mut values = asked.solve(&x).map_err(|why| {
            InputError::general(format!("there is no such trim: {why}")).with_help(
                "leave as many variables free as motions are supported, each with an effect of its own",
            )
        })?;
        self.links.follow(trim, &mut values);
        let cp: Vec<f64> = (0..cp.nrows())
            .map(|row| values.iter().enumerate().map(|(j, value)| cp[(row, j)] * value).sum())
            .collect();
        let loads = self.integration.corrected(&self.corrections).box_loads(q, &cp);
        let monitored = self.monitors.iter().map(|one| (one.name.clone(), one.loads(&self.lattice, &loads)));
        let on_grids: Vec<f64> = (0..self.gather.nrows())
            .map(|i| q * (self.offset[i] + (0..cp.len()).map(|j| self.gather[(i, j)] * cp[j]).sum::<f64>()))
            .collect();
        let net = self.net_monitors.iter().map(|one| (one.name.clone(), one.loads(&on_grids, &values)));
        let alpha = self.variables.iter().position(|name| name == "ANGLEA").map(|at| values[at]);
        // What a load does to the mean axes is not known.
        let mean_pitch = self.mean_pitch.as_ref().filter(|_| self.load.is_none());
        let mean = mean_pitch.map(|pitch| share * pitch.angle_rad(&on_grids, &values));
        Ok(TrimmedDeck {
            mean_angle_of_attack_rad: alpha.zip(mean).map(|(alpha, mean)| alpha + mean),
            lift: loads.values.iter().copied().step_by(2).collect(),
            monitors: monitored.chain(net).collect(),
            cp,
            values: self.variables.iter().cloned().zip(values).collect(),
            on_grids,
        })
    }
}

/// Pressures that are always there are the same on both halves, as camber is: an antisymmetric aircraft knows none.
fn offset(symmetry: i32, weighed: impl FnOnce() -> Vec<f64>, rows: usize) -> Vec<f64> {
    if symmetry == ANTISYMMETRIC { vec![0.0; rows] } else { weighed() }
}

/// Stations of boxes that are seen in the axes of the stream.
fn stations(
    bulk: &BulkData,
    lattice: &Lattice,
    stream: &StreamAxes,
) -> Result<(Vec<Monitor>, Vec<String>), InputError> {
    let (monitors, skipped) = monitors(bulk, lattice, &Frames::resolve(bulk)?)?;
    Ok((monitors.iter().map(|monitor| monitor.seen_in(stream)).collect(), skipped))
}

/// The axes of the stream; those that are only shifted in the plane of symmetry are the basic ones, in which users look for places.
fn stream_axes(frames: &Frames, aeros: &Aeros) -> Result<StreamAxes, InputError> {
    let stream = StreamAxes::of_deck(frames, aeros.acsid, &aeros.span)?;
    let is_shifted = (stream.axes - Matrix3::identity()).amax() <= 1e-9 && stream.origin.y == 0.0;
    Ok(if is_shifted { StreamAxes::basic() } else { stream })
}

/// One over the positive real eigenvalues of `F H`, ascending.
fn divergence(flexibility: &Mat<f64>, stiffness: &Mat<f64>) -> Result<Vec<f64>, AircraftError> {
    let gains: Vec<c64> = eigenvalues((flexibility * stiffness).as_ref())
        .ok_or(CouplingError::Diverged { q_pa: 0.0, divergence_pa: None })?;
    let scale = gains.iter().map(|gain| gain.norm()).fold(0.0, f64::max);
    let real = |gain: &&c64| gain.im.abs() <= 1e-9 * gain.re.abs() && gain.re > 1e-9 * scale;
    let mut pressures: Vec<f64> = gains.iter().filter(real).map(|gain| 1.0 / gain.re).collect();
    pressures.sort_by(f64::total_cmp);
    Ok(pressures)
}

/// The plane of symmetry that AEROS or AERO asks for (SYMXZ), through the origin of the axes of the stream (ACSID), in these axes.
pub(crate) fn mirror_plane(symmetry: i32) -> MirrorPlane {
    match symmetry {
        1 => MirrorPlane::Symmetric { y_m: 0.0 },
        ANTISYMMETRIC => MirrorPlane::Antisymmetric { y_m: 0.0 },
        _ => MirrorPlane::None,
    }
}
