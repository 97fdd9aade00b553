//! A gust on boxes that stand aslant, and a table's phase, by hand.

use super::*;
use aero::AeroBox;
use nalgebra::Point3;

#[test]
fn a_gust_is_an_incidence_by_its_part_along_the_normal_and_comes_later_farther_aft() {
    // a dihedral of tan 3/4: normal (0, -.6, .8); three quarters of the chord at x = 1.75 and 3.75
    let corner = |x: f64, y: f64| Point3::new(x, y, 0.75 * y);
    let boxes = [1.0, 3.0].into_iter().zip(1..).map(|(x, id)| AeroBox {
        id,
        corners: [corner(x, 0.0), corner(x + 1.0, 0.0), corner(x + 1.0, 2.0), corner(x, 2.0)],
    });
    let lattice = Lattice::from_corners("aslant", 1, boxes.collect()).expect("boxes");
    let (from, kappa) = (0.5, 0.8);
    let upwards = gust_incidence(&lattice, from, kappa);
    let along = gust_incidence_along(&lattice, [5.0, 2.0, -3.0], from, kappa);
    for (j, x) in [1.75, 3.75].into_iter().enumerate() {
        let later = c64::new(0.0, -kappa * (x - from)).exp();
        assert!((upwards[(j, 0)] - later * 0.8).norm() < 1e-12, "box {j}");
        assert!((along[(j, 0)] - later * (-1.2 - 2.4)).norm() < 1e-12, "box {j}");
    }
    assert_eq!((upwards.nrows(), upwards.ncols()), (2, 1));
}

#[test]
fn a_table_gives_the_answer_to_a_gust_that_is_counted_from_elsewhere() {
    let of = |kappa: f64| Mat::from_fn(2, 1, |i, _| c64::new(1.0 + kappa, i as f64));
    let table = FrequencyTable::new(vec![0.25, 1.0], vec![of(0.25), of(1.0)], 3.0).expect("a table");
    assert_eq!(table.range(), (0.25, 1.0));
    // counted from 1.5 m further upstream it comes 1.5 m later
    let found = table.at(0.5, 1.5).expect("inside");
    let later = c64::new(0.0, -0.75).exp();
    assert!((found[(0, 0)] - later * 1.5).norm() < 1e-12);
    assert!((found[(1, 0)] - later * c64::new(1.5, 1.0)).norm() < 1e-12);
    let error = table.at(1.25, 0.0).expect_err("outside");
    assert!(
        matches!(error, FlutterError::OutsideTable { asked, low, high } if [asked, low, high] == [1.25, 0.25, 1.0])
    );
}
