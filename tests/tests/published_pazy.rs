//! The Pazy wing (`data/pazy`): a beam of the measured stiffness beside what was measured on the wing
//! (data/published/pazy__*.json: Avin, Raveh, Drachinsky, Ben-Shmuel, Tur, AIAA J. 60(3), 2022).
//!
//! Goal: static bending and torsion, ground vibration, tip deflection in the wind, and lift factors near one; kind:
//! measured. The source's finite element model of 7800 elements is not in the data, so what is asked of "the same
//! finite elements" (1 % on its frequencies and on its linear tip deflections) cannot be met by a beam: the second is
//! held between known bounds. The onset of flutter hangs on geometric nonlinearity and is not computed.

use aero::{Corrections, Flow};
use calibrate::{Calibration, Campaign, LiftFactor, Settings, calibrate};
use coupling::{ElasticWing, Mount, RootPlane, SteadyCase, SteadyModel, WingFile};
use nastran::{BeamProperty, BulkData};
use serde_json::Value;
use std::f64::consts::TAU;
use validation::{assert_close, data, list, number, published};

const SEMISPAN_M: f64 = 0.55;
const G_M_S2: f64 = 9.806_65;
/// Of the mass's hook ahead of the elastic axis in the torsion test. Not in the files: it follows from the source's
/// model, whose twist is 5.8359 degrees a kilogram with the GJ that gives its divergence speed (data/pazy/README.md).
const ARM_M: f64 = 0.1219;
/// EI and GJ of the source's model: from its linear bending, 21.677 % of the semispan a kilogram, and from its divergence
/// at 100.966 m/s.
const SOURCES_MODEL_NM2: [f64; 2] = [4.5618, 6.4539];

fn wing() -> (WingFile, ElasticWing) {
    ElasticWing::read(&data("pazy/wing.ron")).expect("the shipped wing")
}

/// The wing with its beam and root changed.
fn wing_with(plane_m: f64, change: impl Fn(&mut BeamProperty)) -> ElasticWing {
    let mut file = wing().0;
    file.root_plane = Some(RootPlane::Symmetric(plane_m));
    let mut bulk: BulkData = file.bulk(Mount::Tunnel).expect("the shipped wing");
    bulk.beam_properties.values_mut().for_each(change);
    ElasticWing::from_bulk(&file, &bulk).expect("a beam and boxes")
}

/// EI and GJ times these factors.
fn scaled(property: &mut BeamProperty, [ei, gj]: [f64; 2]) {
    for station in &mut property.stations {
        station.i1 *= ei;
        station.j *= gj;
    }
}

/// Tip deflection per N at the tip, twist in rad per N m there.
fn flexibility(wing: &ElasticWing) -> [f64; 2] {
    let structure = wing.supported.as_ref().expect("a beam");
    let twist = structure.s_dofs.binary_search(&(structure.s_dofs[structure.tip_z] + 2)).expect("the tip's");
    [structure.flexibility[(structure.tip_z, structure.tip_z)], structure.flexibility[(twist, twist)]]
}

/// Rows (mass in kg, value) up to one kilogram, the empty one left out.
fn up_to_one_kilogram(rows: &Value) -> Vec<(f64, f64)> {
    let row = |row: &Value| (number(&row[0]), number(&row[1]));
    list(rows).iter().map(row).filter(|row| row.0 > 0.0 && row.0 <= 1.0).collect()
}

#[test]
fn static_bending_below_one_kilogram() {
    let case = published("pazy__pazy_static_bending_skin1");
    let [per_newton, _] = flexibility(&wing().1);
    let rows = up_to_one_kilogram(&case["expected"]["measured"]);
    assert_eq!(rows.len(), 5);
    for (mass_kg, per_cent) in rows {
        let got = -100.0 * per_newton * mass_kg * G_M_S2 / SEMISPAN_M;
        println!("{mass_kg} kg: {got:.2} % beside {per_cent:.2} %: {:+.1} %", 100.0 * (got / per_cent - 1.0));
        assert_close(&format!("tip under {mass_kg} kg"), got, per_cent, 0.05, 0.0);
    }
}

