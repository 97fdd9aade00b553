//! Runs of the virtual wind tunnel: where they begin, what they hide, and that the shipped ones can be read.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use coupling::ByLoad;
use maneuver::Run;
use maneuver::motion::{MotionSpec, Shape, tidy_degrees};
use nastran::Table;
use std::path::{Path, PathBuf};
use tunnel::{Joiner, Truth, TunnelFile, Use, campaign};

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex").join(name)
}

/// The shipped file with hardly any noise and the runs that `keep` chooses.
fn quiet(keep: impl Fn(&MotionSpec) -> bool) -> TunnelFile {
    let mut file = TunnelFile::read(&data("tunnel.ron")).unwrap();
    file.noise.sample = ByLoad::from_array([1e-9; 3]);
    file.runs.retain(|run| keep(&run.motion));
    file
}

fn tables(file: &TunnelFile) -> Vec<Table> {
    let made = campaign(file, &Truth::build(file).unwrap(), 1).unwrap();
    let run = |name: &str| made.files.iter().find(|(file, _)| file == name).unwrap();
    file.runs.iter().map(|plan| Table::parse(&plan.file, &run(&plan.file).1).unwrap()).collect()
}

#[test]
fn a_run_begins_with_the_static_loads() {
    let mut file = quiet(|motion| matches!(&motion.shape, Shape::OneMinusCosine(m) if m.frequency_hz == 4.0));
    // without the day's offset
    file.runs[0].block = None;
    let truth = Truth::build(&file).unwrap();
    let expected = truth.states(30.0, &[1.3_f64.to_radians()]).unwrap()[0].loads.to_array();
    let run = &tables(&file)[0];
    for (name, expected) in ["Fz_N", "Mx_Nm", "My_Nm"].into_iter().zip(expected) {
        let first = run.number(0, name).unwrap();
        // Printed with four decimals.
        assert!((first - expected).abs() < 1e-4, "{name}: {first} {expected}");
    }
}

#[test]
fn each_aileron_loses_what_its_table_says() {
    let table = |name: &str, degrees: f64| {
        let file = TunnelFile::read(&data("tunnel.ron")).unwrap();
        let tables = file.dynamics.unwrap().deflection;
        let rows = &tables.iter().find(|table| table.control == name).unwrap().rows;
        let row = rows.iter().find(|row| row.v_m_s == 30.0).unwrap();
        row.factors()[row.commanded_deg.iter().position(|d| *d == degrees).unwrap()]
    };
    let mut file = quiet(|motion| matches!(motion.shape, Shape::Doublet(_)));
    file.runs.retain(|run| run.v_m_s == 30.0 && run.repeat_of.is_none());
    let found: Vec<(String, f64, f64)> = file
        .runs
        .iter()
        .zip(tables(&file))
        .map(|(plan, run)| {
            let fz = run.numbers("Fz_N").unwrap();
            let degrees = tidy_degrees(plan.motion.kind().height());
            let peak = fz.iter().map(|f| f - fz[0]).fold(0.0, f64::max);
            (plan.motion.control().unwrap().to_owned(), degrees, peak / degrees)
        })
        .collect();
    assert_eq!(found.len(), 12);
    // All else is linear, so per degree the ratios are those of the factors.
    for (control, degrees, per_degree) in &found {
        let smallest = found.iter().find(|(other, d, _)| other == control && *d == 5.0).unwrap();
        let expected = table(control, *degrees) / table(control, 5.0);
        assert!(
            (per_degree / smallest.2 - expected).abs() < 1e-3,
            "{control} {degrees}: {per_degree} {expected}"
        );
    }
    // Inner and middle saturate; the outer one rises at 5 degrees first (S43).
    for name in ["inner", "middle"] {
        assert!(table(name, 5.0) < table(name, 1.0) && table(name, 25.0) < 0.8 * table(name, 1.0), "{name}");
    }
    assert!(
        table("outer", 5.0) > 1.1 * table("outer", 1.0) && table("outer", 25.0) < 0.8 * table("outer", 1.0)
    );
}

