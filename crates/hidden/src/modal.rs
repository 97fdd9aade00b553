//! The true structure in its lowest modes, with what its matrices change by per unit change of stiffness and mass.
//!
//! With the modes Phi of the unchanged structure, `Phiᵀ K Phi` and `Phiᵀ M Phi` are linear in EI, GJ and the distributed
//! mass. Each is changed by an amount at the root and one at the tip (linear between), so that a changed structure costs
//! a few sums of small matrices and no eigenproblem.

use crate::truth_wing::{elements, same_beam, wing};
use coupling::planform::{Mesh, Planform};
use coupling::{CouplingError, ElasticWing};
use faer::Mat;
use nalgebra::Point3;
use std::path::Path;
use structure::{System, normal_modes};
use tunnel::{BeamChange, TunnelError};

/// Fields of acceleration: aft, up, nose-up rotation about the pitch axis.
pub(crate) const FIELDS: usize = 3;
/// Change from which derivatives are taken. Matrices are linear in stiffness and mass, and nearly so in the mass's place (its
/// square is lost).
const STEP: f64 = 0.0625;

/// What can be changed: each at the root and at the tip.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Part {
    Bending,
    Torsion,
    Mass,
    /// The mass moved aft, everywhere alike.
    MassAft,
}

/// Matrices that follow from the mass.
#[derive(Debug, Clone)]
pub(crate) struct Masses {
    /// Phiᵀ M Phi.
    pub(crate) modal: Mat<f64>,
    /// Phiᵀ M r, modes by fields.
    pub(crate) fields: Mat<f64>,
    /// Loads at the balance of modal accelerations, 3 by modes.
    pub(crate) loads_by_modes: Mat<f64>,
    /// Loads at the balance of the fields, 3 by fields.
    pub(crate) loads_by_fields: Mat<f64>,
}

/// See the module.
#[derive(Debug, Clone)]
pub(crate) struct ModalStructure {
    /// Natural frequencies, rad/s.
    pub(crate) omega_rad_s: Vec<f64>,
    /// Displacements of the s-set.
    pub(crate) shapes: Mat<f64>,
    /// Tip's height by mode.
    pub(crate) tip: Vec<f64>,
    pub(crate) masses: Masses,
    /// Change of Phiᵀ K Phi per unit relative change: bending and torsion, root and tip.
    pub(crate) stiffness_by: [[Mat<f64>; 2]; 2],
    /// Change of the masses per unit relative change at root and tip.
    pub(crate) masses_by: [Masses; 2],
    /// The same per chord by which the distributed mass moves aft.
    pub(crate) masses_by_aft: Masses,
    pub(crate) pitch_axis_x_m: f64,
    pub(crate) balance: Point3<f64>,
}

/// The matrices of a system in given shapes on the g-set.
fn masses(system: &System, shapes_g: &Mat<f64>, axis: &Point3<f64>, balance: &Point3<f64>) -> Masses {
    let fields = system.rigid_body(axis);
    let fields = Mat::from_fn(fields.nrows(), FIELDS, |dof, field| fields[(dof, [0, 2, 4][field])]);
    let rows = system.rigid_body(balance);
    let rows = Mat::from_fn(3, rows.nrows(), |row, dof| rows[(dof, row + 2)]);
    let (of_fields, of_modes) =
        (system.inertia_loads(fields.as_ref()), system.inertia_loads(shapes_g.as_ref()));
    Masses {
        modal: shapes_g.transpose() * &of_modes,
        fields: shapes_g.transpose() * &of_fields,
        loads_by_modes: &rows * &of_modes,
        loads_by_fields: &rows * &of_fields,
    }
}

impl Masses {
    /// (self - other) / STEP
    fn change_from(&self, other: &Self) -> Self {
        let change = |a: &Mat<f64>, b: &Mat<f64>| {
            Mat::from_fn(a.nrows(), a.ncols(), |i, j| (a[(i, j)] - b[(i, j)]) / STEP)
        };
        Self {
            modal: change(&self.modal, &other.modal),
            fields: change(&self.fields, &other.fields),
            loads_by_modes: change(&self.loads_by_modes, &other.loads_by_modes),
            loads_by_fields: change(&self.loads_by_fields, &other.loads_by_fields),
        }
    }

