//! The count that proves modes complete, where the iteration does not see half of them.

use super::*;
use crate::model::Model;
use std::fmt::Write as _;

/// Two equal cantilevers that do not hang together: every frequency is there twice.
fn two_wings() -> System {
    let mut deck = String::from("MAT1,1,7.+10,2.7+10,,2700.\nPBAR,1,1,1.-4,4.-9,1.-9,2.-9\n");
    for wing in 0..2 {
        for node in 0..=8 {
            let _ = writeln!(deck, "GRID,{},,{wing}.,{:?},0.", 100 * wing + node + 1, 0.25 * f64::from(node));
        }
        for grid in (100 * wing + 1)..(100 * wing + 9) {
            let _ = writeln!(deck, "CBAR,{grid},1,{grid},{},0.,0.,1.", grid + 1);
        }
        let _ = writeln!(deck, "SPC1,1,123456,{}", 100 * wing + 1);
    }
    let bulk = nastran::parse_deck("test.bdf", &deck).expect("a deck");
    System::assemble(&Model::from_bulk(&bulk).expect("a model")).expect("a structure")
}

/// A search that starts without any motion of the second wing, which no iteration then gives it.
fn half_blind(system: &System, count: usize, known: Option<Count>) -> Search<'_> {
    let mut search = Search::new(system, system.mass(), count, known, 0, 0.0, held(system));
    let of_second = |i: usize| system.name(i).0 > 100;
    for j in 0..search.block.ncols() {
        for i in (0..search.block.nrows()).filter(|i| of_second(*i)) {
            search.block[(i, j)] = 0.0;
        }
    }
    search
}

#[test]
fn modes_that_the_iteration_does_not_see_are_missed_by_the_count() {
    let system = two_wings();
    let pairs = |modes: Modes| {
        for pair in modes.omega_rad_s.chunks(2) {
            assert!((pair[1] / pair[0] - 1.0).abs() < 1e-8, "not twice: {:?}", modes.omega_rad_s);
        }
    };
    let mut blind = half_blind(&system, 6, None);
    let factor = blind.factor.take().expect("a factor");
    blind.by_sweeps(factor).expect("it converges, on half of the modes");
    let difference =
        blind.check(Room::default()).expect("it can be counted").expect("and the count contradicts");
    let ModesError::Incomplete { found, counted, .. } = difference else { panic!("{difference}") };
    assert_eq!((found, counted), (6, 12));
    pairs(half_blind(&system, 6, None).run().expect("the block grows until all are found"));
    // as many as lie below a frequency: none beyond it may stand in for those that are missed
    let all = normal_modes(&system, 8).expect("modes").omega_rad_s;
    let square = (0.5 * (all[5] + all[6])).powi(2);
    let known = Some(Count { square, below: 6 });
    let found = half_blind(&system, 6, known).run().expect("modes");
    assert!(found.omega_rad_s.iter().all(|omega| omega * omega < square), "{:?}", found.omega_rad_s);
    pairs(found);
}

/// Masses of 1 to 4 kg in a row along z on springs of 30, 20 and 50 N/m between them; held by one of 10 N/m at the
/// first, or free.
fn row(is_held: bool) -> System {
    let mut deck = String::from(
        "SPC1,1,12456,1,2,3,4\nCELAS2,1,30.,1,3,2,3\nCELAS2,2,20.,2,3,3,3\nCELAS2,3,50.,3,3,4,3\n",
    );
    for grid in 1..=4 {
        let _ = writeln!(deck, "GRID,{grid},,{grid}.,0.,0.\nCONM2,{},{grid},,{grid}.", 10 + grid);
    }
    if is_held {
        deck.push_str("CELAS2,9,10.,1,3\n");
    }
    let bulk = nastran::parse_deck("test.bdf", &deck).expect("a deck");
    System::assemble(&Model::from_bulk(&bulk).expect("a model")).expect("a structure")
}

