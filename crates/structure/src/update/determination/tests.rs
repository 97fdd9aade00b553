//! What measurements determine.

use super::*;

#[test]
fn a_difference_nothing_is_known_of_is_the_undetermined_direction() {
    // Two measurements of the sum of two factors with a standard deviation of 0.01, one of the third.
    let j = [vec![100.0, 100.0, 0.0], vec![100.0, 100.0, 0.0], vec![0.0, 0.0, 50.0]];
    let (found, step) = Determination::of(&j, &[2.0, 2.0, 1.0], 3, 0.5);
    assert_eq!(found.determined, 2);
    assert!(!found.is_determined(0) && !found.is_determined(1) && found.is_determined(2));
    let open = &found.undetermined_directions()[0];
    assert!((open[0].1 + open[1].1).abs() < 1e-12 && (open[0].1.abs() - 0.5_f64.sqrt()).abs() < 1e-12);
    // The step is the smallest that explains the sum, and the third factor's.
    for (got, want) in step.iter().zip([0.01, 0.01, 0.02]) {
        assert!((got - want).abs() < 1e-12, "{step:?}");
    }
    assert!((found.covariance()[2][2].sqrt() - 0.02).abs() < 1e-12);
}

#[test]
fn without_data_nothing_is_determined() {
    let (found, step) = Determination::of(&[], &[], 2, 0.5);
    assert_eq!((found.determined, step), (0, vec![0.0, 0.0]));
    assert!(found.sigma.iter().all(|sigma| sigma.is_infinite()));
    assert_eq!(Determination::of(&[vec![]], &[1.0], 0, 0.5).0.determined, 0);
}

/// Two directions at 45 degrees, with sigmas of 1/10 and 1/2, worked out by hand.
#[test]
fn directions_have_the_sigma_of_their_singular_value_and_count_below_the_limit() {
    let root = 0.5_f64.sqrt();
    let j = [vec![10.0 * root, 10.0 * root], vec![2.0 * root, -2.0 * root]];
    for (limit, determined) in [(0.6, 2), (0.4, 1), (0.11, 1), (0.09, 0)] {
        let (found, step) = Determination::of(&j, &[10.0, 2.0], 2, limit);
        assert_eq!(found.determined, determined, "limit {limit}");
        for (sigma, expected) in found.sigma.iter().zip([0.1, 0.5]) {
            assert!((sigma - expected).abs() < 1e-14);
        }
        // The residuals are those of a step of one along each direction.
        let along = |direction: [f64; 2]| step[0] * direction[0] + step[1] * direction[1];
        for (at, own) in [along([root, root]), along([root, -root])].into_iter().enumerate() {
            let expected = f64::from(u8::from(at < determined));
            assert!((own - expected).abs() < 1e-13, "limit {limit}, direction {at}: {own}");
        }
        let covariance = found.covariance();
        let squares = [0.01, 0.25].iter().take(determined);
        let (sum, difference) = squares.enumerate().fold((0.0, 0.0), |(sum, difference), (at, square)| {
            (sum + 0.5 * square, difference + if at == 0 { 0.5 } else { -0.5 } * square)
        });
        for (row, column, expected) in [(0, 0, sum), (1, 1, sum), (0, 1, difference), (1, 0, difference)] {
            assert!((covariance[row][column] - expected).abs() < 1e-13, "limit {limit}: {covariance:?}");
        }
        for factor in 0..2 {
            let share = 0.5 * f64::from(u8::try_from(2 - determined).expect("two directions"));
            assert!((found.undetermined_share(factor) - share).abs() < 1e-14);
            assert_eq!(found.is_determined(factor), determined == 2);
        }
        assert_eq!(found.undetermined_directions().len(), 2 - determined);
    }
}

#[test]
fn small_parts_of_a_direction_are_left_out_and_small_shares_do_no_harm() {
    // A direction that nothing is known of: mostly the first factor, by 0.04 or 0.06 the second.
    for (part, named, share_of_second) in [(0.04_f64, 1, true), (0.06, 2, true), (0.11, 2, false)] {
        let first = (1.0 - part * part).sqrt();
        let (found, _) = Determination::of(&[vec![-100.0 * part, 100.0 * first]], &[0.0], 2, 0.5);
        assert_eq!(found.determined, 1);
        let open = &found.undetermined_directions()[0];
        assert_eq!(open.len(), named, "part {part}: {open:?}");
        assert!((open[0].1.abs() - first).abs() < 1e-12 && open[0].0 == 0);
        // A hundredth of a factor may lie there: 0.1 squared.
        assert_eq!(found.is_determined(1), share_of_second, "part {part}");
        assert!(!found.is_determined(0));
        assert_eq!(found.sigma[1], f64::INFINITY);
    }
}
