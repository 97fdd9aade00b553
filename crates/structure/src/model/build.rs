//! What the readers of all kinds of cards share: the deck, its frames, and where each grid stands.

use super::nastran_shells::NastranShells;
use super::node::{Clamp, Node};
use crate::laminate::{ShearModel, ShellSection};
use crate::solid_material::SolidMaterial;
use nalgebra::{Matrix3, Point3, Vector3};
use nastran::{BulkData, Frames, InputError, Motion, Span};
use std::collections::BTreeMap;
use std::fmt::Display;
use std::sync::Arc;

/// A model while it is read.
pub(crate) struct Builder<'a> {
    pub(super) bulk: &'a BulkData,
    pub(super) frames: Frames,
    pub(super) nodes: Vec<Node>,
    /// How laminates get their transverse shear stiffness.
    pub(super) shear: ShearModel,
    /// Sections of shells by their property, as many elements share one.
    pub(super) sections: BTreeMap<u32, Arc<ShellSection>>,
    /// Materials of solids by their property, unless its axes turn with the place.
    pub(super) solid_materials: BTreeMap<u32, Arc<SolidMaterial>>,
    /// What makes flat shells those of Nastran, if they are to be.
    pub(super) nastran: Option<NastranShells>,
    /// Which rotations of each node clamps hold, about the axes of its displacement system; empty before [`Self::prepared`].
    held: Vec<[bool; 3]>,
    places: BTreeMap<u32, usize>,
}

/// Least share of a direction's square along held axes for its rotation to be held: 15 degrees off.
const HELD: f64 = 0.933;

impl<'a> Builder<'a> {
    pub(super) fn new(bulk: &'a BulkData, shear: ShearModel) -> Result<Self, InputError> {
        let frames = Frames::resolve(bulk)?;
        let mut nodes = Vec::with_capacity(bulk.grids.len() + bulk.scalar_points.len());
        for grid in bulk.grids.values() {
            let point = frames.grid_point(grid)?;
            let axes = match grid.cd {
                0 => Matrix3::identity(),
                system => frames.axes_at_point(system, &point, &grid.span)?,
            };
            nodes.push(Node { id: grid.id, point, axes, is_scalar: false });
        }
        for id in bulk.scalar_points.keys() {
            let (point, axes) = (Point3::origin(), Matrix3::identity());
            nodes.push(Node { id: *id, point, axes, is_scalar: true });
        }
        nodes.sort_unstable_by_key(|node| node.id);
        let places = nodes.iter().enumerate().map(|(place, node)| (node.id, place)).collect();
        let (sections, solid_materials) = (BTreeMap::new(), BTreeMap::new());
        Ok(Self {
            bulk,
            frames,
            nodes,
            shear,
            sections,
            solid_materials,
            nastran: None,
            held: Vec::new(),
            places,
        })
    }

    /// With what its clamps hold and, for a user's deck, what makes flat shells those of Nastran; and its clamps.
    pub(super) fn prepared(
        bulk: &'a BulkData,
        shear: ShearModel,
        as_nastran: bool,
    ) -> Result<(Self, Vec<Clamp>), InputError> {
        let mut builder = Self::new(bulk, shear)?;
        builder.nastran = as_nastran.then(|| NastranShells::new(bulk, &builder.nodes)).transpose()?;
        let clamps = builder.clamps()?;
        builder.hold(&clamps);
        Ok((builder, clamps))
    }

    /// Notes which rotations `clamps` hold.
    fn hold(&mut self, clamps: &[Clamp]) {
        self.held = vec![[false; 3]; self.nodes.len()];
        for clamp in clamps {
            for component in clamp.components.iter().filter(|component| **component > 3) {
                self.held[clamp.node][usize::from(*component) - 4] = true;
            }
        }
    }

    /// Whether clamps hold the rotation of a node about a direction of unit length.
    pub(super) fn is_held(&self, node: usize, direction: &Vector3<f64>) -> bool {
        let Some(held) = self.held.get(node) else { return false };
        let own = self.nodes[node].axes.transpose() * direction;
        (0..3).filter(|axis| held[*axis]).map(|axis| own[axis].powi(2)).sum::<f64>() > HELD
    }

