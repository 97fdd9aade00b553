//! The generator of the micro air vehicle's runs: it is repeatable, its errors are the declared ones, the shipped runs are
//! its own, and no analysis can call it.

use std::path::{Path, PathBuf};

use response::mav::{
    Balance, Errors, Published, Runs, Series, Spread, draw, dynamic_pressure_pa, shipped_files, truth,
};

fn data() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/mav")
}

fn published() -> Published {
    Published::read(&data().join("published")).expect("the shipped coefficients")
}

fn drawn(series: Series, errors: &Errors, seed: u64) -> Runs {
    draw(&published(), series, errors, seed).expect("the series' equations")
}

#[test]
fn the_shipped_runs_are_what_the_generator_gives() {
    for (name, text) in shipped_files(&published()).expect("the series' equations") {
        let shipped = std::fs::read_to_string(data().join(&name)).expect("the file ships");
        assert!(
            shipped == text,
            "{name} is not what `cargo run -p wingroot-response --example draw_mav_runs` gives"
        );
    }
}

#[test]
fn a_seed_fixes_the_runs_and_another_changes_them() {
    let of = |seed| drawn(Series::PropellerOff, &Errors::default(), seed);
    assert_eq!(of(1), of(1));
    assert_ne!(of(1), of(2));
}

#[test]
fn without_errors_the_runs_are_the_models() {
    let published = published();
    let runs = truth(&published, Series::PropellerOff).expect("the series' equations");
    let model = published.equation(5, "PR").expect("Eq. 5");
    for row in &runs.rows {
        let value =
            model.value(&row.point.condition, response::mav::Rules::STRICT).expect("within its range");
        assert_eq!(row.values[0], value);
    }
}

#[test]
fn scatter_and_offsets_of_blocks_have_the_declared_size() {
    let balanceless = Errors { balance: None, ..Errors::default() };
    let (mut squares, mut count) = (0.0, 0.0);
    let (mut block_squares, mut blocks) = (0.0, 0.0);
    for seed in 0..200 {
        let runs = drawn(Series::PropellerOff, &balanceless, seed);
        let clean = truth(&published(), Series::PropellerOff).expect("the series' equations");
        let mut sums = [0.0; 3];
        let errors: Vec<f64> =
            runs.rows.iter().zip(&clean.rows).map(|(run, clean)| run.values[0] - clean.values[0]).collect();
        for (row, error) in runs.rows.iter().zip(&errors) {
            sums[row.block] += error / 128.0;
        }
        for (row, error) in runs.rows.iter().zip(&errors) {
            squares += (error - sums[row.block]).powi(2);
        }
        count += 3.0 * 127.0;
        let mean = sums.iter().sum::<f64>() / 3.0;
        block_squares += sums.iter().map(|sum| (sum - mean).powi(2)).sum::<f64>();
        blocks += 2.0;
    }
    let Spread { point, block } = Errors::default().lift;
    // three standard errors of a standard deviation from 76200 and from 400 degrees of freedom
    assert!(((squares / count).sqrt() / point - 1.0).abs() < 0.008, "{}", (squares / count).sqrt());
    assert!(
        ((block_squares / blocks).sqrt() / block - 1.0).abs() < 0.106,
        "{}",
        (block_squares / blocks).sqrt()
    );
}

#[test]
fn offsets_of_the_blocks_add_up_to_zero() {
    let mut errors = Errors::NONE;
    errors.lift.block = 0.1;
    let runs = drawn(Series::PropellerOff, &errors, 5);
    let clean = drawn(Series::PropellerOff, &Errors::NONE, 5);
    let offset = |block: usize| runs.rows[128 * block].values[0] - clean.rows[128 * block].values[0];
    assert!((offset(0) + offset(1) + offset(2)).abs() < 1e-14 && offset(0).abs() > 1e-3);
}

#[test]
fn one_reading_is_a_whole_number_of_steps_and_the_mean_of_many_is_finer() {
    let balance = Balance { readings: 1, reading_steps: 0.0, ..Balance::default() };
    let steps = |runs: &Runs| -> Vec<f64> {
        let lift = runs.response("CL").expect("CL");
        let force_n = |q: f64| q * 0.0178;
        let q = runs.rows.iter().map(|row| row.point.condition.q_pa);
        lift.iter().zip(q).map(|(lift, q)| lift * force_n(q) / 0.03).collect()
    };
    let coarse = steps(&drawn(Series::PropellerOff, &Errors { balance: Some(balance), ..Errors::NONE }, 3));
    let clean = steps(&drawn(Series::PropellerOff, &Errors::NONE, 3));
    for (coarse, clean) in coarse.iter().zip(&clean) {
        assert!((coarse - coarse.round()).abs() < 1e-9 && (coarse - clean).abs() <= 0.5 + 1e-9);
    }
    // readings scatter over steps, so that their mean sees between them: sqrt(1 + 1/12)/20 = 0.052 steps
    let balance = Some(Balance::default());
    let fine = steps(&drawn(Series::PropellerOff, &Errors { balance, ..Errors::NONE }, 3));
    let squares: f64 = fine.iter().zip(&clean).map(|(fine, clean)| (fine - clean).powi(2)).sum();
    let rms = (squares / fine.len() as f64).sqrt();
    assert!((rms / 0.052 - 1.0).abs() < 0.12, "{rms}");
}

#[test]
fn every_run_has_the_points_of_the_series_once() {
    for series in Series::ALL {
        let runs = drawn(series, &Errors::NONE, 0);
        let points = series.points();
        assert_eq!(runs.rows.len(), series.blocks() * points.len());
        for (k, row) in runs.rows.iter().enumerate() {
            assert_eq!((row.block, row.point.v_m_s), (k / points.len(), points[k % points.len()].v_m_s));
            assert_eq!(row.point.condition.q_pa, dynamic_pressure_pa(row.point.v_m_s));
        }
    }
}

/// All source files below a folder.
fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("a folder of sources") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            sources(&path, found);
        } else {
            found.push(path);
        }
    }
}

#[test]
fn no_analysis_names_the_generator() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    sources(&root, &mut files);
    let analysis = |path: &&PathBuf| !path.starts_with(root.join("mav")) && !path.ends_with("src/lib.rs");
    assert!(files.iter().filter(analysis).count() > 1);
    for path in files.iter().filter(analysis) {
        let text = std::fs::read_to_string(path).expect("a source");
        assert!(!text.contains("mav::"), "{} names the vehicle's module", path.display());
    }
}
