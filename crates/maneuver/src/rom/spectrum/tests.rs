//! The grid, the interpolation and the transform against closed forms.

use super::super::driven::parted;
use super::super::tests::small;
use super::*;

#[test]
fn the_grid_is_fine_where_the_first_bending_is_and_finer_without_wind() {
    let (windy, still) = (grid(true), grid(false));
    assert_eq!((windy.len(), still.len()), (61 + 26, 161 + 40 + 65));
    for (grid, steps) in [
        (windy, &[(0.0, 12.0, 0.2), (12.0, 25.0, 0.5)][..]),
        (still, &[(0.0, 8.0, 0.05), (8.0, 12.0, 0.1), (12.0, 25.0, 0.2)]),
    ] {
        assert!(grid[0] == 0.0 && (grid[grid.len() - 1] - 25.0).abs() < 1e-9);
        for pair in grid.windows(2) {
            let middle = 0.5 * (pair[0] + pair[1]);
            let step = steps.iter().find(|(from, to, _)| (*from..*to).contains(&middle)).expect("a step").2;
            assert!((pair[1] - pair[0] - step).abs() < 1e-9, "{pair:?}");
        }
    }
}

/// Outputs by drives from a formula of s.
fn table(outputs: usize, drives: usize, of: impl Fn(c64, usize, usize) -> c64) -> ResponseTable {
    let frequencies_hz = grid(true);
    let at = |f: &f64| Mat::from_fn(outputs, drives, |i, j| of(c64::new(0.0, TAU * f), i, j));
    ResponseTable {
        responses: frequencies_hz.iter().map(at).collect::<Vec<_>>().into(),
        rest: (0..outputs).map(|i| 0.5 + i as f64).collect(),
        rest_s: 5.0,
        frequencies_hz,
    }
}

fn rows(table: &ResponseTable) -> Vec<usize> {
    (0..table.rest.len()).collect()
}

fn at_rest(table: &ResponseTable, samples: usize) -> Vec<Vec<f64>> {
    table.rest.iter().map(|rest| vec![*rest; samples]).collect()
}

/// All outputs, from rest on.
fn flown(table: &ResponseTable, drives: &[(usize, &[f64])], dt: f64) -> Vec<Vec<f64>> {
    let mut outputs = at_rest(table, drives.first().map_or(0, |(_, values)| values.len()));
    table.add_flown(&driven(drives).iter().collect::<Vec<_>>(), dt, &rows(table), &mut outputs);
    outputs
}

fn driven(drives: &[(usize, &[f64])]) -> Vec<Driven> {
    drives.iter().map(|(column, values)| Driven::new(*column, values.to_vec())).collect()
}

#[test]
fn some_outputs_in_any_order_are_added_to_what_is_there() {
    let table = table(3, 2, |s, i, j| c64::from((i + 2 * j) as f64) + s * (0.01 * i as f64));
    let drive: Vec<f64> = (0..100).map(|k| bell(f64::from(k) * 0.01, 0.3, 1.0, 0.5)[0]).collect();
    let all = flown(&table, &[(1, &drive)], 0.01);
    let mut some = vec![vec![7.0; 100], vec![-7.0; 100]];
    table.add_flown(&[&Driven::new(1, drive)], 0.01, &[2, 1], &mut some);
    for (row, level, some) in [(2, 7.0, &some[0]), (1, -7.0, &some[1])] {
        let off = some.iter().zip(&all[row]).map(|(some, all)| some - level - (all - table.rest[row]));
        assert!(off.map(f64::abs).fold(0.0, f64::max) < 1e-12, "{row}");
    }
}

#[test]
fn between_frequencies_the_cubic_through_the_nearest_four_is_taken() {
    let table = table(1, 1, |s, _, _| s);
    for x in [0.0, 0.07, 0.2, 0.33, 5.0, 11.93, 12.0, 12.1, 12.7, 24.1, 24.7, 24.999] {
        let weights = table.weights(x).expect("inside the grid");
        for power in 0..4 {
            let sum: f64 = weights.iter().map(|(k, w)| w * table.frequencies_hz[*k].powi(power)).sum();
            assert!((sum - x.powi(power)).abs() < 1e-9 * x.powi(power).max(1.0), "{x} Hz to the {power}");
        }
        assert!(weights.windows(2).all(|pair| pair[1].0 == pair[0].0 + 1));
        let (second, third) = (table.frequencies_hz[weights[1].0], table.frequencies_hz[weights[2].0]);
        assert!((second <= x && x <= third) || !(0.2..24.5).contains(&x), "{second} {x} {third}");
    }
}

