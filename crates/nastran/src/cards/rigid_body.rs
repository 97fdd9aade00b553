//! Rigid elements whose six independent motions may be those of several grids: RBAR, RBAR1, RTRPLT, RTRPLT1 and RBE1. Thermal expansion
//! is skipped.

use super::prelude::*;
use crate::card::FIELDS_PER_LINE;
use crate::real;

/// Components (digits 1 to 6) of a grid.
pub type GridComponents = (u32, Vec<u8>);

/// A rigid body: six motions determine it, others follow.
#[derive(Debug, Clone, PartialEq)]
pub struct RigidBody {
    /// Identification number.
    pub id: u32,
    /// The independent motions: six components in all, at one grid or several.
    pub independent: Vec<GridComponents>,
    /// The motions that follow.
    pub dependent: Vec<GridComponents>,
    /// Where the card stands.
    pub span: Span,
}

impl RigidBody {
    /// Its grids, each once: those with independent motions first.
    pub fn grids(&self) -> Vec<u32> {
        let mut grids: Vec<u32> = Vec::new();
        for (grid, _) in self.independent.iter().chain(&self.dependent) {
            if !grids.contains(grid) {
                grids.push(*grid);
            }
        }
        grids
    }

    /// Its name in messages, such as `RBAR 12`; one of more than two grids may be of several cards.
    pub fn name(&self) -> String {
        format!("{} {}", if self.grids().len() == 2 { "RBAR" } else { "rigid element" }, self.id)
    }

    /// Components that a list has for a grid.
    fn components(list: &[GridComponents], grid: u32) -> Vec<u8> {
        let own = list.iter().filter(|(other, _)| *other == grid);
        own.flat_map(|(_, components)| components.iter().copied()).collect()
    }

    /// RBAR and RTRPLT: EID, grids, independent components, and from `dependent_at` on dependent ones; if none are given, all that are
    /// not independent follow.
    fn of_ends(card: &Card, ends: &[char], dependent_at: usize) -> Result<Self, InputError> {
        let count = ends.len();
        let id = card.id(0, "EID")?;
        let field = |first: &str, end: usize| format!("{first}{}", ends[end]);
        let names: Vec<String> = (0..count).map(|end| field("G", end)).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let grids = card.corners(1, &names)?;
        let digits = |first: &str, at: usize| -> Result<Vec<Vec<u8>>, InputError> {
            (0..count).map(|end| card.components(at + end, &field(first, end))).collect()
        };
        let (independent, mut dependent) = (digits("CN", 1 + count)?, digits("CM", dependent_at)?);
        for end in 0..count {
            if let Some(digit) = dependent[end].iter().find(|digit| independent[end].contains(digit)) {
                let message = format!(
                    "component {digit} of {} {id} is independent and dependent at one end",
                    card.name
                );
                return Err(card.error(dependent_at + end, message));
            }
        }
        if dependent.iter().all(Vec::is_empty) {
            let rest = |own: &Vec<u8>| (1..=6).filter(|digit| !own.contains(digit)).collect();
            dependent = independent.iter().map(rest).collect();
        }
        let of_grids = |all: Vec<Vec<u8>>| {
            grids.iter().copied().zip(all).filter(|(_, components)| !components.is_empty()).collect()
        };
        Self::determined(card, 1 + count, (of_grids(independent), of_grids(dependent)))
    }

    /// RBAR1 and RTRPLT1: EID GA GB (GC) CB (CB CC): all of GA is independent; an empty list of the others is all of theirs.
    fn of_first(card: &Card, names: &[&str]) -> Result<Self, InputError> {
        let grids = card.corners(1, names)?;
        let follow = |end: usize| {
            let digits = card.components(names.len() + end, names[end])?;
            let all = (1..=6).collect();
            Ok((grids[end], if digits.is_empty() { all } else { digits }))
        };
        let dependent = (1..grids.len()).map(follow).collect::<Result<_, InputError>>()?;
        Self::determined(card, 1, (vec![(grids[0], (1..=6).collect())], dependent))
    }

