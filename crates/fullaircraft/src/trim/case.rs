//! Balanced flight of the elastic aircraft with any set of free variables against any set of motions.
//!
//! ```text
//! P = q W S Q (D G u + sum w_x x) + q S f_e,   u = F (Gᵀ P - M r a)      (held at the wing's root, where angles are counted)
//! rᵀ (Gᵀ P + thrust) - rᵀ M r a = 0            six equations, a = what an accelerometer feels
//! ```
//! All is linear in the variables x and the motions a, so one factorisation an airspeed gives a unit solution for each, and a
//! trim is a system of at most six equations. In balanced flight the reaction where the structure is held is zero, so
//! inertia relief is complete; with mean axes instead only angles and deflections are counted from elsewhere.
//! Motions that are neither asked for nor held come out as they may. Small angles: loads act on the undeformed places, no
//! drag, no suction, no centrifugal forces (ω² r is 2 m/s² at the tip of a 3.6 m wing rolling at 60 deg/s, along the span).

use crate::aircraft::assembly::Aircraft;
use crate::aircraft::file::FlightPoint;
use crate::error::AircraftError;
use crate::stations::nodal::NodalLoads;
use crate::stations::places::Station;
use crate::trim::balance::Balance;
use crate::trim::model::{FlightModel, Trimmed};
use crate::trim::variables::{Acts, MOTION_UNITS, MOTIONS, TrimVariables, motion};
use aero::Flow;
use coupling::wing_file::StationAt;
use coupling::{CouplingError, RootLoads, SupportedStructure};
use faer::linalg::solvers::Solve;
use faer::{Mat, MatRef};
use nalgebra::{Point3, Vector3};
use std::sync::atomic::{AtomicUsize, Ordering};

/// What each of the six equations balances.
const ROWS: [&str; 6] =
    ["force ahead", "side force", "vertical force", "rolling moment", "pitching moment", "yawing moment"];

/// A trim: names as in [`crate::trim::variables`], values in the units the names say.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TrimCase {
    /// What errors call it.
    pub name: String,
    /// Airspeed, m/s.
    pub v_m_s: f64,
    /// Variables with values; those neither here nor free are zero.
    pub given: Vec<(String, f64)>,
    /// Variables to be found.
    pub free: Vec<String>,
    /// Motions asked for, as many as there are free variables.
    pub targets: Vec<(String, f64)>,
    /// Motions that do not happen whatever the forces: the structure is held there.
    pub held: Vec<String>,
}

/// What all trims of an aircraft share: variables, stations, and how box loads come together.
#[derive(Debug)]
pub struct TrimTools<'a> {
    /// The aircraft.
    pub aircraft: &'a Aircraft,
    /// Variables.
    pub variables: TrimVariables,
    /// Stations of the wings.
    pub stations: Vec<Station>,
    /// Loads of the stations by box loads (six rows a station, two columns a box).
    air: Mat<f64>,
    /// Loads of the stations by acceleration along and about the axes, about the centre of gravity: to be taken off.
    pub(crate) inertia: Mat<f64>,
    /// Forces and moments about the centre of gravity by box loads, 6 by two a box.
    pub(crate) sums: Mat<f64>,
    factorisations: AtomicUsize,
}

/// A model at one airspeed, solved for a unit of each variable and motion. Columns: fixed, variables, motions.
#[derive(Debug)]
pub struct TrimAt<'a> {
    tools: &'a TrimTools<'a>,
    v_m_s: f64,
    names: Vec<String>,
    /// Displacement of the s-set.
    u: Mat<f64>,
    /// Box loads, two rows a box.
    loads: Mat<f64>,
    /// Six equations of balance.
    balance: Mat<f64>,
    /// Loads of the stations, six rows each.
    stations: Mat<f64>,
}

/// A trim that was found: values of all columns of its [`TrimAt`].
#[derive(Debug, Clone, PartialEq)]
pub struct Balanced {
    /// Fixed (1), variables, motions.
    pub(crate) x: Vec<f64>,
}

