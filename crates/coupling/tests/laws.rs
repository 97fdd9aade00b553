//! Laws of the coupled wing: what must hold for any wing, whatever the numbers.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use aero::{Corrections, Flow};
use coupling::planform::Planform;
use coupling::wing_file::{Departure, Source};
use coupling::{ElasticWing, Mount, Rows, Spline, SteadyCase, SteadyModel, WingFile};
use faer::Mat;
use nalgebra::{Point3, Vector3};
use std::path::{Path, PathBuf};

const RHO: f64 = 1.225;

fn wing_path() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex/wing_beam.ron")
}

/// The shipped wing on a coarser lattice, so that the laws run quickly; `change` alters the planform first.
fn wing(change: impl Fn(&mut Planform)) -> (WingFile, ElasticWing) {
    let mut file = WingFile::read(&wing_path()).unwrap();
    let Source::Parametric(planform) = &mut file.source else { panic!("the shipped wing is parametric") };
    planform.boxes.chordwise = 4;
    planform.boxes.spanwise = 14;
    planform.controls.clear();
    change(planform);
    let bulk = file.bulk(Mount::Tunnel).unwrap();
    let wing = ElasticWing::from_bulk(&file, &bulk).unwrap();
    (file, wing)
}

fn flow(v_m_s: f64) -> Flow {
    Flow { v_m_s, rho_kg_m3: RHO }
}

fn uneven(boxes: usize) -> Corrections {
    let wave = |b: usize, phase: f64| (b as f64 * 0.37 + phase).sin();
    Corrections {
        force: (0..boxes).map(|b| 1.0 + 0.2 * wave(b, 0.0)).collect(),
        moment: (0..boxes).map(|b| 1.0 + 0.3 * wave(b, 1.0)).collect(),
        pressure_offset: (0..boxes).map(|b| 0.1 * wave(b, 2.0)).collect(),
    }
}

#[test]
fn a_rigid_motion_is_splined_exactly() {
    let (_, wing) = wing(|planform| planform.dihedral_deg = 5.0);
    let (system, beam) = wing.structure.as_ref().unwrap();
    let nodes: Vec<usize> = (0..20).collect();
    let nearest = Spline::nearest_node(&wing.lattice, system.points(), &nodes);
    let about = Point3::new(0.3, -0.2, 0.1);
    let rigid = system.rigid_body(&about);
    for spline in [beam, &nearest] {
        let moved = spline.displace(rigid.as_ref());
        for (j, panel) in wing.lattice.boxes.iter().enumerate() {
            for motion in 0..6 {
                let (t, r) = if motion < 3 {
                    (Vector3::ith(motion, 1.0), Vector3::zeros())
                } else {
                    (Vector3::zeros(), Vector3::ith(motion - 3, 1.0))
                };
                let heave = panel.normal().dot(&(t + r.cross(&(panel.mid_point() - about))));
                let pitch = panel.pitch_axis().dot(&r);
                assert!((moved[(2 * j, motion)] - heave).abs() < 1e-12, "box {j} motion {motion}");
                assert!((moved[(2 * j + 1, motion)] - pitch).abs() < 1e-12, "box {j} motion {motion}");
            }
        }
    }
}

#[test]
fn virtual_work_is_the_same_on_both_sides() {
    let (_, wing) = wing(|_| ());
    let (_, spline) = wing.structure.as_ref().unwrap();
    let u = Mat::from_fn(spline.g_size(), 1, |i, _| (i as f64 * 0.7).sin());
    let p = Mat::from_fn(2 * wing.lattice.len(), 1, |i, _| (i as f64 * 0.3).cos());
    let on_boxes: f64 = (0..p.nrows()).map(|i| p[(i, 0)] * spline.displace(u.as_ref())[(i, 0)]).sum();
    let on_grids: f64 = (0..u.nrows()).map(|i| u[(i, 0)] * spline.loads(p.as_ref())[(i, 0)]).sum();
    assert!((on_boxes - on_grids).abs() < 1e-12 * on_boxes.abs().max(1.0));
}

