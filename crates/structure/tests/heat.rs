//! Temperatures: free expansion and what holds it, of bars, plates, laminates and solids, beside closed forms and NAFEMS LE11; and the other
//! loads that need no force of their own: enforced motions of a load set, loads per area with a direction.

use crate::common::{at, close, system};
use faer::Mat;
use nalgebra::{DVector, Point3};
use nastran::{BulkData, Span, parse_deck};
use std::f64::consts::FRAC_1_SQRT_2;
use std::fmt::Write;
use std::sync::Arc;
use structure::{
    Flexibility, Model, QuadraticSolid, SolidMaterial, System, enforced_motions, loads_of, thermal_loads,
};

fn deck_of(text: &str) -> BulkData {
    parse_deck("test.bdf", text).unwrap_or_else(|error| panic!("{error}"))
}

/// Displacements (g-set) of a deck under temperatures of set 1.
fn warmed(text: &str, initial: Option<u32>) -> (System, Mat<f64>) {
    let forces = thermal_loads(&deck_of(text), 1, initial).unwrap_or_else(|error| panic!("{error}"));
    let system = system(text);
    let load = Mat::from_fn(forces.len(), 1, |i, _| forces[i]);
    let free = Flexibility::new(&system).expect("held").displacements(system.reduce(load.as_ref()).as_ref());
    let moved = system.expand(free.as_ref());
    (system, moved)
}

/// Two bars of the length 1 along x, off their grids, held at the first.
const BARS: &str = "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,2.,0.,0.\nCBAR,1,1,1,2,0.,1.,0.\n,,,0.,.2,.3,0.,.2,.3\n\
                    CBAR,2,1,2,3,0.,1.,0.\n,,,0.,.2,.3,0.,.2,.3\nPBAR,1,1,1.-2,2.-6,3.-6,4.-6\n\
                    MAT1,1,7.+10,,.3,,2.-5,15.\nSPC1,1,123456,1\n";

/// Boley and Weiner, Theory of Thermal Stresses: a free beam grows by A T and bends by v'' = -A dT/dy.
#[test]
fn a_free_bar_grows_and_bends_as_its_temperature_says() {
    let (system, moved) = warmed(&format!("{BARS}TEMP,1,1,35.,2,45.,3,75.\n"), None);
    close(at(&system, &moved, 3, 1), 2e-5 * (25.0 + 45.0), 1e-12, "means of the grids, from TREF on");
    let gradients = "TEMPRB,1,1,20.,30.,100.,70.,10.,20.\nTEMPRB,1,2,20.,30.,70.,40.,20.,30.\n";
    let (system, moved) = warmed(&format!("{BARS}{gradients}"), None);
    let (alpha, length) = (2e-5, 2.0_f64);
    close(at(&system, &moved, 3, 6), -alpha * length * 0.5 * (100.0 + 40.0), 1e-9, "turn in plane 1");
    close(at(&system, &moved, 3, 5), alpha * length * 0.5 * (10.0 + 30.0), 1e-9, "turn in plane 2");
    let sag = |a: f64, b: f64| -alpha * length.powi(2) * (a / 3.0 + b / 6.0);
    // Of the end of the beam, which stands off the grid: without an offset along x both sink alike.
    close(at(&system, &moved, 3, 2), sag(100.0, 40.0), 1e-9, "deflection in plane 1");
    close(at(&system, &moved, 3, 3), sag(10.0, 30.0), 1e-9, "deflection in plane 2");
    // The end of the beam grows by A T L; the grid stands .2 and .3 off, and the beam turns.
    let turned = at(&system, &moved, 3, 5) * 0.3 - at(&system, &moved, 3, 6) * 0.2;
    close(at(&system, &moved, 3, 1) + turned, alpha * 10.0 * length, 1e-9, "growth");
}

#[test]
fn a_bar_between_walls_pushes_with_its_stiffness_times_its_free_strain() {
    for card in [
        "CROD,1,2,1,2\nPROD,2,1,3.-3\n",
        "CONROD,1,1,2,1,3.-3\n",
        "CBAR,1,2,1,2,0.,1.,0.\nPBAR,2,1,3.-3,1.-6,1.-6,1.-6\n",
    ] {
        let deck = format!("GRID,1\nGRID,2,,0.,3.,4.\n{card}MAT1,1,7.+10,,.3,,2.-5\nTEMPD,1,50.,2,20.\n")
            .replace("0.,1.,0.\nPBAR", "1.,0.,0.\nPBAR");
        let forces = thermal_loads(&deck_of(&deck), 1, Some(2)).expect("temperatures");
        let push = 7e10 * 3e-3 * 2e-5 * 30.0;
        close(forces[7], 0.6 * push, 1e-9, card);
        close(forces[8], 0.8 * push, 1e-9, card);
        close(forces[2], -0.8 * push, 1e-9, card);
    }
}

