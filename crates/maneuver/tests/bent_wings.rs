//! Flutter about bent wings beside codes: the Pazy beam with skin straight and swept (UM/NAST; SHARPy and FENIAX), the wing of sixteen
//! metres of Patil, Hodges and Cesnik (J. Aircraft, 2001).

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use crate::large::pazy_beam::{Station, swept};
use crate::large::{Flat, SEMISPAN_M, heavy_flat_wing, with_skin};
use aero::{BoxLoads, Corrections, Flow, Lattice, MirrorPlane};
use coupling::{LargeState, LargeWing, RootLoads, SteadyCase};
use maneuver::flutter::{BentCrossing, BentFlutter, BentSweep};
use nalgebra::Vector3;
use serde_json::Value;
use std::path::Path;
use structure::nonlinear::{Loads, NodeLoad};

fn published(name: &str) -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../data/published/{name}.json"));
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

fn pairs(case: &Value, name: &str) -> Vec<[f64; 2]> {
    let pair = |row: &Value| [0, 1].map(|at| row[at].as_f64().unwrap());
    case["expected"][name].as_array().unwrap().iter().map(pair).collect()
}

fn is_slow_run() -> bool {
    std::env::var_os("RUN_SLOW_TESTS").is_some()
}

fn task(wing: &LargeWing, alpha_deg: f64, rho_kg_m3: f64, modes: usize) -> BentFlutter<'_> {
    BentFlutter { wing, alpha_rad: alpha_deg.to_radians(), rho_kg_m3, modes, damping_ratio: 0.0 }
}

fn over(wing: &LargeWing, alpha_deg: f64, airspeeds: &[f64]) -> BentSweep {
    let neutral = Corrections::neutral(wing.elastic.correctable.len());
    task(wing, alpha_deg, 1.225, 7).over(airspeeds, &|_| neutral.clone()).unwrap()
}

fn off(own: f64, of: f64) -> f64 {
    (own / of - 1.0).abs()
}

#[test]
fn the_beam_of_the_codes_begins_to_flutter_where_they_say_at_every_root_angle() {
    if !is_slow_run() {
        eprintln!(
            "skipped: flutter of the Pazy beam at 3, 5 and 7 degrees takes a minute (RUN_SLOW_TESTS=1)"
        );
        return;
    }
    let wing = with_skin([18, 36], 0.0);
    let case = published("nl_pazy__flutter_onset_over_angle");
    let (onsets, offsets) = (pairs(&case, "UMNAST_onset"), pairs(&case, "UMNAST_offset"));
    let at = |rows: &[[f64; 2]], alpha: f64| rows.iter().find(|row| row[0] == alpha).unwrap()[1];
    for alpha in [3.0, 5.0, 7.0] {
        let (onset, offset) = (at(&onsets, alpha), at(&offsets, alpha));
        let airspeeds =
            [0.5 * onset, 0.8 * onset, 0.95 * onset, onset, 0.5 * (onset + offset), offset, 1.1 * offset];
        let sweep = over(&wing, alpha, &airspeeds);
        println!("{alpha} deg, UM/NAST {onset} to {offset}: {:?}", sweep.crossings);
        let found = |unstable: bool| sweep.crossings.iter().find(|c| c.unstable == unstable).unwrap().v_m_s;
        assert!(off(found(true), onset) < 0.05, "{alpha} deg: onset {} for {onset}", found(true));
        assert!(off(found(false), offset) < 0.06, "{alpha} deg: offset {} for {offset}", found(false));
    }
}

