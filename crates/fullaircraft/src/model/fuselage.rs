//! The fuselage as cards: a tube along x, and a cruciform of boxes interrupted where the wing is.

use crate::aircraft::file::Fuselage;
use crate::model::beam;
use nalgebra::{Point3, Vector3};
use nastran::{BulkData, Caero1, Divisions, Dmi, Paero1, Span, Step};

/// Distance of grids aimed at, m.
const PITCH_M: f64 = 0.1;
/// Strips of an arm.
const STRIPS: u32 = 2;

/// Places of the grids from nose to tail; the one nearest to the wing's root is moved to it.
pub(crate) fn stations(fuselage: &Fuselage, root_x_m: f64) -> Vec<f64> {
    let (nose, end) = fuselage.x_m;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to a small count")]
    let elements = ((end - nose) / PITCH_M).round().clamp(4.0, 500.0) as usize;
    let mut x_m: Vec<f64> =
        (0..=elements).map(|node| nose + (end - nose) * node as f64 / elements as f64).collect();
    if let Some(nearest) =
        x_m.iter_mut().min_by(|a, b| (**a - root_x_m).abs().total_cmp(&(**b - root_x_m).abs()))
    {
        *nearest = root_x_m;
    }
    x_m
}

/// The tube through `stations`, and the four panels (horizontal and vertical arm, ahead of and behind the gap).
pub(crate) fn cards(
    fuselage: &Fuselage,
    x_m: &[f64],
    half_width_m: f64,
    first: Step,
    span: &Span,
) -> BulkData {
    let mut bulk = BulkData::default();
    let points: Vec<Point3<f64>> = x_m.iter().map(|x| Point3::new(*x, 0.0, 0.0)).collect();
    beam::add(&mut bulk, first.cards, &points, &fuselage.beam, &Vector3::z(), span);
    bulk.panel_properties.insert(first.cards, Paero1 { id: first.cards, span: span.clone() });
    let ((nose, end), (gap, behind)) = (fuselage.x_m, fuselage.gap_x_m);
    let arms = [[0.0, half_width_m, 0.0], [0.0, 0.0, 0.5 * fuselage.height_m]];
    let parts = [(nose, gap, fuselage.boxes.ahead), (behind, end, fuselage.boxes.behind)];
    let mut id = first.boxes;
    for [_, y, z] in arms {
        for (from, to, boxes) in parts {
            let panel = Caero1 {
                id,
                property: first.cards,
                cp: 0,
                span_divisions: Divisions::Equal(STRIPS),
                chord_divisions: Divisions::Equal(boxes),
                group: 1,
                point_1: Point3::new(from, 0.0 - y, 0.0 - z),
                chord_1: to - from,
                point_4: Point3::new(from, y, z),
                chord_4: to - from,
                span: span.clone(),
            };
            bulk.panels.insert(id, panel);
            id += STRIPS * boxes;
        }
    }
    let boxes = (id - first.boxes) as usize;
    bulk.matrices.insert("W2GJ".to_owned(), Dmi::column_vector("W2GJ", vec![0.0; boxes]));
    bulk
}
