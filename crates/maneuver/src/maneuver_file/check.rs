//! What a maneuver must satisfy: numbers that can be, what the wing can do, and what deserves a remark.

use super::{ActuatorChoice, ManeuverFile};
use crate::motion::{ANGLE, Fault, MotionSpec};
use crate::run::AIRSPEEDS_M_S;
use coupling::WingFile;
use nastran::suggest::nearest;
use nastran::{InputError, place_of, read_text};

/// Largest deflection of a control surface whose limit the wing's file does not give, degrees (assumed).
pub const DEFAULT_LIMIT_DEG: f64 = 30.0;
/// Most samples.
const MOST_SAMPLES: f64 = 1e6;
/// A commanded deflection may exceed its limit by this share: rounding.
const ROUNDING: f64 = 1e-9;

/// An error at a field of the maneuver itself, or (with a number) of its motion.
fn refuse(file: &ManeuverFile, motion: Option<usize>, field: &str, message: &str, help: &str) -> InputError {
    let anchor = format!("{field}:");
    let mut anchors: Vec<&str> = motion.iter().map(|_| "motions:").collect();
    for spec in motion.iter().flat_map(|&number| &file.motions[..=number]) {
        anchors.push(spec.shape.name());
    }
    anchors.push(&anchor);
    // The file was read before; should it be gone, its name has to do.
    let text = read_text(&file.path).unwrap_or_default();
    InputError::at(&place_of(&anchors, &text, &file.path), message).with_help(help)
}

/// Numbers that cannot be.
pub(super) fn numbers(file: &ManeuverFile) -> Result<(), InputError> {
    let &ManeuverFile { v_m_s, rho_kg_m3, alpha_deg, sample_rate_hz, length_s, actuator, .. } = file;
    let samples = length_s * sample_rate_hz;
    let alpha = alpha_deg.unwrap_or(0.0);
    let mut rules = vec![
        (
            "V_m_s",
            AIRSPEEDS_M_S.contains(&v_m_s),
            format!("the airspeed {v_m_s:?} m/s is not within 0 to {} m/s", AIRSPEEDS_M_S.end()),
            "zero is a wind-off run",
        ),
        (
            "rho_kg_m3",
            rho_kg_m3 > 0.0 && rho_kg_m3 < 100.0,
            format!("rho_kg_m3 is {rho_kg_m3:?}"),
            "air at sea level has 1.225 kg/m3",
        ),
        (
            "alpha_deg",
            alpha.abs() <= 90.0,
            format!("alpha_deg is {alpha:?}, beyond 90 degrees"),
            "angles are in degrees",
        ),
        (
            "sample_rate_hz",
            sample_rate_hz > 0.0 && sample_rate_hz <= 1e5,
            format!("sample_rate_hz is {sample_rate_hz:?}, expected a number up to 100000"),
            "200 samples a second are usual",
        ),
        (
            "length_s",
            length_s > 0.0 && length_s.is_finite(),
            format!("the length {length_s:?} s is not above zero"),
            "the time from the first sample to the last",
        ),
        (
            "length_s",
            (2.0..=MOST_SAMPLES).contains(&samples),
            format!(
                "{length_s:?} s at {sample_rate_hz:?} Hz are {samples:.0} samples, expected 3 to a million"
            ),
            "change length_s or sample_rate_hz",
        ),
    ];
    if let ActuatorChoice::SecondOrder { frequency_hz, damping_ratio } = actuator {
        rules.push((
            "actuator",
            frequency_hz > 0.0 && frequency_hz <= 1e4 && damping_ratio > 0.0 && damping_ratio <= 10.0,
            format!("an actuator of {frequency_hz:?} Hz and a damping ratio of {damping_ratio:?}"),
            "both are above zero; without `actuator` the servos are those of the wing's file",
        ));
    }
    if let Some((field, _, message, help)) = rules.iter().find(|(_, holds, ..)| !holds) {
        return Err(refuse(file, None, field, message, help));
    }
    let fault =
        |(number, spec): (usize, &MotionSpec)| spec.fault(sample_rate_hz).map(|fault| (Some(number), fault));
    match file.motions.iter().enumerate().find_map(fault) {
        Some((number, Fault { field, message, help })) => Err(refuse(file, number, field, &message, help)),
        None => Ok(()),
    }
}

