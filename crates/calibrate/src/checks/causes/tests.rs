//! Evidence of causes: densities are normalised, what theory is off by is what the constants say, and a cause undoes
//! its mistake.

use super::super::lines::LineNoise;
use super::*;
use crate::checks::lines::lines;
use crate::statics::StaticData;
use crate::tests::{RHO, Toy, near, noise};

fn line(slope: f64, at_zero: f64) -> Line {
    Line { slope, at_zero }
}

/// Two airspeeds with lines of theory, measured as theory says.
fn two(channels: [bool; 3]) -> Vec<Lines> {
    let theory = ByLoad { fz: line(100.0, 4.0), mx: line(70.0, 3.0), my: line(-5.0, 0.6) };
    let of = |v_m_s: f64, by: f64| {
        let theory = theory.map(|line| line.times(by, by));
        let noise = ByLoad::from_array([0.3, 0.2, 0.1]).map(|sigma: f64| LineNoise {
            slope: 9.0 * sigma * sigma,
            at_zero: sigma * sigma,
            both: -0.5 * sigma * sigma,
        });
        let channels = ByLoad::from_array(channels);
        Lines { v_m_s, measured: theory, theory, noise, chord_m: 0.4, channels }
    };
    vec![of(10.0, 1.0), of(20.0, 4.0)]
}

#[test]
fn the_logarithm_of_a_mean_is_that_of_the_exponentials_mean() {
    near(log_mean(&[0.0, 3.0_f64.ln()]), 2.0_f64.ln(), 1e-14);
    near(log_mean(&[-2000.0, -2000.0 + 5.0_f64.ln()]), -2000.0 + 3.0_f64.ln(), 1e-14);
    assert_eq!(log_mean(&[f64::NEG_INFINITY; 2]), f64::NEG_INFINITY);
    near(log_mean(&[f64::NEG_INFINITY, 0.0]), 0.5_f64.ln(), 1e-14);
}

/// The density of measured lines as a quadratic: the numbers at which it is largest are theory's with the cause put
/// in, and its height
/// there is that of a Gaussian with its curvature, so that it holds one.
fn curvature(lines: &[Lines], undone: &Undone, scale: f64) -> (f64, Mat<f64>) {
    let loads: Vec<Load> = Load::ALL.into_iter().filter(|&load| lines[0].channels[load]).collect();
    let places: Vec<(usize, Load, bool)> = (0..lines.len())
        .flat_map(|k| loads.iter().flat_map(move |&load| [(k, load, true), (k, load, false)]))
        .collect();
    let n = places.len();
    let at = |moves: &[(usize, f64)]| {
        let mut moved = lines.to_vec();
        for &(i, by) in moves {
            let (k, load, is_slope) = places[i];
            let line = &mut moved[k].measured[load];
            if is_slope { line.slope += by } else { line.at_zero += by }
        }
        log_density(&moved, undone, scale)
    };
    let h = 1.0;
    let largest = at(&[]);
    for i in 0..n {
        let slope = (at(&[(i, h)]) - at(&[(i, -h)])) / (2.0 * h);
        assert!(slope.abs() < 1e-8 * largest.abs().max(1.0), "{i}: {slope}");
    }
    let precision = Mat::from_fn(n, n, |i, j| {
        -(at(&[(i, h), (j, h)]) - at(&[(i, h), (j, -h)]) - at(&[(i, -h), (j, h)]) + at(&[(i, -h), (j, -h)]))
            / (4.0 * h * h)
    });
    (largest, precision)
}

fn inverse(matrix: &Mat<f64>) -> Mat<f64> {
    use faer::linalg::solvers::DenseSolveCore;
    matrix.partial_piv_lu().inverse()
}

/// Lines that a cause makes of theory's: its matrix and shift undone.
fn mistaken_for(lines: &[Lines], undone: &Undone) -> Vec<Lines> {
    let matrix = Mat::from_fn(3, 3, |i, j| undone.matrix[i][j]);
    let back = inverse(&matrix);
    let shift = undone.shift.to_array();
    let one = |at: &Lines| {
        let parts = at.theory.to_array().map(Line::parts);
        let of = |i: usize, part: usize| {
            (0..3)
                .map(|j| back[(i, j)] * (parts[j][part] - if part == 1 { shift[j] } else { 0.0 }))
                .sum::<f64>()
        };
        let measured = ByLoad::from_array([0, 1, 2].map(|i| line(of(i, 0), of(i, 1))));
        Lines { measured, ..at.clone() }
    };
    lines.iter().map(one).collect()
}

