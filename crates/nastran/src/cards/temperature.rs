//! Temperatures that load a structure: of grids (TEMP, TEMPD), of bars (TEMPRB) and of plates (TEMPP1).

use super::prelude::*;
use crate::card::FIELDS_PER_LINE;

/// What a temperature card says, in the deck's degrees.
#[derive(Debug, Clone, PartialEq)]
pub enum TemperatureOf {
    /// Grids and their temperatures (TEMP).
    Grids(Vec<(u32, f64)>),
    /// All grids of which no TEMP of the set speaks (TEMPD).
    Others(f64),
    /// Bars, beams, rods and tubes (TEMPRB).
    Bars {
        /// The elements.
        elements: Vec<u32>,
        /// Mean of the section at ends A and B.
        ends: [f64; 2],
        /// Growth per length along element y (plane 1) and z (plane 2), at end A, then at end B.
        gradients: [[f64; 2]; 2],
    },
    /// Plates (TEMPP1).
    Plates {
        /// The elements.
        elements: Vec<u32>,
        /// Mean over the thickness.
        mean: f64,
        /// Growth per height along the normal.
        gradient: f64,
    },
}

/// A temperature card of a set that TEMPERATURE selects.
#[derive(Debug, Clone, PartialEq)]
pub struct Temperature {
    /// Set.
    pub set: u32,
    /// What is how warm.
    pub of: TemperatureOf,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Temperature {
    keyed!(u32, set);
    variant!(|card| match card.of {
        TemperatureOf::Grids(_) => 0,
        TemperatureOf::Others(_) => 1,
        TemperatureOf::Bars { .. } => 2,
        TemperatureOf::Plates { .. } => 3,
    });
    /// TEMP: SID G1 T1 G2 T2 G3 T3. TEMPD: SID1 T1 SID2 T2 ... TEMPRB: SID EID1 TA TB TP1A TP1B TP2A TP2B / stress points / EID2 ...
    /// TEMPP1: SID EID1 TBAR TPRIME blank TS1 TS2 / EID2 ...; temperatures of stress points are skipped.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let item = |set: u32, of: TemperatureOf| Self { set, of, span: card.span.clone() };
        if card.name == "TEMPD" {
            let places = (0..card.len().max(2)).step_by(2);
            return places
                .map(|at| Ok(item(card.id(at, "SID")?, TemperatureOf::Others(card.real(at + 1, "T")?))))
                .collect();
        }
        let set = card.id(0, "SID")?;
        if card.name == "TEMP" {
            card.ends_after(7)?;
            let places = (1..card.len().max(3)).step_by(2);
            let grids = places
                .map(|at| Ok((card.id(at, "G")?, card.real(at + 1, "T")?)))
                .collect::<Result<Vec<_>, InputError>>()?;
            return Ok(vec![item(set, TemperatureOf::Grids(grids))]);
        }
        let more_from = FIELDS_PER_LINE * if card.name == "TEMPRB" { 2 } else { 1 };
        let mut elements = vec![card.id(1, "EID1")?];
        if card.len() > more_from {
            elements.extend(card.id_list(more_from, "EID")?);
        }
        if card.name == "TEMPP1" {
            let (mean, gradient) = (card.real(2, "TBAR")?, card.real_or(3, "TPRIME", 0.0)?);
            return Ok(vec![item(set, TemperatureOf::Plates { elements, mean, gradient })]);
        }
        let ends = [card.real(2, "TA")?, card.real(3, "TB")?];
        let one = |at: usize, name: &str| card.real_or(at, name, 0.0);
        let gradients = [[one(4, "TP1A")?, one(6, "TP2A")?], [one(5, "TP1B")?, one(7, "TP2B")?]];
        Ok(vec![item(set, TemperatureOf::Bars { elements, ends, gradients })])
    }

    fn write(&self, card: Fields) -> Fields {
        let card = card.int(self.set);
        match &self.of {
            TemperatureOf::Grids(grids) => {
                grids.iter().fold(card, |card, (grid, warmth)| card.int(*grid).real(*warmth))
            }
            TemperatureOf::Others(warmth) => card.real(*warmth),
            TemperatureOf::Bars { elements, ends, gradients: [[a1, a2], [b1, b2]] } => {
                let card =
                    card.ints(elements.iter().copied().take(1)).reals(ends).reals(&[*a1, *b1, *a2, *b2]);
                if elements.len() > 1 { card.blanks(8).ints(elements.iter().copied().skip(1)) } else { card }
            }
            TemperatureOf::Plates { elements, mean, gradient } => {
                let card = card.ints(elements.iter().copied().take(1)).reals(&[*mean, *gradient]);
                card.next_line().ints(elements.iter().copied().skip(1))
            }
        }
    }

    // Sets keep their numbers.
    fn raise(&mut self, by: Step) {
        match &mut self.of {
            TemperatureOf::Grids(grids) => by.cards(grids),
            TemperatureOf::Others(_) => {}
            TemperatureOf::Bars { elements, .. } | TemperatureOf::Plates { elements, .. } => {
                by.cards(elements);
            }
        }
    }

    // An image has no case control that selects temperatures.
    no_image!();
}
