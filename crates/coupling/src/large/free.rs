//! The free body that bends far, in balanced flight.
//!
//! ```text
//! f_inner(u) = f_air(u; alpha, delta, omega) + n f_weight(u; alpha)
//! sum over all nodes:   force normal to the stream = 0,   pitching moment = 0
//! ```
//! Held at one node, against which alpha is counted: at every state that Newton's method comes to, angle of attack and control are
//! those at which air and inertia balance each other there, so that the held node feels nothing (a statically determinate
//! hold, and no equations beside the structure's). Mass, centre of gravity and arms are those of the bent body. In steady flight
//! at load factor n all masses feel n g, normal to the stream; the centrifugal forces about the
//! centre of gravity are left out, as small deflections leave them out (they balance among themselves).

use super::air::{Air, Solved, Turning};
use super::boxes::{CarriedBoxes, CarriedPart};
use super::wake::Wake;
use crate::error::CouplingError;
use crate::wing::ElasticWing;
use aero::{BoxLoads, Corrections, Flow, Lattice};
use nalgebra::{Point3, Rotation3, Vector3};
use nastran::InputError;
use std::sync::{Mutex, PoisonError};
use structure::Model;
use structure::nonlinear::{Acting, Controls, LargeDeflection, Loads, Near, State};

/// What is left unbalanced, as a share of the weight (and of the weight on a mean chord).
const BALANCED: f64 = 1e-12;
/// Steps of the balance at one state.
const ROUNDS: usize = 12;
/// Differences for its matrix, rad.
const STEP: f64 = 1e-3;
/// What a step may leave of the one before: a matrix that leaves more is that of other angles (lift is by a sine) and is made again.
const LEFT: f64 = 0.1;

/// A body in free flight.
#[derive(Debug)]
pub struct FreeBody<'a> {
    elastic: &'a ElasticWing,
    /// Its structure, held at one node.
    pub structure: LargeDeflection,
    boxes: CarriedBoxes,
    centre: usize,
    /// N, under the gravity of [`ElasticWing::gravity_m_s2`].
    weight_n: f64,
}

/// What flight is asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct SteadyFlight {
    /// Airspeed and density.
    pub flow: Flow,
    /// What all masses feel, in g, normal to the stream.
    pub load_factor: f64,
    /// Nose up, rad/s.
    pub pitch_rate_rad_s: f64,
    /// The point the rate is about, m: the centre of gravity.
    pub about: Point3<f64>,
    /// Incidence of the boxes by the control that balances the pitching moment, per rad; none if nothing balances it.
    pub control: Option<Vec<f64>>,
    /// Where the wake goes.
    pub wake: Wake,
}

/// The body in flight.
#[derive(Debug, Clone)]
pub struct FreeState {
    /// Angle of the held node against the stream, rad.
    pub alpha_rad: f64,
    /// The control, rad.
    pub control_rad: f64,
    /// Where the structure is.
    pub state: State,
    /// Forces and moments of the air on the nodes (N, Nm; g-set, basic axes).
    pub air: Vec<f64>,
    /// Of weight and inertia.
    pub inertia: Vec<f64>,
    /// The boxes.
    pub lattice: Lattice,
    /// Corrected loads, two a box.
    pub box_loads: BoxLoads,
    /// Force (N) and moment about the held node (Nm) that the hold gives: nothing in balance.
    pub held: [f64; 6],
    /// Newton's iterations.
    pub iterations: usize,
}

impl<'a> FreeBody<'a> {
    /// From the body's lattice, the model of its structure (held at a node, by position), and what its boxes follow.
    ///
    /// # Errors
    /// If something in the structure cannot turn far, or it is loose.
    pub fn new(
        elastic: &'a ElasticWing,
        model: &Model,
        centre: usize,
        parts: &[CarriedPart],
    ) -> Result<Self, CouplingError> {
        let structure = LargeDeflection::new(model)?;
        let points: Vec<Point3<f64>> = structure.nodes().iter().map(|node| node.point).collect();
        let boxes = CarriedBoxes::of_parts(&elastic.lattice, elastic.plane, &points, parts);
        let mut body = Self { elastic, structure, boxes, centre, weight_n: 0.0 };
        let fields = body.fields(&body.structure.undeformed());
        body.weight_n = elastic.gravity_m_s2 * body.resultant(&body.structure.undeformed(), &fields[1])[2];
        if body.weight_n <= 0.0 {
            return Err(InputError::general("a body without mass does not fly").into());
        }
        Ok(body)
    }

    /// Weight, N.
    pub fn weight_n(&self) -> f64 {
        self.weight_n
    }

