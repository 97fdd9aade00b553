//! The structure of a user's deck as trim needs it: SUPORT motions, flexibility held and in mean axes, inertia loads.

use crate::error::AircraftError;
use aero::Corrections;
use coupling::{CouplingError, Spline};
use faer::linalg::solvers::{DenseSolveCore, Solve};
use faer::{Mat, MatRef};
use nalgebra::{DMatrix, Matrix3, Point3, Vector3};
use nastran::{BulkData, Frames, InputError, Spc1, Suport};
use structure::{Flexibility, Model, System};

/// Rigid motions by a unit of a SUPORT component beyond which the components do not hold a rigid body.
const LARGEST: f64 = 1e9;

/// The deck's structure.
pub(crate) fn assembled(bulk: &BulkData) -> Result<System, InputError> {
    System::assemble(&Model::from_deck(bulk, None)?)
}

/// The structure clamped at its SUPORT motions.
pub(crate) fn held(bulk: &BulkData) -> Result<System, InputError> {
    assembled(&clamped(bulk.clone()))
}

/// The deck with its SUPORT motions clamped.
#[must_use]
pub fn clamped(mut bulk: BulkData) -> BulkData {
    // One more card of a set that applies.
    let set = bulk.constraints.first().map_or(1, |card| card.set);
    for support in &bulk.supports {
        let clamp = Spc1 {
            set,
            components: support.components.clone(),
            grids: vec![support.grid],
            enforced: 0.0,
            span: support.span.clone(),
        };
        bulk.constraints.push(clamp);
    }
    bulk
}

/// The rigid motions of the SUPORT components, each of unit size with the others at rest, g-set by motions; none for a deck without
/// SUPORT, held by its constraints.
///
/// # Errors
/// If a grid is not there, or components of several grids are not six that hold a rigid body.
pub(crate) fn support_motions(bulk: &BulkData, free: &System) -> Result<Mat<f64>, InputError> {
    let [support, rest @ ..] = bulk.supports.as_slice() else {
        return Ok(Mat::zeros(6 * free.node_count(), 0));
    };
    let frames = Frames::resolve(bulk)?;
    let place = |support: &Suport| {
        let node = free.node_index(support.grid).ok_or_else(|| {
            InputError::at(&support.span, format!("GRID {} of SUPORT is not there", support.grid))
        })?;
        let axes = frames.axes_at_point(bulk.grids[&support.grid].cd, &free.points()[node], &support.span)?;
        Ok::<_, InputError>((node, axes))
    };
    let (node, axes) = place(support)?;
    let rigid = reference_motions(free, &free.points()[node], &axes);
    let components = |support: &Suport| support.components.iter().map(|c| usize::from(*c) - 1).collect();
    if rest.iter().all(|other| other.grid == support.grid) {
        let columns: Vec<usize> = bulk.supports.iter().map(components).collect::<Vec<Vec<usize>>>().concat();
        if let Some(motions) = along_clamps(bulk, free, &rigid, &columns)? {
            return Ok(motions);
        }
        return Ok(Mat::from_fn(rigid.nrows(), columns.len(), |i, j| rigid[(i, columns[j])]));
    }
    // What each of the six motions about the first grid moves along the components.
    let mut moved: Vec<[f64; 6]> = Vec::new();
    for support in &bulk.supports {
        let (node, axes) = place(support)?;
        let columns: Vec<usize> = components(support);
        for c in columns {
            let along =
                |k: usize, motion: usize| axes[(k, c % 3)] * rigid[(6 * node + 3 * (c / 3) + k, motion)];
            moved.push(std::array::from_fn(|motion| (0..3).map(|k| along(k, motion)).sum()));
        }
    }
    let by_motions = Mat::from_fn(moved.len(), 6, |i, j| moved[i][j]);
    let motions = (moved.len() == 6).then(|| by_motions.partial_piv_lu().inverse());
    let motions = motions.filter(|all| all.col_iter().all(|column| column.iter().all(|x| x.abs() < LARGEST)));
    let refused = || {
        InputError::at(
            &support.span,
            "SUPORT names components of several grids that do not hold a rigid body",
        )
        .with_help("support six components that do, or components of one grid")
    };
    Ok(rigid * motions.ok_or_else(refused)?)
}

