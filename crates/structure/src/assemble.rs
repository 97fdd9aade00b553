//! Sums the elements into stiffness and mass of all motions and of the free ones.
//!
//! Element matrices are computed in parallel, a batch at a time, and added in the order of the elements: the sums are
//! the same on any number of threads. Free motions get the element's matrix by its own rows of T, so the whole is never
//! multiplied with T.

use crate::dofs::DofMap;
use crate::element::Element;
use crate::model::{MassForm, Model};
use crate::sparse::{Lower, Pattern, Sparse, Values};
use nalgebra::DMatrix;
use rayon::prelude::*;
use std::sync::Arc;

/// Elements whose matrices are in memory at a time.
const BATCH: usize = 512;

/// Stiffness and mass of the g-set and of the f-set.
pub(crate) struct Assembled {
    pub(crate) k_gg: Lower,
    pub(crate) m_gg: Sparse,
    pub(crate) k_ff: Sparse,
    pub(crate) m_ff: Sparse,
}

/// An element's motions among the free ones: T of its own rows, or where each row stands if no row is a combination.
#[derive(Debug, Clone)]
pub(crate) enum Free {
    Places(Vec<Option<usize>>),
    Combined { dofs: Vec<usize>, t: DMatrix<f64> },
}

/// The sums over all elements of a model; `factors` scales stiffness and mass of an element by its number in the list.
pub(crate) fn assembled(
    model: &Model,
    map: &DofMap,
    factors: impl Fn(usize) -> [f64; 2] + Sync,
) -> Assembled {
    let dofs: Vec<Vec<usize>> = model.elements.iter().map(|element| element.dofs()).collect();
    let mut all = Pattern::of(6 * model.nodes.len(), &dofs).values();
    // Where no motion follows others, the free ones are rows and columns of the whole.
    let mut own = (!map.only_clamps()).then(|| Own::of(&dofs, map));
    for batch in (0..model.elements.len()).step_by(BATCH) {
        let range = batch..(batch + BATCH).min(model.elements.len());
        let one = |at: usize| {
            let [k, m] = matrices(model, &model.elements[at], &dofs[at]);
            let [stiffer, heavier] = factors(at);
            let (k, m) = (k.map(|k| k * stiffer), m.map(|m| m * heavier));
            let free = own.as_ref().map(|own| &own.free[at]);
            let reduced = free.map(|free| [free.reduce(k.as_ref()), free.reduce(m.as_ref())]);
            ([k, m], reduced.unwrap_or_default())
        };
        let computed: Vec<_> = range.clone().into_par_iter().map(one).collect();
        for (at, ([k, m], [k_f, m_f])) in range.zip(computed) {
            all.add(&dofs[at], k.as_ref(), m.as_ref());
            let Some(Own { free, sums }) = &mut own else { continue };
            match &free[at] {
                Free::Places(places) => sums.add_where(places, k.as_ref(), m.as_ref()),
                Free::Combined { dofs, .. } => sums.add(dofs, k_f.as_ref(), m_f.as_ref()),
            }
        }
    }
    let (k_gg, m_gg) = all.lower();
    let parts = || (k_gg.block(&map.free), m_gg.block(&map.free));
    let (k_ff, m_ff) = own.map_or_else(parts, |own| own.sums.symmetric());
    Assembled { m_gg: m_gg.symmetric(), k_gg, k_ff, m_ff }
}

/// The sums of the free motions, where some motions follow others.
struct Own {
    free: Vec<Free>,
    sums: Values,
}

impl Own {
    fn of(dofs: &[Vec<usize>], map: &DofMap) -> Self {
        let free: Vec<Free> = dofs.iter().map(|dofs| free_motions(dofs, map)).collect();
        let lists: Vec<Vec<usize>> = free.iter().map(Free::list).collect();
        Self { free, sums: Pattern::of(map.free.len(), &lists).values() }
    }
}

/// Stiffness and mass of an element, the mass in the form and unit the model asks for.
pub(crate) fn matrices(
    model: &Model,
    element: &Arc<dyn Element>,
    dofs: &[usize],
) -> [Option<DMatrix<f64>>; 2] {
    let k = element.stiffness().map(std::borrow::Cow::into_owned);
    [k, mass_matrix(model, element, dofs)]
}

/// Mass of an element in the form and unit the model asks for.
pub(crate) fn mass_matrix(model: &Model, element: &Arc<dyn Element>, dofs: &[usize]) -> Option<DMatrix<f64>> {
    let is_lumped = model.mass_form == MassForm::Lumped && element.is_elastic();
    let own = || element.mass().map(std::borrow::Cow::into_owned);
    let m = if is_lumped { element.lumped_mass().or_else(|| own().map(|m| lumped(&m, dofs))) } else { own() };
    m.map(|m| m * model.mass_factor)
}

/// Each displacement keeps the sum of its row over displacements of the same component.
fn lumped(mass: &DMatrix<f64>, dofs: &[usize]) -> DMatrix<f64> {
    let of_row = |i: usize| -> f64 {
        let component = dofs[i] % 6;
        if component > 2 {
            return 0.0;
        }
        (0..dofs.len()).filter(|j| dofs[*j] % 6 == component).map(|j| mass[(i, j)]).sum()
    };
    DMatrix::from_diagonal(&nalgebra::DVector::from_fn(dofs.len(), |i, _| of_row(i)))
}

pub(crate) fn free_motions(dofs: &[usize], map: &DofMap) -> Free {
    let is_plain = |dof: &usize| matches!(map.rows[*dof].as_slice(), [] | [(_, 1.0)]);
    let mut own: Vec<usize> = dofs.iter().flat_map(|dof| map.rows[*dof].iter().map(|(at, _)| *at)).collect();
    own.sort_unstable();
    let is_shared = own.windows(2).any(|pair| pair[0] == pair[1]);
    // Where two motions of an element follow the same one, what is between them counts for both.
    if !is_shared && dofs.iter().all(is_plain) {
        return Free::Places(dofs.iter().map(|dof| map.rows[*dof].first().map(|(at, _)| *at)).collect());
    }
    own.dedup();
    let mut t = DMatrix::zeros(dofs.len(), own.len());
    for (row, dof) in dofs.iter().enumerate() {
        for (at, factor) in &map.rows[*dof] {
            t[(row, own.binary_search(at).expect("every motion is in the list"))] += factor;
        }
    }
    Free::Combined { dofs: own, t }
}

impl Free {
    pub(crate) fn list(&self) -> Vec<usize> {
        match self {
            Self::Places(places) => places.iter().flatten().copied().collect(),
            Self::Combined { dofs, .. } => dofs.clone(),
        }
    }

    /// T^T A T; nothing where the element's own matrix can be added as it is.
    pub(crate) fn reduce(&self, matrix: Option<&DMatrix<f64>>) -> Option<DMatrix<f64>> {
        match (self, matrix) {
            (Self::Combined { t, .. }, Some(matrix)) => Some(t.transpose() * matrix * t),
            _ => None,
        }
    }
}