    /// Balanced flight with corrections of all boxes, the load grown from that without load factor where it must.
    ///
    /// # Errors
    /// If no balanced equilibrium is found; with the last load factor that was reached.
    pub fn fly(&self, flight: &SteadyFlight, corrections: &Corrections) -> Result<FreeState, CouplingError> {
        let at = |share: f64| -> Box<dyn Acting + '_> { Box::new(self.flying(flight, corrections, share)) };
        let path = self.structure.path_under(&self.structure.undeformed(), &at, &Controls::default());
        let failed = |reached: f64, why: String| CouplingError::NotBalanced {
            v_m_s: flight.flow.v_m_s,
            load_factor: flight.load_factor,
            reached: reached * flight.load_factor,
            why,
        };
        let path = path.map_err(|error| failed(error.reached(), error.to_string()))?;
        let end = path.end();
        let flying = self.flying(flight, corrections, 1.0);
        // The lattice is solved at the angle of attack that was found: twice, as the first is from none.
        let balanced = flying.balanced(&end.state).and_then(|_| flying.balanced(&end.state));
        let Some(balanced) = balanced else {
            return Err(failed(0.0, "the lattice of the bent body cannot be solved".to_owned()));
        };
        let iterations = path.points.iter().map(|point| point.iterations).sum();
        Ok(FreeState { iterations, ..balanced.reported(&end.state) })
    }

    fn flying<'b>(&'b self, flight: &SteadyFlight, corrections: &Corrections, share: f64) -> Flying<'b> {
        let load_factor = share * flight.load_factor;
        let pitch_rate_rad_s = share * flight.pitch_rate_rad_s;
        let flight = SteadyFlight { load_factor, pitch_rate_rad_s, ..flight.clone() };
        Flying { body: self, flight, corrections: corrections.clone(), known: Mutex::new([0.0; 2]) }
    }

    /// Forces on the nodes in unit fields of acceleration along x and z, per m/s^2.
    fn fields(&self, state: &State) -> [Vec<f64>; 2] {
        [Vector3::x(), Vector3::z()].map(|gravity_m_s2| {
            self.structure.load_forces(state, &Loads { gravity_m_s2, ..Loads::default() })
        })
    }

    /// Force, and moment about the held node, of forces on the nodes.
    fn resultant(&self, state: &State, forces: &[f64]) -> [f64; 6] {
        let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
        for (place, load) in state.places.iter().zip(forces.chunks_exact(6)) {
            let f = Vector3::new(load[0], load[1], load[2]);
            force += f;
            moment += Vector3::new(load[3], load[4], load[5]) + (place - state.places[self.centre]).cross(&f);
        }
        [force.x, force.y, force.z, moment.x, moment.y, moment.z]
    }
}

/// Air and inertia in balance.
struct Flying<'a> {
    body: &'a FreeBody<'a>,
    flight: SteadyFlight,
    /// Of all boxes.
    corrections: Corrections,
    /// Angle of attack and control of the last balance, rad.
    known: Mutex<[f64; 2]>,
}

/// The same with the lattice of one state.
struct Balancing<'a> {
    flying: &'a Flying<'a>,
    solved: Solved<'a>,
    /// Unit fields at that state.
    fields: [Vec<f64>; 2],
    /// Inverse of what angle of attack and control do to lift and moment, rad per N and Nm.
    inverse: [[f64; 2]; 2],
    /// The balance at that state, rad.
    trim: [f64; 2],
}

impl Flying<'_> {
    fn air(&self, [alpha_rad, control_rad]: [f64; 2]) -> Air<'_> {
        let body = self.body;
        let mut incidence = body.elastic.camber.clone();
        for (sum, slope) in incidence.iter_mut().zip(self.flight.control.iter().flatten()) {
            *sum += slope * control_rad;
        }
        Air {
            elastic: body.elastic,
            structure: &body.structure,
            boxes: &body.boxes,
            corrections: self.corrections.clone(),
            q_pa: self.flight.flow.dynamic_pressure_pa(),
            alpha_rad,
            wake: self.flight.wake,
            incidence,
            turning: Turning {
                per_m: Vector3::y() * (self.flight.pitch_rate_rad_s / self.flight.flow.v_m_s),
                about: self.flight.about,
            },
        }
    }

    /// Angle of attack and control at which nothing is left at a state; nothing if they are not found.
    fn balanced<'b>(&'b self, state: &State) -> Option<Balancing<'b>> {
        let start = *self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let solved = self.air(start).solved(state)?;
        let fields = self.body.fields(state);
        let mut balancing = Balancing { flying: self, solved, fields, inverse: [[0.0; 2]; 2], trim: start };
        balancing.inverse = balancing.differences(state, start)?;
        balancing.trim = balancing.balance(state, start)?;
        balancing.inverse = balancing.differences(state, balancing.trim)?;
        *self.known.lock().unwrap_or_else(PoisonError::into_inner) = balancing.trim;
        Some(balancing)
    }
}

