//! The Pazy wing under a weight on its tip: the equivalent beams of Riso and Cesnik beside their program (UM/NAST, a geometrically
//! exact beam).

use crate::large::{numbers, published, share_off};
use crate::pazy_beam::{AXIS_M, CHORD_M};
use nalgebra::Vector3;
use structure::nonlinear::{LargeDeflection, Loads, NodeLoad, State};

const SEMISPAN_M: f64 = 0.55;
const G_M_S2: f64 = 9.81;

/// Place of a point of the tip's chord, from the leading edge, m.
fn tip(state: &State, chord: f64) -> Vector3<f64> {
    state.places[15] + state.rotations[15] * Vector3::new(chord - AXIS_M, 0.0, 0.0)
}

#[test]
fn the_wing_without_skin_bends_and_twists_under_a_weight_behind_its_tip() {
    let case = published("nl_pazy__static_torsion_skin0");
    let wing = LargeDeflection::new(&crate::pazy_beam::beam(false, Some(0.04))).expect("a beam");
    let weight = Loads { gravity_m_s2: Vector3::new(0.0, 0.0, -G_M_S2), ..Loads::default() };
    let sag = wing.under(&weight).expect("its own weight").end().state.clone();
    let rows = |name: &str| -> Vec<Vec<f64>> {
        case["expected"][name].as_array().expect("rows").iter().map(numbers).collect()
    };
    let twist = |state: &State| {
        let chord = tip(state, 0.0) - tip(state, CHORD_M);
        (chord.z / chord.norm()).asin().to_degrees()
    };
    let (mut worst_z, mut worst_twist): (f64, f64) = (0.0, 0.0);
    for (place, turned) in
        rows("UMNAST_z_y_x").iter().zip(rows("UMNAST_twist_deg")).filter(|(p, _)| p[0] > 0.0)
    {
        let force = Vector3::new(0.0, 0.0, -place[0] * G_M_S2);
        let load = NodeLoad { node: 16, force, moment: Vector3::zeros() };
        let loads = Loads { dead: vec![load], ..weight.clone() };
        let end = wing.under(&loads).expect("the weight is carried").end().state.clone();
        let moved = (tip(&end, 0.5 * CHORD_M) - tip(&sag, 0.5 * CHORD_M)) * (100.0 / SEMISPAN_M);
        let axis = (end.places[15] - sag.places[15]) * (100.0 / SEMISPAN_M);
        let angle = twist(&end) - twist(&sag);
        println!(
            "{:.2} kg: z {:.3} (axis {:.3}) for {:.3}, y {:.3} ({:.3}) for {:.3}, x {:.3} ({:.3}) for {:.3}; twist {angle:.3} for {:.3}",
            place[0],
            moved.z,
            axis.z,
            place[1],
            moved.y,
            axis.y,
            place[2],
            moved.x,
            axis.x,
            place[3],
            turned[1]
        );
        worst_z = worst_z.max(share_off(moved.z, place[1]));
        worst_twist = worst_twist.max(share_off(angle, turned[1]));
    }
    println!("largest differences from UM/NAST: z {worst_z:.4}, twist {worst_twist:.4}");
    assert!(worst_z < 0.005 && worst_twist < 0.02, "z {worst_z}, twist {worst_twist}");
}

#[test]
fn the_wing_with_skin_bends_under_a_weight_on_its_tip() {
    let case = published("nl_pazy__static_bending_skin1");
    let wing = LargeDeflection::new(&crate::pazy_beam::beam(true, Some(-0.5 * CHORD_M))).expect("a beam");
    let weight = Loads { gravity_m_s2: Vector3::new(0.0, 0.0, -G_M_S2), ..Loads::default() };
    let sag = wing.under(&weight).expect("its own weight").end().state.clone();
    let (mut worst_z, mut worst_y): (f64, f64) = (0.0, 0.0);
    for row in case["expected"]["UMNAST_beam_z_y"].as_array().expect("rows").iter().map(numbers) {
        let [mass_kg, z, y] = row[..] else { panic!("three columns") };
        if mass_kg == 0.0 {
            continue;
        }
        let force = Vector3::new(0.0, 0.0, -mass_kg * G_M_S2);
        let load = NodeLoad { node: 16, force, moment: Vector3::zeros() };
        let end =
            wing.under(&Loads { dead: vec![load], ..weight.clone() }).expect("carried").end().state.clone();
        let moved = (end.places[15] - sag.places[15]) * (100.0 / SEMISPAN_M);
        println!("{mass_kg} kg: z {:.3} for {z}, y {:.3} for {y}", moved.z, moved.y);
        worst_z = worst_z.max(share_off(moved.z, z));
        if mass_kg >= 1.0 {
            worst_y = worst_y.max(share_off(moved.y, y));
        }
    }
    println!("largest differences from UM/NAST: z {worst_z:.4}, y from 1 kg on {worst_y:.4}");
    assert!(worst_z < 0.005 && worst_y < 0.01, "z {worst_z}, y {worst_y}");
}
