//! A declared maneuver flown in the tunnel's unsteady air by the wing without corrections, as a CSV of loads.
//!
//! `fly_a_maneuver WING.ron MANEUVER.ron > history.csv`, say with `data/tuflex/wing_beam.ron data/tuflex/maneuvers/doublet.ron`.

use aero::{Corrections, Flow};
use coupling::ElasticWing;
use maneuver::{ManeuverFile, Rig, RigSettings};
use std::error::Error;
use std::io::Write;

fn main() -> Result<(), Box<dyn Error>> {
    let mut out = std::io::stdout().lock();
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [wing, maneuver] = arguments.as_slice() else {
        return Err("expected WING.ron MANEUVER.ron".into());
    };
    let (file, wing) = ElasticWing::read(wing.as_ref())?;
    let maneuver = ManeuverFile::read(maneuver.as_ref())?;
    let controls = wing.control_names();
    for remark in maneuver.checked(&file, &controls)? {
        writeln!(std::io::stderr(), "{remark}")?;
    }
    let settings = maneuver.settings(&RigSettings::of_wing(&file));
    let rig = Rig::new(&wing, settings)?;
    let flow = Flow { v_m_s: maneuver.v_m_s, rho_kg_m3: maneuver.rho_kg_m3 };
    // corrections of a calibration take the place of neutral ones
    let model = rig.at(flow, &Corrections::neutral(wing.correctable.len()))?;
    writeln!(out, "{}", model.fly(&maneuver.motion(&model)).to_csv())?;
    Ok(())
}