fn of_linear(matrix: [[f64; 3]; 3], shift: [f64; 3]) -> Undone {
    Undone { words: String::new(), matrix, shift: RootLoads::from_array(shift) }
}

#[test]
fn the_density_of_lines_is_normalised_whatever_the_cause() {
    let all = [
        of_linear(IDENTITY, [0.0; 3]),
        of_linear(IDENTITY, [2.0, -3.0, 1.0]),
        Undone::scales("", [2.0, 0.5, -3.0]),
        of_linear([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]], [0.0; 3]),
        of_linear([[1.0, 0.0, 0.0], [0.7, 1.0, 0.0], [-0.4, 0.0, 1.0]], [0.0; 3]),
    ];
    let lines = two([true; 3]);
    for undone in &all {
        let (largest, precision) = curvature(&mistaken_for(&lines, undone), undone, 1.0);
        near(largest, 0.5 * precision.determinant().ln(), 1e-5);
    }
    // of two loads only scales have a say
    let two_loads = two([true, false, true]);
    for undone in [&all[0], &all[2]] {
        let (largest, precision) = curvature(&mistaken_for(&two_loads, undone), undone, 3.0);
        near(largest, 0.5 * precision.determinant().ln(), 1e-5);
    }
    near(all[2].determinant(), 3.0, 1e-14);
    near(all[3].determinant(), 1.0, 1e-14);
}

/// In common and each for itself, as the constants of the file say; then noise.
#[test]
fn lines_are_off_theory_by_its_usual_errors_and_noise() {
    let lines = two([true; 3]);
    for scale in [0.5, 3.0] {
        let (_, precision) = curvature(&lines, &of_linear(IDENTITY, [0.0; 3]), scale);
        let covariance = inverse(&precision);
        let square =
            |[common, own]: [f64; 2], same: bool| common * common + if same { own * own } else { 0.0 };
        for k in 0..2 {
            for l in 0..2 {
                let same = k == l;
                let by = [1.0, 4.0][k] * [1.0, 4.0][l] * scale * scale;
                let lift = square([0.08, 0.03], same);
                let y = square([0.06, 0.02], same);
                let x = 0.4 * 0.4 * square([0.04, 0.015], same);
                let zero = square([0.015, 0.015], same);
                let moment = 0.4 * 0.4 * square([0.02, 0.01], same) * (100.0_f64 / 5.0).powi(2);
                // by slopes 100, 70, -5 and loads at zero angle 4, 3, 0.6; an offset acts elsewhere by 0.3 arms and
                // 0.2 chords
                let expected = [
                    [lift * 1e4, lift * 400.0, lift * 16.0 + zero * 1e4],
                    [(lift + y) * 4900.0, (lift + y) * 210.0, (lift + y) * 9.0 + zero * 4900.0 * 1.09],
                    [
                        lift * 25.0 + x * 1e4,
                        -lift * 3.0 + x * 400.0,
                        lift * 0.36 + x * 16.0 + zero * (25.0 + (0.2 * 100.0 * 0.4_f64).powi(2)) + moment,
                    ],
                ];
                for (c, [slope, both, at_zero]) in expected.into_iter().enumerate() {
                    let sigma2 = if same { [0.09, 0.04, 0.01][c] } else { 0.0 };
                    let (i, j) = (6 * k + 2 * c, 6 * l + 2 * c);
                    near(covariance[(i, j)], by * slope + 9.0 * sigma2, 1e-4);
                    near(covariance[(i, j + 1)], by * both - 0.5 * sigma2, 1e-4);
                    near(covariance[(i + 1, j + 1)], by * at_zero + sigma2, 1e-4);
                }
                // lift and bending go together, and so does what zero lift adds to both
                near(covariance[(6 * k, 6 * l + 2)], by * lift * 7000.0, 1e-4);
                near(covariance[(6 * k + 1, 6 * l + 3)], by * (lift * 12.0 + zero * 7000.0), 1e-4);
            }
        }
    }
}

