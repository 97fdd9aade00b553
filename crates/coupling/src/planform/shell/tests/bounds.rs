//! What is refused of a shell-and-solid wing just beyond each bound.

use crate::planform::shell::samples::{planform, shell};
use crate::planform::{Planform, Profile, ShellSolid, Structure, Surface};
use nastran::Span;

/// What is said of a wing after a change.
fn said(change: impl Fn(&mut Planform, &mut ShellSolid)) -> String {
    let mut shell = shell();
    let mut wing = planform(shell.clone());
    change(&mut wing, &mut shell);
    wing.structure = Some(Structure::ShellSolid(Box::new(shell)));
    let span = Span::generated("a test");
    wing.check().err().map(|fault| fault.at(&span).to_string()).unwrap_or_default()
}

/// A number, how it is set, values that may be, values that may not, and a word of what is said.
type Bound = (fn(&mut Planform, &mut ShellSolid, f64), &'static [f64], &'static [f64], &'static str);

const BOUNDS: &[Bound] = &[
    (|_, s, v| s.elastic_axis_over_c = v, &[0.0, 1.0], &[-0.01, 1.01, f64::NAN], "elastic_axis_over_c"),
    (|_, s, v| s.finish_kg_m2 = v, &[0.0, 100.0], &[-0.01, 100.1], "finish_kg_m2"),
    (|_, s, v| s.line_masses[0].mass_kg_m = v, &[0.0, 1e3], &[-0.1, 1001.0], "cable"),
    (|_, s, v| s.line_masses[0].x_over_c = v, &[-1.0, 2.0], &[-1.01, 2.01], "cable"),
    (|_, s, v| s.balance_stiffness.0 = v, &[1e-3], &[0.0, -1.0, f64::INFINITY], "balance_stiffness"),
    (|_, s, v| s.balance_stiffness.5 = v, &[1e-3], &[0.0, -1.0, f64::NAN], "balance_stiffness"),
    (|_, s, v| s.materials[1].e1_pa = v, &[1e13, 1e9], &[0.0, -1.0, 1.1e13], "uni"),
    (|_, s, v| (s.materials[1].e2_pa, s.materials[1].nu12) = (v, 0.0), &[1e13, 1.0], &[0.0, 1.1e13], "uni"),
    (|_, s, v| s.materials[1].g12_pa = v, &[1e13, 1.0], &[0.0, 1.1e13], "uni"),
    (|_, s, v| s.materials[1].rho_kg_m3 = v, &[0.0, 1e5], &[-1.0, 1.1e5], "uni"),
    // The contraction squared is less than e1/e2, four.
    (
        |_, s, v| (s.materials[1].e1_pa, s.materials[1].e2_pa, s.materials[1].nu12) = (4e9, 1e9, v),
        &[1.99, -1.99],
        &[2.0, -2.0, 3.0],
        "uni",
    ),
    (|_, s, v| s.foam.e_pa = v, &[1e13, 1.0], &[0.0, -1.0, 1.1e13], "foam"),
    (|_, s, v| s.foam.nu = v, &[-0.999, 0.499], &[-1.0, 0.5, 1.0], "foam"),
    (|_, s, v| s.foam.rho_kg_m3 = v, &[0.0, 1e5], &[-1.0, 1.1e5], "foam"),
    (
        |_, s, v| s.plies[0].thickness_m = Profile(vec![(0.0, v)]),
        &[0.1, 1e-4],
        &[0.11, -0.1, f64::NAN],
        "thickness of ply 1",
    ),
    (
        |_, s, v| s.plies[0].thickness_m = Profile(vec![(0.0, 1e-3), (v, 1e-3)]),
        &[0.1],
        &[0.0, -1.0, f64::INFINITY],
        "thickness of ply 1",
    ),
    (|_, s, v| s.plies[0].angle_deg = v, &[-720.0, 33.0], &[f64::NAN, f64::INFINITY], "ply 1"),
    (|_, s, v| s.mesh.edges_over_c.0 = v, &[0.0, 0.04], &[-0.01, 0.25], "edges_over_c"),
    (|_, s, v| s.mesh.edges_over_c.1 = v, &[0.95, 1.0], &[0.75, 1.01], "edges_over_c"),
    // Where the chord is 0.4 m a band of 0.06 m is 0.15 wide.
    (
        |_, s, v| {
            if let Some(band) = &mut s.plies[1].band {
                band.centre_over_c = v;
            }
        },
        &[0.1, 0.3, 0.7],
        &[0.05, 0.9],
        "ply 2",
    ),
    (
        |_, s, v| {
            if let Some(band) = &mut s.plies[1].band {
                band.width_m = Profile(vec![(0.0, v)]);
            }
        },
        &[0.0, 0.09],
        &[-0.1, 1.1e4, 0.1],
        "ply 2",
    ),
    (
        |w, s, v| {
            if let Some(band) = &mut s.plies[1].band {
                (w.tip_chord_m, band.centre_over_c, band.width_m) = (0.8, v, Profile(vec![(0.0, 0.4)]));
            }
        },
        &[0.2601, 0.7199],
        &[0.2599, 0.7201],
        "ply 2",
    ),
];

#[test]
fn numbers_at_their_bounds_are_taken_and_beyond_them_refused() {
    for (set, good, bad, word) in BOUNDS {
        let with = |value: f64| {
            said(|wing, shell| {
                if let Some(band) = &mut shell.plies[1].band {
                    band.width_m = Profile(vec![(0.0, 0.06)]);
                }
                set(wing, shell, value);
            })
        };
        for value in *good {
            assert_eq!(with(*value), "", "{word} {value}");
        }
        for value in *bad {
            assert!(with(*value).contains(word), "{word} {value}: {}", with(*value));
        }
    }
}

/// What is said after a change of the sample with a narrow cap.
fn with(change: &dyn Fn(&mut Planform, &mut ShellSolid)) -> String {
    said(|wing, shell| {
        if let Some(band) = &mut shell.plies[1].band {
            band.width_m = Profile(vec![(0.0, 0.06)]);
        }
        change(wing, shell);
    })
}

fn tells(what: &str, said: &str, word: &str) {
    assert!(said.contains(word) && said.is_empty() == word.is_empty(), "{what}: {said}");
}

#[test]
fn meshes_of_no_or_too_many_elements_are_refused() {
    assert_eq!(with(&|_, _| ()), "");
    let mesh = |per_strip: usize, per_box: usize, layers: usize| {
        with(&|_, s| {
            (s.mesh.spanwise_per_strip, s.mesh.chordwise_per_box, s.mesh.thickness) =
                (per_strip, per_box, layers);
        })
    };
    // Two strips of four boxes.
    for (strip, per_box, layers, word) in [
        (1, 1, 1, ""),
        (100, 1, 100, ""),
        (1, 100, 100, ""),
        (0, 1, 1, "spanwise_per_strip is 0"),
        (101, 1, 1, "spanwise_per_strip is 101"),
        (1, 0, 1, "chordwise_per_box is 0"),
        (1, 101, 1, "chordwise_per_box is 101"),
        (1, 1, 0, "thickness is 0"),
        (1, 1, 101, "thickness is 101"),
        (100, 2, 100, "160000 solids and 200 stations"),
    ] {
        tells(&format!("{strip} {per_box} {layers}"), &mesh(strip, per_box, layers), word);
    }
    let stations = |strips: usize, per_strip: usize| {
        with(&|wing, s| {
            (wing.boxes.spanwise, s.mesh.spanwise_per_strip, s.mesh.thickness) = (strips, per_strip, 1);
        })
    };
    assert_eq!(stations(633, 3), "");
    assert!(stations(475, 4).contains("1900 stations"));
    // 99999 = 9 x 11111 = 9 x 41 x 271 solids, and one layer more than that.
    let solids = |strips: usize, boxes: usize| {
        with(&|wing, s| {
            (wing.boxes.spanwise, wing.boxes.chordwise, s.mesh.thickness) = (strips, boxes, 9);
            (s.webs_over_c, s.mesh.edges_over_c) = (vec![0.25, 0.75], (0.0, 1.0));
        })
    };
    assert_eq!(solids(271, 41), "");
    assert!(solids(278, 40).contains("100080 solids"));
}

#[test]
fn webs_plies_and_names_that_cannot_be_are_refused() {
    for (webs, word) in [
        (vec![0.25, 0.75], ""),
        (vec![0.25, 0.27], "no separate chord lines"),
        (vec![0.25, 0.1], "no separate chord lines"),
        (vec![0.9, 0.25], "no separate chord lines"),
        (vec![1.1], "no separate chord lines"),
        (vec![-0.1], "no separate chord lines"),
        (vec![], "do not go together"),
    ] {
        tells(&format!("{webs:?}"), &with(&|_, s| s.webs_over_c.clone_from(&webs)), word);
    }
    let one = |what: &str, change: &dyn Fn(&mut ShellSolid), word: &str| {
        tells(what, &with(&|_, s| change(s)), word);
    };
    one(
        "webs' plies alone",
        &|s| s.plies.retain(|ply| !ply.on.contains(&Surface::Webs)),
        "do not go together",
    );
    one(
        "neither",
        &|s| {
            s.plies.retain(|ply| !ply.on.contains(&Surface::Webs));
            s.webs_over_c.clear();
        },
        "",
    );
    one("bare lower skin", &|s| s.plies[0].on = vec![Surface::Upper], "no ply covers Lower at y = 0.000 m");
    one(
        "bare tip",
        &|s| s.plies[0].thickness_m = Profile(vec![(0.0, 1e-3), (2.0, 0.0)]),
        "covers Upper at y = 2.000",
    );
    one("bare webs", &|s| s.plies[2].thickness_m = Profile(vec![(0.0, 0.0)]), "no ply covers Webs");
    one("no faces", &|s| s.plies.truncate(3), "");
    one("nowhere", &|s| s.plies[3].on.clear(), "ply 4 lies nowhere");
    one("no thickness", &|s| s.plies[3].thickness_m = Profile(Vec::new()), "thickness of ply 4");
    one("unknown", &|s| s.plies[3].material = "none".into(), "no material is called \"none\"");
    one("twice", &|s| s.materials[1].name = "cloth".into(), "two materials are called");
    one("no name", &|s| s.materials[1].name.clear(), "two materials are called");
    one("no such cap", &|s| s.plies[1].on = vec![Surface::Upper, Surface::Webs], "band off the skin");
    tells("no section", &with(&|wing, _| wing.airfoil = None), "needs an airfoil");
    assert!(said(|_, s| s.sensors[0].y_m = 2.01).contains("imu has y_m 2.01"));
}
