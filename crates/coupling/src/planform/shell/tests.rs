//! What a mesh of few elements has on its cards, by hand, and what is refused just beyond each bound.

mod bounds;

use super::samples::{Folder, heights, planform, shell};
use super::*;
use crate::planform::{FIRST_AXIS_GRID, FIRST_SENSOR_GRID, PointMass};
use nalgebra::Vector3;

fn same(found: f64, expected: f64, tolerance: f64, what: &str) {
    let off = (found - expected).abs();
    assert!(off <= tolerance * expected.abs().max(1e-9), "{what}: {found} beside {expected}");
}

fn cards(test: &str, planform: &Planform) -> BulkData {
    planform.bulk(&Folder::new(test).0, Mount::Tunnel).expect("a wing")
}

/// Length of a surface (0 lower, 1 upper) over the chord, in short straight pieces.
fn arc(side: usize, from: f64, to: f64) -> f64 {
    let (low, high) = (from.sqrt(), to.sqrt());
    let at = |k: u32| {
        let x = (low + (high - low) * f64::from(k) / 4000.0).powi(2);
        [x, heights(x)[side]]
    };
    (0..4000).map(|k| (at(k + 1)[0] - at(k)[0]).hypot(at(k + 1)[1] - at(k)[1])).sum()
}

fn facets(side: usize, lines: &[f64]) -> f64 {
    let at = |x: f64| [x, heights(x)[side]];
    lines.windows(2).map(|p| (p[1] - p[0]).hypot(at(p[1])[1] - at(p[0])[1])).sum()
}

const LINES: [f64; 5] = [0.01, 0.25, 0.5, 0.75, 0.97];

#[test]
fn laminates_carry_the_mass_that_straight_facets_leave_out() {
    let bulk = cards("laminates", &planform(shell()));
    let nsm = |element: u32| bulk.laminates[&bulk.shells[&element].property].nsm;
    let skin = 0.3e-3 * 1800.0;
    // The cap covers 0.2 of the chord, all of it on the first cell.
    for station in 0..2_u32 {
        let covered = 0.2 / 0.24;
        for (side, first) in [(1, 2_100_001), (0, 2_200_001)] {
            let ratio = arc(side, 0.01, 0.97) / facets(side, &LINES);
            assert!(ratio > 1.001, "{ratio}");
            let cap = 0.9e-3 * covered * 1800.0;
            for line in 0..4 {
                let plies = if line == 0 { skin + cap } else { skin };
                let element = first + 4 * station + line;
                same(nsm(element), 0.5 * ratio + plies * (ratio - 1.0), 2e-4, "a skin");
                let property = &bulk.laminates[&bulk.shells[&element].property];
                let thick: f64 = property.plies.iter().map(|ply| ply.thickness).sum();
                same(thick, plies / 1800.0, 1e-9, "thickness");
            }
        }
    }
    // Nose and trailing edge weigh on the faces that close the section, less what these weigh themselves.
    for (first, from, to, at) in [(2_300_001, 0.0, 0.01, 0.01), (2_400_001, 0.97, 1.0, 0.97)] {
        let [low, high] = heights(at);
        let cut = (skin + 0.5) * (arc(0, from, to) + arc(1, from, to)) / (high - low);
        for element in first..first + 6 {
            same(nsm(element), cut - 0.1e-3 * 1900.0, 1e-3, "a closing face");
        }
    }
    assert!((2_500_001..2_500_013).all(|web| nsm(web) == 0.0));
    // Faces that weigh more than what they stand for get nothing.
    let mut heavy = shell();
    heavy.plies[3].thickness_m = Profile(vec![(0.0, 5e-3)]);
    let bulk = cards("heavy", &planform(heavy));
    assert_eq!(bulk.laminates[&bulk.shells[&2_300_001].property].nsm, 0.0);
}

#[test]
fn the_core_fills_the_contour_and_has_its_moduli() {
    let bulk = cards("core", &planform(shell()));
    let core = &bulk.materials[&1];
    assert!(core.e == 4e7 && core.nu == 0.25);
    same(core.g, 4e7 / 2.5, 1e-12, "shear modulus");
    // Thickness 0.3 sqrt(x) (1 - x): area 0.3 (2/3 - 2/5) = 0.08.
    let polygon: f64 = LINES
        .windows(2)
        .map(|p| {
            let thick = |x: f64| heights(x)[1] - heights(x)[0];
            0.5 * (p[1] - p[0]) * (thick(p[0]) + thick(p[1]))
        })
        .sum();
    same(core.rho, 40.0 * 0.08 / polygon, 1e-4, "density");
    // Two stations of cells, four along the chord, three layers; grids layer by layer.
    assert_eq!((bulk.solids.len(), bulk.shells.len()), (24, 16 + 6 + 6 + 12));
    let grid = |line: u32, station: u32, layer: u32| 1_000_001 + (station * 5 + line) * 4 + layer;
    for station in 0..2 {
        for line in 0..4 {
            for layer in 0..3 {
                let id = 1_000_001 + (station * 4 + line) * 3 + layer;
                let face =
                    |layer| [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(l, s)| grid(line + l, station + s, layer));
                assert_eq!(bulk.solids[&id].grids, [face(layer), face(layer + 1)].concat());
            }
        }
    }
    for (line, x) in (0..).zip(LINES) {
        for (station, chord) in (0..).zip([0.8, 0.6, 0.4]) {
            for layer in 0..4_u32 {
                let [low, high] = heights(x);
                let share = f64::from(layer) / 3.0;
                let at = bulk.grids[&grid(line, station, layer)].xyz;
                let expected = Vector3::new(
                    0.2 + (x - 0.25) * chord,
                    f64::from(station),
                    chord * (low + share * (high - low)),
                );
                assert!((at.coords - expected).norm() < 1e-6, "{at} beside {expected}");
            }
        }
    }
}

