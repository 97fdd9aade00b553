//! The air in motion beside closed forms of thin sections and a published wing.

use std::f64::consts::PI;
use std::path::{Path, PathBuf};
use truth::air::{Harmonic, Lattice, Loads, Memory, Mesh, Motions, Operator};
use truth::wing::{Planform, Section};

use crate::published::case;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/published")
}

/// A section: chord 1, one strip of half a span of 20000 chords.
fn section(chordwise: usize, step_m: f64) -> Lattice {
    let planform = Planform {
        semispan_m: 1e4,
        root_chord_m: 1.0,
        tip_chord_m: 1.0,
        sweep_rad: 0.0,
        root_leading_x_m: 0.0,
    };
    Lattice::new(&planform, &Mesh { chordwise, edges_m: vec![0.0, 1e4], step_m, wake_m: 2000.0 })
}

/// As fine along the chord as the truth's wing is.
const CHORDWISE: usize = 16;
const STEP_M: f64 = 0.1;

fn solved(lattice: &Lattice, wake: bool) -> Operator {
    let mut motions = Motions::default();
    motions.push_strips(lattice, &[1.0], &[0.0]);
    motions.push_pitch(lattice, 0.5);
    motions.push_flap(lattice, (0.0, 1e4), 0.25, 1.0);
    Operator::new(lattice, &[Section::FLAT], &motions, wake)
}

/// Amplitude ratio, and phase of one complex number over another, degrees.
fn apart(found: nalgebra::Complex<f64>, known: nalgebra::Complex<f64>) -> (f64, f64) {
    let ratio = found / known;
    (ratio.norm() - 1.0, ratio.arg().to_degrees())
}

/// Theodorsen (NACA 496): lift of heave h (up) and pitch a about mid-chord, b = 1/2, per q and area:
/// `cl = 2 pi C (a + (b/2) a'/V - h'/V) + pi b (a'/V - h''/V²)`.
#[test]
fn oscillating_sections_have_the_lift_of_theodorsen_up_to_half_a_reduced_frequency() {
    let known = case(&root(), "unsteady2d__theodorsen");
    let lattice = section(CHORDWISE, STEP_M);
    let operator = solved(&lattice, true);
    let (v_m_s, b) = (10.0, 0.5);
    let scale = 0.5 * 1.2 * v_m_s * v_m_s * 1e4;
    for row in known["expected"]["C"].as_array().expect("a list") {
        let number = |name: &str| row[name].as_f64().expect("a number");
        let k = number("k");
        if !(0.02..=0.6).contains(&k) {
            continue;
        }
        let c = nalgebra::Complex::new(number("F"), number("G"));
        let ik = nalgebra::Complex::new(0.0, k);
        let heave = -c * ik * 2.0 * PI / b + PI * k * k / b;
        let pitch = c * (ik * 0.5 + 1.0) * 2.0 * PI + ik * PI;
        for (motion, exact) in [(0, heave), (1, pitch)] {
            let omega = k * v_m_s / b;
            let found = Harmonic::of(&lattice, &operator, motion, 1.2, v_m_s, omega).lift_n[0] / scale;
            let (share, degrees) = apart(found, exact);
            println!("motion {motion} k {k}: {:.2} %, {degrees:.2} degrees", 100.0 * share);
            if k <= 0.5 {
                assert!(
                    share.abs() < 0.01 && degrees.abs() < 1.0,
                    "motion {motion} k {k}: {share} {degrees}"
                );
            }
        }
    }
}

/// A section that begins to meet an incidence: the circulatory lift is Wagner's.
#[test]
fn a_step_of_incidence_gives_the_lift_of_wagner() {
    let known = case(&root(), "unsteady2d__wagner_kussner");
    let lattice = section(CHORDWISE, STEP_M);
    let operator = solved(&lattice, true);
    let mut memory = Memory::new(&operator, &lattice.rows);
    let v_m_s = 10.0;
    let dt = STEP_M / v_m_s;
    let full = PI * v_m_s * v_m_s * 1.2 * 1e4;
    let mut by_step = Vec::new();
    for step in 0..520 {
        // downwash by a rate of heave that begins and stays: no slope, so no second impulse after the first step
        let (part, mut rate) = memory.begin(dt);
        let own = operator.by_motion.column(operator.motions) * -v_m_s;
        let state = part + &own;
        if step < 3 {
            rate *= 0.0;
        }
        let circulation: Vec<f64> = state.rows(0, 1).iter().copied().collect();
        by_step.push(Loads::of(&lattice, 1.2, v_m_s, &state, &rate).lift_n[0] / full);
        memory.end(&circulation);
    }
    for row in known["expected"]["wagner"].as_array().expect("a list") {
        let number = |name: &str| row[name].as_f64().expect("a number");
        // semi-chords travelled; the motion begins within the first step
        let place = number("s") * 0.5 / STEP_M - 0.5;
        if !(9.0..=510.0).contains(&place) {
            continue;
        }
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a small positive number"
        )]
        let before = place.floor() as usize;
        let share = place - place.floor();
        let found = by_step[before] * (1.0 - share) + by_step[before + 1] * share;
        println!("s {}: {found:.4} {:.4}", number("s"), number("phi"));
        assert!((found / number("phi") - 1.0).abs() < 0.01, "s {}: {found}", number("s"));
    }
}

