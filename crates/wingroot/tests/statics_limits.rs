//! What cannot be carried, as a user meets it: status 3, the last load that was carried, a sentence, and no waiting.

use std::path::Path;
use std::time::Instant;

use crate::statics_command::{folder, run};

/// Runs `statics`, which must end with status 3 within a minute; what it said.
#[track_caller]
fn stopped(folder: &Path, arguments: &[&str]) -> String {
    let start = Instant::now();
    let output = run(folder, arguments);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(3), "{arguments:?}: {said}");
    assert!(start.elapsed().as_secs() < 60, "{arguments:?} took {} s", start.elapsed().as_secs());
    said
}

/// The first number after some words.
#[track_caller]
fn number_after(said: &str, words: &str) -> f64 {
    let (_, rest) = said.split_once(words).unwrap_or_else(|| panic!("no `{words}` in: {said}"));
    let digits: String = rest.trim_start().chars().take_while(|c| c.is_ascii_digit() || *c == '.').collect();
    digits.trim_end_matches('.').parse().unwrap_or_else(|_| panic!("no number after `{words}` in: {said}"))
}

const RISE: f64 = 0.1;
const STIFFNESS: f64 = 1e6;

/// What two rods over a span of two, risen by [`RISE`] at their joint, carry there: most of 2 E A (1 - l/L) sin over the sinking.
fn limit_of_two_rods() -> f64 {
    let long = f64::hypot(1.0, RISE);
    let carried = |rise: f64| {
        let now = f64::hypot(1.0, rise);
        2.0 * STIFFNESS * (long - now) / long * (rise / now)
    };
    (0..=10_000).map(|at| carried(RISE * f64::from(at) / 10_000.0)).fold(0.0, f64::max)
}

#[test]
fn two_rods_that_would_snap_through_are_carried_to_their_limit_and_no_further() {
    let folder = folder("snap");
    let limit = limit_of_two_rods();
    let load = 1.7 * limit;
    let deck = format!(
        "SOL 106\nCEND\nSPC = 1\nLOAD = 20\nBEGIN BULK\nMAT1,1,1.+6,,0.\nPROD,1,1,1.\nGRID,1,,-1.,0.,0.\nGRID,2,,0.,0.,{RISE}\n\
         GRID,3,,1.,0.,0.\nCROD,1,1,1,2\nCROD,2,1,2,3\nSPC1,1,123456,1,3\nSPC1,1,2456,2\nFORCE,20,2,,{load:.6},0.,0.,-1.\nENDDATA\n"
    );
    std::fs::write(folder.join("rods.bdf"), deck).expect("a deck");
    let said = stopped(&folder, &["--deck", "rods.bdf", "--nonlinear"]);
    let words = if said.contains("unstable between") { "unstable between" } else { "beyond" };
    let reached = number_after(&said, words) * load;
    assert!((0.98..=1.0001).contains(&(reached / limit)), "carried {reached} of {limit}: {said}");
    std::fs::remove_dir_all(folder).expect("it was made above");
}

#[test]
fn a_column_is_carried_to_the_load_of_euler_and_says_where_it_gives_way() {
    use std::fmt::Write as _;
    let folder = folder("column");
    // E I = 1, length 1: pi^2/4; twice that is asked for.
    let euler = std::f64::consts::PI.powi(2) / 4.0;
    let mut deck =
        "SOL 106\nCEND\nSPC = 1\nLOAD = 20\nBEGIN BULK\nMAT1,1,1.+6,,0.\nPBAR,1,1,1.,1.-6,2.-6,2.-6\nSPC1,1,123456,1\n"
            .to_owned();
    for grid in 1..=17 {
        let _ = writeln!(deck, "GRID,{grid},,{:.6},0.,0.", f64::from(grid - 1) / 16.0);
    }
    for bar in 1..=16 {
        let _ = writeln!(deck, "CBAR,{bar},1,{bar},{},0.,0.,1.", bar + 1);
    }
    let _ = write!(deck, "FORCE,20,17,,{:.6},-1.,0.,0.\nENDDATA\n", 2.0 * euler);
    std::fs::write(folder.join("column.bdf"), deck).expect("a deck");
    let said = stopped(&folder, &["--deck", "column.bdf", "--nonlinear"]);
    let reached = 2.0 * number_after(&said, "unstable between");
    assert!((0.985..=1.005).contains(&reached), "carried {reached} of the load of Euler: {said}");
    assert!(said.contains("GRID 17 component 5"), "{said}");
    std::fs::remove_dir_all(folder).expect("it was made above");
}

#[test]
fn an_airspeed_that_no_wing_bears_ends_with_the_last_one_that_it_bore() {
    let folder = folder("bears");
    let wing = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/pazy/wing.ron");
    let text = std::fs::read_to_string(&wing).expect("the wing");
    // A coarse lattice will do.
    let coarse = text.replace("chordwise: 18, spanwise: 36", "chordwise: 2, spanwise: 8");
    let coarse = coarse.replace("chord_strips: 2, span_order: 2", "chord_strips: 1, span_order: 1");
    std::fs::write(folder.join("wing.ron"), coarse).expect("a wing");
    std::fs::copy(wing.with_file_name("beam_distribution.csv"), folder.join("beam_distribution.csv"))
        .expect("its beam");
    let said =
        stopped(&folder, &["--wing", "wing.ron", "--airspeeds", "30,340", "--alpha", "-20", "--nonlinear"]);
    let reached = number_after(&said, "the last one was at");
    assert!((30.0..340.0).contains(&reached), "{said}");
    std::fs::remove_dir_all(folder).expect("it was made above");
}