/// A search that has come to some values.
fn come_to<'a>(system: &'a System, values: &[f64], rigid: usize, shift: f64) -> Search<'a> {
    let n = system.free_count();
    let mut search =
        Search::new(system, system.mass(), values.len().max(1), None, rigid, shift, held(system));
    let vectors = Mat::from_fn(n, values.len(), |i, j| f64::from(u8::from(i == j)) - 0.1);
    search.ritz = Ritz { values: values.to_vec(), vectors };
    search
}

#[test]
fn the_first_elastic_value_comes_after_the_rigid_ones() {
    let system = row(false);
    // A millionth of the smallest ratio of stiffness to mass: 30/1, 50/2, 70/3, 50/4.
    let least = 12.5e-6;
    assert!((first_shift(&system) - least).abs() < 1e-18);
    for (values, rigid, expected) in [
        (vec![1e-9, 5.0, 7.0], 1, 5.0),
        (vec![5.0, 7.0], 0, 5.0),
        (vec![1e-9, 0.0, 7.0], 1, least),
        (vec![1e-9, -2.0], 1, least),
        (vec![1e-9], 1, least),
        (vec![1e-9, 1e-9, 7.0], 2, 7.0),
    ] {
        assert!(
            (come_to(&system, &values, rigid, 0.0).first_elastic() - expected).abs() < 1e-15,
            "{values:?}"
        );
    }
    let massless = System::from_matrices(
        vec![1],
        vec![Point3::origin()],
        Mat::<f64>::identity(6, 6).as_ref(),
        Mat::<f64>::zeros(6, 6).as_ref(),
        &[],
    );
    assert_eq!(first_shift(&massless), 1.0);
}

#[test]
fn motions_below_a_thousandth_of_the_first_elastic_value_are_rigid_if_there_may_be_some() {
    let system = row(false);
    let omega = |values: &[f64], rigid: usize| come_to(&system, values, rigid, 0.0).modes().omega_rad_s;
    assert_eq!(omega(&[0.003_9, 4.0, 9.0], 1), [0.0, 2.0, 3.0]);
    assert_eq!(omega(&[0.004_1, 4.0, 9.0], 1), [0.004_1_f64.sqrt(), 2.0, 3.0]);
    assert_eq!(omega(&[0.003_9, 4.0, 9.0], 0), [0.003_9_f64.sqrt(), 2.0, 3.0]);
    assert_eq!(omega(&[-1e-9, 0.01, 9.0], 1), [0.0, 0.1, 3.0]);
    assert_eq!(omega(&[-1e-9, 9.0], 0), [0.0, 3.0], "a square is not negative");
}

#[test]
fn blocks_are_twice_as_wide_eight_wider_or_all() {
    let system = row(true);
    let mut search = come_to(&system, &[1.0, 2.0], 0, 0.0);
    search.block = Mat::zeros(4, 3);
    let filled = search.keep_size(Mat::from_fn(4, 2, |i, j| (1 + i + j) as f64).as_ref());
    assert_eq!((filled.ncols(), filled[(3, 1)], filled[(3, 2)]), (3, 5.0, 0.0));
    for (count, rigid, columns) in [(1, 0, 2), (2, 0, 4), (1, 2, 4), (3, 0, 4)] {
        let search = Search::new(&system, system.mass(), count, None, rigid, 0.0, held(&system));
        assert_eq!(search.block.ncols(), columns, "twice as many, eight more, or all");
    }
    let wings = two_wings();
    assert_eq!(Search::new(&wings, wings.mass(), 12, None, 0, 0.0, held(&wings)).block.ncols(), 20);
}

