//! Laws of box loads and corrections: P = q W S Q w + q S f_e (paper 1, Eq. 7) in every form that flies, and in two and in six
//! components per box.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use aero::{BoxLoads, Corrections, Integration, Lattice};
use faer::{Mat, c64};
use nalgebra::{Point3, Vector3};
use nastran::Dmi;

const Q_PA: f64 = 708.0;

/// Boxes of all sorts: flat, with dihedral, given from tip to root, and upright.
fn mixed() -> Lattice {
    let flat = Lattice::trapezoid(1, [0.0, 0.0, 0.0], 0.3, [0.3, 1.0, 0.0], 0.2, [3, 4]).unwrap();
    let dihedral = Lattice::trapezoid(101, [0.3, 1.0, 0.0], 0.2, [0.6, 1.8, 0.4], 0.1, [3, 4]).unwrap();
    let inwards = Lattice::trapezoid(201, [0.2, -0.8, 0.1], 0.1, [0.0, 0.0, 0.0], 0.3, [2, 3]).unwrap();
    let fin = Lattice::trapezoid(301, [1.5, 0.0, 0.1], 0.3, [1.7, 0.0, 0.6], 0.2, [2, 3]).unwrap();
    flat.joined(&dihedral).unwrap().joined(&inwards).unwrap().joined(&fin).unwrap()
}

/// Some numbers around `mean`, different for each `seed`.
fn varied(n: usize, mean: f64, seed: f64) -> Vec<f64> {
    (0..n).map(|i| mean + 0.4 * (seed + 1.7 * i as f64).sin()).collect()
}

fn some(n: usize) -> Corrections {
    Corrections {
        force: varied(n, 1.0, 1.0),
        moment: varied(n, 1.0, 2.0),
        pressure_offset: varied(n, 0.0, 3.0),
    }
}

#[test]
fn neutral_corrections_leave_loads_as_they_are_to_the_last_bit() {
    let lattice = mixed();
    let s = Integration::new(&lattice);
    let cp = varied(lattice.len(), 0.5, 0.0);
    let loads = s.corrected(&Corrections::neutral(lattice.len())).box_loads(Q_PA, &cp);
    for (j, pair) in loads.values.chunks(2).enumerate() {
        let lift = Q_PA * s.area(j) * cp[j];
        assert_eq!(pair, [lift, lift * s.moment_arm(j)]);
    }
    assert!(Corrections::neutral(5).is_neutral() && !some(5).is_neutral());
}

#[test]
fn loads_are_affine_in_pressures_factors_and_offsets() {
    let lattice = mixed();
    let n = lattice.len();
    let s = Integration::new(&lattice);
    let (cp_a, cp_b, c) = (varied(n, 0.5, 0.0), varied(n, 0.1, 9.0), some(n));
    let middle: Vec<f64> = cp_a.iter().zip(&cp_b).map(|(a, b)| 0.3 * a + 0.7 * b).collect();
    let of = |cp: &[f64]| s.corrected(&c).box_loads(Q_PA, cp).values;
    for (got, (a, b)) in of(&middle).iter().zip(of(&cp_a).iter().zip(of(&cp_b))) {
        assert!((got - (0.3 * a + 0.7 * b)).abs() < 1e-11 * (1.0 + a.abs() + b.abs()));
    }
}

#[test]
fn factors_never_multiply_the_offset() {
    let lattice = mixed();
    let n = lattice.len();
    let s = Integration::new(&lattice);
    let offset = varied(n, 0.0, 3.0);
    let with = |factor: f64, cp: f64| {
        let c =
            Corrections { force: vec![factor; n], moment: vec![factor; n], pressure_offset: offset.clone() };
        s.corrected(&c).box_loads(Q_PA, &vec![cp; n]).values
    };
    // Without pressures the factors have nothing to act on.
    assert_eq!(with(0.5, 0.0), with(1.7, 0.0));
    // Doubling the factors adds the theoretical load once more, and no offset.
    let neutral = s.corrected(&Corrections::neutral(n)).box_loads(Q_PA, &vec![0.8; n]).values;
    for ((double, single), theory) in with(2.0, 0.8).iter().zip(with(1.0, 0.8)).zip(neutral) {
        assert!((double - single - theory).abs() < 1e-10 * theory.abs());
    }
}

/// Numbers that differ from row to row and column to column.
fn matrix(rows: usize, columns: usize, seed: f64) -> Mat<f64> {
    Mat::from_fn(rows, columns, |i, j| (seed + 1.3 * i as f64 + 0.7 * j as f64).sin())
}