    /// RBE1: EID GN1 CN1 ... UM GM1 CM1 ... ALPHA TREF.
    fn of_lists(card: &Card) -> Result<Self, InputError> {
        let is_um = |at: &usize| card.text(*at).eq_ignore_ascii_case("UM");
        let end = (1..card.len()).find(|at| real::parse(card.text(*at)).is_some()).unwrap_or(card.len());
        let Some(um) = (FIELDS_PER_LINE..end).find(is_um) else {
            let message = format!("RBE1 {} has no dependent motions", card.text(0));
            return Err(card
                .error(0, message)
                .with_help("begin a line with UM and list grids and components"));
        };
        let list = |from: usize, end: usize, grid: &str, digits: &str| {
            let (mut list, mut at) = (Vec::new(), from);
            while at < end {
                if card.text(at).is_empty() {
                    at += 1;
                } else {
                    list.push((card.id(at, grid)?, card.some_components(at + 1, digits)?));
                    at += 2;
                }
            }
            Ok::<_, InputError>(list)
        };
        Self::determined(card, 2, (list(1, um, "GN", "CN")?, list(um + 1, end, "GM", "CM")?))
    }

    /// With its six independent motions; `at` is the field to blame if there are others than six.
    fn determined(
        card: &Card,
        at: usize,
        (independent, dependent): (Vec<GridComponents>, Vec<GridComponents>),
    ) -> Result<Self, InputError> {
        let id = card.id(0, "EID")?;
        let count: usize = independent.iter().map(|(_, components)| components.len()).sum();
        if count != 6 {
            let message = format!("{} {id} has {count} independent components, not six", card.name);
            return Err(card
                .error(at, message)
                .with_help("for instance 123456 of one grid and none of the others"));
        }
        Ok(Self { id, independent, dependent, span: card.span.clone() })
    }
}

impl DeckCard for RigidBody {
    numbered!();
    // A bar, or RBE1.
    variant!(|card| usize::from(card.grids().len() != 2));

    /// RBAR: EID GA GB CNA CNB CMA CMB; RTRPLT: EID GA GB GC CNA CNB CNC blank CMA CMB CMC; the others as their readers say.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let body = match card.name.as_str() {
            "RBAR" => {
                card.ends_after(9)?;
                Self::of_ends(card, &['A', 'B'], 5)?
            }
            "RTRPLT" => {
                card.ends_after(13)?;
                Self::of_ends(card, &['A', 'B', 'C'], FIELDS_PER_LINE)?
            }
            "RBAR1" => {
                card.ends_after(6)?;
                Self::of_first(card, &["GA", "GB"])?
            }
            "RTRPLT1" => {
                card.ends_after(8)?;
                Self::of_first(card, &["GA", "GB", "GC"])?
            }
            _ => Self::of_lists(card)?,
        };
        Ok(vec![body])
    }

    fn write(&self, card: Fields) -> Fields {
        let card = card.int(self.id);
        let grids = self.grids();
        if let [a, b] = grids[..] {
            let lists = [&self.independent, &self.dependent];
            let digits = lists.into_iter().flat_map(|list| [a, b].map(|grid| Self::components(list, grid)));
            return digits.fold(card.ints([a, b]), |card, digits| card.digits(&digits));
        }
        let listed = |mut card: Fields, list: &[GridComponents]| {
            for (line, motions) in list.chunks(3).enumerate() {
                card = if line == 0 { card } else { card.next_line().blanks(1) };
                card = motions.iter().fold(card, |card, (grid, digits)| card.int(*grid).digits(digits));
            }
            card
        };
        listed(listed(card, &self.independent).next_line().text("UM"), &self.dependent)
    }

    raises!(cards: id, independent, dependent);

    own_image!();
}
