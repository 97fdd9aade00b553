//! A straight uniform wing beside the formulas of beams: what is read where nothing was measured, by flexibility too.

use aero::{ControlSurface, Corrections, Flow, Lattice, MirrorPlane};
use coupling::{
    Balance, CouplingError, ElasticWing, GRAVITY_M_S2, Rows, Spline, SteadyCase, SteadyModel,
    SupportedStructure, WingParts,
};
use faer::Mat;
use nalgebra::Point3;
use nastran::{BulkData, parse_deck};
use std::fmt::Write as _;
use structure::{Model, System};

/// Bending and torsional stiffness, N m^2; axis behind the leading edge, masses behind the axis, chord, m.
const EI: f64 = 50.0;
const GJ: f64 = 20.0;
pub(crate) const AXIS_M: f64 = 0.2;
const ARM_M: f64 = 0.05;
pub(crate) const CHORD_M: f64 = 0.4;
const MASS_KG: f64 = 0.3;
/// Grids are at the root and at the middles of the four strips.
const PLACES_M: [f64; 5] = [0.0, 0.125, 0.375, 0.625, 0.875];

pub(crate) fn near(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((found - expected).abs() <= tolerance, "{what}: {found} beside {expected}");
}

fn cards() -> BulkData {
    let mut deck = String::from("MAT1,1,5.+7,2.+7\nPBAR,1,1,1.-3,1.-6,1.-6,1.-6\nSPC1,1,123456,1\n");
    for (at, y) in (1..).zip(PLACES_M) {
        let _ = writeln!(deck, "GRID,{at},,{AXIS_M:?},{y:?},0.");
        let _ = writeln!(deck, "CONM2,{},{at},,{MASS_KG:?},{ARM_M:?},0.,0.", 10 + at);
        if at > 1 {
            let _ = writeln!(deck, "CBAR,{},1,{},{at},0.,0.,1.", 20 + at, at - 1);
        }
    }
    parse_deck("straight.bdf", &deck).expect("cards")
}

pub(crate) fn boxes(places: [f64; 2], chord_m: f64) -> Lattice {
    let [from, to] = places.map(|y| [0.0, y, 0.0]);
    Lattice::trapezoid(1, from, chord_m, to, chord_m, [2, 4]).expect("boxes")
}

pub(crate) fn parts(lattice: Lattice) -> WingParts {
    let count = lattice.len();
    WingParts {
        controls: vec![ControlSurface {
            name: "flap".to_owned(),
            boxes: vec![5, 7],
            slope: vec![0.8, 0.9],
            lever_m: vec![0.0; 2],
        }],
        balance: Balance { point: Point3::new(AXIS_M, 0.0, 0.0), metric: vec![true; count] },
        plane: MirrorPlane::Symmetric { y_m: 0.0 },
        mach: 0.0,
        fairing_surfaces: Vec::new(),
        camber: (0..count).map(|j| 0.01 * (1.0 + j as f64)).collect(),
        supported: None,
        structure: None,
        lattice,
    }
}

fn built(bulk: &BulkData) -> ElasticWing {
    let system = System::assemble(&Model::from_bulk(bulk).expect("a model")).expect("a beam");
    let mut parts = parts(boxes([0.0, 1.0], CHORD_M));
    let spline = Spline::beam(&parts.lattice, system.points(), &[0, 1, 2, 3, 4]);
    let held = SupportedStructure::new(&system, &spline, 4, &parts.balance.point).expect("held");
    (parts.supported, parts.structure) = (Some(held), Some((system, spline)));
    ElasticWing::new(parts).expect("a wing")
}

pub(crate) fn wing() -> ElasticWing {
    built(&cards())
}

fn matrix(rows: &[Vec<f64>]) -> Mat<f64> {
    Mat::from_fn(rows.len(), rows[0].len(), |r, c| rows[r][c])
}

pub(crate) fn uneven(count: usize) -> Corrections {
    let wave = |phase: f64| (0..count).map(move |b| (1.3 * b as f64 + phase).sin());
    Corrections {
        force: wave(0.0).map(|v| 1.0 + 0.2 * v).collect(),
        moment: wave(1.0).map(|v| 1.0 + 0.3 * v).collect(),
        pressure_offset: wave(2.0).map(|v| 0.05 * v).collect(),
    }
}

