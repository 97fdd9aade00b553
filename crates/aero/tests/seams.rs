//! Boxes that were moved one by one, beside the lattice that is laid out where they ought to be.

use aero::{AeroBox, Lattice, MirrorPlane, Seams, SteadyAero, incidence};
use nalgebra::{Rotation3, Vector3};

const SPAN_M: f64 = 1.8;
const STRIPS: u32 = 56;
const PLANE: MirrorPlane = MirrorPlane::Symmetric { y_m: 0.0 };

/// A wing of strips ten times as narrow as its chord.
fn wing(span_m: f64) -> Lattice {
    Lattice::trapezoid(1, [0.0; 3], 0.3, [0.2, span_m, 0.0], 0.3, [6, STRIPS]).expect("boxes")
}

/// The mean of the pressures in each strip.
fn strips(cp: &[f64]) -> Vec<f64> {
    cp.chunks_exact(6).map(|strip| strip.iter().sum::<f64>() / 6.0).collect()
}

/// The strips of a lattice, each moved as a rigid body.
fn moved(lattice: &Lattice, of_strip: impl Fn(usize, &AeroBox) -> AeroBox) -> Lattice {
    let boxes = lattice.boxes.iter().enumerate().map(|(j, panel)| of_strip(j / 6, panel)).collect();
    Lattice { boxes, surfaces: lattice.surfaces.clone() }
}

#[test]
fn strips_that_come_apart_or_overlap_a_little_carry_what_the_whole_surface_carries() {
    let plain = wing(SPAN_M);
    let seams = Seams::of(&plain, PLANE);
    for share in [0.0015, -0.0015] {
        let gap_m = share * SPAN_M / f64::from(STRIPS);
        let apart = moved(&plain, |strip, panel| {
            let shift = Vector3::new(0.0, gap_m * (strip as f64 + 0.5), 0.0);
            AeroBox { id: panel.id, corners: panel.corners.map(|corner| corner + shift) }
        });
        let own = SteadyAero::moved(&apart, &seams, PLANE, 0.0).expect("boxes");
        let own = strips(&own.pressures_of(&incidence::angle_of_attack(&apart)));
        // The wing that is so much longer, in one piece.
        let whole = wing(SPAN_M * (1.0 + share));
        let of = SteadyAero::new(&whole, PLANE, 0.0).expect("boxes");
        let of = strips(&of.pressures_of(&incidence::angle_of_attack(&whole)));
        for (strip, (own, of)) in own.iter().zip(&of).enumerate() {
            assert!((own / of - 1.0).abs() < 1e-3, "strip {strip} apart by {share}: {own} for {of}");
        }
    }
}

#[test]
fn strips_that_turn_with_a_twist_carry_what_small_twist_says() {
    let plain = wing(SPAN_M);
    let seams = Seams::of(&plain, PLANE);
    // To 3 degrees at the tip about a line behind the trailing edge, so that the edges of strips move up and down and apart.
    let twist = |strip: usize| 3.0_f64.to_radians() * (strip as f64 + 0.5) / f64::from(STRIPS);
    let turned = moved(&plain, |strip, panel| {
        let turn = Rotation3::from_axis_angle(&Vector3::y_axis(), twist(strip));
        AeroBox { id: panel.id, corners: panel.corners.map(|corner| turn * corner) }
    });
    let w: Vec<f64> = turned.boxes.iter().map(|panel| panel.normal().x).collect();
    let own = SteadyAero::moved(&turned, &seams, PLANE, 0.0).expect("boxes").pressures_of(&w);
    let flat = SteadyAero::new(&plain, PLANE, 0.0).expect("boxes").pressures_of(&w);
    let lift = |cp: &[f64]| cp.iter().sum::<f64>();
    let share = lift(&own) / lift(&flat);
    assert!((share - 1.0).abs() < 0.005, "lift of the twisted surface over that of its twist alone: {share}");
}
