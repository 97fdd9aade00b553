//! The Pazy wing without skin in steady air.

#![expect(clippy::expect_used, unreachable_pub, reason = "helpers of the tests in this folder")]
#![allow(dead_code, reason = "not every test file uses every helper")]

#[path = "../../../structure/tests/large/pazy_beam.rs"]
mod pazy_beam;

use aero::{Lattice, MirrorPlane};
use coupling::{Balance, ElasticWing, LargeWing, Spline, SplineKind, SupportedStructure, WingParts};
use nalgebra::{Matrix3, Point3, Vector3};
use pazy_beam::{AXIS_M, CHORD_M};
use std::sync::Arc;
use structure::{PointMass, System};

/// Semispan, m.
pub const SEMISPAN_M: f64 = 0.55;

/// [`without_skin_with`] no mass more.
pub fn without_skin(divisions: [u32; 2], plane: MirrorPlane) -> LargeWing {
    without_skin_with(divisions, plane, None)
}

/// The wing without skin under a lattice of the source's size, `divisions` along chord and span, without weight; a mass
/// (kg) so many m behind the trailing edge of the tip.
pub fn without_skin_with(divisions: [u32; 2], plane: MirrorPlane, mass: Option<(f64, f64)>) -> LargeWing {
    let mut model = pazy_beam::beam(None);
    if let Some((kg, aft_m)) = mass {
        let arm = Vector3::new(CHORD_M + aft_m - AXIS_M, 0.0, 0.0);
        model.elements.push(Arc::new(PointMass::new(1000, 15, kg, &arm, &Matrix3::zeros())));
    }
    let system = System::assemble(&model).expect("a beam");
    let (edge, chord) = (AXIS_M - 0.441 * 0.0989, 0.0989);
    let lattice =
        Lattice::trapezoid(1001, [edge, 0.00215, 0.0], chord, [edge, SEMISPAN_M, 0.0], chord, divisions)
            .expect("boxes");
    let nodes: Vec<usize> = (0..16).collect();
    let spline = Spline::beam(&lattice, system.points(), &nodes);
    let point = Point3::new(AXIS_M, 0.0, 0.0);
    let supported = SupportedStructure::new(&system, &spline, 15, &point).expect("held");
    let boxes = lattice.len();
    let elastic = ElasticWing::new(WingParts {
        lattice,
        controls: Vec::new(),
        balance: Balance { point, metric: vec![true; boxes] },
        plane,
        mach: 0.0,
        fairing_surfaces: Vec::new(),
        camber: vec![0.0; boxes],
        supported: Some(supported),
        structure: Some((system, spline)),
    })
    .expect("a wing");
    let wing = LargeWing::new(elastic, &model, SplineKind::Beam, &nodes).expect("a wing");
    wing.weightless().expect("at rest")
}
