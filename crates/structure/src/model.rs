//! A structure as the deck describes it, every reference checked and everything turned to basic axes.
//!
//! Displacements are kept in basic axes throughout. A grid's displacement system (CD) turns its beam offsets and
//! orientation vectors; constraints and rigid elements may name some components of such a grid only if the choice
//! does not depend on the axes (all displacements, all rotations).

use crate::beam::{Beam, BeamPlacement};
use crate::element::Element;
use crate::masses::PointMass;
use crate::rigid::RigidLink;
use nalgebra::{Matrix3, Point3, Vector3};
use nastran::{BeamElement, BulkData, Frames, InputError, Orientation, Span};
use std::collections::BTreeMap;
use std::fmt::Display;

/// A grid point.
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    /// The grid's identification number.
    pub id: u32,
    /// Its place in the basic system, m.
    pub point: Point3<f64>,
}

/// Components of one node that are held fixed.
#[derive(Debug, Clone, PartialEq)]
pub struct Clamp {
    /// Position of the node in [`Model::nodes`].
    pub node: usize,
    /// Components, digits 1 to 6, basic axes.
    pub components: Vec<u8>,
    /// The card that says so.
    pub span: Span,
}

/// A structure: nodes, elements, masses, rigid links and clamps.
#[derive(Debug, Clone, Default)]
pub struct Model {
    /// Nodes in ascending grid number.
    pub nodes: Vec<Node>,
    /// Beams in ascending element number.
    pub beams: Vec<Beam>,
    /// Point masses in ascending number.
    pub masses: Vec<PointMass>,
    /// Rigid links in ascending number.
    pub rigid: Vec<RigidLink>,
    /// Clamps: those of the grids, then those of the constraint cards. All sets of constraints apply.
    pub clamps: Vec<Clamp>,
}

impl Model {
    /// Reads a structure from bulk data.
    ///
    /// # Errors
    /// If a card refers to something that is not there, or describes no possible element; the card is blamed and
    /// the hint lists what there is.
    pub fn from_bulk(bulk: &BulkData) -> Result<Self, InputError> {
        let builder = Builder::new(bulk)?;
        let mut nodes = Vec::with_capacity(bulk.grids.len());
        for grid in bulk.grids.values() {
            nodes.push(Node { id: grid.id, point: builder.frames.grid_point(grid)? });
        }
        let beams = bulk.beams.values().map(|card| builder.beam(card)).collect::<Result<_, _>>()?;
        let masses = bulk.masses.values().map(|card| {
            let node = builder.node(card.grid, &format!("CONM2 {}", card.id), &card.span)?;
            PointMass::from_card(card, node, &nodes[node].point, &builder.frames)
        });
        let masses = masses.collect::<Result<_, _>>()?;
        Ok(Self { masses, beams, rigid: builder.rigid_links()?, clamps: builder.clamps()?, nodes })
    }

    /// Every element, in the order in which they are summed.
    pub fn elements(&self) -> impl Iterator<Item = &dyn Element> {
        let beams = self.beams.iter().map(|beam| beam as &dyn Element);
        beams.chain(self.masses.iter().map(|mass| mass as &dyn Element))
    }
}

struct Builder<'a> {
    bulk: &'a BulkData,
    frames: Frames,
    places: BTreeMap<u32, usize>,
}

impl<'a> Builder<'a> {
    fn new(bulk: &'a BulkData) -> Result<Self, InputError> {
        let places = bulk.grids.keys().enumerate().map(|(place, id)| (*id, place)).collect();
        Ok(Self { bulk, frames: Frames::resolve(bulk)?, places })
    }

    fn node(&self, grid: u32, user: &str, span: &Span) -> Result<usize, InputError> {
        let missing = || undefined(user, "GRID", grid, self.bulk.grids.keys(), span);
        self.places.get(&grid).copied().ok_or_else(missing)
    }

    /// Axes of a grid's displacement system.
    fn displacement_axes(&self, grid: u32) -> Result<Matrix3<f64>, InputError> {
        let grid = &self.bulk.grids[&grid];
        self.frames.axes_at(grid.cd, &grid.span)
    }

