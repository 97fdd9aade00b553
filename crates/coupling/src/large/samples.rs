//! Small wings and bodies for the tests of this folder: straight beams along y under flat boxes.

use super::boxes::CarriedPart;
use crate::load_rows::Balance;
use crate::spline::Spline;
use crate::supported::SupportedStructure;
use crate::wing::ElasticWing;
use crate::wing_file::SplineKind;
use crate::wing_parts::WingParts;
use crate::{FreeBody, LargeWing};
use aero::{AeroBox, ControlSurface, Corrections, Lattice, MirrorPlane};
use nalgebra::Point3;
use std::fmt::Write as _;
use structure::{Model, System};

/// Of the beam, behind the leading edge, m.
pub(super) const AXIS_M: f64 = 0.3;
/// Of the boxes, m.
pub(super) const CHORD_M: f64 = 0.6;
/// At each grid, kg.
pub(super) const MASS_KG: f64 = 0.5;
/// Beside that at the middle, kg, and how far ahead of the axis.
pub(super) const NOSE_KG: f64 = 3.0;
/// See there.
pub(super) const NOSE_ARM_M: f64 = 0.2;

/// Behind the tip of [`with_arm`], kg.
pub(super) const ARM_KG: f64 = 0.4;

/// Boxes along chord and half span of a half wing.
pub(super) const HALF: [u32; 2] = [2, 4];

/// Cards of a beam along y with grids at places, each with its mass; `ei` and `gj` in N m^2.
pub(super) fn beam(places: &[f64], ei: f64, gj: f64, clamped: usize) -> String {
    // E I with I = 1e-6 m^4; G J with G = E/2.6.
    let e = ei * 1e6;
    let j = gj / (e / 2.6);
    let mut deck = format!("MAT1,1,{},,.3\n", field(e));
    let _ = writeln!(deck, "PBAR,1,1,1.-3,1.-6,3.-5,{}", field(j));
    for (at, y) in places.iter().enumerate() {
        let id = at + 1;
        let _ = writeln!(deck, "GRID,{id},,{AXIS_M:?},{y:.4},0.");
        let _ = writeln!(deck, "CONM2,{},{id},,{MASS_KG:?}", 100 + id);
        if at > 0 {
            let _ = writeln!(deck, "CBAR,{},1,{at},{id},0.,0.,1.", 200 + id);
        }
    }
    let _ = writeln!(deck, "SPC1,1,123456,{}", clamped + 1);
    deck
}

/// A number in a field of eight characters.
fn field(value: f64) -> String {
    let exponent = value.abs().log10().floor();
    format!("{:.3}{exponent:+}", value / 10_f64.powf(exponent))
}

/// The model of some cards.
pub(super) fn model(deck: &str) -> Model {
    let bulk = nastran::parse_deck("sample.bdf", deck).expect("cards");
    Model::from_bulk(&bulk).expect("a structure")
}

/// Parts of a wing of flat boxes without structure; the boxes at the trailing edge are a flap.
pub(super) fn air(lattice: Lattice, plane: MirrorPlane, camber: f64) -> WingParts {
    let boxes = lattice.len();
    let chordwise = lattice.surfaces[0].chordwise;
    // Alike on both sides.
    let place = |panel: &AeroBox| panel.mid_point();
    let cambered =
        lattice.boxes.iter().map(place).map(|at| camber * (1.0 + at.x + 0.5 * at.y * at.y)).collect();
    let flap: Vec<usize> = (0..boxes).filter(|j| j % chordwise == chordwise - 1).collect();
    let flap = ControlSurface {
        name: "flap".into(),
        slope: vec![0.9; flap.len()],
        lever_m: vec![0.0; flap.len()],
        boxes: flap,
    };
    WingParts {
        lattice,
        controls: vec![flap],
        balance: Balance { point: Point3::new(AXIS_M, 0.0, 0.0), metric: vec![true; boxes] },
        plane,
        mach: 0.0,
        fairing_surfaces: Vec::new(),
        camber: cambered,
        supported: None,
        structure: None,
    }
}

