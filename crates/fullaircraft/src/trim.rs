//! Balanced flight of the elastic aircraft at a given load factor, airspeed and pitch rate.
//!
//! ```text
//! P = q W S Q (D G u + alpha n_z + (x - x_cg) rate/V + camber + elevator) + q S f_e
//! u = F (Gᵀ P - n g M z)          (held at the centre, where alpha is counted)
//! sum Fz = n m g,   sum My about the centre of gravity = 0
//! ```
//! Everything is linear in alpha and elevator, so two unit solutions and one constant give both by a 2 by 2 system; with
//! wings only, alpha follows from the lift alone. Load factor, airspeed and pitch rate are taken as they are:
//! a steady pull-up has the pitch rate (n - 1) g/V, and [`FlightPoint::warning`] says so if it has not.
//! Small angles: lift is along z, the weight's component along x is left out, loads act on the undeformed places.

use crate::aircraft::{Aircraft, WingPlaces};
use crate::aircraft_file::{FlightPoint, Surfaces};
use crate::error::AircraftError;
use aero::{Corrections, Flow, incidence};
use coupling::{Balance, CouplingError, GRAVITY_M_S2, RootLoads, SupportedStructure, root_rows};
use faer::linalg::solvers::Solve;
use faer::{Mat, MatRef};
use nalgebra::{Point3, Vector3};

/// Pitch rates that differ by more than this share are warned about.
const PITCH_RATE_TOLERANCE: f64 = 0.02;
/// A 2 by 2 system whose columns are as parallel as this has no solution worth the name.
const SINGULAR: f64 = 1e-6;

impl FlightPoint {
    /// Pitch rate of a steady pull-up or push-down with this load factor: (n - 1) g/V, rad/s.
    pub fn steady_pitch_rate_rad_s(&self) -> f64 {
        (self.load_factor - 1.0) * GRAVITY_M_S2 / self.v_m_s
    }

    /// A sentence if the pitch rate is more than 2 % off (n - 1) g/V.
    pub fn warning(&self, name: &str) -> Option<String> {
        let steady_deg_s = self.steady_pitch_rate_rad_s().to_degrees();
        let off = (self.pitch_rate_deg_s - steady_deg_s).abs();
        (off > PITCH_RATE_TOLERANCE * steady_deg_s.abs()).then(|| {
            format!(
                "{name}: the pitch rate {} deg/s is not that of steady flight, (n - 1) g/V = {steady_deg_s:.2} deg/s; \
                 all three numbers are used as given",
                self.pitch_rate_deg_s
            )
        })
    }
}

/// An aircraft with corrections of its wings.
#[derive(Debug)]
pub struct FlightModel<'a> {
    /// The aircraft.
    pub aircraft: &'a Aircraft,
    /// Corrections of all boxes in the flow.
    pub corrections: Corrections,
}

/// The aircraft in balanced flight.
#[derive(Debug, Clone)]
pub struct Trimmed {
    /// Where.
    pub point: FlightPoint,
    /// Angle of the centre (the wing's root) against the flow, rad.
    pub alpha_rad: f64,
    /// Elevator, trailing edge down, rad; zero with wings only.
    pub elevator_rad: f64,
    /// Height of the right and left tip over the plane of the centre, m.
    pub tip_deflection_m: [f64; 2],
    /// Displacement of the s-set (the degrees of freedom the boxes follow) against the centre, m and rad.
    pub displacement: Vec<f64>,
    /// Corrected box loads, two a box, N and N m.
    pub box_loads: Vec<f64>,
    /// Lift, N.
    pub fz_n: f64,
    /// Pitching moment about the centre of gravity, nose up, N m: what wings alone leave unbalanced.
    pub my_nm: f64,
    /// What right and left wing put on the fuselage, weight and inertia included, about the wing's balance
    /// point, aircraft axes on both sides (so Mx of the left wing is negative under lift).
    pub root_loads: [RootLoads; 2],
}