impl<'a> TrimTools<'a> {
    /// Tools for an aircraft whose roots and further `points` are monitored.
    ///
    /// # Errors
    /// If a point has nothing outboard of it.
    pub fn new(aircraft: &'a Aircraft, points: &[StationAt]) -> Result<Self, AircraftError> {
        let stations = aircraft.wing_stations(points)?;
        let field = aircraft.free.inertia_loads(aircraft.free.rigid_body(&reference(aircraft)).as_ref());
        let mut air = Mat::zeros(6 * stations.len(), 2 * aircraft.flow.lattice.len());
        let mut inertia = Mat::zeros(6 * stations.len(), MOTIONS.len());
        for (at, station) in stations.iter().enumerate() {
            let motions = station.motions(&aircraft.free, &station.point);
            let boxes = aircraft.spline.displace(motions.as_ref());
            air.as_mut().subrows_mut(6 * at, 6).copy_from(boxes.transpose());
            inertia.as_mut().subrows_mut(6 * at, 6).copy_from(motions.transpose() * &field);
        }
        Ok(Self {
            aircraft,
            variables: TrimVariables::new(aircraft),
            stations,
            air,
            inertia,
            sums: sums(aircraft),
            factorisations: AtomicUsize::new(0),
        })
    }

    /// How often an elastic aircraft at an airspeed has been factorised with these tools.
    pub fn factorisations(&self) -> usize {
        self.factorisations.load(Ordering::Relaxed)
    }

    /// A model at an airspeed: one factorisation, for any number of trims.
    ///
    /// # Errors
    /// If the aircraft diverges at this airspeed.
    pub fn at(&'a self, model: &FlightModel<'_>, v_m_s: f64) -> Result<TrimAt<'a>, AircraftError> {
        let held = self.aircraft.held()?;
        let flow = Flow { v_m_s, rho_kg_m3: model.rho_kg_m3 };
        let q_pa = flow.dynamic_pressure_pa();
        let divergence_pa = model.divergence_pressure_pa()?;
        if divergence_pa.is_some_and(|limit_pa| q_pa >= limit_pa) {
            return Err(CouplingError::Diverged { q_pa, divergence_pa }.into());
        }
        self.factorisations.fetch_add(1, Ordering::Relaxed);
        let factor = self.aircraft.flow.factorise(held, flow, &model.corrections)?;
        let cp = self.pressures(v_m_s);
        let mut u = &held.flexibility * &held.gather(model.loads(q_pa, cp.as_ref()).as_ref());
        let first = cp.ncols() - MOTIONS.len();
        for (motion, unit) in MOTION_UNITS.iter().enumerate() {
            for row in 0..held.size() {
                u[(row, first + motion)] -= self.sag(held, row, motion) * unit;
            }
        }
        let u = factor.solve(&u);
        let cp = cp + self.aircraft.flow.pressures_by_displacement() * &u;
        let loads = model.loads(q_pa, cp.as_ref());
        let mut balance = &self.sums * &loads;
        let mut stations = &self.air * &loads;
        for (motion, unit) in MOTION_UNITS.iter().enumerate() {
            for row in 0..6 {
                balance[(row, first + motion)] -= self.aircraft.inertia.mass[(row, motion)] * unit;
            }
            for row in 0..stations.nrows() {
                stations[(row, first + motion)] -= self.inertia[(row, motion)] * unit;
            }
        }
        for (at, variable) in self.variables.all.iter().enumerate() {
            if let Acts::Force(force) = variable.acts {
                (0..6).for_each(|row| balance[(row, 1 + at)] += force[row] * variable.unit);
            }
        }
        Ok(TrimAt { tools: self, v_m_s, names: self.names(), u, loads, balance, stations })
    }

    /// Displacement of the s-set per unit acceleration; translations are those of the held structure, so that a structure
    /// given as numbers keeps its own.
    fn sag(&self, held: &SupportedStructure, row: usize, motion: usize) -> f64 {
        if motion < 3 { held.sag[(row, motion)] } else { self.aircraft.inertia.sag[(row, motion)] }
    }

    /// Names of all columns.
    fn names(&self) -> Vec<String> {
        let variables = self.variables.all.iter().map(|variable| variable.name.clone());
        std::iter::once("fixed".to_owned()).chain(variables).chain(MOTIONS.map(str::to_owned)).collect()
    }

    /// Pressures of the undeformed aircraft per unit of each column.
    pub(crate) fn pressures(&self, v_m_s: f64) -> Mat<f64> {
        let unit = &self.variables.pressures;
        let columns = 1 + self.variables.all.len() + MOTIONS.len();
        Mat::from_fn(unit.nrows(), columns, |j, column| {
            if column == 0 {
                return unit[(j, 0)];
            }
            let Some(variable) = self.variables.all.get(column - 1) else { return 0.0 };
            match variable.acts {
                Acts::Flow(at) => unit[(j, at)] * variable.unit,
                Acts::Rate(at) => unit[(j, at)] * variable.unit / v_m_s,
                Acts::Force(_) => 0.0,
            }
        })
    }
}

