//! Rows of a round trip, of loads at three points by hand.

use super::{Balanced, Row, balance_rows, round_trip_csv, station_rows};
use crate::package::cards::CardCase;
use crate::package::condensed::Condensed;
use crate::package::round_trip::Expected;
use crate::stations::nodal::{Component, NodalLoads};
use crate::stations::places::Station;
use nalgebra::{Matrix3, Point3};
use nastran::load_cards;

fn station(name: &str, point: Point3<f64>, nodes: &[usize]) -> Station {
    Station {
        name: name.to_owned(),
        channel: name.to_owned(),
        point,
        nodes: nodes.to_vec(),
        axes: Matrix3::identity(),
    }
}

fn points() -> [Point3<f64>; 3] {
    [Point3::new(0.0, 0.0, 0.0), Point3::new(1.0, 2.0, 0.5), Point3::new(1.5, 4.0, -0.5)]
}

fn loads() -> Vec<f64> {
    (0..18).map(|at| (1.7 * f64::from(at + 1)).sin()).collect()
}

#[test]
fn differences_are_shares_of_the_largest_force_or_moment_of_all_stations() {
    let stations = [station("a", Point3::origin(), &[0]), station("b", Point3::origin(), &[1])];
    let expected = [[1.0, 2.0, -4.0, 10.0, 0.0, 0.0], [3.0, 0.0, 1.0, -20.0, 5.0, 8.0]];
    let mut sums = expected;
    (sums[0][0], sums[1][5]) = (1.5, 7.0);
    let rows = station_rows(3, &stations, &expected, &sums);
    assert_eq!(rows.len(), 12);
    let off: Vec<(&str, &str, f64)> = rows
        .iter()
        .filter(|row| !row.holds())
        .map(|row| (row.place.as_str(), row.what, row.of_largest))
        .collect();
    assert_eq!(off, vec![("a", "Fx_N", 0.5 / 4.0), ("b", "Mz_Nm", 1.0 / 20.0)]);
    let csv = round_trip_csv(&rows);
    assert!(csv.contains("3,a,Fx_N,1e0,1.5e0,5e-1,1.25e-1,not reproduced\n"), "{csv}");
    assert!(csv.contains("3,b,Fx_N,3e0,3e0,0e0,0e0,reproduced\n"), "{csv}");
    let row = |off: f64| Row::new(1, "a", "Fx_N", [1.0, 1.0 + off], 1.0);
    assert!(row(0.9e-9).holds() && !row(1.1e-9).holds());
    assert_eq!(Row::new(1, "a", "Fx_N", [0.0, 0.0], 0.0).of_largest, 0.0);
}

#[test]
fn a_balance_is_work_in_a_motion_as_a_share_of_all_sizes() {
    let (points, mut loads) = (points(), vec![0.0; 18]);
    // 3 N along x and 4 N along y at the second point, 12 N m about x at the third
    (loads[6], loads[7], loads[15]) = (3.0, 4.0, 12.0);
    let about = Point3::new(1.0, 2.0, 1.7);
    let rows = balance_rows(9, &points, &loads, &Balanced::all(about));
    // arm -1.2 m along z: moments of forces 1.2 m x (4, -3, 0) and the free one
    let law = [3.0, 4.0, 0.0, 4.8 + 12.0, -3.6, 0.0];
    let sizes = [5.0, 5.0, 5.0, 18.0, 18.0, 18.0];
    for (row, (law, size)) in rows.iter().zip(law.into_iter().zip(sizes)) {
        assert!((row.cards - law).abs() < 1e-12 && row.solver == 0.0, "{row:?} {law}");
        assert!((row.of_largest - f64::abs(law) / size).abs() < 1e-12, "{row:?} {size}");
    }
    let shares = [2.0, 0.0, 0.0, 0.0, 0.5, 0.0];
    let one = balance_rows(9, &points, &loads, &[Balanced { load: 4, about, shares }]);
    assert!((one[0].cards - (6.0 - 1.8)).abs() < 1e-12 && one[0].what == "My_Nm");
}

