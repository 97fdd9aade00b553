//! Decks of the aeroelastic handbooks' examples beside what was printed of them, each as its command reads it: HA144B, HA145B, HA145E,
//! the kind of HA146A and B, and NASA's D10-02. Sources stand in the cases (data/published).

use faer::c64;
use fullaircraft::{
    DynamicAnswer, Elastic, FlutterDeck, FlutterPoints, FlutterRoots, GustDeck, TrimDeck, deck_cases,
    flutter_cases, gust_cases,
};
use maneuver::flutter::{CompleteCurves, GafTable, GeneralisedForces, KRoot, Root};
use nastran::{BulkData, read_deck};
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::f64::consts::TAU;
use std::path::{Path, PathBuf};

fn published(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/published").join(name)
}

fn deck(name: &str) -> BulkData {
    read_deck(&published(&format!("decks/{name}.bdf"))).unwrap_or_else(|error| panic!("{error}"))
}

fn case(name: &str) -> Value {
    let text = std::fs::read_to_string(published(&format!("{name}.json"))).expect("a case");
    serde_json::from_str::<Value>(&text).expect("JSON")["expected"].clone()
}

fn numbers<T: DeserializeOwned>(value: &Value) -> T {
    serde_json::from_value(value.clone()).unwrap_or_else(|error| panic!("{error}: {value}"))
}

fn near(what: &str, ours: f64, printed: f64, share: f64) {
    assert!((ours - printed).abs() <= share * printed.abs(), "{what}: {ours} beside {printed}");
}

/// A deck of flutter and the answers to its subcases, which have the same boundary conditions.
struct Flown {
    deck: FlutterDeck,
    answers: Vec<FlutterRoots>,
}

impl Flown {
    fn new(name: &str) -> Self {
        let bulk = self::deck(name);
        let cases = flutter_cases(&bulk).unwrap_or_else(|error| panic!("{error}"));
        let deck = FlutterDeck::new(&bulk, &cases[0].0).unwrap_or_else(|error| panic!("{error}"));
        let answer = |card| {
            let points = deck.points(&bulk, card).unwrap_or_else(|error| panic!("{error}"));
            let table = |mach: f64| (mach, deck.forces(mach).expect("forces"));
            let machs =
                points.iter().flat_map(FlutterPoints::machs).map(|mach| deck.modal.nearest_mach(mach));
            let tables: Vec<(f64, GafTable)> = machs.map(table).collect();
            deck.roots(&points[0], &tables).expect("roots")
        };
        let answers = cases.iter().map(|(_, card)| answer(card)).collect();
        Self { deck, answers }
    }

    fn hz(&self) -> Vec<f64> {
        self.deck.modal.omega_rad_s.iter().map(|omega| omega / TAU).collect()
    }

    fn curves(&self, subcase: usize) -> &CompleteCurves {
        match &self.answers[subcase] {
            FlutterRoots::Curves(curves) => curves,
            FlutterRoots::ByFrequency(_) => panic!("subcase {subcase} asks for airspeeds"),
        }
    }

    /// The roots at a reduced frequency, each seen as `of` does.
    fn at(&self, subcase: usize, k: f64, of: fn(&KRoot) -> [f64; 2]) -> Vec<[f64; 2]> {
        let FlutterRoots::ByFrequency(list) = &self.answers[subcase] else {
            panic!("subcase {subcase} asks for reduced frequencies")
        };
        let found = list.iter().find(|(own, _)| (own - k).abs() < 1e-9);
        found.expect("a reduced frequency of the list").1.iter().map(of).collect()
    }
}

/// Demands a root at the airspeed with the printed damping and frequency.
fn met(curves: &CompleteCurves, v: f64, [g, hz]: [f64; 2], [share_hz, off_g]: [f64; 2]) {
    let place = curves.flows.iter().position(|flow| (flow.v_m_s - v).abs() < 1e-6 * v).expect("an airspeed");
    let roots: Vec<&Root> = curves.branches.iter().filter_map(|branch| branch.at(place)).collect();
    let is_met = |root: &&Root| {
        let is_near = (root.frequency_hz() / hz - 1.0).abs() < share_hz;
        is_near && root.damping_g().is_some_and(|own| (own - g).abs() < off_g)
    };
    let all = || roots.iter().map(|root| (root.frequency_hz(), root.damping_g())).collect::<Vec<_>>();
    assert!(roots.iter().any(is_met), "{v}: {hz} Hz, g {g}: {:?}", all());
}

