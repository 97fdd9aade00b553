//! What a maneuver must satisfy: numbers that can be, what the wing can do, and what deserves a remark.

use super::own_signal::OwnSignal;
use super::{ActuatorChoice, ManeuverFile, MotionSpec};
use crate::rig_model::RigModel;
use coupling::WingFile;
use nastran::suggest::nearest;
use nastran::{InputError, place_of, read_text};

/// Largest deflection of a control surface whose limit the wing's file does not give, degrees (assumed).
pub const DEFAULT_LIMIT_DEG: f64 = 30.0;
/// Largest airspeed, m/s: the air is taken as incompressible.
const FASTEST_M_S: f64 = 340.0;
/// Most samples.
const MOST_SAMPLES: f64 = 1e6;
/// A commanded deflection may exceed its limit by this share: rounding.
const ROUNDING: f64 = 1e-9;
/// Real part over modulus of an eigenvalue that is called unstable: rounding is far below.
const GROWTH: f64 = 1e-6;

/// An error at a field of the maneuver itself, or (with a number) of its motion.
fn refuse(file: &ManeuverFile, motion: Option<usize>, field: &str, message: &str, help: &str) -> InputError {
    let anchor = format!("{field}:");
    let mut anchors: Vec<&str> = motion.iter().map(|_| "motions:").collect();
    for spec in motion.iter().flat_map(|&number| &file.motions[..=number]) {
        anchors.push(spec.kind());
    }
    anchors.push(&anchor);
    // The file was read before; should it be gone, its name has to do.
    let text = read_text(&file.path).unwrap_or_default();
    InputError::at(&place_of(&anchors, &text, &file.path), message).with_help(help)
}

/// Numbers that cannot be.
pub(super) fn numbers(file: &ManeuverFile) -> Result<(), InputError> {
    let fail = |field: &str, message: String, help: &str| Err(refuse(file, None, field, &message, help));
    if !(0.0..=FASTEST_M_S).contains(&file.v_m_s) {
        let message = format!("the airspeed {:?} m/s is not within 0 to {FASTEST_M_S} m/s", file.v_m_s);
        return fail("V_m_s", message, "zero is a wind-off run");
    }
    if !(file.rho_kg_m3 > 0.0 && file.rho_kg_m3 < 100.0) {
        return fail(
            "rho_kg_m3",
            format!("rho_kg_m3 is {:?}", file.rho_kg_m3),
            "air at sea level has 1.225 kg/m3",
        );
    }
    if let Some(alpha) = file.alpha_deg.filter(|alpha| alpha.is_nan() || alpha.abs() > 90.0) {
        return fail(
            "alpha_deg",
            format!("alpha_deg is {alpha:?}, beyond 90 degrees"),
            "angles are in degrees",
        );
    }
    if !(file.sample_rate_hz > 0.0 && file.sample_rate_hz <= 1e5) {
        let message = format!("sample_rate_hz is {:?}, expected a number up to 100000", file.sample_rate_hz);
        return fail("sample_rate_hz", message, "200 samples a second are usual");
    }
    if !(file.length_s > 0.0 && file.length_s.is_finite()) {
        let message = format!("the length {:?} s is not above zero", file.length_s);
        return fail("length_s", message, "the time from the first sample to the last");
    }
    let samples = file.length_s * file.sample_rate_hz;
    if !(2.0..=MOST_SAMPLES).contains(&samples) {
        let message = format!(
            "{:?} s at {:?} Hz are {samples:.0} samples, expected 3 to a million",
            file.length_s, file.sample_rate_hz
        );
        return fail("length_s", message, "change length_s or sample_rate_hz");
    }
    if let ActuatorChoice::SecondOrder { frequency_hz, damping_ratio } = file.actuator
        && !(frequency_hz > 0.0 && frequency_hz <= 1e4 && damping_ratio > 0.0 && damping_ratio <= 10.0)
    {
        let message = format!("an actuator of {frequency_hz:?} Hz and a damping ratio of {damping_ratio:?}");
        let help = "both are above zero; 15 Hz and 0.8 are assumed if nothing is said";
        return fail("actuator", message, help);
    }
    (0..file.motions.len()).try_for_each(|number| motion_numbers(file, number))
}

