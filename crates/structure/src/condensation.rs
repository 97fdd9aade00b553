//! Reduction to some motions: static condensation (Guyan, *AIAA Journal* 3, 1965, p. 380), as Nastran does with the motions of ASET and OMIT.
//!
//! An omitted motion follows those that are kept as it would under loads on these alone: `u_o` = -`K_oo`^-1 `K_oa` `u_a`. Displacements under
//! loads on kept motions stay exact; frequencies rise, since masses at omitted motions no longer move by themselves.

use crate::constraints::Combination;
use crate::dofs::DofMap;
use crate::flexibility::{Flexibility, SingularStructure};
use crate::sparse::{self, Pattern};
use crate::system::System;
use faer::Mat;
use nalgebra::DMatrix;
use nastran::{BulkData, Reduction};
use std::collections::{BTreeMap, BTreeSet};

/// Motions of the structure times motions kept beyond which nothing is reduced: what all follow alone takes half a gigabyte.
const MOST: usize = 30_000_000;

/// A structure as a deck wants its modes computed.
#[derive(Debug)]
pub struct Reduced {
    /// The structure, of the motions that are kept.
    pub system: System,
    /// What was done or left undone, for the user; nothing if the deck asks for no reduction.
    pub remark: Option<String>,
}

/// The structure of a deck under its constraints ([`BulkData::bounded`]), reduced as ASET and OMIT say; motions of SUPORT are kept.
///
/// # Errors
/// If omitted motions meet no stiffness while the others are held.
pub fn reduced(bulk: &BulkData, system: System) -> Result<Reduced, SingularStructure> {
    let cards = &bulk.analysis_sets;
    if cards.is_empty() {
        return Ok(Reduced { system, remark: None });
    }
    let is_there = |reduction| cards.iter().any(|card| card.reduction == reduction);
    let named = |reduction| -> BTreeSet<usize> {
        let cards = cards.iter().filter(|card| card.reduction == reduction);
        cards.flat_map(|card| motions(&system, &card.grids, &card.components)).collect()
    };
    let (kept, omitted) = (named(Reduction::Kept), named(Reduction::Omitted));
    let supports = bulk.supports.iter().map(|card| motions(&system, &[card.grid], &card.components));
    let supported: BTreeSet<usize> = supports.flatten().collect();
    // Of cards of both kinds ASET decide: what stands on none is omitted.
    let by_name = |dof| {
        if is_there(Reduction::Kept) { kept.contains(dof) } else { !omitted.contains(dof) }
    };
    let is_kept = |at: &usize| {
        let dof = &system.free_dofs()[*at];
        supported.contains(dof) || by_name(dof)
    };
    let places: Vec<usize> = (0..system.free_count()).filter(is_kept).collect();
    let (count, all) = (places.len(), system.free_count());
    let obstacle = if is_there(Reduction::Generalised) {
        Some("QSET is not followed".to_owned())
    } else if count == 0 {
        Some("ASET and OMIT keep no motion that is free".to_owned())
    } else if count.saturating_mul(6 * system.node_count()) > MOST {
        Some(format!("ASET and OMIT keep {count} motions, too many for a reduction"))
    } else {
        None
    };
    if let Some(why) = obstacle {
        let remark = Some(format!("{why}: modes are those of all motions, without reduction"));
        return Ok(Reduced { system, remark });
    }
    let remark =
        format!("modes are those of {count} of {all} motions, as ASET and OMIT say (static condensation)");
    Ok(Reduced { system: system.condensed(&places)?, remark: Some(remark) })
}

/// The motions of grids, 6 * node + component - 1; none of grids that are not there, which lists by THRU reach over.
fn motions(system: &System, grids: &[u32], components: &[u8]) -> Vec<usize> {
    let components = if components.is_empty() { &[1] } else { components };
    let nodes = grids.iter().filter_map(|grid| system.node_index(*grid));
    nodes.flat_map(|node| components.iter().map(move |c| 6 * node + usize::from(*c) - 1)).collect()
}

impl System {
    /// The structure reduced to some of its free motions (`kept`, ascending places in the f-set), which all others follow.
    ///
    /// # Errors
    /// If the others meet no stiffness while these are held.
    fn condensed(&self, kept: &[usize]) -> Result<Self, SingularStructure> {
        let t = self.followed(kept)?;
        let reduced = |a| {
            let product = t.transpose() * sparse::multiply(a, t.as_ref());
            DMatrix::from_fn(kept.len(), kept.len(), |i, j| 0.5 * (product[(i, j)] + product[(j, i)]))
        };
        let all: Vec<usize> = (0..kept.len()).collect();
        let mut values = Pattern::of(kept.len(), std::slice::from_ref(&all)).values();
        values.add(&all, Some(&reduced(self.stiffness())), Some(&reduced(self.mass())));
        let (k, m) = values.symmetric();
        let motions = self.motions();
        let combined = |row: &Combination| -> Combination {
            let mut sum: BTreeMap<usize, f64> = BTreeMap::new();
            for (at, factor) in row {
                for column in all.iter().filter(|column| t[(*at, **column)] != 0.0) {
                    *sum.entry(*column).or_default() += factor * t[(*at, *column)];
                }
            }
            sum.into_iter().collect()
        };
        let free = kept.iter().map(|at| motions.free[*at]).collect();
        Ok(self.with_free(DofMap { free, rows: motions.rows.iter().map(combined).collect() }, [k, m]))
    }

    /// What all free motions are by a unit of each that is kept, the loads on the others zero.
    fn followed(&self, kept: &[usize]) -> Result<Mat<f64>, SingularStructure> {
        let mut t = Mat::zeros(self.free_count(), kept.len());
        kept.iter().enumerate().for_each(|(column, at)| t[(*at, column)] = 1.0);
        let omitted: Vec<usize> =
            (0..self.free_count()).filter(|at| kept.binary_search(at).is_err()).collect();
        let forces = sparse::multiply(self.stiffness(), t.as_ref());
        let loads = Mat::from_fn(omitted.len(), kept.len(), |i, j| -forces[(omitted[i], j)]);
        let displaced = Flexibility::new(&self.restricted(&omitted))?.displacements(loads.as_ref());
        for (i, at) in omitted.iter().enumerate() {
            (0..kept.len()).for_each(|j| t[(*at, j)] = displaced[(i, j)]);
        }
        Ok(t)
    }
}
