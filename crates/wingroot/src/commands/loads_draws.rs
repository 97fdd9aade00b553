//! Intervals of the envelope of `loads`: of envelopes taken with each wing of the ensemble.

use fullaircraft::cases::envelope::Extreme;

use crate::commands::fullaircraft_draws::set_intervals;
use crate::commands::loads_flights::Flights;
use crate::commands::loads_tables as tables;
use crate::failure::Failure;

/// Sets the intervals of the updated model's envelope; a wing at a time is read.
///
/// # Errors
/// If a case can no longer be read.
pub(crate) fn intervals(
    flights: &Flights<'_>,
    names: &[String],
    envelope: &mut [Extreme],
) -> Result<(), Failure> {
    let of_draw = |draw: usize| {
        let instants = flights.of_draw(draw)?.instants();
        Ok(tables::envelope(names, &instants, flights.matrix))
    };
    let draws = (0..flights.states.draws.count()).map(of_draw).collect::<Result<Vec<_>, Failure>>()?;
    set_intervals(envelope, &draws);
    Ok(())
}
