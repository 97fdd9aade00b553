//! The V-n diagram of a mass at an altitude: stall lines, maneuver lines, gust lines, and their corners (14 CFR 23.333, 25.333).

use crate::atmosphere::{Air, G_M_S2, RHO0_KG_M3};
use crate::cell::cell;
use crate::design::{Design, DesignSpeeds, Gust, LimitLoadFactors, Speed};
use crate::rules::pratt::{Airframe, Pratt};
use nastran::InputError;
use std::fmt::Write as _;

/// Points of a stall line.
const POINTS: u32 = 40;
/// A load factor that is this share beyond a line is on it.
const ON_THE_LINE: f64 = 1e-9;

/// Where the aircraft stalls with load factor one and minus one, m/s EAS.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stall {
    /// Upright.
    pub upright_m_s: f64,
    /// Inverted.
    pub inverted_m_s: f64,
}

impl Stall {
    /// The largest and the smallest load factor that the wing carries at an equivalent airspeed, m/s.
    pub fn factors(&self, v_eas_m_s: f64) -> (f64, f64) {
        (-(v_eas_m_s / self.inverted_m_s).powi(2), (v_eas_m_s / self.upright_m_s).powi(2))
    }
}

/// A corner of the maneuver envelope.
#[derive(Debug, Clone, PartialEq)]
pub struct Corner {
    /// A, C, D, E, F or G.
    pub name: &'static str,
    /// Equivalent airspeed, m/s.
    pub v_eas_m_s: f64,
    /// Load factor.
    pub n: f64,
    /// Why it cannot be flown.
    pub left_out: Option<String>,
}

/// Gusts from below and above at a design speed by Pratt's formula.
#[derive(Debug, Clone, PartialEq)]
pub struct GustPoint {
    /// The design speed.
    pub speed: Speed,
    /// Equivalent airspeed, m/s.
    pub v_eas_m_s: f64,
    /// The derived gust, m/s EAS.
    pub u_de_m_s: f64,
    /// The formula's numbers.
    pub pratt: Pratt,
    /// Where the stall line meets this speed's gust line, if there is one and it does: m/s EAS and load factor.
    pub stall_meets: Option<(f64, f64)>,
}

/// The diagram of a mass at an altitude.
#[derive(Debug, Clone, PartialEq)]
pub struct Diagram {
    /// Mass, kg.
    pub mass_kg: f64,
    /// Altitude, m.
    pub h_m: f64,
    /// Design speeds.
    pub speeds: DesignSpeeds,
    /// Limit load factors.
    pub factors: LimitLoadFactors,
    /// Stall speeds, if the plan has lift coefficients.
    pub stall: Option<Stall>,
    /// Where the stall line meets n1, m/s EAS.
    pub v_a_least_m_s: Option<f64>,
    /// VA in use, m/s EAS: as given, but not below where the stall line meets n1.
    pub v_a_m_s: Option<f64>,
    /// Where the inverted stall line meets n2, m/s EAS.
    pub v_g_m_s: Option<f64>,
    /// Corners.
    pub corners: Vec<Corner>,
    /// Gusts of the plan's `Pratt`.
    pub gusts: Vec<GustPoint>,
}

impl Diagram {
    /// The diagram of a plan for an airframe of a mass, kg, at an altitude, m.
    ///
    /// # Errors
    /// If a number is missing that the plan asks for.
    pub fn of(design: &Design, airframe: &Airframe, mass_kg: f64, h_m: f64) -> Result<Self, InputError> {
        let (factors, _) = design.load_factors()?;
        let stall = design.lift.map(|lift| {
            let speed = |cl: f64| (2.0 * mass_kg * G_M_S2 / (RHO0_KG_M3 * airframe.area_m2 * cl)).sqrt();
            Stall { upright_m_s: speed(lift.cl_max), inverted_m_s: speed(-lift.cl_min) }
        });
        let v_a_least_m_s = stall.map(|stall| stall.upright_m_s * factors.n1.sqrt());
        let v_g_m_s = stall.map(|stall| stall.inverted_m_s * (-factors.n2).sqrt());
        let v_a_m_s = match (design.speeds.va, v_a_least_m_s) {
            (Some(given), Some(least)) => Some(given.max(least)),
            (given, least) => given.or(least),
        };
        let mut diagram = Self {
            mass_kg,
            h_m,
            speeds: design.speeds,
            factors,
            stall,
            v_a_least_m_s,
            v_a_m_s,
            v_g_m_s,
            corners: Vec::new(),
            gusts: Vec::new(),
        };
        diagram.corners = diagram.all_corners();
        diagram.gusts = diagram.all_gusts(design, airframe)?;
        Ok(diagram)
    }

