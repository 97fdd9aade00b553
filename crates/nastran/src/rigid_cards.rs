//! Rigid elements and constraints: RBAR, RBE3, MPC and SPC, from fields to the structs of [`crate::fe_cards`].

use crate::card::Card;
use crate::cards::Spc1;
use crate::fe_cards::{Mpc, Rbar, Rbe3, Rbe3Group};
use crate::field::FIELDS_PER_LINE;
use crate::real;
use crate::source::InputError;

/// RBAR: EID GA GB CNA CNB CMA CMB ALPHA; thermal expansion is skipped.
pub(crate) fn rbar(card: &Card) -> Result<Rbar, InputError> {
    card.ends_after(8)?;
    let id = card.id(0, "EID")?;
    let grids = card.corners(1, &["GA", "GB"])?;
    let independent = [card.components(3, "CNA")?, card.components(4, "CNB")?];
    let dependent = [card.components(5, "CMA")?, card.components(6, "CMB")?];
    let count = independent[0].len() + independent[1].len();
    if count != 6 {
        let message = format!("RBAR {id} has {count} independent components in CNA and CNB, not six");
        return Err(card.error(3, message).with_help("for instance CNA 123456 and CNB empty"));
    }
    for end in 0..2 {
        if let Some(digit) = dependent[end].iter().find(|digit| independent[end].contains(digit)) {
            let message = format!("component {digit} of RBAR {id} is independent and dependent at one end");
            return Err(card.error(5 + end, message));
        }
    }
    Ok(Rbar { id, grids: [grids[0], grids[1]], independent, dependent, span: card.span.clone() })
}

/// RBE3: EID blank REFGRID REFC WT1 C1 G1,1 G1,2 ... WT2 C2 ... UM GM1 CM1 GM2 CM2 ... ALPHA a.
///
/// Groups start with a real number. Thermal expansion is skipped.
pub(crate) fn rbe3(card: &Card) -> Result<Rbe3, InputError> {
    let id = card.id(0, "EID")?;
    let find = |word: &str| (4..card.len()).find(|index| card.text(*index).eq_ignore_ascii_case(word));
    let end = find("ALPHA").unwrap_or(card.len());
    let um_at = find("UM").filter(|index| *index < end);
    let groups = groups(card, 4, um_at.unwrap_or(end))?;
    if groups.is_empty() {
        let message = format!("RBE3 {id} has no grids to follow");
        return Err(card
            .error(4, message)
            .with_help("give a weight, components and grids: 1.0, 123, G1, G2"));
    }
    let mut um = Vec::new();
    let mut at = um_at.map_or(end, |index| index + 1);
    while at < end {
        if card.text(at).is_empty() {
            at += 1;
        } else {
            um.push((card.id(at, "GM")?, card.some_components(at + 1, "CM")?));
            at += 2;
        }
    }
    Ok(Rbe3 {
        id,
        reference: card.id(2, "REFGRID")?,
        components: card.some_components(3, "REFC")?,
        groups,
        um,
        span: card.span.clone(),
    })
}

fn groups(card: &Card, from: usize, end: usize) -> Result<Vec<Rbe3Group>, InputError> {
    let is_weight = |index: usize| real::parse(card.text(index)).is_some();
    let mut groups = Vec::new();
    let mut at = from;
    while at < end {
        if card.text(at).is_empty() {
            at += 1;
            continue;
        }
        let (weight, components) = (card.real(at, "WT")?, card.some_components(at + 1, "C")?);
        if weight < 0.0 {
            return Err(card.wrong(at, "WT", "zero or more"));
        }
        let next = (at + 2..end).find(|index| is_weight(*index)).unwrap_or(end);
        let grids = card.id_list_until(at + 2, next, "G")?;
        groups.push(Rbe3Group { weight, components, grids });
        at = next;
    }
    Ok(groups)
}

/// MPC: SID G1 C1 A1 G2 C2 A2 blank / blank G3 C3 A3 ...
pub(crate) fn mpc(card: &Card) -> Result<Mpc, InputError> {
    let set = card.id(0, "SID")?;
    let mut terms = Vec::new();
    for line in (0..card.len().max(2)).step_by(FIELDS_PER_LINE) {
        for at in [line + 1, line + 4] {
            if at == 1 || (at..at + 3).any(|index| !card.text(index).is_empty()) {
                let motion = card.motion(at, "G", "C")?;
                if terms.iter().any(|(other, _)| *other == motion) {
                    let message = format!("motion {} of grid {} stands twice in MPC", motion.1, motion.0);
                    return Err(card.error(at, message));
                }
                terms.push((motion, card.real(at + 2, "A")?));
            }
        }
        for index in [line + 7, line + 8] {
            if !card.text(index).is_empty() {
                let message = format!("`{}` stands in a field of MPC that is always empty", card.text(index));
                return Err(card
                    .error(index, message)
                    .with_help("two terms a line, from the third column on"));
            }
        }
    }
    match terms.first() {
        Some((_, 0.0)) => Err(card.error(3, "the coefficient of the dependent motion (A1) of MPC is zero")),
        _ => Ok(Mpc { set, terms, span: card.span.clone() }),
    }
}

/// SPC: SID G1 C1 D1 G2 C2 D2, as the SPC1 that say the same; enforced displacements are refused.
pub(crate) fn spc(card: &Card) -> Result<Vec<Spc1>, InputError> {
    card.ends_after(7)?;
    let set = card.id(0, "SID")?;
    let mut all = Vec::new();
    for at in [1, 4] {
        if at > 1 && (at..at + 3).all(|index| card.text(index).is_empty()) {
            continue;
        }
        let (grid, components) = (card.id(at, "G")?, card.some_components(at + 1, "C")?);
        let displacement = card.real_or(at + 2, "D", 0.0)?;
        if displacement != 0.0 {
            let message =
                format!("SPC enforces a displacement of {displacement} on grid {grid}, which is not read");
            return Err(card.error(at + 2, message).with_help("leave field D empty, or zero"));
        }
        all.push(Spc1 { set, components, grids: vec![grid], span: card.span.clone() });
    }
    Ok(all)
}
