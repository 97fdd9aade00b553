//! The aircraft around a wing, trimmed in the steady points of its file, with and without corrections.
//!
//! `trim_an_aircraft AIRCRAFT.ron`, say with `data/tuflex/aircraft.ron`. The corrections take a tenth of the lift away at the
//! tips; those of a calibration (`Schedule::at` of the crate `calibrate`) take their place.

use aero::Corrections;
use fullaircraft::{Aircraft, FlightModel};
use std::error::Error;
use std::io::Write;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [file] = arguments.as_slice() else {
        return Err("expected AIRCRAFT.ron".into());
    };
    let aircraft = Aircraft::read(file.as_ref(), None)?;
    // of one wing's boxes, in their order; mirrored to the left wing, while tail and fuselage stay as they are
    let boxes = &aircraft.right.boxes;
    let y_m = |place: &usize| aircraft.flow.lattice.boxes[*place].mid_point().y;
    let tip_y_m = boxes.iter().map(y_m).fold(0.0, f64::max);
    let mut corrections = Corrections::neutral(boxes.len());
    for (factor, place) in corrections.force.iter_mut().zip(boxes) {
        *factor -= 0.1 * y_m(place) / tip_y_m;
    }
    show("theory", &aircraft, &aircraft.uncorrected())?;
    show("corrected", &aircraft, &aircraft.with_corrections(&corrections)?)
}

fn show(name: &str, aircraft: &Aircraft, model: &FlightModel<'_>) -> Result<(), Box<dyn Error>> {
    let mut out = std::io::stdout().lock();
    let file = &aircraft.file;
    for (maneuver, point) in
        [("trim", &file.trim), ("pull-up", &file.pull_up), ("push-down", &file.push_down)]
    {
        let trimmed = model.trim(maneuver, point)?;
        writeln!(
            out,
            "{name}, {maneuver}: alpha {:.2} deg, elevator {:.2} deg, tip {:.3} m",
            trimmed.alpha_rad.to_degrees(),
            trimmed.elevator_rad.to_degrees(),
            trimmed.tip_deflection_m[0]
        )?;
    }
    Ok(())
}