#[test]
fn a_shift_comes_down_to_the_first_elastic_value_once_that_is_a_tenth() {
    let system = row(false);
    for (first, shift, lowered) in [
        (0.4, 5.0, true),
        (0.5, 5.0, true),
        (0.6, 5.0, false),
        (0.0, 5.0, false),
        (-0.1, 5.0, false),
        (0.4, 0.0, false),
    ] {
        let mut search = come_to(&system, &[1e-9, first], 1, shift);
        assert_eq!(search.lowers_shift(), lowered, "{first} and {shift}");
        assert_eq!(search.shift, if lowered { first } else { shift });
    }
    assert!(!come_to(&system, &[1e-9], 1, 5.0).lowers_shift(), "nothing elastic so far");
}

/// Of K x = omega^2 M x for the row: by hand for what is asked, the values that are known.
#[test]
fn what_was_found_is_compared_with_what_is_counted() {
    let system = row(true);
    let all = normal_modes(&system, 4).expect("modes").omega_rad_s;
    let squares: Vec<f64> = all.iter().map(|omega| omega * omega).collect();
    let known = |below: usize, square: f64| Some(Count { square, below });
    let between = 0.5 * (squares[1] + squares[2]);
    let mut search = come_to(&system, &squares[..2], 0, 0.0);
    assert_eq!(search.check(Room::default()), Ok(None), "both are there");
    search.known = known(2, between);
    assert_eq!(search.check(Room::default()), Ok(None), "as is known");
    // A wrong count that is known, beside one that is taken.
    search.known = known(3, between);
    assert_eq!(search.check(Room::default()), Ok(None), "counted afresh");
    let missed = come_to(&system, &[squares[0], squares[2]], 0, 0.0);
    let Ok(Some(ModesError::Incomplete { found, counted, omega_rad_s })) = missed.check(Room::default())
    else {
        panic!("incomplete")
    };
    assert_eq!((found, counted), (2, 3));
    assert!((omega_rad_s / all[2] - 1.0).abs() < 1e-5 && omega_rad_s > all[2]);
    // A value that is known to lie below, and does not.
    let mut beyond = come_to(&system, &[squares[0], squares[2]], 0, 0.0);
    beyond.known = known(2, between);
    assert!(matches!(beyond.check(Room::default()), Ok(Some(_))), "one of two lies below");
    // Rigid motions are counted below a thousandth of the first elastic value.
    let free = row(false);
    let squares: Vec<f64> =
        normal_modes(&free, 4).expect("modes").omega_rad_s.iter().map(|o| o * o).collect();
    assert_eq!(come_to(&free, &[1e-12, squares[1]], 1, 0.0).check(Room::default()), Ok(None));
    let mut one = come_to(&free, &[1e-12, squares[1]], 1, 0.0);
    one.count = 1;
    assert_eq!(one.check(Room::default()), Ok(None), "the rigid one alone");
}

/// The largest displacement along z is positive; of what hardly moves along z the largest; of rotations alone the
/// largest of these.
#[test]
fn signs_are_those_of_what_moves_most() {
    let free = Mat::<f64>::identity(12, 12);
    let ids = vec![1, 2];
    let points = vec![Point3::origin(), Point3::new(1.0, 0.0, 0.0)];
    let system = System::from_matrices(ids, points, free.as_ref(), free.as_ref(), &[]);
    let sign = |entries: &[(usize, f64)]| {
        let mut shape = Mat::zeros(12, 1);
        for (at, value) in entries {
            shape[(*at, 0)] = *value;
        }
        sign_component(&system, shape.as_ref())
    };
    // z are 2 and 8.
    assert_eq!(sign(&[(0, 9.0), (2, -1.0), (8, 0.5)]), -1.0);
    assert_eq!(sign(&[(0, -9.0), (2, 0.5), (8, 1.0), (5, -70.0)]), 1.0);
    assert_eq!(sign(&[(2, -1.0), (8, 1.0)]), -1.0, "the first of equals");
    assert_eq!(sign(&[(2, -1.0 + 1e-8), (8, 1.0)]), -1.0 + 1e-8);
    assert_eq!(sign(&[(2, -1.0 + 1e-5), (8, 1.0)]), 1.0);
    assert_eq!(sign(&[(6, -9.0), (1, 3.0), (2, 1e-6)]), -9.0, "hardly along z");
    assert_eq!(sign(&[(6, -9.0), (2, 1e-5)]), 1e-5);
    assert_eq!(sign(&[(3, 2.0), (10, -3.0)]), -3.0, "rotations alone");
    assert_eq!(sign(&[]), 0.0);
}