/// The motions of the SUPORT components that leave clamped displacements where they are, as Nastran's D = `-K_ll^-1 K_lr` does: pitch about a grid above
/// the one that is held in x moves the whole in x. `rigid` are the six motions about the supported grid. Nothing if the plain ones leave them there, or
/// no rigid motion does.
fn along_clamps(
    bulk: &BulkData,
    free: &System,
    rigid: &Mat<f64>,
    columns: &[usize],
) -> Result<Option<Mat<f64>>, InputError> {
    let frames = Frames::resolve(bulk)?;
    let by_cards =
        bulk.constraints.iter().flat_map(|card| card.grids.iter().map(|grid| (*grid, &card.components)));
    let mut clamps: Vec<[f64; 6]> = Vec::new();
    for (grid, components) in by_cards.chain(bulk.grids.values().map(|grid| (grid.id, &grid.ps))) {
        let (Some(card), Some(node)) = (bulk.grids.get(&grid), free.node_index(grid)) else { continue };
        if components.is_empty() || !free.is_attached(node) {
            continue;
        }
        let axes = frames.axes_at_point(card.cd, &free.points()[node], &card.span)?;
        for axis in components.iter().filter(|component| **component <= 3).map(|c| usize::from(*c) - 1) {
            clamps.push(std::array::from_fn(|j| {
                (0..3).map(|k| axes[(k, axis)] * rigid[(6 * node + k, j)]).sum()
            }));
        }
    }
    let length = clamps.iter().flatten().fold(1.0, |most: f64, value| most.max(value.abs()));
    if clamps.iter().all(|row| columns.iter().all(|column| row[*column].abs() <= 1e-9 * length)) {
        return Ok(None);
    }
    // Rotations as displacements at the longest arm.
    let scale = |j: usize| if j < 3 { 1.0 } else { length };
    let count = columns.len();
    let conditions = DMatrix::from_fn(count + clamps.len(), 6, |i, j| match i.checked_sub(count) {
        Some(clamp) => clamps[clamp][j] / scale(j),
        None => f64::from(u8::from(columns[i] == j)),
    });
    let units =
        DMatrix::from_fn(conditions.nrows(), count, |i, j| if i == j { scale(columns[j]) } else { 0.0 });
    let found =
        conditions.clone().svd(true, true).solve(&units, 1e-9).unwrap_or_else(|_| DMatrix::zeros(6, count));
    if (conditions * &found - units).amax() > 1e-6 * length {
        return Ok(None);
    }
    let along = |i: usize, j: usize| (0..6).map(|k| rigid[(i, k)] * found[(k, j)] / scale(k)).sum();
    Ok(Some(Mat::from_fn(rigid.nrows(), count, along)))
}

/// Rotation of each SUPORT motion, basic axes.
pub(crate) fn support_rotations(bulk: &BulkData, free: &System, d: &Mat<f64>) -> Vec<Vector3<f64>> {
    let node = bulk.supports.first().and_then(|support| free.node_index(support.grid));
    let of = |node: usize, j: usize| Vector3::from_fn(|axis, _| d[(6 * node + 3 + axis, j)]);
    (0..d.ncols()).map(|j| node.map_or_else(Vector3::zeros, |node| of(node, j))).collect()
}

/// Unit motions along and about the reference axes.
pub(crate) fn reference_motions(free: &System, origin: &Point3<f64>, axes: &Matrix3<f64>) -> Mat<f64> {
    let rigid = free.rigid_body(origin);
    Mat::from_fn(rigid.nrows(), 6, |i, j| {
        (0..3).map(|k| rigid[(i, 3 * (j / 3) + k)] * axes[(k, j % 3)]).sum()
    })
}

/// Accelerations of the g-set by each variable: those of the reference axes in units of gravity (PARAM AUNITS), none of the others; of what flies,
/// as the free motions carry them. All weight of a wing that is clamped and does not fly hangs on its clamps.
pub(crate) fn accelerations_by(
    bulk: &BulkData,
    free: &System,
    axes: &Mat<f64>,
    of: &[Option<usize>],
) -> Result<Mat<f64>, InputError> {
    let units = bulk.parameters.get("AUNITS").copied().unwrap_or(1.0);
    let all = Mat::from_fn(axes.nrows(), of.len(), |i, j| of[j].map_or(0.0, |axis| axes[(i, axis)] / units));
    if bulk.supports.is_empty() { Ok(all) } else { carried(bulk, free, &all) }
}

/// Motions of the g-set as the free motions carry them: those that SPC, GRID or AUTOSPC holds are at rest, and so is what follows them alone. Nastran's
/// inertia and air are those of the free motions: a mass on a motion that is held is not accelerated, and a load there is the ground's.
///
/// # Errors
/// If the displacement system of a grid is not there.
pub(crate) fn carried(bulk: &BulkData, free: &System, motions: &Mat<f64>) -> Result<Mat<f64>, InputError> {
    let frames = Frames::resolve(bulk)?;
    let mut own = Mat::zeros(free.free_count(), motions.ncols());
    for i in 0..free.free_count() {
        let (grid, component) = free.name(i);
        let (Some(card), Some(node)) = (bulk.grids.get(&grid), free.node_index(grid)) else { continue };
        let axes = frames.axes_at_point(card.cd, &free.points()[node], &card.span)?;
        let (kind, axis) = (usize::from(component - 1) / 3, axes.column(usize::from(component - 1) % 3));
        for j in 0..motions.ncols() {
            own[(i, j)] = (0..3).map(|k| axis[k] * motions[(6 * node + 3 * kind + k, j)]).sum::<f64>();
        }
    }
    Ok(free.expand(own.as_ref()))
}

