//! Random gusts: power spectral densities, root mean squares and crossings of zero (RANDPS, TABRND1, TABRNDG).
//!
//! ```text
//! S_y = sum_jk Re[S_jk y_j conj(y_k)],   A² = int S_y df,   N0² = int f² S_y df/A²
//! ```
//! The densities are straight lines between the frequencies, as Nastran integrates them.

use super::{DynamicAnswer, GustCase, GustDeck, GustLoads};
use crate::error::AircraftError;
use faer::c64;
use loads::design::Spectrum;
use nastran::{BulkData, InputError, Randps, SpectrumShape};
use std::f64::consts::TAU;

/// A solved subcase.
#[derive(Debug)]
pub struct DeckGust<'a> {
    /// What it asks for.
    pub case: &'a GustCase,
    /// Its structure and air.
    pub deck: &'a GustDeck,
    /// Its answer.
    pub answer: &'a DynamicAnswer,
}

/// One quantity in random gusts.
#[derive(Debug, Clone, PartialEq)]
pub struct RandomAnswer {
    /// Density at each frequency, the quantity's unit squared per Hz.
    pub density: Vec<f64>,
    /// Root mean square.
    pub rms: f64,
    /// Crossings of zero upwards, Hz; none where nothing moves.
    pub n0_hz: Option<f64>,
}

/// The answers of the subcases that a set of RANDPS joins.
#[derive(Debug)]
pub struct RandomSet<'a> {
    /// Frequencies, Hz.
    pub hz: Vec<f64>,
    terms: Vec<Term<'a>>,
}

/// One card.
#[derive(Debug)]
struct Term<'a> {
    pair: [&'a DeckGust<'a>; 2],
    /// S_jk at each frequency.
    density: Vec<c64>,
}

impl RandomAnswer {
    /// Of densities over frequencies.
    fn new(hz: &[f64], density: Vec<f64>) -> Self {
        let (mut area, mut second) = (0.0, 0.0);
        for i in 1..hz.len() {
            let (a, b, step) = (hz[i - 1], hz[i], hz[i] - hz[i - 1]);
            let (s1, s2) = (density[i - 1], density[i]);
            area += 0.5 * step * (s1 + s2);
            // int f² S of a straight line, exactly
            second += step
                * (s1 * (3.0 * a * a + 2.0 * a * b + b * b) + s2 * (a * a + 2.0 * a * b + 3.0 * b * b))
                / 12.0;
        }
        let (area, second) = (area.max(0.0), second.max(0.0));
        let n0_hz = (area > 0.0).then(|| (second / area).sqrt());
        Self { density, rms: area.sqrt(), n0_hz }
    }
}

impl<'a> DeckGust<'a> {
    /// The densities of a set of RANDPS on solved subcases; none if no card of it names one of them.
    ///
    /// # Errors
    /// If there is no such set, a subcase or density of it is not there, or subcases differ in frequencies or boundary conditions.
    pub fn random(
        bulk: &'a BulkData,
        set: u32,
        solved: &'a [DeckGust<'a>],
    ) -> Result<RandomSet<'a>, AircraftError> {
        let cards: Vec<&Randps> = bulk.spectra.iter().filter(|card| card.set == set).collect();
        let Some(first) = cards.first() else {
            let message = format!("the case control selects RANDOM {set}, which is not there");
            return Err(InputError::general(message).with_help("give it as RANDPS cards").into());
        };
        let find = |card: &Randps, id: u32| {
            let found = solved.iter().find(|gust| gust.case.subcase.id == id);
            let missing = || {
                let message = format!("RANDPS {set} names subcase {id}, which no gust or load excites");
                InputError::at(&card.span, message)
            };
            let gust = found.ok_or_else(missing)?;
            if gust.case.times_s.is_some() {
                let message = format!("RANDPS {set} names subcase {id}, whose excitation is given in time");
                return Err(InputError::at(&card.span, message)
                    .with_help("give it over frequency: RLOAD1 with amplitude one"));
            }
            Ok(gust)
        };
        let hz = find(first, first.subcases[0])?.case.hz.clone();
        let mut terms = Vec::new();
        for card in cards {
            let pair = [find(card, card.subcases[0])?, find(card, card.subcases[1])?];
            let is_other =
                |gust: &&DeckGust<'_>| gust.case.hz != hz || !std::ptr::eq(gust.deck, pair[0].deck);
            if pair.iter().any(is_other) {
                let message =
                    format!("the subcases of RANDPS {set} differ in frequencies or boundary conditions");
                return Err(InputError::at(&card.span, message)
                    .with_help("select one FREQUENCY, SPC, MPC and METHOD for all of them")
                    .into());
            }
            let factor = c64::new(card.factor[0], card.factor[1]);
            let density = hz.iter().map(|hz| Ok(factor * density(bulk, card, *hz)?));
            terms.push(Term { pair, density: density.collect::<Result<_, InputError>>()? });
        }
        Ok(RandomSet { hz, terms })
    }
}

impl RandomSet<'_> {
    /// Of a displacement (`acceleration` false) or acceleration, a component (0 to 5) of a grid.
    pub fn of_grid(&self, grid: u32, component: usize, acceleration: bool) -> Option<RandomAnswer> {
        let shapes = self.terms.first()?.pair[0].deck.shapes_at(grid)?;
        Some(self.of(&|answer, n| {
            let x: c64 = answer.modal[n].iter().enumerate().map(|(j, x)| *x * shapes[(component, j)]).sum();
            if acceleration { x * -(TAU * answer.hz[n]).powi(2) } else { x }
        }))
    }

    /// Of the total load of a station, a component (0 to 5).
    pub fn of_station(&self, station: usize, component: usize) -> RandomAnswer {
        self.of(&|answer, n| GustLoads::total(&answer.stations[n][station], component))
    }

    fn of(&self, value: &dyn Fn(&DynamicAnswer, usize) -> c64) -> RandomAnswer {
        let at = |n: usize| -> f64 {
            let of = |term: &Term<'_>| {
                let [j, k] = term.pair;
                let product = term.density[n] * value(j.answer, n) * value(k.answer, n).conj();
                // S_kj is the conjugate of S_jk, and both count.
                if std::ptr::eq(j, k) { product.re } else { 2.0 * product.re }
            };
            self.terms.iter().map(of).sum()
        };
        RandomAnswer::new(&self.hz, (0..self.hz.len()).map(at).collect())
    }
}

/// The density of a card's table, per Hz.
fn density(bulk: &BulkData, card: &Randps, hz: f64) -> Result<f64, InputError> {
    if card.table == 0 {
        return Ok(1.0);
    }
    let table = bulk.spectrum_tables.get(&card.table).ok_or_else(|| {
        let message = format!("TABRND1 or TABRNDG {} of RANDPS {} is not there", card.table, card.set);
        InputError::at(&card.span, message)
    })?;
    Ok(match &table.shape {
        SpectrumShape::Points { is_log, points } => SpectrumShape::of_points(points, *is_log, hz),
        SpectrumShape::Turbulence { is_karman, scale_s, rms } => {
            let spectrum = if *is_karman { Spectrum::Karman } else { Spectrum::Dryden };
            // The rule's density is over wave numbers; with scale and wave number both over the airspeed it is over omega.
            rms * rms * TAU * spectrum.density(TAU * hz, *scale_s)
        }
    })
}

#[cfg(test)]
mod tests;