    fn beam(&self, card: &BeamElement) -> Result<Beam, InputError> {
        let bulk = self.bulk;
        let user = format!("{} {}", if card.is_beam { "CBEAM" } else { "CBAR" }, card.id);
        let nodes =
            [self.node(card.grids[0], &user, &card.span)?, self.node(card.grids[1], &user, &card.span)?];
        let property = bulk.beam_properties.get(&card.property).ok_or_else(|| {
            let kind = if card.is_beam { "PBEAM" } else { "PBAR" };
            undefined(&user, kind, card.property, bulk.beam_properties.keys(), &card.span)
        })?;
        let material = bulk.materials.get(&property.material).ok_or_else(|| {
            let user = format!("{} {}", if property.is_beam { "PBEAM" } else { "PBAR" }, property.id);
            undefined(&user, "MAT1", property.material, bulk.materials.keys(), &property.span)
        })?;
        let point = |id: u32| self.frames.grid_point(&bulk.grids[&id]);
        let grids = [point(card.grids[0])?, point(card.grids[1])?];
        let orientation = match card.orientation {
            Orientation::Vector(v) => self.displacement_axes(card.grids[0])? * Vector3::from(v),
            Orientation::Grid(id) => {
                self.node(id, &format!("{user} (orientation)"), &card.span)?;
                point(id)? - grids[0]
            }
        };
        let mut offsets = [Vector3::zeros(); 2];
        for (end, offset) in offsets.iter_mut().enumerate() {
            *offset = self.displacement_axes(card.grids[end])? * Vector3::from(card.offsets[end]);
        }
        let placement = BeamPlacement { grids, offsets, orientation, pins: card.pins.clone() };
        Beam::new(card.id, nodes, &placement, property, material, &card.span)
    }

    fn rigid_links(&self) -> Result<Vec<RigidLink>, InputError> {
        let mut links = Vec::with_capacity(self.bulk.rigid.len());
        for card in self.bulk.rigid.values() {
            let user = format!("RBE2 {}", card.id);
            let independent = self.node(card.independent, &user, &card.span)?;
            let mut dependent = Vec::with_capacity(card.dependent.len());
            for grid in &card.dependent {
                dependent.push(self.node(*grid, &user, &card.span)?);
                self.check_axes(*grid, &card.components, &user, &card.span)?;
            }
            let components = card.components.clone();
            links.push(RigidLink {
                id: card.id,
                independent,
                components,
                dependent,
                span: card.span.clone(),
            });
        }
        Ok(links)
    }

    fn clamps(&self) -> Result<Vec<Clamp>, InputError> {
        let mut clamps = Vec::new();
        for grid in self.bulk.grids.values().filter(|grid| !grid.ps.is_empty()) {
            self.check_axes(grid.id, &grid.ps, &format!("GRID {} (PS)", grid.id), &grid.span)?;
            let node = self.places[&grid.id];
            clamps.push(Clamp { node, components: grid.ps.clone(), span: grid.span.clone() });
        }
        for card in &self.bulk.constraints {
            let user = format!("SPC1 of set {}", card.set);
            for grid in &card.grids {
                let node = self.node(*grid, &user, &card.span)?;
                self.check_axes(*grid, &card.components, &user, &card.span)?;
                clamps.push(Clamp { node, components: card.components.clone(), span: card.span.clone() });
            }
        }
        Ok(clamps)
    }

    /// Refuses a choice of components that means something else in the grid's own axes than in basic ones.
    fn check_axes(&self, grid: u32, components: &[u8], user: &str, span: &Span) -> Result<(), InputError> {
        let partial = [[1, 2, 3], [4, 5, 6]].iter().any(|group| {
            let named = group.iter().filter(|c| components.contains(c)).count();
            named != 0 && named != 3
        });
        let turned = (self.displacement_axes(grid)? - Matrix3::identity()).norm() > 1e-9;
        if partial && turned {
            let cd = self.bulk.grids[&grid].cd;
            let message = format!(
                "{user} names components of GRID {grid} one by one, but that grid's displacement system {cd} is turned"
            );
            let help = "name 123, 456 or 123456, or set field CD of the grid to 0; single components are held in basic axes only";
            return Err(InputError::at(span, message).with_help(help));
        }
        Ok(())
    }
}

/// The error for a reference to something that is not there, with what there is.
fn undefined<T: Display>(
    user: &str,
    kind: &str,
    id: u32,
    known: impl ExactSizeIterator<Item = T>,
    span: &Span,
) -> InputError {
    const SHOWN: usize = 8;
    let count = known.len();
    let mut list = known.take(SHOWN).map(|id| id.to_string()).collect::<Vec<_>>().join(", ");
    if count > SHOWN {
        list.push_str(" and more");
    }
    let help =
        if count == 0 { format!("the deck has no {kind}") } else { format!("there are {kind} {list}") };
    InputError::at(span, format!("{user} refers to {kind} {id}, which is not in the deck")).with_help(help)
}