fn assert_close(got: &Mat<f64>, wanted: &Mat<f64>) {
    assert_eq!((got.nrows(), got.ncols()), (wanted.nrows(), wanted.ncols()));
    let largest = wanted.norm_max();
    assert!(largest > 0.0 && (got - wanted).norm_max() < 1e-13 * largest);
}

/// Box by box as the equation is written, with the areas and chords of the lattice.
fn by_hand(lattice: &Lattice, c: &Corrections, cp: &[f64], offset: f64) -> Vec<f64> {
    let one = |(j, panel): (usize, &aero::AeroBox)| {
        let of = |factor: f64| Q_PA * panel.area_m2() * (factor * cp[j] + offset * c.pressure_offset[j]);
        [of(c.force[j]), of(c.moment[j]) * panel.chord_m() / 4.0]
    };
    lattice.boxes.iter().enumerate().flat_map(one).collect()
}

#[test]
fn dense_columns_and_the_offset_are_the_two_parts_of_the_equation() {
    let lattice = mixed();
    let (n, s, c) = (lattice.len(), Integration::new(&lattice), some(lattice.len()));
    let cp = matrix(n, 3, 0.2);
    let mut loads = s.corrected(&c).of_pressures(Q_PA, cp.as_ref());
    s.corrected(&c).add_offset(Q_PA, &mut loads, 1);
    let wanted: [Vec<f64>; 3] = std::array::from_fn(|column| {
        by_hand(&lattice, &c, cp.col_as_slice(column), f64::from(u8::from(column == 1)))
    });
    assert_close(&loads, &Mat::from_fn(2 * n, 3, |k, column| wanted[column][k]));
    let one_case = s.corrected(&c).box_loads(Q_PA, cp.col_as_slice(1)).values;
    assert_eq!(loads.col_as_slice(1), one_case);
}

#[test]
fn rows_weigh_the_same_loads() {
    let lattice = mixed();
    let (n, s, c) = (lattice.len(), Integration::new(&lattice), some(lattice.len()));
    let (rows, cp) = (matrix(4, 2 * n, 0.6), matrix(n, 3, 0.2));
    let loads = s.corrected(&c);
    let dense = &rows * loads.of_pressures(Q_PA, cp.as_ref());
    assert_close(&(loads.rows_by_pressure(rows.as_ref()) * &cp * faer::Scale(Q_PA)), &dense);
    assert_close(&(loads.weighed(rows.as_ref(), cp.as_ref()) * faer::Scale(Q_PA)), &dense);
    let offset = loads.offset_weighed(rows.as_ref());
    let at_rest = Mat::from_fn(2 * n, 1, |k, _| loads.box_loads(Q_PA, &vec![0.0; n]).values[k]);
    assert_close(&Mat::from_fn(4, 1, |i, _| Q_PA * offset[i]), &(&rows * at_rest));
    let neutral = Corrections::neutral(n);
    assert_eq!(s.rows_by_pressure(rows.as_ref()), s.corrected(&neutral).rows_by_pressure(rows.as_ref()));
}

#[test]
fn complex_pressures_load_as_their_real_and_imaginary_parts() {
    let lattice = mixed();
    let (n, s, c) = (lattice.len(), Integration::new(&lattice), some(lattice.len()));
    let (rows, re, im) = (matrix(4, 2 * n, 0.6), matrix(n, 3, 0.2), matrix(n, 3, 1.1));
    let cp = Mat::from_fn(n, 3, |j, column| c64::new(re[(j, column)], im[(j, column)]));
    let loads = s.corrected(&c);
    let joined = |re: Mat<f64>, im: Mat<f64>| {
        Mat::from_fn(re.nrows(), re.ncols(), |i, j| c64::new(re[(i, j)], im[(i, j)]))
    };
    let dense = |cp: &Mat<f64>| loads.of_pressures(Q_PA, cp.as_ref());
    assert_eq!(loads.of_pressures(Q_PA, cp.as_ref()), joined(dense(&re), dense(&im)));
    let weighed = |cp: &Mat<f64>| loads.weighed(rows.as_ref(), cp.as_ref());
    assert_eq!(loads.weighed(rows.as_ref(), cp.as_ref()), joined(weighed(&re), weighed(&im)));
}