    /// Position of a grid that `user` names.
    pub(super) fn node(&self, grid: u32, user: &str, span: &Span) -> Result<usize, InputError> {
        let missing = || undefined(user, "GRID", grid, self.bulk.grids.keys(), span);
        self.places.get(&grid).copied().ok_or_else(missing)
    }

    /// Position and component (0 to 5) of one motion that `user` names.
    pub(super) fn motion(
        &self,
        (grid, component): Motion,
        user: &str,
        span: &Span,
    ) -> Result<(usize, usize), InputError> {
        let node = self.node(grid, user, span)?;
        match (self.nodes[node].is_scalar, component) {
            (true, 0 | 1) => Ok((node, 0)),
            (false, 1..=6) => Ok((node, usize::from(component) - 1)),
            (true, _) => {
                let message = format!(
                    "{user} names component {component} of scalar point {grid}, which has one motion only"
                );
                Err(InputError::at(span, message).with_help("leave the component empty"))
            }
            (false, _) => {
                let message = format!("{user} has no component for GRID {grid}");
                Err(InputError::at(span, message).with_help("give one digit from 1 to 6"))
            }
        }
    }

    /// Positions of several grids.
    pub(super) fn nodes_of(&self, grids: &[u32], user: &str, span: &Span) -> Result<Vec<usize>, InputError> {
        grids.iter().map(|grid| self.node(*grid, user, span)).collect()
    }

    pub(super) fn clamps(&self) -> Result<Vec<Clamp>, InputError> {
        let (mut clamps, mut absent) = (Vec::new(), Vec::new());
        for grid in self.bulk.grids.values().filter(|grid| !grid.ps.is_empty()) {
            let node = self.places[&grid.id];
            clamps.push(Clamp { node, components: grid.ps.clone(), span: grid.span.clone() });
        }
        for card in &self.bulk.constraints {
            let user = format!("SPC1 of set {}", card.set);
            for grid in &card.grids {
                // As in Nastran, which warns: lists by THRU reach over grids that are not there.
                let Some(node) = self.places.get(grid).copied() else {
                    absent.push(*grid);
                    continue;
                };
                let is_scalar = self.nodes[node].is_scalar;
                if card.components.is_empty() && !is_scalar {
                    let message = format!("{user} names GRID {grid} without a component");
                    return Err(InputError::at(&card.span, message).with_help("give digits from 1 to 6"));
                }
                let components = if is_scalar { vec![1] } else { card.components.clone() };
                clamps.push(Clamp { node, components, span: card.span.clone() });
            }
        }
        if let Some(first) = absent.first() {
            let count = absent.len();
            tracing::warn!(
                "SPC and SPC1 name {count} grid(s) that are not in the deck, the first of them {first}; there is nothing to hold there"
            );
        }
        Ok(clamps)
    }
}

/// GE of a material, zero if it has none.
pub(super) fn loss_of(bulk: &BulkData, material: Option<u32>) -> f64 {
    material.and_then(|id| bulk.loss_factors.materials.get(&id)).copied().unwrap_or(0.0)
}

/// Which edges have a grid, and these grids.
pub(super) fn present(midsides: &[Option<u32>]) -> (Vec<usize>, Vec<u32>) {
    midsides.iter().enumerate().filter_map(|(edge, grid)| Some((edge, (*grid)?))).unzip()
}

/// The card of a kind that `user` refers to.
pub(super) fn found<'a, T>(
    cards: &'a BTreeMap<u32, T>,
    id: u32,
    user: &str,
    kind: &str,
    span: &Span,
) -> Result<&'a T, InputError> {
    cards.get(&id).ok_or_else(|| undefined(user, kind, id, cards.keys(), span))
}

/// The error for a reference to something that is not there, with what there is.
pub(super) fn undefined<T: Display>(
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
