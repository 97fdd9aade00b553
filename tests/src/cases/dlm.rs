//! The doublet lattice beside published and independently computed wings (data/published/dlm__*.json), each at the
//! tolerance its case states.

use super::flutter_decks::NASTRAN;
use crate::half_wing::WALL;
use crate::registry::Case;
use crate::row::{Row, worst};
use crate::{list, number, numbers};
use aero::{DlmSettings, DoubletLattice, KernelIntegral, Lattice, SpanFit};
use faer::{Mat, MatRef, c64};
use serde_json::Value;

/// The cases of this file.
pub const CASES: &[Case] = &[
    Case { file: "dlm__dlm_aic_rect_ar4_sym", run: matrices },
    Case { file: "dlm__dlm_aic_swept_taper_dihedral_sym", run: matrices },
    Case { file: "dlm__dlm_gaf_subsonic", run: generalised },
    Case { file: "dlm__dlm_vanzyl_AR20_pitch", run: pitching },
];

/// As PanelAero computes with its quartic fit.
pub const QUARTIC: DlmSettings = DlmSettings { integral: KernelIntegral::Desmarais, fit: SpanFit::Quartic };

fn complex(value: &Value) -> c64 {
    let parts = numbers(value);
    c64::new(parts[0], parts[1])
}

/// A count of a case.
fn whole(value: &Value) -> u32 {
    value.as_u64().and_then(|count| u32::try_from(count).ok()).expect("a count")
}

/// By how much a number misses a printed one of six digits, beyond half of the last digit.
fn miss(got: f64, want: f64) -> f64 {
    let half_a_unit = if want == 0.0 { 0.0 } else { 0.501 * 10_f64.powf(want.abs().log10().floor() - 5.0) };
    ((got - want).abs() - half_a_unit).max(0.0)
}

/// Largest error of a matrix relative to the largest entry of the printed one, printing aside.
fn off(got: MatRef<'_, c64>, want: &Value) -> f64 {
    let want: Vec<Vec<c64>> = list(want).iter().map(|row| list(row).iter().map(complex).collect()).collect();
    assert_eq!((got.nrows(), got.ncols()), (want.len(), want[0].len()));
    let size = want.iter().flatten().map(|v| v.norm()).fold(0.0, f64::max);
    let error = |(i, row): (usize, &Vec<c64>)| {
        row.iter()
            .enumerate()
            .map(|(j, v)| miss(got[(i, j)].re, v.re).hypot(miss(got[(i, j)].im, v.im)))
            .fold(0.0, f64::max)
    };
    want.iter().enumerate().map(error).fold(0.0, f64::max) / size
}

/// The matrices of a case at each Mach number and frequency: 5e-6 of the largest entry for parabolic fits, 1e-6 for
/// quartic ones, as the case states.
fn matrices(case: &Value) -> Vec<Row> {
    let panel = &case["inputs"]["caero1"][0];
    let point = |key: &str| -> [f64; 3] { numbers(&panel[key]).try_into().expect("three coordinates") };
    let count = |key: &str| whole(&panel[key]);
    let (c1, c4) = (number(&panel["c1"]), number(&panel["c4"]));
    let divisions = [count("nchord"), count("nspan")];
    let lattice = Lattice::trapezoid(101, point("p1"), c1, point("p4"), c4, divisions).expect("a panel");
    let mut errors = [Vec::new(), Vec::new(), Vec::new()];
    for row in list(&case["expected"]) {
        let (mach, k) = (number(&row["mach"]), number(&row["k"]));
        let at = |settings: &DlmSettings| {
            // The reference length of the case is 1 m.
            let doublets = DoubletLattice::new(&lattice, WALL, mach, settings).expect("a half wing");
            doublets.influence(2.0 * k).expect("a frequency")
        };
        let (parabolic, quartic) = (at(&NASTRAN), at(&QUARTIC));
        let each =
            [(&parabolic, "A", 5e-6), (&parabolic, "pa_parabolic", 5e-6), (&quartic, "pa_quartic", 1e-6)];
        for (list, (matrix, key, tolerance)) in errors.iter_mut().zip(each) {
            let what = format!("Mach {mach}, k = {k}");
            list.push(Row::absolute(what, off(matrix.as_ref(), &row[key]), 0.0, tolerance));
        }
    }
    let names =
        ["parabolic fit beside NASTRAN-95", "parabolic fit beside PanelAero", "quartic fit beside PanelAero"];
    names
        .into_iter()
        .zip(errors)
        .map(|(name, rows)| worst(&format!("error of the matrix, {name}"), rows))
        .collect()
}

