//! What the readers of all kinds of cards share: the deck, its frames, and where each grid stands.

use super::node::{Clamp, Node};
use crate::laminate::{ShearModel, ShellSection};
use crate::solid_material::SolidMaterial;
use nalgebra::Matrix3;
use nastran::{BulkData, Frames, InputError, Span};
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
    places: BTreeMap<u32, usize>,
}

impl<'a> Builder<'a> {
    pub(super) fn new(bulk: &'a BulkData, shear: ShearModel) -> Result<Self, InputError> {
        let places = bulk.grids.keys().enumerate().map(|(place, id)| (*id, place)).collect();
        let frames = Frames::resolve(bulk)?;
        let mut nodes = Vec::with_capacity(bulk.grids.len());
        for grid in bulk.grids.values() {
            let point = frames.grid_point(grid)?;
            let axes =
                if grid.cd == 0 { Matrix3::identity() } else { frames.axes_at(grid.cd, &grid.span)? };
            nodes.push(Node { id: grid.id, point, axes });
        }
        let (sections, solid_materials) = (BTreeMap::new(), BTreeMap::new());
        Ok(Self { bulk, frames, nodes, shear, sections, solid_materials, places })
    }

    /// Position of a grid that `user` names.
    pub(super) fn node(&self, grid: u32, user: &str, span: &Span) -> Result<usize, InputError> {
        let missing = || undefined(user, "GRID", grid, self.bulk.grids.keys(), span);
        self.places.get(&grid).copied().ok_or_else(missing)
    }

    /// Positions of several grids.
    pub(super) fn nodes_of(&self, grids: &[u32], user: &str, span: &Span) -> Result<Vec<usize>, InputError> {
        grids.iter().map(|grid| self.node(*grid, user, span)).collect()
    }

    pub(super) fn clamps(&self) -> Result<Vec<Clamp>, InputError> {
        let mut clamps = Vec::new();
        for grid in self.bulk.grids.values().filter(|grid| !grid.ps.is_empty()) {
            let node = self.places[&grid.id];
            clamps.push(Clamp { node, components: grid.ps.clone(), span: grid.span.clone() });
        }
        for card in &self.bulk.constraints {
            let user = format!("SPC1 of set {}", card.set);
            for grid in &card.grids {
                let node = self.node(*grid, &user, &card.span)?;
                clamps.push(Clamp { node, components: card.components.clone(), span: card.span.clone() });
            }
        }
        Ok(clamps)
    }
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
