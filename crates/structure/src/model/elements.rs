//! Beams, springs and masses: cards to elements.

use super::build::{Builder, undefined};
use crate::beam::{Beam, BeamPlacement};
use crate::element::Element;
use crate::masses::PointMass;
use crate::matrix_element::MatrixElement;
use crate::springs;
use nalgebra::{Matrix3, Point3, Vector3};
use nastran::{
    BeamElement, BushAxes, Cbush, InputError, Motion, Orientation, ScalarElement, ScalarProperty,
    ScalarValue, Span,
};
use std::collections::BTreeMap;
use std::sync::Arc;

type Elements = Result<Vec<Arc<dyn Element>>, InputError>;

fn shared(element: impl Element + 'static) -> Arc<dyn Element> {
    Arc::new(element)
}

impl Builder<'_> {
    pub(super) fn beams(&self) -> Elements {
        let mut elements: Vec<Arc<dyn Element>> = Vec::new();
        for card in self.bulk.beams.values() {
            elements.push(shared(self.beam(card)?));
        }
        for card in self.bulk.rods.values() {
            let user = format!("CROD {}", card.id);
            let ends =
                [self.node(card.grids[0], &user, &card.span)?, self.node(card.grids[1], &user, &card.span)?];
            let rods = &self.bulk.rod_properties;
            let property = rods
                .get(&card.property)
                .ok_or_else(|| undefined(&user, "PROD", card.property, rods.keys(), &card.span))?;
            let materials = &self.bulk.materials;
            let material = materials.get(&property.material).ok_or_else(|| {
                let user = format!("PROD {}", property.id);
                undefined(&user, "MAT1", property.material, materials.keys(), &property.span)
            })?;
            elements.push(shared(springs::rod(card, &self.nodes, ends, property, material)?));
        }
        Ok(elements)
    }

    fn beam(&self, card: &BeamElement) -> Result<Beam, InputError> {
        let bulk = self.bulk;
        let user = format!("{} {}", if card.is_beam { "CBEAM" } else { "CBAR" }, card.id);
        let nodes =
            [self.node(card.grids[0], &user, &card.span)?, self.node(card.grids[1], &user, &card.span)?];
        let property = bulk.beam_properties.get(&card.property).ok_or_else(|| {
            let kind = if card.is_beam { "PBEAM" } else { "PBAR" };
            undefined(&user, kind, card.property, bulk.beam_properties.keys(), &card.span)
        })?;
        let material = bulk.materials.get(&property.material).ok_or_else(|| {
            let user = format!("{} {}", if property.is_beam { "PBEAM" } else { "PBAR" }, property.id);
            undefined(&user, "MAT1", property.material, bulk.materials.keys(), &property.span)
        })?;
        let grids = nodes.map(|node| self.nodes[node].point);
        let orientation = self.orientation(&card.orientation, nodes[0], &user, &card.span)?;
        let mut offsets = [Vector3::zeros(); 2];
        for (end, offset) in offsets.iter_mut().enumerate() {
            *offset = self.nodes[nodes[end]].axes * Vector3::from(card.offsets[end]);
        }
        let placement = BeamPlacement { grids, offsets, orientation, pins: card.pins.clone() };
        Beam::new(card.id, nodes, &placement, property, material, &card.span)
    }

    fn orientation(
        &self,
        orientation: &Orientation,
        end_a: usize,
        user: &str,
        span: &Span,
    ) -> Result<Vector3<f64>, InputError> {
        match orientation {
            Orientation::Vector(v) => Ok(self.nodes[end_a].axes * Vector3::from(*v)),
            Orientation::Grid(id) => {
                let node = self.node(*id, &format!("{user} (orientation)"), span)?;
                Ok(self.nodes[node].point - self.nodes[end_a].point)
            }
        }
    }

    pub(super) fn springs(&self) -> Elements {
        let mut elements = Vec::new();
        for card in self.bulk.bushes.values() {
            elements.push(shared(self.bush(card)?));
        }
        for card in self.bulk.springs.values() {
            let (dofs, k) = self.scalar(card, ["CELAS", "PELAS"], &self.bulk.spring_properties)?;
            elements.push(shared(MatrixElement::spring(card.id, &dofs, &k)));
        }
        for card in self.bulk.general.values() {
            let user = format!("GENEL {}", card.id);
            let ui = self.motions(&card.ui, &user, &card.span)?;
            let ud = self.motions(&card.ud, &user, &card.span)?;
            elements.push(shared(springs::general(card, &self.nodes, &ui, &ud)?));
        }
        Ok(elements)
    }

    fn bush(&self, card: &Cbush) -> Result<MatrixElement, InputError> {
        let user = format!("CBUSH {}", card.id);
        let end_a = self.node(card.grids.0, &user, &card.span)?;
        let end_b = card.grids.1.map(|grid| self.node(grid, &user, &card.span)).transpose()?;
        let bushes = &self.bulk.bush_properties;
        let property = bushes
            .get(&card.property)
            .ok_or_else(|| undefined(&user, "PBUSH", card.property, bushes.keys(), &card.span))?;
        let a = self.nodes[end_a].point;
        let along = end_b.map_or_else(Vector3::zeros, |b| self.nodes[b].point - a);
        let place = match card.offset {
            Some((system, xyz)) => self.frames.point(system, xyz, &card.span)?,
            None => a + along * card.location,
        };
        let axes = match &card.axes {
            BushAxes::System(system) => Some(self.axes_at(*system, &place, &card.span)?),
            BushAxes::Oriented(orientation) => {
                let vector = self.orientation(orientation, end_a, &user, &card.span)?;
                springs::line_axes(&along, Some(&vector))
            }
            BushAxes::Line => springs::line_axes(&along, None),
        };
        let crosswise = [1, 2, 4, 5].iter().any(|at| property.stiffness[*at] != 0.0);
        let needs_more = card.axes == BushAxes::Line && crosswise;
        let Some(axes) = axes.filter(|_| !needs_more) else {
            let message = format!("{user}: the axes of its stiffnesses are not determined");
            let help = "give a coordinate system in field CID (0 is the basic one), or an orientation vector";
            return Err(InputError::at(&card.span, message).with_help(help));
        };
        if let Some(value) = property.stiffness.iter().find(|value| !(**value >= 0.0 && value.is_finite())) {
            let message = format!("PBUSH {} has the stiffness {value}", property.id);
            return Err(InputError::at(&property.span, message).with_help("a stiffness is zero or positive"));
        }
        Ok(springs::bush(card.id, &self.nodes, (end_a, end_b), &place, &axes, property))
    }

    pub(super) fn axes_at(
        &self,
        system: u32,
        place: &Point3<f64>,
        span: &Span,
    ) -> Result<Matrix3<f64>, InputError> {
        self.frames.axes_at_point(system, place, span)
    }

    fn motions(
        &self,
        motions: &[Motion],
        user: &str,
        span: &Span,
    ) -> Result<Vec<(usize, usize)>, InputError> {
        motions
            .iter()
            .map(|(grid, component)| {
                Ok((self.node(*grid, user, span)?, usize::from(*component).saturating_sub(1)))
            })
            .collect()
    }

    fn scalar(
        &self,
        card: &ScalarElement,
        [element, kind]: [&str; 2],
        properties: &BTreeMap<u32, ScalarProperty>,
    ) -> Result<(Vec<usize>, nalgebra::DMatrix<f64>), InputError> {
        let user = format!("{element} {}", card.id);
        let value = match card.value {
            ScalarValue::Given(value) => value,
            ScalarValue::Property(id) => {
                properties
                    .get(&id)
                    .ok_or_else(|| undefined(&user, kind, id, properties.keys(), &card.span))?
                    .value
            }
        };
        let mut ends = [None; 2];
        for (end, given) in ends.iter_mut().zip(card.ends) {
            if let Some(motion) = given {
                *end = self.motions(&[motion], &user, &card.span)?.first().copied();
            }
        }
        Ok(springs::scalar(&self.nodes, ends, value))
    }

    pub(super) fn masses(&self) -> Elements {
        let mut elements = Vec::new();
        for card in self.bulk.masses.values() {
            let node = self.node(card.grid, &format!("CONM2 {}", card.id), &card.span)?;
            let point = &self.nodes[node].point;
            elements.push(shared(PointMass::from_card(card, node, point, &self.frames)?));
        }
        for card in self.bulk.mass_matrices.values() {
            let node = self.node(card.grid, &format!("CONM1 {}", card.id), &card.span)?;
            let axes = self.axes_at(card.cid, &self.nodes[node].point, &card.span)?;
            elements.push(shared(springs::mass_matrix(card, node, &axes)));
        }
        for card in self.bulk.scalar_masses.values() {
            let (dofs, m) = self.scalar(card, ["CMASS", "PMASS"], &self.bulk.mass_properties)?;
            elements.push(shared(MatrixElement::mass(card.id, &dofs, &m)));
        }
        Ok(elements)
    }
}