impl Balancing<'_> {
    /// Forces on the nodes: of the air, of weight and inertia.
    fn forces_at(&self, state: &State, trim: [f64; 2]) -> [Vec<f64>; 2] {
        let body = self.flying.body;
        let air = self.solved.on_nodes_in(&self.flying.air(trim), state);
        let felt = body.elastic.gravity_at(trim[0]) * self.flying.flight.load_factor;
        let inertia = self.fields[0].iter().zip(&self.fields[1]);
        [air, inertia.map(|(x, z)| felt[0] * x + felt[2] * z).collect()]
    }

    /// Force normal to the stream, N, and pitching moment about the held node, Nm.
    fn unbalanced(&self, state: &State, trim: [f64; 2]) -> [f64; 2] {
        let all = self.forces_at(state, trim).map(|forces| self.flying.body.resultant(state, &forces));
        let sum: Vec<f64> = all[0].iter().zip(&all[1]).map(|(air, inertia)| air + inertia).collect();
        let back = Rotation3::from_axis_angle(&Vector3::y_axis(), -trim[0]);
        [(back * Vector3::z()).dot(&Vector3::new(sum[0], sum[1], sum[2])), sum[4]]
    }

    fn differences(&self, state: &State, at: [f64; 2]) -> Option<[[f64; 2]; 2]> {
        let now = self.unbalanced(state, at);
        let by = |which: usize| {
            let mut moved = at;
            moved[which] += STEP;
            let then = self.unbalanced(state, moved);
            [(then[0] - now[0]) / STEP, (then[1] - now[1]) / STEP]
        };
        let [a, c] = by(0);
        if self.flying.flight.control.is_none() {
            return (a.abs() > 0.0).then(|| [[1.0 / a, 0.0], [0.0, 0.0]]);
        }
        let [b, d] = by(1);
        let determinant = a * d - b * c;
        let inverse = [[d, -b], [-c, a]].map(|row| row.map(|value| value / determinant));
        inverse.iter().flatten().all(|value| value.is_finite()).then_some(inverse)
    }

    fn balance(&self, state: &State, start: [f64; 2]) -> Option<[f64; 2]> {
        let body = self.flying.body;
        let scale = [body.weight_n, body.weight_n * body.elastic.correctable.mean_chord_m()];
        let (mut trim, mut inverse, mut least) = (start, self.inverse, f64::INFINITY);
        for _ in 0..ROUNDS {
            let short = self.unbalanced(state, trim);
            let size = if self.flying.flight.control.is_some() {
                (short[0] / scale[0]).abs().max((short[1] / scale[1]).abs())
            } else {
                (short[0] / scale[0]).abs()
            };
            // Round-off is where it no longer falls.
            if size < BALANCED || (size < 1e-9 && size > 0.5 * least) {
                return Some(trim);
            }
            if size > LEFT * least {
                inverse = self.differences(state, trim)?;
            }
            least = size;
            for (trim, row) in trim.iter_mut().zip(&inverse) {
                *trim -= row[0] * short[0] + row[1] * short[1];
            }
            if !trim.iter().all(|angle| angle.abs() < 1.0) {
                return None;
            }
        }
        (least < 1e-6).then_some(trim)
    }

    fn reported(&self, state: &State) -> FreeState {
        let body = self.flying.body;
        let [air, inertia] = self.forces_at(state, self.trim);
        let all: Vec<f64> = air.iter().zip(&inertia).map(|(air, inertia)| air + inertia).collect();
        let loaded = self.solved.loaded_in(&self.flying.air(self.trim), state);
        FreeState {
            alpha_rad: self.trim[0],
            control_rad: self.trim[1],
            held: body.resultant(state, &all).map(|value| -value),
            state: state.clone(),
            air,
            inertia,
            lattice: loaded.boxes.lattice,
            box_loads: loaded.box_loads,
            iterations: 0,
        }
    }
}

impl Acting for Flying<'_> {
    fn at<'b>(&'b self, _: &'b LargeDeflection, state: &State) -> Option<Box<dyn Near + 'b>> {
        Some(Box::new(self.balanced(state)?))
    }

    fn follows(&self) -> bool {
        true
    }
}

impl Near for Balancing<'_> {
    fn forces(&self) -> Vec<f64> {
        let [air, inertia] = self.forces_at(self.solved.state(), self.trim);
        air.iter().zip(&inertia).map(|(air, inertia)| air + inertia).collect()
    }

    fn following_here(&self) -> Vec<f64> {
        self.following(self.solved.state())
    }

    fn following(&self, state: &State) -> Vec<f64> {
        let trim = self.balance(state, self.trim).unwrap_or(self.trim);
        let [air, inertia] = self.forces_at(state, trim);
        air.iter().zip(&inertia).map(|(air, inertia)| air + inertia).collect()
    }
}

#[cfg(test)]
mod tests;
