//! Springs, bushes and dampers: cards to elements, and to dampers.

use super::build::{Builder, found};
use super::registry::{DamperCard, ElementCard};
use crate::cell_shape::CellShape;
use crate::corotation::Corotation;
use crate::damper::Damper;
use crate::element::Element;
use crate::matrix_element::MatrixElement;
use crate::springs::{self, BushPlace, OverMotions};
use nalgebra::{DMatrix, DVector, Vector3};
use nastran::{
    BulkData, BushAxes, Cbush, Cbush1d, Cvisc, InputError, Pbush, Pbush1d, ScalarElement, ScalarKind,
    ScalarValue,
};
use std::sync::Arc;

/// Where a bush is and what it is made of; `values` of its property are those whose axes must be determined.
fn bush<'a>(
    card: &Cbush,
    builder: &Builder<'a>,
    values: impl Fn(&Pbush) -> [f64; 6],
) -> Result<(BushPlace, &'a Pbush), InputError> {
    let user = format!("CBUSH {}", card.id);
    let end_a = builder.node(card.grids.0, &user, &card.span)?;
    let end_b = card.grids.1.map(|grid| builder.node(grid, &user, &card.span)).transpose()?;
    let property = found(&builder.bulk.bush_properties, card.property, &user, "PBUSH", &card.span)?;
    let a = builder.nodes[end_a].point;
    let along = end_b.map_or_else(Vector3::zeros, |b| builder.nodes[b].point - a);
    let (point, mass_at_b) = match card.offset {
        Some((system, xyz)) => {
            let point = builder.frames.point(system, xyz, &card.span)?;
            let [from_a, to_b] = [a, a + along].map(|end| (point - end).norm());
            (point, if from_a > 0.0 { from_a / (from_a + to_b) } else { 0.0 })
        }
        None => (a + along * card.location, card.location),
    };
    let axes = match &card.axes {
        BushAxes::System(system) => Some(builder.frames.axes_at_point(*system, &point, &card.span)?),
        BushAxes::Oriented(orientation) => {
            let vector = builder.orientation(orientation, end_a, &user, &card.span)?;
            springs::line_axes(&along, Some(&vector))
        }
        BushAxes::Line => springs::line_axes(&along, None),
    };
    let values = values(property);
    let crosswise = [1, 2, 4, 5].iter().any(|at| values[*at] != 0.0);
    let needs_more = card.axes == BushAxes::Line && crosswise;
    let Some(axes) = axes.filter(|_| !needs_more) else {
        let message = format!("{user}: the axes of its stiffnesses are not determined");
        let help = "give a coordinate system in field CID (0 is the basic one), or an orientation vector";
        return Err(InputError::at(&card.span, message).with_help(help));
    };
    if let Some(value) = values.iter().find(|value| !(**value >= 0.0 && value.is_finite())) {
        let message = format!("PBUSH {} has the stiffness or damping {value}", property.id);
        return Err(InputError::at(&property.span, message).with_help("it is zero or positive"));
    }
    Ok((BushPlace { ends: (end_a, end_b), point, axes, mass_at_b }, property))
}

impl ElementCard for Cbush {
    fn element(&self, builder: &mut Builder) -> Result<Arc<dyn Element>, InputError> {
        let (place, property) = bush(self, builder, |property| property.stiffness)?;
        Ok(Arc::new(place.element(self.id, &builder.nodes, property)))
    }

    fn property(&self) -> Option<u32> {
        Some(self.property)
    }

    fn cell(&self) -> Option<(CellShape, Vec<u32>)> {
        self.grids.1.map(|end| (CellShape::Line, vec![self.grids.0, end]))
    }

    /// By direction.
    fn structural_damping(&self, builder: &mut Builder) -> Result<Option<OverMotions>, InputError> {
        let Some(factors) = builder.bulk.loss_factors.bushes.get(&self.property) else { return Ok(None) };
        let (place, property) = bush(self, builder, |property| property.stiffness)?;
        let damped = std::array::from_fn(|axis| factors[axis] * property.stiffness[axis]);
        Ok(Some(springs::bush(&builder.nodes, &place, &damped)))
    }
}

impl DamperCard for Cbush {
    fn damper(&self, builder: &Builder) -> Result<Option<Damper>, InputError> {
        // Missing properties are said where the element is made.
        let damping = builder.bulk.bush_properties.get(&self.property).map(|property| property.damping);
        if damping.is_none_or(|damping| damping == [0.0; 6]) {
            return Ok(None);
        }
        let (place, property) = bush(self, builder, |property| property.damping)?;
        let (dofs, matrix) = springs::bush(&builder.nodes, &place, &property.damping);
        Ok(Some(Damper::new(format!("B of CBUSH {}", self.id), &self.span, dofs, matrix)))
    }
}

/// Ends, axis and property of a spring along one axis.
struct LineBush<'a> {
    ends: (usize, Option<usize>),
    axis: Vector3<f64>,
    property: &'a Pbush1d,
}

