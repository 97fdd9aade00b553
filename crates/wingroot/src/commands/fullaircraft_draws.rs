//! Wings as likely as the calibrated one: the updated model's cases are flown with an aircraft of each, and 90 % intervals are of
//! envelopes taken draw by draw.

use aero::Corrections;
use calibrate::Member;
use calibrate::ensemble::interval;
use fullaircraft::cases::envelope::Extreme;
use fullaircraft::cases::list::MODELS;
use fullaircraft::{Aircraft, AircraftFile};

use crate::commands::fullaircraft_prepared::{Assembled, assembled};
use crate::corrections::CorrectedWing;
use crate::failure::Failure;
use crate::store::Shared;

/// Whose structure and surfaces an aircraft flies with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Flies {
    /// The wing as given: the initial model, and the updated one where no other structure was found.
    Given,
    /// The wing that was found: the updated model.
    Found,
    /// A wing of the ensemble.
    Draw(usize),
}

/// The ensemble of a wing and the aircraft that its wings are set into.
pub(crate) struct Draws<'a> {
    wing: Option<&'a CorrectedWing>,
    file: &'a AircraftFile,
    shared: &'a Shared,
}

/// An aircraft with a wing of the ensemble.
pub(crate) struct Draw {
    pub(crate) aircraft: Aircraft,
    pub(crate) corrections: Corrections,
}

impl<'a> Draws<'a> {
    /// Of a wing with an ensemble, or none.
    pub(crate) fn new(wing: Option<&'a CorrectedWing>, file: &'a AircraftFile, shared: &'a Shared) -> Self {
        Self { wing, file, shared }
    }

    fn members(&self) -> &[Member] {
        self.wing.and_then(|wing| wing.ensemble.as_ref()).map_or(&[], |ensemble| &ensemble.members)
    }

    /// How many there are.
    pub(crate) fn count(&self) -> usize {
        self.members().len()
    }

    /// What cases of draws depend on, as text; none without draws.
    pub(crate) fn inputs(&self) -> Option<String> {
        (self.count() > 0).then(|| format!("{:?}", self.members()))
    }

    /// Where they are from, in words; none without draws.
    pub(crate) fn from(&self) -> Option<String> {
        self.wing.and_then(CorrectedWing::intervals_from)
    }

    /// The aircraft of a draw.
    ///
    /// # Errors
    /// If it cannot be assembled.
    pub(crate) fn aircraft(&self, draw: usize) -> Result<Draw, Failure> {
        let Some((wing, member)) = self.wing.zip(self.members().get(draw)) else {
            return Err(Failure::Computation(format!("there is no wing {} of an ensemble", draw + 1)));
        };
        if !wing.file.effects.is_empty() {
            // effects join the corrections by the wing as it stands in the tunnel
            let Assembled { aircraft, corrections, .. } =
                assembled(self.file.clone(), &wing.member_in_flight(member)?, self.shared)?;
            return Ok(Draw { aircraft, corrections });
        }
        let (file, schedule) = wing.of_member(&Member { sets: member.sets_in_flight(), ..member.clone() });
        let corrections = schedule.nearest(self.file.correction_airspeed_m_s).corrections.clone();
        Ok(Draw { aircraft: Aircraft::kept(self.file.clone(), file, self.shared)?, corrections })
    }
}

/// Sets the intervals of the updated model's envelope from those of all draws; an end that a draw does not have has none.
pub(crate) fn set_intervals(envelope: &mut [Extreme], draws: &[Vec<Extreme>]) {
    if draws.is_empty() {
        return;
    }
    for extreme in envelope.iter_mut().filter(|extreme| extreme.model == MODELS[1]) {
        let of_draw =
            |draw: &Vec<Extreme>| draw.iter().find(|end| end.is_end_of(extreme)).map(|end| end.value);
        let values: Option<Vec<f64>> = draws.iter().map(of_draw).collect();
        extreme.interval_90 = values.map(|values| interval(extreme.value, &values));
    }
}