/// The twist is met. The tip sinks 9 to 13 % less than measured up to 0.8 kg: the same masses sank 11 to 13 % more in
/// this test than in the bending test, which no beam with one EI can follow, and the source's own model misses the
/// tolerance of 8 % at 0.2 and 0.4 kg as well. A known deviation, held between bounds.
#[test]
fn static_torsion_below_one_kilogram() {
    let case = published("pazy__pazy_static_torsion_skin1");
    let [per_newton, per_newton_metre] = flexibility(&wing().1);
    for (mass_kg, twist_deg) in up_to_one_kilogram(&case["expected"]["rot_deg"]) {
        let got = (per_newton_metre * ARM_M * mass_kg * G_M_S2).to_degrees();
        println!(
            "{mass_kg} kg: {got:.3} deg beside {twist_deg:.3}: {:+.1} %",
            100.0 * (got / twist_deg - 1.0)
        );
        assert_close(&format!("twist under {mass_kg} kg"), got, twist_deg, 0.08, 0.0);
    }
    let known = [-13.1, -12.0, -10.2, -8.7, -5.6];
    for ((mass_kg, per_cent), known) in up_to_one_kilogram(&case["expected"]["disp"]).into_iter().zip(known) {
        let off = 100.0 * (-100.0 * per_newton * mass_kg * G_M_S2 / SEMISPAN_M / per_cent - 1.0);
        println!("{mass_kg} kg: tip {off:+.1} %");
        assert!((off - known).abs() < 0.3, "{mass_kg} kg: {off} %, known {known} %");
    }
}

/// No mass is in the files. The first two bending frequencies fix the mass per length and the mass at the tip, the
/// torsional and the in-plane one the inertia and the in-plane stiffness: those four are fitted, and met with room for
/// the rounding of the shipped numbers only. The third bending frequency is the prediction.
#[test]
fn ground_vibration_test() {
    let case = published("pazy__pazy_gvt");
    let measured = &case["expected"]["gvt_skin_hz"];
    let wing = wing().1;
    let (system, _) = wing.structure.as_ref().expect("a beam");
    let modes = structure::normal_modes(system, 5).expect("five modes");
    let hz: Vec<f64> = modes.omega_rad_s.iter().map(|omega| omega / TAU).collect();
    let names = ["OOP1", "OOP2", "T1", "IP1", "OOP3"];
    for (name, hz) in names.into_iter().zip(hz) {
        let want = number(&measured[name]);
        let rel = if name == "OOP3" { number(&case["tolerance"]["vs_gvt"]) } else { 0.002 };
        println!("{name}: {hz:.2} Hz beside {want}: {:+.1} %", 100.0 * (hz / want - 1.0));
        assert_close(name, hz, want, rel, 0.0);
    }
}

/// The chain of lattice, spline and beam beside the source's linear solution (SOL 144, 36 by 18 boxes, its finite
/// element model): its bending stiffness and its divergence speed are given to the beam, its tip deflection is the
/// comparison. 4.2 % more at low speed, 3.8 % at 57.5 m/s: a third of it is a slit of 2.15 mm at the root of its lattice.
/// A known deviation (the case asks for 1 % with the same finite elements).
#[test]
fn the_source_s_linear_tip_deflection_with_the_stiffness_of_its_model() {
    let case = published("pazy__pazy_static_aeroelastic_aoa5");
    let to_source = |property: &mut BeamProperty| {
        scaled(property, [SOURCES_MODEL_NM2[0] / 4.726, SOURCES_MODEL_NM2[1] / 7.66]);
    };
    for (slit_m, known) in [(0.0, [4.2, 3.8]), (0.002_15, [2.7, 1.9])] {
        let mut wing = wing_with(-slit_m, to_source);
        // the source's run has no weight
        wing.gravity_m_s2 = 0.0;
        let neutral = Corrections::neutral(wing.correctable.len());
        let v_d = wing.divergence_speed(1.225, &neutral).expect("neutral").expect("it diverges");
        assert_close("divergence speed", v_d, 100.966, 0.005, 0.0);
        for row in list(&case["expected"]["gfem_sol144_linear_disp"]).iter().skip(2) {
            let (v_m_s, per_cent) = (number(&row[0]), number(&row[1]));
            let case = SteadyCase::new(Flow { v_m_s, rho_kg_m3: 1.225 }, 5.0_f64.to_radians());
            let tip_m = wing.tip_deflections(&[case], &neutral).expect("below divergence")[0];
            let off = 100.0 * (100.0 * tip_m / SEMISPAN_M / per_cent - 1.0);
            assert!(off < known[0] + 0.1 && off > known[1] - 0.2, "slit {slit_m} at {v_m_s} m/s: {off} %");
        }
    }
}

fn calibrated(wing: &ElasticWing, campaign: &str) -> Calibration {
    let campaign = Campaign::read(&data(&format!("pazy/{campaign}"))).expect("a shipped campaign");
    calibrate(wing, &campaign, &Settings::of_wing(&wing_file().correction)).expect("a calibration")
}

fn wing_file() -> WingFile {
    wing().0
}

fn lift(calibration: &Calibration) -> LiftFactor {
    calibration.common.as_ref().and_then(|common| common.lift.clone()).expect("a lift factor")
}