#[test]
fn runs_of_a_day_share_its_offset_and_those_without_wind_have_none() {
    let mut file = quiet(|motion| matches!(&motion.shape, Shape::OneMinusCosine(m) if m.frequency_hz == 4.0));
    assert_eq!(file.runs.iter().map(|run| run.v_m_s).collect::<Vec<_>>(), [30.0, 30.0, 0.0]);
    file.runs[2].motion = file.runs[0].motion.clone();
    let first = |tables: &[Table], run: usize| {
        ["Fz_N", "Mx_Nm", "My_Nm"].map(|name| tables[run].number(0, name).unwrap())
    };
    let with = tables(&file);
    file.runs.iter_mut().for_each(|run| run.block = None);
    let without = tables(&file);
    let offsets = [0, 1, 2].map(|run| {
        let (with, without) = (first(&with, run), first(&without, run));
        [0, 1, 2].map(|c| with[c] - without[c])
    });
    assert_eq!(offsets[2], [0.0; 3]);
    assert_ne!(offsets[0], offsets[1], "two days");
    // the static cases' offset of the same day
    let made = campaign(&file, &Truth::build(&file).unwrap(), 1).unwrap();
    let truth = Truth::build(&file).unwrap();
    for (run, day) in ["day_1", "day_2"].into_iter().enumerate() {
        let row = made.rows.iter().find(|row| row.v_m_s == 30.0 && row.block == day).unwrap();
        let clean = truth.states(30.0, &[row.alpha_deg.to_radians()]).unwrap()[0].loads.to_array();
        for c in 0..3 {
            let noise = row.loads.to_array()[c] - clean[c] - offsets[run][c];
            // five standard deviations of a static point
            assert!(noise.abs() < 5.0 * file.noise.static_point.to_array()[c], "{day} channel {c}: {noise}");
        }
    }
}

#[test]
fn without_wind_a_run_is_weight_and_inertia() {
    let file = quiet(|motion| matches!(motion.shape, Shape::OneMinusCosine(_)));
    let wind_off: Vec<_> = file.runs.iter().filter(|run| run.v_m_s == 0.0).collect();
    assert_eq!(wind_off.len(), 3);
    let truth = Truth::build(&file).unwrap();
    let expected = truth.states(0.0, &[1.3_f64.to_radians()]).unwrap()[0].loads.to_array();
    for (plan, run) in file.runs.iter().zip(tables(&file)).filter(|(plan, _)| plan.v_m_s == 0.0) {
        for (name, expected) in ["Fz_N", "Mx_Nm", "My_Nm"].into_iter().zip(expected) {
            let values = run.numbers(name).unwrap();
            assert!((values[0] - expected).abs() < 1e-4, "{}: {} {expected}", plan.file, values[0]);
            assert!(values.iter().all(|value| value.abs() < 100.0), "{}", plan.file);
        }
    }
    let entries = campaign(&file, &truth, 1).unwrap().files.pop().unwrap().1;
    assert_eq!(entries.matches("wind_off: true").count(), 3);
    assert!(entries.contains(
        "(file: \"aoa_4hz_30.csv\", use: Holdout, block: \"day_2\", repeat_of: \"aoa_4hz_30_day_1.csv\"),"
    ));
}

