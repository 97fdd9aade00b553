//! Damping of a user's deck: viscous by CDAMP, CVISC, and B and C of bushes, structural by GE. It has no part in statics, natural modes
//! and trims.

use super::build::Builder;
use super::registry::{self, DamperCard, ElementCard, Visitor};
use crate::damper::{Damper, on_modes};
use crate::laminate::ShearModel;
use faer::{Mat, MatRef};
use nastran::{BulkData, InputError};
use std::collections::BTreeMap;

/// The dampers of a deck, under the constraints that are there.
///
/// # Errors
/// If one refers to something that is not there, or has no length or axes.
pub fn dampers(bulk: &BulkData) -> Result<Vec<Damper>, InputError> {
    let mut count = Count(0);
    registry::visit(bulk, &mut count)?;
    if count.0 == 0 {
        return Ok(Vec::new());
    }
    let builder = Builder::new(bulk, ShearModel::Equilibrium)?;
    let mut found = Dampers { builder, all: Vec::new() };
    registry::visit(bulk, &mut found)?;
    Ok(found.all)
}

/// Structural damping forces on modes by their displacements, sum of GE Phi^T k Phi over the elements of a deck that have a loss factor;
/// shapes over the g-set, a column a mode.
///
/// # Errors
/// As where the elements are made.
pub fn modal_structural_damping(bulk: &BulkData, shapes: MatRef<'_, f64>) -> Result<Mat<f64>, InputError> {
    let none = Mat::zeros(shapes.ncols(), shapes.ncols());
    if bulk.loss_factors.is_empty() {
        return Ok(none);
    }
    let (builder, _) = Builder::prepared(bulk, ShearModel::Equilibrium, true)?;
    let mut sum = Hysteretic { builder, shapes, sum: none };
    registry::visit(bulk, &mut sum)?;
    Ok(sum.sum)
}

/// How many cards may damp.
struct Count(usize);

impl Visitor for Count {
    fn dampers<C: DamperCard>(&mut self, cards: &BTreeMap<u32, C>) -> Result<(), InputError> {
        self.0 += cards.len();
        Ok(())
    }
}

struct Hysteretic<'a> {
    builder: Builder<'a>,
    shapes: MatRef<'a, f64>,
    sum: Mat<f64>,
}

impl Visitor for Hysteretic<'_> {
    fn elements<C: ElementCard>(&mut self, cards: &BTreeMap<u32, C>) -> Result<(), InputError> {
        for card in cards.values() {
            if let Some((dofs, matrix)) = card.structural_damping(&mut self.builder)? {
                self.sum += on_modes(&dofs, &matrix, self.shapes);
            }
        }
        Ok(())
    }
}

struct Dampers<'a> {
    builder: Builder<'a>,
    all: Vec<Damper>,
}

impl Visitor for Dampers<'_> {
    fn dampers<C: DamperCard>(&mut self, cards: &BTreeMap<u32, C>) -> Result<(), InputError> {
        for card in cards.values() {
            self.all.extend(card.damper(&self.builder)?);
        }
        Ok(())
    }
}