#[test]
fn a_cubic_bending_shape_is_splined_exactly() {
    // Straight beam along y: w = y^3, slope 3 y^2, which the beam element and its spline contain exactly.
    let points: Vec<Point3<f64>> = (0..5).map(|i| Point3::new(0.0, 0.25 * f64::from(i), 0.0)).collect();
    let corner = |x: f64, y: f64| Point3::new(x, y, 0.0);
    let lattice = aero::Lattice {
        boxes: (0..7)
            .map(|i| {
                let (a, b) = (0.14 * f64::from(i), 0.14 * f64::from(i + 1));
                aero::AeroBox {
                    id: 1 + i,
                    corners: [corner(-0.1, a), corner(0.1, a), corner(0.1, b), corner(-0.1, b)],
                }
            })
            .collect(),
        surfaces: Vec::new(),
    };
    let mut u = Mat::zeros(30, 1);
    for (node, point) in points.iter().enumerate() {
        u[(6 * node + 2, 0)] = point.y.powi(3);
        u[(6 * node + 3, 0)] = 3.0 * point.y.powi(2);
    }
    let moved = Spline::beam(&lattice, &points, &[0, 1, 2, 3, 4]).displace(u.as_ref());
    for (j, panel) in lattice.boxes.iter().enumerate() {
        assert!((moved[(2 * j, 0)] - panel.mid_point().y.powi(3)).abs() < 1e-13);
        assert!(moved[(2 * j + 1, 0)].abs() < 1e-13);
    }
}

#[test]
fn a_flat_wing_at_zero_incidence_without_weight_carries_nothing() {
    let (_, mut wing) = wing(|planform| planform.airfoil = None);
    wing.gravity_m_s2 = 0.0;
    let neutral = Corrections::neutral(wing.correctable.len());
    let loads = wing.root_loads(&[SteadyCase::new(flow(40.0), 0.0)], &neutral).unwrap();
    assert_eq!(loads[0].to_array(), [0.0; 3]);
}

#[test]
fn loads_are_affine_in_alpha_without_weight() {
    let (_, mut wing) = wing(|_| ());
    wing.gravity_m_s2 = 0.0;
    let corrections = uneven(wing.correctable.len());
    let cases: Vec<SteadyCase> = [-0.07, 0.01, 0.09].map(|alpha| SteadyCase::new(flow(34.0), alpha)).to_vec();
    let loads = wing.root_loads(&cases, &corrections).unwrap();
    for channel in 0..3 {
        let value = |i: usize| loads[i].to_array()[channel];
        assert!((value(0) + value(2) - 2.0 * value(1)).abs() < 1e-10 * value(2).abs().max(1.0));
    }
}

#[test]
fn neutral_corrections_leave_loads_bit_identical() {
    let (_, wing) = wing(|_| ());
    let boxes = wing.correctable.len();
    let case = [SteadyCase::new(flow(30.0), 0.03)];
    let neutral = wing.root_loads(&case, &Corrections::neutral(boxes)).unwrap();
    let written =
        Corrections { force: vec![1.0; boxes], moment: vec![1.0; boxes], pressure_offset: vec![0.0; boxes] };
    assert_eq!(neutral, wing.root_loads(&case, &written).unwrap());
    // ... and are those of a path that knows no corrections: R S q cp, with cp of the deformed wing
    let state = &wing.at(flow(30.0), &written).unwrap().solve(&case)[0];
    let q_pa = flow(30.0).dynamic_pressure_pa();
    for (j, cp) in state.cp.iter().enumerate() {
        assert_eq!(state.box_loads.values[2 * j], q_pa * wing.integration.area(j) * cp);
    }
}

#[test]
fn the_adjoint_jacobian_agrees_with_central_differences_at_fifty_boxes() {
    let (_, wing) = wing(|_| ());
    let boxes = wing.correctable.len();
    let corrections = uneven(boxes);
    let case = [SteadyCase::new(flow(40.0), 0.05)];
    let exact = &wing.sensitivities(&case, &corrections).unwrap()[0];
    let step = 1e-4;
    for index in 0..50 {
        let b = index * boxes / 50;
        for (family, by_box) in [&exact.by_force, &exact.by_moment, &exact.by_offset].into_iter().enumerate()
        {
            let moved = |sign: f64| {
                let mut c = corrections.clone();
                [&mut c.force, &mut c.moment, &mut c.pressure_offset][family][b] += sign * step;
                let [fz, mx, my] = wing.root_loads(&case, &c).unwrap()[0].to_array();
                [fz, mx, my, wing.tip_deflections(&case, &c).unwrap()[0]]
            };
            let (up, down) = (moved(1.0), moved(-1.0));
            // the tip hardly feels boxes at the root, less than the differences' round-off: its scale is all boxes'
            let tip = (0..boxes).map(|any| by_box[(3, any)].abs()).fold(0.0, f64::max);
            let loads = (0..3).map(|c| by_box[(c, b)].abs()).fold(1e-6, f64::max);
            for channel in 0..4 {
                let scale = if channel < 3 { loads } else { tip };
                let difference = (up[channel] - down[channel]) / (2.0 * step);
                let error = (by_box[(channel, b)] - difference).abs() / scale;
                assert!(error < 1e-6, "box {b} family {family} channel {channel}: {error:e}");
            }
        }
    }
}

