//! A wing calibrated by measured root loads: what the corrections do to the loads, and what the data determine.
//!
//! `calibrate_a_wing WING.ron CAMPAIGN_FOLDER`, say with `data/weber_brebner/wing.ron data/weber_brebner`.

use calibrate::{Campaign, Settings, calibrate};
use coupling::ElasticWing;
use std::error::Error;
use std::io::Write;

fn main() -> Result<(), Box<dyn Error>> {
    let mut out = std::io::stdout().lock();
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [wing, campaign] = arguments.as_slice() else {
        return Err("expected WING.ron CAMPAIGN_FOLDER".into());
    };
    let (file, wing) = ElasticWing::read(wing.as_ref())?;
    let campaign = Campaign::read(campaign.as_ref())?;
    let calibration = calibrate(&wing, &campaign, &Settings::of_wing(&file.correction))?;
    for airspeed in &calibration.airspeeds {
        let [before, after] = airspeed.fit.objective;
        writeln!(out, "{} m/s: F {before:.4} -> {after:.4}, {:?}", airspeed.data.v_m_s, airspeed.fit.ending)?;
        if let Some(told) = &airspeed.identifiability {
            writeln!(out, "    the data determine {} directions of corrections", told.determined_directions)?;
        }
    }
    Ok(())
}
