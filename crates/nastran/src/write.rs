//! Decks out: the cards of a [`BulkData`] as a bulk data section.
//!
//! A card is written in 8-character fields if they hold its numbers exactly, and in 16-character fields
//! otherwise. These hold 15 digits of a positive number and 14 of a negative one as long as it needs no
//! exponent; the relative rounding error is at most 1e-11 for magnitudes from 1e-9 to 1e9 and 1e-9 for all
//! others. What is read from a written deck is written again in the same way, without any loss.
//!
//! DMI matrices are written by [`Dmi::write`](crate::Dmi::write), in 8-character fields.

use crate::cards::{
    BeamElement, BeamProperty, BulkData, Caero1, Coord, CoordDefinition, CoordKind, Divisions, MonitorPoint,
    Orientation,
};
use crate::real;
use std::fmt::Write as _;

/// The bulk data section with all cards of `deck`, from a comment on what cannot be written to `ENDDATA`.
///
/// Lists are written in full, without `THRU`. Cards that were not read ([`BulkData::unknown`]) cannot be
/// written; a comment says how many there were.
pub fn write_deck(deck: &BulkData) -> String {
    let mut text = String::new();
    for (name, count) in &deck.unknown {
        let _ = writeln!(text, "$ not written because not read: {count} {name}");
    }
    text.push_str("BEGIN BULK\n");
    structure(deck, &mut text);
    aerodynamics(deck, &mut text);
    for matrix in deck.matrices.values() {
        text.push_str(&matrix.write());
    }
    text.push_str("ENDDATA\n");
    text
}

fn structure(deck: &BulkData, text: &mut String) {
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

fn aerodynamics(deck: &BulkData, text: &mut String) {
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
        while card.values.len() < 6 {
            card = card.push(Value::Blank);
        }
        text.push_str(&card.real(surface.effectiveness).write());
    }
    for list in deck.box_lists.values() {
        text.push_str(&Fields::new("AELIST").int(list.id).ints(list.boxes.iter().copied()).write());
    }
    deck.monitors.iter().for_each(|monitor| text.push_str(&self::monitor(monitor)));
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

enum Value {
    Blank,
    Int(u32),
    Real(f64),
    Text(String),
}

impl Value {
    fn digits(digits: &[u8]) -> Self {
        if digits.is_empty() { Self::Blank } else { Self::Text(digits.iter().map(u8::to_string).collect()) }
    }

    fn text(&self, width: usize) -> String {
        match self {
            Self::Blank => String::new(),
            Self::Int(number) => number.to_string(),
            Self::Real(number) => real::format(*number, width),
            Self::Text(text) => text.clone(),
        }
    }

    fn fits_small(&self) -> bool {
        match self {
            Self::Real(number) => real::parse(&real::format(*number, 8)) == Some(*number),
            other => other.text(8).len() <= 8,
        }
    }
}

/// A card being written.
struct Fields {
    name: &'static str,
    values: Vec<Value>,
}

impl Fields {
    fn new(name: &'static str) -> Self {
        Self { name, values: Vec::new() }
    }

    fn push(mut self, value: Value) -> Self {
        self.values.push(value);
        self
    }

    fn int(self, number: u32) -> Self {
        self.push(Value::Int(number))
    }

    fn ints(self, numbers: impl IntoIterator<Item = u32>) -> Self {
        numbers.into_iter().fold(self, Self::int)
    }

    fn real(self, number: f64) -> Self {
        self.push(Value::Real(number))
    }

    fn reals(self, numbers: &[f64]) -> Self {
        numbers.iter().fold(self, |card, number| card.real(*number))
    }

    fn write(&self) -> String {
        self.lines(self.name)
    }

    /// The lines without a card's name, to be put after another line.
    fn continuation(&self) -> String {
        self.lines("")
    }

    fn lines(&self, name: &str) -> String {
        let is_small = self.values.iter().all(Value::fits_small);
        let (width, per_line) = if is_small { (8, 8) } else { (16, 4) };
        let mut text = String::new();
        // Large lines come in pairs.
        let count = if is_small { self.values.len() } else { self.values.len().next_multiple_of(8) };
        for start in (0..count).step_by(per_line) {
            let head = match (start == 0 && !name.is_empty(), is_small) {
                (true, true) => name.to_owned(),
                (true, false) => format!("{name}*"),
                (false, true) => "+".to_owned(),
                (false, false) => "*".to_owned(),
            };
            let fields = self.values.iter().skip(start).take(per_line);
            let line = fields
                .fold(format!("{head:<8}"), |line, value| format!("{line}{:>width$}", value.text(width)));
            text.push_str(line.trim_end());
            text.push('\n');
        }
        text
    }
}
