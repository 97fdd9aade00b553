//! Which loads a campaign has, of which its noise is stated, and what of its files is not used: a campaign of one's own
//! may lack channels, or have others.

use calibrate::Campaign;
use calibrate::campaign::{CHANNELS, ChannelNoise};
use coupling::ByLoad;
use maneuver::Run;
use nastran::InputError;
use std::path::Path;

/// Names of the root loads that residuals are made of.
pub(crate) const LOADS: [&str; 3] = ["Fz_N", "Mx_Nm", "My_Nm"];

/// Which loads the runs have: the same in all that have any.
pub(crate) fn run_loads(
    campaign: &Campaign,
    runs: &[Run],
    listed_in: &Path,
) -> Result<[bool; 3], InputError> {
    let of = |run: &Run| [0, 1, 2].map(|c| run.load(c).is_some());
    let mut measured = (0..runs.len()).filter(|i| of(&runs[*i]).contains(&true));
    let Some(first) = measured.next() else {
        if campaign.channels.contains(&true) {
            return Ok([false; 3]);
        }
        let message = "neither a static point nor a run has a root load Fz_N, Mx_Nm or My_Nm";
        return Err(InputError::in_file(listed_in, message)
            .with_help("a missing effect is looked for in root loads; other channels are not searched"));
    };
    let all = of(&runs[first]);
    for i in measured {
        if let Some(c) = (0..3).find(|&c| of(&runs[i])[c] != all[c]) {
            let (with, without) = if all[c] { (first, i) } else { (i, first) };
            let [with, without] = [with, without].map(|i| campaign.runs[i].file.as_str());
            let name = CHANNELS[c];
            let message = format!("{without} has no column {name}, and {with} has one");
            return Err(InputError::in_file(listed_in, message).with_help(
                "runs have the same loads: take the column out of all of them, or leave out runs",
            ));
        }
    }
    Ok(all)
}

/// Standard deviations as a campaign states them; zero for a load of which none is stated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StatedNoise {
    /// Of a sample of a run, N and N m.
    pub sample: ByLoad<f64>,
    /// Of a static point.
    pub point: ByLoad<f64>,
}

/// Stated noise, if there is any of a channel that is there.
pub(crate) fn stated(campaign: &Campaign, run_loads: [bool; 3]) -> Option<StatedNoise> {
    let noise = campaign.noise.as_ref()?;
    let [sample, point] = [noise.sample, noise.static_point].map(ChannelNoise::to_array);
    let of = |sigma: [f64; 4], there: &[bool]| {
        ByLoad::from_fn(|load| if there[load as usize] { sigma[load as usize] } else { 0.0 })
    };
    Some(StatedNoise { sample: of(sample, &run_loads), point: of(point, &campaign.channels) })
}

/// Columns and runs that nothing is made of.
pub(crate) fn not_used(campaign: &Campaign, runs: &[Run]) -> Vec<String> {
    let tip = campaign.points.iter().any(|point| point.tip_z_m.is_some())
        || runs.iter().any(|run| run.tip_z_m.is_some());
    let mut columns: Vec<String> =
        runs.iter().flat_map(|run| &run.accelerations).map(|a| a.0.clone()).collect();
    columns.sort();
    columns.dedup();
    let mut all: Vec<String> = columns.iter().map(|name| format!("az_{name}_m_s2")).collect();
    all.extend(tip.then(|| "tip_z_m".to_owned()));
    let silent = runs.iter().filter(|run| (0..3).all(|c| run.load(c).is_none()));
    all.extend(silent.map(|run| format!("{} (it has no loads)", run.name)));
    all
}
