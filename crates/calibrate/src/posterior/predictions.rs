//! What is predicted with an interval: loads along the span, the tip, and what controls do.

use super::off::WingOff;
use super::prior::Unknowns;
use super::read::{CaseRead, read_case};
use crate::sensors::{Reading, Row, Together};
use coupling::{ElasticWing, SteadyCase, SteadyOperator};
use nastran::InputError;
use std::rc::Rc;

/// Places of sections along the span, as shares of it.
const SECTIONS: [f64; 4] = [0.0, 0.25, 0.5, 0.75];

/// The balance's channel that bending at the root is.
pub(super) const MX: usize = 1;

/// What is predicted.
#[derive(Debug, Clone, PartialEq)]
pub enum Quantity {
    /// What a sensor would read there.
    Reading(Reading),
    /// Height of the tip above its wind-off place at alpha = 0, m.
    TipHeight,
    /// Bending moment at the root per degree of a control, N m/deg.
    ControlMx {
        /// Name of the control.
        control: String,
    },
}

impl Quantity {
    /// Whether it is of the wing with its controls at rest, more than a strip: a section's load, or the tip.
    pub(super) fn is_of_the_whole_wing(&self) -> bool {
        match self {
            Self::Reading(reading) => !matches!(reading, Reading::StripLift { .. }),
            Self::TipHeight => true,
            Self::ControlMx { .. } => false,
        }
    }
}

/// What is predicted of a wing: strips, sections, tip, controls.
pub(super) fn quantities(wing: &ElasticWing) -> Vec<Quantity> {
    let boxes = &wing.correctable;
    let strips = (0..boxes.len())
        .filter(|&b| boxes.chord_row[b] == 0)
        .map(|b| Reading::StripLift { y_over_span: boxes.y_norm[b] });
    let sections = SECTIONS
        .iter()
        .flat_map(|&y_over_span| [Reading::Shear { y_over_span }, Reading::Bending { y_over_span }]);
    let controls = wing.control_names().into_iter().map(|control| Quantity::ControlMx { control });
    strips.chain(sections).map(Quantity::Reading).chain([Quantity::TipHeight]).chain(controls).collect()
}

fn row_of(wing: &ElasticWing, quantity: &Quantity) -> Row {
    match quantity {
        Quantity::Reading(reading) => reading.row(wing),
        Quantity::TipHeight => Row::OnStructure(wing.tip_row()),
        Quantity::ControlMx { .. } => Row::Balance(MX),
    }
}

/// A prediction: a reading of a case, less that of another case.
pub(super) struct Predicted {
    of: Rc<CaseRead>,
    less: Option<Rc<CaseRead>>,
    row: usize,
}

impl Predicted {
    pub(super) fn value(&self) -> f64 {
        self.of.values[self.row] - self.less.as_ref().map_or(0.0, |less| less.values[self.row])
    }

    /// Its derivatives by the unknowns.
    pub(super) fn gradient(&self, unknowns: &Unknowns) -> Vec<f64> {
        let mut gradient = unknowns.gradient(&self.of, self.row);
        if let Some(less) = &self.less {
            for (value, less) in gradient.iter_mut().zip(unknowns.gradient(less, self.row)) {
                *value -= less;
            }
        }
        gradient
    }
}

/// Predicts quantities in a case; what a control does is the case with it by a degree less the case without it.
pub(super) fn predict(
    wing: &ElasticWing,
    operator: &SteadyOperator<'_>,
    off: &WingOff,
    case: &SteadyCase,
    quantities: &[Quantity],
) -> Result<Vec<Predicted>, InputError> {
    let together = Together::new(wing, quantities.iter().map(|quantity| row_of(wing, quantity)).collect());
    let held = Rc::new(read_case(operator, off, case, &together));
    let names = wing.control_names();
    let one = |(quantity, &row): (&Quantity, &usize)| {
        let Quantity::ControlMx { control } = quantity else {
            return Ok(Predicted { of: Rc::clone(&held), less: None, row });
        };
        let Some(index) = names.iter().position(|name| name == control) else {
            return Err(InputError::general(format!("the wing has no control surface {control}")));
        };
        let mut deflected = case.clone();
        deflected.controls_rad = vec![0.0; names.len()];
        deflected.controls_rad[index] = 1.0_f64.to_radians();
        let of = Rc::new(read_case(operator, off, &deflected, &together));
        Ok(Predicted { of, less: Some(Rc::clone(&held)), row })
    };
    quantities.iter().zip(&together.places).map(one).collect()
}
