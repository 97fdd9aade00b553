//! Sections of bars and beams along their length: PBAR, PBEAM, by the name of a section PBARL and PBEAML, and PBCOMP.

use super::named_section::{self, NamedStation};
use super::prelude::*;
use super::section_shapes::Section;
use crate::card::FIELDS_PER_LINE;

/// One station of a beam section. Plane 1 is spanned by the element axis x and the orientation vector (element y).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BeamStation {
    /// Position x/L along the element.
    pub x_over_l: f64,
    /// Area.
    pub area: f64,
    /// I1 = Izz: bending in plane 1 (x-y).
    pub i1: f64,
    /// I2 = Iyy: bending in plane 2 (x-z).
    pub i2: f64,
    /// I12.
    pub i12: f64,
    /// Torsional constant J.
    pub j: f64,
    /// Non-structural mass per unit length.
    pub nsm: f64,
}

/// A bar or beam property (PBAR, PBEAM).
#[derive(Debug, Clone, PartialEq)]
pub struct BeamProperty {
    /// Identification number.
    pub id: u32,
    /// MAT1.
    pub material: u32,
    /// Stations in ascending x/L, at least one; PBAR has one, PBEAM at least ends A (0) and B (1).
    pub stations: Vec<BeamStation>,
    /// Shear stiffness factors K1, K2; zero means no shear flexibility.
    pub shear_factors: [f64; 2],
    /// Non-structural mass moment of inertia per length at ends A and B (PBEAM NSI).
    pub nsi: [f64; 2],
    /// Non-structural mass centre offsets (y, z) at ends A and B (PBEAM M1, M2).
    pub nsm_offset: [[f64; 2]; 2],
    /// Neutral axis offsets (y, z) from the shear centre at ends A and B (PBEAM N1, N2).
    pub neutral_axis: [[f64; 2]; 2],
    /// True for PBEAM.
    pub is_beam: bool,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for BeamProperty {
    numbered!();
    variant!(|card| usize::from(card.is_beam));

    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let property = match card.name.as_str() {
            "PBAR" => pbar(card)?,
            "PBEAM" => pbeam(card)?,
            "PBCOMP" => pbcomp(card)?,
            _ => named(card)?,
        };
        Ok(vec![property])
    }

    fn write(&self, card: Fields) -> Fields {
        let Some(first) = self.stations.first() else { return card };
        let card = card.ints([self.id, self.material]);
        if !self.is_beam {
            let card = card.reals(&[first.area, first.i1, first.i2, first.j, first.nsm]);
            return card.blanks(9).reals(&self.shear_factors).real(first.i12);
        }
        let mut card = card.reals(&[first.area, first.i1, first.i2, first.i12, first.j, first.nsm]);
        for station in &self.stations[1..] {
            card = card.text("NO").real(station.x_over_l);
            card = card.reals(&[station.area, station.i1, station.i2, station.i12, station.j, station.nsm]);
        }
        if self.stations.len() == 1 {
            // A uniform beam: the line of stress points keeps the places of what follows.
            card = card.reals(&[0.0; 8]);
        }
        let card = card.reals(&self.shear_factors).reals(&[0.0, 0.0]).reals(&self.nsi).reals(&[0.0, 0.0]);
        card.reals(self.nsm_offset.as_flattened()).reals(self.neutral_axis.as_flattened())
    }

    raises!(cards: id, material);

    /// Element z is the cross product of axis and orientation vector: what lies along it changes its sign.
    fn mirrored(mut self, _: &Mirror) -> Mirrored<Self> {
        self.stations.iter_mut().for_each(|station| station.i12 = minus(station.i12));
        self.nsm_offset.iter_mut().chain(&mut self.neutral_axis).for_each(|at| at[1] = minus(at[1]));
        Ok(Some(self))
    }
}

