//! The effects of a wing's file in `fullaircraft`: those of the air join the corrections, those of control surfaces change
//! what ailerons make of commands; the rest is named.

use aero::Corrections;
use fullaircraft::{Aircraft, AircraftError, AircraftFile, Comparison};
use maneuver::effects::{Active, Carried, acting_deflection, carry, of_wing};
use nastran::InputError;

use crate::corrections::CorrectedWing;

/// A wing's effects on their way into an aircraft.
pub(crate) struct Travelling {
    active: Vec<Active>,
    controls: Vec<String>,
    carried: Carried,
}

/// The effects of a wing's file; those of the air change the corrections, at their airspeed.
pub(crate) fn travelling(
    wing: &CorrectedWing,
    file: &AircraftFile,
    corrections: &mut Corrections,
) -> Result<Travelling, InputError> {
    let controls: Vec<String> = wing.wing.controls.iter().map(|control| control.name.clone()).collect();
    let active = of_wing(&wing.file, &controls)?;
    let carried = carry(&active, &wing.wing, file.correction_airspeed_m_s, corrections);
    Ok(Travelling { active, controls, carried })
}

impl Travelling {
    /// What the user should know.
    pub(crate) fn remarks(&self) -> Vec<String> {
        let Carried { carried, tunnel, left } = &self.carried;
        let what = [
            (carried, "act on the updated aircraft"),
            (tunnel, "belong to tunnel, balance or sensors and stay there"),
            (
                left,
                "would act in flight, but corrections and deflections cannot carry them: they are left out",
            ),
        ];
        let said = what.into_iter().filter(|(names, _)| !names.is_empty());
        said.map(|(names, what)| format!("effects of the wing: {} {what}", names.join(", "))).collect()
    }

    /// What the ailerons make of an amplitude, degrees.
    fn acting_deg(&self, control: &str, v_m_s: f64, commanded_deg: f64) -> f64 {
        let radians = commanded_deg.to_radians();
        let acting = acting_deflection(&self.active, &self.controls, control, v_m_s, radians);
        if acting.to_bits() == radians.to_bits() { commanded_deg } else { acting.to_degrees() }
    }

    /// Flies both models; commands of the updated one reach as far as its effects let them: a sine keeps its shape.
    pub(crate) fn compare(
        &self,
        aircraft: &mut Aircraft,
        corrections: &Corrections,
    ) -> Result<Comparison, AircraftError> {
        let comparison = aircraft.compare(corrections)?;
        let commanded = aircraft.file.clone();
        let v_m_s = commanded.trim.v_m_s;
        let (doublet, chirp) = (&mut aircraft.file.doublet, &mut aircraft.file.chirp);
        doublet.amplitude_deg = self.acting_deg(&doublet.control, v_m_s, doublet.amplitude_deg);
        chirp.amplitude_deg = self.acting_deg(&chirp.control, v_m_s, chirp.amplitude_deg);
        if aircraft.file == commanded {
            return Ok(comparison);
        }
        let acting = aircraft.compare(corrections);
        aircraft.file = commanded;
        Ok(Comparison { updated: acting?.updated, ..comparison })
    }
}
