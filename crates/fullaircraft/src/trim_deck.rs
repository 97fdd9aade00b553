//! Trim and derivatives of a user's deck: a linear problem in any set of variables.
//!
//! ```text
//! w = sum w_x x + Theta u,   f = q Gᵀ S A^-1 w,   u = F (f - M a)       (held at the SUPORT motions)
//! Dᵀ (f - M a) = 0           one equation for each SUPORT motion D
//! ```
//! F is the flexibility held at the SUPORT motions (restrained); with inertia relief in mean axes it is `R F Rᵀ`,
//! `R = 1 - D (Dᵀ M D)^-1 Dᵀ M` (unrestrained). Trim angles are those of the SUPORT grid. Source: MSC.Nastran Aeroelastic
//! Analysis User's Guide, chapter 2, quasi-steady static aeroelasticity.
//! All SPC and SPC1 of the deck apply, whatever its case control selects. Corrections (WKK, FA2J) are not applied.

use crate::deck_spline;
use crate::error::AircraftError;
use crate::trim_balance::Balance;
use aero::{ControlSurface, Integration, Lattice, MirrorPlane, SteadyAero, camber_and_twist, incidence};
use coupling::{CouplingError, Spline};
use faer::linalg::solvers::Solve;
use faer::{Mat, MatRef};
use nalgebra::{Matrix3, Point3, Vector3};
use nastran::{Aeros, BulkData, Frames, InputError, Spc1, Trim};
use std::collections::BTreeMap;
use structure::{Flexibility, Model, System};

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
    /// Boxes.
    pub lattice: Lattice,
    /// Variable names: INTERCEPT (camber and twist, always 1), then AESTAT and AESURF in ascending number.
    pub variables: Vec<String>,
    aeros: Aeros,
    origin: Point3<f64>,
    /// Incidence of each variable, boxes by variables.
    incidence: Mat<f64>,
    /// Load on the s-set per box cp and unit dynamic pressure.
    gather: Mat<f64>,
    /// Incidence by displacement of the s-set.
    theta: Mat<f64>,
    aero: SteadyAero,
    restrained: Mat<f64>,
    unrestrained: Mat<f64>,
    /// Displacement of the s-set by each variable's inertia loads, held.
    sag: Mat<f64>,
    /// SUPORT motions by each variable's inertia, then the reference axes' six: forces to accelerate.
    inertia: Mat<f64>,
    /// The s-set part of the SUPORT motions.
    motions: Mat<f64>,
    /// The s-set part of the six motions of the reference axes.
    axes: Mat<f64>,
    area: Vec<f64>,
}

/// A trimmed deck.
#[derive(Debug, Clone)]
pub struct TrimmedDeck {
    /// Value of each variable.
    pub values: BTreeMap<String, f64>,
    /// Pressure coefficient of each box.
    pub cp: Vec<f64>,
    /// Lift of each box along its normal, the deck's unit of force.
    pub lift: Vec<f64>,
}

