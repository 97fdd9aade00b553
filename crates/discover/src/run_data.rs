//! A campaign's runs and static points, as [`crate::data::Dataset`] has them.

use calibrate::Use;
use maneuver::effects::Stimulus;

/// A run.
#[derive(Debug, Clone)]
pub struct RunData {
    /// Name of its file without ending.
    pub name: String,
    /// Training or held out.
    pub usage: Use,
    /// Place of its airspeed in [`crate::data::Dataset::airspeeds_m_s`].
    pub airspeed: usize,
    /// Place of its block in [`crate::data::Dataset::blocks`].
    pub block: Option<usize>,
    /// Place in [`crate::data::Dataset::runs`] of the run it repeats.
    pub repeat_of: Option<usize>,
    /// What moved, at the rate of [`crate::rules::DataRules`] or the file's own rate if that is lower.
    pub stimulus: Stimulus,
    /// Measured Fz, Mx, My at the same samples, N and N m; zeros for a load that the runs lack ([`crate::data::Dataset::run_loads`]).
    pub measured: [Vec<f64>; 3],
    /// Samples of the file to one of these.
    pub decimation: usize,
}

/// The static points of one airspeed (zero: weight tares).
#[derive(Debug, Clone)]
pub struct StaticGroup {
    /// Place of its airspeed.
    pub airspeed: usize,
    /// Angles and deflections, one sample a point.
    pub stimulus: Stimulus,
    /// Measured Fz, Mx, My by point; none for a channel that the campaign lacks.
    pub measured: Vec<[Option<f64>; 3]>,
    /// Place of each point in the campaign's list.
    pub points: Vec<usize>,
    /// Place of each point's block.
    pub blocks: Vec<Option<usize>>,
    /// Whether no run or every run of this airspeed is held out: held-out airspeeds give nothing away.
    pub usage: Use,
}
