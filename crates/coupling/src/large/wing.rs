//! Equilibria of the bent wing.

use super::air::{Air, Loaded, Turning};
use super::boxes::CarriedBoxes;
use super::wake::Wake;
use crate::case::SteadyCase;
use crate::error::CouplingError;
use crate::root_loads::RootLoads;
use crate::wing::{ElasticWing, read_wing};
use crate::wing_file::{SplineKind, WingFile};
use crate::wing_parts::{spline_nodes, wing_parts};
use aero::{BoxLoads, Corrections, Lattice};
use nalgebra::{Point3, Vector3};
use nastran::{BulkData, InputError};
use std::path::Path;
use structure::Model;
use structure::nonlinear::{Acting, Controls, LargeDeflection, Loads, Near, State};

/// A wing that may bend far, with its linear self beside it.
#[derive(Debug)]
pub struct LargeWing {
    /// The same wing with small deflections: lattice, camber, controls, balance, areas.
    pub elastic: ElasticWing,
    /// Its structure.
    pub structure: LargeDeflection,
    pub(super) boxes: CarriedBoxes,
    /// The node whose height is the tip deflection.
    pub(super) tip: usize,
    /// At rest at alpha = 0: its own weight alone.
    wind_off: State,
}

/// An equilibrium of the bent wing, on the axes of the balance.
#[derive(Debug, Clone)]
pub struct LargeState {
    /// Where the structure is.
    pub state: State,
    /// What acts on its nodes, N and Nm (g-set, basic axes): air and weight.
    pub forces: Vec<f64>,
    /// The boxes.
    pub lattice: Lattice,
    /// Uncorrected pressure coefficients, one a box.
    pub cp: Vec<f64>,
    /// Corrected loads, two a box.
    pub box_loads: BoxLoads,
    /// What the balance feels, the weight at rest at alpha = 0 taken off.
    pub root: RootLoads,
    /// Displacement of the tip (x aft, y outboard, z up) from its place at rest at alpha = 0, m.
    pub tip_m: Vector3<f64>,
    /// Rise of the chord's nose at the tip against the same, rad.
    pub twist_rad: f64,
    /// Newton's iterations since the state it was continued from.
    pub iterations: usize,
    /// What the air gives back of a small motion: from one on the wing diverges.
    pub gain: f64,
}

impl LargeWing {
    /// Reads a wing's RON file and everything it names: the wing as it stands in the tunnel.
    ///
    /// # Errors
    /// Bad input, and as [`LargeWing::from_bulk`].
    pub fn read(path: &Path) -> Result<(WingFile, Self), CouplingError> {
        read_wing(path, Self::from_bulk)
    }

    /// A wing file's wing.
    ///
    /// # Errors
    /// As [`ElasticWing::from_bulk`]; if there is no structure, or something in it cannot turn far.
    pub fn from_bulk(file: &WingFile, bulk: &BulkData) -> Result<Self, CouplingError> {
        let parts = wing_parts(file, bulk)?;
        let Some((system, _)) = &parts.structure else {
            let error =
                InputError::in_file(&file.path, "large deflections need a structure, and the wing is rigid");
            return Err(error.into());
        };
        let nodes = spline_nodes(file, bulk, system)?;
        let model = Model::from_bulk(bulk)?;
        Self::new(ElasticWing::new(parts)?, &model, file.spline, &nodes)
    }

    /// From the linear wing, the model its structure was assembled from, and the nodes its boxes follow.
    ///
    /// # Errors
    /// If the wing is rigid, something in the structure cannot turn far, or it does not carry its own weight.
    pub fn new(
        elastic: ElasticWing,
        model: &Model,
        kind: SplineKind,
        nodes: &[usize],
    ) -> Result<Self, CouplingError> {
        let (Some(supported), Some((system, _))) = (&elastic.supported, &elastic.structure) else {
            return Err(
                InputError::general("large deflections need a structure, and the wing is rigid").into()
            );
        };
        let structure = LargeDeflection::new(model)?;
        let boxes = CarriedBoxes::new(&elastic.lattice, elastic.plane, kind, system.points(), nodes);
        let tip = supported.s_dofs[supported.tip_z] / 6;
        let wind_off = structure.undeformed();
        let mut wing = Self { elastic, structure, boxes, tip, wind_off };
        wing.rest()?;
        Ok(wing)
    }

