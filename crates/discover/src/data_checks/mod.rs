//! Data defects that stop the search: what no missing effect does to one run and not to its peers.
//!
//! The model may be wrong, and by much: a run is judged by how it differs from runs like it, never by the model alone;
//! what concerns all runs (a channel's sign, exchanged labels) must be something that no effect can do.

mod airspeed;
mod labels;
mod record;
mod repeats;
mod samples;
mod timing;

use crate::data::Dataset;
use maneuver::effects::Flown;
pub use record::rough_noise;
pub(crate) use record::{CHANNELS, mean, median};

/// What is wrong.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DefectKind {
    /// Labels of channels exchanged.
    SwappedChannels,
    /// A channel's sign.
    SignFlipped,
    /// The airspeed is not what the label says.
    WrongAirspeed,
    /// The channel ends at a value beyond which the load went.
    Clipped,
    /// The channel stands still while the load moves.
    Stuck,
    /// The run is late or early.
    Lag,
    /// Single samples far off.
    Spikes,
    /// A repeat that does not repeat.
    Repeat,
}

/// A defect.
#[derive(Debug, Clone, PartialEq)]
pub struct Defect {
    /// What is wrong.
    pub kind: DefectKind,
    /// Name of the run or of the static points; none if it is so everywhere.
    pub run: Option<String>,
    /// The channel; none if it concerns all of them or several.
    pub channel: Option<&'static str>,
    /// One plain sentence.
    pub sentence: String,
}

/// Defects of a data set, worst kind first; none is what one hopes for. `simulated`: static groups, then runs, as
/// measured; `sigma`: one standard deviation of a sample of Fz, Mx, My in the same order.
pub fn defects(data: &Dataset, simulated: &[Flown], sigma: &[[f64; 3]]) -> Vec<Defect> {
    let records = record::records(data, simulated, sigma);
    let mut all = labels::everywhere(&records);
    let everywhere = !all.is_empty();
    // each kind is looked for in what the kinds before have left: a mislabelled run is not late, too
    let mut add = |found: Vec<Defect>| {
        let new: Vec<Defect> =
            found.into_iter().filter(|defect| all.iter().all(|other| other.run != defect.run)).collect();
        all.extend(new);
    };
    add(samples::flat(&records));
    if !everywhere {
        add(labels::by_run(&records));
    }
    add(airspeed::wrong(&records));
    add(samples::spikes(&records));
    add(timing::lags(&records));
    // a run that is named already differs from its repeat of course
    let named: Vec<String> = all.iter().filter_map(|defect| defect.run.clone()).collect();
    all.extend(repeats::differ(&records, &named));
    all
}
