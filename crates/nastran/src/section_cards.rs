//! Beam properties given by the dimensions of a named section: PBARL and PBEAML, as the PBAR and PBEAM they amount to.

use crate::beam_sections::{SECTIONS, Section, section};
use crate::card::Card;
use crate::cards::{BeamProperty, BeamStation};
use crate::field::FIELDS_PER_LINE;
use crate::source::InputError;

/// PBARL: PID MID GROUP TYPE / DIM1 ... DIMn NSM.
///
/// A bar has no distance between shear centre and neutral axis, so that of the section is dropped, as Nastran does.
pub(crate) fn pbarl(card: &Card) -> Result<BeamProperty, InputError> {
    let (name, count) = kind(card)?;
    card.ends_after(FIELDS_PER_LINE + count + 1)?;
    let section = at(card, name, &dimensions(card, FIELDS_PER_LINE, count, None)?, FIELDS_PER_LINE)?;
    let nsm = card.real_or(FIELDS_PER_LINE + count, "NSM", 0.0)?;
    Ok(BeamProperty {
        id: card.id(0, "PID")?,
        material: card.id(1, "MID")?,
        stations: vec![station(0.0, &section, nsm)],
        shear_factors: section.shear_factors,
        nsi: [0.0; 2],
        nsm_offset: [[0.0; 2]; 2],
        neutral_axis: [[0.0; 2]; 2],
        is_beam: false,
        span: card.span.clone(),
    })
}

/// PBEAML: PID MID GROUP TYPE / DIM1(A) ... DIMn(A) NSM(A) SO(1) X(1)/XB DIM1(1) ... NSM(1) SO(2) ...
///
/// Empty dimensions of end B are those of end A; intermediate stations must have all of theirs. The shear factors are
/// those of end A.
pub(crate) fn pbeaml(card: &Card) -> Result<BeamProperty, InputError> {
    let (name, count) = kind(card)?;
    let first = dimensions(card, FIELDS_PER_LINE, count, None)?;
    let end_a = at(card, name, &first, FIELDS_PER_LINE)?;
    let nsm_a = card.real_or(FIELDS_PER_LINE + count, "NSM(A)", 0.0)?;
    let mut stations = vec![station(0.0, &end_a, nsm_a)];
    let mut end_b = None;
    let mut from = FIELDS_PER_LINE + count + 1;
    while from < card.len() {
        card.word(from, "SO", &["YES", "NO"])?;
        let x = card.real_or(from + 1, "X/XB", 1.0)?;
        if !(x > 0.0 && x <= 1.0) {
            return Err(card.wrong(from + 1, "X/XB", "above 0 and at most 1"));
        }
        if stations.iter().any(|other| other.x_over_l == x) {
            return Err(card.error(from + 1, format!("station {x} of PBEAML is given twice")));
        }
        let default = if x == 1.0 { Some(first.as_slice()) } else { None };
        let here = at(card, name, &dimensions(card, from + 2, count, default)?, from + 2)?;
        stations.push(station(x, &here, card.real_or(from + 2 + count, "NSM", nsm_a)?));
        if x == 1.0 {
            end_b = Some(here);
        }
        from += count + 3;
    }
    let end_b = end_b.unwrap_or_else(|| {
        stations.push(station(1.0, &end_a, nsm_a));
        end_a
    });
    stations.sort_by(|one, other| one.x_over_l.total_cmp(&other.x_over_l));
    Ok(BeamProperty {
        id: card.id(0, "PID")?,
        material: card.id(1, "MID")?,
        stations,
        shear_factors: end_a.shear_factors,
        nsi: [0.0; 2],
        nsm_offset: [[0.0; 2]; 2],
        neutral_axis: [end_a.neutral_axis, end_b.neutral_axis],
        is_beam: true,
        span: card.span.clone(),
    })
}

/// The name of the section and the number of its dimensions.
fn kind(card: &Card) -> Result<(&'static str, usize), InputError> {
    card.word(2, "GROUP", &["MSCBML0"])?;
    let name = card.name_at(3, "TYPE")?;
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

fn station(x_over_l: f64, section: &Section, nsm: f64) -> BeamStation {
    let Section { area, i1, i2, i12, j, .. } = *section;
    BeamStation { x_over_l, area, i1, i2, i12, j, nsm }
}