/// A rectangle's half beside the wall.
///
/// # Panics
/// If it has no area.
pub fn rectangle(aspect_ratio: f64, c: f64, divisions: [u32; 2]) -> Lattice {
    Lattice::trapezoid(1, [0.0; 3], c, [0.0, aspect_ratio * c / 2.0, 0.0], c, divisions).expect("a rectangle")
}

/// Lift and moment about mid-chord of a rectangle of chord `c`, over area and chord, in heave (upwards, one chord) and in
/// pitch (nose up about mid-chord) at reduced frequency `k`.
///
/// # Panics
/// If the lattice cannot be solved.
pub fn heave_and_pitch(lattice: &Lattice, c: f64, mach: f64, k: f64, settings: DlmSettings) -> [[c64; 2]; 2] {
    let w = Mat::from_fn(lattice.len(), 2, |i, column| match column {
        0 => c64::new(0.0, -2.0 * k),
        _ => c64::new(1.0, 2.0 * k * (lattice.boxes[i].three_quarter_point().x / c - 0.5)),
    });
    let doublets = DoubletLattice::new(lattice, WALL, mach, &settings).expect("a half wing");
    let cp = doublets.at(2.0 * k / c).expect("a frequency").pressures(w.as_ref());
    let area: f64 = lattice.boxes.iter().map(aero::AeroBox::area_m2).sum();
    [0, 1].map(|column| {
        lattice.boxes.iter().enumerate().fold([c64::default(); 2], |[lift, moment], (i, panel)| {
            let force = cp[(i, column)] * panel.area_m2() / area;
            [lift + force, moment + force * ((c / 2.0 - panel.quarter_point().x) / c)]
        })
    })
}

/// Relative error of the lift in heave and pitch and of the moment in both, for a row of the case.
fn gaf_errors(row: &Value, settings: DlmSettings) -> [f64; 4] {
    let get = |key: &str| number(&row[key]);
    let lattice = rectangle(get("AR"), 1.0, [whole(&row["nchord"]), whole(&row["nspan_half"])]);
    let got = heave_and_pitch(&lattice, 1.0, get("mach"), get("k"), settings);
    [("CL_heave", 0, 0), ("CL_pitch", 1, 0), ("CM_heave", 0, 1), ("CM_pitch", 1, 1)].map(
        |(name, motion, kind)| {
            let want = complex(&row[name]);
            (got[motion][kind] - want).norm() / want.norm()
        },
    )
}

const SINGLE: &str =
    "the case's program computes in single precision; PanelAero gives our numbers to twelve digits";

/// Aspect ratio, Mach number, per cent between the quartic fit and the case's parabolic one at k = 2: lift in heave and
/// pitch. Boxes there are up to three times as wide as long, beyond what parabolas are for.
const FITS: [(f64, f64, [f64; 2]); 6] = [
    (2.0, 0.0, [3.5, 3.0]),
    (2.0, 0.5, [4.0, 3.7]),
    (6.0, 0.0, [5.4, 4.2]),
    (6.0, 0.5, [3.1, 1.6]),
    (20.0, 0.0, [7.8, 3.7]),
    (20.0, 0.5, [3.3, 8.9]),
];

