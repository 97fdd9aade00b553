//! The RON file that describes an aircraft: which wing, what stands around it, what it weighs and what it flies.

use crate::aircraft::lift_limits::{LiftLimits, lift_limits};
use maneuver::motion::{Chirp, Doublet, MotionSpec, OfKind, of_kind};
use nastran::{InputError, Span, ron_file};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// An aircraft as its file describes it; angles in degrees as in the file.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename = "Aircraft")]
pub struct AircraftFile {
    /// What reports call it.
    pub name: String,
    /// The wing's file, relative to this one.
    pub wing: String,
    /// Polars of the wing's section (CSV `V_mps,Re,alpha_deg,cl,...`), relative to this file: for stall lines and warnings.
    #[serde(default)]
    pub section_polars: Option<String>,
    /// Airspeed whose corrections all flight points use, m/s.
    pub correction_airspeed_m_s: f64,
    /// Air density, kg/m3.
    pub rho_kg_m3: f64,
    /// What is in the flow.
    pub surfaces: Surfaces,
    /// Mass properties of the whole.
    pub total: Total,
    /// Fuselage.
    pub fuselage: Fuselage,
    /// Right half of the horizontal tail.
    pub htp: TailSurface,
    /// Vertical tail.
    pub vtp: TailSurface,
    /// Where thrust acts; without it, forward through the centre of gravity.
    #[serde(default)]
    pub thrust_line: Option<ThrustLine>,
    /// Steady flight, where dynamic maneuvers start.
    pub trim: FlightPoint,
    /// Steady pull-up.
    pub pull_up: FlightPoint,
    /// Steady push-down.
    pub push_down: FlightPoint,
    /// Aileron doublet.
    #[serde(deserialize_with = "of_kind::<Doublet, _>")]
    #[schemars(with = "OfKind<Doublet>")]
    pub doublet: MotionSpec,
    /// Aileron chirp.
    #[serde(deserialize_with = "of_kind::<Chirp, _>")]
    #[schemars(with = "OfKind<Chirp>")]
    pub chirp: MotionSpec,
    /// A gust from `trim`; none if the file has none.
    #[serde(default)]
    pub gust: Option<GustCase>,
    /// Second-order actuators.
    pub actuator: Actuator,
    /// Highest frequency of elastic modes in dynamic maneuvers, Hz.
    pub modes_up_to_hz: f64,
    /// The file as it was named when read.
    #[serde(skip)]
    pub path: PathBuf,
}

/// What is in the flow; the structure is the same in both cases.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum Surfaces {
    /// Wings, tail and fuselage: alpha and elevator balance lift and pitching moment.
    All,
    /// Wings alone: alpha balances the lift, the pitching moment stays unbalanced.
    WingsOnly,
}

/// Mass properties of the whole aircraft.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Total {
    /// Mass, kg.
    pub mass_kg: f64,
    /// x of the centre of gravity, m; its y and z are zero.
    pub x_cg_m: f64,
    /// About x through the centre of gravity, kg m2.
    pub ixx_kg_m2: f64,
    /// About y through the centre of gravity, kg m2.
    pub iyy_kg_m2: f64,
    /// About z through the centre of gravity, kg m2.
    pub izz_kg_m2: f64,
}

/// A beam of round section: equally stiff both ways.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RoundBeam {
    /// Bending stiffness, N m2.
    pub ei_nm2: f64,
    /// Torsional stiffness, N m2.
    pub gj_nm2: f64,
    /// Mass per length, kg/m.
    pub mass_kg_m: f64,
}

/// A tube along x at y = z = 0, a cruciform of boxes in the flow.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Fuselage {
    /// Nose and tail end, m.
    pub x_m: (f64, f64),
    /// Where the wing interrupts the boxes, m.
    pub gap_x_m: (f64, f64),
    /// Height of the vertical arm, m.
    pub height_m: f64,
    /// Half the width of the horizontal arm, counted in strips of the wing.
    pub half_width_wing_strips: usize,
    /// Boxes along x.
    pub boxes: FuselageBoxes,
    /// The tube.
    pub beam: RoundBeam,
}