fn line_bush<'a>(card: &Cbush1d, builder: &Builder<'a>) -> Result<LineBush<'a>, InputError> {
    let user = format!("CBUSH1D {}", card.id);
    let a = builder.node(card.grids.0, &user, &card.span)?;
    let b = card.grids.1.map(|grid| builder.node(grid, &user, &card.span)).transpose()?;
    let properties = &builder.bulk.line_bush_properties;
    let property = found(properties, card.property, &user, "PBUSH1D", &card.span)?;
    let start = builder.nodes[a].point;
    let axis = match card.system {
        Some(system) => {
            Some(builder.frames.axes_at_point(system, &start, &card.span)?.column(0).into_owned())
        }
        None => b.and_then(|b| {
            let end = builder.nodes[b].point;
            (end - start).try_normalize(1e-12 * (start.coords.norm() + end.coords.norm()))
        }),
    };
    let axis = axis.ok_or_else(|| {
        let message = format!("{user}: both ends are at one place, and no coordinate system gives its axis");
        InputError::at(&card.span, message).with_help("give CID: the x axis of that system is the element's")
    })?;
    Ok(LineBush { ends: (a, b), axis, property })
}

impl ElementCard for Cbush1d {
    fn element(&self, builder: &mut Builder) -> Result<Arc<dyn Element>, InputError> {
        let LineBush { ends, axis, property } = line_bush(self, builder)?;
        let (dofs, k) = springs::along(ends, &axis, property.stiffness);
        let mass = DMatrix::from_diagonal(&DVector::from_element(dofs.len(), 0.5 * property.mass));
        let element = if property.mass > 0.0 {
            MatrixElement::new(self.id, &dofs, &k, &mass)
        } else {
            MatrixElement::spring(self.id, &dofs, &k)
        };
        let turning = match (&property.nonlinear, self.system) {
            (Some(word), _) => Corotation::Refused(format!(
                "CBUSH1D {}: {word} of PBUSH1D {} makes it nonlinear, which is not computed",
                self.id, property.id
            )),
            (None, Some(_)) => Corotation::Axes,
            (None, None) => Corotation::Fit,
        };
        Ok(Arc::new(element.turning(turning)))
    }

    fn property(&self) -> Option<u32> {
        Some(self.property)
    }

    fn cell(&self) -> Option<(CellShape, Vec<u32>)> {
        self.grids.1.map(|end| (CellShape::Line, vec![self.grids.0, end]))
    }
}

impl DamperCard for Cbush1d {
    fn damper(&self, builder: &Builder) -> Result<Option<Damper>, InputError> {
        let LineBush { ends, axis, property } = line_bush(self, builder)?;
        if property.damping == 0.0 {
            return Ok(None);
        }
        let (dofs, matrix) = springs::along(ends, &axis, property.damping);
        Ok(Some(Damper::new(format!("C of CBUSH1D {}", self.id), &self.span, dofs, matrix)))
    }
}

impl DamperCard for Cvisc {
    fn damper(&self, builder: &Builder) -> Result<Option<Damper>, InputError> {
        let user = format!("CVISC {}", self.id);
        let ends = builder.ends(self.grids, &user, &self.span)?;
        let properties = &builder.bulk.damper_properties;
        let property = found(properties, self.property, &user, "PVISC", &self.span)?;
        let values = [property.stretch, property.twist];
        let (dofs, matrix) = springs::line(&builder.nodes, ends, values, &user, &self.span)?;
        Ok(Some(Damper::new(user, &self.span, dofs, matrix)))
    }
}

/// The matrix of a scalar element, and the name of its card and number.
fn scalar(card: &ScalarElement, builder: &Builder) -> Result<(String, Vec<usize>, DMatrix<f64>), InputError> {
    let bulk = builder.bulk;
    let (name, kind, properties) = match card.kind {
        ScalarKind::Spring => ("CELAS", "PELAS", &bulk.spring_properties),
        ScalarKind::Mass => ("CMASS", "PMASS", &bulk.mass_properties),
        ScalarKind::Damper => ("CDAMP", "PDAMP", &bulk.damping_properties),
    };
    let user = format!("{name} {}", card.id);
    let value = match card.value {
        ScalarValue::Given(value) => value,
        ScalarValue::Property(id) => found(properties, id, &user, kind, &card.span)?.value,
    };
    let mut ends = [None; 2];
    for (end, given) in ends.iter_mut().zip(card.ends) {
        if let Some(motion) = given {
            *end = builder.motions(&[motion], &user, &card.span)?.first().copied();
        }
    }
    let (dofs, matrix) = springs::scalar(&builder.nodes, ends, value);
    Ok((user, dofs, matrix))
}

impl ElementCard for ScalarElement {
    fn element(&self, builder: &mut Builder) -> Result<Arc<dyn Element>, InputError> {
        let (_, dofs, matrix) = scalar(self, builder)?;
        let make = if self.kind == ScalarKind::Mass { MatrixElement::mass } else { MatrixElement::spring };
        Ok(Arc::new(make(self.id, &dofs, &matrix).turning(Corotation::Axes)))
    }

    /// Only springs are drawn.
    fn cell(&self) -> Option<(CellShape, Vec<u32>)> {
        match self.ends {
            [Some(a), Some(b)] if self.kind == ScalarKind::Spring => Some((CellShape::Line, vec![a.0, b.0])),
            _ => None,
        }
    }

    fn loss_factor(&self, bulk: &BulkData) -> f64 {
        let factors = &bulk.loss_factors;
        let own = match self.value {
            ScalarValue::Given(_) => factors.springs.get(&self.id),
            ScalarValue::Property(property) => factors.spring_properties.get(&property),
        };
        own.filter(|_| self.kind == ScalarKind::Spring).copied().unwrap_or(0.0)
    }
}

impl DamperCard for ScalarElement {
    fn damper(&self, builder: &Builder) -> Result<Option<Damper>, InputError> {
        let (user, dofs, matrix) = scalar(self, builder)?;
        Ok(Some(Damper::new(user, &self.span, dofs, matrix)))
    }
}