    /// Adds `factor` times another.
    pub(crate) fn add(&mut self, factor: f64, other: &Self) {
        let pairs = [
            (&mut self.modal, &other.modal),
            (&mut self.fields, &other.fields),
            (&mut self.loads_by_modes, &other.loads_by_modes),
            (&mut self.loads_by_fields, &other.loads_by_fields),
        ];
        for (own, others) in pairs {
            for j in 0..own.ncols() {
                for i in 0..own.nrows() {
                    own[(i, j)] += factor * others[(i, j)];
                }
            }
        }
    }
}

/// The structure and its spline, which a wing from a parametric file always has.
fn system(wing: &ElasticWing) -> Result<&System, TunnelError> {
    let none = CouplingError::Size { what: "structures of the true wing", got: 0, expected: 1 };
    wing.structure.as_ref().map(|(system, _)| system).ok_or(TunnelError::Wing(none))
}

impl ModalStructure {
    /// The lowest modes of the true wing, and the derivatives from rebuilt structures (on few boxes: the lattice has no
    /// part in them).
    pub(crate) fn new(
        path: &Path,
        planform: &Planform,
        wing_of_truth: &ElasticWing,
        pitch_axis_x_m: f64,
        count: usize,
    ) -> Result<Self, TunnelError> {
        let base = system(wing_of_truth)?;
        let modes = normal_modes(base, count.min(base.free_count())).map_err(maneuver::RigError::from)?;
        let shapes_g = base.expand(modes.shapes.as_ref());
        let balance = wing_of_truth.balance.point;
        let axis = Point3::new(pitch_axis_x_m, balance.y, balance.z);
        let of = |system: &System| masses(system, &shapes_g, &axis, &balance);
        let unchanged = of(base);
        let stiffness = |system: &System| shapes_g.transpose() * &system.elastic_loads(shapes_g.as_ref());
        let plain = stiffness(base);
        let changed = |part: Part, end: usize| -> Result<_, TunnelError> {
            let beam = changed_beam(part, end, elements(planform));
            let truth = wing(path, coarse(planform), beam)?;
            Ok((stiffness(system(&truth.wing)?), of(system(&truth.wing)?)))
        };
        let softer = |part: Part, end: usize| -> Result<Mat<f64>, TunnelError> {
            let (k, _) = changed(part, end)?;
            Ok(Mat::from_fn(k.nrows(), k.ncols(), |i, j| (k[(i, j)] - plain[(i, j)]) / STEP))
        };
        let heavier = |part: Part, end: usize| -> Result<Masses, TunnelError> {
            Ok(changed(part, end)?.1.change_from(&unchanged))
        };
        let none = CouplingError::Size { what: "structures of the true wing", got: 0, expected: 1 };
        let supported = wing_of_truth.supported.as_ref().ok_or(TunnelError::Wing(none))?;
        let shapes = coupling::supported::restrict(shapes_g.as_ref(), &supported.s_dofs);
        Ok(Self {
            tip: (0..shapes.ncols()).map(|mode| shapes[(supported.tip_z, mode)]).collect(),
            omega_rad_s: modes.omega_rad_s,
            shapes,
            stiffness_by: [
                [softer(Part::Bending, 0)?, softer(Part::Bending, 1)?],
                [softer(Part::Torsion, 0)?, softer(Part::Torsion, 1)?],
            ],
            masses_by: [heavier(Part::Mass, 0)?, heavier(Part::Mass, 1)?],
            masses_by_aft: heavier(Part::MassAft, 0)?,
            masses: unchanged,
            pitch_axis_x_m,
            balance,
        })
    }
}

fn changed_beam(part: Part, end: usize, elements: usize) -> BeamChange {
    let mut beam = same_beam(elements, 0.02);
    let ends = if end == 0 { (1.0 + STEP, 1.0) } else { (1.0, 1.0 + STEP) };
    match part {
        Part::Bending => beam.bending = ends,
        Part::Torsion => beam.torsion = ends,
        Part::Mass => beam.mass = ends,
        Part::MassAft => beam.mass_aft_over_c = STEP,
    }
    beam
}

/// The smallest mesh on which the control surfaces have their place.
fn coarse(planform: &Planform) -> Mesh {
    let mut mesh = planform.mesh(0.1, 0.02);
    mesh.fairing_strips = 1;
    mesh
}
