//! Weight and air on the bent wing.

use super::boxes::{CarriedBoxes, MovedBoxes, turned};
use super::wake::Wake;
use crate::wing::ElasticWing;
use aero::{AeroBox, BoxLoads, Corrections, Lattice, SteadyAero};
use nalgebra::{Point3, Rotation3, Vector3};
use std::sync::OnceLock;
use structure::nonlinear::{Acting, LargeDeflection, Loads, Near, State};

/// One condition: a share of weight is not taken, of dynamic pressure it may be.
#[derive(Debug, Clone)]
pub(super) struct Air<'a> {
    pub(super) elastic: &'a ElasticWing,
    pub(super) structure: &'a LargeDeflection,
    pub(super) boxes: &'a CarriedBoxes,
    /// Of all boxes.
    pub(super) corrections: Corrections,
    pub(super) q_pa: f64,
    pub(super) alpha_rad: f64,
    pub(super) wake: Wake,
    /// Incidence of camber, twist and controls, rad, one a box.
    pub(super) incidence: Vec<f64>,
    /// Of a body in flight.
    pub(super) turning: Turning,
}

/// A steady rotation of the whole, seen from axes that turn with it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Turning {
    /// Rate over airspeed, rad/m, the structure's axes.
    pub(super) per_m: Vector3<f64>,
    /// A point of its axis, m.
    pub(super) about: Point3<f64>,
}

impl Turning {
    /// None.
    pub(super) fn none() -> Self {
        Self { per_m: Vector3::zeros(), about: Point3::origin() }
    }
}

/// The air about one state: its lattice solved, pressures of motions beside it by the same influence.
pub(super) struct Solved<'a> {
    pub(super) air: Air<'a>,
    pub(super) aero: SteadyAero,
    /// Chord along the wake of the boxes when the lattice was solved, m.
    pub(super) chord_m: Vec<f64>,
    weight: Vec<f64>,
    state: State,
    /// The boxes there, and in the axes of the lattice.
    moved: MovedBoxes,
    boxes: Lattice,
    /// Forces of this air on the nodes there, once they were asked for.
    here: OnceLock<Vec<f64>>,
}

/// Pressures and loads of all boxes.
pub(super) struct Loaded {
    /// Uncorrected pressure coefficients.
    pub(super) cp: Vec<f64>,
    /// Lift and moment.
    pub(super) box_loads: BoxLoads,
    /// Force, and moment about the midpoint, N and Nm, the structure's axes.
    pub(super) loads: Vec<[Vector3<f64>; 2]>,
    /// The boxes.
    pub(super) boxes: MovedBoxes,
}

impl<'a> Air<'a> {
    /// From the structure's axes to those of the lattice, whose x runs along the wake.
    pub(super) fn to_wake(&self) -> Rotation3<f64> {
        self.wake.axes(self.alpha_rad)
    }

    /// Direction of the stream in the axes of the lattice.
    pub(super) fn stream(&self) -> Vector3<f64> {
        self.wake.stream(self.alpha_rad)
    }

    /// Chord of a box along itself, m.
    pub(super) fn own_chord_m(&self, at: usize) -> f64 {
        4.0 * self.elastic.integration.moment_arm(at)
    }

    /// Weight of the structure's axes at this angle of attack.
    pub(super) fn weight(&self) -> Loads {
        Loads { gravity_m_s2: self.elastic.gravity_at(self.alpha_rad), ..Loads::default() }
    }

    /// Stream along the normals of boxes in the axes of the lattice, rad.
    fn incidence_of(&self, boxes: &Lattice) -> Vec<f64> {
        let (axes, stream) = (self.to_wake(), self.stream());
        let (rate, about) = (axes * self.turning.per_m, axes * self.turning.about);
        let one = |(panel, incidence): (&AeroBox, &f64)| {
            let own = rate.cross(&(panel.three_quarter_point() - about));
            let normal = panel.normal();
            (normal + chord(panel) * *incidence).dot(&stream) - own.dot(&normal)
        };
        boxes.boxes.iter().zip(&self.incidence).map(one).collect()
    }

    /// Force, and moment about the midpoint, of lift and moment of each box (N, Nm; the structure's axes).
    fn directed(&self, boxes: &Lattice, box_loads: &BoxLoads) -> Vec<[Vector3<f64>; 2]> {
        let (back, stream) = (self.to_wake().inverse(), self.stream());
        let load = |(j, panel): (usize, &AeroBox)| {
            let [force, moment] = directions(panel, &stream);
            [back * (force * box_loads.values[2 * j]), back * (moment * box_loads.values[2 * j + 1])]
        };
        boxes.boxes.iter().enumerate().map(load).collect()
    }

    /// The lattice solved at a state; nothing if it cannot be.
    pub(super) fn solved(&self, state: &State) -> Option<Solved<'a>> {
        let elastic = self.elastic;
        let moved = self.boxes.moved(&elastic.lattice, state);
        let boxes = turned(&moved.lattice, &self.to_wake());
        let aero = SteadyAero::moved(&boxes, &self.boxes.seams, elastic.plane, elastic.mach).ok()?;
        let chord_m = boxes.boxes.iter().map(AeroBox::chord_m).collect();
        let weight = self.structure.load_forces(state, &self.weight());
        let (air, state, here) = (self.clone(), state.clone(), OnceLock::new());
        Some(Solved { air, aero, chord_m, weight, state, moved, boxes, here })
    }
}

