//! The case matrix: masses x altitudes x speeds x conditions, each with a number that it keeps, and a status.

use crate::atmosphere::Air;
use crate::cell::cell;
use crate::design::{Attitude, Design, Direction, Gradients, Gust, Rules, Spectrum, Speed};
use crate::rules::discrete::{default_gradients, design_gust, longest_gradient_m};
use crate::rules::pratt::Airframe;
use crate::vn::Diagram;
use nastran::InputError;
use std::fmt::Write as _;

/// Most cases of a plan.
const MOST_CASES: usize = 200_000;

/// A condition of the caller's beside corners and gusts: flown at every mass and altitude.
#[derive(Debug, Clone, PartialEq)]
pub struct Condition {
    /// Kind, one word.
    pub kind: String,
    /// In words.
    pub words: String,
    /// Equivalent airspeed, m/s.
    pub v_eas_m_s: f64,
    /// Load factor.
    pub n_z: f64,
}

/// What becomes of a case.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// To be flown.
    Planned,
    /// Not flown.
    LeftOut,
    /// Flown.
    Flown,
    /// It could not be flown.
    Failed,
}

/// What is flown.
#[derive(Debug, Clone, PartialEq)]
pub enum Action {
    /// A balanced trim at the case's load factor.
    Trim,
    /// One of the caller's conditions, by its place.
    Condition(usize),
    /// A gust of one minus a cosine from level flight.
    Discrete {
        /// Gradient, m.
        gradient_m: f64,
        /// Direction.
        direction: Direction,
        /// Design velocity, m/s TAS.
        u_ds_m_s: f64,
        /// Whether the worst gradient of each load is searched for between those of the plan.
        refine: bool,
    },
    /// Continuous turbulence from level flight.
    Turbulence {
        /// Axis.
        direction: Direction,
        /// Limit intensity, m/s TAS.
        u_sigma_m_s: f64,
        /// Scale, m.
        scale_m: f64,
        /// Where the response ends, Hz.
        cut_off_hz: f64,
        /// Spectrum.
        spectrum: Spectrum,
        /// What keeps airspeed and attitude.
        attitude: Attitude,
        /// Longest gradient of the plan's gusts, m: who cannot fly so long without doubling a motion is not stable by itself.
        longest_gradient_m: f64,
    },
}

/// One case.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// Its number, from one.
    pub number: usize,
    /// Kind: `corner`, `pratt`, `discrete`, `turbulence`, or a condition's own.
    pub kind: String,
    /// Which mass of the plan.
    pub mass: usize,
    /// Altitude, m.
    pub h_m: f64,
    /// True airspeed, m/s.
    pub v_m_s: f64,
    /// Equivalent airspeed, m/s.
    pub v_eas_m_s: f64,
    /// Mach number.
    pub mach: f64,
    /// Load factor: of the trim, or of the flight that a gust meets.
    pub n_z: f64,
    /// In words.
    pub condition: String,
    /// The rules in use.
    pub rule: Rules,
    /// What becomes of it.
    pub status: Status,
    /// Why it is left out or changed.
    pub why: String,
    /// What is flown.
    pub action: Action,
}

/// All cases and the diagrams they come from.
#[derive(Debug, Clone, PartialEq)]
pub struct Matrix {
    /// Cases in their order.
    pub cases: Vec<Case>,
    /// A diagram each mass and altitude: place of the mass, diagram.
    pub diagrams: Vec<(usize, Diagram)>,
}

/// The matrix of a plan for an airframe, with further conditions.
///
/// # Errors
/// If the plan's numbers make no sense, one is missing that it asks for, or there is no case or too many.
pub fn matrix(design: &Design, airframe: &Airframe, conditions: &[Condition]) -> Result<Matrix, InputError> {
    design.check()?;
    let mut all = Matrix { cases: Vec::new(), diagrams: Vec::new() };
    for (mass, case) in design.masses.iter().enumerate() {
        for &h_m in &design.altitudes_m {
            let diagram = Diagram::of(design, airframe, case.mass_kg, h_m)?;
            let mut writer =
                Writer { design, diagram: &diagram, mass, air: Air::at(h_m), cases: &mut all.cases };
            writer.corners();
            writer.conditions(conditions);
            writer.gusts(airframe)?;
            all.diagrams.push((mass, diagram));
            if all.cases.len() > MOST_CASES {
                let message = format!("these are more than {MOST_CASES} cases, the most of a plan");
                return Err(design.wrong("masses", message, "make its lists shorter, or split it"));
            }
        }
    }
    Ok(all)
}

