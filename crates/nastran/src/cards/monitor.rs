//! Monitoring stations: MONPNT1 and MONPNT3.

use super::prelude::*;
use nalgebra::Point3;

/// A monitoring station (MONPNT1, MONPNT3).
#[derive(Debug, Clone, PartialEq)]
pub struct MonitorPoint {
    /// NAME.
    pub name: String,
    /// LABEL.
    pub label: String,
    /// Component digits of the axes.
    pub axes: Vec<u8>,
    /// COMP of MONPNT1 (an AECOMP), GRIDSET of MONPNT3.
    pub set: String,
    /// Coordinate system of the point.
    pub cp: u32,
    /// The point.
    pub xyz: Point3<f64>,
    /// Output coordinate system.
    pub cd: u32,
    /// True for MONPNT3 (structural grid point forces), false for MONPNT1.
    pub is_structural: bool,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for MonitorPoint {
    keyed!(String, name);
    variant!(|card| usize::from(card.is_structural));

    /// MONPNT1: NAME LABEL / AXES COMP CP X Y Z CD, and
    /// MONPNT3: NAME LABEL / AXES GRIDSET ELEMSET CP X Y Z XFLAG / CD; ELEMSET and XFLAG are skipped.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let is_structural = card.name == "MONPNT3";
        let cp_at = if is_structural { 11 } else { 10 };
        let cd_at = if is_structural { 16 } else { 14 };
        let axes = card.components(8, "AXES")?;
        if axes.is_empty() {
            return Err(card.empty(8, "AXES", "a combination of the digits 1 to 6"));
        }
        let cp = card.count_or(cp_at, "CP", 0)?;
        Ok(vec![MonitorPoint {
            name: card.name_at(0, "NAME")?,
            label: card.long_text(1..8),
            axes,
            set: card.name_at(9, if is_structural { "GRIDSET" } else { "COMP" })?,
            cp,
            xyz: card.vector(cp_at + 1, ["X", "Y", "Z"])?,
            cd: card.count_or(cd_at, "CD", cp)?,
            is_structural,
            span: card.span.clone(),
        }])
    }

    /// The label runs over seven fields of 8 columns, so the first line is a small one in any case.
    fn write(&self, card: Fields) -> Fields {
        let gap = usize::from(self.is_structural);
        let card = card.first_line(format!("{:<8}{}", self.name, self.label));
        let card = card.digits(&self.axes).text(self.set.clone()).blanks(gap).int(self.cp);
        card.reals(&self.xyz.coords).blanks(gap).int(self.cd)
    }

    raises!(systems: cp, cd);

    // Left out: the names of stations are those of the original.
    no_image!();
}
