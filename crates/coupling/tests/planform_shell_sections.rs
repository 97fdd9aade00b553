//! Masses and beam properties of the shell-and-solid wing, against sums made another way and against the beam's table.

use crate::shell_mesh::masses;
use coupling::planform::{Mount, Planform, Profile, ShellSolid, Structure, Surface};
use coupling::wing_file::WingFile;
use nalgebra::{Point3, Vector3};
use std::path::{Path, PathBuf};

type Outcome = Result<(), Box<dyn std::error::Error>>;

fn data(file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex").join(file)
}

fn tuflex() -> WingFile {
    WingFile::read(&data("wing.ron")).unwrap_or_else(|error| panic!("{error}"))
}

fn shell(planform: &mut Planform) -> &mut ShellSolid {
    match &mut planform.structure {
        Some(Structure::ShellSolid(shell)) => shell,
        _ => panic!("wing.ron is no shell-and-solid wing"),
    }
}

/// The section's published points, upper trailing edge to lower.
fn section_points() -> Vec<[f64; 2]> {
    let text = std::fs::read_to_string(data("e214.dat")).expect("the section's file");
    let number = |word: &str| word.parse::<f64>().expect("a number");
    let pair = |line: &str| -> [f64; 2] {
        let words: Vec<f64> = line.split_whitespace().map(number).collect();
        [words[0], words[1]]
    };
    smooth(&text.lines().skip(1).map(pair).collect::<Vec<_>>())
}

/// Seven points more on each piece, on the mean of the parabolas over chord length through three points each that
/// meet there (Overhauser's curve): another curve than the generator's spline.
fn smooth(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut arc = vec![0.0];
    for pair in points.windows(2) {
        arc.push(arc[arc.len() - 1] + (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]));
    }
    let parabola = |middle: usize, at: f64, axis: usize| -> f64 {
        let nodes = [middle - 1, middle, middle + 1];
        let weight = |k: usize| -> f64 {
            nodes.iter().filter(|&&n| n != k).map(|&n| (at - arc[n]) / (arc[k] - arc[n])).product()
        };
        nodes.iter().map(|&k| weight(k) * points[k][axis]).sum()
    };
    let last = points.len() - 1;
    let mut dense = Vec::new();
    for piece in 0..last {
        for step in 0..8 {
            let share = f64::from(step) / 8.0;
            let at = arc[piece] + share * (arc[piece + 1] - arc[piece]);
            let (before, after) = (piece.max(1), (piece + 1).min(last - 1));
            dense.push(
                [0, 1].map(|axis| {
                    (1.0 - share) * parabola(before, at, axis) + share * parabola(after, at, axis)
                }),
            );
        }
    }
    dense.push(points[last]);
    dense
}

/// Where a point of the section is in space: chord 0.30 to 0.15 m over 1.8 m, the quarter-chord line swept 20 deg
/// from x = 0.075 m.
fn place([x, z]: [f64; 2], y_m: f64) -> Point3<f64> {
    let chord_m = 0.30 - 0.15 * y_m / 1.8;
    Point3::new(0.075 + y_m * 20.0_f64.to_radians().tan() + (x - 0.25) * chord_m, y_m, z * chord_m)
}

/// Straight lines through values at root, middle and tip.
fn over_span(y_m: f64, values: [f64; 3]) -> f64 {
    let share = y_m / 0.9;
    if share < 1.0 {
        values[0] + share * (values[1] - values[0])
    } else {
        values[1] + (share - 1.0) * (values[2] - values[1])
    }
}

/// Parts of the flexible wing in kg: skin, finish, caps, webs, ribs, foam, cables; from the published points and the
/// lay-up of data/tuflex/README.md, the surface cut into 360 slices.
fn parts_kg() -> [f64; 7] {
    const SLICES: usize = 360;
    let points = section_points();
    let width_m = 1.8 / SLICES as f64;
    let area = 0.5 * points.windows(2).map(|p| p[0][0] * p[1][1] - p[1][0] * p[0][1]).sum::<f64>().abs();
    let height = |x: f64| {
        let side = |range: &[[f64; 2]]| {
            let pair =
                range.windows(2).find(|p| (p[0][0] - x) * (p[1][0] - x) <= 0.0).expect("a pair around x");
            pair[0][1] + (x - pair[0][0]) / (pair[1][0] - pair[0][0]) * (pair[1][1] - pair[0][1])
        };
        side(&points[..=32 * 8]) - side(&points[32 * 8..])
    };
    let mut parts = [0.0; 7];
    for slice in 0..SLICES {
        let y_m = (slice as f64 + 0.5) * width_m;
        let chord_m = 0.30 - 0.15 * y_m / 1.8;
        let skin_m = over_span(y_m, [0.33e-3, 0.25e-3, 0.18e-3]);
        let (low, high) = (y_m - 0.5 * width_m, y_m + 0.5 * width_m);
        for pair in points.windows(2) {
            let corners =
                [place(pair[0], low), place(pair[0], high), place(pair[1], low), place(pair[1], high)];
            let surface = 0.5 * (corners[3] - corners[0]).cross(&(corners[2] - corners[1])).norm();
            parts[0] += surface * skin_m * 1850.0;
            parts[1] += surface * 0.08;
        }
        let cap = over_span(y_m, [0.04, 0.03, 0.018]) * over_span(y_m, [0.08e-3, 0.05e-3, 0.02e-3]);
        parts[2] += 2.0 * cap * width_m * 1850.0;
        let web_m = 0.08e-3 - 0.04e-3 * y_m / 1.8;
        for x in [1.0 / 3.0, 0.75] {
            let along: Vector3<f64> = place([x, 0.0], high) - place([x, 0.0], low);
            parts[3] += height(x) * chord_m * along.norm() * web_m * 1850.0;
        }
        parts[5] += area * chord_m.powi(2) * width_m * 30.4;
        parts[6] += 0.09 * width_m;
    }
    parts[4] = area * (0.30_f64.powi(2) * 0.33e-3 + 0.15_f64.powi(2) * 0.18e-3) * 1850.0;
    parts
}