#[test]
fn condensed_points_carry_what_no_inner_station_has_and_add_up_to_every_cut() {
    let (points, loads) = (points(), loads());
    let inner = Point3::new(1.2, 3.0, 0.1);
    let stations = [
        station("whole", Point3::new(0.2, 0.0, 0.3), &[0, 1, 2]),
        station("tip", inner, &[2]),
        station("half", Point3::new(0.9, 1.5, 0.2), &[1, 2]),
    ];
    let condensed = Condensed::new(&stations, &points, 100).expect("they nest");
    assert_eq!(condensed.grids(), [101, 102, 103]);
    assert_eq!(condensed.places()[1], inner);
    let own = condensed.loads(&loads);
    for (at, node) in [(0, 0), (1, 2), (2, 1)] {
        let force = nalgebra::Vector3::from_row_slice(&loads[6 * node..6 * node + 3]);
        let moment = nalgebra::Vector3::from_row_slice(&loads[6 * node + 3..6 * node + 6]);
        let law = moment + (points[node] - stations[at].point).cross(&force);
        for axis in 0..3 {
            assert!((own[6 * at + axis] - force[axis]).abs() < 1e-14);
            assert!((own[6 * at + 3 + axis] - law[axis]).abs() < 1e-14);
        }
    }
    let expected = Expected {
        stations: stations.iter().map(|station| station.sums(&points, &loads)).collect(),
        tips_m: Vec::new(),
    };
    let case = CardCase { sid: 5, words: String::new(), net: own.clone(), parts: Vec::new() };
    let (text, cards) = (load_cards(5, condensed.grids(), &own), condensed.cards(&[]));
    let rows = condensed.compare(&case, &text, &cards, &expected, &Balanced::all(points[0]));
    let rows = rows.expect("it is read back");
    assert_eq!(rows.len(), 18 + 6);
    assert!(rows[..18].iter().all(Row::holds), "{rows:?}");
    let whole = station("balance", points[0], &[0, 1, 2]).sums(&points, &loads);
    for (row, law) in rows[18..].iter().zip(whole) {
        assert!((row.cards - law).abs() < 1e-9, "the whole, moved to another point: {row:?} {law}");
    }
    // a grid of a station that is not there, and one elsewhere
    let without = cards.replace("             102", "             202");
    assert!(condensed.compare(&case, &text, &without, &expected, &[]).is_err());
    let nodal = condensed.nodal(&NodalLoads {
        air: loads.clone(),
        inertia: vec![0.0; 18],
        thrust: loads.clone(),
        damping: vec![0.0; 18],
    });
    let net: Vec<f64> = own.iter().map(|load| 2.0 * load).collect();
    assert_eq!((nodal.of(Component::Air), nodal.of(Component::Net)), (own, net));
}

#[test]
fn stations_that_overlap_or_leave_grids_out_cannot_be_condensed() {
    let points = points();
    // which nodes count for each point: by a unit force on one after the other
    let counted = |made: &Condensed<'_>, stations: usize| -> Vec<Vec<usize>> {
        let unit = |node: usize| {
            made.loads(&(0..18).map(|at| f64::from(u8::from(at == 6 * node))).collect::<Vec<_>>())
        };
        let by_node: Vec<Vec<f64>> = (0..3).map(unit).collect();
        (0..stations).map(|at| (0..3).filter(|node| by_node[*node][6 * at] == 1.0).collect()).collect()
    };
    let of = |sets: &[Vec<usize>]| {
        let at = |(i, nodes): (usize, &Vec<usize>)| station(&format!("s{i}"), points[0], nodes);
        let all: Vec<Station> = sets.iter().enumerate().map(at).collect();
        Condensed::new(&all, &points, 0).map(|made| counted(&made, all.len()))
    };
    let why = |sets: &[Vec<usize>]| of(sets).expect_err("it cannot be").to_string();
    assert!(why(&[vec![0, 1], vec![1, 2]]).contains("stations s0 and s1 share grids"));
    assert!(why(&[vec![0, 1]]).contains("1 grids are in no station"));
    let same = |sets: &[Vec<usize>], law: &[Vec<usize>]| assert_eq!(of(sets).expect("they nest"), law);
    same(&[vec![0, 1], vec![2]], &[vec![0, 1], vec![2]]);
    // of two with the same nodes the later is inside
    same(&[vec![0, 1, 2], vec![0, 1, 2]], &[vec![], vec![0, 1, 2]]);
    same(&[vec![1], vec![0, 1, 2], vec![1, 2]], &[vec![1], vec![0], vec![2]]);
}