#[test]
fn above_the_grid_responses_fade_within_a_fifth_of_it() {
    let table = table(1, 1, |s, _, _| s);
    let last = table.frequencies_hz.len() - 1;
    for (x, wanted) in [(25.0 + 1e-9, 1.0), (26.25, 0.853_553_390_6), (27.5, 0.5), (28.75, 0.146_446_609_4)] {
        let weights = table.weights(x).expect("where it fades");
        assert_eq!(weights[0].0, last);
        let sum: f64 = weights.iter().map(|(_, w)| w).sum();
        assert!((sum - wanted).abs() < 1e-6, "{x} Hz: {sum}");
    }
    assert!(table.weights(29.99).is_some() && table.weights(30.01).is_none());
}

#[test]
fn two_records_in_one_complex_one_come_apart_into_their_own_spectra() {
    for n in [6_usize, 8] {
        let first: Vec<f64> = (0..n).map(|k| (1.3 * k as f64 + 0.2).sin()).collect();
        let second: Vec<f64> = (0..n).map(|k| (2.1 * (k * k) as f64).cos()).collect();
        let dft = |values: &[c64], bin: usize| -> c64 {
            let turn = |k: usize| -TAU * (bin * k) as f64 / n as f64;
            (0..n).map(|k| values[k] * c64::new(turn(k).cos(), turn(k).sin())).sum()
        };
        let complex = |re: &[f64], im: &[f64]| -> Vec<c64> {
            re.iter().zip(im).map(|(a, b)| c64::new(*a, *b)).collect()
        };
        let zero = vec![0.0; n];
        let together = complex(&first, &second);
        let both: Vec<c64> = (0..n).map(|bin| dft(&together, bin)).collect();
        let found = parted(&both, 2, n / 2 + 1);
        assert_eq!((found.len(), found[0].len(), found[1].len()), (2, n / 2 + 1, n / 2 + 1));
        for (spectrum, values) in found.iter().zip([&first, &second]) {
            let alone = complex(values, &zero);
            for (bin, value) in spectrum.iter().enumerate() {
                assert!((value - dft(&alone, bin)).norm() < 1e-12, "{bin} of {n}");
            }
        }
        let alone = complex(&first, &zero);
        let one: Vec<c64> = (0..n).map(|bin| dft(&alone, bin)).collect();
        assert_eq!(parted(&one, 1, n / 2), [one[..n / 2].to_vec()]);
    }
}

/// A bell from a level, with its derivatives.
fn bell(t: f64, level: f64, height: f64, middle: f64) -> [f64; 3] {
    let (width, x) = (0.06, t - middle);
    let value = height * (-0.5 * (x / width).powi(2)).exp();
    let slope = -x / (width * width);
    [level + value, slope * value, (slope * slope - 1.0 / (width * width)) * value]
}

