//! The lattice at rest beside published lift slopes, and tables that another program computed.

use std::path::{Path, PathBuf};
use truth::air::{Harmonic, Lattice, Loads, Mesh, Motions, Operator};
use truth::wing::{Planform, Section};

use crate::published::case;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/published")
}

/// Lift slope and moment slope about the root's leading edge of a flat half wing beside its plane of symmetry, over its area.
fn slopes(planform: &Planform, chordwise: usize, edges_m: Vec<f64>) -> (f64, f64) {
    let lattice = Lattice::new(planform, &Mesh { chordwise, edges_m, step_m: 0.05, wake_m: 30.0 });
    let mut motions = Motions::default();
    motions.push_pitch(&lattice, 0.0);
    let sections = vec![Section::FLAT; lattice.strips.len()];
    let operator = Operator::new(&lattice, &sections, &motions, true);
    let state = operator.at_rest(0, 1.0);
    let none = &state * 0.0;
    let [lift, _, moment] = Loads::of(&lattice, 2.0, 1.0, &state, &none).at_balance(&lattice, 0.0);
    // the steady limit of the stepped equations is the same
    let slow = Harmonic::of(&lattice, &operator, 0, 2.0, 1.0, 1e-9).at_balance(&lattice, 0.0);
    assert!((slow[0].re / lift - 1.0).abs() < 1e-6);
    (lift / planform.area_m2(), moment / planform.area_m2())
}

fn even(end_m: f64, count: usize) -> Vec<f64> {
    (0..=count).map(|place| end_m * place as f64 / count as f64).collect()
}

#[test]
fn the_wing_of_warren_has_its_published_slopes() {
    let known = case(&root(), "vlm__warren12");
    let number = |name: &str| known["expected"][name].as_f64().expect("a number");
    let leading = 53.54_f64.to_radians().tan();
    let semispan_m = 0.5 * known["inputs"]["b"].as_f64().expect("a number");
    let sweep_rad = (leading + 0.25 * (0.5 - 1.5) / semispan_m).atan();
    let planform =
        Planform { semispan_m, root_chord_m: 1.5, tip_chord_m: 0.5, sweep_rad, root_leading_x_m: 0.0 };
    // the tolerances are the published case's, for this mesh
    let (lift, moment) = slopes(&planform, 12, even(semispan_m, 24));
    println!("Warren: {lift:.4} {moment:.4}");
    assert!((lift / number("CLalpha") - 1.0).abs() < 0.015, "{lift}");
    assert!((moment / number("CMalpha") - 1.0).abs() < 0.020, "{moment}");
}

/// Bound vortex and point are those of horseshoes: with one ring along the chord and a steady wake both are the same.
#[test]
fn tables_of_another_vortex_lattice_are_met() {
    let known = case(&root(), "vlm__vlm_own_tables");
    let mut met = 0;
    for row in known["expected"].as_array().expect("a list") {
        let number = |name: &str| row[name].as_f64().expect("a number");
        if number("mach") != 0.0 || row["spacing"] != "uniform" {
            continue;
        }
        let (semispan_m, tip_chord_m) = (number("semispan"), number("c_tip"));
        let root_chord_m = number("c_root");
        let quarter = number("xLE_tip") + 0.25 * (tip_chord_m - root_chord_m);
        let sweep_rad = (quarter / semispan_m).atan();
        let planform = Planform { semispan_m, root_chord_m, tip_chord_m, sweep_rad, root_leading_x_m: 0.0 };
        let counts = [number("nchord"), number("nspan_half")].map(|count| {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small count")]
            let count = count as usize;
            count
        });
        let (lift, _) = slopes(&planform, counts[0], even(semispan_m, counts[1]));
        let off = lift / number("CLalpha") - 1.0;
        println!("{} {counts:?}: {off:.1e}", row["planform"]);
        assert!(off.abs() < 1e-8, "{} {counts:?}: {lift} {}", row["planform"], number("CLalpha"));
        met += 1;
    }
    assert!(met > 5);
}

/// A section with a polar in an infinite wing: its lift is the polar's, whatever the lattice.
#[test]
fn a_section_of_an_endless_wing_has_the_lift_of_its_polar() {
    let planform = Planform {
        semispan_m: 1e5,
        root_chord_m: 1.0,
        tip_chord_m: 1.0,
        sweep_rad: 0.0,
        root_leading_x_m: 0.0,
    };
    let mesh = Mesh { chordwise: 6, edges_m: vec![0.0, 1e5], step_m: 0.1, wake_m: 100.0 };
    let lattice = Lattice::new(&planform, &mesh);
    let mut motions = Motions::default();
    motions.push_pitch(&lattice, 0.0);
    for slope_per_rad in [5.2, 6.9] {
        let section = Section { slope_per_rad, ..Section::FLAT };
        let operator = Operator::new(&lattice, &[section], &motions, true);
        let state = operator.at_rest(0, 1.0);
        let lift = Loads::of(&lattice, 2.0, 1.0, &state, &(&state * 0.0)).lift_n[0] / 1e5;
        assert!((lift / slope_per_rad - 1.0).abs() < 1e-4, "{lift} {slope_per_rad}");
    }
}

/// A rectangular wing does not know where its wall's coordinate is counted from.
#[test]
fn a_wall_elsewhere_is_the_same_wall() {
    let lift = |wall_m: f64| {
        let semispan_m = 1.5 + wall_m;
        let planform = Planform {
            semispan_m,
            root_chord_m: 0.5,
            tip_chord_m: 0.5,
            sweep_rad: 0.0,
            root_leading_x_m: 0.0,
        };
        let edges_m = even(1.5, 12).iter().map(|edge| edge + wall_m).collect();
        let lattice = Lattice::new(&planform, &Mesh { chordwise: 4, edges_m, step_m: 0.05, wake_m: 20.0 });
        let mut motions = Motions::default();
        motions.push_pitch(&lattice, 0.0);
        let sections = vec![Section::FLAT; lattice.strips.len()];
        let state = Operator::new(&lattice, &sections, &motions, true).at_rest(0, 1.0);
        Loads::of(&lattice, 2.0, 1.0, &state, &(&state * 0.0)).lift_n.sum()
    };
    assert!((lift(-0.4) / lift(0.0) - 1.0).abs() < 1e-9, "{} {}", lift(-0.4), lift(0.0));
}
