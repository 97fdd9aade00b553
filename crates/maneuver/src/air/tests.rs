//! Which air a rig moves through, how far it is off, and the chord that frequencies refer to, by hand.

use super::*;
use aero::AeroBox;
use nalgebra::Point3;

fn constant(value: f64) -> RationalAir {
    RationalAir::quasi_steady(Mat::from_fn(1, 1, |_, _| value), Mat::zeros(1, 1))
}

/// One box that moves in one way; `table`: frequencies and pressures there.
fn air(table: Option<(Vec<f64>, Vec<f64>)>) -> UnsteadyAir {
    let one = || Mat::from_fn(1, 1, |_, _| 1.0);
    let table = table.map(|(omega_over_v_per_m, cp)| AirTable {
        omega_over_v_per_m,
        cp: cp.into_iter().map(|cp| Mat::from_fn(1, 1, |_, _| c64::new(cp, 0.0))).collect(),
    });
    UnsteadyAir {
        columns: MotionColumns { still: one(), moving: one() },
        chord_m: 0.2,
        table,
        looked_at: one(),
        rational: constant(1.0),
        beyond: constant(2.0),
        instant: constant(3.0),
        wake: Wake::default(),
        quasi_steady: constant(4.0),
        lattice: None,
    }
}

#[test]
fn modes_within_the_table_have_its_lags_and_in_slow_air_nothing_has_any() {
    let air = air(Some((vec![1.0, 4.0], vec![1.0, 1.0])));
    let of = |parts: &AirParts<'_>| parts.families.map(|family| family.steady[(0, 0)]);
    // the highest frequency is 4 V
    let parts = air.at_airspeed(&[119.0, 120.0, 121.0], 30.0);
    assert_eq!((of(&parts), parts.slow_modes), ([1.0, 2.0], 2));
    let parts = air.at_airspeed(&[39.0, 41.0, 40.0], 10.0);
    assert_eq!((of(&parts), parts.slow_modes), ([3.0, 3.0], 1));
    // 15 Hz are 94.2 rad/s
    assert_eq!(of(&air.at_airspeed(&[], 23.5)), [3.0, 3.0]);
    assert_eq!(of(&air.at_airspeed(&[], 23.6)), [1.0, 2.0]);
    let without = self::air(None);
    let parts = without.at_airspeed(&[1e5], 0.0);
    assert_eq!((of(&parts), parts.slow_modes), ([1.0, 2.0], 1));
}

#[test]
fn accuracy_is_the_largest_difference_over_the_largest_pressure() {
    let accuracy = air(Some((vec![1.0, 4.0], vec![1.1, 2.0]))).accuracy().expect("a table");
    assert!((accuracy.error[(0, 0)] - 0.5).abs() < 1e-12 && accuracy.error.nrows() == 1);
    assert!(air(None).accuracy().is_none());
    let mut quasi_steady = air(None);
    quasi_steady.rational.rate = Mat::from_fn(1, 1, |_, _| 0.25);
    assert_eq!(quasi_steady.exact(2.0).expect("its own")[(0, 0)], c64::new(1.0, 0.5));
}

#[test]
fn the_mean_chord_is_the_area_over_the_width_of_all_strips() {
    // strips of unlike width and chord, three and two boxes along the chord
    let strips = |id: u32, sides: &[[f64; 2]], chord: f64, count: u32| {
        let mut boxes = Vec::new();
        for (strip, [inner, outer]) in sides.iter().enumerate() {
            for row in 0..count {
                let x = [row, row + 1].map(|k| chord * f64::from(k) / f64::from(count));
                let at = |x: f64, y: f64| Point3::new(x, y, 0.0);
                let id = id + count * u32::try_from(strip).expect("few") + row;
                let corners = [at(x[0], *inner), at(x[1], *inner), at(x[1], *outer), at(x[0], *outer)];
                boxes.push(AeroBox { id, corners });
            }
        }
        Lattice::from_corners("strips", count as usize, boxes).expect("boxes")
    };
    let inner = strips(1, &[[0.0, 1.0], [1.0, 4.0]], 0.6, 3);
    assert!((mean_chord_m(&inner) - 0.6).abs() < 1e-12);
    let outer = strips(101, &[[4.0, 4.5], [4.5, 6.5], [6.5, 6.7]], 0.3, 2);
    let both = inner.joined(&outer).expect("numbers of their own");
    assert!((mean_chord_m(&both) - (0.6 * 4.0 + 0.3 * 2.7) / 6.7).abs() < 1e-12);
}
