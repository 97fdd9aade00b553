//! The aircraft assembled once: structure free and held, lattice, spline and the pressures of everything that does
//! not depend on airspeed or corrections.
//!
//! Angles and deflections are counted from the fuselage's grid at the wing's root (the centre). For steady
//! flight the structure is held there: six motions, so statically determinate, and in balanced flight the reaction is
//! zero. For dynamics it is free.

use crate::aircraft::file::{AircraftFile, Surfaces};
use crate::error::AircraftError;
use crate::model::cards::{self, Cards};
use crate::model::closing;
use aero::{ControlSurface, Corrections, Lattice, MirrorPlane, Surface, camber_and_twist};
use coupling::{
    Balance, CarriedPart, ElasticWing, Keep, RigidInertia, Spline, SplineKind, SupportedStructure, WingFile,
    WingParts,
};
use maneuver::SharedAir;
use nalgebra::Point3;
use nastran::{BulkData, Frames, InputError};
use std::path::Path;
use std::sync::Arc;
use structure::{MassProperties, Model, System};

/// Nodes and boxes of a wing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WingPlaces {
    /// Index of each box in the lattice; of the left wing in the order of the right wing's originals.
    pub boxes: Vec<usize>,
    /// Index of each node of the wing, ascending.
    pub nodes: Vec<usize>,
    /// The spline node at the tip.
    pub tip: usize,
    /// The outermost accelerometer; without one the tip.
    pub sensor: usize,
}

/// An aircraft.
#[derive(Debug)]
pub struct Aircraft {
    /// Its file.
    pub file: AircraftFile,
    /// Its wing's file.
    pub wing: WingFile,
    /// All cards, free in space; with all panels, whatever is in the flow.
    pub bulk: BulkData,
    /// The free structure.
    pub free: System,
    /// How all boxes in the flow follow the structure.
    pub spline: Spline,
    /// What the boxes of each panel follow.
    pub carried: Vec<CarriedPart>,
    /// Boxes in the flow, controls, unit pressures, and the structure held at the centre. Its "balance" is the
    /// centre of gravity, and all boxes count; its corrections are those of both wings.
    pub flow: ElasticWing,
    /// Right wing.
    pub right: WingPlaces,
    /// Left wing.
    pub left: WingPlaces,
    /// Nodes of the right and left half of the horizontal tail and of the vertical tail, from root to tip.
    pub tail: [Vec<usize>; 3],
    /// Nodes of the fuselage, nose first.
    pub fuselage: Vec<usize>,
    /// Node of the reference grid.
    pub centre: usize,
    /// Mass properties of the whole.
    pub mass: MassProperties,
    /// What rigid accelerations, about the centre of gravity, do to the structure held at the centre.
    pub inertia: RigidInertia,
    /// Mass properties of all but the body that closes the totals, and that body's number.
    rest: MassProperties,
    closing: u32,
    /// Doublets that other aircraft use, too.
    pub(crate) shared: Option<Arc<SharedAir>>,
}

impl Aircraft {
    /// The same with doublets that other aircraft use, too, wherever they are its own.
    #[must_use]
    pub fn in_air(self, shared: Option<Arc<SharedAir>>) -> Self {
        Self { shared, ..self }
    }

    /// Reads an aircraft's file and everything it names; `wing` takes the place of the wing it names.
    ///
    /// # Errors
    /// Bad input, and a structure that does not hold together.
    pub fn read(path: &Path, wing: Option<&Path>) -> Result<Self, AircraftError> {
        let file = AircraftFile::read(path)?;
        let wing = WingFile::read(wing.unwrap_or(&file.wing_path()))?;
        Self::new(file, wing)
    }

    /// Assembles an aircraft.
    ///
    /// # Errors
    /// As [`Aircraft::read`].
    pub fn new(file: AircraftFile, wing: WingFile) -> Result<Self, AircraftError> {
        Self::kept(file, wing, &())
    }

