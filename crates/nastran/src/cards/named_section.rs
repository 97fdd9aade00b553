//! Sections of beams given by name and dimensions: PBARL and PBEAML.

use super::section_shapes::{OF_BARS_ONLY, SECTIONS, Section, section};
use crate::card::{Card, FIELDS_PER_LINE};
use crate::source::InputError;

/// A section at one station.
pub(super) struct NamedStation {
    /// Position x/L along the element.
    pub(super) x_over_l: f64,
    /// What it amounts to.
    pub(super) section: Section,
    /// Non-structural mass per unit length.
    pub(super) nsm: f64,
}

/// PBARL: PID MID GROUP TYPE / DIM1 ... DIMn NSM; one station.
pub(super) fn pbarl(card: &Card) -> Result<Vec<NamedStation>, InputError> {
    let (name, count) = kind(card)?;
    card.ends_after(FIELDS_PER_LINE + count + 1)?;
    let section = at(card, name, &dimensions(card, FIELDS_PER_LINE, count, None)?, FIELDS_PER_LINE)?;
    let nsm = card.real_or(FIELDS_PER_LINE + count, "NSM", 0.0)?;
    Ok(vec![NamedStation { x_over_l: 0.0, section, nsm }])
}

/// PBEAML: PID MID GROUP TYPE / DIM1(A) ... DIMn(A) NSM(A) SO(1) X(1)/XB DIM1(1) ... NSM(1) SO(2) ...
///
/// Stations in ascending x/L from end A to end B. Empty dimensions of end B are those of end A; intermediate stations
/// must have all of theirs.
pub(super) fn pbeaml(card: &Card) -> Result<Vec<NamedStation>, InputError> {
    let (name, count) = kind(card)?;
    let first = dimensions(card, FIELDS_PER_LINE, count, None)?;
    let end_a = at(card, name, &first, FIELDS_PER_LINE)?;
    let nsm_a = card.real_or(FIELDS_PER_LINE + count, "NSM(A)", 0.0)?;
    let mut stations = vec![NamedStation { x_over_l: 0.0, section: end_a, nsm: nsm_a }];
    let mut from = FIELDS_PER_LINE + count + 1;
    while from < card.len() {
        card.word(from, "SO", &["YES", "NO"])?;
        let x_over_l = card.real_or(from + 1, "X/XB", 1.0)?;
        if !(x_over_l > 0.0 && x_over_l <= 1.0) {
            return Err(card.wrong(from + 1, "X/XB", "above 0 and at most 1"));
        }
        if stations.iter().any(|other| other.x_over_l == x_over_l) {
            return Err(card.error(from + 1, format!("station {x_over_l} of PBEAML is given twice")));
        }
        let default = if x_over_l == 1.0 { Some(first.as_slice()) } else { None };
        let section = at(card, name, &dimensions(card, from + 2, count, default)?, from + 2)?;
        let nsm = card.real_or(from + 2 + count, "NSM", nsm_a)?;
        stations.push(NamedStation { x_over_l, section, nsm });
        from += count + 3;
    }
    if stations.iter().all(|station| station.x_over_l != 1.0) {
        stations.push(NamedStation { x_over_l: 1.0, section: end_a, nsm: nsm_a });
    }
    stations.sort_by(|one, other| one.x_over_l.total_cmp(&other.x_over_l));
    Ok(stations)
}

/// The name of the section and the number of its dimensions.
fn kind(card: &Card) -> Result<(&'static str, usize), InputError> {
    card.word(2, "GROUP", &["MSCBML0"])?;
    let name = card.name_at(3, "TYPE")?;
    if card.name == "PBEAML" && OF_BARS_ONLY.contains(&name.as_str()) {
        let message = format!("section {name} of PBEAML is not read: its shear centre is not known");
        return Err(card.error(3, message).with_help("give the numbers in a PBEAM, or use PBARL"));
    }
    SECTIONS.into_iter().find(|(known, _)| *known == name).ok_or_else(|| {
        let known: Vec<&str> = SECTIONS.iter().map(|(known, _)| *known).collect();
        let message = format!("section {name} of {} is not read", card.name);
        let help = format!("{} are; for others give the numbers in a PBAR or PBEAM", known.join(", "));
        card.error(3, message).with_help(help)
    })
}

fn dimensions(
    card: &Card,
    from: usize,
    count: usize,
    default: Option<&[f64]>,
) -> Result<Vec<f64>, InputError> {
    let one = |number: usize| {
        let (index, name) = (from + number, format!("DIM{}", number + 1));
        match default {
            Some(values) if card.text(index).is_empty() => Ok(values[number]),
            _ if card.text(index).is_empty() => Err(card.empty(index, &name, "a dimension above zero")),
            // A tube may be solid.
            _ if number == 1 && count == 2 => card.not_negative(index, &name, 0.0),
            _ => card.positive(index, &name),
        }
    };
    (0..count).map(one).collect()
}

fn at(card: &Card, name: &str, dimensions: &[f64], from: usize) -> Result<Section, InputError> {
    section(name, dimensions).filter(|section| section.area > 0.0).ok_or_else(|| {
        let message = format!("the dimensions of section {name} in {} do not fit together", card.name);
        card.error(from, message)
            .with_help("walls must leave room inside, and inner radii be below outer ones")
    })
}
