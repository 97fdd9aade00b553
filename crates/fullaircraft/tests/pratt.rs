//! Pratt's formula beside the gust that it stands for, flown: H = 12.5 chords, the structure rigid, pitch held.

use fullaircraft::flight::loads::LoadedTrim;
use fullaircraft::{
    Aircraft, AircraftFile, Component, FlightAir, FlightLoads, FlightPoint, Gust, GustAxis, Steady, TrimTools,
};
use loads::Air;
use loads::rules::pratt::Pratt;

/// A gust that the shipped aircraft stands, m/s.
const U_DE_M_S: f64 = 3.0;
const CHORDS: f64 = 12.5;

/// The shipped aircraft with beams, so slow in pitch that a gust does not turn it.
fn held_in_pitch() -> Aircraft {
    let mut file = AircraftFile::read(&crate::common::path()).expect("shipped files are right");
    let total = &mut file.total;
    // no body is hard to turn about one axis alone
    (total.ixx_kg_m2, total.iyy_kg_m2, total.izz_kg_m2) = (1e5, 1e5, 1e5);
    let wing = coupling::WingFile::read(&crate::common::beam_wing()).expect("shipped files are right");
    Aircraft::new(file, wing).expect("a body that is hard to turn")
}

#[test]
fn a_gust_of_twelve_and_a_half_chords_on_the_rigid_aircraft_loads_it_as_pratts_formula_says() {
    let aircraft = held_in_pitch();
    let air = FlightAir::new(&aircraft).unwrap().rigid();
    let model = aircraft.uncorrected();
    let tools = TrimTools::new(&aircraft, &[]).unwrap();
    for v_m_s in [25.0, 37.0] {
        let at = tools.at(&model, v_m_s).unwrap();
        let found = at.solve(&Steady::Level.case(&aircraft.file, v_m_s)).unwrap();
        let point = FlightPoint { v_m_s, load_factor: 1.0, pitch_rate_deg_s: 0.0 };
        let trimmed = at.trimmed(&found, &point);
        let steady = at.nodal_loads(&found);
        let axis = GustAxis::Vertical;
        let trim =
            LoadedTrim { model: &model, air: &air, trimmed: &trimmed, steady, drives: Vec::new(), axis };
        let whole = aircraft.body_stations().pop().expect("the whole is last");
        let flight = FlightLoads::new(trim, vec![whole], 0.001).unwrap();
        let airframe = aircraft.airframe(&model, v_m_s).unwrap();
        let formula = Pratt::of(&airframe, aircraft.mass.mass_kg, &Air::at(0.0), v_m_s, U_DE_M_S).delta_n;
        let length_m = 2.0 * CHORDS * airframe.mean_chord_m;
        let flown = flight.fly(Some(Gust { velocity_m_s: U_DE_M_S, length_m, start_s: 0.0 }), &[], 400);
        let lift = |sample: usize| flown.at_station(0, Component::Air, sample)[2];
        let largest = (0..400).map(lift).fold(0.0, f64::max);
        let delta_n = largest / lift(0) - 1.0;
        println!(
            "{v_m_s} m/s: {delta_n:.4} flown, {formula:.4} by the formula: {:+.2} %",
            100.0 * (delta_n / formula - 1.0)
        );
        assert!(
            (-0.02..0.10).contains(&(delta_n / formula - 1.0)),
            "{v_m_s} m/s: {delta_n} flown, {formula} by the formula"
        );
    }
}
