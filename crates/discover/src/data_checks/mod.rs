//! Data defects that stop the search: what no missing effect does to one run and not to its peers.
//!
//! The model may be wrong, and by much: a run is judged by how it differs from runs like it, never by the model alone;
//! what concerns all runs (a channel's sign, exchanged labels) must be something that no effect can do.

mod airspeed;
mod defect;
mod labels;
mod record;
mod repeats;
mod samples;
mod scales;
mod timing;

use crate::data::Dataset;
use coupling::ByLoad;
pub use defect::{Defect, DefectKind};
use maneuver::effects::Flown;
pub use record::rough_noise;

/// Defects of a data set, worst kind first; none is what one hopes for. `simulated`: static groups, then runs, as
/// measured; `sigma`: one standard deviation of a sample of Fz, Mx, My in the same order.
pub fn defects(data: &Dataset, simulated: &[Flown], sigma: &[ByLoad<f64>]) -> Vec<Defect> {
    let rules = &data.rules;
    let records = record::records(data, simulated, sigma);
    let mut all = labels::everywhere(&rules.labels, &records);
    let everywhere = !all.is_empty();
    // each kind is looked for in what the kinds before have left: a mislabelled run is not late, too
    let mut add = |found: Vec<Defect>| {
        let new: Vec<Defect> =
            found.into_iter().filter(|defect| all.iter().all(|other| other.run != defect.run)).collect();
        all.extend(new);
    };
    add(samples::flat(&rules.samples, &records));
    if !everywhere {
        add(labels::by_run(&rules.labels, &records));
    }
    add(scales::by_run(&rules.scales, &records));
    add(airspeed::wrong(&rules.airspeed, &records));
    add(samples::spikes(&rules.samples, &records));
    add(timing::lags(&rules.timing, &records));
    // a run that is named already differs from its repeat of course
    let named: Vec<String> = all.iter().filter_map(|defect| defect.run.clone()).collect();
    all.extend(repeats::differ(&rules.repeats, &records, &named));
    all
}