#[test]
fn the_swept_beam_bends_and_flutters_as_the_codes_say() {
    if !is_slow_run() {
        eprintln!("skipped: flutter of the swept Pazy beam takes a minute (RUN_SLOW_TESTS=1)");
        return;
    }
    let wing = with_skin([18, 36], 10.0_f64.to_radians());
    let case = published("nl_pazy__swept10");
    let neutral = Corrections::neutral(wing.elastic.correctable.len());
    let cases = [30.0, 50.0, 70.0]
        .map(|v_m_s| SteadyCase::new(Flow { v_m_s, rho_kg_m3: 1.225 }, 7.0_f64.to_radians()));
    let states = wing.solve(&cases, &neutral).unwrap();
    let last = states.last().unwrap();
    let tip = last.state.places[15] / SEMISPAN_M;
    let wanted = pairs(&case, "shape_10deg_7deg_70m_s_y_z_over_span").pop().unwrap();
    println!("tip y {} for {}, z {} for {}", tip.y, wanted[0], tip.z, wanted[1]);
    let mut misses = Vec::new();
    for [alpha, onset] in pairs(&case, "flutter_onset_aoa_m_s_10deg")
        .into_iter()
        .filter(|row| [7.0, 5.0, 3.0, 1.0].contains(&row[0]))
    {
        let airspeeds = [0.5, 0.75, 0.9, 0.96, 1.02, 1.1].map(|share| share * onset);
        let sweep = over(&wing, alpha, &airspeeds);
        println!("{alpha} deg, codes {onset}: {:?}", sweep.crossings);
        let found = sweep
            .crossings
            .iter()
            .find(|crossing| crossing.unstable)
            .map_or(f64::NAN, |crossing| crossing.v_m_s);
        misses.push((alpha, found, off(found, onset)));
    }
    assert!(off(tip.z, wanted[1]) < 0.06, "tip {} for {}", tip.z, wanted[1]);
    assert!(misses.iter().all(|miss| miss.2 < 0.06), "{misses:?}");
}