#[test]
fn what_answers_value_rate_and_acceleration_gives_these_of_every_drive() {
    const COUNT: usize = 200;
    let dt = 0.005;
    let gain = |i: usize, j: usize, d: usize| ((3 * i + 5 * j + 7 * d) as f64).sin() * [1.0, 0.03, 1e-3][d];
    for (outputs, moving) in [(3, 3), (2, 2), (4, 1)] {
        let table =
            table(outputs, 5, |s, i, j| c64::from(gain(i, j, 0)) + s * gain(i, j, 1) + s * s * gain(i, j, 2));
        let places = [(0.3, 1.0, 0.45), (-0.2, 0.7, 0.6), (0.0, -1.4, 0.5)];
        let records: Vec<Vec<[f64; 3]>> = places[..moving]
            .iter()
            .map(|&(level, height, middle)| {
                (0..COUNT).map(|k| bell(k as f64 * dt, level, height, middle)).collect()
            })
            .collect();
        let values: Vec<Vec<f64>> = records.iter().map(|r| r.iter().map(|x| x[0]).collect()).collect();
        let still = vec![0.4; COUNT];
        let mut drives: Vec<(usize, &[f64])> = vec![(4, &still)];
        drives.extend(values.iter().enumerate().map(|(j, v)| (j, v.as_slice())));
        let answer = flown(&table, &drives, dt);
        assert_eq!((answer.len(), answer[0].len()), (outputs, COUNT));
        for (i, answer) in answer.iter().enumerate() {
            for (k, ours) in answer.iter().enumerate() {
                let moved: f64 =
                    (0..moving).map(|j| (0..3).map(|d| gain(i, j, d) * records[j][k][d]).sum::<f64>()).sum();
                let wanted = 0.5 + i as f64 + gain(i, 4, 0) * 0.4 + moved;
                assert!((ours - wanted).abs() < 2e-5, "{i} at {k}: {ours} {wanted}");
            }
        }
        let mut steady = at_rest(&table, COUNT);
        table.add_steady(&driven(&drives).iter().collect::<Vec<_>>(), &rows(&table), &mut steady);
        for (i, steady) in steady.iter().enumerate() {
            let wanted: f64 = drives.iter().map(|(j, v)| gain(i, *j, 0) * v[90]).sum();
            assert!((steady[90] - wanted - 0.5 - i as f64).abs() < 1e-12 && steady.len() == COUNT);
        }
    }
}

#[test]
fn without_drives_there_is_no_history_and_drives_that_rest_leave_the_wing_at_rest() {
    let table = table(3, 2, |s, i, j| c64::from((i + 2 * j) as f64) + s);
    assert_eq!(flown(&table, &[], 0.01), at_rest(&table, 0));
    let answer = flown(&table, &[(1, &[0.2; 5])], 0.01);
    for (i, answer) in answer.iter().enumerate() {
        assert!(
            answer.iter().all(|x| (x - 0.5 - i as f64 - 0.2 * (i + 2) as f64).abs() < 1e-12),
            "{answer:?}"
        );
    }
    let mut steady = at_rest(&table, 2);
    table.add_steady(&[], &rows(&table), &mut steady);
    assert!(steady.iter().enumerate().all(|(i, v)| *v == [0.5 + i as f64; 2]));
}

#[test]
fn a_table_holds_the_model_s_responses_and_waits_longer_without_wind() {
    let change = Change::none(3);
    let constants = Constants { moment_coefficient: 0.1, upwash_rad_m: 0.2 };
    for (v_m_s, rest_s) in [(25.0, 5.0), (0.0, 20.0)] {
        let rom = small(v_m_s);
        for everything in [true, false] {
            let table = ResponseTable::new(&rom, &change, &constants, everything);
            assert_eq!((table.rest_s, &table.frequencies_hz), (rest_s, &grid(v_m_s > 0.0)));
            assert_eq!(table.rest, rom.at_rest(&change, &constants, everything));
            let at =
                |k: usize| rom.responses(&change, &[TAU * table.frequencies_hz[k]], everything).remove(0);
            for k in [0, 1, 40] {
                assert!((&at(k) - &table.responses[k]).norm_max() < 1e-12, "{k}");
            }
        }
    }
}

#[test]
fn a_record_is_long_enough_for_the_wing_to_come_to_rest_behind_it() {
    // a resonance of 2 Hz that dies away in .4 s is gone before the record begins again
    let w = TAU * 2.0;
    let table = table(1, 1, |s, _, _| c64::from(w * w) / (s * s + s * 5.0 + w * w));
    let dt = 0.01;
    let drive: Vec<f64> = (0..60).map(|k| bell(f64::from(k) * dt, 0.0, 1.0, 0.3)[0]).collect();
    let short = flown(&table, &[(0, &drive)], dt);
    let long: Vec<f64> = drive.iter().copied().chain(vec![0.0; 900]).collect();
    let long = flown(&table, &[(0, &long)], dt);
    for k in 0..60 {
        assert!((short[0][k] - long[0][k]).abs() < 1e-3, "{k}");
        assert!(k > 5 || (short[0][k] - 0.5).abs() < 1e-3, "at rest before it moves: {}", short[0][k]);
    }
}