/// Still air: the apparent mass of a plate is that of the air in a circle around it, and acts at mid-chord.
#[test]
fn a_plate_in_still_air_carries_the_air_of_a_circle() {
    let lattice = section(64, STEP_M);
    let operator = solved(&lattice, false);
    let by_rate: nalgebra::DVector<f64> = operator.by_motion.column(operator.motions).into_owned();
    let none = &by_rate * 0.0;
    let loads = Loads::of(&lattice, 1.2, 0.0, &none, &by_rate);
    let mass = -loads.lift_n[0] / (1.2 * PI * 0.25 * 1e4);
    let place = -loads.moment_n_m[0] / loads.lift_n[0] + 0.25;
    println!("apparent mass {mass:.4} of a circle's, at {place:.4} of the chord");
    assert!((mass - 1.0).abs() < 0.03, "{mass}");
    assert!((place - 0.5).abs() < 0.02, "{place}");
}

/// A flap of a quarter of the chord, slowly moved (Glauert): with the hinge at `x = (1 - cos t)/2` of the chord the lift is
/// `2 (pi - t + sin t)`, the moment about the quarter chord `-sin t (1 - cos t)/2`.
#[test]
fn a_slow_flap_has_the_lift_of_thin_sections() {
    let lattice = section(CHORDWISE, STEP_M);
    let operator = solved(&lattice, true);
    let state = operator.at_rest(2, 1.0);
    let none = &state * 0.0;
    let loads = Loads::of(&lattice, 2.0, 1.0, &state, &none);
    let theta = (1.0_f64 - 2.0 * 0.75).acos();
    let lift = 2.0 * (PI - theta + theta.sin());
    let moment = -0.5 * theta.sin() * (1.0 - theta.cos());
    let found = (loads.lift_n[0] / 1e4, loads.moment_n_m[0] / 1e4);
    println!("flap: lift {:.4} {lift:.4}, moment {:.4} {moment:.4}", found.0, found.1);
    assert!((found.0 / lift - 1.0).abs() < 0.01, "{} {lift}", found.0);
    assert!((found.1 / moment - 1.0).abs() < 0.02, "{} {moment}", found.1);
}

/// A rectangular wing of aspect ratio 20 that pitches about mid-chord, by doublet lattices (van Zyl 2003; NASTRAN-95).
#[test]
fn a_wing_of_aspect_ratio_20_pitches_as_doublet_lattices_say() {
    let known = case(&root(), "dlm__dlm_vanzyl_AR20_pitch");
    let planform = Planform {
        semispan_m: 5.0,
        root_chord_m: 0.5,
        tip_chord_m: 0.5,
        sweep_rad: 0.0,
        root_leading_x_m: 0.0,
    };
    let edges_m = (0..=40).map(|place| 0.125 * f64::from(place)).collect();
    let lattice = Lattice::new(&planform, &Mesh { chordwise: 10, edges_m, step_m: 0.04, wake_m: 100.0 });
    let mut motions = Motions::default();
    motions.push_pitch(&lattice, 0.25);
    let sections = vec![Section::FLAT; lattice.strips.len()];
    let operator = Operator::new(&lattice, &sections, &motions, true);
    for row in known["expected"]["nastran95_parabolic"].as_array().expect("a list") {
        let [kr, re, im] = [0, 1, 2].map(|place| row[place].as_f64().expect("a number"));
        if kr > 1.0 {
            continue;
        }
        let found = Harmonic::of(&lattice, &operator, 0, 2.0, 1.0, kr / 0.5);
        let lift = found.lift_n.iter().sum::<nalgebra::Complex<f64>>() / 2.5;
        let (share, degrees) = apart(lift, nalgebra::Complex::new(re, im));
        println!("omega c/V {kr}: {:.2} %, {degrees:.2} degrees", 100.0 * share);
        assert!(share.abs() < 0.02 && degrees.abs() < 1.0, "{kr}: {share} {degrees}");
    }
}