pub(crate) fn case(v_m_s: f64, alpha_rad: f64) -> SteadyCase {
    SteadyCase::new(Flow { v_m_s, rho_kg_m3: 1.2 }, alpha_rad)
}

/// A weight W at `a` along the span, `e` behind the axis: W y^2 (3 a - y)/(6 EI) down where y < a, turned by W e y/GJ.
#[test]
fn a_weight_bends_and_turns_the_wing_as_a_cantilever() {
    let wing = wing();
    let (weight, a, e) = (7.0, 0.875, 0.8 * CHORD_M - AXIS_M);
    let [height, turned] = wing.point_rows(0.375, 0.75);
    let [outer, outer_turned] = wing.point_rows(0.875, 0.1);
    let rows = matrix(&[wing.tip_row(), height, turned, outer, outer_turned]);
    let (values, [bending, torsion]) = wing.under_weight(weight, [0.875, 0.8], &rows);
    let sag = |y: f64| weight * y * y * (3.0 * a - y) / (6.0 * EI);
    let twist = |y: f64| weight * e * y / GJ;
    let expected = [
        [-sag(a), 0.0],
        [-sag(0.375), -(0.75 * CHORD_M - AXIS_M) * twist(0.375)],
        [0.0, twist(0.375)],
        [-sag(a), -(0.1 * CHORD_M - AXIS_M) * twist(a)],
        [0.0, twist(a)],
    ];
    for (row, [bent, twisted]) in expected.into_iter().enumerate() {
        near(values[row], bent + twisted, 1e-9, "a reading");
        near(bending[row], bent, 1e-9, "by bending");
        near(torsion[row], twisted, 1e-9, "by torsion");
    }
    assert!(sag(a) > 1e-2 && twist(a) > 1e-2);
    // Half way between two middles the mean of both.
    let [between, _] = wing.point_rows(0.5, 0.75);
    let [further, _] = wing.point_rows(0.625, 0.75);
    let [inner, _] = wing.point_rows(0.375, 0.75);
    for (k, value) in between.iter().enumerate() {
        near(*value, 0.5 * (inner[k] + further[k]), 1e-12, "a mean");
    }
    let rigid = ElasticWing::new(parts(boxes([0.0, 1.0], CHORD_M))).expect("a rigid wing");
    assert_eq!(
        rigid.under_weight(1.0, [0.5, 0.5], &Mat::zeros(2, 0)),
        (vec![0.0; 2], [vec![0.0; 2], vec![0.0; 2]])
    );
    assert!(rigid.tip_row().is_empty() && rigid.point_rows(0.5, 0.5).iter().all(Vec::is_empty));
    assert!(rigid.tip_twist_rad(&[]) == 0.0 && !rigid.has_tip() && wing.has_tip());
}

/// Masses behind the axis turn the wing nose up by m g x y/GJ each.
#[test]
fn the_twist_of_the_tip_is_counted_from_that_of_its_own_weight() {
    let wing = wing();
    let sag: f64 = PLACES_M.iter().map(|y| MASS_KG * GRAVITY_M_S2 * ARM_M * y / GJ).sum();
    let held = wing.supported.as_ref().expect("a structure");
    let pitch = held.s_dofs.binary_search(&28).expect("the tip turns");
    let mut displacement = vec![0.0; held.size()];
    near(wing.tip_twist_rad(&displacement), -sag, 1e-9, "unloaded");
    displacement[pitch] = 0.3;
    near(wing.tip_twist_rad(&displacement), 0.3 - sag, 1e-9, "turned");
    let state = wing
        .at(case(0.0, 0.0).flow, &Corrections::neutral(8))
        .expect("a wing")
        .solve(&[case(0.0, 0.0)])
        .remove(0);
    near(wing.tip_twist_rad(&state.displacement), 0.0, 1e-12, "wind off");
    let tip = wing.tip_row();
    assert!(tip.iter().enumerate().all(|(i, v)| *v == f64::from(u8::from(i == held.tip_z))));
    assert_eq!(held.s_dofs[held.tip_z], 26);
}

