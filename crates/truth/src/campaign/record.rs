//! Records and static points as they are written.

/// One record of a run; angles in degrees.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// File name.
    pub file: String,
    /// Block, from 0.
    pub block: usize,
    /// Clock time of its beginning, s.
    pub start_s: f64,
    /// Airspeed as written, m/s.
    pub v_m_s: f64,
    /// Whether it may be learnt from.
    pub train: bool,
    /// File of which it is a repetition.
    pub repeat_of: Option<String>,
    /// Samples per second.
    pub rate_hz: f64,
    /// Measured angle of attack, degrees.
    pub alpha_deg: Vec<f64>,
    /// Fz, Mx, My.
    pub loads: [Vec<f64>; 3],
    /// Height of the tip, m.
    pub tip_z_m: Vec<f64>,
    /// The control that moves, and its command, degrees.
    pub command: Option<(usize, Vec<f64>)>,
}

/// One static point.
#[derive(Debug, Clone, PartialEq)]
pub struct StaticPoint {
    /// Airspeed, m/s; zero is a weight tare.
    pub v_m_s: f64,
    /// Angle of attack, degrees.
    pub alpha_deg: f64,
    /// Fz, Mx, My.
    pub loads: [f64; 3],
    /// Height of the tip, m.
    pub tip_z_m: f64,
    /// Block, from 0.
    pub block: usize,
}

/// A campaign before it is files.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// Records, in the order of the design: block after block of each run.
    pub records: Vec<Record>,
    /// Static points.
    pub statics: Vec<StaticPoint>,
    /// Static points of the same wing without any effect.
    pub reference: Vec<StaticPoint>,
}
