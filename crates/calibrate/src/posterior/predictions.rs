//! What is predicted with an interval: loads along the span, the tip, and what controls do.

use coupling::{ElasticWing, station_rows, strip_rows};
use faer::Mat;

/// Places of sections along the span, as shares of it.
const SECTIONS: [f64; 4] = [0.0, 0.25, 0.5, 0.75];

/// What is predicted.
#[derive(Debug, Clone, PartialEq)]
pub enum Quantity {
    /// Lift per span at a strip, N/m.
    StripLift {
        /// Middle of the strip, distance from the root over the span.
        y_norm: f64,
    },
    /// Air load outboard of a section, N.
    Shear {
        /// Place of the section.
        y_norm: f64,
    },
    /// Its bending moment about the section, tip up positive, N m.
    Bending {
        /// Place of the section.
        y_norm: f64,
    },
    /// Height of the tip above its wind-off place at alpha = 0, m.
    TipHeight,
    /// Bending moment at the root per degree of a control, N m/deg.
    ControlMx {
        /// Name of the control.
        control: String,
    },
}

/// What is predicted of a wing: strips, sections, tip, controls.
pub(super) fn quantities(wing: &ElasticWing) -> Vec<Quantity> {
    let boxes = &wing.correctable;
    let mut strips: Vec<(usize, f64)> =
        boxes.strip.iter().copied().zip(boxes.y_norm.iter().copied()).collect();
    strips.sort_by_key(|strip| strip.0);
    strips.dedup_by_key(|strip| strip.0);
    let strips = strips.into_iter().map(|(_, y_norm)| Quantity::StripLift { y_norm });
    let sections =
        SECTIONS.iter().flat_map(|&y_norm| [Quantity::Shear { y_norm }, Quantity::Bending { y_norm }]);
    let controls = wing.control_names().into_iter().map(|control| Quantity::ControlMx { control });
    strips.chain(sections).chain([Quantity::TipHeight]).chain(controls).collect()
}

/// Row on the box loads that a quantity is read by; the tip's is empty, as its height is no load.
pub(super) fn row_of(wing: &ElasticWing, quantity: &Quantity) -> Vec<f64> {
    let row = |rows: &Mat<f64>, row: usize| (0..rows.ncols()).map(|k| rows[(row, k)]).collect();
    let empty = || vec![0.0; wing.root_rows.ncols()];
    let section = |y_norm: f64| {
        let mut point = wing.balance.point;
        point.y = wing.correctable.ends_m[0] + y_norm * wing.correctable.span_m();
        station_rows(&wing.lattice, &wing.balance, &point)
    };
    match quantity {
        Quantity::StripLift { y_norm } => {
            let strip = wing.correctable.y_norm.iter().position(|y| y == y_norm);
            let rows = || strip_rows(&wing.lattice, &wing.correctable);
            strip.map_or_else(empty, |b| row(&rows(), wing.correctable.strip[b]))
        }
        Quantity::Shear { y_norm } => row(&section(*y_norm), 0),
        Quantity::Bending { y_norm } => row(&section(*y_norm), 1),
        Quantity::TipHeight => empty(),
        Quantity::ControlMx { .. } => row(&wing.root_rows, 1),
    }
}