impl TrimDeck {
    /// Assembles a deck for one Mach number.
    ///
    /// # Errors
    /// If AEROS or SUPORT is missing, SUPORT names more than one grid, a variable is unknown, a box has no spline, or the structure is
    /// loose when held at the SUPORT motions.
    pub fn new(bulk: &BulkData, mach: f64) -> Result<Self, AircraftError> {
        let missing = |card: &str| InputError::general(format!("the deck has no {card}, which trim needs"));
        let aeros = bulk.aero_reference.clone().ok_or_else(|| missing("AEROS"))?;
        let lattice = Lattice::from_bulk(bulk)?;
        let (free, held) = (assembled(bulk)?, held(bulk)?);
        let spline = deck_spline::splines(bulk, &lattice, free.node_ids(), free.points())?;
        let frames = Frames::resolve(bulk)?;
        let axes = frames.axes_at(aeros.rcsid, &aeros.span)?;
        let origin = frames.point(aeros.rcsid, [0.0; 3], &aeros.span)?;
        let (variables, incidence, accelerations) = variables(bulk, &lattice, &aeros, &origin)?;
        let integration = Integration::new(&lattice);
        let s_dofs = spline.used_dofs();
        let d = support_motions(bulk, &free)?;
        let d6 = reference_motions(&free, &origin, &axes);
        let units = bulk.parameters.get("AUNITS").copied().unwrap_or(1.0);
        let a = Mat::from_fn(d6.nrows(), variables.len(), |i, j| {
            accelerations[j].map_or(0.0, |axis| d6[(i, axis)] / units)
        });
        let structure = Reduced::new(&free, &held, &d, &a, &s_dofs)?;
        let plane = match aeros.symmetry {
            1 => MirrorPlane::Symmetric { y_m: 0.0 },
            -1 => MirrorPlane::Antisymmetric { y_m: 0.0 },
            _ => MirrorPlane::None,
        };
        let (theta, gather) = coupling_matrices(&spline, &s_dofs, &integration);
        let at = |m: &Mat<f64>| coupling::supported::restrict(m.as_ref(), &s_dofs);
        Ok(Self {
            aero: SteadyAero::new(&lattice, plane, mach)?,
            area: (0..lattice.len()).map(|j| integration.area(j)).collect(),
            motions: at(&d),
            axes: at(&d6),
            theta,
            gather,
            restrained: structure.restrained,
            unrestrained: structure.unrestrained,
            sag: structure.sag,
            inertia: structure.inertia,
            lattice,
            variables,
            aeros,
            origin,
            incidence,
        })
    }

    /// Pressures of each variable (boxes by variables); with `inertia`, accelerations bend the structure.
    fn pressures(&self, q: f64, elastic: Elastic, inertia: bool) -> Mat<f64> {
        let flexibility = match elastic {
            Elastic::Rigid => return self.aero.pressures(self.incidence.as_ref()),
            Elastic::Restrained => &self.restrained,
            Elastic::Unrestrained => &self.unrestrained,
        };
        let mut w = self.incidence.clone();
        if inertia {
            w -= &self.theta * &self.sag;
        }
        let feedback = &self.theta * (flexibility * &self.gather);
        let n = self.lattice.len();
        let unit = self.aero.pressures(Mat::<f64>::identity(n, n).as_ref());
        let system = Mat::<f64>::identity(n, n) - (feedback * &unit) * faer::Scale(q);
        &unit * system.partial_piv_lu().solve(&w)
    }

    /// Force and moment coefficients (`CX`, `CY`, `CZ`, `Cl`, `Cm`, `Cn` in the reference axes, about their origin) per unit of each variable.
    pub fn derivatives(&self, q: f64, elastic: Elastic) -> BTreeMap<String, [f64; 6]> {
        let cp = self.pressures(q, elastic, elastic == Elastic::Restrained);
        let sums = self.axes.transpose() * (&self.gather * cp);
        let (b, c) = (self.aeros.span_length, self.aeros.chord);
        let lengths = [1.0, 1.0, 1.0, b, c, b].map(|length| length * self.aeros.area);
        let of = |j: usize| std::array::from_fn(|i| sums[(i, j)] / lengths[i]);
        self.variables.iter().enumerate().map(|(j, name)| (name.clone(), of(j))).collect()
    }

    /// Neutral point: x in the basic system about which the moment does not follow the angle of attack; nothing without ANGLEA.
    pub fn neutral_point_x(&self, q: f64, elastic: Elastic) -> Option<f64> {
        let all = self.derivatives(q, elastic);
        let alpha = all.get("ANGLEA")?;
        Some(self.origin.x + self.aeros.chord * alpha[4] / alpha[2])
    }

