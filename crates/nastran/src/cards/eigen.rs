//! What modes are asked for: EIGRL and EIGR.

use super::prelude::*;

/// Methods of EIGR that transform the whole matrix: with a number of modes (ND) their range of frequencies selects nothing.
const TRANSFORMATIONS: [&str; 6] = ["GIV", "MGIV", "AGIV", "HOU", "MHOU", "AHOU"];

/// A range of frequencies and a number of modes (EIGRL, EIGR); how they are computed is not its matter.
#[derive(Debug, Clone, PartialEq)]
pub struct EigenMethod {
    /// Identification number, which METHOD of the case control selects.
    pub id: u32,
    /// Upper end of the range of frequencies, Hz.
    pub highest_hz: Option<f64>,
    /// Number of modes.
    pub count: Option<u32>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for EigenMethod {
    numbered!();
    /// EIGRL: SID V1 V2 ND ...; EIGR: SID METHOD F1 F2 NE ND ... The lower end of the range is skipped: modes are found from the lowest on. GIV and
    /// its like find all modes, of which Nastran gives ND, or those of the range where ND is blank.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let (highest, count) = if card.name == "EIGRL" { (2, 3) } else { (3, 5) };
        let count = Some(card.count_or(count, "ND", 0)?).filter(|count| *count > 0);
        let method = card.text(1).to_ascii_uppercase();
        let is_by_number =
            card.name == "EIGR" && count.is_some() && TRANSFORMATIONS.contains(&method.as_str());
        Ok(vec![Self {
            id: card.id(0, "SID")?,
            highest_hz: card.optional_real(highest, "V2")?.filter(|hz| *hz > 0.0 && !is_by_number),
            count,
            span: card.span.clone(),
        }])
    }

    // A selection of the case control's, which is not written.
    not_written!();

    raises!(cards: id);

    no_image!();
}
