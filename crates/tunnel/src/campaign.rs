//! A campaign folder as texts: `campaign.ron`, `static.csv` and the runs.

use crate::file::TunnelFile;
use crate::runs;
use crate::statics::{self, StaticRow};
use crate::truth::{Truth, TunnelError};
use coupling::ByLoad;
use std::fmt::Write as _;

/// What a campaign folder holds, before it is written.
#[derive(Debug, Clone, PartialEq)]
pub struct Campaign {
    /// Seed of its random numbers.
    pub seed: u64,
    /// The rows of `static.csv`.
    pub rows: Vec<StaticRow>,
    /// File names and texts.
    pub files: Vec<(String, String)>,
}

/// Measures everything a tunnel file asks for. The same seed gives the same texts.
///
/// # Errors
/// If the true wing diverges or its sections do not settle.
pub fn campaign(tunnel: &TunnelFile, truth: &Truth, seed: u64) -> Result<Campaign, TunnelError> {
    let rows = statics::measure(tunnel, truth, seed)?;
    let mut files = vec![("static.csv".to_owned(), statics::csv(&rows))];
    files.extend(runs::measure(tunnel, truth, seed)?);
    files.push(("campaign.ron".to_owned(), entry(tunnel)));
    Ok(Campaign { seed, rows, files })
}

/// `campaign.ron`.
fn entry(tunnel: &TunnelFile) -> String {
    let noise = |ByLoad { fz, mx, my }: ByLoad<f64>| format!("(fz_N: {fz:?}, mx_Nm: {mx:?}, my_Nm: {my:?})");
    let mut text = String::from("// Virtual measurements: README.md beside this file says whose.\n");
    let _ = write!(
        text,
        "Campaign(\n    name: {:?},\n    rho_kg_m3: {:?},\n    // One standard deviation.\n    noise: Some((\n        \
         sample: {},\n        static_point: {},\n    )),\n    static_cases: \"static.csv\",\n    runs: [\n",
        tunnel.name,
        tunnel.rho_kg_m3,
        noise(tunnel.noise.sample),
        noise(tunnel.noise.static_point),
    );
    for run in &tunnel.runs {
        let _ = write!(text, "        (file: {:?}, use: {:?}", run.file, run.purpose);
        for (field, value) in [("block", &run.block), ("repeat_of", &run.repeat_of)] {
            if let Some(value) = value {
                let _ = write!(text, ", {field}: {value:?}");
            }
        }
        text.push_str(if run.v_m_s == 0.0 { ", wind_off: true),\n" } else { "),\n" });
    }
    text.push_str("    ],\n)\n");
    text
}