/// A free rectangle of four plates about a grid off the middle; the corner at the origin is held.
fn rectangle(property: &str, extra: &str) -> String {
    let mut deck = String::from(
        "CQUAD4,1,1,1,2,5,4\nCQUAD4,2,1,2,3,6,5\nCQUAD4,3,1,4,5,8,7\nCTRIA3,4,1,5,6,9\nCTRIA3,5,1,5,9,8\n",
    );
    for (at, (x, y)) in
        [(0., 0.), (1., 0.), (2., 0.), (0., 1.), (1.2, 0.9), (2., 1.), (0., 2.), (1., 2.), (2., 2.)]
            .iter()
            .enumerate()
    {
        let _ = writeln!(deck, "GRID,{},,{x:?},{y:?},0.", at + 1);
    }
    deck + property + extra + "SPC1,1,123456,1\n"
}

/// A laminate of layers at 0, 45, -45 and 90 degrees expands alike in all directions, by (E1 A1 + E2 A2 + NU12 E2 (A1 + A2)) / (E1 + E2 + 2 NU12 E2):
/// Tsai and Hahn, Introduction to Composite Materials. Numbers of NASTRAN's verification problem VD0114.
#[test]
fn a_quasi_isotropic_laminate_expands_by_its_closed_form() {
    let layers = "PCOMP,1,,,,,30.,,SYM\n,2,.125,0.,,2,.125,45.\n,2,.125,-45.,,2,.125,90.\n\
                  MAT8,2,2.03+7,1.49+6,.29,7.47+5,,,.1\n,.7-6,31.2-6,11.\n";
    let (system, moved) = warmed(&rectangle(layers, "TEMPD,1,100.\n"), None);
    let (e1, e2, nu, a1, a2) = (2.03e7, 1.49e6, 0.29, 0.7e-6, 31.2e-6);
    let alpha = (e1 * a1 + e2 * a2 + nu * e2 * (a1 + a2)) / (e1 + e2 + 2.0 * nu * e2);
    for (grid, [x, y]) in [(9, [2.0, 2.0]), (5, [1.2, 0.9])] {
        close(at(&system, &moved, grid, 1), alpha * 70.0 * x, 1e-9, "along x, from the laminate's TREF on");
        close(at(&system, &moved, grid, 2), alpha * 70.0 * y, 1e-9, "along y");
    }
}

/// Timoshenko, Analysis of Bi-Metal Thermostats, 1925: the curvature of two layers that expand differently.
#[test]
fn a_strip_of_two_metals_bends_as_timoshenko_says() {
    let layers = "PCOMP,1\n,2,.01,0.,,3,.02,0.\nMAT1,2,2.+11,,0.,,1.-5\nMAT1,3,1.+11,,0.,,3.-5\n";
    let (system, moved) = warmed(&rectangle(layers, "TEMPD,1,50.\n"), None);
    let (m, n, h) = (0.01 / 0.02, 2e11 / 1e11, 0.03);
    let curvature = 6.0 * (3e-5 - 1e-5) * 50.0 * (1.0_f64 + m).powi(2)
        / (h * (3.0 * (1.0 + m).powi(2) + (1.0 + m * n) * (m * m + 1.0 / (m * n))));
    // Without Poisson's ratio it bends alike along both axes; the upper layer grows more, so the edges sink.
    for (grid, [x, y]) in [(3, [2.0_f64, 0.0_f64]), (9, [2.0, 2.0]), (5, [1.2, 0.9])] {
        close(at(&system, &moved, grid, 3), -0.5 * curvature * (x * x + y * y), 1e-6, "sag");
    }
}

#[test]
fn a_plate_that_is_warmer_above_bends_and_keeps_its_size() {
    let plate = "PSHELL,1,2,.05,2,,2\nMAT1,2,2.+11,,.3,,1.-5\nTEMPP1,1,1,0.,200.\n,2,THRU,5\n";
    let (system, moved) = warmed(&rectangle(plate, ""), None);
    close(at(&system, &moved, 9, 3), -0.5 * 1e-5 * 200.0 * 8.0, 1e-6, "sag");
    close(at(&system, &moved, 9, 5), 1e-5 * 200.0 * 2.0, 1e-6, "turn about y");
    assert!(at(&system, &moved, 9, 1).abs() < 1e-12, "no growth");
}

