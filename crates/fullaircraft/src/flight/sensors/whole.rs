//! Loads on parts of the shipped wings.

use super::*;
use crate::aircraft::file::{AircraftFile, Surfaces};
use crate::flight::air::FlightAir;
use crate::flight::model::FlyingAircraft;
use coupling::WingFile;
use coupling::wing_file::Source;
use std::path::Path;

/// The shipped wings alone in the flow, with few boxes.
fn wings() -> Aircraft {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex");
    let mut file = AircraftFile::read(&data.join("aircraft.ron")).expect("shipped files are right");
    file.surfaces = Surfaces::WingsOnly;
    let mut wing = WingFile::read(&data.join("wing_beam.ron")).expect("shipped files are right");
    let Source::Parametric(planform) = &mut wing.source else { panic!("it is parametric") };
    planform.boxes.chordwise = 4;
    planform.controls.iter_mut().for_each(|control| control.chord_boxes = 1);
    Aircraft::new(file, wing).expect("an aircraft")
}

#[test]
fn in_a_sideslip_too_air_on_both_wings_adds_up_to_air_on_the_whole() {
    let aircraft = wings();
    let (model, air) = (aircraft.uncorrected(), FlightAir::new(&aircraft).expect("it can be solved"));
    let trimmed = model.trim("trim", &aircraft.file.trim).expect("it is trimmed");
    let drives = vec![aircraft.drive("outer").expect("ailerons")];
    let flying = FlyingAircraft::new(&model, &air, &trimmed, drives, None).expect("it flies");
    let (equations, sensors) = (&flying.equations, &flying.sensors);
    let mut state = equations.trimmed();
    // wind from the right, another angle of attack, all rates, ailerons
    state[1] = 3.0;
    state[2] -= 1.5;
    (state[3], state[4], state[5]) = (0.5, 0.3, -0.2);
    state[equations.layout.drive(0)] = 0.1;
    let evaluated = equations.evaluate(&state, &equations.no_inputs());
    let (loads, felt) = (sensors.loads_at(&state, &evaluated), felt(&state, &evaluated));
    let on_air = |row: usize| {
        loads[row] + felt.iter().enumerate().map(|(j, a)| sensors.inertia[(row, j)] * a).sum::<f64>()
    };
    let whole = 3 * (sensors.parts.len() - 1);
    let both = [0, 1, 2].map(|row| on_air(row) + on_air(3 + row));
    // roots lie on the x axis ahead of the centre of gravity, so only the lift's arm differs
    let ahead_m = aircraft.mass.centre.x - aircraft.root_point().x;
    let law = [on_air(whole), on_air(whole + 1), on_air(whole + 2) - ahead_m * on_air(whole)];
    assert!(law.iter().all(|load| load.abs() > 1.0), "{law:?}");
    for (row, (both, law)) in both.into_iter().zip(law).enumerate() {
        assert!((both - law).abs() < 1e-9 * law.abs(), "row {row}: {both} on the wings, {law} on the whole");
    }
}