#[test]
fn the_wing_weighs_the_sum_of_its_parts() -> Outcome {
    let bulk = tuflex().bulk(Mount::Tunnel)?;
    let parts = parts_kg();
    let lumps = 1.216 + 3.0 * 0.03 + 4.0 * 0.012;
    let (flexible, total): (f64, f64) =
        (parts.iter().sum(), masses(&bulk).iter().map(|(mass, _)| mass).sum());
    println!(
        "skin, finish, caps, webs, ribs, foam, cables {parts:.4?}; with lumps {:.4}, mesh {total:.4}",
        flexible + lumps
    );
    assert!((total / (flexible + lumps) - 1.0).abs() < 1e-3, "{total} kg against {} kg", flexible + lumps);
    // The point masses must not hide an error of the mesh.
    assert!(((total - lumps) / flexible - 1.0).abs() < 1.5e-3, "{} kg against {flexible} kg", total - lumps);
    // The paper's wing has 2.2 kg.
    assert!((total / 2.2 - 1.0).abs() < 0.01);
    Ok(())
}

#[test]
fn a_finer_mesh_weighs_the_same() -> Outcome {
    let weigh = |fine: bool| -> Result<(f64, f64), nastran::InputError> {
        let mut planform = tuflex().planform().expect("parametric").clone();
        if fine {
            let mesh = &mut shell(&mut planform).mesh;
            (mesh.spanwise_per_strip, mesh.chordwise_per_box, mesh.thickness) = (2, 2, 6);
        }
        let all = masses(&planform.bulk(&data(""), Mount::Tunnel)?);
        let total: f64 = all.iter().map(|(mass, _)| mass).sum();
        Ok((total, all.iter().map(|(mass, at)| mass * at.x).sum::<f64>() / total))
    };
    let (coarse, fine) = (weigh(false)?, weigh(true)?);
    assert!((coarse.0 / fine.0 - 1.0).abs() < 2e-4, "{coarse:?} {fine:?}");
    assert!((coarse.1 - fine.1).abs() < 2e-4, "{coarse:?} {fine:?}");
    Ok(())
}

/// The wing without webs, which the beam's table does not have, and with the modulus the table was made with.
fn without_webs() -> (Planform, ShellSolid) {
    let mut planform = tuflex().planform().expect("parametric").clone();
    let shell = shell(&mut planform);
    shell.webs_over_c.clear();
    shell.plies.retain(|ply| !ply.on.contains(&Surface::Webs));
    (shell.materials[0].e1_pa, shell.materials[0].e2_pa) = (17e9, 17e9);
    let shell = shell.clone();
    (planform, shell)
}

/// Rows of the beam's table: y, EI flap, EI lag, GJ, mass per span, pitch inertia, centre of gravity, elastic axis.
fn table() -> Vec<Vec<f64>> {
    let text = std::fs::read_to_string(data("beam_distribution.csv")).expect("the beam's table");
    let row = |line: &str| line.split(',').map(|word| word.parse().ok()).collect::<Option<Vec<f64>>>();
    text.lines().filter_map(row).collect()
}