/// Writes the cases of a mass and an altitude.
struct Writer<'a> {
    design: &'a Design,
    diagram: &'a Diagram,
    mass: usize,
    air: Air,
    cases: &'a mut Vec<Case>,
}

impl Writer<'_> {
    fn corners(&mut self) {
        for corner in &self.diagram.corners {
            let words = format!("corner {}", corner.name);
            let case = self.case("corner", &words, corner.v_eas_m_s, corner.n, Action::Trim);
            self.push(case, corner.left_out.clone());
        }
    }

    fn conditions(&mut self, conditions: &[Condition]) {
        for (place, own) in conditions.iter().enumerate() {
            let forbidden = self.diagram.forbidden(own.v_eas_m_s, own.n_z);
            let case = self.case(&own.kind, &own.words, own.v_eas_m_s, own.n_z, Action::Condition(place));
            self.push(case, forbidden);
        }
    }

    fn gusts(&mut self, airframe: &Airframe) -> Result<(), InputError> {
        self.pratt();
        for gust in &self.design.gusts {
            match gust {
                Gust::Pratt { .. } => {}
                Gust::Discrete { at, gradients_m, directions, refine } => {
                    let gradients = match gradients_m {
                        Gradients::Default => default_gradients(airframe.mean_chord_m),
                        Gradients::Of(own) => own.clone(),
                    };
                    for &speed in at {
                        for &direction in directions {
                            self.discrete(speed, (direction, *refine), &gradients)?;
                        }
                    }
                }
                Gust::Turbulence { at, scale_m, cut_off_hz, spectrum, directions, attitude } => {
                    for &speed in at {
                        for &direction in directions {
                            let v = self.speed(speed)?;
                            let [_, limit] = self.design.turbulence_intensity(self.diagram.h_m, v)?;
                            let action = Action::Turbulence {
                                direction,
                                u_sigma_m_s: limit.value,
                                scale_m: *scale_m,
                                cut_off_hz: *cut_off_hz,
                                spectrum: *spectrum,
                                attitude: *attitude,
                                longest_gradient_m: longest_gradient_m(self.design),
                            };
                            let (axis, held) = (direction.axis(), attitude.words());
                            let words = format!("{axis} turbulence at {}{held}", speed.name());
                            let case = self.case("turbulence", &words, v, 1.0, action);
                            self.push_level(case);
                        }
                    }
                }
            }
        }
        Ok(())
    }

    /// Both load factors of each of Pratt's gusts; beyond the stall line the stall line's.
    fn pratt(&mut self) {
        for point in &self.diagram.gusts {
            for (sign, from) in [(1.0, "up"), (-1.0, "down")] {
                let asked = 1.0 + sign * point.pratt.delta_n;
                let v = point.v_eas_m_s;
                let (n, why) = match (self.diagram.stall, self.diagram.beyond_stall(v, asked)) {
                    (Some(stall), Some(_)) => {
                        let (smallest, largest) = stall.factors(v);
                        let n = asked.clamp(smallest, largest);
                        (n, format!("the gust asks n {asked:.2}, stall allows {n:.2}: flown at it"))
                    }
                    _ => (asked, String::new()),
                };
                let words =
                    format!("Pratt gust {from} of {:.2} m/s at {}", point.u_de_m_s, point.speed.name());
                let mut case = self.case("pratt", &words, v, n, Action::Trim);
                case.why = why;
                self.cases.push(case);
            }
        }
    }

    fn discrete(
        &mut self,
        speed: Speed,
        (direction, refine): (Direction, bool),
        gradients: &[f64],
    ) -> Result<(), InputError> {
        let (v, h_m) = (self.speed(speed)?, self.diagram.h_m);
        let reference = self.design.reference_gust(h_m, v)?.value;
        let factor = self.design.profile_alleviation(h_m)?.value;
        for &gradient_m in gradients {
            let u_ds_m_s = design_gust(reference, factor, gradient_m) * self.air.true_over_equivalent();
            let words = format!("gust {} H {gradient_m:.1} m at {}", direction.word(), speed.name());
            let action = Action::Discrete { gradient_m, direction, u_ds_m_s, refine };
            let case = self.case("discrete", &words, v, 1.0, action);
            self.push_level(case);
        }
        Ok(())
    }

    fn speed(&self, speed: Speed) -> Result<f64, InputError> {
        let computed = if speed == Speed::VA { self.diagram.v_a_m_s } else { None };
        computed.or(self.design.speeds.get(speed)).ok_or_else(|| self.design.no_speed(speed))
    }

    fn case(&self, kind: &str, words: &str, v_eas_m_s: f64, n_z: f64, action: Action) -> Case {
        let v_m_s = v_eas_m_s * self.air.true_over_equivalent();
        Case {
            number: self.cases.len() + 1,
            kind: kind.to_owned(),
            mass: self.mass,
            h_m: self.diagram.h_m,
            v_m_s,
            v_eas_m_s,
            mach: v_m_s / self.air.sound_m_s,
            n_z,
            condition: words.to_owned(),
            rule: self.design.rules_in_use(),
            status: Status::Planned,
            why: String::new(),
            action,
        }
    }

    /// A case that begins in level flight, which the stall line may forbid.
    fn push_level(&mut self, case: Case) {
        let forbidden = self.diagram.beyond_stall(case.v_eas_m_s, 1.0);
        self.push(case, forbidden);
    }

    fn push(&mut self, mut case: Case, left_out: Option<String>) {
        if let Some(why) = left_out {
            (case.status, case.why) = (Status::LeftOut, why);
        }
        self.cases.push(case);
    }
}

