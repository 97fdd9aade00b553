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
    let ends_m = |place: usize| {
        let y = wing.lattice.boxes[place].corners.map(|corner| corner.y);
        [y.iter().copied().fold(f64::INFINITY, f64::min), y.iter().copied().fold(f64::NEG_INFINITY, f64::max)]
    };
    let (mut listed, mut rows): (Vec<Quantity>, Vec<Vec<f64>>) = (Vec::new(), Vec::new());
    let root = |row: usize, k: usize| wing.root_rows[(row, k)];
    let all_ends: Vec<[f64; 2]> = boxes.places.iter().map(|&place| ends_m(place)).collect();
    let from_m = all_ends.iter().map(|ends| ends[0]).fold(f64::INFINITY, f64::min);
    let to_m = all_ends.iter().map(|ends| ends[1]).fold(f64::NEG_INFINITY, f64::max);
    let strips = boxes.strip.iter().copied().max().map_or(0, |last| last + 1);
    for strip in 0..strips {
        let mut row = vec![0.0; wing.root_rows.ncols()];
        let mut y_norm = 0.0;
        for b in (0..boxes.len()).filter(|&b| boxes.strip[b] == strip) {
            let width_m = all_ends[b][1] - all_ends[b][0];
            [0, 1]
                .iter()
                .for_each(|i| row[2 * boxes.places[b] + i] = root(0, 2 * boxes.places[b] + i) / width_m);
            y_norm = boxes.y_norm[b];
        }
        listed.push(Quantity::StripLift { y_norm });
        rows.push(row);
    }
    for y_norm in SECTIONS {
        let y_m = from_m + y_norm * (to_m - from_m);
        let (mut shear, mut bending) = (vec![0.0; wing.root_rows.ncols()], vec![0.0; wing.root_rows.ncols()]);
        for (b, &place) in boxes.places.iter().enumerate() {
            // a strip that the section cuts counts by its share outboard of it
            let [inner, outer] = all_ends[b];
            let share = ((outer - y_m) / (outer - inner)).clamp(0.0, 1.0);
            let arm_m = y_m - wing.balance.point.y
                + if share < 1.0 { 0.5 * (1.0 - share) * (inner - outer) } else { 0.0 };
            for k in [2 * place, 2 * place + 1] {
                shear[k] = share * root(0, k);
                bending[k] = share * (root(1, k) - arm_m * root(0, k));
            }
        }
        listed.extend([Quantity::Shear { y_norm }, Quantity::Bending { y_norm }]);
        rows.extend([shear, bending]);
    }
    listed.push(Quantity::TipHeight);
    (listed, Mat::from_fn(rows.len(), wing.root_rows.ncols(), |r, k| rows[r][k]))
}
