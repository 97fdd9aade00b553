//! Laminates: PCOMP and PCOMPG, with the defaults of Nastran's Quick Reference Guide.

use super::prelude::*;
use crate::card::FIELDS_PER_LINE;

/// One ply of a laminate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ply {
    /// Material (MAT1, MAT2 or MAT8).
    pub material: u32,
    /// Thickness.
    pub thickness: f64,
    /// Angle of the fibres from the element's material direction, degrees.
    pub angle_deg: f64,
    /// GPLYID of PCOMPG, kept to be written again.
    pub global_id: Option<u32>,
}

impl Ids for Ply {
    fn each(&mut self, change: &mut dyn FnMut(&mut u32)) {
        self.material.each(change);
    }
}

/// LAM: which plies are listed and what is computed of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LaminateOption {
    /// Blank: all plies, all stiffness.
    All,
    /// SYM: the lower half of the plies, all stiffness.
    Symmetric,
    /// MEM: all plies, membrane stiffness alone.
    Membrane,
    /// BEND: all plies, bending stiffness alone.
    Bending,
    /// SMEAR: all plies, whose sequence does not matter: a plate of their mean.
    Smeared,
    /// SMCORE: the faces' plies and, last, the core; half of the faces' mean lies below and half above it.
    SmearedFaces,
}

impl LaminateOption {
    const WORDS: [(&'static str, Self); 5] = [
        ("SYM", Self::Symmetric),
        ("MEM", Self::Membrane),
        ("BEND", Self::Bending),
        ("SMEAR", Self::Smeared),
        ("SMCORE", Self::SmearedFaces),
    ];

    /// Field LAM of a card.
    fn read(card: &Card) -> Result<Self, InputError> {
        card.word(7, "LAM", &Self::WORDS.map(|(word, _)| word))?;
        let given = card.text(7);
        let found = Self::WORDS.into_iter().find(|(word, _)| word.eq_ignore_ascii_case(given));
        Ok(found.map_or(Self::All, |(_, option)| option))
    }

    /// Its word; none for all plies and all stiffness.
    pub fn word(self) -> Option<&'static str> {
        Self::WORDS.into_iter().find(|(_, option)| *option == self).map(|(word, _)| word)
    }
}

/// A laminate (PCOMP, PCOMPG), plies from bottom to top.
#[derive(Debug, Clone, PartialEq)]
pub struct Pcomp {
    /// Identification number.
    pub id: u32,
    /// Z0: from the reference plane to the bottom surface; none means half the total thickness below.
    pub z0: Option<f64>,
    /// NSM: non-structural mass per area.
    pub nsm: f64,
    /// TREF: the temperature at which nothing has expanded, in the place of the plies' own.
    pub reference: f64,
    /// The plies the card lists.
    pub plies: Vec<Ply>,
    /// LAM: whether these are all, and what is computed of them.
    pub option: LaminateOption,
    /// True for PCOMPG.
    pub is_global: bool,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Pcomp {
    numbered!();
    variant!(|card| usize::from(card.is_global));

    /// PCOMP: PID Z0 NSM SB FT TREF GE LAM / MID1 T1 THETA1 SOUT1 MID2 T2 THETA2 SOUT2 / ..., and
    /// PCOMPG: the same first line, then a line GPLYID MID T THETA SOUT for every ply.
    ///
    /// Strength and damping (SB, FT, GE) are skipped. Four empty fields are no ply.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let is_global = card.name == "PCOMPG";
        let option = LaminateOption::read(card)?;
        let (stride, first) = if is_global { (FIELDS_PER_LINE, 1) } else { (4, 0) };
        let mut plies: Vec<Ply> = Vec::new();
        for start in (FIELDS_PER_LINE..card.len()).step_by(stride) {
            let at = start + first;
            if (start..start + stride).all(|index| card.text(index).is_empty()) {
                continue;
            }
            for index in at + 4..start + stride {
                card.unset(index, "behind SOUT")?;
            }
            let ply = ply(card, at, plies.last())?;
            let global_id = if is_global { Some(card.id(start, "GPLYID")?) } else { None };
            if let Some(id) = global_id.filter(|_| plies.iter().any(|other| other.global_id == global_id)) {
                return Err(
                    card.error(start, format!("global ply {id} stands twice in PCOMPG {}", card.text(0)))
                );
            }
            plies.push(Ply { global_id, ..ply });
        }
        if plies.is_empty() {
            let message = format!("{} {} has no plies", card.name, card.text(0));
            return Err(card
                .error(0, message)
                .with_help("plies start in the second line: MID, T, THETA, SOUT"));
        }
        Ok(vec![Pcomp {
            id: card.id(0, "PID")?,
            z0: card.optional_real(1, "Z0")?,
            nsm: card.real_or(2, "NSM", 0.0)?,
            reference: card.real_or(5, "TREF", 0.0)?,
            plies,
            option,
            is_global,
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        let card = card.int(self.id).optional_real(self.z0).real(self.nsm).blanks(2);
        let warm = Some(self.reference).filter(|reference| *reference != 0.0);
        let card = card.optional_real(warm).blanks(1);
        let mut card = match self.option.word() {
            Some(word) => card.text(word),
            None => card.blanks(1),
        };
        for ply in &self.plies {
            if self.is_global {
                card = card.next_line().int(ply.global_id.unwrap_or(1));
            }
            card = card.int(ply.material).reals(&[ply.thickness, ply.angle_deg]).blanks(1);
        }
        card
    }

    raises!(cards: id, plies);

    fn mirrored(mut self, _: &Mirror) -> Mirrored<Self> {
        self.plies.iter_mut().for_each(|ply| ply.angle_deg = minus(ply.angle_deg));
        Ok(Some(self))
    }
}

/// MID T THETA SOUT; an empty material or thickness is that of the ply before.
fn ply(card: &Card, at: usize, before: Option<&Ply>) -> Result<Ply, InputError> {
    card.word(at + 3, "SOUT", &["YES", "NO"])?;
    let material = match (card.optional_id(at, "MID")?, before) {
        (Some(material), _) => material,
        (None, Some(ply)) => ply.material,
        (None, None) => return Err(card.empty(at, "MID", "the material of the first ply")),
    };
    let thickness = match before {
        Some(ply) if card.text(at + 1).is_empty() => ply.thickness,
        _ => card.positive(at + 1, "T")?,
    };
    Ok(Ply { material, thickness, angle_deg: card.real_or(at + 2, "THETA", 0.0)?, global_id: None })
}