    /// The largest and smallest load factor of maneuvers at an equivalent airspeed, m/s, without stall.
    pub fn maneuver_factors(&self, v_eas_m_s: f64) -> (f64, f64) {
        let DesignSpeeds { vc, vd, .. } = self.speeds;
        let LimitLoadFactors { n1, n2, n2_at_vd } = self.factors;
        let share = ((v_eas_m_s - vc) / (vd - vc)).clamp(0.0, 1.0);
        (n2 + (n2_at_vd - n2) * share, n1)
    }

    /// Why a load factor cannot be flown at an equivalent airspeed, m/s, for the stall lines.
    pub fn beyond_stall(&self, v_eas_m_s: f64, n: f64) -> Option<String> {
        let (smallest, largest) = self.stall?.factors(v_eas_m_s);
        let slack = ON_THE_LINE * n.abs();
        if n > largest + slack {
            Some(format!("n {n:.2} above the stall line {largest:.2} at {v_eas_m_s:.1} m/s EAS"))
        } else if n < smallest - slack {
            Some(format!("n {n:.2} below the stall line {smallest:.2} at {v_eas_m_s:.1} m/s EAS"))
        } else {
            None
        }
    }

    /// Why a maneuver of a load factor is not flown at an equivalent airspeed, m/s: stall, VD, or the limit load factors.
    pub fn forbidden(&self, v_eas_m_s: f64, n: f64) -> Option<String> {
        let vd = self.speeds.vd;
        if v_eas_m_s > vd * (1.0 + ON_THE_LINE) {
            return Some(format!("{v_eas_m_s:.1} m/s EAS is above VD {vd:.1}"));
        }
        let (smallest, largest) = self.maneuver_factors(v_eas_m_s);
        let slack = ON_THE_LINE * n.abs();
        if n > largest + slack || n < smallest - slack {
            return Some(format!(
                "n {n:.2} is outside {smallest:.2} to {largest:.2}, the limits at {v_eas_m_s:.1} m/s EAS"
            ));
        }
        self.beyond_stall(v_eas_m_s, n)
    }