impl Solved<'_> {
    /// Pressures and loads at a state, with the influence of the one that was solved.
    pub(super) fn loaded(&self, state: &State) -> Loaded {
        self.loaded_in(&self.air, state)
    }

    /// The same in other air, with the influence of the one that was solved.
    pub(super) fn loaded_in(&self, air: &Air<'_>, state: &State) -> Loaded {
        let boxes = air.boxes.moved(&air.elastic.lattice, state);
        let (cp, box_loads, loads) = self.loads_on(air, &turned(&boxes.lattice, &air.to_wake()));
        Loaded { cp, box_loads, loads, boxes }
    }

    /// Pressures, lift and moment, and their directed loads on boxes in the axes of the lattice.
    fn loads_on(&self, air: &Air<'_>, boxes: &Lattice) -> (Vec<f64>, BoxLoads, Vec<[Vector3<f64>; 2]>) {
        let cp = self.aero.pressures_of(&air.incidence_of(boxes));
        // The lattice takes the circulation as V cp chord/2 with the chord along the wake; pressures are by the box's own.
        let cp: Vec<f64> =
            cp.iter().enumerate().map(|(j, cp)| cp * self.chord_m[j] / air.own_chord_m(j)).collect();
        let box_loads = air.elastic.integration.corrected(&air.corrections).box_loads(air.q_pa, &cp);
        let loads = air.directed(boxes, &box_loads);
        (cp, box_loads, loads)
    }

    /// Boxes at a state in the axes of the lattice.
    pub(super) fn turned_boxes(&self, state: &State) -> Lattice {
        let air = &self.air;
        turned(&air.boxes.moved(&air.elastic.lattice, state).lattice, &air.to_wake())
    }

    /// Those of the state that was solved, their corners joined.
    pub(super) fn surface(&self) -> Lattice {
        self.air.boxes.seams.closed(&self.boxes)
    }

    /// The state that was solved.
    pub(super) fn state(&self) -> &State {
        &self.state
    }

    /// Stream along the normals of boxes in the axes of the lattice, rad.
    pub(super) fn incidence(&self, boxes: &Lattice) -> Vec<f64> {
        self.air.incidence_of(boxes)
    }

    /// Force and moment (axes of the lattice) of a unit pressure coefficient of the solved lattice, per unit dynamic pressure.
    pub(super) fn unit_loads(&self, boxes: &Lattice) -> Vec<[Vector3<f64>; 2]> {
        let (integration, corrections) = (&self.air.elastic.integration, &self.air.corrections);
        let stream = self.air.stream();
        let load = |(j, panel): (usize, &AeroBox)| {
            let [force, moment] = directions(panel, &stream);
            let arm = integration.moment_arm(j);
            let lift = integration.area(j) * self.chord_m[j] / (4.0 * arm);
            [force * (lift * corrections.force[j]), moment * (lift * arm * corrections.moment[j])]
        };
        boxes.boxes.iter().enumerate().map(load).collect()
    }

    /// Lift and moment of a solved state, turned and moved with the boxes to another, on the nodes.
    pub(super) fn same_loads_on_nodes(&self, loaded: &Loaded, state: &State) -> Vec<f64> {
        let air = &self.air;
        let boxes = air.boxes.moved(&air.elastic.lattice, state);
        let turned_boxes = turned(&boxes.lattice, &air.to_wake());
        air.boxes.to_nodes(&boxes, &air.directed(&turned_boxes, &loaded.box_loads))
    }

    /// Forces of this air on the nodes at the state that was solved.
    fn here(&self) -> &[f64] {
        self.here.get_or_init(|| {
            let (_, _, loads) = self.loads_on(&self.air, &self.boxes);
            self.air.boxes.to_nodes(&self.moved, &loads)
        })
    }

    /// Forces of other air on the nodes at a state.
    pub(super) fn on_nodes_in(&self, air: &Air<'_>, state: &State) -> Vec<f64> {
        let loaded = self.loaded_in(air, state);
        air.boxes.to_nodes(&loaded.boxes, &loaded.loads)
    }
}

/// Unit chord of a box, aft.
pub(super) fn chord(panel: &AeroBox) -> Vector3<f64> {
    let [c1, c2, c3, c4] = &panel.corners;
    ((c2 - c1) + (c3 - c4)).normalize()
}

/// Directions of a box's lift, on the stream and the bound vortex, and of its nose-up moment.
pub(super) fn directions(panel: &AeroBox, stream: &Vector3<f64>) -> [Vector3<f64>; 2] {
    let [from, to] = panel.bound_vortex();
    let lift = stream.cross(&(to - from)).normalize();
    [lift, lift.cross(&chord(panel))]
}

impl Acting for Air<'_> {
    fn at<'b>(&'b self, structure: &'b LargeDeflection, state: &State) -> Option<Box<dyn Near + 'b>> {
        if self.q_pa == 0.0 {
            return Some(Box::new(Still(structure.load_forces(state, &self.weight()))));
        }
        Some(Box::new(self.solved(state)?))
    }

    fn follows(&self) -> bool {
        self.q_pa != 0.0
    }
}

impl Near for Solved<'_> {
    fn forces(&self) -> Vec<f64> {
        self.here().iter().zip(&self.weight).map(|(air, weight)| air + weight).collect()
    }

    fn following_here(&self) -> Vec<f64> {
        self.here().to_vec()
    }

    fn following(&self, state: &State) -> Vec<f64> {
        self.on_nodes_in(&self.air, state)
    }
}

/// Weight alone.
struct Still(Vec<f64>);

impl Near for Still {
    fn forces(&self) -> Vec<f64> {
        self.0.clone()
    }

    fn following_here(&self) -> Vec<f64> {
        vec![0.0; self.0.len()]
    }

    fn following(&self, _: &State) -> Vec<f64> {
        self.following_here()
    }
}
