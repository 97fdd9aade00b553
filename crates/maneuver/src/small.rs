//! Small wings for tests: that of Goland (J. Appl. Mech., 1945) under few boxes, and rigid ones.

use aero::{Lattice, MirrorPlane};
use coupling::{Balance, ElasticWing, LargeWing, WingParts};
use nalgebra::Point3;

#[path = "../../coupling/tests/large/mod.rs"]
mod large;

/// Chord, m.
pub(crate) const CHORD_M: f64 = 1.8288;

/// Uniform, centre of mass a tenth of the chord behind the elastic axis, in four beams.
pub(crate) fn goland() -> LargeWing {
    let (length, beams) = (6.096, 4);
    let station = |at: usize| {
        let reach = length / f64::from(beams) * if at == 0 || at == 4 { 0.5 } else { 1.0 };
        let mut row = vec![length * at as f64 / f64::from(beams), 1e10, 0.987e6, 9.77e6, 1e10];
        row.extend([0.0; 6]);
        row.extend([35.71 * reach, 0.1 * CHORD_M, 0.0, 0.0, 0.0, 7.44 * reach, 7.44 * reach]);
        row
    };
    let rows: Vec<Vec<f64>> = (0..=4).map(station).collect();
    let flat = large::Flat {
        axis: 0.33,
        chord_m: CHORD_M,
        inner_m: 0.0,
        sweep_rad: 0.0,
        divisions: [2, 4],
        plane: MirrorPlane::Symmetric { y_m: 0.0 },
    };
    large::flat_wing(&large::pazy_beam::swept(&rows, 0.33 * CHORD_M, 0.0), &flat)
}

/// A rigid wing of chord 1.8288 m with boxes along chord and span, and an incidence of its own on each.
pub(crate) fn rigid(divisions: [u32; 2], camber: impl Fn(usize) -> f64) -> ElasticWing {
    let chord = CHORD_M;
    let lattice =
        Lattice::trapezoid(1001, [0.0, 0.0, 0.0], chord, [0.0, 6.096, 0.0], chord, divisions).expect("boxes");
    let boxes = lattice.len();
    ElasticWing::new(WingParts {
        lattice,
        controls: Vec::new(),
        balance: Balance { point: Point3::new(0.6, 0.0, 0.0), metric: vec![true; boxes] },
        plane: MirrorPlane::Symmetric { y_m: 0.0 },
        mach: 0.0,
        fairing_surfaces: Vec::new(),
        camber: (0..boxes).map(camber).collect(),
        supported: None,
        structure: None,
    })
    .expect("a wing")
}