#[test]
fn the_weight_is_tared_at_zero_angle_but_the_sag_stays() {
    let (_, mut wing) = wing(|planform| planform.airfoil = None);
    let neutral = Corrections::neutral(wing.correctable.len());
    let wind_off = wing.root_loads(&[SteadyCase::new(flow(0.0), 0.0)], &neutral).unwrap();
    assert_eq!(wind_off[0].to_array(), [0.0; 3]);
    let case = [SteadyCase::new(flow(40.0), 0.0)];
    let with_sag = wing.root_loads(&case, &neutral).unwrap()[0];
    wing.gravity_m_s2 = 0.0;
    let without = wing.root_loads(&case, &neutral).unwrap()[0];
    // A wing swept back that hangs down is washed in: the flat wing lifts only because it sags.
    assert_eq!(without.fz_n, 0.0);
    assert!(with_sag.fz_n > 0.1, "{with_sag:?}");
}

#[test]
fn tilted_wind_off_the_balance_feels_the_weight_and_its_arm() {
    let (file, wing) = wing(|_| ());
    let neutral = Corrections::neutral(wing.correctable.len());
    let alpha = 0.2_f64;
    let loads = wing.root_loads(&[SteadyCase::new(flow(0.0), alpha)], &neutral).unwrap()[0];
    let (system, _) = wing.structure.as_ref().unwrap();
    let mass = system.mass_properties();
    let arm = mass.centre - Point3::new(file.balance.x_m, file.balance.y_m, file.balance.z_m);
    let g = coupling::GRAVITY_M_S2;
    let relieved = mass.mass_kg * g * (1.0 - alpha.cos());
    assert!((loads.fz_n - relieved).abs() < 1e-10);
    assert!((loads.mx_nm - arm.y * relieved).abs() < 1e-10);
    assert!((loads.my_nm - (-arm.x * relieved + arm.z * mass.mass_kg * g * alpha.sin())).abs() < 1e-10);
}

/// The tip is counted from the shape with wind off at zero angle. Tilted, gravity along z is g cos(alpha), and along x
/// g sin(alpha); what these bend is computed here from the structure alone.
#[test]
fn with_wind_off_the_tip_rises_by_the_weight_that_the_tilt_takes_off() {
    let (_, wing) = wing(|_| ());
    let neutral = Corrections::neutral(wing.correctable.len());
    let (system, _) = wing.structure.as_ref().unwrap();
    let rigid = system.rigid_body(&Point3::origin());
    let field = system.inertia_loads(rigid.as_ref());
    let flexibility = structure::Flexibility::new(system).unwrap();
    let bent = system.expand(flexibility.displacements(system.reduce(field.as_ref()).as_ref()).as_ref());
    // the grid farthest along the span that the wing's tip reading may be of
    let tip = wing.supported.as_ref().unwrap();
    let tip = tip.s_dofs[tip.tip_z];
    let g = coupling::GRAVITY_M_S2;
    for alpha in [0.0, 0.3, -0.5, std::f64::consts::FRAC_PI_2] {
        let case = [SteadyCase::new(flow(0.0), alpha)];
        let found = wing.tip_deflections(&case, &neutral).unwrap()[0];
        let expected = g * (bent[(tip, 2)] * (1.0 - alpha.cos()) + bent[(tip, 0)] * alpha.sin());
        assert!((found - expected).abs() < 1e-9, "{alpha}: {found} beside {expected}");
    }
    assert!(g * bent[(tip, 2)] > 1e-3, "the wing sags by {} m", g * bent[(tip, 2)]);
}