/// Largest distance of a row from the uncorrected model, and how many rows are within a tenth of their own deflection.
fn row_by_row(wing: &ElasticWing, calibration: &Calibration, zero_m: f64) -> (f64, usize) {
    let neutral = Corrections::neutral(wing.correctable.len());
    let (mut worst_m, mut within) = (0.0_f64, 0);
    for airspeed in &calibration.data.airspeeds {
        for angle in &airspeed.angles {
            let flow = Flow { v_m_s: airspeed.v_m_s, rho_kg_m3: calibration.rho_kg_m3 };
            let case = SteadyCase::new(flow, angle.alpha_rad);
            let tip_m = wing.tip_deflections(&[case], &neutral).expect("below divergence")[0];
            let (off, read) = ((tip_m + zero_m - angle.tip_z_m).abs(), (angle.tip_z_m - zero_m).abs());
            worst_m = worst_m.max(off);
            within += usize::from(off <= 0.1 * read);
        }
    }
    (worst_m, within)
}

/// Uncorrected tip deflection beside every reading below 15 % of the semispan, the zero of each sweep fitted. The
/// tolerance of 10 % is asked of the curve: its slope, and the rms of what is left over the largest reading.
#[test]
fn tip_deflection_against_dynamic_pressure() {
    let wing = wing().1;
    for campaign in ["tip_3deg", "tip_5deg", "tip_5deg_by_airspeed"] {
        let calibration = calibrated(&wing, campaign);
        let common = calibration.common.as_ref().expect("one set");
        let readings = calibration.data.airspeeds.iter().flat_map(|a| &a.angles).map(|angle| angle.tip_z_m);
        let largest = readings.clone().fold(0.0, f64::max);
        assert!(largest < 0.15 * SEMISPAN_M, "{largest}");
        let rms = common.fit.rmse[0][calibrate::campaign::TIP];
        let found = lift(&calibration);
        let slope = 1.0 / found.factor;
        let (worst_m, within) = row_by_row(&wing, &calibration, found.tip_zeros[0].0);
        println!("  rows within 10 % of their own reading: {within}; farthest {:.1} mm", 1e3 * worst_m);
        println!(
            "{campaign}: {} rows, model over measured slope {slope:.3}, rms {:.1} mm of {:.1} mm",
            common.rows,
            1e3 * rms,
            1e3 * largest
        );
        assert_close("slope", slope, 1.0, 0.10, 0.0);
        assert!(rms < 0.10 * largest, "{rms} of {largest}");
    }
}

/// Lift factors from tip deflections alone. The files derive 1.02 (3 degrees) and 0.97 (5 degrees) by hand from slopes
/// below 1000 Pa (labelled derived, low confidence); the factor here is found by the elastic model with the zero free.
#[test]
fn lift_factors_are_near_one_within_their_uncertainty() {
    let wing = wing().1;
    let softer = wing_with(0.0, |property| scaled(property, [1.0, SOURCES_MODEL_NM2[1] / 7.66]));
    for (campaign, derived) in [("tip_3deg", 1.02), ("tip_5deg", 0.97), ("tip_5deg_by_airspeed", 0.97)] {
        let calibration = calibrated(&wing, campaign);
        assert!(calibration.failures().is_empty(), "{:?}", calibration.failures());
        let common = calibration.common.as_ref().expect("one set");
        let (found, with_less_gj) = (lift(&calibration), lift(&calibrated(&softer, campaign)));
        let (zero_m, zero_sigma_m) = found.tip_zeros[0];
        println!(
            "{campaign}: lift factor {:.3} +- {:.3} (with the GJ of the source's model {:.3}), rho {:.2}, zero {:.1} +- {:.1} mm",
            found.factor,
            found.sigma,
            with_less_gj.factor,
            found.correlation,
            1e3 * zero_m,
            1e3 * zero_sigma_m
        );
        assert!((found.factor - 1.0).abs() < 0.10, "{found:?}");
        assert!((found.factor - derived).abs() < 2.0 * found.sigma, "{found:?} beside {derived}");
        // rows of a slow sweep: a few per cent, not the third of a per cent that independent rows would claim
        assert!((0.02..0.06).contains(&found.sigma), "{found:?}");
        assert!(zero_m.abs() < 0.009, "{found:?}");
        // a softer wing washes in more, so theory needs less lift: the torsion test's doubt about GJ is a doubt of 3 %
        let less = found.factor - with_less_gj.factor;
        assert!((0.0..0.05).contains(&less), "{with_less_gj:?}");
        // the set of corrections is that factor: the data do not ask for a distribution, and could not give one
        assert!((common.mean_force_factor - found.factor).abs() < 1e-9);
        let told = common.identifiability.as_ref().expect("a regular metric");
        assert_eq!(told.determined_directions, 1, "{:?}", told.singular_values);
        assert!(told.mean_force_sigma[1] > 0.8 * told.mean_force_sigma[0], "{:?}", told.mean_force_sigma);
    }
}
