//! What is kept of the air is what was put there, and contradicting sizes are nothing.

use super::SolvedAir;
use crate::flight::modes::FreeModes;
use faer::{Mat, c64};

fn solved(cp: usize) -> SolvedAir {
    let of = |rows, columns, from: usize| Mat::from_fn(rows, columns, |i, j| (from + 10 * i + j) as f64);
    let modes = FreeModes { omega_rad_s: vec![0.0, 3.0, 7.0], shapes: of(12, 3, 100), boxes: of(4, 3, 200) };
    let one = |at: usize| Mat::from_fn(2, 5, |i, j| c64::new((at + i) as f64, (300 * at + j) as f64));
    SolvedAir { modes, steady: of(2, 5, 400), cp: (0..cp).map(one).collect() }
}

#[test]
fn modes_and_pressures_come_back_as_they_were_kept() {
    for count in [0, 1, 3] {
        let (one, all) = (solved(count), solved(count).matrices());
        assert_eq!(all.len(), 4 + 2 * count);
        let back = SolvedAir::of_matrices(all).expect("sizes fit");
        assert_eq!(back.modes.omega_rad_s, one.modes.omega_rad_s);
        assert_eq!((back.modes.shapes, back.modes.boxes), (one.modes.shapes, one.modes.boxes));
        assert_eq!((back.steady, back.cp), (one.steady, one.cp));
    }
}

#[test]
fn matrices_whose_sizes_contradict_each_other_are_nothing() {
    let spoilt = |at: usize, rows: usize, columns: usize| {
        let mut all = solved(2).matrices();
        all[at] = Mat::zeros(rows, columns);
        SolvedAir::of_matrices(all).is_none()
    };
    assert!(spoilt(0, 3, 2) && spoilt(0, 2, 1), "frequencies");
    assert!(spoilt(1, 12, 2) && spoilt(2, 4, 2), "modes");
    assert!(spoilt(2, 5, 3) && spoilt(2, 8, 3), "two rows a box");
    assert!(spoilt(4, 1, 5) && spoilt(5, 2, 4) && spoilt(7, 3, 5), "pressures");
    for count in [0, 3, 5, 7] {
        let mut all = solved(2).matrices();
        all.truncate(count);
        assert!(SolvedAir::of_matrices(all).is_none(), "{count} of eight");
    }
}
