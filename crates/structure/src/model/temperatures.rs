//! How warm grids and elements are: the temperatures of a set above those at which nothing has expanded.

use nastran::{BulkData, InputError, Span, TemperatureOf, Unread};
use std::collections::BTreeMap;

/// Temperatures that are not read, and would be missing if a set had some.
const UNREAD: &[&str] =
    &["TEMPP2", "TEMPP3", "TEMPP4", "TEMPG", "TEMPBC", "TEMPF", "TEMPN1", "TEMPAX", "TEMPIC"];

/// What the cards of a set say.
#[derive(Default)]
struct Field {
    grids: BTreeMap<u32, f64>,
    others: Option<f64>,
    /// Means at the ends; gradients in the two planes at end A, then B.
    bars: BTreeMap<u32, ([f64; 2], [[f64; 2]; 2])>,
    /// Mean and gradient.
    plates: BTreeMap<u32, [f64; 2]>,
}

/// Temperatures of a set above an initial one, or above those of reference.
pub(super) struct Warmth {
    set: u32,
    now: Field,
    initial: Option<(u32, Field)>,
}

impl Warmth {
    /// Of the sets that a subcase selects.
    ///
    /// # Errors
    /// If a set is not there, has temperatures that are not read, or materials change with the temperature.
    pub(super) fn of(bulk: &BulkData, load: u32, initial: Option<u32>) -> Result<Self, InputError> {
        bulk.refuse_warm_materials()?;
        let initial = initial.map(|set| Ok((set, Field::of(bulk, set)?))).transpose()?;
        Ok(Self { set: load, now: Field::of(bulk, load)?, initial })
    }

    /// Of each of some grids.
    pub(super) fn grids(
        &self,
        grids: &[u32],
        reference: f64,
        user: &str,
        span: &Span,
    ) -> Result<Vec<f64>, InputError> {
        let before = |grid: u32| match &self.initial {
            Some((set, field)) => field.at(grid, *set, user, span),
            None => Ok(reference),
        };
        grids.iter().map(|grid| Ok(self.now.at(*grid, self.set, user, span)? - before(*grid)?)).collect()
    }

    /// Mean of some grids before now.
    fn before(&self, grids: &[u32], reference: f64, user: &str, span: &Span) -> Result<f64, InputError> {
        let Some((set, field)) = &self.initial else { return Ok(reference) };
        let all =
            grids.iter().map(|grid| field.at(*grid, *set, user, span)).collect::<Result<Vec<_>, _>>()?;
        Ok(all.iter().sum::<f64>() / (all.len() as f64))
    }

    /// Mean of a bar, and its gradients in the two planes at both ends.
    pub(super) fn bar(
        &self,
        id: u32,
        grids: &[u32],
        reference: f64,
        user: &str,
        span: &Span,
    ) -> Result<(f64, [[f64; 2]; 2]), InputError> {
        if let Some((ends, gradients)) = self.now.bars.get(&id) {
            return Ok((0.5 * (ends[0] + ends[1]) - self.before(grids, reference, user, span)?, *gradients));
        }
        let rises = self.grids(grids, reference, user, span)?;
        Ok((0.5 * (rises[0] + rises[1]), [[0.0; 2]; 2]))
    }

    /// Mean and gradient of a plate.
    pub(super) fn plate(
        &self,
        id: u32,
        grids: &[u32],
        reference: f64,
        user: &str,
        span: &Span,
    ) -> Result<[f64; 2], InputError> {
        if let Some([mean, gradient]) = self.now.plates.get(&id) {
            return Ok([mean - self.before(grids, reference, user, span)?, *gradient]);
        }
        let rises = self.grids(grids, reference, user, span)?;
        Ok([rises.iter().sum::<f64>() / (rises.len() as f64), 0.0])
    }
}

impl Field {
    fn of(bulk: &BulkData, set: u32) -> Result<Self, InputError> {
        let is_meant = |(name, unread): &(&String, &Unread)| {
            UNREAD.contains(&name.as_str()) && unread.numbers.contains(&set)
        };
        if let Some((name, unread)) = bulk.unknown.iter().find(is_meant) {
            let message =
                format!("{name} is a temperature that is not read: leaving it out would change the loads");
            return Err(
                InputError::at(&unread.first, message).with_help("TEMP, TEMPD, TEMPRB and TEMPP1 are read")
            );
        }
        let mut field = Self::default();
        let mut any = false;
        for card in bulk.temperatures.iter().filter(|card| card.set == set) {
            any = true;
            match &card.of {
                TemperatureOf::Grids(grids) => field.grids.extend(grids.iter().copied()),
                TemperatureOf::Others(warmth) => field.others = Some(*warmth),
                TemperatureOf::Bars { elements, ends, gradients } => {
                    field.bars.extend(elements.iter().map(|id| (*id, (*ends, *gradients))));
                }
                TemperatureOf::Plates { elements, mean, gradient } => {
                    field.plates.extend(elements.iter().map(|id| (*id, [*mean, *gradient])));
                }
            }
        }
        if any {
            return Ok(field);
        }
        let message = format!("the case control selects temperatures of set {set}, which is not there");
        Err(InputError::general(message).with_help("TEMP, TEMPD, TEMPRB and TEMPP1 are read"))
    }

    fn at(&self, grid: u32, set: u32, user: &str, span: &Span) -> Result<f64, InputError> {
        self.grids.get(&grid).copied().or(self.others).ok_or_else(|| {
            let message = format!("{user} expands, and its GRID {grid} has no temperature in set {set}");
            InputError::at(span, message).with_help("give it by TEMP, or one for all grids by TEMPD")
        })
    }
}