/// A half wing of 1 m clamped at its root, grids at quarters.
pub(super) fn half_wing(ei: f64, gj: f64, camber: f64) -> LargeWing {
    let places = [0.0, 0.25, 0.5, 0.75, 1.0];
    let lattice = Lattice::trapezoid(1001, [0.0; 3], CHORD_M, [0.0, 1.0, 0.0], CHORD_M, HALF).expect("boxes");
    wing_on(&beam(&places, ei, gj, 0), lattice, camber)
}

/// Boxes on a beam's grids, the last of which is the tip.
pub(super) fn wing_on(deck: &str, lattice: Lattice, camber: f64) -> LargeWing {
    let model = model(deck);
    let system = System::assemble(&model).expect("a beam");
    let nodes: Vec<usize> = (0..5).collect();
    let spline = Spline::beam(&lattice, system.points(), &nodes);
    let mut parts = air(lattice, MirrorPlane::Symmetric { y_m: 0.0 }, camber);
    let held = SupportedStructure::new(&system, &spline, 4, &parts.balance.point).expect("held");
    (parts.supported, parts.structure) = (Some(held), Some((system, spline)));
    let elastic = ElasticWing::new(parts).expect("a wing");
    LargeWing::new(elastic, &model, SplineKind::Beam, &nodes).expect("a wing")
}

/// Boxes from tip to tip of 2 m, without structure.
pub(super) fn flying_boxes(camber: f64) -> ElasticWing {
    let lattice =
        Lattice::trapezoid(1001, [0.0, -1.0, 0.0], CHORD_M, [0.0, 1.0, 0.0], CHORD_M, [2, 8]).expect("boxes");
    ElasticWing::new(air(lattice, MirrorPlane::None, camber)).expect("a wing")
}

/// Cards of a body with a mass in front of its middle; held at a grid: 2 is the middle, 5 the mass in front.
pub(super) fn body_deck(ei: f64, gj: f64, held: usize) -> String {
    let mut deck = beam(&[-1.0, -0.5, 0.0, 0.5, 1.0], ei, gj, held);
    let _ = writeln!(deck, "GRID,6,,{:.4},0.,0.\nCONM2,106,6,,{NOSE_KG:?}", AXIS_M - NOSE_ARM_M);
    let _ = writeln!(deck, "CBAR,206,1,3,6,0.,0.,1.");
    deck
}

/// A heavy half wing with a mass on a rigid arm behind its tip, as it hangs and flies.
pub(super) fn with_arm(ei: f64, gj: f64, camber: f64) -> LargeWing {
    let mut deck = beam(&[0.0, 0.25, 0.5, 0.75, 1.0], ei, gj, 0);
    let _ = writeln!(deck, "GRID,6,,0.9,1.,0.1\nRBE2,300,5,123456,6\nCONM2,106,6,,{ARM_KG:?}");
    let lattice = Lattice::trapezoid(1001, [0.0; 3], CHORD_M, [0.0, 1.0, 0.0], CHORD_M, HALF).expect("boxes");
    wing_on(&deck, lattice, camber)
}

/// The body on those cards.
pub(super) fn body(boxes: &ElasticWing, ei: f64, gj: f64, held: usize) -> FreeBody<'_> {
    let parts =
        [CarriedPart { boxes: [0, boxes.lattice.len()], kind: SplineKind::Beam, nodes: (0..5).collect() }];
    FreeBody::new(boxes, &model(&body_deck(ei, gj, held)), held, &parts).expect("a body")
}

/// Corrections that differ from box to box, alike on both sides of a body.
pub(super) fn uneven(lattice: &Lattice) -> Corrections {
    let wave = |phase: f64| -> Vec<f64> {
        let of = |j: usize| {
            let place = lattice.boxes[j].mid_point();
            (3.0 * place.x + 2.0 * place.y * place.y + phase).sin()
        };
        (0..lattice.len()).map(of).collect()
    };
    Corrections {
        force: wave(0.0).iter().map(|v| 1.0 + 0.3 * v).collect(),
        moment: wave(1.0).iter().map(|v| 1.0 + 0.2 * v).collect(),
        pressure_offset: wave(2.0).iter().map(|v| 0.02 * v).collect(),
    }
}
