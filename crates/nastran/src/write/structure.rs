//! Coordinate systems, grids, beams, concentrated masses and supports as cards.

use crate::cards::{BeamElement, BeamProperty, BulkData, Coord, CoordDefinition, CoordKind, Orientation};
use crate::write::fields::{Fields, Value};

/// Systems, grids, beams, concentrated masses, RBE2, SPC1 and SET1.
pub(super) fn structure(deck: &BulkData, text: &mut String) {
    deck.coords.values().for_each(|coord| text.push_str(&self::coord(coord)));
    for grid in deck.grids.values() {
        let ps = Value::digits(&grid.ps);
        let card = Fields::new("GRID").ints([grid.id, grid.cp]).reals(&grid.xyz).int(grid.cd).push(ps);
        text.push_str(&card.write());
    }
    deck.beams.values().for_each(|beam| text.push_str(&beam_element(beam)));
    deck.beam_properties.values().for_each(|property| text.push_str(&beam_property(property)));
    for material in deck.materials.values() {
        let card =
            Fields::new("MAT1").int(material.id).reals(&[material.e, material.g, material.nu, material.rho]);
        text.push_str(&card.write());
    }
    for mass in deck.masses.values() {
        let card = Fields::new("CONM2").ints([mass.id, mass.grid]).push(Value::Text(mass.cid.to_string()));
        let card = card.real(mass.mass).reals(&mass.offset).push(Value::Blank).reals(&mass.inertia);
        text.push_str(&card.write());
    }
    for element in deck.rigid.values() {
        let card = Fields::new("RBE2").ints([element.id, element.independent]);
        let card = card.push(Value::digits(&element.components)).ints(element.dependent.iter().copied());
        text.push_str(&card.write());
    }
    for constraint in &deck.constraints {
        let card = Fields::new("SPC1").int(constraint.set).push(Value::digits(&constraint.components));
        text.push_str(&card.ints(constraint.grids.iter().copied()).write());
    }
    for set in deck.sets.values() {
        text.push_str(&Fields::new("SET1").int(set.id).ints(set.ids.iter().copied()).write());
    }
}

fn coord(coord: &Coord) -> String {
    let [by_points, by_grids] = match coord.kind {
        CoordKind::Rectangular => ["CORD2R", "CORD1R"],
        CoordKind::Cylindrical => ["CORD2C", "CORD1C"],
        CoordKind::Spherical => ["CORD2S", "CORD1S"],
    };
    match &coord.definition {
        CoordDefinition::Points { rid, a, b, c } => {
            Fields::new(by_points).ints([coord.id, *rid]).reals(a).reals(b).reals(c).write()
        }
        CoordDefinition::Grids(grids) => Fields::new(by_grids).int(coord.id).ints(*grids).write(),
    }
}

fn beam_element(beam: &BeamElement) -> String {
    let name = if beam.is_beam { "CBEAM" } else { "CBAR" };
    let card = Fields::new(name).ints([beam.id, beam.property]).ints(beam.grids);
    let card = match &beam.orientation {
        Orientation::Vector(vector) => card.reals(vector),
        Orientation::Grid(grid) => card.int(*grid).push(Value::Blank).push(Value::Blank),
    };
    let card = card.push(Value::Blank).push(Value::digits(&beam.pins[0])).push(Value::digits(&beam.pins[1]));
    let [a, b] = &beam.offsets;
    if beam.offsets == [[0.0; 3]; 2] { card.write() } else { card.reals(a).reals(b).write() }
}

fn beam_property(property: &BeamProperty) -> String {
    let Some(first) = property.stations.first() else { return String::new() };
    let card =
        Fields::new(if property.is_beam { "PBEAM" } else { "PBAR" }).ints([property.id, property.material]);
    if !property.is_beam {
        let card = card.reals(&[first.area, first.i1, first.i2, first.j, first.nsm]);
        let card = (0..9).fold(card, |card, _| card.push(Value::Blank));
        return card.reals(&property.shear_factors).real(first.i12).write();
    }
    let mut card = card.reals(&[first.area, first.i1, first.i2, first.i12, first.j, first.nsm]);
    for station in &property.stations[1..] {
        card = card.push(Value::Text("NO".into())).real(station.x_over_l);
        card = card.reals(&[station.area, station.i1, station.i2, station.i12, station.j, station.nsm]);
    }
    if property.stations.len() == 1 {
        // A uniform beam: the line of stress points keeps the places of what follows.
        card = (0..8).fold(card, |card, _| card.real(0.0));
    }
    let card = card.reals(&property.shear_factors).reals(&[0.0, 0.0]).reals(&property.nsi).reals(&[0.0, 0.0]);
    let [m, n] = [&property.nsm_offset, &property.neutral_axis];
    card.reals(m.as_flattened()).reals(n.as_flattened()).write()
}