/// Demands that one of some airspeeds and dampings is the printed one.
fn met_by_frequency(roots: &[[f64; 2]], [v, g]: [f64; 2], [share_v, off_g]: [f64; 2]) {
    let is_met = |root: &[f64; 2]| (root[0] / v - 1.0).abs() < share_v && (root[1] - g).abs() < off_g;
    assert!(roots.iter().any(is_met), "{v}, g {g}: {roots:?}");
}

/// Airspeed and damping that the oscillation needs.
fn plain(root: &KRoot) -> [f64; 2] {
    [root.v_m_s, root.g]
}

/// Airspeed and damping as NASTRAN prints them by K and KE: of p = i V/sqrt(1 + i g), V as its imaginary part and g as twice the real
/// part over it, which is V and g where g is nothing.
fn as_nastran_prints(root: &KRoot) -> [f64; 2] {
    let p = c64::new(0.0, root.v_m_s) / c64::new(1.0, root.g).sqrt();
    [p.im, 2.0 * p.re / p.im]
}

#[test]
fn the_jet_transport_rolls_by_its_aileron_as_printed() {
    let bulk = deck("ha144b_bah_roll");
    let printed = case("trim__ha144b_roll");
    let cases = deck_cases(&bulk).expect("trims");
    let mut bulk = bulk.in_subcase(&cases[0].subcase).expect("a subcase");
    let wing = TrimDeck::new(&bulk, 0.0).unwrap_or_else(|error| panic!("{error}"));
    for case in &cases {
        let trimmed = wing.trim_card(&case.trim).unwrap_or_else(|error| panic!("{error}"));
        let expected = numbers(&printed["roll"][case.trim.q.to_string()]);
        near("roll", trimmed.values["ROLL"], expected, 2e-6);
    }
    let kinds = [
        ("rigid", Elastic::Rigid),
        ("restrained", Elastic::Restrained),
        ("unrestrained", Elastic::Unrestrained),
    ];
    for (name, elastic) in kinds {
        let all = wing.derivatives(8.015, elastic);
        for label in ["ROLL", "AILE"] {
            let expected = numbers(&printed["cl_at_8.015"][label][name]);
            near(&format!("Cl of {label}, {name}"), all[label][3], expected, 1e-5);
        }
    }
    let five: Vec<f64> = numbers(&printed["divergence_q_antisymmetric"]);
    for (ours, expected) in wing.divergence_pressures().iter().zip(five) {
        near("antisymmetric divergence", *ours, expected, 2e-6);
    }
    bulk.aero_reference.as_mut().expect("AEROS").symmetry = 1;
    let wing = TrimDeck::new(&bulk, 0.0).unwrap_or_else(|error| panic!("{error}"));
    let five: Vec<f64> = numbers(&case("trim__ha144b_divergence_sym")["q_div"]);
    for (ours, expected) in wing.divergence_pressures().iter().zip(five) {
        near("symmetric divergence", *ours, expected, 2e-6);
    }
}

/// Generalised forces as MSC.Nastran has them: modes of masses `mhh`, and turned so that the second row has the printed signs.
fn forces_of(wing: &Flown, kappa: f64, mhh: &[f64], printed: &[Vec<[f64; 2]>]) -> Vec<Vec<c64>> {
    let q = wing.deck.forces(0.0).expect("forces").at(kappa, 1.0).expect("a frequency of the table");
    let sign = |j: usize| if q[(1, j)].re * printed[1][j.min(3)][0] < 0.0 { -1.0 } else { 1.0 };
    let modes = mhh.len();
    let value = |i: usize, j: usize| q[(i, j)] * ((mhh[i] * mhh[j]).sqrt() * sign(i) * sign(j));
    (0..modes).map(|i| (0..modes).map(|j| value(i, j)).collect()).collect()
}

#[test]
fn the_jet_transport_held_at_its_root_has_the_modes_and_air_forces_of_msc_nastran() {
    let printed = case("flutter__ha145b");
    let wing = Flown::new("ha145b_bah_flutter");
    let pairs: Vec<[f64; 2]> = numbers(&printed["modes_khh_mhh"]);
    for (ours, [k, m]) in wing.hz().iter().zip(&pairs) {
        near("frequency", *ours, (k / m).sqrt() / TAU, 2e-6);
    }
    let mhh: Vec<f64> = pairs.iter().map(|pair| pair[1]).collect();
    for (name, k) in [("qhhl_k0", 1e-6), ("qhhl_k0.1", 0.1)] {
        let rows: Vec<Vec<[f64; 2]>> = numbers(&printed[name]);
        let ours = forces_of(&wing, wing.deck.modal.kappa(k), &mhh, &rows);
        for j in 0..4 {
            let of = |i: usize| c64::new(rows[i][j][0], rows[i][j][1]);
            let size = (0..10).map(|i| of(i).norm()).fold(0.0, f64::max);
            // Which way a mode's own row points is not known beyond the four whose second row is given: sizes.
            let off = |i: usize| {
                if i < 4 { (ours[i][j] - of(i)).norm() } else { (ours[i][j].norm() - of(i).norm()).abs() }
            };
            let worst = (0..10).map(off).fold(0.0, f64::max) / size;
            println!("{name}, mode {}: at most {worst:.1e} of the largest off", j + 1);
            assert!(worst < 2e-5, "{name}, mode {}: {worst}", j + 1);
        }
    }
}