#[test]
fn as_many_modes_as_motions_and_no_more_can_be_asked_for() {
    let system = row(true);
    assert_eq!(
        normal_modes(&system, 5).expect_err("too many"),
        ModesError::TooMany { asked: 5, available: 4 }
    );
    let none = normal_modes(&system, 0).expect("nothing");
    assert_eq!((none.omega_rad_s.len(), none.shapes.nrows(), none.shapes.ncols()), (0, 4, 0));
    let all = normal_modes(&system, 4).expect("all").omega_rad_s;
    // The product of the squares is det K / det M: by the chain 10 * 30 * 20 * 50 over 1 * 2 * 3 * 4.
    let product: f64 = all.iter().map(|omega| omega * omega).product();
    assert!((product / (300_000.0 / 24.0) - 1.0).abs() < 1e-10, "{product}");
    let below = normal_modes_below(&system, 0.5 * (all[1] + all[2]), 1).expect("two").omega_rad_s;
    assert_eq!(below.len(), 2);
    assert_eq!(normal_modes_below(&system, 0.5 * all[0], 0).expect("none").omega_rad_s.len(), 0);
    assert_eq!(normal_modes_below(&system, 0.5 * all[0], 3).expect("three").omega_rad_s.len(), 3);
    assert_eq!(normal_modes_below(&system, 2.0 * all[3], 1).expect("all").omega_rad_s.len(), 4);
}

/// Eleven hundred oscillators, twelve of them alike: what Lanczos does not see the count misses.
#[test]
fn a_large_structure_with_many_copies_of_a_frequency_has_them_all() {
    let nodes = 190;
    let square = |dof: usize| if dof < 12 { 4.0 } else { 9.0 + dof as f64 };
    let diagonal = |entry: &dyn Fn(usize) -> f64| {
        Mat::from_fn(6 * nodes, 6 * nodes, |i, j| if i == j { entry(i) } else { 0.0 })
    };
    let (k, m) = (diagonal(&|dof| 2.0 * square(dof)), diagonal(&|_| 2.0));
    let ids = (1..=190).collect();
    let system = System::from_matrices(ids, vec![Point3::origin(); nodes], k.as_ref(), m.as_ref(), &[]);
    let way = |count| Search::new(&system, system.mass(), count, None, 0, 0.0, held(&system)).way;
    assert_eq!(way(10), Way::Lanczos);
    for count in [10, 14] {
        let modes = normal_modes(&system, count).expect("modes");
        for (at, omega) in modes.omega_rad_s.iter().enumerate() {
            assert!((omega.powi(2) / square(at) - 1.0).abs() < 1e-10, "{count}: {at} {omega}");
        }
    }
    assert_eq!(way(200), Way::Rotations);
}

#[test]
fn many_modes_of_a_small_structure_that_is_held_come_from_rotations() {
    let cases = [
        (Way::of(1500, 188, 0.0, true), Way::Rotations),
        (Way::of(1501, 188, 0.0, true), Way::Sweeps),
        (Way::of(1500, 188, 0.0, false), Way::Sweeps),
        (Way::of(1500, 188, 1.0, true), Way::Rotations),
        (Way::of(1500, 187, 0.0, true), Way::Lanczos),
        (Way::of(1500, 187, 1.0, true), Way::Sweeps),
        (Way::of(1000, 125, 0.0, true), Way::Sweeps),
        (Way::of(1000, 126, 0.0, true), Way::Rotations),
    ];
    for (at, (way, expected)) in cases.into_iter().enumerate() {
        assert_eq!(way, expected, "{at}");
    }
}