#[test]
fn cells_may_be_divided_and_webs_stand_on_the_nearest_lines() {
    let mut wing = shell();
    wing.mesh.chordwise_per_box = 2;
    let lines = wing.chord_lines(2);
    let expected = [0.01, 0.255, 0.5, 0.735, 0.97];
    assert!(lines.len() == 5 && lines.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{lines:?}");
    assert_eq!(wing.web_lines(&lines), [3, 1]);
    wing.webs_over_c = vec![0.3, 0.38, 0.62];
    assert_eq!(wing.web_lines(&lines), [1, 2, 3]);
    wing.mesh.spanwise_per_strip = 3;
    wing.webs_over_c = vec![0.26, 0.74];
    let bulk = cards("divided", &planform(wing));
    let axis: Vec<f64> = (0..7).map(|at| bulk.grids[&(FIRST_AXIS_GRID + at)].xyz.y).collect();
    assert!(axis.iter().enumerate().all(|(at, y)| (y - at as f64 / 3.0).abs() < 1e-12), "{axis:?}");
    assert_eq!(MeshCounts::of(&bulk).solids, 6 * 8 * 3);
}

#[test]
fn the_axis_system_runs_along_a_swept_axis() {
    let mut wing = planform(shell());
    (wing.quarter_chord_sweep_deg, wing.dihedral_deg) = (25.0, 10.0);
    let bulk = cards("axis", &wing);
    let nastran::CoordDefinition::Points { a, b, c, .. } = &bulk.coords[&601].definition else {
        panic!("points")
    };
    let (root, tip) = (wing.point(0.0, 0.4), wing.point(2.0, 0.4));
    assert!((a - root).norm() < 1e-12);
    assert!(((c - a) - (tip - root).normalize()).norm() < 1e-12);
    let up = b - a;
    assert!((up.norm() - 1.0).abs() < 1e-12 && up.dot(&(tip - root)).abs() < 1e-12 && up.z > 0.9);
    assert!(up.dot(&(tip - root).cross(&Vector3::z())).abs() < 1e-12);
}

#[test]
fn masses_hang_on_the_corners_of_their_cell_and_lines_on_the_axis() {
    let sensor = |y_m: f64, x_over_c: f64| {
        let mut wing = shell();
        wing.sensors = vec![PointMass { name: "imu".to_owned(), y_m, x_over_c, mass_kg: 0.1 }];
        cards("masses", &planform(wing))
    };
    let corners = |bulk: &BulkData| {
        let mut grids = bulk.averages[&(3_000_000 + FIRST_SENSOR_GRID)].groups[0].grids.clone();
        grids.sort_unstable();
        grids
    };
    let of = |stations: &[u32], lines: [u32; 2]| -> Vec<u32> {
        let at = |station: u32, line: u32| [0, 3].map(|layer| 1_000_001 + (station * 5 + line) * 4 + layer);
        stations.iter().flat_map(|&s| lines.into_iter().flat_map(move |l| at(s, l))).collect()
    };
    // Inside, on an edge, ahead of the first line, behind the last, and at the root, whose rib follows the root.
    for (y, x, stations, lines) in [
        (1.5, 0.6, &[1, 2][..], [2, 3]),
        (1.0, 0.5, &[1, 2], [2, 3]),
        (0.99, 0.499, &[1], [1, 2]),
        (1.5, -0.5, &[1, 2], [0, 1]),
        (2.0, 1.5, &[1, 2], [3, 4]),
        (0.0, 0.0, &[1], [0, 1]),
    ] {
        let bulk = sensor(y, x);
        assert_eq!(corners(&bulk), of(stations, lines), "at {y} m, {x} of the chord");
        assert_eq!(bulk.masses[&(3_200_000 + FIRST_SENSOR_GRID)].grid, FIRST_SENSOR_GRID);
    }
    let wing = planform(shell());
    let bulk = cards("lines", &wing);
    // 0.2 kg/m over 0.5, 1 and 0.5 m, at the middles of these pieces.
    for (at, y, kg, middle) in [(0_u32, 0.0, 0.1, 0.25), (1, 1.0, 0.2, 1.0), (2, 2.0, 0.1, 1.75)] {
        let mass = &bulk.masses[&(3_100_001 + at)];
        same(mass.mass, kg, 1e-12, "a piece of the line");
        assert_eq!(mass.grid, FIRST_AXIS_GRID + at);
        let centre = bulk.grids[&mass.grid].xyz + mass.offset;
        let expected = wing.point(middle, 0.9);
        assert!((centre.xy() - expected.xy()).norm() < 1e-12, "{centre} beside {expected}, axis at {y}");
        same(centre.z, 0.12 * 0.9 * 0.1 * wing.chord_m(middle), 1e-3, "on the camber line");
    }
    // The axis' grids follow all of their station's skin.
    let followed = &bulk.averages[&(3_000_000 + FIRST_AXIS_GRID + 2)].groups[0].grids;
    assert_eq!(followed.len(), 10);
    assert!(!bulk.averages.contains_key(&(3_000_000 + FIRST_AXIS_GRID)));
}

#[test]
fn profiles_are_straight_between_their_pairs_and_constant_beyond() {
    let profile = Profile(vec![(1.0, 2.0), (3.0, 6.0), (4.0, 0.0)]);
    for (y, value) in [(0.0, 2.0), (1.0, 2.0), (1.5, 3.0), (3.0, 6.0), (3.25, 4.5), (4.0, 0.0), (9.0, 0.0)] {
        assert!((profile.at(y) - value).abs() < 1e-12, "{y}: {}", profile.at(y));
    }
    assert_eq!(Profile(Vec::new()).at(1.0), 0.0);
}
