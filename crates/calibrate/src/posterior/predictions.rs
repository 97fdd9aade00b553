//! What is predicted with an interval: loads along the span, the tip, and what controls do.

use coupling::ElasticWing;

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
    match quantity {
        Quantity::StripLift { y_norm } => strip_row(wing, *y_norm),
        Quantity::Shear { y_norm } => section_rows(wing, *y_norm)[0].clone(),
        Quantity::Bending { y_norm } => section_rows(wing, *y_norm)[1].clone(),
        Quantity::TipHeight => vec![0.0; wing.root_rows.ncols()],
        Quantity::ControlMx { .. } => (0..wing.root_rows.ncols()).map(|k| wing.root_rows[(1, k)]).collect(),
    }
}

/// Row of the lift per span of the strip with its middle at a place.
fn strip_row(wing: &ElasticWing, y_norm: f64) -> Vec<f64> {
    let boxes = &wing.correctable;
    let mut row = vec![0.0; wing.root_rows.ncols()];
    for (b, ends_m) in all_ends_m(wing).into_iter().enumerate().filter(|(b, _)| boxes.y_norm[*b] == y_norm) {
        for k in [2 * boxes.places[b], 2 * boxes.places[b] + 1] {
            row[k] = wing.root_rows[(0, k)] / (ends_m[1] - ends_m[0]);
        }
    }
    row
}

/// Rows of the air load outboard of a section and of its bending moment about it.
fn section_rows(wing: &ElasticWing, y_norm: f64) -> [Vec<f64>; 2] {
    let boxes = &wing.correctable;
    let root = |row: usize, k: usize| wing.root_rows[(row, k)];
    let all_ends = all_ends_m(wing);
    let from_m = all_ends.iter().map(|ends| ends[0]).fold(f64::INFINITY, f64::min);
    let to_m = all_ends.iter().map(|ends| ends[1]).fold(f64::NEG_INFINITY, f64::max);
    let y_m = from_m + y_norm * (to_m - from_m);
    let mut rows = [0; 2].map(|_| vec![0.0; wing.root_rows.ncols()]);
    for (b, &place) in boxes.places.iter().enumerate() {
        // a strip that the section cuts counts by its share outboard of it, at that share's middle
        let [inner, outer] = all_ends[b];
        let share = ((outer - y_m) / (outer - inner)).clamp(0.0, 1.0);
        let arm_m = y_m - wing.balance.point.y - 0.5 * (1.0 - share) * (outer - inner);
        for k in [2 * place, 2 * place + 1] {
            rows[0][k] = share * root(0, k);
            rows[1][k] = share * (root(1, k) - arm_m * root(0, k));
        }
    }
    rows
}

/// Ends of each correctable box along y, m.
fn all_ends_m(wing: &ElasticWing) -> Vec<[f64; 2]> {
    let ends = |&place: &usize| {
        let y = wing.lattice.boxes[place].corners.map(|corner| corner.y);
        y.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], y| [a.min(*y), b.max(*y)])
    };
    wing.correctable.places.iter().map(ends).collect()
}