    /// The balanced aircraft: `fixed` variables as given, all others from the balance of the SUPORT motions.
    ///
    /// # Errors
    /// If a fixed variable is unknown, there are not as many free variables as SUPORT motions, or a free variable cannot be
    /// determined; it is named.
    pub fn trim(&self, q: f64, fixed: &[(String, f64)]) -> Result<TrimmedDeck, AircraftError> {
        let mut x: Vec<Option<f64>> = vec![None; self.variables.len()];
        x[0] = Some(1.0);
        for (label, value) in fixed {
            let at = self.variables.iter().position(|name| name == label).ok_or_else(|| {
                InputError::general(format!("{label} is no variable of the trim"))
                    .with_help(format!("there are {}", self.variables[1..].join(", ")))
            })?;
            x[at] = Some(*value);
        }
        let cp = self.pressures(q, Elastic::Restrained, true);
        let air = (self.motions.transpose() * (&self.gather * &cp)) * faer::Scale(q);
        let balance = air - &self.inertia;
        let rows: Vec<usize> = (0..balance.nrows()).collect();
        let row_names = vec!["motions of SUPORT"; rows.len()];
        let asked = Balance { matrix: &balance, rows: &rows, row_names: &row_names, names: &self.variables };
        let values = asked.solve(&x).map_err(|why| {
            InputError::general(format!("there is no such trim: {why}")).with_help(
                "leave as many variables free as motions are supported, each with an effect of its own",
            )
        })?;
        let cp: Vec<f64> = (0..cp.nrows())
            .map(|row| values.iter().enumerate().map(|(j, value)| cp[(row, j)] * value).sum())
            .collect();
        Ok(TrimmedDeck {
            lift: cp.iter().zip(&self.area).map(|(cp, area)| q * area * cp).collect(),
            cp,
            values: self.variables.iter().cloned().zip(values).collect(),
        })
    }

    /// As [`TrimDeck::trim`], for a TRIM card; the deck must have been built with its Mach number.
    ///
    /// # Errors
    /// As [`TrimDeck::trim`].
    pub fn trim_card(&self, card: &Trim) -> Result<TrimmedDeck, AircraftError> {
        self.trim(card.q, &card.fixed)
    }
}

fn assembled(bulk: &BulkData) -> Result<System, InputError> {
    System::assemble(&Model::from_bulk(bulk)?)
}

/// The structure clamped at its SUPORT motions.
fn held(bulk: &BulkData) -> Result<System, InputError> {
    let mut bulk = bulk.clone();
    for support in &bulk.supports {
        let clamp = Spc1 {
            set: 1,
            components: support.components.clone(),
            grids: vec![support.grid],
            span: support.span.clone(),
        };
        bulk.constraints.push(clamp);
    }
    assembled(&bulk)
}

/// The rigid motions of the SUPORT components, g-set by motions.
fn support_motions(bulk: &BulkData, free: &System) -> Result<Mat<f64>, InputError> {
    let [support, rest @ ..] = bulk.supports.as_slice() else {
        return Err(InputError::general("the deck has no SUPORT, which trim needs"));
    };
    let node = free.node_index(support.grid).ok_or_else(|| {
        InputError::at(&support.span, format!("GRID {} of SUPORT is not there", support.grid))
    })?;
    if rest.iter().any(|other| other.grid != support.grid) || bulk.grids[&support.grid].cd != 0 {
        return Err(InputError::at(&support.span, "SUPORT names several grids, or one with its own axes")
            .with_help("support one grid with basic displacement axes"));
    }
    let rigid = free.rigid_body(&free.points()[node]);
    let columns: Vec<usize> =
        bulk.supports.iter().flat_map(|s| &s.components).map(|c| usize::from(*c) - 1).collect();
    Ok(Mat::from_fn(rigid.nrows(), columns.len(), |i, j| rigid[(i, columns[j])]))
}

/// Unit motions along and about the reference axes.
fn reference_motions(free: &System, origin: &Point3<f64>, axes: &Matrix3<f64>) -> Mat<f64> {
    let rigid = free.rigid_body(origin);
    Mat::from_fn(rigid.nrows(), 6, |i, j| {
        (0..3).map(|k| rigid[(i, 3 * (j / 3) + k)] * axes[(k, j % 3)]).sum()
    })
}

