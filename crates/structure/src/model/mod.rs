//! A structure as the deck describes it, every reference checked and everything turned to basic axes.
//!
//! Elements work in basic axes. A grid's displacement system (CD) turns the components that constraints, rigid elements
//! and scalar elements name, beam offsets and orientation vectors.

mod build;
mod bushes;
mod conrod;
mod dampers;
mod direct;
mod elements;
mod enforced;
mod heat;
mod inertial;
mod laminates;
mod links;
mod loads;
mod nastran_shells;
mod node;
pub(crate) mod registry;
mod shear;
mod shells;
mod solids;
mod temperatures;
mod tube;

pub use dampers::{dampers, modal_structural_damping};
pub use enforced::enforced_motions;
pub use heat::thermal_loads;
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
    /// As points at the ends of beams, with their inertia about the grids; of other elements each displacement keeps the sum of its
    /// row and rotations have none. (Concentrated masses stay as they are.)
    Lumped,
}

impl MassForm {
    /// Nastran's of a deck: lumped unless PARAM COUPMASS is above zero.
    fn of_deck(bulk: &BulkData) -> Self {
        let is_consistent = bulk.parameters.get("COUPMASS").is_some_and(|value| *value > 0.0);
        if is_consistent { Self::Consistent } else { Self::Lumped }
    }
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
    /// Clamps: those of the grids, then those of the constraint cards.
    pub clamps: Vec<Clamp>,
    /// What every mass is multiplied with (PARAM WTMASS); one if the deck says nothing.
    pub mass_factor: f64,
    /// Consistent, or lumped (PARAM COUPMASS -1).
    pub mass_form: MassForm,
    /// Whether motions without stiffness at their grid are held (AUTOSPC).
    pub holds_loose: bool,
}

impl Model {
    /// Reads the structure of a wing or of a part from bulk data: consistent mass unless PARAM COUPMASS says otherwise.
    ///
    /// # Errors
    /// If the deck has elements that are not read or dampers, a card refers to something that is not there or describes no possible element (the card is blamed and
    /// the hint lists what there is), or it is left open which constraints apply ([`BulkData::bounded`]).
    pub fn from_bulk(bulk: &BulkData) -> Result<Self, InputError> {
        Self::from_bulk_with(bulk, ShearModel::Equilibrium)
    }

    /// Reads the structure of a user's deck as Nastran does: lumped mass unless PARAM COUPMASS is above zero, motions
    /// without stiffness held unless PARAM AUTOSPC is NO, flat shells as its own and with normals of their grids ([`crate::Shell::as_nastran`], [`crate::Shell::with_grid_normals`]), under the boundary conditions of a subcase ([`BulkData::bounded`]).
    ///
    /// # Errors
    /// As [`Model::from_bulk`].
    pub fn from_deck(bulk: &BulkData, subcase: Option<u32>) -> Result<Self, InputError> {
        bulk.refuse_unread_undamped()?;
        let bulk = &*bulk.bounded(subcase)?;
        // They have no part here, but what they name must be there.
        dampers(bulk)?;
        let mut model = Self::read(bulk, ShearModel::Equilibrium, true)?;
        model.holds_loose = bulk.parameters.get("AUTOSPC") != Some(&0.0);
        model.mass_form = MassForm::of_deck(bulk);
        Ok(model)
    }

    /// As [`Model::from_bulk`], with another rule for the transverse shear stiffness of laminates (PCOMP).
    ///
    /// # Errors
    /// As [`Model::from_bulk`].
    pub fn from_bulk_with(bulk: &BulkData, shear: ShearModel) -> Result<Self, InputError> {
        bulk.refuse_unread_elements()?;
        let bulk = &*bulk.bounded(None)?;
        if let Some(damper) = dampers(bulk)?.first() {
            let message = format!("{} is a damper, which wings are computed without", damper.owner);
            return Err(InputError::at(&damper.span, message).with_help(
                "take it out and give modes a damping ratio; flutter --deck and gust --deck compute with it",
            ));
        }
        Self::read(bulk, shear, false)
    }

    /// Reads what is there, under the constraints that are there.
    fn read(bulk: &BulkData, shear: ShearModel, as_nastran: bool) -> Result<Self, InputError> {
        let (builder, clamps) = build::Builder::prepared(bulk, shear, as_nastran)?;
        let mut read = Reading { builder, elements: Vec::new(), dependents: Vec::new(), ties: Vec::new() };
        registry::visit(bulk, &mut read)?;
        let Reading { builder, mut elements, dependents, ties } = read;
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
        for matrix in &bulk.added {
            elements.extend(direct::elements(&builder, &bulk.direct_matrices, matrix, mass_factor)?);
        }
        Ok(Self {
            nodes: builder.nodes,
            elements,
            dependents,
            ties,
            clamps,
            mass_factor,
            mass_form,
            holds_loose: false,
        })
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
