//! The mirror image of a deck about the plane y = 0.
//!
//! Mirroring a point changes the sign of y. It also turns right-handed axes into left-handed ones; what a
//! deck says in local axes changes accordingly: the products of inertia xy and yz, and of a beam's section what
//! lies along its z axis (`I12`, z offsets), because element z is the cross product of axis and orientation vector. Each
//! card says beside its type what its image is.

use crate::bulk_data::{BulkData, Change, Rest};
use crate::cards::Divisions;
use crate::cards::kind::{CardKind, DeckCard, Mirror};
use crate::dmi::Dmi;
use crate::geometry::Frames;
use crate::source::InputError;
use std::collections::{BTreeMap, BTreeSet};

impl Change for Mirror<'_> {
    fn card<C: DeckCard>(&mut self, _: &CardKind, card: C) -> Result<Option<C>, InputError> {
        card.mirrored(self)
    }
}

impl BulkData {
    /// The mirror image about y = 0, every number kept; `boxes` is the image of each box number, one to one. Mirrored
    /// twice, a model in basic axes is itself again. Left out are splines, monitoring stations, matrices other than
    /// `W2GJ`, structural damping, and what is asked of the whole aircraft (case control, unions of sets, trims).
    ///
    /// # Errors
    /// If a grid's displacement system or a mass's system is not basic, an AEFACT divides both span and chord, a card
    /// has no image (GENEL, some scalar elements), or a reference leads nowhere; the card is blamed.
    pub fn mirrored(&self, boxes: &BTreeMap<u32, u32>) -> Result<Self, InputError> {
        self.refuse_added("mirrored")?;
        let frames = Frames::resolve(self)?;
        let to_basic = |system, xyz, span: &_| frames.point(system, xyz, span);
        let mut mirror = Mirror { to_basic: &to_basic, boxes, strips: self.strips()? };
        let mut image = Self::default();
        let rest = self.clone().pour(&mut image, &mut mirror)?;
        let Rest {
            parameters,
            bars_twist,
            mut matrices,
            subcases: _,
            added: _,
            loss_factors: _,
            air_errors,
            unknown,
        } = rest;
        let incidence = matrices.remove("W2GJ").map(|matrix| carried(boxes, matrix));
        image.matrices.extend(incidence.map(|matrix| (matrix.name.clone(), matrix)));
        (image.parameters, image.bars_twist) = (parameters, bars_twist);
        (image.air_errors, image.unknown) = (air_errors, unknown);
        Ok(image)
    }

    /// AEFACT that divide the span, whose strips count from the other side in an image.
    fn strips(&self) -> Result<BTreeSet<u32>, InputError> {
        let strips: BTreeSet<u32> =
            self.panels.values().filter_map(|panel| panel.span_divisions.list()).collect();
        for panel in self.panels.values() {
            if let Divisions::Aefact(id) = panel.chord_divisions
                && strips.contains(&id)
            {
                let message = format!("AEFACT {id} divides chord and span, so it cannot be mirrored");
                return Err(
                    InputError::at(&panel.span, message).with_help("give chord and span their own AEFACT")
                );
            }
        }
        Ok(strips)
    }
}

/// Values in ascending box number, carried to the images: also in ascending number.
fn carried(boxes: &BTreeMap<u32, u32>, mut matrix: Dmi) -> Dmi {
    for column in &mut matrix.columns {
        let mut values: Vec<(u32, f64)> = boxes.values().copied().zip(column.iter().copied()).collect();
        values.sort_unstable_by_key(|(id, _)| *id);
        *column = values.into_iter().map(|(_, value)| value).collect();
    }
    matrix
}