impl Aircraft {
    /// The aircraft with corrections of one wing's boxes, mirrored to the other.
    ///
    /// # Errors
    /// If there is not one entry for each box of the wing.
    pub fn with_corrections(&self, wing: &Corrections) -> Result<FlightModel<'_>, AircraftError> {
        Ok(FlightModel { aircraft: self, corrections: self.corrections(wing)? })
    }

    /// The aircraft as modelled before any measurement.
    pub fn uncorrected(&self) -> FlightModel<'_> {
        FlightModel { aircraft: self, corrections: Corrections::neutral(self.flow.lattice.len()) }
    }

    /// The structure held at the centre.
    pub(crate) fn held(&self) -> Result<&SupportedStructure, AircraftError> {
        let missing = CouplingError::Size { what: "held structures", got: 0, expected: 1 };
        self.flow.supported.as_ref().ok_or_else(|| missing.into())
    }

    /// The point a wing's root loads are about: the balance of the wing's file.
    pub fn root_point(&self) -> Point3<f64> {
        let balance = &self.wing.balance;
        Point3::new(balance.x_m, balance.y_m, balance.z_m)
    }

    /// Root loads of box loads of one wing: 3 rows by two columns a box.
    pub(crate) fn wing_root_rows(&self, wing: &WingPlaces) -> Mat<f64> {
        let mut metric = vec![false; self.flow.lattice.len()];
        for &at in &wing.boxes {
            metric[at] = true;
        }
        root_rows(&self.flow.lattice, &Balance { point: self.root_point(), metric })
    }

    /// Root loads (3 rows) of nodal loads on one wing, g-set columns.
    pub(crate) fn wing_nodal_loads(&self, wing: &WingPlaces, f_g: MatRef<'_, f64>) -> Mat<f64> {
        let about = self.root_point();
        let mut root = Mat::zeros(3, f_g.ncols());
        for column in 0..f_g.ncols() {
            for &node in &wing.nodes {
                let part = |from: usize| Vector3::from_fn(|axis, _| f_g[(6 * node + from + axis, column)]);
                let (force, moment) = (part(0), part(3));
                let moment = moment + (self.free.points()[node] - about).cross(&force);
                root[(0, column)] += force.z;
                root[(1, column)] += moment.x;
                root[(2, column)] += moment.y;
            }
        }
        root
    }
}

