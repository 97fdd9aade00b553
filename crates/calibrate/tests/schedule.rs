//! The rule between airspeeds and the file the sets are kept in.

use aero::Corrections;
use calibrate::{CorrectionSet, Member, Schedule};

fn set(v_m_s: f64, force: f64) -> CorrectionSet {
    let corrections =
        Corrections { force: vec![force, 1.0], moment: vec![1.0, 0.9], pressure_offset: vec![0.1, -0.2] };
    CorrectionSet { v_m_s, corrections }
}

fn schedule() -> Schedule {
    let sets = vec![set(20.0, 1.4), set(40.0, 1.0)];
    Schedule { wing: "a wing".into(), wing_hash: "0123".into(), sets, found: None, unconverged: Vec::new() }
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

#[test]
fn a_file_that_says_what_no_corrections_are_is_refused() {
    let folder = std::env::temp_dir().join(format!("wingroot-no-schedule-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder of our own");
    let path = folder.join("corrections.ron");
    let read = |sets: Vec<CorrectionSet>| {
        std::fs::write(&path, Schedule { sets, ..schedule() }.to_ron()).expect("a file");
        Schedule::read(&path).map_err(|error| error.to_string())
    };
    for v_m_s in [0.1, 340.0] {
        assert!(read(vec![set(v_m_s, 1000.0)]).is_ok(), "{v_m_s}");
    }
    let of = |family: usize, value: f64| {
        let mut set = set(20.0, 1.0);
        let Corrections { force, moment, pressure_offset } = &mut set.corrections;
        [force, moment, pressure_offset][family][1] = value;
        vec![set]
    };
    let mut cases = vec![
        (vec![], "no set"),
        (vec![set(0.09, 1.0)], "0.09 m/s"),
        (vec![set(340.5, 1.0)], "340.5 m/s"),
        (vec![set(20.0, 1.0), set(20.0, 1.0)], "must ascend"),
        (vec![set(20.0, 1.0), set(30.0, 1.0), set(25.0, 1.0)], "must ascend"),
    ];
    for family in 0..3 {
        assert!(read(of(family, -1000.0)).is_ok());
        cases.extend([1000.5, -1000.5].map(|value| (of(family, value), "beyond 1000")));
        let mut long = set(20.0, 1.0);
        let Corrections { force, moment, pressure_offset } = &mut long.corrections;
        [force, moment, pressure_offset][family].push(1.0);
        cases.push((vec![long], "differ in length"));
    }
    for (sets, words) in cases {
        let refused = read(sets).expect_err(words);
        assert!(refused.contains(words), "{words}: {refused}");
    }
    std::fs::remove_dir_all(&folder).expect("a folder of our own");
}

/// A wing that was found beside the sets of [`schedule`].
fn found() -> Member {
    let sets = vec![set(20.0, 1.3), set(40.0, 0.9)];
    Member { log_flexibility: [0.125, -0.03], controls: vec![0.75, 1.5], stream: 1.0, sets }
}

#[test]
fn a_wing_that_was_found_is_written_and_read_with_the_corrections() {
    let folder = std::env::temp_dir().join(format!("wingroot-found-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder of our own");
    let path = folder.join("corrections.ron");
    let read = |found: Member| {
        std::fs::write(&path, Schedule { found: Some(found), ..schedule() }.to_ron()).expect("a file");
        Schedule::read(&path).map_err(|error| error.to_string())
    };
    assert_eq!(read(found()), Ok(Schedule { found: Some(found()), ..schedule() }));
    let mut other_boxes = found();
    other_boxes.sets[1].corrections.moment.push(1.0);
    let mut short = found();
    for values in short.sets.iter_mut().map(|set| &mut set.corrections) {
        *values = Corrections { force: vec![1.0], moment: vec![1.0], pressure_offset: vec![0.0] };
    }
    let cases = [
        (Member { sets: vec![set(20.0, 1.3)], ..found() }, "other airspeeds or boxes"),
        (Member { sets: vec![set(20.0, 1.3), set(41.0, 0.9)], ..found() }, "other airspeeds or boxes"),
        (other_boxes, "differ in length"),
        (short, "other airspeeds or boxes"),
        (Member { log_flexibility: [0.0, 2.4], ..found() }, "log_flexibility 2.4"),
        (Member { controls: vec![1.0, 1001.0], ..found() }, "1001.0 on a control surface"),
    ];
    for (found, words) in cases {
        let refused = read(found).expect_err(words);
        assert!(refused.contains(words) && refused.contains("corrections.ron"), "{words}: {refused}");
    }
    // the stream is not written; who writes it by hand is told
    let text = Schedule { found: Some(found()), ..schedule() }.to_ron();
    std::fs::write(&path, text.replace("controls: [", "stream: 1.1, controls: [")).expect("a file");
    assert!(Schedule::read(&path).expect_err("a stream").to_string().contains("stream 1.1"));
    std::fs::remove_dir_all(&folder).expect("a folder of our own");
}

/// What was found goes along with corrections that are moved, as wings of an ensemble do, and is left where airspeeds are others.
#[test]
fn a_wing_that_was_found_goes_along_with_other_corrections_of_the_same_airspeeds() {
    let from = Schedule { found: Some(found()), ..schedule() };
    let mut to = Schedule { wing: "another".into(), ..schedule() };
    to.sets[0].corrections.force[0] += 0.25;
    let moved = to.clone().with_found_of(&from, &[1, 7]);
    assert_eq!((moved.wing.as_str(), &moved.sets), ("another", &to.sets));
    let wing = moved.found.expect("the same airspeeds");
    assert_eq!((wing.log_flexibility, wing.controls), ([0.125, -0.03], vec![0.75, 1.0]));
    assert_eq!(wing.sets[0].corrections.force, [1.55, 1.0]);
    assert_eq!(wing.sets[1], set(40.0, 0.9));
    to.sets.pop();
    assert_eq!(to.with_found_of(&from, &[]).found, None);
}

#[test]
fn three_sets_are_mixed_in_all_families_by_the_two_beside() {
    let third = CorrectionSet {
        v_m_s: 50.0,
        corrections: Corrections {
            force: vec![2.0, 1.0],
            moment: vec![3.0, 0.9],
            pressure_offset: vec![-0.3, 0.2],
        },
    };
    let mut schedule = schedule();
    schedule.sets.push(third);
    // 1600, 2050, 2500: half of the way
    let found = schedule.at(2050.0_f64.sqrt()).expect("inside");
    let near =
        |a: &[f64], b: [f64; 2]| assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12), "{a:?} {b:?}");
    near(&found.force, [1.5, 1.0]);
    near(&found.moment, [2.0, 0.9]);
    near(&found.pressure_offset, [-0.1, 0.0]);
    near(&schedule.at(30.0).expect("inside").force, [1.4 - 0.4 * 5.0 / 12.0, 1.0]);
    assert_eq!(
        [19.0, 29.9, 30.1, 44.9, 45.1, 90.0].map(|v| schedule.nearest(v).v_m_s),
        [20.0, 20.0, 40.0, 40.0, 50.0, 50.0]
    );
    let one = Schedule { sets: vec![set(20.0, 1.4)], ..schedule };
    assert_eq!(one.at(20.0).expect("the one").force[0], 1.4);
}
