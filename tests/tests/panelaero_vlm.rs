//! The vortex lattice beside PanelAero 2025.8 (see data/panelaero/README.md): matrices, pressures, strips, totals.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use crate::panelaero::{mesh, pitch_axis, table};
use aero::{Corrections, Integration, Lattice, MirrorPlane, SteadyAero, incidence};
use faer::Mat;
use validation::{assert_close, data};

/// Printed to 11 or 13 digits: what is left is round-off.
const TOLERANCE: f64 = 1e-9;

/// Pressures, strips and totals for 1 rad against the tables of mesh `name`.
fn compare(name: &str, lattice: &Lattice, plane: MirrorPlane, first_row: usize) {
    let (cps, strips, totals) =
        (table(&format!("{name}_cp")), table(&format!("{name}_strips")), table(&format!("{name}_totals")));
    for (case, mach) in [0.0, 0.5].into_iter().enumerate() {
        let cp =
            SteadyAero::new(lattice, plane, mach).unwrap().pressures_of(&incidence::angle_of_attack(lattice));
        let full = cps.len() / 2;
        for (j, cp) in cp.iter().enumerate() {
            let want = cps.number(case * full + first_row + j, "cp").unwrap();
            assert_close(&format!("mesh {name} Mach {mach} cp of box {j}"), *cp, want, TOLERANCE, 0.0);
        }
        let chordwise = lattice.surfaces[0].chordwise;
        let first_strip = case * strips.len() / 2 + first_row / chordwise;
        for (s, boxes) in lattice.boxes.chunks(chordwise).enumerate() {
            let lift: f64 = boxes.iter().zip(&cp[s * chordwise..]).map(|(b, cp)| b.area_m2() * cp).sum();
            let want = strips.number(first_strip + s, "l").unwrap();
            assert_close(
                &format!("mesh {name} Mach {mach} strip {s}"),
                lift / boxes[0].width_m(),
                want,
                TOLERANCE,
                0.0,
            );
        }
        if plane == MirrorPlane::None {
            let loads =
                Integration::new(lattice).corrected(&Corrections::neutral(lattice.len())).box_loads(1.0, &cp);
            let (force, moment) = loads.resultant(lattice, 0..lattice.len(), &pitch_axis(name));
            for (got, column) in [(force[2], "Fz"), (moment[0], "Mx"), (moment[1], "My")] {
                let want = totals.number(case, column).unwrap();
                // The rolling moment of a symmetric wing is zero but for round-off.
                assert_close(
                    &format!("mesh {name} Mach {mach} {column}"),
                    got,
                    want,
                    TOLERANCE,
                    1e-11 * force[2],
                );
            }
        }
    }
}

#[test]
fn rectangle_of_aspect_ratio_8() {
    compare("A", &mesh("A"), MirrorPlane::None, 0);
}

#[test]
fn swept_half_wing_without_image() {
    compare("B", &mesh("B"), MirrorPlane::None, 0);
}

#[test]
fn swept_wing_with_its_mirror_image_as_boxes() {
    compare("Bsym", &mesh("Bsym"), MirrorPlane::None, 0);
}

#[test]
fn swept_half_wing_beside_a_plane_of_symmetry() {
    compare("Bsym", &mesh("B"), MirrorPlane::Symmetric { y_m: 0.0 }, 96);
}

#[test]
fn the_whole_matrix_of_pressures_per_incidence() {
    let lattice = mesh("A");
    let identity = Mat::<f64>::identity(lattice.len(), lattice.len());
    for mach in ["0.0", "0.5"] {
        let steady = SteadyAero::new(&lattice, MirrorPlane::None, mach.parse().unwrap()).unwrap();
        let got = steady.pressures(identity.as_ref());
        let text = std::fs::read_to_string(data(&format!("panelaero/A_Qjj_M{mach}.csv"))).unwrap();
        let want: Vec<Vec<f64>> =
            text.lines().map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect();
        assert_eq!(want.len(), 80);
        for (i, row) in want.iter().enumerate() {
            assert_eq!(row.len(), 80);
            for (j, want) in row.iter().enumerate() {
                assert_close(&format!("Mach {mach} cp {i} for w {j}"), got[(i, j)], *want, TOLERANCE, 0.0);
            }
        }
    }
}