#[test]
fn solids_grow_freely_and_push_where_they_are_held() {
    let corners = "GRID,1\nGRID,2,,2.\nGRID,3,,2.1,1.\nGRID,4,,0.,1.\nGRID,5,,0.,0.,3.\nGRID,6,,2.2,0.,3.\nGRID,7,,2.,1.,3.\nGRID,8,,0.,1.,3.1\n";
    let material = "PSOLID,1,1\nMAT1,1,2.+11,,.3,,1.-5\nTEMPD,1,40.,2,10.\n";
    let held = "SPC1,1,123,1\nSPC1,1,23,2\nSPC1,1,3,4\n";
    for (element, grids) in [
        ("CHEXA,1,1,1,2,3,4,5,6\n,7,8\n", vec![2, 3, 4, 5, 6, 7, 8]),
        ("CPENTA,1,1,1,2,4,5,6,8\n", vec![2, 4, 5, 6, 8]),
        ("CTETRA,1,1,1,2,4,5\n", vec![2, 4, 5]),
    ] {
        let text = format!("{corners}{element}{material}{held}");
        let bulk = deck_of(&text);
        let (system, moved) = warmed(&text, Some(2));
        for grid in grids {
            for axis in 0..3 {
                let free = 1e-5 * 30.0 * bulk.grids[&grid].xyz[axis];
                let moved = at(&system, &moved, grid, axis + 1);
                assert!((moved - free).abs() < 1e-12, "{element} GRID {grid}: {moved} for {free}");
            }
        }
    }
    // Held all round: -E A T / (1 - 2 nu) in all directions.
    let cube = "GRID,1\nGRID,2,,2.\nGRID,3,,2.,1.\nGRID,4,,0.,1.\nGRID,5,,0.,0.,3.\nGRID,6,,2.,0.,3.\nGRID,7,,2.,1.,3.\nGRID,8,,0.,1.,3.\nCHEXA,1,1,1,2,3,4,5,6\n,7,8\n";
    let forces = thermal_loads(&deck_of(&format!("{cube}{material}")), 1, None).expect("temperatures");
    let push: f64 = [2, 3, 6, 7].iter().map(|grid| forces[6 * (grid - 1)]).sum();
    close(push, 2e11 * 1e-5 * 40.0 / 0.4 * 3.0, 1e-9, "on the face at x = 2");
}

/// Inner and outer outline of NAFEMS LE11's section (r, z) at a place from 0 (the face at z = 0) to 7 (the one at z = 1.79).
fn outline(place: f64) -> [[f64; 2]; 2] {
    let arc = |radius: f64, degrees: f64| {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        [radius * cosine, radius * sine]
    };
    let between = |[a, b]: [[f64; 2]; 2], share: f64| [0, 1].map(|i| a[i] + (b[i] - a[i]) * share);
    let inner = match place {
        p if p < 4.0 => arc(1.0, 5.625 * p),
        p if p < 5.0 => arc(1.0, 22.5 * (p - 3.0)),
        p => between([[FRAC_1_SQRT_2, FRAC_1_SQRT_2], [FRAC_1_SQRT_2, 1.79]], (p - 5.0) / 2.0),
    };
    let outer = match place {
        p if p < 3.0 => arc(1.4, 5.625 * p),
        p if p < 4.0 => arc(1.4, 16.875 + 13.125 * (p - 3.0)),
        p if p < 6.0 => between([[1.2124, 0.7], [1.0, 1.39]], (p - 4.0) / 2.0),
        p => between([[1.0, 1.39], [1.0, 1.79]], p - 6.0),
    };
    [inner, outer]
}