#[test]
fn the_jet_transport_held_at_its_root_flutters_as_printed() {
    let printed = case("flutter__ha145b");
    let wing = Flown::new("ha145b_bah_flutter");
    let curves = wing.curves(0);
    let [flutter, divergence] =
        ["flutter_ft_s", "divergence_ft_s"].map(|key| 12.0 * numbers::<f64>(&printed[key]));
    let ours = curves.flutter().expect("it flutters");
    println!("flutter at {} in/s, {} Hz", ours.flow.v_m_s, ours.omega_rad_s / TAU);
    near("flutter", ours.flow.v_m_s, flutter, 0.01);
    let ours = curves.divergence().expect("it diverges");
    println!("divergence at {} in/s", ours.flow.v_m_s);
    near("divergence", ours.flow.v_m_s, divergence, 0.005);
    let rows: Vec<[f64; 5]> = numbers(&printed["nastran95_pk"]["rows"]);
    for [_, v, g, hz, _] in rows.into_iter().filter(|row| row[3] > 0.0) {
        // Between the reduced frequencies the two interpolate in ways of their own; most where an oscillation is about to end.
        let off = if g > -1.0 { [3e-4, 1.5e-3] } else { [0.01, 0.05] };
        met(curves, v, [g, hz], off);
    }
    let rows: Vec<[f64; 5]> = numbers(&printed["nastran95_ke"]["rows"]);
    for [_, k, v, g, _] in rows {
        // NASTRAN-95 computes the air in single precision.
        met_by_frequency(&wing.at(1, k, as_nastran_prints), [v, g], [1e-4, 2e-4]);
    }
}

#[test]
fn the_swept_plate_flutters_near_zaero() {
    let printed = case("flutter__ha145e_k");
    let plate = Flown::new("ha145e_plate");
    let hz: Vec<f64> = numbers(&printed["modes_hz"]);
    for (ours, expected) in plate.hz().iter().zip(hz) {
        // The print is of 1998, when MSC's CQUAD4 had another bending (full Poisson effect, twist of its middle); that of today, which
        // structure's `prints_of_nastran.rs` holds to MSC's digits, is softer on 28 elements at two point supports. By how much is our own
        // result, held here; no print of today's element for this plate is known.
        let below = 1.0 - ours / expected;
        println!("mode: {ours} Hz, {below} below {expected}");
        assert!((0.013..0.025).contains(&below), "{below} below MSC's {expected} Hz of 1998");
    }
    let rows: Vec<[f64; 5]> = numbers(&printed["k_method"]["rows"]);
    for [_, k, v, g, _] in rows {
        // The print takes 1 % of modal damping off.
        met_by_frequency(&plate.at(0, k, plain), [v, g + 0.01], [0.03, 0.01 + 0.2 * g.abs()]);
    }
    let [v, hz]: [f64; 2] = numbers(&printed["flutter_0_percent"]);
    let ours = plate.curves(1).flutter().expect("it flutters");
    println!("flutter at {} in/s, {} Hz", ours.flow.v_m_s, ours.omega_rad_s / TAU);
    near("flutter", ours.flow.v_m_s, v, 0.03);
    // ZONA6 itself is 8 % below the 120 Hz that the tunnel had (flutter__ha145e_modes.json).
    near("frequency", ours.omega_rad_s / TAU, hz, 0.04);
    let denser = plate.curves(2).flutter().expect("it flutters");
    println!("in the denser air at {} in/s, {} Hz", denser.flow.v_m_s, denser.omega_rad_s / TAU);
    // Theory of NASA TN D-1824 by NASA's problem D10-02: 5980 in/s; the plate of 28 elements is less stiff in torsion.
    near("flutter", denser.flow.v_m_s, 5980.0, 0.08);
}