    fn all_corners(&self) -> Vec<Corner> {
        let DesignSpeeds { vc, vd, .. } = self.speeds;
        let LimitLoadFactors { n1, n2, n2_at_vd } = self.factors;
        let without = "without lift coefficients (`lift`) there is no stall line";
        let corner = |name: &'static str, v: Option<f64>, n: f64, most: f64| match v {
            None => Corner { name, v_eas_m_s: vc, n, left_out: Some(without.to_owned()) },
            Some(v) if v > most * (1.0 + ON_THE_LINE) => {
                let left_out =
                    Some(format!("the stall line meets n {n:.2} at {v:.1} m/s EAS, beyond {most:.1}"));
                Corner { name, v_eas_m_s: v, n, left_out }
            }
            Some(v) => Corner { name, v_eas_m_s: v, n, left_out: self.beyond_stall(v, n) },
        };
        vec![
            corner("A", self.v_a_m_s, n1, vd),
            corner("C", Some(vc), n1, vd),
            corner("D", Some(vd), n1, vd),
            corner("E", Some(vd), n2_at_vd, vd),
            corner("F", Some(vc), n2, vd),
            corner("G", self.v_g_m_s, n2, vc),
        ]
    }

    fn all_gusts(&self, design: &Design, airframe: &Airframe) -> Result<Vec<GustPoint>, InputError> {
        let air = Air::at(self.h_m);
        let mut points: Vec<GustPoint> = Vec::new();
        for gust in &design.gusts {
            let Gust::Pratt { at } = gust else { continue };
            for &speed in at {
                let u_de_m_s = design.derived_gust(speed, self.h_m)?.value;
                let v = design.speeds.get(speed).ok_or_else(|| design.no_speed(speed))?;
                let pratt = Pratt::of(airframe, self.mass_kg, &air, v, u_de_m_s);
                let stall_meets = self.stall.and_then(|stall| meets(stall.upright_m_s, pratt.delta_n / v));
                points.push(GustPoint { speed, v_eas_m_s: v, u_de_m_s, pratt, stall_meets });
            }
        }
        points.sort_by(|a, b| a.v_eas_m_s.total_cmp(&b.v_eas_m_s));
        Ok(points)
    }

    /// The lines: name, equivalent airspeed, m/s, and load factor of each point.
    pub fn lines(&self) -> Vec<(&'static str, f64, f64)> {
        let mut lines = Vec::new();
        let vd = self.speeds.vd;
        if let Some(stall) = self.stall {
            let mut along = |name: &'static str, end: f64, of: &dyn Fn(f64) -> f64| {
                for step in 0..=POINTS {
                    let v = end * f64::from(step) / f64::from(POINTS);
                    lines.push((name, v, of(v)));
                }
            };
            let end = |v: Option<f64>, most: f64| v.unwrap_or(most).min(most);
            along("stall line", end(self.v_a_least_m_s, vd), &|v| stall.factors(v).1);
            along("inverted stall line", end(self.v_g_m_s, self.speeds.vc), &|v| stall.factors(v).0);
        }
        let (n1, vc) = (self.factors.n1, self.speeds.vc);
        let from = |v: Option<f64>| v.unwrap_or(0.0);
        for (v, n) in [(from(self.v_a_least_m_s), n1), (vd, n1), (vd, self.factors.n2_at_vd)] {
            lines.push(("maneuver", v, n));
        }
        for (v, n) in [(vc, self.factors.n2), (from(self.v_g_m_s), self.factors.n2)] {
            lines.push(("maneuver", v, n));
        }
        for (name, sign) in [("gust up", 1.0), ("gust down", -1.0)] {
            if !self.gusts.is_empty() {
                lines.push((name, 0.0, 1.0));
            }
            for point in &self.gusts {
                lines.push((name, point.v_eas_m_s, 1.0 + sign * point.pratt.delta_n));
            }
        }
        lines
    }

    /// The lines as rows of `vn.csv`, whose header is [`VN_HEADER`].
    pub fn csv(&self, mass: &str) -> String {
        let mut text = String::new();
        for (line, v, n) in self.lines() {
            // Writing to a String cannot fail.
            let _ = writeln!(text, "{},{},{line},{v:.6},{n:.6}", cell(mass), self.h_m);
        }
        text
    }
}

/// First line of `vn.csv`.
pub const VN_HEADER: &str = "mass,h_m,line,V_EAS_m_s,n\n";

/// Where the stall parabola (V/VS)^2 meets the gust line 1 + k V.
fn meets(stall_m_s: f64, k: f64) -> Option<(f64, f64)> {
    let a = stall_m_s.powi(-2);
    let v = (k + (k * k + 4.0 * a).sqrt()) / (2.0 * a);
    v.is_finite().then_some((v, 1.0 + k * v))
}

impl Design {
    /// A complaint that a design speed is asked for.
    pub(crate) fn no_speed(&self, speed: Speed) -> InputError {
        let name = speed.name();
        self.wrong("design_speeds_EAS_m_s", format!("{name} is asked for"), "give it among the design speeds")
    }
}