fn all_rows(wing: &ElasticWing) -> Rows {
    let [height, turned] = wing.point_rows(0.7, 0.2);
    Rows { on_loads: wing.root_rows.clone(), on_structure: matrix(&[height, turned, wing.tip_row()]) }
}

#[test]
fn readings_change_with_bending_and_torsion_as_with_the_moduli() {
    let softer = |bending: f64, torsion: f64| {
        let mut bulk = cards();
        for material in bulk.materials.values_mut() {
            material.e /= 1.0 + bending;
            material.g /= 1.0 + torsion;
        }
        built(&bulk)
    };
    let case = SteadyCase { controls_rad: vec![0.1], ..case(15.0, 0.1) };
    let here = wing();
    let operator = here.at(case.flow, &uneven(8)).expect("below divergence");
    let own = operator.readings(&case, &all_rows(&here));
    assert_eq!(own.values, operator.values(&case, &all_rows(&here)));
    let step = 1e-4_f64;
    for (kind, sides) in
        [[softer(step, 0.0), softer(-step, 0.0)], [softer(0.0, step), softer(0.0, -step)]].iter().enumerate()
    {
        let [up, down] = sides.each_ref().map(|wing| {
            wing.at(case.flow, &uneven(8)).expect("below divergence").values(&case, &all_rows(wing))
        });
        for row in 0..6 {
            let difference = (up[row] - down[row]) / (step.ln_1p() - (-step).ln_1p());
            let size = own.by_flexibility.iter().map(|by| by[row].abs()).fold(0.0, f64::max);
            assert!(size > 1e-4, "{row}: {size}");
            near(
                own.by_flexibility[kind][row],
                difference,
                1e-5 * size,
                &format!("row {row} of kind {kind}"),
            );
        }
    }
    for (family, by) in [&own.by_force, &own.by_moment, &own.by_offset].into_iter().enumerate() {
        for b in 0..8 {
            let side = |sign: f64| {
                let mut moved = uneven(8);
                [&mut moved.force, &mut moved.moment, &mut moved.pressure_offset][family][b] += sign * step;
                here.at(case.flow, &moved).expect("below divergence").values(&case, &all_rows(&here))
            };
            let (up, down) = (side(1.0), side(-1.0));
            for row in 0..6 {
                let most = (0..8).map(|b| by[(row, b)].abs()).fold(0.0, f64::max);
                assert!(most > 1e-6);
                near(by[(row, b)], (up[row] - down[row]) / (2.0 * step), 1e-6 * most, "by a correction");
            }
        }
    }
}

/// Without wind everything grows with the flexibility: readings, and the place they are counted from.
#[test]
fn with_wind_off_readings_are_their_own_derivatives_by_flexibility() {
    let wing = wing();
    for alpha in [0.0, 0.6] {
        let case = case(0.0, alpha);
        let operator = wing.at(case.flow, &uneven(8)).expect("no wind");
        let own = operator.readings(&case, &all_rows(&wing));
        for (row, value) in own.values.iter().enumerate() {
            near(own.by_flexibility.iter().map(|by| by[row]).sum(), *value, 1e-12, "both parts");
        }
        // Loads on boxes are none; the tip rises by what the tilt takes off its sag.
        assert!(own.values[..3].iter().all(|load| load.abs() < 1e-12));
        let tip = PLACES_M[4];
        let sag = |y: f64| y * y * (3.0 * tip - y) / (6.0 * EI);
        let rise: f64 = PLACES_M.iter().map(|y| MASS_KG * GRAVITY_M_S2 * (1.0 - alpha.cos()) * sag(*y)).sum();
        near(own.values[5], rise, 1e-9, "the tip");
        near(own.by_flexibility[0][5], rise, 1e-9, "the tip by bending");
        near(own.by_flexibility[1][5], 0.0, 1e-12, "the tip by torsion");
    }
    let rigid = ElasticWing::new(parts(boxes([0.0, 1.0], CHORD_M))).expect("a rigid wing");
    let rows = Rows { on_loads: rigid.root_rows.clone(), on_structure: Mat::zeros(1, 0) };
    let (case, neutral) = (case(20.0, 0.1), Corrections::neutral(8));
    let own = rigid.at(case.flow, &neutral).expect("rigid").readings(&case, &rows);
    assert_eq!(own.by_flexibility, [vec![0.0; 4], vec![0.0; 4]]);
    let state = rigid.root_loads(std::slice::from_ref(&case), &neutral).expect("loads")[0];
    near(own.values[0], state.fz_n, 1e-12, "lift");
    assert_eq!(own.values[3], 0.0);
}

