//! The doublet lattice beside PanelAero 2025.8 (see data/panelaero/README.md): matrices, strips, generalised forces and
//! totals of three meshes at every frequency. An error is relative to the largest entry of its kind at that frequency.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use crate::panelaero::{mesh, pitch_axis, table};
use aero::{DlmSettings, DoubletLattice, KernelIntegral, Lattice, MirrorPlane, SpanFit};
use faer::{Mat, c64};
use nalgebra::{Point3, Vector3};
use validation::data;

const CASES: [&str; 5] = ["alpha", "heave", "pitch", "bend", "gust"];

/// Displacement of the motions heave, pitch and bend at a point; the mesh reaches to `tip_m`.
fn motion(case: &str, at: &Point3<f64>, axis: &Point3<f64>, tip_m: f64) -> Vector3<f64> {
    match case {
        "heave" => Vector3::z(),
        "pitch" => Vector3::new(at.z - axis.z, 0.0, -(at.x - axis.x)),
        "bend" => Vector3::z() * (at.y / tip_m).powi(2),
        _ => Vector3::zeros(),
    }
}

/// Incidences of the five cases, as the folder's README defines them.
fn incidences(name: &str, lattice: &Lattice, kappa: f64) -> Mat<c64> {
    let tip_m = if name == "A" { 4.0 } else { 1.8 };
    Mat::from_fn(lattice.len(), CASES.len(), |i, case| {
        let (point, n) = (lattice.boxes[i].three_quarter_point(), lattice.boxes[i].normal());
        let rate = c64::new(0.0, -kappa) * n.dot(&motion(CASES[case], &point, &pitch_axis(name), tip_m));
        match CASES[case] {
            "alpha" => c64::from(n.z),
            "pitch" => rate + n.z,
            "gust" => c64::new(0.0, -kappa * point.x).exp() * n.z,
            _ => rate,
        }
    })
}

/// What the tables hold, from pressures: totals (Fz, Mx, My) and lift per span of each case, generalised forces.
struct Result {
    totals: Vec<[c64; 3]>,
    strips: Vec<Vec<c64>>,
    gaf: Vec<[c64; 3]>,
}

impl Result {
    fn new(name: &str, lattice: &Lattice, cp: &Mat<c64>) -> Self {
        let (axis, tip_m) = (pitch_axis(name), if name == "A" { 4.0 } else { 1.8 });
        let chordwise = lattice.surfaces[0].chordwise;
        let (mut totals, mut strips, mut gaf) =
            (vec![[c64::default(); 3]; 5], vec![Vec::new(); 5], vec![[c64::default(); 3]; 3]);
        for case in 0..5 {
            for (i, panel) in lattice.boxes.iter().enumerate() {
                let (point, force) = (panel.quarter_point(), cp[(i, case)] * panel.area_m2());
                let n = panel.normal();
                let moment = (point - axis).cross(&n);
                for (sum, arm) in totals[case].iter_mut().zip([n.z, moment.x, moment.y]) {
                    *sum += force * arm;
                }
                if i % chordwise == 0 {
                    strips[case].push(c64::default());
                }
                *strips[case].last_mut().unwrap() += force / panel.width_m();
                for row in 0..if (1..4).contains(&case) { 3 } else { 0 } {
                    gaf[row][case - 1] += force * n.dot(&motion(CASES[row + 1], &point, &axis, tip_m));
                }
            }
        }
        Self { totals, strips, gaf }
    }
}

/// Largest error of totals, strips and generalised forces relative to the largest entry of their kind.
fn errors(name: &str, plane: MirrorPlane, settings: DlmSettings) -> f64 {
    let lattice = mesh(if plane == MirrorPlane::None { name } else { "B" });
    let fit = if settings.fit == SpanFit::Quartic { "quartic" } else { "parabolic" };
    let mut largest: f64 = 0.0;
    for mach in [0.0, 0.5] {
        let doublets = DoubletLattice::new(&lattice, plane, mach, &settings).unwrap();
        for k in [0.05, 0.2, 0.5, 1.0] {
            let kappa = k * 2.0 / if name == "A" { 1.0 } else { 0.225 };
            let cp = doublets.at(kappa).unwrap().pressures(incidences(name, &lattice, kappa).as_ref());
            let got = Result::new(name, &lattice, &cp);
            largest = largest.max(beside(name, &got, plane, fit, [mach, k]));
        }
    }
    largest
}

/// The block of one fit, Mach number and frequency in a table: values of columns `name`_re and `name`_im by row.
fn block(file: &str, columns: &[&str], fit: &str, at: [f64; 2]) -> Vec<(String, Vec<c64>)> {
    let table = table(file);
    let wanted = |row: &usize| {
        table.text(*row, "fit").unwrap() == fit
            && table.number(*row, "mach").unwrap() == at[0]
            && table.number(*row, "k").unwrap() == at[1]
    };
    let value = |row, name: &str| {
        c64::new(
            table.number(row, &format!("{name}re")).unwrap(),
            table.number(row, &format!("{name}im")).unwrap(),
        )
    };
    let rows = (0..table.len()).filter(wanted).map(|row| {
        let key = if table.has("case") { "case" } else { "row" };
        (table.text(row, key).unwrap().to_owned(), columns.iter().map(|c| value(row, c)).collect())
    });
    rows.collect()
}

