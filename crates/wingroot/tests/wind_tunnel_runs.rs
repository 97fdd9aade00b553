//! S35 to S40 and S45 to S47 of the claims about the flexible wing, on runs of the virtual wind tunnel that were held out:
//! pitch at 30 m/s and the inner aileron's chirp, flown with the corrections of loads and deflections found from the
//! rest.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use maneuver::Run;
use maneuver::motion::Shape;
use serde_json::Value;
use tunnel::{Truth, TunnelFile, campaign};

const START_S: f64 = 0.5;
const LOADS: [&str; 3] = ["Fz_N", "Mx_Nm", "My_Nm"];

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex").join(name)
}

/// The folder with the campaign, what `deflection` found and what `simulate` flew; and the latter's result.
fn outcome() -> &'static (PathBuf, Value) {
    static OUTCOME: OnceLock<(PathBuf, Value)> = OnceLock::new();
    OUTCOME.get_or_init(|| {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("wind_tunnel_runs");
        let mut file = TunnelFile::read(&data("tunnel.ron")).expect("the shipped file");
        file.runs.retain(|run| run.v_m_s == 30.0 && run.motion.control().is_none_or(|name| name == "inner"));
        let truth = Truth::build(&file).expect("the true wing");
        std::fs::create_dir_all(folder.join("campaign")).expect("a temporary folder");
        for (name, text) in &campaign(&file, &truth, file.seed).expect("a campaign").files {
            std::fs::write(folder.join("campaign").join(name), text).expect("a temporary file");
        }
        let wing = data("wing_beam.ron");
        run(&folder, &["deflection", "--wing", &wing.to_string_lossy(), "--out", "deflection"]);
        let corrections = ["--corrections", "deflection/corrections.ron"];
        let simulate = ["simulate", "--wing", "deflection/wing.ron", "--out", "flown"];
        let result = run(&folder, &[&simulate[..], &corrections[..]].concat());
        (folder, result)
    })
}

