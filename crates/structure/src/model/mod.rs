//! A structure as the deck describes it, every reference checked and everything turned to basic axes.
//!
//! Elements work in basic axes. A grid's displacement system (CD) turns the components that constraints, rigid elements
//! and scalar elements name, beam offsets and orientation vectors.

mod build;
mod elements;
mod links;
mod loads;
mod node;
pub(crate) mod registry;
mod shells;
mod solids;

pub use loads::{load_sets, loads_of};
pub use node::{Clamp, Node};

use crate::constraints::Dependent;
use crate::constraints::joint::Tie;
use crate::element::Element;
use crate::laminate::ShearModel;
use nastran::{BulkData, InputError};
use registry::{ElementCard, TieCard};
use std::collections::BTreeMap;
use std::sync::Arc;

/// How the mass of elements is spread over their nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MassForm {
    /// By the same shape functions as the stiffness, rotary inertia included.
    #[default]
    Consistent,
    /// As points at the nodes: each displacement keeps the sum of its row, rotations have none. (Concentrated masses
    /// stay as they are.)
    Lumped,
}

/// A structure: nodes, elements, constraints and clamps.
#[derive(Debug, Clone)]
pub struct Model {
    /// Nodes in ascending grid number.
    pub nodes: Vec<Node>,
    /// Elements in the order in which they are summed: by kind, ascending number within a kind.
    pub elements: Vec<Arc<dyn Element>>,
    /// Motions that follow others.
    pub dependents: Vec<Dependent>,
    /// The cards that say so.
    pub ties: Vec<Tie>,
    /// Clamps: those of the grids, then those of the constraint cards. All sets of constraints apply.
    pub clamps: Vec<Clamp>,
    /// What every mass is multiplied with (PARAM WTMASS); one if the deck says nothing.
    pub mass_factor: f64,
    /// Consistent, or lumped (PARAM COUPMASS -1).
    pub mass_form: MassForm,
}

impl Model {
    /// Reads a structure from bulk data.
    ///
    /// # Errors
    /// If the deck has elements that are not read, or a card refers to something that is not there, or describes no possible element; the card is blamed and
    /// the hint lists what there is.
    pub fn from_bulk(bulk: &BulkData) -> Result<Self, InputError> {
        Self::from_bulk_with(bulk, ShearModel::Equilibrium)
    }

    /// As [`Model::from_bulk`], with another rule for the transverse shear stiffness of laminates (PCOMP).
    ///
    /// # Errors
    /// As [`Model::from_bulk`].
    pub fn from_bulk_with(bulk: &BulkData, shear: ShearModel) -> Result<Self, InputError> {
        bulk.refuse_unread_elements()?;
        let builder = build::Builder::new(bulk, shear)?;
        let mut read = Reading { builder, elements: Vec::new(), dependents: Vec::new(), ties: Vec::new() };
        registry::visit(bulk, &mut read)?;
        let Reading { builder, elements, dependents, ties } = read;
        let clamps = builder.clamps()?;
        let parameter = |name: &str| bulk.parameters.get(name).copied();
        let mass_form = if parameter("COUPMASS").is_some_and(|v| v < 0.0) {
            MassForm::Lumped
        } else {
            MassForm::Consistent
        };
        let mass_factor = parameter("WTMASS").unwrap_or(1.0);
        if !(mass_factor > 0.0 && mass_factor.is_finite()) {
            let message = format!("PARAM WTMASS {mass_factor} is not a positive number");
            return Err(InputError::general(message).with_help("it turns the deck's weights into masses"));
        }
        Ok(Self { nodes: builder.nodes, elements, dependents, ties, clamps, mass_factor, mass_form })
    }

    /// Every element, in the order in which they are summed.
    pub fn elements(&self) -> impl Iterator<Item = &dyn Element> {
        self.elements.iter().map(AsRef::as_ref)
    }
}

/// A model's elements and ties while they are read.
struct Reading<'a> {
    builder: build::Builder<'a>,
    elements: Vec<Arc<dyn Element>>,
    dependents: Vec<Dependent>,
    ties: Vec<Tie>,
}

impl registry::Visitor for Reading<'_> {
    fn elements<C: ElementCard>(&mut self, cards: &BTreeMap<u32, C>) -> Result<(), InputError> {
        for card in cards.values() {
            self.elements.push(card.element(&mut self.builder)?);
        }
        Ok(())
    }

    fn ties<'a, C: TieCard + 'a>(
        &mut self,
        cards: impl IntoIterator<Item = &'a C>,
    ) -> Result<(), InputError> {
        for card in cards {
            let first = self.dependents.len();
            self.dependents.extend(card.dependents(&self.builder)?);
            self.ties.extend(Tie::new(card.joint(&self.builder)?, &self.dependents, first));
        }
        Ok(())
    }
}