/// Boxes along x in each of the two strips of an arm.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FuselageBoxes {
    /// From the nose to the gap.
    pub ahead: u32,
    /// From the gap to the tail end.
    pub behind: u32,
}

/// A trapezoidal surface: half a horizontal tail (along +y) or a vertical tail (along +z).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TailSurface {
    /// Leading edge of the root, m.
    pub root_leading_edge_m: (f64, f64, f64),
    /// From root to tip, m.
    pub span_m: f64,
    /// Chord at the root, m.
    pub root_chord_m: f64,
    /// Chord at the tip, m.
    pub tip_chord_m: f64,
    /// Sweep of the leading edge, aft positive.
    pub leading_edge_sweep_deg: f64,
    /// Numbers of boxes.
    pub boxes: TailBoxes,
    /// The control surface, over the whole span.
    pub control: TailControl,
    /// Along the quarter chord.
    pub beam: RoundBeam,
}

/// Boxes of a tail surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TailBoxes {
    /// Along the chord.
    pub chordwise: u32,
    /// Along the span.
    pub spanwise: u32,
}

/// Elevator or rudder.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TailControl {
    /// Its name.
    pub name: String,
    /// Boxes of a strip that belong to it, counted from the trailing edge.
    pub chord_boxes: u32,
    /// Their share of the chord: boxes before and behind the hinge have different lengths.
    pub chord_share: f64,
}

/// The line thrust acts along. Its force reaches the structure at the wing's root.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ThrustLine {
    /// A point of it, m.
    pub point_m: (f64, f64, f64),
    /// How far it points up from straight ahead, deg.
    pub up_deg: f64,
}

/// A steady point of flight.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FlightPoint {
    /// Airspeed, m/s.
    #[serde(rename = "V_m_s")]
    pub v_m_s: f64,
    /// Lift over weight.
    pub load_factor: f64,
    /// Nose up, deg/s.
    pub pitch_rate_deg_s: f64,
}

/// A vertical one-minus-cosine gust.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GustCase {
    /// Largest velocity, upwards, m/s.
    pub velocity_m_s: f64,
    /// Length of the wave, m: twice the gradient distance.
    pub length_m: f64,
    /// When the nose enters, s.
    pub start_s: f64,
    /// Length of the time history, s.
    pub duration_s: f64,
}

/// An actuator of second order.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Actuator {
    /// Natural frequency, Hz.
    pub frequency_hz: f64,
    /// Share of critical damping.
    pub damping_ratio: f64,
}

impl AircraftFile {
    /// Reads and checks an aircraft's file; the wing's is not read.
    ///
    /// # Errors
    /// If it cannot be read or a number makes no sense.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let mut file: Self = ron_file::read(path)?;
        file.path = path.to_path_buf();
        file.check()?;
        nastran::named_file(path, &file.wing)?;
        Ok(file)
    }

    /// The file without the place it was read from: another text if anything in it is another.
    pub fn text(&self) -> String {
        format!("{:?}", Self { path: PathBuf::new(), ..self.clone() })
    }

    /// Where the wing's file is.
    pub fn wing_path(&self) -> PathBuf {
        self.path.parent().unwrap_or_else(|| Path::new("")).join(&self.wing)
    }

    /// Lift limits of the wing's section, if the file names polars.
    ///
    /// # Errors
    /// If they cannot be read.
    pub fn lift_limits(&self) -> Result<Option<Vec<LiftLimits>>, InputError> {
        let folder = self.path.parent().unwrap_or_else(|| Path::new(""));
        self.section_polars.as_ref().map(|name| lift_limits(&folder.join(name))).transpose()
    }

    /// The file as the place of cards made from it.
    pub fn span(&self) -> Span {
        Span::whole_file(&self.path)
    }
}