/// Numbers of one motion that cannot be.
fn motion_numbers(file: &ManeuverFile, number: usize) -> Result<(), InputError> {
    let spec = &file.motions[number];
    let fail =
        |field: &str, message: String, help: &str| Err(refuse(file, Some(number), field, &message, help));
    if !(spec.start_s() >= 0.0 && spec.start_s().is_finite()) {
        let message = format!("{} starts at {:?} s, before the maneuver", spec.kind(), spec.start_s());
        return fail("start_s", message, "time counts from the first sample");
    }
    let (height, times) = match *spec {
        MotionSpec::OneMinusCosine { height_deg, frequency_hz, .. }
        | MotionSpec::Doublet { height_deg, frequency_hz, .. } => {
            (height_deg, Some(("frequency_hz", frequency_hz)))
        }
        MotionSpec::Chirp { height_deg, duration_s, .. } => (height_deg, Some(("duration_s", duration_s))),
        MotionSpec::Step { height_deg, .. } => (height_deg, None),
        MotionSpec::ThreeTwoOneOne { height_deg, unit_s, .. } => (height_deg, Some(("unit_s", unit_s))),
        MotionSpec::FromFile { .. } => (0.0, None),
    };
    if height.is_nan() || height.abs() > 90.0 {
        return fail(
            "height_deg",
            format!("height_deg is {height:?}, beyond 90 degrees"),
            "angles are in degrees",
        );
    }
    if let Some((field, value)) = times.filter(|(_, value)| !(*value > 0.0 && value.is_finite())) {
        let message = format!("{field} of {} is {value:?}, expected a number above zero", spec.kind());
        return fail(field, message, "the unit is in the field's name");
    }
    let half = 0.5 * file.sample_rate_hz;
    if let Some((field, hz)) = spec.frequencies().into_iter().find(|(_, hz)| !(0.0..=half).contains(hz)) {
        let message = format!(
            "{} has {hz} Hz, expected 0 to {half} Hz, half the sampling rate of {} Hz",
            spec.kind(),
            file.sample_rate_hz
        );
        return fail(field, message, "raise sample_rate_hz, or lower the frequency");
    }
    Ok(())
}

