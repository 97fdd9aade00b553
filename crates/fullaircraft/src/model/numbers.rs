//! Numbers of cards: raised by a step so that models can stand in one deck, and put together.

use crate::model::numbers_elements;
use nastran::{BulkData, CoordDefinition, Divisions, InputError, Orientation};
use std::collections::BTreeMap;

/// Steps by which numbers are raised.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Step {
    /// Of everything except panels and their boxes.
    pub cards: u32,
    /// Of panels and boxes.
    pub boxes: u32,
}

impl Step {
    /// Powers of ten above every number in a model, at least 10000 for cards and 1000000 for boxes.
    pub fn above(bulk: &BulkData, last_box: u32) -> Self {
        let keys = [
            bulk.grids.keys().max(),
            bulk.coords.keys().max(),
            bulk.beams.keys().max(),
            bulk.beam_properties.keys().max(),
            bulk.materials.keys().max(),
            bulk.masses.keys().max(),
            bulk.rigid.keys().max(),
            bulk.factors.keys().max(),
            bulk.surfaces.keys().max(),
            bulk.box_lists.keys().max(),
            bulk.sets.keys().max(),
        ];
        let largest =
            keys.into_iter().flatten().copied().max().unwrap_or(0).max(numbers_elements::largest(bulk));
        let power = |least: u32, above: u32| {
            std::iter::successors(Some(least), |power| power.checked_mul(10)).find(|power| *power > above)
        };
        // Nastran's numbers have at most 8 digits, so a power is found; if not, joining will name the collision.
        Self {
            cards: power(10_000, largest).unwrap_or(10_000),
            boxes: power(1_000_000, last_box).unwrap_or(1_000_000),
        }
    }
}

/// The model with numbers raised and `prefix` before the labels of its control surfaces.
pub fn raised(bulk: &BulkData, step: Step, prefix: &str) -> BulkData {
    let cards = |id: u32| id.saturating_add(step.cards);
    let boxes = |id: u32| id.saturating_add(step.boxes);
    let system = |id: u32| if id == 0 { 0 } else { cards(id) };
    let mut new = bulk.clone();
    new.grids = rekeyed(new.grids, cards, |g| (g.id, g.cp, g.cd) = (cards(g.id), system(g.cp), system(g.cd)));
    new.coords = rekeyed(new.coords, cards, |c| {
        c.id = cards(c.id);
        match &mut c.definition {
            CoordDefinition::Points { rid, .. } => *rid = system(*rid),
            CoordDefinition::Grids(grids) => *grids = grids.map(cards),
        }
    });
    new.beams = rekeyed(new.beams, cards, |b| {
        (b.id, b.property, b.grids) = (cards(b.id), cards(b.property), b.grids.map(cards));
        if let Orientation::Grid(grid) = &mut b.orientation {
            *grid = cards(*grid);
        }
    });
    new.beam_properties =
        rekeyed(new.beam_properties, cards, |p| (p.id, p.material) = (cards(p.id), cards(p.material)));
    new.materials = rekeyed(new.materials, cards, |m| m.id = cards(m.id));
    new.masses = rekeyed(new.masses, cards, |m| (m.id, m.grid) = (cards(m.id), cards(m.grid)));
    new.rigid = rekeyed(new.rigid, cards, |r| {
        (r.id, r.independent) = (cards(r.id), cards(r.independent));
        r.dependent.iter_mut().for_each(|id| *id = cards(*id));
    });
    numbers_elements::raise(&mut new, step.cards);
    new.constraints.iter_mut().flat_map(|c| &mut c.grids).for_each(|id| *id = cards(*id));
    let divisions = |d: Divisions| match d {
        Divisions::Aefact(id) => Divisions::Aefact(cards(id)),
        Divisions::Equal(count) => Divisions::Equal(count),
    };
    new.panels = rekeyed(new.panels, boxes, |p| {
        (p.id, p.property, p.cp) = (boxes(p.id), cards(p.property), system(p.cp));
        (p.span_divisions, p.chord_divisions) = (divisions(p.span_divisions), divisions(p.chord_divisions));
    });
    new.panel_properties = rekeyed(new.panel_properties, cards, |_| ());
    new.factors = rekeyed(new.factors, cards, |f| f.id = cards(f.id));
    new.box_lists = rekeyed(new.box_lists, cards, |list| {
        list.id = cards(list.id);
        list.boxes.iter_mut().for_each(|id| *id = boxes(*id));
    });
    new.surfaces = rekeyed(new.surfaces, cards, |s| {
        s.id = cards(s.id);
        s.label = format!("{prefix}{}", s.label);
        s.parts.iter_mut().for_each(|part| *part = (system(part.0), cards(part.1)));
    });
    new.sets = rekeyed(new.sets, cards, |s| {
        s.id = cards(s.id);
        s.ids.iter_mut().for_each(|id| *id = cards(*id));
    });
    new
}

pub(crate) fn rekeyed<T>(
    map: BTreeMap<u32, T>,
    key: impl Fn(u32) -> u32,
    change: impl Fn(&mut T),
) -> BTreeMap<u32, T> {
    let change = |(id, mut card): (u32, T)| {
        change(&mut card);
        (key(id), card)
    };
    map.into_iter().map(change).collect()
}

/// Adds the cards of `other`; `W2GJ` of `other` is put behind, so its panels must have the higher numbers.
///
/// # Errors
/// If both use a number for the same kind of card.
pub fn join(all: &mut BulkData, mut other: BulkData) -> Result<(), InputError> {
    numbers_elements::join(all, &mut other)?;
    merge(&mut all.grids, other.grids, "GRID")?;
    merge(&mut all.coords, other.coords, "CORD2R")?;
    merge(&mut all.beams, other.beams, "CBEAM")?;
    merge(&mut all.beam_properties, other.beam_properties, "PBEAM")?;
    merge(&mut all.materials, other.materials, "MAT1")?;
    merge(&mut all.masses, other.masses, "CONM2")?;
    merge(&mut all.rigid, other.rigid, "RBE2")?;
    merge(&mut all.panels, other.panels, "CAERO1")?;
    merge(&mut all.panel_properties, other.panel_properties, "PAERO1")?;
    merge(&mut all.factors, other.factors, "AEFACT")?;
    merge(&mut all.surfaces, other.surfaces, "AESURF")?;
    merge(&mut all.box_lists, other.box_lists, "AELIST")?;
    merge(&mut all.sets, other.sets, "SET1")?;
    all.constraints.extend(other.constraints);
    for (name, matrix) in other.matrices {
        match all.matrices.get_mut(&name) {
            Some(first) => {
                first.rows += matrix.rows;
                for (column, more) in first.columns.iter_mut().zip(matrix.columns) {
                    column.extend(more);
                }
            }
            None => _ = all.matrices.insert(name, matrix),
        }
    }
    Ok(())
}

pub(crate) fn merge<T>(
    all: &mut BTreeMap<u32, T>,
    other: BTreeMap<u32, T>,
    kind: &str,
) -> Result<(), InputError> {
    for (id, card) in other {
        if all.insert(id, card).is_some() {
            return Err(InputError::general(format!(
                "the parts of the aircraft share the number of {kind} {id}"
            ))
            .with_help("use smaller numbers in the wing's deck"));
        }
    }
    Ok(())
}