/// PBAR: PID MID A I1 I2 J NSM / C1 C2 D1 D2 E1 E2 F1 F2 / K1 K2 I12; stress points are skipped, and with I12 so are K1 and K2, as in Nastran.
fn pbar(card: &Card) -> Result<BeamProperty, InputError> {
    let given = [card.real_or(16, "K1", 0.0)?, card.real_or(17, "K2", 0.0)?];
    let station = BeamStation {
        x_over_l: 0.0,
        area: card.real_or(2, "A", 0.0)?,
        i1: card.real_or(3, "I1", 0.0)?,
        i2: card.real_or(4, "I2", 0.0)?,
        i12: card.real_or(18, "I12", 0.0)?,
        j: card.real_or(5, "J", 0.0)?,
        nsm: card.real_or(6, "NSM", 0.0)?,
    };
    Ok(BeamProperty {
        id: card.id(0, "PID")?,
        material: card.id(1, "MID")?,
        // An empty K is infinite shear stiffness, which is what zero stands for.
        shear_factors: if station.i12 == 0.0 { given } else { [0.0; 2] },
        stations: vec![station],
        nsi: [0.0; 2],
        nsm_offset: [[0.0; 2]; 2],
        neutral_axis: [[0.0; 2]; 2],
        is_beam: false,
        span: card.span.clone(),
    })
}

/// PBEAM: PID MID A I1 I2 I12 J NSM at end A (/ stress points) / SO X/XB A I1 I2 I12 J NSM (/ stress points) /
/// ... / K1 K2 S1 S2 NSI(A) NSI(B) CW(A) CW(B) / M1(A) M2(A) M1(B) M2(B) N1(A) N2(A) N1(B) N2(B).
///
/// Empty fields of end B are those of end A; of intermediate stations, interpolated between the ends. Stress
/// points and warping coefficients are skipped; shear relief (S1, S2) is refused.
fn pbeam(card: &Card) -> Result<BeamProperty, InputError> {
    let end_a = section(card, 2)?.map(|value| value.unwrap_or(0.0));
    let mut at = FIELDS_PER_LINE;
    if !is_output_request(card.text(at)) {
        at += FIELDS_PER_LINE;
    }
    let mut given = Vec::new();
    while is_output_request(card.text(at)) {
        let x = card.real(at + 1, "X/XB")?;
        if !(x > 0.0 && x <= 1.0) {
            return Err(card.wrong(at + 1, "X/XB", "above 0 and at most 1"));
        }
        if given.iter().any(|(other, _)| *other == x) {
            return Err(card.error(at + 1, format!("station {x} of PBEAM is given twice")));
        }
        given.push((x, section(card, at + 2)?));
        let has_stress_points = card.text(at).eq_ignore_ascii_case("YES");
        at += FIELDS_PER_LINE * if has_stress_points { 2 } else { 1 };
    }
    for (index, name) in [(at + 2, "S1"), (at + 3, "S2")] {
        if card.real_or(index, name, 0.0)? != 0.0 {
            return Err(card.error(index, format!("shear relief ({name}) of PBEAM is not read")));
        }
    }
    let nsi_a = card.real_or(at + 4, "NSI(A)", 0.0)?;
    let axes = at + FIELDS_PER_LINE;
    Ok(BeamProperty {
        id: card.id(0, "PID")?,
        material: card.id(1, "MID")?,
        stations: stations(end_a, given),
        shear_factors: [card.real_or(at, "K1", 1.0)?, card.real_or(at + 1, "K2", 1.0)?],
        nsi: [nsi_a, card.real_or(at + 5, "NSI(B)", nsi_a)?],
        nsm_offset: offsets(card, axes, "M")?,
        neutral_axis: offsets(card, axes + 4, "N")?,
        is_beam: true,
        span: card.span.clone(),
    })
}

fn is_output_request(text: &str) -> bool {
    ["YES", "YESA", "NO"].iter().any(|word| text.eq_ignore_ascii_case(word))
}

/// A, I1, I2, I12, J, NSM; nothing where a field is empty.
fn section(card: &Card, from: usize) -> Result<[Option<f64>; 6], InputError> {
    let mut values = [None; 6];
    for (index, name) in ["A", "I1", "I2", "I12", "J", "NSM"].into_iter().enumerate() {
        values[index] = card.optional_real(from + index, name)?;
    }
    Ok(values)
}

