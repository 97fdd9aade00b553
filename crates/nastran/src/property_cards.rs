//! Beam sections and materials: from fields to the structs of [`crate::cards`], with Nastran's defaults.

use crate::card::Card;
use crate::cards::{BeamProperty, BeamStation, Mat1};
use crate::field::FIELDS_PER_LINE;
use crate::source::InputError;

/// PBAR: PID MID A I1 I2 J NSM / C1 C2 D1 D2 E1 E2 F1 F2 / K1 K2 I12; stress points are skipped.
pub(crate) fn pbar(card: &Card) -> Result<BeamProperty, InputError> {
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
        stations: vec![station],
        // An empty K is infinite shear stiffness, which is what zero stands for.
        shear_factors: [card.real_or(16, "K1", 0.0)?, card.real_or(17, "K2", 0.0)?],
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
pub(crate) fn pbeam(card: &Card) -> Result<BeamProperty, InputError> {
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

/// MAT1: MID E G NU RHO; of E, G and NU the empty one follows from E = 2 (1 + NU) G.
///
/// If NU is empty together with E or G, both are zero, as in Nastran.
pub(crate) fn mat1(card: &Card) -> Result<Mat1, InputError> {
    let fields = (card.optional_real(1, "E")?, card.optional_real(2, "G")?, card.optional_real(3, "NU")?);
    let (e, g, nu) = match fields {
        (Some(e), Some(g), Some(nu)) => (e, g, nu),
        (Some(e), None, Some(nu)) if nu > -1.0 => (e, e / (2.0 * (1.0 + nu)), nu),
        (None, Some(g), Some(nu)) => (2.0 * (1.0 + nu) * g, g, nu),
        (Some(e), Some(g), None) if g > 0.0 => (e, g, e / (2.0 * g) - 1.0),
        (Some(e), Some(g), None) => (e, g, 0.0),
        (Some(e), None, None) => (e, 0.0, 0.0),
        (None, Some(g), None) => (0.0, g, 0.0),
        (Some(_), None, Some(_)) => return Err(card.wrong(3, "NU", "above -1")),
        (None, None, _) => {
            return Err(card.empty(1, "E", "Young's modulus, or the shear modulus in field G"));
        }
    };
    Ok(Mat1 { id: card.id(0, "MID")?, e, g, nu, rho: card.real_or(4, "RHO", 0.0)?, span: card.span.clone() })
}