/// Loads are linear in each correction at given pressures: a step of any length gives the derivative.
#[test]
fn derivatives_are_differences_of_loads() {
    type Family = fn(&mut Corrections) -> &mut Vec<f64>;
    let lattice = mixed();
    let (n, s, c) = (lattice.len(), Integration::new(&lattice), some(lattice.len()));
    let (rows, cp, boxes) = (matrix(4, 2 * n, 0.6), varied(n, 0.5, 0.0), [0, 5, 13, 20]);
    let by = s.corrected(&c).derivatives(Q_PA, rows.as_ref(), &cp, &boxes);
    let loads = |c: &Corrections| {
        let loads = s.corrected(c).box_loads(Q_PA, &cp).values;
        &rows * Mat::from_fn(2 * n, 1, |k, _| loads[k])
    };
    let families: [(&Mat<f64>, Family); 3] = [
        (&by.by_force, |c| &mut c.force),
        (&by.by_moment, |c| &mut c.moment),
        (&by.by_offset, |c| &mut c.pressure_offset),
    ];
    for (got, family) in families {
        let difference = |b: usize| {
            let mut moved = c.clone();
            family(&mut moved)[boxes[b]] += 1.0;
            loads(&moved) - loads(&c)
        };
        let columns: Vec<Mat<f64>> = (0..boxes.len()).map(difference).collect();
        let wanted = Mat::from_fn(4, boxes.len(), |i, b| columns[b][(i, 0)]);
        assert!((got - &wanted).norm_max() < 1e-11 * loads(&c).norm_max());
    }
}

#[test]
fn padding_gives_a_fairing_neutral_corrections() {
    let wing = some(4);
    let all = wing.padded(7, &[3, 4, 5, 6]);
    assert_eq!(all.len(), 7);
    assert_eq!(all.force[..3], [1.0; 3]);
    assert_eq!(all.moment[..3], [1.0; 3]);
    assert_eq!(all.pressure_offset[..3], [0.0; 3]);
    assert_eq!((&all.force[3..], &all.moment[3..]), (&wing.force[..], &wing.moment[..]));
    assert_eq!(all.pressure_offset[3..], wing.pressure_offset[..]);
}

/// 56 strips of 12 boxes and 3 of a fairing: 708 rows of FA2J, 1416 of WKK, force and moment alternating.
#[test]
fn matrices_for_nastran_have_one_and_two_rows_per_box_and_come_back() {
    let places: Vec<usize> = (36..708).collect();
    let all = some(672).padded(708, &places);
    let (wkk, fa2j) = (all.wkk(), all.fa2j());
    assert_eq!((wkk.form, wkk.rows, wkk.columns.len(), wkk.columns[0].len()), (3, 1416, 1, 1416));
    assert_eq!((fa2j.form, fa2j.rows, fa2j.columns[0].len()), (2, 708, 708));
    assert_eq!(wkk.columns[0][72..74], [all.force[36], all.moment[36]]);
    assert_eq!(Corrections::from_dmi(&wkk, &fa2j).unwrap(), all);
    let mut full = Dmi { columns: vec![vec![0.0; 1416]; 1416], form: 1, ..wkk.clone() };
    for (i, factor) in wkk.columns[0].iter().enumerate() {
        full.columns[i][i] = *factor;
    }
    assert_eq!(Corrections::from_dmi(&full, &fa2j).unwrap(), all);
    full.columns[3][4] = 0.1;
    assert!(Corrections::from_dmi(&full, &fa2j).unwrap_err().message.contains("not diagonal"));
    assert!(
        Corrections::from_dmi(&wkk, &some(3).fa2j())
            .unwrap_err()
            .message
            .contains("two and one for each box")
    );
}

#[test]
fn six_factors_are_placed_by_the_normal() {
    let lattice = mixed();
    let n = lattice.len();
    let six = Corrections { force: vec![2.0; n], moment: vec![3.0; n], ..Corrections::neutral(n) }
        .six_dof(&lattice);
    let at = |id: u32| six[lattice.index_of(id).unwrap()];
    assert_eq!(at(1), [1.0, 1.0, 2.0, 1.0, 3.0, 1.0]);
    assert_eq!(at(101), [1.0, 2.0, 2.0, 1.0, 3.0, 3.0]);
    assert_eq!(at(301), [1.0, 2.0, 1.0, 1.0, 1.0, 3.0]);
}