/// Pressures are forces cp q A along the normals at quarter points: their sum and moments, without any row of R.
#[test]
fn root_loads_are_those_of_the_pressures_at_the_quarter_points() {
    let (file, mut wing) = wing(|planform| {
        planform.dihedral_deg = 20.0;
        planform.fairing = None;
    });
    wing.gravity_m_s2 = 0.0;
    let balance = Point3::new(file.balance.x_m, file.balance.y_m, file.balance.z_m);
    let boxes = wing.lattice.len();
    let pressures: Vec<f64> = (0..boxes).map(|j| (0.7 * j as f64).sin()).collect();
    let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
    for (panel, cp) in wing.lattice.boxes.iter().zip(&pressures) {
        let own = panel.normal() * (cp * panel.area_m2());
        force += own;
        moment += (panel.quarter_point() - balance).cross(&own);
    }
    let loads = wing.integration.corrected(&Corrections::neutral(boxes)).box_loads(1.0, &pressures);
    let found: [f64; 3] = std::array::from_fn(|row| {
        loads.values.iter().enumerate().map(|(k, load)| wing.root_rows[(row, k)] * load).sum()
    });
    for (name, found, expected) in
        [("Fz", found[0], force.z), ("Mx", found[1], moment.x), ("My", found[2], moment.y)]
    {
        assert!((found - expected).abs() < 1e-10 * moment.norm(), "{name}: {found} beside {expected}");
    }
}

#[test]
fn a_fairing_disturbs_the_flow_but_not_the_balance() {
    let (_, with) = wing(|_| ());
    assert_eq!(with.correctable.len(), 56);
    assert_eq!(with.lattice.len(), 56 + 12);
    for j in 56..68 {
        assert!(!with.balance.metric[j]);
        assert!(
            (0..3).all(|row| with.root_rows[(row, 2 * j)] == 0.0 && with.root_rows[(row, 2 * j + 1)] == 0.0)
        );
    }
}

#[test]
fn a_wing_beyond_divergence_is_refused_with_both_pressures() {
    // Swept forward, the shipped wing diverges.
    let (_, wing) = wing(|planform| {
        planform.quarter_chord_sweep_deg = -30.0;
        planform.fairing = None;
    });
    let neutral = Corrections::neutral(wing.correctable.len());
    let v_d = wing.divergence_speed(RHO, &neutral).unwrap().expect("a forward-swept wing diverges");
    assert!(wing.at(flow(0.98 * v_d), &neutral).is_ok());
    let message = wing.at(flow(1.02 * v_d), &neutral).unwrap_err().to_string();
    let q_d = 0.5 * RHO * v_d * v_d;
    assert!(message.contains("diverges") && message.contains(&format!("{q_d:.1} Pa")), "{message}");
    // loads grow without bound on the way there: 1 / (1 - q/q_D)
    let lift = |share: f64| {
        wing.root_loads(&[SteadyCase::new(flow(v_d * share.sqrt()), 0.02)], &neutral).unwrap()[0].mx_nm
            / share
    };
    assert!(lift(0.999) > 50.0 * lift(0.1));
}

/// Rows of one reading on the structure, and root loads.
fn rows(wing: &ElasticWing, on_structure: &[Vec<f64>]) -> Rows {
    let columns = wing.tip_row().len();
    Rows {
        on_loads: wing.root_rows.clone(),
        on_structure: Mat::from_fn(on_structure.len(), columns, |r, k| on_structure[r][k]),
    }
}

#[test]
fn a_section_is_rigid_and_the_last_one_is_where_the_tip_is() {
    let (_, wing) = wing(|_| {});
    let case = SteadyCase::new(flow(30.0), 0.06);
    let operator = wing.at(case.flow, &uneven(wing.correctable.len())).unwrap();
    let [ahead, turned] = wing.point_rows(0.6, 0.1);
    let [behind, _] = wing.point_rows(0.6, 0.9);
    let [last, _] = wing.point_rows(1.0, 0.38);
    let values = operator.values(&case, &rows(&wing, &[ahead, behind, turned, last, wing.tip_row()]));
    let [.., ahead_m, behind_m, turned_rad, last_m, tip_m] = values[..] else { panic!("{values:?}") };
    // chord of the strips on both sides of 0.6 of the half span, from the drawing: 0.3 m at the root, 0.15 m at the tip
    let chord_m = 0.3 - 0.15 * 0.6;
    assert!(((ahead_m - behind_m) / (0.8 * chord_m) / turned_rad - 1.0).abs() < 0.02, "{values:?}");
    // swept aft and bent up: washed out
    assert!(turned_rad < 0.0 && ahead_m < behind_m, "{values:?}");
    // the last strip's middle is 1/28 of the span inboard of the tip, where the slope is about twice the mean one
    assert!(last_m < tip_m && last_m > 0.85 * tip_m, "{last_m} {tip_m}");
    assert!((operator.solve(&[case])[0].tip_z_m - tip_m).abs() < 1e-12);
}

