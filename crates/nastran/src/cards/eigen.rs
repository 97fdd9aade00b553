//! What modes are asked for: EIGRL and EIGR.

use super::prelude::*;

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
    /// EIGRL: SID V1 V2 ND ...; EIGR: SID METHOD F1 F2 NE ND ... The lower end of the range is skipped: modes are found from the lowest on.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let (highest, count) = if card.name == "EIGRL" { (2, 3) } else { (3, 5) };
        Ok(vec![Self {
            id: card.id(0, "SID")?,
            highest_hz: card.optional_real(highest, "V2")?.filter(|hz| *hz > 0.0),
            count: Some(card.count_or(count, "ND", 0)?).filter(|count| *count > 0),
            span: card.span.clone(),
        }])
    }

    // A selection of the case control's, which is not written.
    not_written!();

    raises!(cards: id);

    no_image!();
}
