//! Control surfaces: AESURF with its AELIST of boxes and the CORD2R whose y axis is the hinge.

use super::panels::card_number;
use super::{Control, Planform, WING_PANEL};
use nalgebra::Vector3;
use nastran::{Aelist, Aesurf, BulkData, Coord, CoordDefinition, CoordKind, Span};

/// The first surface's number; AESURF, AELIST and CORD2R of a surface share theirs.
const FIRST_CONTROL: u32 = 501;

impl Planform {
    pub(super) fn add_controls(&self, bulk: &mut BulkData, span: &Span) {
        for (id, control) in (FIRST_CONTROL..).zip(&self.controls) {
            bulk.coords.insert(
                id,
                Coord {
                    id,
                    kind: CoordKind::Rectangular,
                    definition: self.hinge(control),
                    span: span.clone(),
                },
            );
            bulk.box_lists.insert(id, Aelist { id, boxes: self.control_boxes(control), span: span.clone() });
            let label = control.name.clone();
            let surface = Aesurf { id, label, parts: vec![(id, id)], effectiveness: 1.0, span: span.clone() };
            bulk.surfaces.insert(id, surface);
        }
    }

    /// The hinge line runs along box edges, y axis toward the tip, z axis up: a positive rotation is trailing
    /// edge down.
    fn hinge(&self, control: &Control) -> CoordDefinition {
        let edges_m = self.strip_edges_m();
        let hinge_x_over_c = 1.0 - control.chord_boxes as f64 / self.boxes.chordwise as f64;
        let inboard = self.point(edges_m[control.strips.0 - 1], hinge_x_over_c);
        let outboard = self.point(edges_m[control.strips.1], hinge_x_over_c);
        let y_axis = (outboard - inboard).normalize();
        let z_axis = (Vector3::z() - y_axis * y_axis.z).normalize();
        let x_axis = y_axis.cross(&z_axis);
        CoordDefinition::Points { rid: 0, a: inboard, b: inboard + z_axis, c: inboard + x_axis }
    }

    fn control_boxes(&self, control: &Control) -> Vec<u32> {
        let chordwise = self.boxes.chordwise;
        let rows = chordwise - control.chord_boxes..chordwise;
        (control.strips.0 - 1..control.strips.1)
            .flat_map(|strip| rows.clone().map(move |row| WING_PANEL + card_number(strip * chordwise + row)))
            .collect()
    }
}
