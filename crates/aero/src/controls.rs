//! Control surfaces: AESURF with its box lists, as incidence per radian of deflection.
//!
//! A deflection turns the boxes about the hinge, the y axis of the AESURF's coordinate system, by the right-hand
//! rule (trailing edge down for a hinge that points to the right). Linearised, a box's incidence is the part of
//! that rotation about its own pitch axis: hinge . (n x x), for a swept hinge the cosine of its sweep.

use crate::lattice::Lattice;
use crate::stream_axes::StreamAxes;
use nastran::{Aelist, Aesurf, BulkData, Frames, InputError};
use std::collections::BTreeMap;

/// One control surface.
#[derive(Debug, Clone, PartialEq)]
pub struct ControlSurface {
    /// Label.
    pub name: String,
    /// Indices of its boxes in the lattice, ascending.
    pub boxes: Vec<usize>,
    /// Incidence per rad of deflection of these boxes, same order; includes the effectiveness EFF.
    pub slope: Vec<f64>,
    /// Incidence times V per rad/s of deflection of these boxes, m: the lever of their three-quarter points about
    /// the hinge; includes EFF.
    pub lever_m: Vec<f64>,
}

impl ControlSurface {
    /// All control surfaces of a deck, in ascending AESURF number.
    ///
    /// # Errors
    /// If a box list, a box of it or a coordinate system is not there, or a label is used twice.
    pub fn all_from_bulk(bulk: &BulkData, lattice: &Lattice) -> Result<Vec<Self>, InputError> {
        Self::all_in_axes(bulk, lattice, &StreamAxes::basic())
    }

    /// As [`ControlSurface::all_from_bulk`], for boxes seen in axes of the stream ([`Lattice::in_axes`]).
    ///
    /// # Errors
    /// As [`ControlSurface::all_from_bulk`].
    pub fn all_in_axes(
        bulk: &BulkData,
        lattice: &Lattice,
        stream: &StreamAxes,
    ) -> Result<Vec<Self>, InputError> {
        let frames = Frames::resolve(bulk)?;
        let index: BTreeMap<u32, usize> = lattice.boxes.iter().enumerate().map(|(i, b)| (b.id, i)).collect();
        let mut all: Vec<Self> = Vec::new();
        for card in bulk.surfaces.values() {
            if all.iter().any(|surface| surface.name == card.label) {
                return Err(InputError::at(
                    &card.span,
                    format!("the label {} is used by two AESURF", card.label),
                ));
            }
            let mut parts: BTreeMap<usize, [f64; 2]> = BTreeMap::new();
            for (cid, list) in &card.parts {
                let hinge = stream.axes.transpose() * frames.axes_at(*cid, &card.span)?.column(1);
                let origin = stream.seen(&frames.origin(*cid, &card.span)?);
                for place in places(box_list(bulk, card, *list)?, &index)? {
                    let panel = &lattice.boxes[place];
                    let arm = panel.three_quarter_point() - origin;
                    let sum = parts.entry(place).or_insert([0.0; 2]);
                    sum[0] += card.effectiveness * hinge.dot(&panel.pitch_axis());
                    sum[1] -= card.effectiveness * hinge.cross(&arm).dot(&panel.normal());
                }
            }
            all.push(Self {
                name: card.label.clone(),
                boxes: parts.keys().copied().collect(),
                slope: parts.values().map(|part| part[0]).collect(),
                lever_m: parts.values().map(|part| part[1]).collect(),
            });
        }
        Ok(all)
    }

    /// Incidence per rad of deflection of every box of a lattice of `boxes` boxes.
    pub fn column(&self, boxes: usize) -> Vec<f64> {
        self.spread(&self.slope, boxes)
    }

    /// Incidence times V per rad/s of deflection of every box of a lattice of `boxes` boxes, m.
    pub fn rate_column_m(&self, boxes: usize) -> Vec<f64> {
        self.spread(&self.lever_m, boxes)
    }

    fn spread(&self, values: &[f64], boxes: usize) -> Vec<f64> {
        let mut w = vec![0.0; boxes];
        for (&place, &value) in self.boxes.iter().zip(values) {
            if let Some(entry) = w.get_mut(place) {
                *entry = value;
            }
        }
        w
    }
}

fn box_list<'a>(bulk: &'a BulkData, card: &Aesurf, id: u32) -> Result<&'a Aelist, InputError> {
    bulk.box_lists.get(&id).ok_or_else(|| {
        InputError::at(&card.span, format!("AESURF {} refers to AELIST {id}, which is not there", card.label))
    })
}

/// Indices of the boxes of a list, each once.
fn places(list: &Aelist, index: &BTreeMap<u32, usize>) -> Result<Vec<usize>, InputError> {
    let find = |id: &u32| {
        index.get(id).copied().ok_or_else(|| {
            InputError::at(&list.span, format!("AELIST {} lists box {id}, which no CAERO1 has", list.id))
                .with_help("boxes are numbered from the CAERO1's number, chordwise first, then spanwise")
        })
    };
    let mut found = list.boxes.iter().map(find).collect::<Result<Vec<_>, _>>()?;
    found.sort_unstable();
    found.dedup();
    Ok(found)
}