impl TrimAt<'_> {
    /// Finds a trim.
    ///
    /// # Errors
    /// Names that are not known; [`AircraftError::NotTrimmable`] if the free variables do not determine each other or cannot
    /// give what is asked for.
    pub fn solve(&self, case: &TrimCase) -> Result<Balanced, AircraftError> {
        let first = 1 + self.tools.variables.all.len();
        let mut x: Vec<Option<f64>> = vec![Some(0.0); self.names.len()];
        x[0] = Some(1.0);
        for (name, value) in &case.given {
            x[1 + self.tools.variables.place(name)?] = Some(*value);
        }
        for name in &case.free {
            x[1 + self.tools.variables.place(name)?] = None;
        }
        let mut outcome: Vec<usize> = (0..MOTIONS.len()).collect();
        for name in &case.held {
            let at = motion(name)?;
            outcome.retain(|row| *row != at);
        }
        let mut asked = Vec::new();
        for (name, value) in &case.targets {
            let at = motion(name)?;
            x[first + at] = Some(*value);
            outcome.retain(|row| *row != at);
            asked.push(at);
        }
        let refuse = |why: String| AircraftError::NotTrimmable {
            point: case.name.clone(),
            v_m_s: self.v_m_s,
            load_factor: case.load_factor(),
            why,
        };
        if case.free.len() != asked.len() {
            let (count, free, targets) = (case.free.len(), case.free.join(", "), asked.len());
            return Err(refuse(format!(
                "{count} variables are free ({free}) for {targets} motions asked for"
            )));
        }
        let answers = self.answers(&outcome, first);
        let mut matrix = self.balance.clone();
        for row in (0..MOTIONS.len()).filter(|row| !outcome.contains(row)) {
            for column in 0..matrix.ncols() {
                for (k, motion) in outcome.iter().enumerate() {
                    matrix[(row, column)] += self.balance[(row, first + motion)] * answers[(k, column)];
                }
            }
        }
        let balance = Balance { matrix: &matrix, rows: &asked, row_names: &ROWS, names: &self.names };
        let mut x = balance.solve(&x).map_err(refuse)?;
        let outcomes = combine(answers.as_ref(), &x);
        for (motion, value) in outcome.iter().zip(outcomes) {
            x[first + motion] = value;
        }
        Ok(Balanced { x })
    }

    /// What motions nobody asks for become per unit of each column (their own columns: zero), by their own equations.
    fn answers(&self, outcome: &[usize], first: usize) -> Mat<f64> {
        let n = outcome.len();
        let own = Mat::from_fn(n, n, |i, j| self.balance[(outcome[i], first + outcome[j])]);
        let by = Mat::from_fn(n, self.balance.ncols(), |i, column| {
            let unknown = outcome.iter().any(|motion| first + motion == column);
            if unknown { 0.0 } else { -self.balance[(outcome[i], column)] }
        });
        own.partial_piv_lu().solve(&by)
    }

    /// Airspeed, m/s.
    pub fn v_m_s(&self) -> f64 {
        self.v_m_s
    }

    /// Value of a variable or motion, in the unit its name says.
    pub fn value(&self, balanced: &Balanced, name: &str) -> Option<f64> {
        self.names.iter().position(|known| known == name).map(|at| balanced.x[at])
    }

    /// All variables and motions with their values.
    pub fn values<'b>(&'b self, balanced: &'b Balanced) -> impl Iterator<Item = (&'b str, f64)> {
        self.names.iter().map(String::as_str).zip(balanced.x.iter().copied()).skip(1)
    }

    /// Loads of each station: Fz (N), Mx, My (N m).
    pub fn station_loads(&self, balanced: &Balanced) -> Vec<[f64; 3]> {
        let all = combine(self.stations.as_ref(), &balanced.x);
        all.chunks_exact(6).map(|six| [six[2], six[3], six[4]]).collect()
    }

    /// Loads at all nodes. Thrust is put where the structure is held for statics (the fuselage at the wing's root).
    pub fn nodal_loads(&self, balanced: &Balanced) -> NodalLoads {
        let aircraft = self.tools.aircraft;
        let loads = self.box_loads(balanced);
        let air = aircraft.spline.loads(Mat::from_fn(loads.len(), 1, |k, _| loads[k]).as_ref());
        let first = 1 + self.tools.variables.all.len();
        let about = reference(aircraft);
        let felt = Mat::from_fn(6, 1, |motion, _| -balanced.x[first + motion] * MOTION_UNITS[motion]);
        let felt = aircraft.free.rigid_body(&about) * felt;
        let inertia = aircraft.free.inertia_loads(felt.as_ref());
        let mut thrust = vec![0.0; air.nrows()];
        let (at, arm) = (6 * aircraft.centre, about - aircraft.free.points()[aircraft.centre]);
        for (place, variable) in self.tools.variables.all.iter().enumerate() {
            let Acts::Force(force) = variable.acts else { continue };
            let newtons = balanced.x[1 + place] * variable.unit;
            let shift = arm.cross(&Vector3::new(force[0], force[1], force[2]));
            for axis in 0..3 {
                thrust[at + axis] += newtons * force[axis];
                thrust[at + 3 + axis] += newtons * (force[3 + axis] + shift[axis]);
            }
        }
        let column = |of: &Mat<f64>| of.col_as_slice(0).to_vec();
        NodalLoads { damping: vec![0.0; thrust.len()], air: column(&air), inertia: column(&inertia), thrust }
    }

    /// Height of the right and left tip over the plane of the centre, m.
    pub fn tip_deflection_m(&self, balanced: &Balanced) -> [f64; 2] {
        let aircraft = self.tools.aircraft;
        [&aircraft.right, &aircraft.left].map(|wing| {
            let row =
                aircraft.held().ok().and_then(|held| held.s_dofs.binary_search(&(6 * wing.tip + 2)).ok());
            row.map_or(f64::NAN, |row| balanced.x.iter().enumerate().map(|(k, x)| self.u[(row, k)] * x).sum())
        })
    }

    /// Displacement of the s-set against the centre, m and rad.
    pub fn displacement(&self, balanced: &Balanced) -> Vec<f64> {
        combine(self.u.as_ref(), &balanced.x)
    }

    /// Corrected box loads, two a box, N and N m.
    pub fn box_loads(&self, balanced: &Balanced) -> Vec<f64> {
        combine(self.loads.as_ref(), &balanced.x)
    }

    /// Forces (N) and moments about the centre of gravity (N m) of the air, along and about x, y, z.
    pub fn air_loads(&self, balanced: &Balanced) -> [f64; 6] {
        let loads = self.box_loads(balanced);
        std::array::from_fn(|row| {
            loads.iter().enumerate().map(|(k, load)| self.tools.sums[(row, k)] * load).sum()
        })
    }
}