/// Loads as vectors of six components, corrected by six factors, summed as a program with six components would.
#[test]
fn six_components_per_box_agree_with_two() {
    let lattice = mixed();
    let n = lattice.len();
    let (s, c, cp) = (Integration::new(&lattice), some(n), varied(n, 0.5, 0.0));
    let about = Point3::new(0.075, 0.0, 0.0);
    let (force, moment) = s.corrected(&c).box_loads(Q_PA, &cp).resultant(&lattice, 0..lattice.len(), &about);
    let factors = c.six_dof(&lattice);
    let (mut sum_f, mut sum_m) = (Vector3::zeros(), Vector3::zeros());
    for (j, panel) in lattice.boxes.iter().enumerate() {
        let arm = panel.quarter_point() - panel.mid_point();
        let theory = panel.normal() * (Q_PA * panel.area_m2() * cp[j]);
        let offset = panel.normal() * (Q_PA * panel.area_m2() * c.pressure_offset[j]);
        let at_middle = arm.cross(&theory);
        let f = Vector3::from_fn(|axis, _| factors[j][axis] * theory[axis]) + offset;
        let m = Vector3::from_fn(|axis, _| factors[j][3 + axis] * at_middle[axis]) + arm.cross(&offset);
        sum_f += f;
        sum_m += m + (panel.mid_point() - about).cross(&f);
    }
    assert!((sum_f - force).norm() < 1e-12 * force.norm());
    assert!((sum_m - moment).norm() < 1e-12 * moment.norm());
}

#[test]
fn lift_ahead_of_the_point_is_a_nose_up_moment() {
    let lattice = Lattice::trapezoid(1, [0.0, 0.0, 0.0], 1.0, [0.0, 1.0, 0.0], 1.0, [1, 1]).unwrap();
    let loads = Integration::new(&lattice).corrected(&Corrections::neutral(1)).box_loads(1.0, &[1.0]);
    assert_eq!(loads, BoxLoads { values: vec![1.0, 0.25] });
    let (force, moment) = loads.resultant(&lattice, 0..lattice.len(), &Point3::new(1.0, 0.0, 0.0));
    assert_eq!(force, Vector3::new(0.0, 0.0, 1.0));
    // 0.75 m ahead of the point and 0.5 m to the right: My = -x Fz, Mx = y Fz
    assert_eq!(moment, Vector3::new(0.5, 0.75, 0.0));
}

#[test]
fn loads_and_corrections_are_counted_by_boxes() {
    let lattice = mixed();
    let (n, s) = (lattice.len(), Integration::new(&lattice));
    let loads = s.corrected(&some(n)).box_loads(Q_PA, &varied(n, 0.5, 0.0));
    assert_eq!((s.len(), loads.len(), loads.values.len(), some(n).len()), (n, n, 2 * n, n));
    assert!(!s.is_empty() && !loads.is_empty() && !some(n).is_empty());
    for (j, panel) in lattice.boxes.iter().enumerate() {
        assert_eq!((s.area(j), s.moment_arm(j)), (panel.area_m2(), panel.chord_m() / 4.0));
        let (force, moment) = loads.vector(&lattice, j);
        assert!((force - panel.normal() * loads.values[2 * j]).norm() < 1e-12);
        assert!((moment - panel.pitch_axis() * loads.values[2 * j + 1]).norm() < 1e-12);
    }
    let none = Integration::new(&Lattice::default());
    assert_eq!(none.len(), 0);
    assert!(none.is_empty() && Corrections::neutral(0).is_empty());
    assert!(BoxLoads { values: vec![] }.is_empty());
}

#[test]
fn matrices_that_are_no_corrections_are_refused() {
    let all = some(2);
    let (wkk, fa2j) = (all.wkk(), all.fa2j());
    let message = |wkk: &Dmi, fa2j: &Dmi| Corrections::from_dmi(wkk, fa2j).unwrap_err().message;
    let with = |matrix: &Dmi, columns: Vec<Vec<f64>>| Dmi { columns, ..matrix.clone() };
    let column = &fa2j.columns[0];
    assert!(message(&wkk, &with(&fa2j, vec![column.clone(); 2])).contains("2 columns, expected one"));
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(message(&wkk, &with(&fa2j, vec![vec![0.1, bad]])).contains("not finite"));
        assert!(message(&with(&wkk, vec![vec![1.0, 1.0, bad, 1.0]]), &fa2j).contains("not finite"));
    }
    // Four rows and three columns, each with its entry on the diagonal, are not square.
    let unit = |i: usize| (0..4).map(|row| f64::from(u8::from(row == i))).collect::<Vec<_>>();
    assert!(message(&with(&wkk, (0..3).map(unit).collect()), &fa2j).contains("not diagonal"));
    let full = Corrections::from_dmi(&with(&wkk, (0..4).map(unit).collect()), &fa2j).unwrap();
    assert_eq!((full.force, full.moment), (vec![1.0; 2], vec![1.0; 2]));
    assert!(message(&with(&wkk, vec![vec![1.0; 3]]), &fa2j).contains("two and one for each box"));
}