impl Direction {
    /// As a case's words have it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Up => "up",
            Self::Down => "down",
            Self::Lateral => "lateral",
        }
    }

    /// The axis of the gust's velocity.
    pub fn axis(self) -> &'static str {
        if self == Self::Lateral { "lateral" } else { "vertical" }
    }
}

impl Attitude {
    /// As it follows a case's words.
    fn words(self) -> &'static str {
        if self == Self::Held { " with airspeed and attitude held" } else { "" }
    }

    /// As `turbulence.csv` has it.
    pub fn word(self) -> &'static str {
        if self == Self::Held { "held" } else { "stable" }
    }
}

impl Status {
    /// As `cases.csv` has it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Planned => "planned",
            Self::LeftOut => "left_out",
            Self::Flown => "flown",
            Self::Failed => "failed",
        }
    }
}

impl Rules {
    /// As `cases.csv` has it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Vla => "Vla",
            Self::Cs23Normal => "Cs23Normal",
            Self::Cs25 => "Cs25",
            Self::Stanag4671 => "Stanag4671",
            Self::Own => "Own",
        }
    }
}

impl Matrix {
    /// All cases as `cases.csv`.
    pub fn csv(&self, design: &Design) -> String {
        let mut text =
            String::from("case,kind,mass,h_m,V_m_s,V_EAS_m_s,mach,n_z,condition,rule,status,why\n");
        for case in &self.cases {
            let _ = writeln!(
                text,
                "{},{},{},{},{:.6},{:.6},{:.6},{:.6},{},{},{},{}",
                case.number,
                cell(&case.kind),
                cell(&design.masses[case.mass].name),
                case.h_m,
                case.v_m_s,
                case.v_eas_m_s,
                case.mach,
                case.n_z,
                cell(&case.condition),
                case.rule.word(),
                case.status.word(),
                cell(&case.why),
            );
        }
        text
    }

    /// All diagrams as `vn.csv`.
    pub fn vn_csv(&self, design: &Design) -> String {
        let rows = self.diagrams.iter().map(|(mass, diagram)| diagram.csv(&design.masses[*mass].name));
        rows.fold(String::from(crate::vn::VN_HEADER), |text, rows| text + &rows)
    }
}