/// KE of NASTRAN-95 (PyPI nastran95 0.3, own run) on the cards of plate15_beam.bdf: reduced frequency, airspeed, g.
const NASTRAN_95: [[f64; 3]; 9] = [
    [0.2, 1317.0248, -0.091_444_813],
    [0.15, 1783.7908, -0.130_704_54],
    [0.1, 2804.4685, -0.248_493_73],
    [0.2, 5409.397, -0.038_909_301],
    [0.15, 6033.665, 0.000_681_937_21],
    [0.1, 6394.0972, 0.135_958_05],
    [0.2, 8220.6641, -0.057_006_527],
    [0.15, 11093.488, -0.077_270_62],
    [0.1, 17238.27, -0.124_905_21],
];

#[test]
fn the_swept_beam_flutters_as_nasa_printed() {
    let printed = case("flutter__swept15_d10023a");
    let beam = Flown::new("plate15_beam");
    let hz: Vec<f64> = numbers(&printed["modes_hz"]);
    for (ours, expected) in beam.hz().iter().zip(hz) {
        near("mode", *ours, expected, 5e-3);
    }
    for mode in ["1", "2", "3"] {
        let rows: Vec<[f64; 7]> = numbers(&printed["flutter"][mode]["rows"]);
        for [_, _, v, g, hz, _, _] in rows {
            met(beam.curves(0), v, [g, hz], [5e-3, 3e-3]);
        }
    }
    for [k, v, g] in NASTRAN_95 {
        met_by_frequency(&beam.at(1, k, as_nastran_prints), [v, g], [3e-4, 1e-4]);
    }
    let [[v, hz]]: [[f64; 2]; 1] = numbers(&printed["flutter"]["2"]["zero_crossings_V_f"]);
    let ours = beam.curves(0).flutter().expect("it flutters");
    near("flutter", ours.flow.v_m_s, v, 3e-3);
    near("flutter", ours.omega_rad_s / TAU, hz, 3e-3);
}

/// A motion of a grid at each frequency.
fn motion(deck: &GustDeck, answer: &DynamicAnswer, grid: u32, row: usize) -> Vec<c64> {
    let shapes = deck.shapes_at(grid).expect("a grid");
    let at = |x: &Vec<c64>| x.iter().enumerate().map(|(j, x)| *x * shapes[(row, j)]).sum();
    answer.modal.iter().map(at).collect()
}

#[test]
fn the_jet_transport_answers_its_aileron_as_nastran_95_says() {
    let printed = case("gust__bah_aileron_response");
    let bulk = deck("ha146_bah_aileron");
    let cases = gust_cases(&bulk).unwrap_or_else(|error| panic!("{error}"));
    let all: Vec<_> = cases.iter().collect();
    let wing = GustDeck::new(&bulk, &cases[0].subcase, &all).unwrap_or_else(|error| panic!("{error}"));
    let answer = wing.answer(&cases[0]).unwrap_or_else(|error| panic!("{error}"));
    let side = answer.stations.iter().map(|all| -all[0].total(3)).collect();
    let motions = [("T3_9", 9, 2), ("T3_11", 11, 2), ("R2_12", 12, 4)];
    let curves = motions.map(|(key, grid, row)| (key, motion(&wing, &answer, grid, row), 2e-4));
    // The print's bending is elasticity, which structural damping (g = .06) does not enter; ours is air less mass times acceleration.
    let bending = [("root_bending_11R3_station45", side, 0.08)];
    for (key, ours, share) in curves.into_iter().chain(bending) {
        let rows: Vec<[f64; 3]> = numbers(&printed[key]);
        assert_eq!(rows.len(), ours.len());
        let size = rows.iter().map(|row| row[1].hypot(row[2])).fold(0.0, f64::max);
        let off = rows.iter().zip(&ours).map(|(row, own)| (own - c64::new(row[1], row[2])).norm());
        let off = off.fold(0.0, f64::max) / size;
        println!("{key}: at most {off:.4} of the largest off");
        assert!(off < share, "{key}: {off}");
    }
    let answer = wing.answer(&cases[1]).unwrap_or_else(|error| panic!("{error}"));
    let time = wing.in_time(&cases[1], &answer).expect("in time");
    for (key, grid, row) in motions {
        let values: Vec<f64> = numbers(&printed["time"][key]);
        let ours = time.of_grid(&wing.shapes_at(grid).expect("a grid"));
        assert_eq!(values.len(), ours.len());
        let size = values.iter().map(|value| value.abs()).fold(0.0, f64::max);
        let off = values.iter().zip(&ours).map(|(value, own)| (own[0][row] - value).abs());
        let off = off.fold(0.0, f64::max);
        println!("{key} in time: at most {:.4} of the largest off", off / size);
        assert!(off < 2e-4 * size, "{key} in time: {off} of {size}");
    }
}
