//! Panels, control surfaces, splines and monitoring stations as cards.

use crate::cards::{BulkData, Caero1, Divisions, MonitorPoint};
use crate::fe_cards::{SplineCard, SplineKind};
use crate::write::fields::{Fields, Value};

/// Panels, control surfaces, splines and monitoring stations.
pub(super) fn aerodynamics(deck: &BulkData, text: &mut String) {
    deck.panels.values().for_each(|panel| text.push_str(&self::panel(panel)));
    for id in deck.panel_properties.keys() {
        text.push_str(&Fields::new("PAERO1").int(*id).write());
    }
    for list in deck.factors.values() {
        text.push_str(&Fields::new("AEFACT").int(list.id).reals(&list.values).write());
    }
    for surface in deck.surfaces.values() {
        let mut card = Fields::new("AESURF").int(surface.id).push(Value::Text(surface.label.clone()));
        card = surface.parts.iter().take(2).fold(card, |card, part| card.ints([part.0, part.1]));
        card = card.blanks(4 - 2 * surface.parts.len().min(2));
        text.push_str(&card.real(surface.effectiveness).write());
    }
    for list in deck.box_lists.values() {
        text.push_str(&Fields::new("AELIST").int(list.id).ints(list.boxes.iter().copied()).write());
    }
    deck.splines.values().for_each(|spline| text.push_str(&self::spline(spline)));
    deck.monitors.iter().for_each(|monitor| text.push_str(&self::monitor(monitor)));
}

fn panel(panel: &Caero1) -> String {
    let number = |divisions| match divisions {
        Divisions::Equal(number) => (Value::Int(number), Value::Blank),
        Divisions::Aefact(id) => (Value::Blank, Value::Int(id)),
    };
    let (nspan, lspan) = number(panel.span_divisions);
    let (nchord, lchord) = number(panel.chord_divisions);
    let card = Fields::new("CAERO1").ints([panel.id, panel.property, panel.cp]);
    let card = card.push(nspan).push(nchord).push(lspan).push(lchord).int(panel.group);
    card.reals(&panel.point_1).real(panel.chord_1).reals(&panel.point_4).real(panel.chord_4).write()
}

/// The label runs over seven fields of 8 columns, so the first line is a small one in any case.
fn monitor(monitor: &MonitorPoint) -> String {
    let name = if monitor.is_structural { "MONPNT3" } else { "MONPNT1" };
    let card = Fields::new("").push(Value::digits(&monitor.axes)).push(Value::Text(monitor.set.clone()));
    let card = if monitor.is_structural { card.push(Value::Blank) } else { card };
    let card = card.int(monitor.cp).reals(&monitor.xyz);
    let card = if monitor.is_structural { card.push(Value::Blank) } else { card };
    let rest = card.int(monitor.cd).continuation();
    format!("{name:<8}{:<8}{}\n{rest}", monitor.name, monitor.label)
}

fn spline(spline: &SplineCard) -> String {
    let name = match (spline.kind == SplineKind::Plate, spline.list.is_some()) {
        (true, false) => "SPLINE1",
        (false, false) => "SPLINE2",
        (true, true) => "SPLINE4",
        (false, true) => "SPLINE5",
    };
    let card = Fields::new(name).ints([spline.id, spline.panel]);
    let card = match spline.list {
        Some(list) => card.int(list).push(Value::Blank).int(spline.set),
        None => card.ints([spline.boxes.0, spline.boxes.1, spline.set]),
    };
    match spline.kind {
        SplineKind::Plate => card.real(0.0).write(),
        SplineKind::Beam { system, torsional_ratio, attachment } => {
            let card = card.real(0.0).real(torsional_ratio).int(system);
            if attachment == [0.0; 2] {
                card.write()
            } else {
                card.real(attachment[0]).real(attachment[1]).write()
            }
        }
    }
}