impl TrimAt<'_> {
    /// All of a trim, as flight at a point.
    pub fn trimmed(&self, balanced: &Balanced, point: &FlightPoint) -> Trimmed {
        let elevator = format!("{}_deg", self.tools.aircraft.file.htp.control.name);
        let rad = |name: &str| self.value(balanced, name).map_or(0.0, f64::to_radians);
        let (air, stations) = (self.air_loads(balanced), self.station_loads(balanced));
        Trimmed {
            point: *point,
            alpha_rad: rad("alpha_deg"),
            elevator_rad: rad(&elevator),
            tip_deflection_m: self.tip_deflection_m(balanced),
            displacement: self.displacement(balanced),
            fz_n: air[2],
            my_nm: air[4],
            root_loads: [0, 1].map(|side| RootLoads::from_array(stations[side])),
            box_loads: self.box_loads(balanced),
        }
    }
}

impl TrimCase {
    /// The load factor asked for, or one.
    pub fn load_factor(&self) -> f64 {
        self.targets.iter().find(|(name, _)| name == MOTIONS[2]).map_or(1.0, |(_, value)| *value)
    }
}

/// A matrix times a vector.
fn combine(matrix: MatRef<'_, f64>, x: &[f64]) -> Vec<f64> {
    (0..matrix.nrows()).map(|row| x.iter().enumerate().map(|(k, x)| matrix[(row, k)] * x).sum()).collect()
}

/// What trims count moments and angular motions about: the centre of gravity on the aircraft's axis.
fn reference(aircraft: &Aircraft) -> Point3<f64> {
    Point3::new(aircraft.file.total.x_cg_m, 0.0, 0.0)
}

/// Forces and moments about the centre of gravity by box loads: along the normal at the midpoint, about the pitch axis.
fn sums(aircraft: &Aircraft) -> Mat<f64> {
    let lattice = &aircraft.flow.lattice;
    let about = reference(aircraft);
    let mut rows = Mat::zeros(6, 2 * lattice.len());
    for (j, panel) in lattice.boxes.iter().enumerate() {
        let (n, e) = (panel.normal(), panel.pitch_axis());
        let moment = (panel.mid_point() - about).cross(&n);
        for axis in 0..3 {
            rows[(axis, 2 * j)] = n[axis];
            rows[(3 + axis, 2 * j)] = moment[axis];
            rows[(3 + axis, 2 * j + 1)] = e[axis];
        }
    }
    rows
}
