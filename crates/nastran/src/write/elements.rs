//! Shells, solids, rods, springs, masses, rigid elements and equations as cards.

use crate::cards::{BulkData, Orientation};
use crate::fe_cards::{
    BushAxes, Cbush, Genel, MaterialDirection, Mpc, Rbe3, ScalarElement, ScalarValue, ShellElement,
    SolidElement,
};
use crate::write::fields::Fields;

/// CQUAD4, CTRIA3, CHEXA, CPENTA, CTETRA, CROD, CBUSH, CELAS1, CELAS2, GENEL, CMASS1, CMASS2 and CONM1.
pub(super) fn elements(deck: &BulkData, text: &mut String) {
    deck.shells.values().for_each(|element| text.push_str(&shell(element)));
    deck.solids.values().for_each(|element| text.push_str(&solid(element)));
    for rod in deck.rods.values() {
        text.push_str(&Fields::new("CROD").ints([rod.id, rod.property]).ints(rod.grids).write());
    }
    deck.bushes.values().for_each(|element| text.push_str(&bush(element)));
    deck.springs.values().for_each(|element| text.push_str(&scalar(element, ["CELAS1", "CELAS2"])));
    deck.scalar_masses.values().for_each(|element| text.push_str(&scalar(element, ["CMASS1", "CMASS2"])));
    deck.general.values().for_each(|element| text.push_str(&general(element)));
    for mass in deck.mass_matrices.values() {
        let card = Fields::new("CONM1").ints([mass.id, mass.grid, mass.cid]);
        let card = mass.mass.iter().enumerate().fold(card, |card, (row, values)| card.reals(&values[..=row]));
        text.push_str(&card.write());
    }
}

/// RBAR, RBE3 and MPC.
pub(super) fn constraints(deck: &BulkData, text: &mut String) {
    for bar in deck.rigid_bars.values() {
        let card = Fields::new("RBAR").int(bar.id).ints(bar.grids);
        let card =
            bar.independent.iter().chain(&bar.dependent).fold(card, |card, digits| card.digits(digits));
        text.push_str(&card.write());
    }
    deck.averages.values().for_each(|element| text.push_str(&average(element)));
    deck.equations.iter().for_each(|equation| text.push_str(&self::equation(equation)));
}

fn shell(element: &ShellElement) -> String {
    let name = if element.grids.len() == 3 { "CTRIA3" } else { "CQUAD4" };
    let card = Fields::new(name).ints([element.id, element.property]).ints(element.grids.iter().copied());
    let card = match element.direction {
        MaterialDirection::AngleDeg(angle) => card.real(angle),
        MaterialDirection::System(system) => card.int(system),
    };
    card.real(element.offset).write()
}

fn solid(element: &SolidElement) -> String {
    let name = match element.grids.len() {
        4 => "CTETRA",
        6 => "CPENTA",
        _ => "CHEXA",
    };
    Fields::new(name).ints([element.id, element.property]).ints(element.grids.iter().copied()).write()
}

fn bush(element: &Cbush) -> String {
    let card =
        Fields::new("CBUSH").ints([element.id, element.property, element.grids.0]).optional(element.grids.1);
    let card = match &element.axes {
        BushAxes::System(system) => card.blanks(3).int(*system),
        BushAxes::Oriented(Orientation::Vector(vector)) => card.reals(vector).blanks(1),
        BushAxes::Oriented(Orientation::Grid(grid)) => card.int(*grid).blanks(3),
        BushAxes::Line => card.blanks(4),
    };
    let card = card.real(element.location);
    match &element.offset {
        Some((system, place)) => card.int(*system).reals(place).write(),
        None => card.write(),
    }
}

fn scalar(element: &ScalarElement, [with_property, with_value]: [&'static str; 2]) -> String {
    let card = match element.value {
        ScalarValue::Property(property) => Fields::new(with_property).ints([element.id, property]),
        ScalarValue::Given(value) => Fields::new(with_value).int(element.id).real(value),
    };
    card.motion(element.ends[0]).motion(element.ends[1]).write()
}

fn general(element: &Genel) -> String {
    let card = Fields::new("GENEL").int(element.id).blanks(1);
    let mut card = element.ui.iter().fold(card, |card, motion| card.motion(Some(*motion))).next_line();
    if !element.ud.is_empty() {
        card = card.text("UD").blanks(1);
        card = element.ud.iter().fold(card, |card, motion| card.motion(Some(*motion))).next_line();
    }
    card = card.text(if element.is_flexibility { "Z" } else { "K" });
    for (column, values) in element.matrix.iter().enumerate() {
        // The matrix is symmetric: the lower part of a column is the right part of the row.
        card = card.reals(values.get(column..).unwrap_or(&[]));
    }
    if !element.s.is_empty() {
        card = element.s.iter().fold(card.next_line().text("S"), |card, row| card.reals(row));
    }
    card.write()
}

fn average(element: &Rbe3) -> String {
    let card =
        Fields::new("RBE3").int(element.id).blanks(1).int(element.reference).digits(&element.components);
    let mut card = element.groups.iter().fold(card, |card, group| {
        card.real(group.weight).digits(&group.components).ints(group.grids.iter().copied())
    });
    for (line, motions) in element.um.chunks(3).enumerate() {
        card = card.next_line();
        card = if line == 0 { card.text("UM") } else { card.blanks(1) };
        card = motions.iter().fold(card, |card, (grid, components)| card.int(*grid).digits(components));
    }
    card.write()
}

fn equation(equation: &Mpc) -> String {
    let mut card = Fields::new("MPC");
    for (line, terms) in equation.terms.chunks(2).enumerate() {
        card = card.next_line();
        card = if line == 0 { card.int(equation.set) } else { card.blanks(1) };
        card = terms.iter().fold(card, |card, (motion, factor)| card.motion(Some(*motion)).real(*factor));
    }
    card.write()
}