#[test]
fn every_run_of_the_paper_is_flown() {
    let file = TunnelFile::read(&data("tunnel.ron")).unwrap();
    let flown = |wanted: &dyn Fn(&MotionSpec) -> bool, v_m_s: f64, purpose: Use| {
        file.runs.iter().any(|run| run.v_m_s == v_m_s && run.purpose == purpose && wanted(&run.motion))
    };
    let of = |m: &MotionSpec, name: &str, degrees: f64| {
        m.control() == Some(name) && tidy_degrees(m.kind().height()) == degrees
    };
    for hz in [0.5, 2.0, 4.0] {
        let pitch = |m: &MotionSpec| matches!(&m.shape, Shape::OneMinusCosine(m) if m.frequency_hz == hz && m.to == Some(5.0_f64.to_radians()));
        assert!(flown(&pitch, 30.0, Use::Train) && flown(&pitch, 30.0, Use::Holdout), "{hz} Hz");
    }
    for name in ["inner", "middle", "outer"] {
        for v_m_s in [18.0, 22.0, 30.0, 34.0] {
            for degrees in [5.0, 15.0, 25.0] {
                let doublet = |m: &MotionSpec| matches!(m.shape, Shape::Doublet(_)) && of(m, name, degrees);
                assert!(flown(&doublet, v_m_s, Use::Train), "{name} {degrees} {v_m_s}");
            }
            for degrees in [2.0, 5.0] {
                let chirp = |m: &MotionSpec| {
                    matches!(&m.shape, Shape::Chirp(c) if [c.from_hz, c.to_hz, c.duration_s] == [0.0, 10.0, 30.0])
                        && of(m, name, degrees)
                };
                let either = flown(&chirp, v_m_s, Use::Train) || flown(&chirp, v_m_s, Use::Holdout);
                assert!(either, "{name} {degrees} {v_m_s}");
            }
        }
    }
    for degrees in [5.0, 15.0, 25.0] {
        let shown = |m: &MotionSpec| matches!(m.shape, Shape::Doublet(_)) && of(m, "inner", degrees);
        assert!(flown(&shown, 30.0, Use::Holdout), "Figs. 12 to 14: {degrees}");
    }
}

#[test]
fn a_joiner_resists_pitch_acceleration() {
    let joiner = Joiner { mass_kg: 2.0, aft_m: 0.1, inertia_kg_m2: 0.05 };
    // A point mass aft of the axis accelerates down: it pulls the balance up, which is nose down.
    let loads = joiner.loads(10.0);
    assert!((loads.fz_n - 2.0).abs() < 1e-15 && loads.mx_nm == 0.0 && (loads.my_nm + 0.5).abs() < 1e-15);
}

#[test]
fn the_shipped_runs_can_be_read_and_are_small() {
    let entries = nastran::read_text(&data("measured/campaign.ron")).unwrap();
    let files: Vec<&str> =
        entries.split('"').filter(|word| word.contains(".csv") && *word != "static.csv").collect();
    assert!(files.len() >= 15, "{files:?}");
    let mut bytes = 0;
    for file in files {
        let path = data("measured").join(file);
        let run = Run::read(&path).unwrap();
        assert!((run.time_step_s - 0.005).abs() < 1e-9 && run.loads.is_some());
        // the name ends with the airspeed, or begins with wind_off
        let named = path.file_stem().unwrap().to_str().unwrap().trim_end_matches("_day_1");
        let v_m_s = if named.starts_with("wind_off") {
            0.0
        } else {
            named.rsplit('_').next().unwrap().parse().unwrap()
        };
        assert_eq!(run.v_m_s, v_m_s, "{file}");
        bytes += std::fs::metadata(&path).unwrap().len();
    }
    assert!(bytes < 30_000_000, "{bytes} bytes");
}

#[test]
fn a_tunnel_file_whose_runs_cannot_be_is_refused() {
    let text = nastran::read_text(&data("tunnel.ron")).unwrap();
    for (test, from, to, said) in [
        ("day", "block: \"day_2\"", "block: \"day_3\"", "no block of the static cases is called day_3"),
        (
            "repeat",
            "repeat_of: \"aoa_2hz_30_day_1.csv\"",
            "repeat_of: \"aoa.csv\"",
            "no run is called aoa.csv",
        ),
        (
            "table",
            "(V_m_s: 22.0, commanded_deg: [1.0, 2.5,",
            "(V_m_s: 22.0, commanded_deg: [2.5, 2.5,",
            "must ascend",
        ),
        ("rate", "sample_rate_hz: 200.0", "sample_rate_hz: 0.0", "positive sample_rate_hz"),
    ] {
        assert!(text.contains(from), "{test}");
        let path = std::env::temp_dir().join(format!("wingroot-tunnel-{}-{test}.ron", std::process::id()));
        std::fs::write(&path, text.replacen(from, to, 1)).unwrap();
        let error = TunnelFile::read(&path).unwrap_err();
        std::fs::remove_file(&path).unwrap();
        assert!(error.message.contains(said) && error.help.is_some(), "{test}: {error}");
    }
}
