//! An ensemble: wings that are as likely as the calibrated one's uncertainty lets them be, so that whatever is computed with the
//! calibrated wing can be computed with each of them, and its interval read from how far they spread.
//!
//! `calibrate` writes it as `ensemble.ron` beside `corrections.ron`.

mod file;
mod members;

pub use file::Ensemble;
pub use members::ensemble;

use crate::HALF_90;

/// The 90 % interval of what the calibrated wing has as `value` and the wings of an ensemble as `members`.
pub fn interval(value: f64, members: &[f64]) -> [f64; 2] {
    interval_of(value, &[members.to_vec()])
}

/// The same with several sources of uncertainty that know nothing of each other, each with its own wings: variances add.
pub fn interval_of(value: f64, sources: &[Vec<f64>]) -> [f64; 2] {
    let variance = |members: &Vec<f64>| {
        let squares: f64 = members.iter().map(|member| (member - value).powi(2)).sum();
        squares / members.len().max(1) as f64
    };
    let half = HALF_90 * sources.iter().map(variance).sum::<f64>().sqrt();
    [value - half, value + half]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::member::{CorrectionSet, Member, moved};
    use crate::schedule::Schedule;
    use aero::Corrections;

    #[track_caller]
    fn near(found: [f64; 2], low: f64, high: f64) {
        assert!((found[0] - low).abs() < 1e-8 && (found[1] - high).abs() < 1e-8, "{found:?}");
    }

    #[test]
    fn intervals_are_as_wide_as_members_spread_about_the_value_and_variances_of_sources_add() {
        let half = 1.644_853_627;
        near(
            interval(10.0, &[13.0, 7.0, 10.0, 10.0]),
            10.0 - half * 4.5_f64.sqrt(),
            10.0 + half * 4.5_f64.sqrt(),
        );
        // about the value, not about their own mean
        near(interval(10.0, &[13.0, 13.0]), 10.0 - 3.0 * half, 10.0 + 3.0 * half);
        near(interval_of(1.0, &[vec![4.0, -2.0], vec![5.0], vec![]]), 1.0 - 5.0 * half, 1.0 + 5.0 * half);
        assert_eq!(interval(2.0, &[]), [2.0, 2.0]);
    }

    fn corrections(force: f64, moment: f64, offset: f64) -> Corrections {
        Corrections { force: vec![force; 2], moment: vec![moment; 2], pressure_offset: vec![offset; 2] }
    }

    fn schedule(wing: &str, speeds: [f64; 2], force: f64) -> Schedule {
        let set = |v_m_s: f64| CorrectionSet { v_m_s, corrections: corrections(force, 0.9, 0.1) };
        Schedule {
            wing: wing.into(),
            wing_hash: format!("hash of {wing}"),
            sets: speeds.map(set).to_vec(),
            found: None,
            unconverged: vec![],
        }
    }

    fn member(stream: f64) -> Member {
        let set =
            |v_m_s: f64, force: f64| CorrectionSet { v_m_s, corrections: corrections(force, -0.5, 0.3) };
        Member {
            log_flexibility: [0.0; 2],
            controls: vec![0.8, 0.7],
            stream,
            sets: vec![set(20.0, 1.2), set(40.0, 0.1)],
        }
    }

    fn ensemble(members: Vec<Member>) -> Ensemble {
        Ensemble { wing: "old".into(), wing_hash: "old".into(), corrections: "old".into(), members }
    }

    /// Seven decimals are kept; a force factor does not fall below 0.05, or below where it was.
    #[test]
    fn corrections_move_by_as_much_as_others_differ() {
        let found =
            moved(&corrections(1.2, -0.5, 0.3), &corrections(1.1, 1.4, -1.0), &corrections(0.8, 2.0, 0.25));
        assert_eq!(found, corrections(1.5, -1.1, -0.95));
        let least = |centre: f64, to: f64| {
            moved(&corrections(centre, 1.0, 0.0), &corrections(to, 1.0, 0.0), &corrections(1.0, 1.0, 0.0))
                .force[0]
        };
        assert_eq!(
            [least(0.3, 0.1), least(0.04, 0.1), least(0.04, 1.2), least(-0.2, 0.9)],
            [0.05, 0.04, 0.24, -0.2]
        );
        assert_eq!(crate::member::short(0.123_456_78), 0.123_456_8);
    }

    #[test]
    fn an_ensemble_goes_along_with_other_corrections_of_the_same_airspeeds() {
        let (from, to) = (schedule("old", [20.0, 40.0], 1.0), schedule("new", [20.0, 40.0], 1.25));
        let found = ensemble(vec![member(1.0)]).about(&from, &to, &[1]).expect("the same airspeeds");
        assert_eq!((found.wing.as_str(), found.wing_hash.as_str()), ("new", "hash of new"));
        assert_eq!(found.corrections, coupling::wing_file::fingerprint(&to.to_ron()));
        let one = &found.members[0];
        assert_eq!(one.controls, [0.8, 1.0]);
        assert_eq!(
            [&one.sets[0], &one.sets[1]].map(|set| (set.v_m_s, set.corrections.clone())),
            [(20.0, corrections(1.45, -0.5, 0.3)), (40.0, corrections(0.35, -0.5, 0.3)),]
        );
        assert!(ensemble(vec![member(1.0)]).about(&from, &schedule("new", [20.0, 41.0], 1.0), &[]).is_none());
    }

    #[test]
    fn in_flight_all_that_air_does_has_the_factor_of_the_stream() {
        let sets = member(1.1).sets_in_flight();
        let near = |a: &[f64], b: f64| assert!(a.iter().all(|a| (a - b).abs() < 1e-12), "{a:?} {b}");
        assert_eq!((sets[0].v_m_s, sets[1].v_m_s), (20.0, 40.0));
        near(&sets[0].corrections.force, 1.32);
        near(&sets[1].corrections.force, 0.11);
        near(&sets[0].corrections.moment, -0.55);
        near(&sets[0].corrections.pressure_offset, 0.33);
    }

    #[test]
    fn a_file_is_read_as_written_and_refused_beside_other_corrections() {
        let path = std::env::temp_dir().join(format!("wingroot_ensemble_{}.ron", std::process::id()));
        let schedule = schedule("old", [20.0, 40.0], 1.0);
        let read = |all: &Ensemble, schedule: &Schedule| {
            std::fs::write(&path, all.to_ron().expect("numbers")).expect("a file");
            Ensemble::read(&path, schedule)
        };
        let two = ensemble(vec![member(1.0), member(1.02)]);
        assert_eq!(two.to_ron().expect("numbers").matches("stream").count(), 1);
        assert_eq!(read(&two, &schedule).expect("as written"), two);
        assert!(read(&ensemble(vec![]), &schedule).expect_err("none").to_string().contains("0 wings"));
        let mut small = member(1.0);
        small.log_flexibility = [0.5, 0.25];
        for set in &mut small.sets {
            set.corrections = Corrections { force: vec![1.0], moment: vec![1.0], pressure_offset: vec![0.0] };
        }
        let mut one_box = schedule.clone();
        for set in &mut one_box.sets {
            set.corrections = Corrections { force: vec![1.0], moment: vec![1.0], pressure_offset: vec![0.0] };
        }
        assert!(read(&ensemble(vec![small.clone(); 1000]), &one_box).is_ok());
        assert!(read(&ensemble(vec![small.clone(); 1001]), &one_box).is_err());
        let mut others = Vec::new();
        others.push(Member { sets: member(1.0).sets[..1].to_vec(), ..member(1.0) });
        let mut other = member(1.0);
        other.sets[1].v_m_s = 41.0;
        others.push(other);
        for family in 0..3 {
            let mut other = member(1.0);
            let corrections = &mut other.sets[1].corrections;
            [&mut corrections.force, &mut corrections.moment, &mut corrections.pressure_offset][family]
                .push(1.0);
            others.push(other);
        }
        for other in others {
            let refused =
                read(&ensemble(vec![member(1.0), other]), &schedule).expect_err("another wing").to_string();
            assert!(refused.contains("wing 2 has other airspeeds or boxes"), "{refused}");
        }
        std::fs::remove_file(&path).expect("our own file");
    }
}