    /// The same; its flexibility is taken from where it is kept, or found and kept there.
    ///
    /// # Errors
    /// As [`Aircraft::read`].
    pub fn kept(file: AircraftFile, wing: WingFile, keep: &dyn Keep) -> Result<Self, AircraftError> {
        let mut cards = cards::build(&file, &wing)?;
        let rest = MassProperties::of_model(&Model::from_bulk(&cards.bulk)?);
        let frames = Frames::resolve(&cards.bulk)?;
        let at = frames.grid_point(&cards.bulk.grids[&cards.centre])?;
        let body = closing::mass(&file, &rest, cards.closing, cards.centre, &at)?;
        let closing = body.id;
        cards.bulk.masses.insert(closing, body);
        let free = System::assemble(&Model::from_bulk(&cards.bulk)?)?;

        let in_flow = match file.surfaces {
            Surfaces::All => cards.bulk.clone(),
            Surfaces::WingsOnly => cards.wings_in_flow(),
        };
        let lattice = Lattice::from_bulk(&in_flow)?;
        let carried = carried(&cards, &lattice, &free, wing.spline)?;
        let spline = spline(&carried, &lattice, &free);
        let [right, left] = wings(&cards, &wing, &free)?;
        let nodes = |ids: &[u32]| ids.iter().map(|id| node(&free, *id)).collect::<Result<Vec<_>, _>>();
        let [right_half, left_half, vertical] = &cards.tail_splines;
        let tail = [nodes(right_half)?, nodes(left_half)?, nodes(vertical)?];
        let fuselage = nodes(&cards.fuselage_spline)?;
        let centre = node(&free, cards.centre)?;
        let mass = free.mass_properties();
        let centre_of_gravity = Point3::new(file.total.x_cg_m, 0.0, 0.0);
        let place = Held { inputs: inputs(&file, &wing), keep, centre, tip: right.tip };
        let (supported, inertia) = place.reduced(&free, &spline, &centre_of_gravity)?;
        let is_fairing = |id: &u32| !cards.is_wing_panel(*id);
        let parts = WingParts {
            controls: ControlSurface::all_from_bulk(&in_flow, &lattice)?,
            balance: Balance { point: centre_of_gravity, metric: vec![true; lattice.len()] },
            plane: MirrorPlane::None,
            mach: 0.0,
            fairing_surfaces: lattice.surfaces.iter().map(|s| s.id).filter(is_fairing).collect(),
            camber: camber_and_twist(&in_flow, &lattice)?,
            supported: Some(supported),
            structure: None,
            lattice,
        };
        let flow = ElasticWing::new(parts)?;
        Ok(Self {
            file,
            wing,
            bulk: cards.bulk,
            free,
            spline,
            carried,
            flow,
            right,
            left,
            tail,
            fuselage,
            centre,
            mass,
            inertia,
            rest,
            closing,
            shared: None,
        })
    }

    /// The aircraft with other totals, which the body at the wing's root takes up; the structure, its spline and the air stay as they are.
    ///
    /// # Errors
    /// If no body has what is missing.
    pub(crate) fn of_totals(&self, file: AircraftFile, keep: &dyn Keep) -> Result<Self, AircraftError> {
        let centre_id = self.free.node_ids()[self.centre];
        let point = self.free.points()[self.centre];
        let body = closing::mass(&file, &self.rest, self.closing, centre_id, &point)?;
        let scaled = self.bulk.parameters.get("WTMASS").is_some_and(|factor| *factor != 1.0);
        let before = closing::inertia(&self.bulk.masses[&self.closing]);
        let change =
            closing::inertia(&body).zip(before).filter(|_| !scaled).map(|(after, before)| after - before);
        let dofs: Vec<usize> = (6 * self.centre..6 * self.centre + 6).collect();
        let Some(free) = change.and_then(|change| self.free.with_mass_change(&dofs, &change)) else {
            return Self::kept(file, self.wing.clone(), keep);
        };
        let mut bulk = self.bulk.clone();
        bulk.masses.insert(self.closing, body);
        let mass = free.mass_properties();
        let centre_of_gravity = Point3::new(file.total.x_cg_m, 0.0, 0.0);
        let place =
            Held { inputs: inputs(&file, &self.wing), keep, centre: self.centre, tip: self.right.tip };
        let (supported, inertia) = place.reduced(&free, &self.spline, &centre_of_gravity)?;
        Ok(Self {
            file,
            wing: self.wing.clone(),
            bulk,
            free,
            spline: self.spline.clone(),
            carried: self.carried.clone(),
            flow: self.flow.with_masses(centre_of_gravity, supported)?,
            right: self.right.clone(),
            left: self.left.clone(),
            tail: self.tail.clone(),
            fuselage: self.fuselage.clone(),
            centre: self.centre,
            mass,
            inertia,
            rest: self.rest.clone(),
            closing: self.closing,
            shared: self.shared.clone(),
        })
    }

    /// What the assembled aircraft depends on, its air without corrections too: another text for another aircraft.
    pub fn inputs(&self) -> String {
        inputs(&self.file, &self.wing)
    }

    /// Corrections of one wing's boxes spread over the aircraft: the same on the right wing, mirrored on the left,
    /// neutral (factors 1, offsets 0) on tail and fuselage.
    ///
    /// # Errors
    /// If there is not one entry for each box of the wing.
    pub fn corrections(&self, wing: &Corrections) -> Result<Corrections, AircraftError> {
        let expected = self.right.boxes.len();
        if wing.len() != expected {
            let what = "corrections (one for each box of one wing)";
            return Err(coupling::CouplingError::Size { what, got: wing.len(), expected }.into());
        }
        let mut all = wing.padded(self.flow.lattice.len(), &self.right.boxes);
        let left = wing.padded(self.flow.lattice.len(), &self.left.boxes);
        for &at in &self.left.boxes {
            all.force[at] = left.force[at];
            all.moment[at] = left.moment[at];
            all.pressure_offset[at] = left.pressure_offset[at];
        }
        Ok(all)
    }

    /// Index of a control surface of the flow.
    pub fn control(&self, name: &str) -> Option<usize> {
        self.flow.controls.iter().position(|control| control.name == name)
    }