/// The angle of attack comes from `alpha_deg` or from a file.
pub(super) fn angle_is_given_once(file: &ManeuverFile) -> Result<(), InputError> {
    let own = file.own.iter().flat_map(|own| &own.columns).filter(|(name, ..)| name == "alpha").count();
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
        let mut own = self.own.iter();
        for (number, spec) in self.motions.iter().enumerate() {
            match spec.of() {
                Some(of) => remarks.extend(self.checked_motion(number, of, controls)?),
                None => {
                    remarks.extend(
                        own.next().map(|own| self.checked_own(own, spec, controls)).transpose()?.flatten(),
                    );
                }
            }
            if let Some(end) = spec.end_s().filter(|end| *end > self.length_s * (1.0 + ROUNDING)) {
                let (kind, length) = (spec.kind(), self.length_s);
                remarks.push(format!("{kind} ends at {end} s, the maneuver at {length} s already"));
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
        if of == "alpha" {
            let rounded = "of the angle of attack jumps; it is rounded as a measured angle is smoothed";
            return Ok(spec.jumps().then(|| format!("{} {rounded}", spec.kind())));
        }
        known(of, controls).map_err(|(message, help)| refuse(self, Some(number), "of", &message, &help))?;
        if spec.jumps() && self.actuator == ActuatorChoice::None {
            let message = format!("{} of {of} jumps, and there is no actuator", spec.kind());
            let help = "no surface jumps: leave `actuator: None` out, or use OneMinusCosine";
            return Err(refuse(self, Some(number), "of", &message, help));
        }
        Ok(None)
    }

    /// A user's own signal.
    fn checked_own(
        &self,
        own: &OwnSignal,
        spec: &MotionSpec,
        controls: &[String],
    ) -> Result<Option<String>, InputError> {
        for (name, span, _) in own.columns.iter().filter(|(name, ..)| name != "alpha") {
            known(name, controls).map_err(|(message, help)| InputError::at(span, message).with_help(help))?;
        }
        let end = own.t_s[own.t_s.len() - 1] + spec.start_s();
        let early = end < self.length_s - 0.5 / self.sample_rate_hz;
        let length = self.length_s;
        Ok(early
            .then(|| format!("a signal from a file ends at {end} s; its last value is kept to {length} s")))
    }

    fn within_limit(&self, control: &str, wing: &WingFile) -> Result<(), InputError> {
        let known = wing.deflection_limit_deg(control);
        let limit = known.unwrap_or(DEFAULT_LIMIT_DEG);
        let largest =
            self.sampled(control, |_| true).into_iter().fold(0.0, |most: f64, delta| most.max(delta.abs()));
        if largest.to_degrees() <= limit * (1.0 + ROUNDING) {
            return Ok(());
        }
        let moves = |spec: &MotionSpec| spec.of() == Some(control);
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
    let names = controls.iter().map(String::as_str).chain(["alpha"]);
    let help = match nearest(name, names) {
        Some(meant) => format!("did you mean \"{meant}\"?"),
        None => format!("what can move: alpha, {}", controls.join(", ")),
    };
    Err((format!("the maneuver moves \"{name}\", which the wing does not have"), help))
}

impl MotionSpec {
    /// Frequencies with the fields they come from; a unit of a 3-2-1-1 is half a period of its fastest part.
    fn frequencies(&self) -> Vec<(&'static str, f64)> {
        match *self {
            Self::OneMinusCosine { frequency_hz, .. } | Self::Doublet { frequency_hz, .. } => {
                vec![("frequency_hz", frequency_hz)]
            }
            Self::Chirp { from_hz, to_hz, .. } => vec![("from_hz", from_hz), ("to_hz", to_hz)],
            Self::ThreeTwoOneOne { unit_s, .. } => vec![("unit_s", 0.5 / unit_s)],
            Self::Step { .. } | Self::FromFile { .. } => Vec::new(),
        }
    }

    /// The end of a motion that ends.
    fn end_s(&self) -> Option<f64> {
        let length_s = match *self {
            Self::OneMinusCosine { frequency_hz, .. } | Self::Doublet { frequency_hz, .. } => {
                1.0 / frequency_hz
            }
            Self::Chirp { duration_s, .. } => duration_s,
            Self::ThreeTwoOneOne { unit_s, .. } => 7.0 * unit_s,
            Self::Step { .. } => 0.0,
            Self::FromFile { .. } => return None,
        };
        Some(self.start_s() + length_s)
    }
}

/// A motion of the model that grows by itself: the airspeed is above flutter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Growing {
    /// Frequency; zero if it grows without swinging.
    pub frequency_hz: f64,
    /// Rate of growth, 1/s.
    pub growth_per_s: f64,
}

impl std::fmt::Display for Growing {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { frequency_hz, growth_per_s } = self;
        write!(
            f,
            "above the flutter speed: an oscillation of {frequency_hz:.2} Hz grows by exp({growth_per_s:.3} t)"
        )
    }
}

/// The fastest growing motion of a model; none below flutter.
pub fn growing(model: &RigModel) -> Option<Growing> {
    let values = model.a.eigenvalues().ok()?;
    let fastest = values.into_iter().max_by(|a, b| a.re.total_cmp(&b.re))?;
    (fastest.re > GROWTH * fastest.re.hypot(fastest.im))
        .then(|| Growing { frequency_hz: fastest.im.abs() / std::f64::consts::TAU, growth_per_s: fastest.re })
}