    /// Without weight, as computations without it are compared with.
    ///
    /// # Errors
    /// Never, if the wing carried its weight.
    pub fn weightless(mut self) -> Result<Self, CouplingError> {
        self.elastic.gravity_m_s2 = 0.0;
        self.rest()?;
        Ok(self)
    }

    /// Finds the state at rest at alpha = 0.
    fn rest(&mut self) -> Result<(), CouplingError> {
        let gravity_m_s2 = self.elastic.gravity_at(0.0);
        let path = self.structure.under(&Loads { gravity_m_s2, ..Loads::default() });
        self.wind_off = path.map_err(CouplingError::OwnWeight)?.end().state.clone();
        Ok(())
    }

    /// At rest at alpha = 0.
    pub fn wind_off(&self) -> &State {
        &self.wind_off
    }

    /// Equilibria of cases with corrections (one entry for each correctable box), each continued from the one before
    /// it.
    ///
    /// # Errors
    /// If no equilibrium is found, or the wing diverges there; with the last airspeed that was reached.
    pub fn solve(
        &self,
        cases: &[SteadyCase],
        corrections: &Corrections,
    ) -> Result<Vec<LargeState>, CouplingError> {
        self.solve_from(&self.wind_off, cases, &vec![corrections.clone(); cases.len()])
    }

    /// The same with corrections of each case.
    ///
    /// # Errors
    /// As [`LargeWing::solve`].
    pub fn solve_with(
        &self,
        cases: &[SteadyCase],
        corrections: &[Corrections],
    ) -> Result<Vec<LargeState>, CouplingError> {
        self.solve_from(&self.wind_off, cases, corrections)
    }

    /// The same from a state at rest: the wind-off state, or that turned as a whole with its clamp.
    ///
    /// # Errors
    /// As [`LargeWing::solve`].
    pub fn solve_from(
        &self,
        rest: &State,
        cases: &[SteadyCase],
        corrections: &[Corrections],
    ) -> Result<Vec<LargeState>, CouplingError> {
        let still = Air {
            elastic: &self.elastic,
            structure: &self.structure,
            boxes: &self.boxes,
            corrections: Corrections::neutral(self.elastic.lattice.len()),
            q_pa: 0.0,
            alpha_rad: 0.0,
            wake: Wake::Stream,
            incidence: vec![0.0; self.elastic.lattice.len()],
            turning: Turning::none(),
        };
        let (mut from, mut state, mut found) = (still, rest.clone(), Vec::with_capacity(cases.len()));
        for (case, corrections) in cases.iter().zip(corrections) {
            let to = self.air(case, corrections)?;
            let one = self.continued(&state, &from, &to, case)?;
            (from, state) = (to, one.state.clone());
            found.push(one);
        }
        Ok(found)
    }

    /// The equilibrium of a case with corrections, continued from that of another case.
    ///
    /// # Errors
    /// As [`LargeWing::solve`].
    pub fn continued_from(
        &self,
        known: &LargeState,
        of: &SteadyCase,
        case: &SteadyCase,
        corrections: &Corrections,
    ) -> Result<LargeState, CouplingError> {
        self.continued(&known.state, &self.air(of, corrections)?, &self.air(case, corrections)?, case)
    }

