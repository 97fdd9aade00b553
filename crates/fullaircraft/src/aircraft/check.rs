//! What the numbers of an aircraft's file must satisfy before cards are made of them.

use crate::aircraft::file::{AircraftFile, Fuselage, RoundBeam, TailSurface};
use crate::flight::small_motions::TIME_STEP_S;
use maneuver::motion::Fault;
use nastran::InputError;

/// What is wrong with a part of the aircraft, and the field whose place in the file is shown.
struct PartFault {
    field: String,
    message: String,
}

impl PartFault {
    fn new(part: &str, message: &str) -> Self {
        Self { field: part.to_owned(), message: format!("{part}: {message}") }
    }
}

/// Shorter gusts than this are not resolved by the stations at which a gust is known.
const SHORTEST_GUST_M: f64 = 0.5;

/// Masses, densities and frequencies of aircraft are below.
const LARGEST: f64 = 1e6;

impl AircraftFile {
    /// Numbers that stand alone.
    fn check_numbers(&self) -> Result<(), InputError> {
        let positive = [
            ("correction_airspeed_m_s", self.correction_airspeed_m_s),
            ("rho_kg_m3", self.rho_kg_m3),
            ("total.mass_kg", self.total.mass_kg),
            ("total.ixx_kg_m2", self.total.ixx_kg_m2),
            ("total.iyy_kg_m2", self.total.iyy_kg_m2),
            ("total.izz_kg_m2", self.total.izz_kg_m2),
            ("fuselage.height_m", self.fuselage.height_m),
            ("actuator.frequency_hz", self.actuator.frequency_hz),
            ("actuator.damping_ratio", self.actuator.damping_ratio),
            ("modes_up_to_hz", self.modes_up_to_hz),
        ];
        let finite = [
            ("total.x_cg_m", self.total.x_cg_m),
            ("trim.load_factor", self.trim.load_factor),
            ("trim.pitch_rate_deg_s", self.trim.pitch_rate_deg_s),
            ("pull_up.load_factor", self.pull_up.load_factor),
            ("pull_up.pitch_rate_deg_s", self.pull_up.pitch_rate_deg_s),
            ("push_down.load_factor", self.push_down.load_factor),
            ("push_down.pitch_rate_deg_s", self.push_down.pitch_rate_deg_s),
        ];
        self.refuse(&positive, |value| value.is_finite() && value > 0.0, "a number above zero")?;
        let bounded = [
            ("rho_kg_m3", self.rho_kg_m3),
            ("total.mass_kg", self.total.mass_kg),
            ("actuator.frequency_hz", self.actuator.frequency_hz),
            ("modes_up_to_hz", self.modes_up_to_hz),
        ];
        self.refuse(&bounded, |value| value <= LARGEST, "a number below a million")?;
        let ratio = [("actuator.damping_ratio", self.actuator.damping_ratio)];
        self.refuse(&ratio, |value| value <= 10.0, "a share of critical damping, 10 at most")?;
        self.refuse(&finite, f64::is_finite, "a finite number")
    }