/// The angle of attack comes from `alpha_deg` or from a file.
pub(super) fn angle_is_given_once(file: &ManeuverFile) -> Result<(), InputError> {
    let columns = file.motions.iter().flat_map(|spec| spec.kind().columns());
    let own = columns.filter(|column| column.of == ANGLE).count();
    match (file.alpha_deg, own) {
        (Some(_), 0) | (None, 1) => Ok(()),
        (None, 0) => Err(InputError::in_file(&file.path, "the field `alpha_deg` is missing")
            .with_help("the angle of attack at the beginning, degrees")),
        _ => Err(refuse(
            file,
            None,
            "alpha_deg",
            "the angle of attack is given more than once",
            "a column alpha_deg of a file is the angle itself: leave `alpha_deg` out, and have one such column",
        )),
    }
}

impl ManeuverFile {
    /// Checks the maneuver against a wing and gives what deserves a remark.
    ///
    /// # Errors
    /// An unknown control surface, a deflection beyond its limit ([`DEFAULT_LIMIT_DEG`] if the wing's file gives none),
    /// a jump in a commanded deflection without an actuator.
    pub fn checked(&self, wing: &WingFile, controls: &[String]) -> Result<Vec<String>, InputError> {
        let mut remarks = Vec::new();
        for (number, spec) in self.motions.iter().enumerate() {
            for column in spec.kind().columns().iter().filter(|column| column.of != ANGLE) {
                known(&column.of, controls)
                    .map_err(|(message, help)| InputError::at(&column.span, message).with_help(help))?;
            }
            if let Some(of) = &spec.of {
                remarks.extend(self.checked_motion(number, of, controls)?);
            }
            let (kind, end_s, length_s) = (spec.shape.name(), spec.end_s(), self.length_s);
            if spec.kind().columns().is_empty() {
                if end_s > length_s * (1.0 + ROUNDING) {
                    remarks.push(format!("{kind} ends at {end_s} s, the maneuver at {length_s} s already"));
                }
            } else if end_s < length_s - 0.5 / self.sample_rate_hz {
                remarks.push(format!(
                    "a signal from a file ends at {end_s} s; its last value is kept to {length_s} s"
                ));
            }
        }
        controls.iter().try_for_each(|name| self.within_limit(name, wing))?;
        Ok(remarks)
    }

    /// One declared motion.
    fn checked_motion(
        &self,
        number: usize,
        of: &str,
        controls: &[String],
    ) -> Result<Option<String>, InputError> {
        let spec = &self.motions[number];
        let (kind, jumps) = (spec.shape.name(), spec.kind().jumps());
        if of == ANGLE {
            let rounded = "of the angle of attack jumps; it is rounded as a measured angle is smoothed";
            return Ok(jumps.then(|| format!("{kind} {rounded}")));
        }
        known(of, controls).map_err(|(message, help)| refuse(self, Some(number), "of", &message, &help))?;
        if jumps && self.actuator == ActuatorChoice::None {
            let message = format!("{kind} of {of} jumps, and there is no actuator");
            let help = "no surface jumps: leave `actuator: None` out, or let it move smoothly";
            return Err(refuse(self, Some(number), "of", &message, help));
        }
        Ok(None)
    }

    fn within_limit(&self, control: &str, wing: &WingFile) -> Result<(), InputError> {
        let known = wing.deflection_limit_deg(control);
        let limit = known.unwrap_or(DEFAULT_LIMIT_DEG);
        let largest =
            self.sampled(control, |_| true).into_iter().fold(0.0, |most: f64, delta| most.max(delta.abs()));
        if largest.to_degrees() <= limit * (1.0 + ROUNDING) {
            return Ok(());
        }
        let moves = |spec: &MotionSpec| spec.of.as_deref() == Some(control);
        let number = self.motions.iter().position(moves);
        let whose = if known.is_some() {
            "its limit in the wing's file"
        } else {
            "assumed, as the wing's file gives no limit"
        };
        let message = format!(
            "{control} is deflected by {:.2} degrees, beyond {limit} degrees ({whose})",
            largest.to_degrees()
        );
        let help = "lower height_deg, or write the surface's `limit_deg` in the wing's file";
        Err(refuse(self, number, if number.is_some() { "height_deg" } else { "motions" }, &message, help))
    }
}

/// Complains about a control surface that the wing does not have.
fn known(name: &str, controls: &[String]) -> Result<(), (String, String)> {
    if controls.iter().any(|control| control == name) {
        return Ok(());
    }
    let names = controls.iter().map(String::as_str).chain([ANGLE]);
    let help = match nearest(name, names) {
        Some(meant) => format!("did you mean \"{meant}\"?"),
        None => format!("what can move: alpha, {}", controls.join(", ")),
    };
    Err((format!("the maneuver moves \"{name}\", which the wing does not have"), help))
}

#[cfg(test)]
mod tests;