/// Incidence by displacement and load by pressure, on the s-set.
fn coupling_matrices(spline: &Spline, s_dofs: &[usize], integration: &Integration) -> (Mat<f64>, Mat<f64>) {
    let n = integration.len();
    let (mut theta, mut gather) = (Mat::zeros(n, s_dofs.len()), Mat::zeros(s_dofs.len(), n));
    for (row, entries) in spline.rows().iter().enumerate() {
        let j = row / 2;
        let arm = if row % 2 == 0 { 1.0 } else { integration.moment_arm(j) };
        for (dof, value) in entries {
            let at = s_dofs.binary_search(dof).expect("the s-set is what the spline uses");
            gather[(at, j)] += value * arm * integration.area(j);
            if row % 2 == 1 {
                theta[(j, at)] += value;
            }
        }
    }
    (theta, gather)
}

/// The structure on the s-set.
struct Reduced {
    restrained: Mat<f64>,
    unrestrained: Mat<f64>,
    sag: Mat<f64>,
    inertia: Mat<f64>,
}

impl Reduced {
    fn new(
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
        let m_rr = d.transpose() * &md;
        let factor = m_rr.partial_piv_lu();
        // B = D M_rr^-1 (s by r): R F Rᵀ = F - B C - Cᵀ Bᵀ + B E Bᵀ
        let b = factor.solve(at(d).transpose()).transpose().to_owned();
        let c = md.transpose() * &f_gs;
        let e = md.transpose() * displaced(md.as_ref());
        let restrained = at(&f_gs);
        let bc = &b * &c;
        let unrestrained = &restrained - &bc - bc.transpose() + &b * e * b.transpose();
        if unrestrained.col_iter().any(|column| column.iter().any(|value| !value.is_finite())) {
            let message = "no mass moves with a SUPORT motion";
            return Err(CouplingError::from(InputError::general(message)).into());
        }
        Ok(Self { restrained, unrestrained, sag: at(&displaced(ma.as_ref())), inertia: d.transpose() * ma })
    }
}

type Variables = (Vec<String>, Mat<f64>, Vec<Option<usize>>);

/// Names, incidence, and which acceleration each variable is.
fn variables(
    bulk: &BulkData,
    lattice: &Lattice,
    aeros: &Aeros,
    origin: &Point3<f64>,
) -> Result<Variables, InputError> {
    let n = lattice.len();
    let mut all = vec![("INTERCEPT".to_owned(), camber_and_twist(bulk, lattice)?, None)];
    let rate =
        |axis: Vector3<f64>, length: f64| incidence::rotation_rate(lattice, &axis, origin, length / 2.0);
    for card in bulk.trim_variables.values() {
        let label = card.label.to_ascii_uppercase();
        let (column, acceleration) = match label.as_str() {
            "ANGLEA" => (incidence::angle_of_attack(lattice), None),
            "SIDES" => (incidence::sideslip(lattice), None),
            "ROLL" => (rate(-Vector3::x(), aeros.span_length), None),
            "PITCH" => (rate(Vector3::y(), aeros.chord), None),
            "YAW" => (rate(-Vector3::z(), aeros.span_length), None),
            "URDD1" | "URDD2" | "URDD3" | "URDD4" | "URDD5" | "URDD6" => {
                (vec![0.0; n], label.bytes().last().map(|digit| usize::from(digit - b'1')))
            }
            _ => {
                return Err(InputError::at(&card.span, format!("AESTAT {label} is no trim variable"))
                    .with_help("expected ANGLEA, SIDES, ROLL, PITCH, YAW or URDD1 to URDD6"));
            }
        };
        all.push((label, column, acceleration));
    }
    all.extend(
        ControlSurface::all_from_bulk(bulk, lattice)?
            .into_iter()
            .map(|c| (c.name.clone(), c.column(n), None)),
    );
    let incidence = Mat::from_fn(n, all.len(), |j, at| all[at].1[j]);
    let accelerations = all.iter().map(|one| one.2).collect();
    Ok((all.into_iter().map(|one| one.0).collect(), incidence, accelerations))
}