fn stations(end_a: [f64; 6], given: Vec<(f64, [Option<f64>; 6])>) -> Vec<BeamStation> {
    let b_fields = given.iter().find(|(x, _)| *x == 1.0).map_or([None; 6], |(_, fields)| *fields);
    let end_b: [f64; 6] = std::array::from_fn(|i| b_fields[i].unwrap_or(end_a[i]));
    let mut all = vec![station(0.0, end_a), station(1.0, end_b)];
    for (x, fields) in given.into_iter().filter(|(x, _)| *x < 1.0) {
        let between = |i: usize| end_a[i] + (end_b[i] - end_a[i]) * x;
        all.push(station(x, std::array::from_fn(|i| fields[i].unwrap_or_else(|| between(i)))));
    }
    all.sort_by(|one, other| one.x_over_l.total_cmp(&other.x_over_l));
    all
}

fn station(x_over_l: f64, [area, i1, i2, i12, j, nsm]: [f64; 6]) -> BeamStation {
    BeamStation { x_over_l, area, i1, i2, i12, j, nsm }
}

/// Two offsets at each end, those of B by default those of A.
fn offsets(card: &Card, from: usize, letter: &str) -> Result<[[f64; 2]; 2], InputError> {
    let one = card.real_or(from, &format!("{letter}1(A)"), 0.0)?;
    let two = card.real_or(from + 1, &format!("{letter}2(A)"), 0.0)?;
    let end_b = [
        card.real_or(from + 2, &format!("{letter}1(B)"), one)?,
        card.real_or(from + 3, &format!("{letter}2(B)"), two)?,
    ];
    Ok([[one, two], end_b])
}

/// PBARL and PBEAML, as the PBAR and PBEAM they amount to. The shear factors are those of end A; a bar has no distance
/// between shear centre and neutral axis, so that of the section is dropped, as Nastran does.
fn named(card: &Card) -> Result<BeamProperty, InputError> {
    let is_beam = card.name == "PBEAML";
    let given = if is_beam { named_section::pbeaml(card)? } else { named_section::pbarl(card)? };
    let neutral_axis = [0, given.len() - 1].map(|end| given[end].section.neutral_axis);
    let station = |at: &NamedStation| {
        let Section { area, i1, i2, i12, j, .. } = at.section;
        BeamStation { x_over_l: at.x_over_l, area, i1, i2, i12, j, nsm: at.nsm }
    };
    Ok(BeamProperty {
        id: card.id(0, "PID")?,
        material: card.id(1, "MID")?,
        stations: given.iter().map(station).collect(),
        shear_factors: given[0].section.shear_factors,
        nsi: [0.0; 2],
        nsm_offset: [[0.0; 2]; 2],
        neutral_axis: if is_beam { neutral_axis } else { [[0.0; 2]; 2] },
        is_beam,
        span: card.span.clone(),
    })
}

/// PBCOMP: PID MID A I1 I2 I12 J NSM / K1 K2 M1 M2 N1 N2 SYMOPT, without its areas.
fn pbcomp(card: &Card) -> Result<BeamProperty, InputError> {
    let station = BeamStation {
        x_over_l: 0.0,
        area: card.positive(2, "A")?,
        i1: card.not_negative(3, "I1", 0.0)?,
        i2: card.not_negative(4, "I2", 0.0)?,
        i12: card.real_or(5, "I12", 0.0)?,
        j: card.not_negative(6, "J", 0.0)?,
        nsm: card.real_or(7, "NSM", 0.0)?,
    };
    let line = FIELDS_PER_LINE;
    let of_nsm = [card.real_or(line + 2, "M1", 0.0)?, card.real_or(line + 3, "M2", 0.0)?];
    let neutral = [card.real_or(line + 4, "N1", 0.0)?, card.real_or(line + 5, "N2", 0.0)?];
    Ok(BeamProperty {
        id: card.id(0, "PID")?,
        material: card.id(1, "MID")?,
        stations: vec![station, BeamStation { x_over_l: 1.0, ..station }],
        shear_factors: [card.real_or(line, "K1", 1.0)?, card.real_or(line + 1, "K2", 1.0)?],
        nsi: [0.0; 2],
        nsm_offset: [of_nsm; 2],
        neutral_axis: [neutral; 2],
        is_beam: true,
        span: card.span.clone(),
    })
}