/// Axial stress at point A of NAFEMS LE11, of a slice of curved CHEXA with `7 n` by `n` elements.
fn le11(n: usize) -> f64 {
    let counts = [14 * n, 2 * n, 2];
    let id = |at: [usize; 3]| 1 + (at[0] * (counts[1] + 1) + at[1]) * 3 + at[2];
    let place = |at: [usize; 3]| {
        let [inner, outer] = outline(at[0] as f64 / (2.0 * n as f64));
        let share = at[1] as f64 / counts[1] as f64;
        let [r, z] = [0, 1].map(|i| inner[i] + (outer[i] - inner[i]) * share);
        let (sine, cosine) = (2.5 * at[2] as f64).to_radians().sin_cos();
        [r * cosine, r * sine, z]
    };
    let mut deck =
        String::from("CORD2C,1,,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\nPSOLID,1,1\nMAT1,1,2.1+11,,.3,,2.3-4\n");
    for i in 0..=counts[0] {
        for (j, k) in (0..=counts[1]).flat_map(|j| (0..3).map(move |k| (j, k))) {
            if i % 2 + j % 2 + k % 2 > 1 {
                continue;
            }
            let [x, y, z] = place([i, j, k]);
            let held = if i == 0 || i == counts[0] { "23" } else { "2" };
            let _ = writeln!(deck, "GRID,{},,{x:.9},{y:.9},{z:.9},1,{held}", id([i, j, k]));
            let _ = writeln!(deck, "TEMP,1,{},{:.9}", id([i, j, k]), x.hypot(y) + z);
        }
    }
    // Corners, then edges, in the order of the card: along the outline, across the section, around the axis.
    let corners = [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], [0, 0, 2], [2, 0, 2], [2, 2, 2], [0, 2, 2]];
    let edges =
        [(0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (1, 5), (2, 6), (3, 7), (4, 5), (5, 6), (6, 7), (7, 4)];
    let middle =
        |(a, b): (usize, usize)| [0, 1, 2].map(|axis| usize::midpoint(corners[a][axis], corners[b][axis]));
    let shape: Vec<[usize; 3]> = corners.into_iter().chain(edges.into_iter().map(middle)).collect();
    let grids = |i: usize, j: usize| {
        shape.iter().map(|at| id([2 * i + at[0], 2 * j + at[1], at[2]])).collect::<Vec<_>>()
    };
    for (i, j) in (0..7 * n).flat_map(|i| (0..n).map(move |j| (i, j))) {
        let all: Vec<String> = grids(i, j).iter().map(usize::to_string).collect();
        let lines = [all[..6].join(","), all[6..14].join(","), all[14..].join(",")];
        let _ = writeln!(deck, "CHEXA,{},1,{}\n,{}\n,{}", 100_000 + i * n + j, lines[0], lines[1], lines[2]);
    }
    let (system, moved) = warmed(&deck, None);
    let bulk = deck_of(&deck);
    let own: Vec<u32> = grids(0, 0).iter().map(|id| u32::try_from(*id).expect("few grids")).collect();
    let points: Vec<Point3<f64>> = own.iter().map(|grid| bulk.grids[grid].xyz).collect();
    let motion = DVector::from_iterator(
        60,
        own.iter().flat_map(|grid| [1, 2, 3].map(|c| at(&system, &moved, *grid, c))),
    );
    let material = Arc::new(SolidMaterial::from_mat1(&bulk.materials[&1]).expect("sound"));
    let every: Vec<usize> = (0..12).collect();
    let solid =
        QuadraticSolid::new(1, (0..20).collect(), &points, &every, &material, &Span::generated("LE11"))
            .expect("sound");
    // What the free expansion at A (1 degree) would stress.
    solid.stress(&motion, [-1.0; 3])[2] - 2.1e11 * 2.3e-4 * 1.0 / 0.4
}

/// NAFEMS, The Standard NAFEMS Benchmarks (TNSB rev. 3, 1990), LE11: -105 MPa. Outline as in FinEtools' example (P. Krysl); FeenoX prints -105.04 with a fine
/// mesh, -102.4 with coarse hexahedra.
#[test]
fn nafems_le11_has_its_axial_stress() {
    // Two meshes: -104.99 and -105.24 MPa.
    for n in [2, 4] {
        close(le11(n), -105e6, 0.005, "axial stress at A");
    }
}

#[test]
fn temperatures_that_are_missing_or_not_read_are_refused_in_one_sentence() {
    let refusal = |text: &str| thermal_loads(&deck_of(text), 1, None).expect_err("a refusal").to_string();
    let error = refusal(&format!("{BARS}TEMP,1,1,35.,2,45.\n"));
    assert!(
        error.starts_with("test.bdf:6:1: CBAR 2 expands, and its GRID 3 has no temperature in set 1"),
        "{error}"
    );
    let error = refusal(BARS);
    assert!(
        error.starts_with("the case control selects temperatures of set 1, which is not there"),
        "{error}"
    );
    let error = refusal(&format!("{BARS}TEMPD,1,35.\nMATT1,1,7\n"));
    assert!(error.contains("MATT1 makes a material change with the temperature"), "{error}");
    let error = refusal(&format!("{BARS}TEMPD,1,35.\nTEMPP3,1,7,0.,1.\n"));
    assert!(error.contains("TEMPP3 is a temperature that is not read"), "{error}");
}