    /// A control of the right side and its image on the left.
    ///
    /// # Errors
    /// If there is no such pair; names the ones there are.
    pub fn control_pair(&self, name: &str) -> Result<[usize; 2], InputError> {
        self.control(name)
            .zip(self.control(&format!("L_{name}")))
            .map(|(right, left)| [right, left])
            .ok_or_else(|| {
                let names: Vec<&str> = self.flow.controls.iter().map(|c| c.name.as_str()).collect();
                let message = format!("there is no pair of control surfaces {name}");
                let text = nastran::read_text(&self.file.path).unwrap_or_default();
                let place = nastran::place_of(&["control:", &format!("\"{name}\"")], &text, &self.file.path);
                InputError::at(&place, message)
                    .with_help(format!("controls are {} (L_ is the left one)", names.join(", ")))
            })
    }
}

/// The wing's files, as it departs from them, and the aircraft's.
fn inputs(file: &AircraftFile, wing: &WingFile) -> String {
    format!("{} {:?} {}", wing.hash, wing.departure, file.text())
}

/// Name of the flexibility where it is kept.
const FLEXIBILITY: &str = "flexibility";

/// The structure held at the centre, on its way to the s-set.
struct Held<'a> {
    inputs: String,
    keep: &'a dyn Keep,
    centre: usize,
    tip: usize,
}

impl Held<'_> {
    fn reduced(
        &self,
        free: &System,
        spline: &Spline,
        centre_of_gravity: &Point3<f64>,
    ) -> Result<(SupportedStructure, RigidInertia), AircraftError> {
        let kept = self.keep.get(FLEXIBILITY, &self.inputs);
        if let Some(found) = kept.and_then(|kept| SupportedStructure::of_matrices(kept, spline, self.tip)) {
            return Ok(found);
        }
        let held = free.clamped_at(self.centre);
        let (supported, inertia) =
            SupportedStructure::with_inertia(&held, spline, self.tip, centre_of_gravity)?;
        self.keep.put(FLEXIBILITY, &self.inputs, &supported.matrices(&inertia));
        Ok((supported, inertia))
    }
}

/// Each panel follows the grids of its own part.
fn carried(
    cards: &Cards,
    lattice: &Lattice,
    system: &System,
    kind: SplineKind,
) -> Result<Vec<CarriedPart>, AircraftError> {
    let part = |surface: &Surface| {
        let end = surface.first_box + surface.chordwise * surface.spanwise;
        let nodes: Vec<usize> =
            cards.spline_of_panel(surface.id).iter().map(|id| node(system, *id)).collect::<Result<_, _>>()?;
        let kind = if cards.is_wing_panel(surface.id) { kind } else { SplineKind::Beam };
        Ok(CarriedPart { boxes: [surface.first_box, end], kind, nodes })
    };
    lattice.surfaces.iter().map(part).collect()
}

fn spline(parts: &[CarriedPart], lattice: &Lattice, system: &System) -> Spline {
    let one = |part: &CarriedPart| {
        let boxes = lattice.boxes[part.boxes[0]..part.boxes[1]].to_vec();
        let own = Lattice { boxes, surfaces: Vec::new() };
        match part.kind {
            SplineKind::NearestNode => Spline::nearest_node(&own, system.points(), &part.nodes),
            SplineKind::Beam => Spline::beam(&own, system.points(), &part.nodes),
        }
    };
    Spline::joined(parts.iter().map(one), 6 * system.node_count())
}

/// Places of both wings.
fn wings(cards: &Cards, wing: &WingFile, system: &System) -> Result<[WingPlaces; 2], AircraftError> {
    let originals = Lattice::from_bulk(&cards.right)?;
    let images = cards.image.check(&originals, &Lattice::from_bulk(&cards.left)?, cards.step.boxes)?;
    let nodes =
        |add: u32| cards.right.grids.keys().map(|id| node(system, id + add)).collect::<Result<Vec<_>, _>>();
    let points = system.points();
    let mut tip = cards.centre;
    for id in &cards.wing_spline {
        if points[node(system, *id)?].y > points[node(system, tip)?].y {
            tip = *id;
        }
    }
    let sensors = wing.planform().map_or_else(Vec::new, coupling::planform::Planform::sensor_grids);
    let mut sensor = tip;
    let mut outermost_m = f64::NEG_INFINITY;
    for (_, id) in sensors {
        let y_m = points[node(system, id)?].y;
        if y_m > outermost_m {
            (sensor, outermost_m) = (id, y_m);
        }
    }
    let add = cards.step.cards;
    let count = originals.len();
    Ok([
        WingPlaces {
            boxes: (0..count).collect(),
            nodes: nodes(0)?,
            tip: node(system, tip)?,
            sensor: node(system, sensor)?,
        },
        WingPlaces {
            boxes: images.into_iter().map(|at| count + at).collect(),
            nodes: nodes(add)?,
            tip: node(system, tip + add)?,
            sensor: node(system, sensor + add)?,
        },
    ])
}

fn node(system: &System, id: u32) -> Result<usize, InputError> {
    system.node_index(id).ok_or_else(|| InputError::general(format!("the aircraft has no grid {id}")))
}