/// 1e-5 for the parabolic fit, but for three rows at k = 2. The case expects the quartic fit 1 to 3 % away at k = 2: it is
/// up to 3 % away up to k = 0.2, and at k = 2 by what is listed.
fn generalised(case: &Value) -> Vec<Row> {
    let single = [(6.0, 0.5, 2.0), (20.0, 0.0, 2.0), (20.0, 0.5, 2.0)];
    let [mut parabolic, mut known, mut slow] = [Vec::new(), Vec::new(), Vec::new()];
    let mut rows = Vec::new();
    for row in list(&case["expected"]) {
        let (ratio, mach, k) = (number(&row["AR"]), number(&row["mach"]), number(&row["k"]));
        let what = format!("aspect ratio {ratio}, Mach {mach}, k = {k}");
        let error = gaf_errors(row, NASTRAN).into_iter().fold(0.0, f64::max);
        let entry = Row::absolute(what.clone(), error, 0.0, 1e-5);
        if single.contains(&(ratio, mach, k)) {
            known.push(entry.known(1e-5, 1.6e-5, SINGLE));
        } else {
            parabolic.push(entry);
        }
        let quartic = gaf_errors(row, QUARTIC);
        if k <= 0.2 {
            slow.push(Row::absolute(what.clone(), quartic.into_iter().fold(0.0, f64::max), 0.0, 0.03));
        }
        if let (true, Some((_, _, known))) =
            (k == 2.0, FITS.iter().find(|fit| (fit.0, fit.1) == (ratio, mach)))
        {
            for (motion, (off, known)) in ["heave", "pitch"].iter().zip(quartic.into_iter().zip(known)) {
                let row = Row::absolute(format!("{what}: lift in {motion}, quartic fit"), off, 0.0, 0.03);
                let (low, high) = ((known - 0.1) / 100.0, (known + 0.1) / 100.0);
                let reason = "boxes wider than long: the quartic fit is nearer to short ones than the case's parabolic";
                rows.push(if off <= 0.03 { row } else { row.known(low, high, reason) });
            }
        }
    }
    assert_eq!(rows.len(), 2 * FITS.len(), "every aspect ratio and Mach number has a row at k = 2");
    let mut all = vec![
        worst("error of lift and moment, parabolic fit", parabolic),
        worst("error of lift and moment, parabolic fit, single precision", known),
        worst("difference of the quartic fit up to k = 0.2", slow),
    ];
    all.extend(rows);
    all
}

/// The parabolic fit meets 1e-5 but for two frequencies, 2.4e-5 and 1.3e-5 off (PanelAero: 1.6240076644634915 +
/// 13.988346828692324i at kr = 8); the quartic one van Zyl's printed digits.
fn pitching(case: &Value) -> Vec<Row> {
    let lattice = rectangle(20.0, 0.5, [10, 40]);
    // kr = omega c/V is twice the reduced frequency
    let lift = |kr: f64, settings: DlmSettings| heave_and_pitch(&lattice, 0.5, 0.0, kr / 2.0, settings)[1][0];
    let (rel, abs) = (number(&case["tolerance"]["parabolic"]), number(&case["tolerance"]["quartic_abs"]));
    let single = [(8.0, 2.43e-5), (9.0, 1.28e-5)];
    let [mut parabolic, mut known, mut quartic] = [Vec::new(), Vec::new(), Vec::new()];
    for row in list(&case["expected"]["nastran95_parabolic"]) {
        let row = numbers(row);
        let want = c64::new(row[1], row[2]);
        let error = (lift(row[0], NASTRAN) - want).norm() / want.norm();
        let name = format!("error of the lift, parabolic fit, kr = {}", row[0]);
        let entry = Row::absolute(name, error, 0.0, rel);
        match single.iter().find(|(kr, _)| *kr == row[0]) {
            None => parabolic.push(entry),
            Some((_, off)) => known.push(entry.known(off - 5e-7, off + 5e-7, SINGLE)),
        }
    }
    for row in list(&case["expected"]["quartic_van_zyl_kr_re_im"]) {
        let row = numbers(row);
        let got = lift(row[0], QUARTIC);
        for (part, ours, want) in [("real", got.re, row[1]), ("imaginary", got.im, row[2])] {
            quartic.push(Row::absolute(format!("{part} part at kr = {}", row[0]), ours, want, abs));
        }
    }
    let mut rows = vec![worst("parabolic fit", parabolic)];
    rows.extend(known);
    rows.push(worst("lift, quartic fit", quartic));
    rows
}