/// The wing of sixteen metres, uniform, in `elements` beams, with boxes along chord and span.
fn sixteen_metres(elements: usize, divisions: [u32; 2]) -> LargeWing {
    let case = published("nl_hale__patil_flutter");
    let of = |name: &str| case["inputs"][name].as_f64().unwrap();
    let length = of("span_m");
    let station = |at: usize| -> Station {
        let share = if at == 0 || at == elements { 0.5 } else { 1.0 };
        let reach = share * length / elements as f64;
        let mass = of("mass_per_length") * reach;
        let pitch = of("inertia_pitch_kg_m") * reach;
        // Axial stiffness beyond all else.
        let stiffness =
            [1e9, of("GJ_Nm2"), of("EI_flat_Nm2"), of("EI_chord_Nm2"), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let mut row = vec![length * at as f64 / elements as f64];
        row.extend(stiffness);
        row.extend([mass, 0.0, 0.0, 0.0, 0.0, pitch, pitch]);
        row
    };
    let rows: Vec<Station> = (0..=elements).map(station).collect();
    let axis = of("elastic_axis") * of("chord_m");
    let plane = MirrorPlane::Symmetric { y_m: 0.0 };
    let flat = Flat {
        axis: of("elastic_axis"),
        chord_m: of("chord_m"),
        inner_m: 0.0,
        sweep_rad: 0.0,
        divisions,
        plane,
    };
    heavy_flat_wing(&swept(&rows, axis, 0.0), &flat)
}

/// The wing held up by a force on its tip alone, N: no steady air.
fn held_up(wing: &LargeWing, force_n: f64) -> LargeState {
    let tip = wing.structure.nodes().len() - 1;
    let force = Vector3::z() * force_n;
    let loads =
        Loads { dead: vec![NodeLoad { node: tip, force, moment: Vector3::zeros() }], ..Loads::default() };
    let state = wing.structure.under(&loads).unwrap().end().state.clone();
    LargeState {
        forces: wing.structure.load_forces(&state, &loads),
        lattice: Lattice { boxes: Vec::new(), surfaces: Vec::new() },
        cp: Vec::new(),
        box_loads: BoxLoads { values: Vec::new() },
        root: RootLoads { fz_n: 0.0, mx_nm: 0.0, my_nm: 0.0 },
        tip_m: state.places[tip] - wing.wind_off().places[tip],
        twist_rad: 0.0,
        state,
        iterations: 0,
        gain: 0.0,
    }
}

/// Airspeed (m/s) between two at which an oscillation of the held wing begins to grow.
fn onset(task: &BentFlutter<'_>, state: &LargeState, [mut slow, mut fast]: [f64; 2]) -> f64 {
    let neutral = Corrections::neutral(task.wing.elastic.correctable.len());
    let growth = |v_m_s: f64| {
        let case = SteadyCase::new(Flow { v_m_s, rho_kg_m3: task.rho_kg_m3 }, 0.0);
        let point = task.about(&case, &neutral, state.clone()).unwrap();
        // Motions in the plane of a flat wing meet no air.
        let damped =
            point.roots.iter().flatten().filter(|root| root.im > 0.1 && root.re.abs() > 1e-5 * root.im);
        damped.map(|root| root.re).fold(f64::NEG_INFINITY, f64::max)
    };
    let [mut low, mut high] = [slow, fast].map(growth);
    assert!(low < 0.0 && high > 0.0, "grows by {low} at {slow} m/s and by {high} at {fast}");
    let mut found = slow;
    for _ in 0..4 {
        found = slow + (fast - slow) * low / (low - high);
        let rate = growth(found);
        if rate > 0.0 {
            (fast, high, low) = (found, rate, 0.5 * low);
        } else {
            (slow, low, high) = (found, rate, 0.5 * high);
        }
    }
    found
}

/// A table that rises, and what stands beside it, at a place between its rows.
fn between(rising: &[f64], of: &[f64], at: f64) -> f64 {
    let upper = rising.partition_point(|value| *value < at).clamp(1, rising.len() - 1);
    let share = (at - rising[upper - 1]) / (rising[upper] - rising[upper - 1]);
    of[upper - 1] + share * (of[upper] - of[upper - 1])
}

fn list(table: &Value, name: &str) -> Vec<f64> {
    table[name].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect()
}

#[test]
fn a_wing_that_is_held_bent_flutters_where_the_curve_over_its_tip_says() {
    let case = published("nl_hale__patil_flutter");
    let wing = sixteen_metres(16, [8, 32]).weightless().unwrap();
    let curve = &case["expected"]["flutter_speed_vs_tip_displacement"];
    let (tips, speeds) = (list(curve, "tip_m"), list(curve, "V_m_s"));
    let wanted = |tip: f64| between(&tips, &speeds, tip);
    let task = task(&wing, 0.0, case["inputs"]["rho"].as_f64().unwrap(), 8);
    for (force_n, tolerance) in [(0.0, 0.03), (18.0, 0.06), (24.0, 0.12)] {
        let state = held_up(&wing, force_n);
        let of = wanted(state.tip_m.z);
        let own = onset(&task, &state, [0.8 * of, 1.2 * of]);
        println!("tip {:.3} m: flutter from {own:.2} m/s for {of:.2}", state.tip_m.z);
        assert!(off(own, of) < tolerance, "tip {:.3} m: {own} m/s for {of}", state.tip_m.z);
    }
}

#[test]
fn a_wing_that_its_lift_bends_flutters_as_the_curves_over_its_root_angle_say() {
    if !is_slow_run() {
        eprintln!(
            "skipped: flutter of the wing of sixteen metres over its root angle takes half a minute (RUN_SLOW_TESTS=1)"
        );
        return;
    }
    let case = published("nl_hale__patil_flutter");
    let wing = sixteen_metres(16, [8, 32]);
    let neutral = Corrections::neutral(wing.elastic.correctable.len());
    let speeds = &case["expected"]["flutter_speed_vs_root_aoa"];
    let wanted = |alpha: f64| between(&list(speeds, "aoa_deg"), &list(speeds, "V_m_s"), alpha);
    let airspeeds: Vec<f64> = (0..=24).map(|at| 10.0 + f64::from(at)).collect();
    let rest = wing.wind_off().places.last().unwrap().z;
    let mut misses = Vec::new();
    for alpha in [1.0, 2.0, 3.0, 4.0] {
        let sweep = task(&wing, alpha, case["inputs"]["rho"].as_f64().unwrap(), 8)
            .over(&airspeeds, &|_| neutral.clone())
            .unwrap();
        // Slower, with the tip hanging down by 2 m, a root of next to no damping crosses back and forth; the source's does not.
        let risen = |crossing: &&BentCrossing| crossing.unstable && crossing.tip_z_m + rest > 0.0;
        let (own, tip) = sweep
            .crossings
            .iter()
            .find(risen)
            .map_or((f64::NAN, f64::NAN), |found| (found.v_m_s, found.tip_z_m + rest));
        println!(
            "{alpha} deg: flutter from {own:.2} m/s for {:.2}, the tip at {tip:.3} m; {:?}; {:?}",
            wanted(alpha),
            sweep.crossings,
            sweep.ended
        );
        misses.push((alpha, tip, off(own, wanted(alpha))));
    }
    // The case allows a lattice 10 % beside its strips, and 12 % above 1.5 m.
    assert!(misses.iter().all(|(_, tip, off)| *off < if *tip < 1.5 { 0.1 } else { 0.12 }), "{misses:?}");
}