impl FlightModel<'_> {
    /// Balanced flight at a point; `name` is what errors call it.
    ///
    /// # Errors
    /// [`AircraftError::NotTrimmable`] if the aircraft diverges at this speed or nothing balances it.
    pub fn trim(&self, name: &str, point: &FlightPoint) -> Result<Trimmed, AircraftError> {
        let refuse = |why: String| AircraftError::NotTrimmable {
            point: name.to_owned(),
            v_m_s: point.v_m_s,
            load_factor: point.load_factor,
            why,
        };
        let (aircraft, flow) = (self.aircraft, self.flow(point));
        let (held, q_pa) = (aircraft.held()?, flow.dynamic_pressure_pa());
        let factor =
            aircraft.flow.factorise(held, flow, &self.corrections).map_err(|e| refuse(e.to_string()))?;
        let rigid = self.rigid_pressures(point);
        let mut u = &held.flexibility * &held.gather(self.loads(q_pa, rigid.as_ref()).as_ref());
        for row in 0..held.size() {
            u[(row, 0)] -= held.sag[(row, 2)] * point.load_factor * GRAVITY_M_S2;
        }
        let u = factor.solve(&u);
        let cp = &rigid + aircraft.flow.pressures_by_displacement() * &u;
        let loads = self.loads(q_pa, cp.as_ref());
        let sums = &aircraft.flow.root_rows * &loads;
        let weight_n = point.load_factor * aircraft.mass.mass_kg * GRAVITY_M_S2;
        let (alpha_rad, elevator_rad) = self.balance(&sums, weight_n).map_err(refuse)?;
        let combine = |m: &Mat<f64>| -> Vec<f64> {
            (0..m.nrows()).map(|i| m[(i, 0)] + m[(i, 1)] * alpha_rad + m[(i, 2)] * elevator_rad).collect()
        };
        let (displacement, total) = (combine(&u), combine(&sums));
        let box_loads = combine(&loads);
        Ok(Trimmed {
            point: *point,
            alpha_rad,
            elevator_rad,
            tip_deflection_m: [&aircraft.right, &aircraft.left].map(|wing| {
                held.s_dofs.binary_search(&(6 * wing.tip + 2)).map_or(f64::NAN, |at| displacement[at])
            }),
            displacement,
            fz_n: total[0],
            my_nm: total[2],
            root_loads: self.root_loads(&box_loads, point.load_factor),
            box_loads,
        })
    }

    /// Airspeed and density of a point.
    pub fn flow(&self, point: &FlightPoint) -> Flow {
        Flow { v_m_s: point.v_m_s, rho_kg_m3: self.aircraft.file.rho_kg_m3 }
    }

    /// Pressures of the undeformed aircraft: fixed part (camber and pitch rate), per rad alpha, per rad elevator.
    fn rigid_pressures(&self, point: &FlightPoint) -> Mat<f64> {
        let wing = &self.aircraft.flow;
        let rate = incidence::pitch_rate(&wing.lattice, self.aircraft.file.total.x_cg_m, point.v_m_s);
        let rate = wing.pressures(MatRef::from_column_major_slice(&rate, rate.len(), 1));
        let (alpha, camber, controls) =
            (wing.pressures_by_alpha(), wing.pressures_of_camber(), self.elevator());
        let rate_rad_s = point.pitch_rate_deg_s.to_radians();
        Mat::from_fn(wing.lattice.len(), 3, |j, column| match column {
            0 => camber[j] + rate[(j, 0)] * rate_rad_s,
            1 => alpha[j],
            _ => controls.iter().map(|&at| wing.pressures_by_control()[(j, at)]).sum(),
        })
    }

    /// Both halves of the elevator; none with wings only.
    fn elevator(&self) -> Vec<usize> {
        self.aircraft
            .control_pair(&self.aircraft.file.htp.control.name)
            .map_or_else(|_| Vec::new(), Vec::from)
    }

    /// Box loads of pressures, the pressure offset in the first column.
    fn loads(&self, q_pa: f64, cp: MatRef<'_, f64>) -> Mat<f64> {
        let wing = &self.aircraft.flow;
        let mut loads = wing.k_loads_of_pressures(q_pa, cp, &self.corrections);
        for (j, f_e) in self.corrections.pressure_offset.iter().enumerate() {
            let lift = q_pa * wing.integration.area(j) * f_e;
            loads[(2 * j, 0)] += lift;
            loads[(2 * j + 1, 0)] += lift * wing.integration.moment_arm(j);
        }
        loads
    }

    /// Alpha and elevator from the sums (rows Fz, Mx, My; columns fixed, per alpha, per elevator).
    fn balance(&self, sums: &Mat<f64>, weight_n: f64) -> Result<(f64, f64), String> {
        let missing = weight_n - sums[(0, 0)];
        let (lift, pitch) = (sums[(0, 1)], sums[(2, 1)]);
        if self.aircraft.file.surfaces == Surfaces::WingsOnly {
            let alpha = missing / lift;
            return if alpha.is_finite() {
                Ok((alpha, 0.0))
            } else {
                Err("no lift follows alpha".to_owned())
            };
        }
        let (lift_e, pitch_e) = (sums[(0, 2)], sums[(2, 2)]);
        let determinant = lift * pitch_e - lift_e * pitch;
        let size = (lift * pitch_e).abs().max((lift_e * pitch).abs());
        if !determinant.is_finite() || determinant.abs() <= SINGULAR * size {
            return Err("alpha and elevator do the same, or the elevator does nothing".to_owned());
        }
        let alpha = (missing * pitch_e + lift_e * sums[(2, 0)]) / determinant;
        let elevator = (-lift * sums[(2, 0)] - pitch * missing) / determinant;
        Ok((alpha, elevator))
    }

    /// Root loads of box loads, with weight and inertia at a load factor.
    fn root_loads(&self, box_loads: &[f64], load_factor: f64) -> [RootLoads; 2] {
        let aircraft = self.aircraft;
        let rigid = aircraft.free.rigid_body(&aircraft.root_point());
        let field = aircraft.free.inertia_loads(rigid.as_ref().subcols(2, 1));
        [&aircraft.right, &aircraft.left].map(|wing| {
            let rows = aircraft.wing_root_rows(wing);
            let inertia = aircraft.wing_nodal_loads(wing, field.as_ref());
            RootLoads::from_array(std::array::from_fn(|row| {
                let air: f64 = box_loads.iter().enumerate().map(|(k, load)| rows[(row, k)] * load).sum();
                air - load_factor * GRAVITY_M_S2 * inertia[(row, 0)]
            }))
        })
    }
}