    /// The air of a case with corrections of each correctable box.
    pub(super) fn air(&self, case: &SteadyCase, corrections: &Corrections) -> Result<Air<'_>, CouplingError> {
        Ok(Air {
            elastic: &self.elastic,
            structure: &self.structure,
            boxes: &self.boxes,
            corrections: self.elastic.padded(corrections)?,
            q_pa: case.flow.dynamic_pressure_pa(),
            alpha_rad: case.alpha_rad,
            wake: Wake::Stream,
            incidence: self.incidence(case),
            turning: Turning::none(),
        })
    }

    /// Incidence of camber, twist and controls, rad, one a box.
    fn incidence(&self, case: &SteadyCase) -> Vec<f64> {
        let mut incidence = self.elastic.camber.clone();
        for (control, deflection) in self.elastic.controls.iter().zip(&case.controls_rad) {
            for (&place, slope) in control.boxes.iter().zip(&control.slope) {
                incidence[place] += slope * deflection;
            }
        }
        incidence
    }

    pub(super) fn continued(
        &self,
        start: &State,
        from: &Air<'_>,
        to: &Air<'_>,
        case: &SteadyCase,
    ) -> Result<LargeState, CouplingError> {
        let between = |a: f64, b: f64, share: f64| a + share * (b - a);
        let at = |share: f64| -> Box<dyn Acting + '_> {
            let incidence = from.incidence.iter().zip(&to.incidence).map(|(a, b)| between(*a, *b, share));
            Box::new(Air {
                q_pa: between(from.q_pa, to.q_pa, share),
                alpha_rad: between(from.alpha_rad, to.alpha_rad, share),
                incidence: incidence.collect(),
                ..to.clone()
            })
        };
        let path = self.structure.path_under(start, &at, &Controls::default());
        let failed = |reached: f64, why: String| {
            let q_pa = between(from.q_pa, to.q_pa, reached);
            CouplingError::NotInEquilibrium {
                v_m_s: case.flow.v_m_s,
                alpha_deg: case.alpha_rad.to_degrees(),
                reached_m_s: (2.0 * q_pa / case.flow.rho_kg_m3).sqrt(),
                reached_deg: between(from.alpha_rad, to.alpha_rad, reached).to_degrees(),
                why,
            }
        };
        let path = path.map_err(|error| failed(error.reached(), error.to_string()))?;
        let end = path.end();
        let Some(solved) = to.solved(&end.state) else {
            return Err(failed(0.0, "the lattice of the bent wing cannot be solved".to_owned()));
        };
        let gain =
            if to.q_pa == 0.0 { Some(0.0) } else { self.structure.following_gain(&end.state, &solved) };
        let Some(gain) = gain.filter(|gain| *gain < 1.0) else {
            return Err(failed(
                0.0,
                "the equilibrium that was found there is unstable (divergence)".to_owned(),
            ));
        };
        let iterations = path.points.iter().map(|point| point.iterations).sum();
        let reported = self.reported(to, solved.loaded(&end.state), &end.state);
        Ok(LargeState { forces: solved.forces(), iterations, gain, ..reported })
    }

    fn reported(&self, air: &Air<'_>, loaded: Loaded, state: &State) -> LargeState {
        let point = self.elastic.balance.point;
        let (mut force, mut moment) = self.resultant_of_weight(state, &air.weight());
        let at_rest = Air { alpha_rad: 0.0, ..air.clone() };
        let (tare_force, tare_moment) = self.resultant_of_weight(&self.wind_off, &at_rest.weight());
        force -= tare_force;
        moment -= tare_moment;
        for (j, [f, m]) in loaded.loads.iter().enumerate().filter(|(j, _)| self.elastic.balance.metric[*j]) {
            force += f;
            moment += m + (loaded.boxes.lattice.boxes[j].mid_point() - point).cross(f);
        }
        let nose = |state: &State| {
            let chord = state.rotations[self.tip] * -Vector3::x();
            chord.z.asin()
        };
        LargeState {
            tip_m: state.places[self.tip] - self.wind_off.places[self.tip],
            twist_rad: nose(state) - nose(&self.wind_off),
            state: state.clone(),
            forces: Vec::new(),
            lattice: loaded.boxes.lattice,
            cp: loaded.cp,
            box_loads: loaded.box_loads,
            root: RootLoads { fz_n: force.z, mx_nm: moment.x, my_nm: moment.y },
            iterations: 0,
            gain: 0.0,
        }
    }

    /// Force and moment about the balance point of the weight of all masses at their places of now.
    fn resultant_of_weight(&self, state: &State, weight: &Loads) -> (Vector3<f64>, Vector3<f64>) {
        let point = self.elastic.balance.point;
        let forces = self.structure.load_forces(state, weight);
        let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
        for (place, load) in state.places.iter().zip(forces.chunks_exact(6)) {
            let f = Vector3::new(load[0], load[1], load[2]);
            force += f;
            moment += Vector3::new(load[3], load[4], load[5]) + (Point3::from(*place) - point).cross(&f);
        }
        (force, moment)
    }
}