#[test]
fn the_lay_up_without_webs_has_the_sections_of_the_beam() -> Outcome {
    let (planform, bare) = without_webs();
    let (mut wing, folder) = (tuflex().planform().ok_or("parametric")?.clone(), data(""));
    let webs = shell(&mut wing).clone();
    let rows = table();
    assert_eq!(rows.len(), 19);
    // A cut square to the elastic axis (38 % chord) is shorter by the cosine of its sweep, and so is its stiffness.
    let along: Vector3<f64> = wing.point(1.8, 0.38) - wing.point(0.0, 0.38);
    let cosine = along.normalize().y;
    println!(
        "| y m | EI flap, GJ, m', x_cg/c: table | lay-up along x, 17 GPa, no webs | EI, GJ square to the axis, as shipped |"
    );
    for row in rows {
        let bare = bare.section_integrals(&planform, &folder, row[0])?;
        let webs = webs.section_integrals(&planform, &folder, row[0])?;
        println!(
            "| {:.2} | {:.1}, {:.1}, {:.4}, {:.4} | {:.1}, {:.1}, {:.4}, {:.4} | {:.1}, {:.1} |",
            row[0],
            row[1],
            row[3],
            row[4],
            row[6],
            bare.ei_flap_nm2,
            bare.gj_nm2,
            bare.mass_kg_m,
            bare.centre_of_gravity,
            webs.ei_flap_nm2 * cosine,
            webs.gj_nm2 * cosine
        );
        // The table was made by another program from the same section and lay-up; how it drew the curve between the
        // section's points is not said, and straight lines alone take 0.4 % off the bending stiffness.
        assert!((bare.ei_flap_nm2 / row[1] - 1.0).abs() < 0.013, "{bare:?}");
        assert!((bare.gj_nm2 / row[3] - 1.0).abs() < 0.018, "{bare:?}");
        assert!((bare.mass_kg_m / row[4] - 1.0).abs() < 0.005, "{bare:?}");
        assert!((bare.centre_of_gravity - row[6]).abs() < 0.001, "{bare:?}");
        // The core adds to the lag stiffness, which the table's does not seem to have.
        assert!((bare.ei_lag_nm2 / row[2] - 1.0).abs() < 0.075, "{bare:?}");
        assert!((webs.ei_flap_nm2 * cosine / row[1] - 1.0).abs() < 0.025, "{webs:?}");
        assert!((webs.mass_kg_m / row[4] - 1.0).abs() < 0.012, "{webs:?}");
    }
    Ok(())
}

#[test]
fn the_integrals_of_a_thin_ellipse_are_the_closed_forms() -> Outcome {
    // A doubly symmetric section: x = (1 + cos s)/2, z = 0.05 sin s over the chord; one isotropic ply of thickness t.
    let folder = std::env::temp_dir().join(format!("wingroot_shell_ellipse_{}", std::process::id()));
    std::fs::create_dir_all(&folder)?;
    let pairs = (0..=120).map(|step| {
        let angle = f64::from(step) * std::f64::consts::TAU / 120.0;
        format!("{:.9} {:.9}\n", 0.5 * (1.0 + angle.cos()), 0.05 * angle.sin())
    });
    std::fs::write(folder.join("ellipse.dat"), format!("ellipse\n{}", pairs.collect::<String>()))?;
    let (mut planform, mut wing) = without_webs();
    planform.airfoil = Some("ellipse.dat".to_owned());
    let t_m = 1e-4;
    wing.plies.truncate(1);
    wing.plies[0].thickness_m = Profile(vec![(0.0, t_m)]);
    (wing.finish_kg_m2, wing.line_masses) = (0.0, Vec::new());
    let (e, g) = (wing.materials[0].e1_pa, wing.materials[0].g12_pa);
    let (foam_e, foam_g) = (wing.foam.e_pa, wing.foam.e_pa / (2.0 * (1.0 + wing.foam.nu)));
    let got = wing.section_integrals(&planform, &folder, 0.0)?;
    std::fs::remove_dir_all(&folder)?;
    // Chord 0.3 m: half axes a and b, perimeter by Ramanujan (error below 1e-6 here).
    let (a, b) = (0.15_f64, 0.015_f64);
    let perimeter = std::f64::consts::PI * (3.0 * (a + b) - ((3.0 * a + b) * (a + 3.0 * b)).sqrt());
    let area = std::f64::consts::PI * a * b;
    let bredt = 4.0 * area.powi(2) * g * t_m / perimeter;
    let core = foam_g * std::f64::consts::PI * a * b.powi(3);
    assert!((got.gj_nm2 / (bredt + core) - 1.0).abs() < 2e-3, "{got:?} against {bredt} + {core}");
    // Bending: integral of z^2 along the curve, by the trapezoidal rule over the angle, and pi a b^3/4 of the core.
    let wall: f64 = (0..1000)
        .map(|step| {
            let (sin, cos) = (f64::from(step) * std::f64::consts::TAU / 1000.0).sin_cos();
            (b * sin).powi(2) * (a * sin).hypot(b * cos) * std::f64::consts::TAU / 1000.0
        })
        .sum();
    let bending = e * t_m * wall + foam_e * area * b * b / 4.0;
    assert!((got.ei_flap_nm2 / bending - 1.0).abs() < 2e-3, "{got:?} against {bending}");
    let mass = perimeter * t_m * 1850.0 + area * 30.4;
    assert!((got.mass_kg_m / mass - 1.0).abs() < 1e-3, "{got:?} against {mass}");
    // Contours are drawn over sqrt(x), in which a nose is smooth but this blunt trailing edge is not.
    assert!((got.centre_of_gravity - 0.5).abs() < 1e-3, "{got:?}");
    Ok(())
}
