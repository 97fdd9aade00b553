//! The rule between airspeeds and the file the sets are kept in.

use aero::Corrections;
use calibrate::{CorrectionSet, Schedule};

fn set(v_m_s: f64, force: f64) -> CorrectionSet {
    let corrections =
        Corrections { force: vec![force, 1.0], moment: vec![1.0, 0.9], pressure_offset: vec![0.1, -0.2] };
    CorrectionSet { v_m_s, corrections }
}

fn schedule() -> Schedule {
    let sets = vec![set(20.0, 1.4), set(40.0, 1.0)];
    Schedule { wing: "a wing".into(), wing_hash: "0123".into(), sets, unconverged: Vec::new() }
}

#[test]
fn between_airspeeds_corrections_run_linearly_in_dynamic_pressure() {
    // q(30)/q(20) = 2.25, q(40)/q(20) = 4: five twelfths of the way
    let between = schedule().at(30.0).expect("inside");
    assert!((between.force[0] - (1.4 - 0.4 * 5.0 / 12.0)).abs() < 1e-12);
    assert_eq!(schedule().at(20.0).expect("a set").force[0], 1.4);
    assert_eq!(schedule().at(40.0).expect("a set").force[0], 1.0);
}

#[test]
fn outside_the_range_a_set_is_refused_beyond_two_percent_unless_the_nearest_is_asked_for() {
    let schedule = schedule();
    for v_m_s in [40.8, 19.6] {
        assert_eq!(schedule.at(v_m_s).expect("a tunnel strays"), schedule.nearest(v_m_s).corrections);
    }
    for v_m_s in [40.9, 19.5, 42.0] {
        let refused = schedule.at(v_m_s).expect_err("outside").to_string();
        assert!(
            refused.contains(&format!("{v_m_s} m/s")) && refused.contains("from 20 to 40 m/s"),
            "{refused}"
        );
        let (taken, said) = schedule.at_or_nearest(v_m_s);
        assert_eq!(taken, schedule.nearest(v_m_s).corrections);
        assert!(said.expect("a sentence").contains("are taken"));
    }
    assert_eq!(schedule.at_or_nearest(30.0), (schedule.at(30.0).expect("inside"), None));
    // S52: the paper takes the set of 40 m/s for 37 and 42 m/s
    for v_m_s in [37.0, 42.0] {
        assert_eq!(schedule.nearest(v_m_s).v_m_s, 40.0);
    }
}

#[test]
fn a_schedule_is_written_and_read_without_loss() {
    let folder = std::env::temp_dir().join(format!("wingroot-schedule-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a temporary folder");
    let path = folder.join("corrections.ron");
    let mut original = schedule();
    original.sets[0].corrections.force[0] = 1.0 / 3.0;
    original.sets[1].corrections.pressure_offset[1] = -1.234_567_890_123_456_7e-9;
    std::fs::write(&path, original.to_ron()).expect("a temporary file");
    let read = Schedule::read(&path);
    let broken = original.to_ron().replace("moment: [1.0, 0.9]", "moment: [1.0]");
    std::fs::write(&path, broken).expect("a temporary file");
    let refused = Schedule::read(&path).expect_err("lengths differ").to_string();
    std::fs::remove_dir_all(&folder).expect("a temporary folder");
    assert_eq!(read.expect("as written"), original);
    assert!(refused.contains("differ in length"), "{refused}");
}

#[test]
fn corrections_of_a_fit_that_stalled_are_refused_unless_told() {
    let folder = std::env::temp_dir().join(format!("wingroot-unconverged-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder of our own");
    let path = folder.join("corrections.ron");
    let stalled = Schedule { unconverged: vec!["40 m/s: Stalled".to_owned()], ..schedule() };
    std::fs::write(&path, stalled.to_ron()).expect("a file");
    let refused = Schedule::read(&path).expect_err("they are marked").to_string();
    assert!(refused.contains("did not converge: 40 m/s: Stalled"), "{refused}");
    assert_eq!(Schedule::read_unconverged(&path), Ok(stalled));
    std::fs::remove_dir_all(&folder).expect("a folder of our own");
}
