//! The effects of a wing's file in `fullaircraft`: those of the air join the corrections, those of control surfaces and the
//! deflection correction change what ailerons make of commands; the rest is named.

use aero::Corrections;
use coupling::wing_file::OutsideAirspeeds;
use fullaircraft::{Aircraft, AircraftError, AircraftFile, Comparison, Flown};
use maneuver::deflection::{DeflectionAt, DeflectionCorrection};
use maneuver::effects::{Active, Carried, acting_deflection, carry, of_wing};
use maneuver::motion::{MotionSpec, tidy_degrees};
use nastran::InputError;

use crate::corrections::CorrectedWing;

/// A wing's effects on their way into an aircraft.
pub(crate) struct Travelling {
    active: Vec<Active>,
    controls: Vec<String>,
    carried: Carried,
    /// The deflection correction at the airspeed of the trim; empty beside effects of control surfaces, which the wing's
    /// file does not allow together.
    deflection: DeflectionAt,
    is_corrected: bool,
}

/// The effects of a wing's file; those of the air change the corrections, at their airspeed.
pub(crate) fn travelling(
    wing: &CorrectedWing,
    file: &AircraftFile,
    corrections: &mut Corrections,
) -> Result<Travelling, InputError> {
    let controls = wing.wing.control_names();
    let active = of_wing(&wing.file, &controls)?;
    let carried = carry(&active, &wing.wing, file.correction_airspeed_m_s, corrections);
    // An aircraft flies where it flies: beyond the tunnel's airspeeds the nearest stands, as for the corrections.
    let mut tables = wing.file.deflection.clone();
    for table in &mut tables {
        table.outside = OutsideAirspeeds::Nearest;
    }
    let is_corrected = !tables.is_empty();
    let deflection = DeflectionCorrection::new(tables).at(file.trim.v_m_s)?;
    Ok(Travelling { active, controls, carried, deflection, is_corrected })
}

impl Travelling {
    /// What the user should know.
    pub(crate) fn remarks(&self, file: &AircraftFile) -> Vec<String> {
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
        let mut remarks: Vec<String> =
            said.map(|(names, what)| format!("effects of the wing: {} {what}", names.join(", "))).collect();
        for (name, motion) in [("doublet", &file.doublet), ("chirp", &file.chirp)] {
            let Some(control) = motion.control().filter(|_| self.is_corrected) else { continue };
            let commanded_deg = tidy_degrees(motion.kind().height());
            let acting_deg = self.acting_deg(control, file.trim.v_m_s, commanded_deg);
            remarks.push(format!(
                "the wing's deflection correction makes {acting_deg:.2} of the {commanded_deg} degrees of the \
                 updated aircraft's {name}"
            ));
            let commanded = [commanded_deg.to_radians(), -commanded_deg.to_radians()];
            remarks.extend(self.deflection.beyond(control, &commanded).map(|beyond| beyond.to_string()));
        }
        remarks
    }

    /// What the ailerons make of an amplitude, degrees: the mean of both signs, as one side goes up when the other goes down.
    fn acting_deg(&self, control: &str, v_m_s: f64, commanded_deg: f64) -> f64 {
        let radians = commanded_deg.to_radians();
        let factors = [radians, -radians].map(|delta| self.deflection.factor(control, delta));
        let commanded_deg = commanded_deg * (0.5 * (factors[0] + factors[1]));
        let radians = commanded_deg.to_radians();
        let acting = acting_deflection(&self.active, &self.controls, control, v_m_s, radians);
        if acting.to_bits() == radians.to_bits() { commanded_deg } else { acting.to_degrees() }
    }

    /// What the surfaces make of doublet and chirp, which reach as far as they let them: a sine keeps its shape.
    fn acting(&self, aircraft: &Aircraft) -> [MotionSpec; 2] {
        let v_m_s = aircraft.file.trim.v_m_s;
        [&aircraft.file.doublet, &aircraft.file.chirp].map(|motion| {
            let commanded_deg = tidy_degrees(motion.kind().height());
            let acting_deg = self.acting_deg(motion.control().unwrap_or_default(), v_m_s, commanded_deg);
            motion.clone().with_height(acting_deg.to_radians())
        })
    }

    /// Flies both models, the updated one with the aircraft whose structure was `found`, if that is another.
    pub(crate) fn compare(
        &self,
        aircraft: &Aircraft,
        found: Option<&Aircraft>,
        corrections: &Corrections,
    ) -> Result<Comparison, AircraftError> {
        let [doublet, chirp] = self.acting(aircraft);
        aircraft.compare_acting(found, corrections, [&doublet, &chirp])
    }

    /// Flies the updated model alone.
    pub(crate) fn fly(&self, aircraft: &Aircraft, corrections: &Corrections) -> Result<Flown, AircraftError> {
        let [doublet, chirp] = self.acting(aircraft);
        aircraft.fly_acting(corrections, &doublet, &chirp)
    }
}
