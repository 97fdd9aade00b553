//! The aircraft of a plan in its states of loading, with the wing as given, as found, or another of its ensemble: one after the other, each made
//! when its cases come and dropped behind them.

use aero::Corrections;
use fullaircraft::{Aircraft, FlightAir, TrimTools};
use loads::design::MassCase;

use crate::commands::fullaircraft_draws::{Draw, Draws, Flies};
use crate::commands::fullaircraft_prepared::Prepared;
use crate::failure::Failure;
use crate::store::Shared;

/// An aircraft of a plan.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Frame {
    /// Its wing.
    pub(crate) flies: Flies,
    /// The state of loading.
    pub(crate) mass: usize,
}

/// See the module.
pub(crate) struct States<'a> {
    base: &'a Aircraft,
    /// With the structure that was found, if that is another.
    pub(crate) found: Option<&'a Aircraft>,
    corrections: &'a Corrections,
    masses: &'a [MassCase],
    /// The ensemble.
    pub(crate) draws: Draws<'a>,
    shared: &'a Shared,
}

/// An aircraft with what flies it.
pub(crate) struct Loaded<'b> {
    /// Variables of its trims.
    pub(crate) tools: &'b TrimTools<'b>,
    /// Its unsteady air, if that was asked for.
    pub(crate) air: Option<&'b FlightAir>,
    /// Corrections of its updated model.
    pub(crate) corrections: &'b Corrections,
}

impl<'a> States<'a> {
    /// States of loading of an aircraft; what takes long is taken from what processes share, or left there.
    pub(crate) fn new(
        prepared: &'a Prepared,
        masses: &'a [MassCase],
        draws: Draws<'a>,
        shared: &'a Shared,
    ) -> Self {
        let Prepared { aircraft: base, found, corrections, .. } = prepared;
        Self { base, found: found.as_ref(), corrections, masses, draws, shared }
    }

    /// Works with an aircraft; `moves` if its unsteady air is needed.
    ///
    /// # Errors
    /// If it cannot be made, and those of `work`.
    pub(crate) fn with<T>(
        &self,
        frame: Frame,
        moves: bool,
        work: impl FnOnce(&Loaded<'_>) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        let mass = &self.masses[frame.mass];
        let drawn = match frame.flies {
            Flies::Draw(draw) => Some(self.draws.aircraft(draw)?),
            Flies::Given | Flies::Found => None,
        };
        let (base, corrections) = match (&drawn, self.found) {
            (Some(Draw { aircraft, corrections }), _) => (aircraft, corrections),
            (None, Some(found)) if frame.flies == Flies::Found => (found, self.corrections),
            _ => (self.base, self.corrections),
        };
        let aircraft = base.loaded_kept(mass, self.shared)?;
        let air = if moves { Some(FlightAir::kept(&aircraft, self.shared)?) } else { None };
        let tools = TrimTools::new(&aircraft, &[])?;
        work(&Loaded { tools: &tools, air: air.as_ref(), corrections })
    }
}