#[test]
fn unit_pressures_are_those_of_their_incidences_and_names_are_those_given() {
    let wing = wing();
    let one = |w: &[f64]| {
        let cp = wing.pressures(Mat::from_fn(8, 1, |j, _| w[j]).as_ref());
        cp.col_as_slice(0).to_vec()
    };
    let same = |found: &[f64], expected: Vec<f64>| {
        assert_eq!(found.len(), 8);
        found.iter().zip(expected).for_each(|(a, b)| near(*a, b, 1e-12, "a pressure"));
    };
    same(wing.pressures_of_camber(), one(&wing.camber));
    same(wing.pressures_by_alpha(), one(&[1.0; 8]));
    same(
        wing.pressures_by_control().to_owned().col_as_slice(0),
        one(&[0.0, 0.0, 0.0, 0.0, 0.0, 0.8, 0.0, 0.9]),
    );
    let held = wing.supported.as_ref().expect("a structure");
    let g = held.k_displacements();
    for dof in 0..held.size() {
        let w: Vec<f64> = (0..8).map(|j| g[(2 * j + 1, dof)]).collect();
        same(wing.pressures_by_displacement().to_owned().col_as_slice(dof), one(&w));
    }
    assert_eq!(wing.control_names(), ["flap"]);
    assert!(matches!(
        wing.padded(&Corrections::neutral(7)),
        Err(CouplingError::Size { got: 7, expected: 8, .. })
    ));
    let mut short = parts(boxes([0.0, 1.0], CHORD_M));
    short.camber.pop();
    assert!(matches!(ElasticWing::new(short), Err(CouplingError::Size { got: 7, expected: 8, .. })));
    let mut short = parts(boxes([0.0, 1.0], CHORD_M));
    short.balance.metric.push(true);
    assert!(matches!(ElasticWing::new(short), Err(CouplingError::Size { got: 9, expected: 8, .. })));
    let cp = wing.pressure_coefficients(&case(0.0, 0.05)).expect("pressures");
    let rise: Vec<f64> = one(&wing.camber.iter().map(|own| own + 0.05).collect::<Vec<f64>>());
    assert_eq!(cp.len(), 8);
    // With wind off the wing still sags, nose up.
    assert!(cp.iter().zip(&rise).all(|(cp, rigid)| cp > rigid));
}

#[test]
fn other_masses_are_felt_about_their_own_point_by_the_same_wing() {
    let wing = wing();
    let mut held = wing.supported.clone().expect("a structure");
    held.weight = &held.weight * faer::Scale(2.0);
    let point = Point3::new(0.5, -0.3, 0.0);
    let other = wing.with_masses(point, held.clone()).expect("the same spline");
    assert_eq!(other.balance.point, point);
    for (j, panel) in wing.lattice.boxes.iter().enumerate() {
        let arm = panel.mid_point() - point;
        near(other.root_rows[(1, 2 * j)], arm.y, 1e-12, "Mx");
        near(other.root_rows[(2, 2 * j)], -arm.x, 1e-12, "My");
    }
    let weight = |wing: &ElasticWing| {
        wing.root_loads(&[case(0.0, 0.5)], &Corrections::neutral(8)).expect("loads")[0].fz_n
    };
    near(weight(&other), 2.0 * weight(&wing), 1e-9, "weight");
    held.spline_rows[3].clear();
    assert!(matches!(wing.with_masses(point, held), Err(CouplingError::Size { .. })));
}