    /// Refuses numbers that make no sense.
    pub(crate) fn check(&self) -> Result<(), InputError> {
        self.check_numbers()?;
        if let Some(line) = self.thrust_line {
            let (x, y, z) = line.point_m;
            let numbers = [x, y, z, line.up_deg].map(|value| ("thrust_line", value));
            self.refuse(&numbers, f64::is_finite, "finite numbers")?;
        }
        let airspeeds = [
            ("trim.V_m_s", self.trim.v_m_s),
            ("pull_up.V_m_s", self.pull_up.v_m_s),
            ("push_down.V_m_s", self.push_down.v_m_s),
        ];
        let incompressible = |value: f64| (0.1..=340.0).contains(&value);
        self.refuse(&airspeeds, incompressible, "0.1 to 340 m/s: the air is taken as incompressible")?;
        let history = |value: f64| (0.0..=600.0).contains(&value);
        let motions = [("doublet", &self.doublet), ("chirp", &self.chirp)];
        for (part, motion) in motions {
            if let Some(Fault { field, message, help }) = motion.fault(1.0 / TIME_STEP_S) {
                let place = if field == "height_deg" { part.to_owned() } else { format!("{part}.{field}") };
                return Err(
                    InputError::in_field(&self.path, &place, format!("{part}: {message}")).with_help(help)
                );
            }
        }
        let times = motions.map(|(part, motion)| (part, motion.kind().start_s().max(motion.record_s())));
        self.refuse(&times, history, "0 to 600 s")?;
        if let Some(gust) = &self.gust {
            let times = [("gust.start_s", gust.start_s), ("gust.duration_s", gust.duration_s)];
            self.refuse(&times, history, "0 to 600 s")?;
            let shortest = |value: f64| value.is_finite() && value >= SHORTEST_GUST_M;
            self.refuse(&[("gust.length_m", gust.length_m)], shortest, "at least 0.5 m")?;
            let below = |value: f64| value.abs() <= 0.5 * self.trim.v_m_s;
            let what = "at most half the airspeed of the trim";
            self.refuse(&[("gust.velocity_m_s", gust.velocity_m_s)], below, what)?;
        }
        self.fuselage.check().and(self.htp.check("htp")).and(self.vtp.check("vtp")).map_err(|fault| {
            InputError::in_field(&self.path, &fault.field, fault.message)
                .with_help("data/tuflex/aircraft.ron explains every field")
        })
    }

    fn refuse(
        &self,
        values: &[(&str, f64)],
        fits: impl Fn(f64) -> bool,
        what: &str,
    ) -> Result<(), InputError> {
        match values.iter().find(|(_, value)| !fits(*value)) {
            None => Ok(()),
            Some((name, value)) => {
                Err(InputError::in_field(&self.path, name, format!("{name} is {value}, expected {what}"))
                    .with_help("the unit is in the field's name"))
            }
        }
    }
}

impl RoundBeam {
    fn check(&self, part: &str) -> Result<(), PartFault> {
        let fits = |value: f64| value.is_finite() && value > 0.0;
        if fits(self.ei_nm2) && fits(self.gj_nm2) && fits(self.mass_kg_m) {
            return Ok(());
        }
        let message = format!("{part}.beam needs stiffnesses and a mass above zero");
        Err(PartFault { field: format!("{part}.beam"), message })
    }
}

impl Fuselage {
    fn check(&self) -> Result<(), PartFault> {
        let places = [self.x_m.0, self.gap_x_m.0, self.gap_x_m.1, self.x_m.1];
        if !places.windows(2).all(|pair| pair[0] < pair[1]) || !places.iter().all(|x| x.is_finite()) {
            return Err(PartFault::new(
                "fuselage",
                "x_m and gap_x_m must follow each other as nose, gap, tail end",
            ));
        }
        if self.half_width_wing_strips == 0 || self.boxes.ahead == 0 || self.boxes.behind == 0 {
            return Err(PartFault::new("fuselage", "strips and boxes must be at least one"));
        }
        self.beam.check("fuselage")
    }
}

impl TailSurface {
    fn check(&self, part: &str) -> Result<(), PartFault> {
        let fits = |value: f64| value.is_finite() && value > 0.0;
        let (x, y, z) = self.root_leading_edge_m;
        if !(fits(self.span_m) && fits(self.root_chord_m) && fits(self.tip_chord_m)) {
            return Err(PartFault::new(part, "span and chords must be above zero"));
        }
        if ![x, y, z].iter().all(|value| value.is_finite()) || self.leading_edge_sweep_deg.abs() > 75.0 {
            return Err(PartFault::new(part, "the root must have a place, and the sweep be within 75 deg"));
        }
        let (boxes, control) = (&self.boxes, &self.control);
        let most = 1..=200;
        if !most.contains(&boxes.chordwise) || !most.contains(&boxes.spanwise) {
            return Err(PartFault {
                field: format!("{part}.boxes"),
                message: format!("{part}: boxes must be 1 to 200 each way"),
            });
        }
        let inside = (0.0..1.0).contains(&control.chord_share) && control.chord_share > 0.0;
        if control.chord_boxes == 0 || control.chord_boxes >= boxes.chordwise || !inside {
            let message = format!("{part}: the control needs some, but not all, of the chord and its boxes");
            return Err(PartFault { field: format!("{part}.control"), message });
        }
        self.beam.check(part)
    }
}

#[cfg(test)]
mod tests;
