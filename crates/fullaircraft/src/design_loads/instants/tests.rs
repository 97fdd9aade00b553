//! Instants that drive loads, of loads made by hand.

use super::driving;
use crate::flight::gust::GustAxis;

/// Samples that drive when station 0 has some loads and station 1 is still.
fn found(axis: GustAxis, loads: &[[f64; 6]]) -> Vec<usize> {
    driving(&|station, sample| if station == 0 { loads[sample] } else { [1.0; 6] }, 2, loads.len(), axis)
}

#[test]
fn both_ends_of_each_load_of_the_axis_and_of_the_diagonals_over_their_ranges_drive() {
    // ends of Fz at 1 and 2, Mx at 3 and 4, My at 5 and 6; diagonals at 7, 8 and 9, 10 (0.9 of each range, a
    // thousandth of My's size)
    let mut loads = vec![[0.0; 6]; 12];
    (loads[1][2], loads[2][2]) = (5.0, -5.0);
    (loads[3][3], loads[4][3]) = (100.0, -100.0);
    (loads[5][4], loads[6][4]) = (0.1, -0.1);
    (loads[7][3], loads[7][4]) = (90.0, 0.09);
    (loads[8][3], loads[8][4]) = (-90.0, -0.09);
    (loads[9][3], loads[9][4]) = (90.0, -0.09);
    (loads[10][3], loads[10][4]) = (-90.0, 0.09);
    (loads[11][0], loads[11][1], loads[11][5]) = (1e6, 1e6, 1e6);
    // of a station that does not move the first and the last count
    assert_eq!(found(GustAxis::Vertical, &loads), (0..12).collect::<Vec<_>>());
    let mut more = loads.clone();
    more.push([0.0; 6]);
    more.push([0.0; 6]);
    let law: Vec<usize> = (0..11).chain([13]).collect();
    assert_eq!(found(GustAxis::Vertical, &more), law, "no other load of the vertical axis");
    let lateral = found(GustAxis::Lateral, &more);
    assert!(lateral.contains(&11) && lateral.contains(&3) && !lateral.contains(&5), "{lateral:?}");
    assert_eq!(driving(&|_, _| [0.0; 6], 0, 5, GustAxis::Vertical), Vec::<usize>::new());
}
