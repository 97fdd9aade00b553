//! The Pazy wing in steady air, with its skin and without, straight and swept, and wings made the same way.

#![expect(clippy::expect_used, unreachable_pub, reason = "helpers of the tests in this folder")]
#![allow(dead_code, reason = "not every test file uses every helper")]

#[path = "../../../structure/tests/large/pazy_beam.rs"]
pub mod pazy_beam;

use aero::{Lattice, MirrorPlane};
use coupling::{Balance, ElasticWing, LargeWing, Spline, SplineKind, SupportedStructure, WingParts};
use nalgebra::{Matrix3, Vector3};
use pazy_beam::{AXIS_M, CHORD_M, stations, swept};
use std::sync::Arc;
use structure::{Model, PointMass, System};

/// Semispan, m.
pub const SEMISPAN_M: f64 = 0.55;

/// [`without_skin_with`] no mass more.
pub fn without_skin(divisions: [u32; 2], plane: MirrorPlane) -> LargeWing {
    without_skin_with(divisions, plane, None)
}

/// The wing without skin under a lattice of the source's size, `divisions` along chord and span, without weight; a mass
/// (kg) so many m behind the trailing edge of the tip.
pub fn without_skin_with(divisions: [u32; 2], plane: MirrorPlane, mass: Option<(f64, f64)>) -> LargeWing {
    let mut model = pazy_beam::beam(false, None);
    if let Some((kg, aft_m)) = mass {
        let arm = Vector3::new(CHORD_M + aft_m - AXIS_M, 0.0, 0.0);
        model.elements.push(Arc::new(PointMass::new(1000, 15, kg, &arm, &Matrix3::zeros())));
    }
    flat_wing(
        &model,
        &Flat { axis: 0.441, chord_m: 0.0989, inner_m: 0.00215, sweep_rad: 0.0, divisions, plane },
    )
}

/// The wing with skin, turned aft in its plane with its boxes, without weight.
pub fn with_skin(divisions: [u32; 2], sweep_rad: f64) -> LargeWing {
    let model = swept(&stations(true), AXIS_M, sweep_rad);
    let plane = MirrorPlane::Symmetric { y_m: 0.0 };
    flat_wing(&model, &Flat { axis: 0.441, chord_m: 0.0989, inner_m: 0.00215, sweep_rad, divisions, plane })
}

/// The boxes of a plane wing of one chord on a straight axis.
#[derive(Debug)]
pub struct Flat {
    /// Of the axis behind the leading edge, a share of the chord.
    pub axis: f64,
    /// Normal to the axis, m.
    pub chord_m: f64,
    /// Where the boxes begin, m.
    pub inner_m: f64,
    /// Aft, rad.
    pub sweep_rad: f64,
    /// Along chord and span.
    pub divisions: [u32; 2],
    /// At the root.
    pub plane: MirrorPlane,
}

/// [`heavy_flat_wing`] without weight.
pub fn flat_wing(model: &Model, flat: &Flat) -> LargeWing {
    heavy_flat_wing(model, flat).weightless().expect("at rest")
}

/// The wing of a beam model, its nodes along the axis, the last at the tip.
pub fn heavy_flat_wing(model: &Model, flat: &Flat) -> LargeWing {
    let system = System::assemble(model).expect("a beam");
    let (root, tip) = (system.points()[0], system.points()[system.points().len() - 1]);
    let chord = flat.chord_m / flat.sweep_rad.cos();
    let edge = |y: f64| [root.x + y * flat.sweep_rad.tan() - flat.axis * chord, y, 0.0];
    // The boxes of the source end at the semispan, a hair beyond its last station.
    let outer = if (tip.y - SEMISPAN_M).abs() < 1e-3 { SEMISPAN_M } else { tip.y };
    let lattice = Lattice::trapezoid(1001, edge(flat.inner_m), chord, edge(outer), chord, flat.divisions)
        .expect("boxes");
    let nodes: Vec<usize> = (0..system.points().len()).collect();
    let spline = Spline::beam(&lattice, system.points(), &nodes);
    let supported = SupportedStructure::new(&system, &spline, nodes.len() - 1, &root).expect("held");
    let boxes = lattice.len();
    let elastic = ElasticWing::new(WingParts {
        lattice,
        controls: Vec::new(),
        balance: Balance { point: root, metric: vec![true; boxes] },
        plane: flat.plane,
        mach: 0.0,
        fairing_surfaces: Vec::new(),
        camber: vec![0.0; boxes],
        supported: Some(supported),
        structure: Some((system, spline)),
    })
    .expect("a wing");
    LargeWing::new(elastic, model, SplineKind::Beam, &nodes).expect("a wing")
}