/// What a cause makes of noise: it is that of the loads as they were measured.
#[test]
fn a_cause_leaves_the_noise_with_the_loads_that_were_measured() {
    let quiet: Vec<Lines> = two([true; 3])
        .into_iter()
        .map(|at| Lines {
            noise: at.noise.map(|n| LineNoise {
                slope: 1e-3 * n.slope,
                at_zero: 1e-3 * n.at_zero,
                both: 1e-3 * n.both,
            }),
            ..at
        })
        .collect();
    let undone = of_linear([[1.0, 0.0, 0.0], [0.7, 1.0, 0.0], [-0.4, 0.0, 1.0]], [0.0; 3]);
    let of = |lines: &[Lines]| inverse(&curvature(&mistaken_for(lines, &undone), &undone, 1.0).1);
    let (loud, quiet) = (of(&two([true; 3])), of(&quiet));
    for i in 0..12 {
        for j in 0..12 {
            let sigma2 = [0.09, 0.04, 0.01][(i % 6) / 2];
            let noise = match (i / 2 == j / 2, i % 2, j % 2) {
                (true, 0, 0) => 9.0 * sigma2,
                (true, 1, 1) => sigma2,
                (true, ..) => -0.5 * sigma2,
                _ => 0.0,
            };
            let found = loud[(i, j)] - quiet[(i, j)];
            assert!(
                (found - 0.999 * noise).abs() < 1e-4 * (loud[(i, i)] * loud[(j, j)]).sqrt(),
                "{i} {j}: {found} {noise}"
            );
        }
    }
}

#[test]
fn causes_undo_their_mistakes() {
    let lines = two([true; 3]);
    let all = mistaken(&lines);
    let (foot_m, pound_n) = (0.3048, 4.448_221_615);
    // newtons and metres as they are written by mistake
    let cases: [(&str, [f64; 3]); 10] = [
        ("My_Nm has the other sign", [8.0, 6.0, -3.0]),
        ("Mx_Nm has the other sign", [8.0, -6.0, 3.0]),
        // the column Mx_Nm reads 3 and -3 where the nose is turned up by 3
        ("column Mx_Nm holds the pitching moment My, nose up positive", [8.0, 3.0, 6.0]),
        ("column Mx_Nm holds the pitching moment My, nose down positive", [8.0, -3.0, 6.0]),
        ("lbf ft", [8.0 / pound_n, 6.0 / (pound_n * foot_m), 3.0 / (pound_n * foot_m)]),
        ("lbf in", [8.0 / pound_n, 12.0 * 6.0 / (pound_n * foot_m), 12.0 * 3.0 / (pound_n * foot_m)]),
        ("kgf", [8.0, 6.0, 3.0].map(|load: f64| load / 9.806_65)),
        // a number of knots that is taken for metres a second asks for more load
        ("knots", [8.0, 6.0, 3.0].map(|load: f64| load * (1852.0_f64 / 3600.0).powi(2))),
        ("ft/s", [8.0, 6.0, 3.0].map(|load: f64| load * foot_m * foot_m)),
        ("mph", [8.0, 6.0, 3.0].map(|load: f64| load * (1609.344_f64 / 3600.0).powi(2))),
    ];
    assert_eq!(all.len(), cases.len());
    for (cause, (words, wrong)) in all.iter().zip(cases) {
        let [one] = &cause[..] else { panic!("one value") };
        assert!(one.words.contains(words), "{} {words}", one.words);
        for (row, right) in one.matrix.iter().zip([8.0, 6.0, 3.0]) {
            near((0..3).map(|j| row[j] * wrong[j]).sum(), right, 1e-5);
        }
        assert_eq!(one.shift, RootLoads::default());
    }
    // what takes a load that is not there is not asked
    assert_eq!(
        [[true, true, false], [true, false, true]].map(|channels| mistaken(&two(channels)).len()),
        [7, 7]
    );
}

/// The arm of the lift at the highest airspeed is 0.7 m.
#[test]
fn other_places_move_the_moments_by_the_force_and_other_spans_scale_them() {
    let all = places(&two([true; 3]));
    assert_eq!(all.iter().map(Vec::len).collect::<Vec<_>>(), [14, 14, 10]);
    near(arm_m(&two([true; 3])[1]), 0.7, 1e-14);
    let of = |one: &Undone| one.matrix.map(|row| row[0] * 10.0 + row[1] * 6.0 + row[2] * 3.0);
    for (along, across) in all[0].iter().zip(&all[1]) {
        let [fz, mx, my] = of(along);
        assert_eq!((fz, mx), (10.0, 6.0));
        // My = -(x - dx) Fz about a point dx aft of the balance
        let aft = if along.words.contains("aft of") { 1.0 } else { -1.0 };
        let dx_m: f64 = along.words.split(' ').find_map(|word| word.parse().ok()).expect("a length");
        assert!((my - (3.0 - aft * dx_m * 10.0)).abs() < 0.051, "{} {my}", along.words);
        let [fz, mx, my] = of(across);
        assert_eq!((fz, my), (10.0, 3.0));
        let out = if across.words.contains("outboard") { 1.0 } else { -1.0 };
        let dy_m: f64 = across.words.split(' ').find_map(|word| word.parse().ok()).expect("a length");
        assert!((mx - (6.0 + out * dy_m * 10.0)).abs() < 0.051, "{} {mx}", across.words);
    }
    let [fz, mx, my] = of(&all[0][13]);
    near(my, 3.0 - 7.0, 1e-12);
    assert_eq!((fz, mx), (10.0, 6.0));
    for (spanned, span) in all[2].iter().zip(SPANS) {
        let [fz, mx, my] = of(spanned);
        assert!(spanned.words.contains(&format!("{span:.2} times")));
        near(fz * span, 10.0, 1e-12);
        near(mx * span * span, 6.0, 1e-12);
        near(my * span, 3.0, 1e-12);
    }
    assert_eq!(
        [[true, false, true], [true, true, false], [false, true, true]].map(|c| places(&two(c)).len()),
        [1, 2, 0]
    );
}

