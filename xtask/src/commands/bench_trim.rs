//! The time of 1000 trim cases of the shipped aircraft: 50 maneuvers at ten airspeeds with two models, loads at eight stations included.

use coupling::wing_file::StationAt;
use fullaircraft::cases::grid::CaseResult;
use fullaircraft::cases::list::{Case, groups};
use fullaircraft::{Aircraft, CaseFlight, CasesFile, TrimTools};
use rayon::prelude::*;
use serde_json::{Value, json};

use super::bench_clock::{median, row};
use crate::repository;
use wingroot::failure::Failure;

/// Airspeeds; 50 cases at each of them, with each model.
const AIRSPEEDS: usize = 10;

/// One row: from the assembled aircraft to the loads of all cases.
pub(crate) fn rows() -> Result<Vec<Value>, Failure> {
    let aircraft = Aircraft::read(&repository::path("data/tuflex/aircraft.ron"), None)?;
    let stations =
        [0.45, 0.9, 1.35].map(|y_m| StationAt { name: format!("y{y_m}"), y_m, x_m: None, z_m: None });
    let file = grid(&stations);
    let cases: Vec<Case> = file.cases();
    let mut factorisations = 0;
    let seconds = median(|| {
        let tools = TrimTools::new(&aircraft, &stations)?;
        let (initial, updated) = (aircraft.uncorrected(), aircraft.uncorrected());
        let flight = CaseFlight { tools: &tools, models: [&initial, &updated], air: None, limits: None };
        groups(&cases).par_iter().try_for_each(|group| {
            flight.fly(group, &mut |_: &Case, result: CaseResult| match result.refused {
                Some(why) => Err(Failure::Computation(why)),
                None => Ok(()),
            })
        })?;
        factorisations = tools.factorisations();
        Ok(())
    })?;
    let mut row = row(&format!("trim_{}_cases_{}_boxes", cases.len(), aircraft.flow.lattice.len()), seconds);
    row["factorisations"] = json!(factorisations);
    Ok(vec![row])
}

fn grid(stations: &[StationAt]) -> CasesFile {
    use fullaircraft::cases::file::{Maneuver, Trims};
    let control = || "outer".to_owned();
    // level, 24 pull-ups and 25 rolls: 50 at each airspeed
    let load_factors: Vec<f64> = (0..25).map(|k| 1.0 + 0.125 * f64::from(k)).collect();
    CasesFile {
        name: "bench".to_owned(),
        airspeeds_v_m_s: (0..AIRSPEEDS).map(|k| 22.0 + 2.0 * k as f64).collect(),
        load_factors,
        maneuvers: vec![
            Maneuver::Other(Trims::Level),
            Maneuver::Other(Trims::Pull),
            Maneuver::Other(Trims::Roll { control: control(), rates_deg_s: vec![30.0] }),
        ],
        stations: stations.to_vec(),
        ..CasesFile::default()
    }
}
