//! What is predicted with an interval: loads along the span, the tip, and what controls do.

use coupling::ElasticWing;
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

/// Quantities of a case, and their rows on the box loads (all but the tip's, which is the last).
pub(super) fn quantities(wing: &ElasticWing) -> (Vec<Quantity>, Mat<f64>) {
    let boxes = &wing.correctable;
    let (mut listed, mut rows): (Vec<Quantity>, Vec<Vec<f64>>) = (Vec::new(), Vec::new());
    let root = |row: usize, k: usize| wing.root_rows[(row, k)];
    let all_ends = all_ends_m(wing);
    let strips = boxes.strip.iter().copied().max().map_or(0, |last| last + 1);
    for strip in 0..strips {
        let mut row = vec![0.0; wing.root_rows.ncols()];
        let mut y_norm = 0.0;
        for b in (0..boxes.len()).filter(|&b| boxes.strip[b] == strip) {
            let width_m = all_ends[b][1] - all_ends[b][0];
            for k in [2 * boxes.places[b], 2 * boxes.places[b] + 1] {
                row[k] = root(0, k) / width_m;
            }
            y_norm = boxes.y_norm[b];
        }
        listed.push(Quantity::StripLift { y_norm });
        rows.push(row);
    }
    for y_norm in SECTIONS {
        listed.extend([Quantity::Shear { y_norm }, Quantity::Bending { y_norm }]);
        let of_section = section_rows(wing, y_norm);
        rows.extend(of_section.iter().map(|row| (0..row.ncols()).map(|k| row[(0, k)]).collect()));
    }
    listed.push(Quantity::TipHeight);
    (listed, Mat::from_fn(rows.len(), wing.root_rows.ncols(), |r, k| rows[r][k]))
}

/// Rows of the air load outboard of a section and of its bending moment about it.
pub(super) fn section_rows(wing: &ElasticWing, y_norm: f64) -> [Mat<f64>; 2] {
    let boxes = &wing.correctable;
    let root = |row: usize, k: usize| wing.root_rows[(row, k)];
    let all_ends = all_ends_m(wing);
    let from_m = all_ends.iter().map(|ends| ends[0]).fold(f64::INFINITY, f64::min);
    let to_m = all_ends.iter().map(|ends| ends[1]).fold(f64::NEG_INFINITY, f64::max);
    let y_m = from_m + y_norm * (to_m - from_m);
    let mut rows = [0; 2].map(|_| Mat::zeros(1, wing.root_rows.ncols()));
    for (b, &place) in boxes.places.iter().enumerate() {
        // a strip that the section cuts counts by its share outboard of it, at that share's middle
        let [inner, outer] = all_ends[b];
        let share = ((outer - y_m) / (outer - inner)).clamp(0.0, 1.0);
        let arm_m = y_m - wing.balance.point.y - 0.5 * (1.0 - share) * (outer - inner);
        for k in [2 * place, 2 * place + 1] {
            rows[0][(0, k)] = share * root(0, k);
            rows[1][(0, k)] = share * (root(1, k) - arm_m * root(0, k));
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