/// Displacements of the boxes (two rows a box) by those of the s-set.
pub(crate) fn box_displacements(spline: &Spline, s_dofs: &[usize]) -> Mat<f64> {
    let mut rows = Mat::zeros(spline.rows().len(), s_dofs.len());
    for (row, entries) in spline.rows().iter().enumerate() {
        for (dof, value) in entries {
            let at = s_dofs.binary_search(dof).expect("the s-set is what the spline uses");
            rows[(row, at)] += value;
        }
    }
    rows
}

/// WKK and FA2J of a deck; neutral what it does not have.
pub(crate) fn corrections(bulk: &BulkData, boxes: usize) -> Result<Corrections, InputError> {
    let neutral = Corrections::neutral(boxes);
    let wkk = bulk.matrices.get("WKK").cloned().unwrap_or_else(|| neutral.wkk());
    let fa2j = bulk.matrices.get("FA2J").cloned().unwrap_or_else(|| neutral.fa2j());
    let given = Corrections::from_dmi(&wkk, &fa2j)?;
    if given.len() == boxes {
        return Ok(given);
    }
    let message = format!("DMI WKK or FA2J is for {} boxes, but the deck has {boxes}", given.len());
    Err(InputError::general(message).with_help("two rows of WKK and one of FA2J for each box"))
}

/// The structure on the s-set.
pub(crate) struct Reduced {
    /// Flexibility held at the SUPORT motions.
    pub(crate) restrained: Mat<f64>,
    /// Flexibility in mean axes.
    pub(crate) unrestrained: Mat<f64>,
    /// Displacement by each variable's inertia loads, held.
    pub(crate) sag: Mat<f64>,
    /// SUPORT motions by each variable's inertia.
    pub(crate) inertia: Mat<f64>,
    /// Motion of the mean axes along the SUPORT motions by loads on the s-set, held: `(Dᵀ M D)^-1 Dᵀ M F`.
    pub(crate) mean_by_load: Mat<f64>,
    /// The same by each variable's inertia loads: `(Dᵀ M D)^-1 Dᵀ M F M a`.
    pub(crate) mean_by_inertia: Mat<f64>,
}

impl Reduced {
    /// Reduces; `d` are the SUPORT motions, `a` the accelerations of the variables, both g-set by columns.
    pub(crate) fn new(
        free: &System,
        held: &System,
        d: &Mat<f64>,
        a: &Mat<f64>,
        s_dofs: &[usize],
    ) -> Result<Self, AircraftError> {
        let flexibility = Flexibility::new(held)?;
        let displaced =
            |f_g: MatRef<'_, f64>| held.expand(flexibility.displacements(held.reduce(f_g).as_ref()).as_ref());
        let at = |m: &Mat<f64>| coupling::supported::restrict(m.as_ref(), s_dofs);
        let mut units = Mat::zeros(d.nrows(), s_dofs.len());
        for (column, &dof) in s_dofs.iter().enumerate() {
            units[(dof, column)] = 1.0;
        }
        let f_gs = displaced(units.as_ref());
        let (md, ma) = (free.inertia_loads(d.as_ref()), free.inertia_loads(a.as_ref()));
        let restrained = at(&f_gs);
        let sagged = displaced(ma.as_ref());
        let sag = at(&sagged);
        let inertia = d.transpose() * ma;
        if d.ncols() == 0 {
            let [mean_by_load, mean_by_inertia] = [s_dofs.len(), a.ncols()].map(|n| Mat::zeros(0, n));
            let unrestrained = restrained.clone();
            return Ok(Self { restrained, unrestrained, sag, inertia, mean_by_load, mean_by_inertia });
        }
        let m_rr = d.transpose() * &md;
        let factor = m_rr.partial_piv_lu();
        // B = D M_rr^-1 (s by r): R F Rᵀ = F - B C - Cᵀ Bᵀ + B E Bᵀ
        let b = factor.solve(at(d).transpose()).transpose().to_owned();
        let c = md.transpose() * &f_gs;
        let e = md.transpose() * displaced(md.as_ref());
        let bc = &b * &c;
        let unrestrained = &restrained - &bc - bc.transpose() + &b * e * b.transpose();
        if unrestrained.col_iter().any(|column| column.iter().any(|value| !value.is_finite())) {
            let message = "no mass moves with a SUPORT motion";
            return Err(CouplingError::from(InputError::general(message)).into());
        }
        let mean_by_load = factor.solve(&c);
        let mean_by_inertia = factor.solve(md.transpose() * sagged);
        Ok(Self { restrained, unrestrained, sag, inertia, mean_by_load, mean_by_inertia })
    }
}