fn beside(name: &str, got: &Result, plane: MirrorPlane, fit: &str, at: [f64; 2]) -> f64 {
    let relative = |pairs: &[(c64, c64)]| {
        assert!(!pairs.is_empty());
        let size = pairs.iter().map(|(_, want)| want.norm()).fold(0.0, f64::max);
        pairs.iter().map(|(got, want)| (got - want).norm() / size).fold(0.0, f64::max)
    };
    let half = plane != MirrorPlane::None;
    let case = |name: &str| CASES.iter().position(|case| *case == name).unwrap();
    let mut largest: f64 = 0.0;
    if !half {
        let totals = block(&format!("{name}_oscillating_totals"), &["Fz_", "Mx_", "My_"], fit, at);
        for kind in 0..3 {
            // One size for forces, one for moments: the rolling moment of a whole wing is nothing by itself.
            let same = if kind == 0 { 0..1 } else { 1..3 };
            let size =
                totals.iter().flat_map(|(_, want)| &want[same.clone()]).map(|v| v.norm()).fold(0.0, f64::max);
            for (name, want) in &totals {
                largest = largest.max((got.totals[case(name)][kind] - want[kind]).norm() / size);
            }
        }
        let gaf = block(&format!("{name}_oscillating_gaf"), &[""], fit, at);
        let pairs: Vec<_> =
            gaf.iter().enumerate().map(|(i, (_, want))| (got.gaf[i / 3][i % 3], want[0])).collect();
        assert_eq!(pairs.len(), 9);
        largest = largest.max(relative(&pairs));
    }
    for name_of_case in ["alpha", "pitch"] {
        let mut strips = block(&format!("{name}_oscillating_strips"), &["l_"], fit, at);
        strips.retain(|(case, _)| case == name_of_case);
        if half {
            strips.drain(..16);
        }
        let got = &got.strips[case(name_of_case)];
        assert_eq!(got.len(), strips.len());
        let pairs: Vec<_> = got.iter().zip(strips).map(|(got, (_, want))| (*got, want[0])).collect();
        largest = largest.max(relative(&pairs));
    }
    largest
}

fn check(integral: KernelIntegral, fit: SpanFit, tolerance: f64) {
    let settings = DlmSettings { integral, fit };
    for (name, plane) in [
        ("A", MirrorPlane::None),
        ("B", MirrorPlane::None),
        ("Bsym", MirrorPlane::None),
        ("Bsym", MirrorPlane::Symmetric { y_m: 0.0 }),
    ] {
        let off = errors(name, plane, settings);
        assert!(off < tolerance, "mesh {name} {plane:?} {settings:?}: {off:.2e}");
    }
}

#[test]
fn the_same_formulas_give_the_same_numbers_parabolic_with_laschka() {
    check(KernelIntegral::Laschka, SpanFit::Parabolic, 1e-9);
}

#[test]
fn the_same_formulas_give_the_same_numbers_quartic_with_desmarais() {
    check(KernelIntegral::Desmarais, SpanFit::Quartic, 1e-9);
}

#[test]
fn a_better_integral_moves_the_quartic_fit_by_1e_4_at_most() {
    check(KernelIntegral::Fine, SpanFit::Quartic, 1e-4);
}

#[test]
fn a_better_integral_moves_the_parabolic_fit_by_4e_3_at_most() {
    check(KernelIntegral::Desmarais, SpanFit::Parabolic, 4e-3);
    check(KernelIntegral::Fine, SpanFit::Parabolic, 4e-3);
}

#[test]
fn the_whole_matrices_of_pressures_per_incidence() {
    let lattice = mesh("A");
    for (name, integral, fit) in [
        ("parabolic", KernelIntegral::Laschka, SpanFit::Parabolic),
        ("quartic", KernelIntegral::Desmarais, SpanFit::Quartic),
    ] {
        let settings = DlmSettings { integral, fit };
        let doublets = DoubletLattice::new(&lattice, MirrorPlane::None, 0.5, &settings).unwrap();
        let got = doublets.at(2.0).unwrap().pressures(Mat::identity(80, 80).as_ref());
        let text = std::fs::read_to_string(data(&format!("panelaero/A_Qjj_{name}_M0.5_k1.0.csv"))).unwrap();
        let want: Vec<Vec<f64>> =
            text.lines().map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect();
        assert_eq!(want.len(), 80);
        let size = want.iter().flatten().fold(0.0, |a: f64, b| a.max(b.abs()));
        for (i, row) in want.iter().enumerate() {
            assert_eq!(row.len(), 160);
            for j in 0..80 {
                let off = (got[(i, j)] - c64::new(row[2 * j], row[2 * j + 1])).norm() / size;
                assert!(off < 1e-9, "{name} cp {i} for w {j}: {off:.2e}");
            }
        }
    }
}