#[test]
fn derivatives_by_flexibility_are_those_of_softer_materials() {
    let softer = |bending: f64, torsion: f64| {
        let (file, _) = wing(|_| {});
        let mut bulk = file.bulk(Mount::Tunnel).unwrap();
        for material in bulk.materials.values_mut() {
            material.e /= 1.0 + bending;
            material.g /= 1.0 + torsion;
        }
        ElasticWing::from_bulk(&file, &bulk).unwrap()
    };
    let case = SteadyCase::new(flow(30.0), 0.06);
    let read = |wing: &ElasticWing| {
        let [height, turned] = wing.point_rows(0.7, 0.2);
        let operator = wing.at(case.flow, &uneven(wing.correctable.len())).unwrap();
        operator.readings(&case, &rows(wing, &[height, turned, wing.tip_row()]))
    };
    let here = read(&softer(0.0, 0.0));
    let step = 1e-5;
    for (kind, moved) in [softer(step, 0.0), softer(0.0, step)].iter().enumerate() {
        for (r, moved) in read(moved).values.iter().enumerate() {
            let difference = (moved - here.values[r]) / step;
            let by = here.by_flexibility[kind][r];
            // the axis is straight but for the kink of the first element, where bending turns a little into torsion
            let both = here.by_flexibility.iter().map(|by| by[r].abs()).fold(0.0, f64::max);
            assert!((difference - by).abs() < 2e-2 * both, "{kind} {r}: {difference} {by}");
        }
    }
}

/// Flexibility and dynamic pressure act as one product (Bisplinghoff, Ashley and Halfman, Aeroelasticity, Section 8-2): a wing
/// twice as soft is loaded at half the dynamic pressure as the drawn one, per dynamic pressure.
#[test]
fn a_softer_wing_at_less_dynamic_pressure_has_the_coefficients_of_the_drawn_one() {
    let (mut file, mut drawn) = wing(|_| {});
    let factor = 1.3_f64;
    file.departure = Departure { log_flexibility: [factor.ln(); 2], ..Departure::default() };
    let mut softer = ElasticWing::from_bulk(&file, &file.bulk(Mount::Tunnel).unwrap()).unwrap();
    // weight does not go with dynamic pressure
    (drawn.gravity_m_s2, softer.gravity_m_s2) = (0.0, 0.0);
    let slope = |wing: &ElasticWing, v_m_s: f64| {
        let cases = [0.0, 0.1].map(|alpha_rad| SteadyCase::new(flow(v_m_s), alpha_rad));
        let loads = wing.root_loads(&cases, &uneven(wing.correctable.len())).unwrap();
        let [zero, one] = [loads[0].to_array(), loads[1].to_array()];
        let q_pa = 0.5 * RHO * v_m_s * v_m_s;
        [0, 1, 2].map(|c| (one[c] - zero[c]) / q_pa)
    };
    let (by_softer, by_drawn) = (slope(&softer, 30.0 / factor.sqrt()), slope(&drawn, 30.0));
    for c in 0..3 {
        assert!((by_softer[c] / by_drawn[c] - 1.0).abs() < 1e-9, "{c}: {by_softer:?} {by_drawn:?}");
        let stiff = slope(&drawn, 30.0 / factor.sqrt())[c];
        assert!(
            (stiff / by_drawn[c] - 1.0).abs() > 1e-3,
            "{c}: elastic enough to tell: {stiff} {by_drawn:?}"
        );
    }
}

#[test]
fn tips_of_cases_are_those_of_their_states_in_their_order() {
    let (_, wing) = wing(|_| ());
    let corrections = Corrections::neutral(wing.correctable.len());
    let cases =
        [0.02, -0.01].map(|alpha_rad| SteadyCase { alpha_rad, controls_rad: Vec::new(), flow: flow(25.0) });
    let tips = wing.tip_deflections(&cases, &corrections).unwrap();
    assert_eq!(tips.len(), 2);
    for (tip, case) in tips.iter().zip(&cases) {
        let alone = wing.sensitivities(std::slice::from_ref(case), &corrections).unwrap();
        assert!((tip - alone[0].tip_z_m).abs() <= 1e-12 * tip.abs(), "{tip} for {}", alone[0].tip_z_m);
    }
    assert!(tips[0] > tips[1] + 0.01, "more incidence, more deflection");
}