#[test]
fn an_spcd_moves_what_an_spc_holds_in_its_load_set_alone() {
    let deck = "GRID,1,,0.,0.,0.,,23456\nGRID,2,,10.,0.,0.,,23456\nGRID,3,,20.,0.,0.,,23456\nCROD,1,1,1,2\nCROD,2,1,2,3\n\
                PROD,1,1,.01\nMAT1,1,1.+6,,.3\nSPC1,1,1,1\nSPC,1,3,1,.5\nSPCD,7,3,1,.2\nSPCD,8,2,1,.2\nLOAD,9,2.,1.,7\n";
    let bulk = deck_of(deck);
    let model = Model::from_bulk(&bulk).expect("a model");
    let x_of_3 = |load: Option<u32>| enforced_motions(&bulk, &model, load).expect("held").expect("moved")[12];
    assert_eq!((x_of_3(None), x_of_3(Some(7)), x_of_3(Some(4))), (0.5, 0.2, 0.5));
    let error = enforced_motions(&bulk, &model, Some(8)).expect_err("free").to_string();
    assert!(
        error.contains("SPCD of set 8 enforces component 1 of GRID 2, which no SPC or SPC1 holds"),
        "{error}"
    );
    let error = loads_of(&bulk, 9).expect_err("summed").to_string();
    assert!(error.contains("LOAD 9 sums set 7, whose SPCD a LOAD card does not combine"), "{error}");
    assert!(loads_of(&bulk, 7).is_ok(), "motions alone are a load");
}

/// A face of 5 m2 (the vectors 0 0 1 and 3 4 0 span it): force = pressure x area, along the direction, shared alike.
#[test]
fn a_load_per_area_keeps_the_direction_it_is_given() {
    let deck = "GRID,1\nGRID,2,,3.,4.\nGRID,3,,3.,4.,1.\nGRID,4,,0.,0.,1.\nCORD2R,5,,0.,0.,0.,1.,0.,0.,\n,0.,1.,0.\n\
                CQUAD4,1,1,1,2,3,4\nPSHELL,1,1,.1\nMAT1,1,7.+10,,.3\nPLOAD4,1,1,2.\n,0,0.,0.,-3.\nPLOAD4,2,1,2.\n,5,0.,0.,2.\n";
    for (set, axis, sign) in [(1, 2, -1.0), (2, 0, 1.0)] {
        let loads = loads_of(&deck_of(deck), set).expect("loads");
        assert_eq!((loads.dead.len(), loads.following.len()), (4, 0));
        for load in &loads.dead {
            close(load.force[axis], sign * 2.0 * 5.0 / 4.0, 1e-12, "a quarter of it");
            close(load.force.norm(), 2.5, 1e-12, "nothing else");
        }
    }
}

/// The shear flexibility of a cantilever is that of its MID3: a MAT2 with G11 = G22 = G beside a MAT1 with G, other constants of the MAT2 left out.
#[test]
fn a_mat2_as_transverse_material_has_the_shear_moduli_of_its_card() {
    let sag = |shear: &str| {
        let deck = rectangle(
            &format!("PSHELL,1,2,.5,2,,3\nMAT1,2,2.+11,,.3\n{shear}"),
            "FORCE,1,9,,1000.,0.,0.,1.\n",
        );
        let loads = loads_of(&deck_of(&deck), 1).expect("loads");
        let system = system(&deck.replace("SPC1,1,123456,1\n", "SPC1,1,123456,1,4,7\n"));
        let load = system.reduce(system.forces_of(&loads).as_ref());
        let moved =
            system.expand(Flexibility::new(&system).expect("held").displacements(load.as_ref()).as_ref());
        at(&system, &moved, 9, 3)
    };
    close(sag("MAT2,3,1.+9,,,1.+9\n"), sag("MAT1,3,,1.+9,.3\n"), 1e-9, "the same moduli");
    assert!(sag("MAT2,3,1.+9,,,1.+9\n") > 1.5 * sag("MAT2,3,1.+14,,,1.+14\n"), "and they count");
}