fn run(folder: &Path, arguments: &[&str]) -> Value {
    let output = Command::new(env!("CARGO_BIN_EXE_wingroot"))
        .args(arguments)
        .args(["--json", "--numbers-only", "--quiet", "--campaign", "campaign"])
        .current_dir(folder)
        .output()
        .expect("the command starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("JSON")
}

/// A run as measured and as simulated with all corrections, and the simulation's residual in per cent of the load's
/// variation: initial, updated.
struct Flown {
    measured: Run,
    simulated: Run,
    percent: [[f64; 3]; 2],
}

fn flown(name: &str) -> Flown {
    let (folder, result) = outcome();
    let read = |folder: PathBuf| Run::read(&folder.join(format!("{name}.csv"))).expect("a run");
    let runs = result["runs"].as_array().expect("a list");
    let found = runs.iter().find(|run| {
        run["file"].as_str().and_then(|file| Path::new(file).file_stem()).is_some_and(|stem| stem == name)
    });
    let percent = &found.expect("it was flown")["raw_percent"];
    let of = |model: &str| LOADS.map(|load| percent[model][load].as_f64().expect("a number"));
    Flown {
        measured: read(folder.join("campaign")),
        simulated: read(folder.join("flown")),
        percent: [of("initial"), of("updated")],
    }
}

fn loads(run: &Run) -> &[Vec<f64>; 3] {
    run.loads.as_ref().expect("it has loads")
}

/// Mean over the time before anything moves.
fn beginning(run: &Run, c: usize) -> f64 {
    let count = run.t_s.iter().filter(|t| **t < START_S - 0.05).count();
    loads(run)[c][..count].iter().sum::<f64>() / count as f64
}

/// Largest departure from the beginning, with the sign of the load's change, between two times.
fn departure(run: &Run, c: usize, from_s: f64, to_s: f64, sign: f64) -> f64 {
    let base = beginning(run, c);
    let inside = run.t_s.iter().zip(&loads(run)[c]).filter(|(t, _)| (from_s..to_s).contains(*t));
    inside.map(|(_, load)| sign * (load - base)).fold(0.0, f64::max)
}

/// Sign of a load's change as the angle of attack grows.
const SIGNS: [f64; 3] = [1.0, 1.0, -1.0];

fn amplitude(run: &Run, c: usize, frequency_hz: f64) -> f64 {
    departure(run, c, START_S, START_S + 1.0 / frequency_hz, SIGNS[c])
}

const PITCH: [(&str, f64); 3] = [("aoa_0p5hz_30", 0.5), ("aoa_2hz_30", 2.0), ("aoa_4hz_30", 4.0)];

#[test]
fn s35_pitch_from_1_3_to_5_degrees_at_the_published_reduced_frequencies() {
    let file = TunnelFile::read(&data("tunnel.ron")).expect("the shipped file");
    let wing = coupling::WingFile::read(&data("wing_beam.ron")).expect("the shipped wing");
    let chord_m = wing.planform().expect("parametric").mean_chord_m();
    for ((name, frequency_hz), published) in PITCH.into_iter().zip([0.0118, 0.0471, 0.0943]) {
        let plan = file.runs.iter().find(|run| run.file == format!("{name}.csv")).expect("it is flown");
        let Shape::OneMinusCosine(pitch) = &plan.motion.shape else { panic!("a pitch") };
        assert_eq!((pitch.to, pitch.frequency_hz), (Some(5.0_f64.to_radians()), frequency_hz));
        let k = std::f64::consts::PI * frequency_hz * chord_m / plan.v_m_s;
        // printed with four decimals
        assert!((k - published).abs() < 6e-5, "{name}: {k}");
        let run = flown(name).measured;
        let most = run.alpha_rad.iter().fold(0.0, |most: f64, alpha| most.max(alpha.to_degrees()));
        // the sensor's noise is 0.005 degrees
        assert!(
            (run.alpha_rad[0].to_degrees() - 1.3).abs() < 0.03 && (most - 5.0).abs() < 0.03,
            "{name}: {most}"
        );
    }
}

#[test]
fn s36_the_updated_model_matches_all_three_loads_at_the_beginning() {
    for (name, _) in PITCH {
        let run = flown(name);
        for (c, load) in LOADS.into_iter().enumerate() {
            let (measured, simulated) = (beginning(&run.measured, c), beginning(&run.simulated, c));
            assert!((simulated / measured - 1.0).abs() < 0.005, "{name} {load}: {measured} {simulated}");
        }
    }
}

#[test]
fn s37_at_half_a_hertz_the_updated_amplitude_is_better_than_the_initial_one() {
    let run = flown("aoa_0p5hz_30");
    for (c, load) in LOADS.into_iter().enumerate() {
        let [initial, updated] = [0, 1].map(|model| run.percent[model][c]);
        assert!(updated < 0.1 * initial, "{load}: {initial} % to {updated} %");
    }
    // the paper: the torsion moment improves most
    assert!(run.percent[0][2] > run.percent[0][0] && run.percent[0][2] > run.percent[0][1]);
}

#[test]
fn s38_at_two_hertz_all_amplitudes_match() {
    let run = flown("aoa_2hz_30");
    for (c, bound) in [0.03, 0.03, 0.1].into_iter().enumerate() {
        let ratio = amplitude(&run.simulated, c, 2.0) / amplitude(&run.measured, c, 2.0);
        assert!((ratio - 1.0).abs() < bound, "{}: {ratio}", LOADS[c]);
    }
}

#[test]
fn s39_at_four_hertz_the_torsion_moment_does_not_follow_and_the_others_do() {
    let run = flown("aoa_4hz_30");
    for (c, load) in LOADS.into_iter().enumerate().take(2) {
        let ratio = amplitude(&run.simulated, c, 4.0) / amplitude(&run.measured, c, 4.0);
        assert!((ratio - 1.0).abs() < 0.05, "{load}: {ratio}");
        assert!(run.percent[1][c] < 8.0, "{load}: {} %", run.percent[1][c]);
    }
    // the joiner's inertia is in no model: the residual of My is a fifth of its variation and more, and it has the shape
    // of the angle's second derivative, two bumps down and one up
    assert!(run.percent[1][2] > 20.0, "{} %", run.percent[1][2]);
    let omega = std::f64::consts::TAU * 4.0;
    let inside = |t_s: f64| (START_S..START_S + 0.25).contains(&t_s);
    let pairs: Vec<(f64, f64)> = (0..run.measured.len())
        .filter(|&i| inside(run.measured.t_s[i]))
        .map(|i| {
            let residual = loads(&run.measured)[2][i] - loads(&run.simulated)[2][i];
            (residual, -(omega * (run.measured.t_s[i] - START_S)).cos())
        })
        .collect();
    let correlation = {
        let sum = |of: &dyn Fn(&(f64, f64)) -> f64| pairs.iter().map(of).sum::<f64>();
        sum(&|(a, b)| a * b) / (sum(&|(a, _)| a * a) * sum(&|(_, b)| b * b)).sqrt()
    };
    assert!(correlation > 0.9, "{correlation}");
}

#[test]
fn s40_an_overshoot_follows_the_fast_motions_and_not_the_slow_one() {
    // declared maneuvers: a measured angle's noise moves the simulated loads by as much as the overshoot at 2 Hz
    let folder = &outcome().0;
    let declared = std::fs::read_to_string(data("maneuvers/pitch_4hz.ron")).expect("a shipped maneuver");
    let overshoot = |frequency_hz: f64| {
        let name = format!("pitch_{frequency_hz}");
        let text = declared.replace("frequency_hz: 4.0", &format!("frequency_hz: {frequency_hz:?}"));
        std::fs::write(folder.join(format!("{name}.ron")), text).expect("a temporary file");
        let wing = ["--wing", "deflection/wing.ron", "--corrections", "deflection/corrections.ron"];
        let maneuver = format!("{name}.ron");
        run(folder, &[&["simulate", "--maneuver", &maneuver, "--out", &name][..], &wing[..]].concat());
        let flown = Run::read(&folder.join(&name).join(format!("{name}.csv"))).expect("a run");
        let end_s = START_S + 1.0 / frequency_hz;
        departure(&flown, 1, end_s, end_s + 0.3, -1.0) / amplitude(&flown, 1, frequency_hz)
    };
    let [slow, medium, fast] = [0.5, 2.0, 4.0].map(overshoot);
    // shares of the bending moment's amplitude; the paper gives no numbers
    assert!(slow < 1e-3, "0.5 Hz: {slow}");
    assert!(medium > 5.0 * slow && medium > 2e-3, "2 Hz: {medium}");
    assert!(fast > 5.0 * medium && fast > 2e-2, "4 Hz: {fast}");
}

/// Half the distance of the largest and the smallest load between two times.
fn swing(run: &Run, c: usize, from_s: f64, to_s: f64) -> f64 {
    let inside = run.t_s.iter().zip(&loads(run)[c]).filter(|(t, _)| (from_s..to_s).contains(*t));
    let (low, high) = inside
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (_, load)| (low.min(*load), high.max(*load)));
    0.5 * (high - low)
}