#[test]
fn the_weight_is_half_of_what_turning_over_takes() {
    let mut toy = Toy::new(2, 2);
    toy.weight_n = 30.0;
    let campaign = toy.measured(&[10.0], &[0.0, 0.1, 0.2], &toy.uniform(1.0));
    let found = weight(&toy, &campaign).expect("it is linear");
    [found.fz_n, found.mx_nm, found.my_nm]
        .iter()
        .zip([-30.0, -30.0, -3.0])
        .for_each(|(a, b)| near(*a, b, 1e-12));
}

/// Findings of a wing whose measured loads are changed by hand.
fn found(change: impl Fn([f64; 3]) -> [f64; 3], wind_off: bool) -> Vec<Finding> {
    let mut toy = Toy::new(4, 2);
    (toy.weight_n, toy.camber_rad) = (20.0, 0.03);
    let mut campaign = toy.measured(&[15.0, 20.0, 25.0], &[-0.06, 0.0, 0.06, 0.1], &toy.uniform(0.97));
    campaign.noise = Some(noise([0.05, 0.03, 0.02, 0.0]));
    for point in &mut campaign.points {
        point.loads = change(point.loads.map(|load| load.expect("it is measured"))).map(Some);
    }
    if wind_off {
        campaign.points.push(crate::tests::point(99, 0.0, 0.0, [0.0; 4]));
    }
    let data = StaticData::from_campaign(&campaign).expect("it is sound");
    find(&toy, &campaign, &lines(&toy, RHO, &data).expect("it is linear")).expect("it is linear")
}

#[test]
fn the_cause_that_explains_the_lines_is_named_and_no_other() {
    assert_eq!(found(|loads| loads, false), []);
    let named = |change: fn([f64; 3]) -> [f64; 3], wind_off: bool| {
        let found = found(change, wind_off);
        assert_eq!(found.len(), 1, "{found:?}");
        found[0].sentence.clone()
    };
    let sign = named(|[fz, mx, my]| [fz, -mx, my], true);
    assert!(sign.contains("as they are: Mx_Nm has the other sign") && !sign.contains(", or "), "{sign}");
    let swapped = named(|[fz, mx, my]| [fz, my, mx], true);
    assert!(
        swapped.contains("Mx_Nm and My_Nm are swapped") && !swapped.contains("times the span"),
        "{swapped}"
    );
    let knots = named(|loads| loads.map(|load| load * 0.514_444_f64.powi(2)), true);
    assert!(knots.contains("knots"), "{knots}");
    let untared = |[fz, mx, my]: [f64; 3]| [fz - 20.0, mx - 20.0, my - 2.0];
    let weight = named(untared, false);
    assert!(weight.contains("the wing's weight (20.0 N, 20.0 N m, 2.0 N m) is not tared"), "{weight}");
    // rows with wind off would show it
    assert!(found(untared, true).iter().all(|one| !one.sentence.contains("tared")));
}

#[test]
fn one_load_alone_has_no_cause() {
    let toy = Toy::new(4, 2);
    let mut campaign = toy.measured(&[15.0], &[-0.06, 0.0, 0.06, 0.1], &toy.uniform(5.0));
    let of = |channels: [bool; 3], campaign: &mut Campaign| {
        campaign.channels = channels;
        let data = StaticData::from_campaign(campaign).expect("it is sound");
        find(&toy, campaign, &lines(&toy, RHO, &data).expect("it is linear")).expect("it is linear").len()
    };
    assert_eq!(of([true, false, false], &mut campaign), 0);
    assert_eq!(of([true, true, false], &mut campaign), 1);
    assert_eq!(find(&toy, &campaign, &[]).expect("nothing to do"), []);
}
