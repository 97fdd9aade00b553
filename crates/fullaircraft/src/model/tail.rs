//! A tail surface as cards: beam along the quarter chord, panel with a hinge between boxes, control surface.

use crate::aircraft::file::TailSurface;
use crate::model::beam;
use nalgebra::{Point3, Vector3};
use nastran::{
    Aefact, Aelist, Aesurf, BulkData, Caero1, Coord, CoordDefinition, CoordKind, Divisions, Dmi, Paero1,
    Span, Step,
};

/// Beam elements of a tail surface.
const ELEMENTS: u32 = 4;

/// A tail surface from its root along `outward` (+y or +z), cards numbered from `first`; no camber. Its root grid is
/// number `first.cards`, its grids follow from root to tip.
pub(crate) fn cards(tail: &TailSurface, outward: &Vector3<f64>, first: Step, span: &Span) -> BulkData {
    let mut bulk = BulkData::default();
    let normal = Vector3::x().cross(outward);
    let points: Vec<Point3<f64>> = (0..=ELEMENTS)
        .map(|node| point(tail, outward, f64::from(node) / f64::from(ELEMENTS), 0.25))
        .collect();
    beam::add(&mut bulk, first.cards, &points, &tail.beam, &normal, span);
    let id = first.cards;
    bulk.panel_properties.insert(id, Paero1 { id, span: span.clone() });
    bulk.factors.insert(id, Aefact { id, values: chord_divisions(tail), span: span.clone() });
    let corner = |eta: f64| point(tail, outward, eta, 0.0);
    let panel = Caero1 {
        id: first.boxes,
        property: id,
        cp: 0,
        span_divisions: Divisions::Equal(tail.boxes.spanwise),
        chord_divisions: Divisions::Aefact(id),
        group: 1,
        point_1: corner(0.0),
        chord_1: tail.root_chord_m,
        point_4: corner(1.0),
        chord_4: tail.tip_chord_m,
        span: span.clone(),
    };
    bulk.panels.insert(first.boxes, panel);
    let (rows, strips) = (tail.boxes.chordwise, tail.boxes.spanwise);
    bulk.matrices.insert("W2GJ".to_owned(), Dmi::column_vector("W2GJ", vec![0.0; (rows * strips) as usize]));

    let hinge = 1.0 - tail.control.chord_share;
    let (root, tip) = (point(tail, outward, 0.0, hinge), point(tail, outward, 1.0, hinge));
    let along = (tip - root).normalize();
    let definition =
        CoordDefinition::Points { rid: 0, a: root, b: root + normal, c: root + along.cross(&normal) };
    bulk.coords.insert(id, Coord { id, kind: CoordKind::Rectangular, definition, span: span.clone() });
    let moving = rows - tail.control.chord_boxes..rows;
    let boxes = (0..strips).flat_map(|strip| moving.clone().map(move |row| first.boxes + strip * rows + row));
    bulk.box_lists.insert(id, Aelist { id, boxes: boxes.collect(), span: span.clone() });
    let (label, parts) = (tail.control.name.clone(), vec![(id, id)]);
    bulk.surfaces.insert(id, Aesurf { id, label, parts, effectiveness: 1.0, span: span.clone() });
    bulk
}

/// The point at a share `eta` of the span and `x_over_c` of the chord.
fn point(tail: &TailSurface, outward: &Vector3<f64>, eta: f64, x_over_c: f64) -> Point3<f64> {
    let (x, y, z) = tail.root_leading_edge_m;
    let out_m = eta * tail.span_m;
    let chord_m = tail.root_chord_m + eta * (tail.tip_chord_m - tail.root_chord_m);
    let aft_m = out_m * tail.leading_edge_sweep_deg.to_radians().tan() + x_over_c * chord_m;
    Point3::new(x, y, z) + outward * out_m + Vector3::x() * aft_m
}

/// Equal boxes up to the hinge, equal ones behind it.
fn chord_divisions(tail: &TailSurface) -> Vec<f64> {
    let behind = tail.control.chord_boxes;
    let ahead = tail.boxes.chordwise - behind;
    let hinge = 1.0 - tail.control.chord_share;
    let part = |at: u32, of: u32| f64::from(at) / f64::from(of);
    let mut edges: Vec<f64> = (0..ahead).map(|row| hinge * part(row, ahead)).collect();
    edges.extend((0..behind).map(|row| hinge + tail.control.chord_share * part(row, behind)));
    edges.push(1.0);
    edges
}