#[test]
fn s45_a_chirp_sweeps_from_0_to_10_hz_in_30_seconds() {
    let run = flown("chirp_inner_5_30").measured;
    let delta = &run.controls_rad[0].1;
    // whole turns of the phase up to a time: t²/6 for f = t/3
    let rising = |to_s: f64| {
        let end = run.t_s.iter().filter(|t| **t < START_S + to_s).count();
        delta[..end].windows(2).filter(|pair| pair[0] < 0.0 && pair[1] >= 0.0).count() as f64
    };
    for to_s in [10.0, 20.0, 29.0] {
        assert!((rising(to_s) - to_s * to_s / 6.0).abs() <= 1.0, "{to_s} s: {}", rising(to_s));
    }
    let most = delta.iter().fold(0.0, |most: f64, d| most.max(d.to_degrees()));
    assert!((most - 5.0).abs() < 0.01);
}

#[test]
fn s46_the_bending_moment_swings_most_as_the_chirp_passes_the_first_bending() {
    let run = flown("chirp_inner_5_30");
    for (which, run) in [("measured", &run.measured), ("simulated", &run.simulated)] {
        // windows of two seconds, from where the chirp has turned at least once
        let windows: Vec<(f64, f64)> =
            (4..29).map(|s| (f64::from(s), swing(run, 1, f64::from(s) - 1.0, f64::from(s) + 1.0))).collect();
        let (at_s, most) = windows.iter().copied().fold((0.0, 0.0), |a, b| if b.1 > a.1 { b } else { a });
        // 4 to 6 Hz: 12 to 18 s of the chirp; air adds damping and takes some frequency
        assert!((START_S + 11.0..START_S + 18.0).contains(&at_s), "{which}: {at_s} s");
        assert!(most > 1.05 * windows[0].1 && most > 1.5 * windows[windows.len() - 1].1, "{which}");
    }
}

#[test]
fn s47_with_the_factor_of_5_degrees_trim_and_amplitude_of_the_chirp_match() {
    let run = flown("chirp_inner_5_30");
    for (c, load) in LOADS.into_iter().enumerate() {
        let ratio = beginning(&run.simulated, c) / beginning(&run.measured, c);
        assert!((ratio - 1.0).abs() < 0.005, "{load}: {ratio}");
        let ratio = swing(&run.simulated, c, 12.0, 16.0) / swing(&run.measured, c, 12.0, 16.0);
        // the measurement's noise widens its swing: three standard deviations of 0.2 N in 12 N
        assert!((ratio - 1.0).abs() < 0.06, "{load}: {ratio}");
    }
}
