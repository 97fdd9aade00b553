//! The rig against the same wing without modes: every degree of freedom of the structure and every box, solved at a
//! frequency as one complex linear system. What the rig does about modes (the static residual of those left out, the
//! loop it closes through the air, inertia at the balance) has no counterpart in this solution.
//!
//! ```text
//! (K - w² M - Gᵀ q W S Q (D1 + i w D2/V) G) u = Gᵀ P_input + M r c,   c = (g a, 0, w² a)
//! root loads = R P + r_bᵀ M (r c + w² u)
//! ```
//! Q is the vortex lattice's (air that answers at once) or the doublet lattice's at that frequency.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::common::{uneven, wing_with};
use aero::{Corrections, DlmSettings, DoubletLattice, Flow};
use coupling::{ElasticWing, GRAVITY_M_S2, WingFile};
use faer::linalg::solvers::Solve;
use faer::{Mat, c64};
use maneuver::{AirModel, Rig, RigModel, RigSettings};
use nalgebra::Point3;
use std::f64::consts::TAU;

const I: c64 = c64::new(0.0, 1.0);

type Complex = Mat<c64>;

fn complex(m: &Mat<f64>) -> Complex {
    Mat::from_fn(m.nrows(), m.ncols(), |i, j| c64::from(m[(i, j)]))
}

/// A real linear map of complex columns.
fn mapped(z: &Complex, map: impl Fn(&Mat<f64>) -> Mat<f64>) -> Complex {
    let part = |of: fn(c64) -> f64| map(&Mat::from_fn(z.nrows(), z.ncols(), |i, j| of(z[(i, j)])));
    let (re, im) = (part(|z| z.re), part(|z| z.im));
    Mat::from_fn(re.nrows(), re.ncols(), |i, j| c64::new(re[(i, j)], im[(i, j)]))
}

/// The air as a map from incidences to pressures.
type Air<'a> = &'a dyn Fn(&Complex) -> Complex;

/// What acts on the wing: incidence of the boxes, and fields of acceleration aft, up, nose up.
struct Forcing {
    incidence: Complex,
    fields: [f64; 3],
}

/// Root loads Fz, Mx, My without modes, see the module.
fn without_modes(
    file: &WingFile,
    wing: &ElasticWing,
    flow: Flow,
    corrections: &Corrections,
    omega: f64,
    air: Air<'_>,
    forcing: &Forcing,
) -> Complex {
    let (system, spline) = wing.structure.as_ref().unwrap();
    let (free, boxes) = (system.free_count(), wing.lattice.len());
    let q_pa = flow.dynamic_pressure_pa();
    let units = system.expand(Mat::<f64>::identity(free, free).as_ref());
    let stiffness = system.reduce(system.elastic_loads(units.as_ref()).as_ref());
    let mass = system.reduce(system.inertia_loads(units.as_ref()).as_ref());
    let motion = spline.displace(units.as_ref());
    let slowness = if flow.v_m_s > 0.0 { omega / flow.v_m_s } else { 0.0 };
    let incidence = Mat::from_fn(boxes, free, |j, k| {
        let lever = 0.25 * wing.lattice.boxes[j].chord_m();
        let down = lever * motion[(2 * j + 1, k)] - motion[(2 * j, k)];
        c64::new(motion[(2 * j + 1, k)], slowness * down)
    });
    let loads = |cp: &Complex| wing.integration.corrected(corrections).of_pressures(q_pa, cp.as_ref());
    let to_free = |p_k: &Complex| mapped(p_k, |p| system.reduce(spline.loads(p.as_ref()).as_ref()));
    let (by_motion, input) = (loads(&air(&incidence)), loads(&air(&forcing.incidence)));
    let balance = wing.balance.point;
    let moving = system.rigid_body(&Point3::new(file.pitch_axis_x(), balance.y, balance.z));
    let field = Mat::from_fn(moving.nrows(), 1, |dof, _| {
        (0..3).map(|k| moving[(dof, [0, 2, 4][k])] * forcing.fields[k]).sum::<f64>()
    });
    let field_loads = system.inertia_loads(field.as_ref());
    let dynamic = complex(&(&stiffness - faer::Scale(omega * omega) * &mass)) - to_free(&by_motion);
    let right = to_free(&input) + complex(&system.reduce(field_loads.as_ref()));
    let u = dynamic.partial_piv_lu().solve(&right);
    let box_loads = input + by_motion * &u;
    let accelerations = mapped(&u, |u| faer::Scale(omega * omega) * &system.expand(u.as_ref()));
    let inertia = complex(&field_loads) + mapped(&accelerations, |a| system.inertia_loads(a.as_ref()));
    let at_balance = mapped(&inertia, |f| system.rigid_body(&balance).transpose() * f);
    let of_air = mapped(&box_loads, |p| &wing.root_rows * p);
    Mat::from_fn(3, 1, |c, _| of_air[(c, 0)] + at_balance[(c + 2, 0)])
}

/// Pitch of 1 rad about the axis (gravity taken linear).
fn pitching(file: &WingFile, wing: &ElasticWing, flow: Flow, omega: f64) -> Forcing {
    let slowness = if flow.v_m_s > 0.0 { omega / flow.v_m_s } else { 0.0 };
    let incidence = Mat::from_fn(wing.lattice.len(), 1, |j, _| {
        let panel = &wing.lattice.boxes[j];
        let arm = panel.three_quarter_point().x - file.pitch_axis_x();
        (c64::new(1.0, 0.0) + I * slowness * arm) * panel.normal().z
    });
    Forcing { incidence, fields: [GRAVITY_M_S2, 0.0, omega * omega] }
}

/// A deflection of 1 rad; three-quarter points move down at the rate times their distance aft of the hinge, here of
/// the leading edge of the control's foremost box in each strip.
fn deflecting(wing: &ElasticWing, flow: Flow, omega: f64, control: usize) -> Forcing {
    let surface = &wing.controls[control];
    let mut incidence = Mat::zeros(wing.lattice.len(), 1);
    for (&j, slope) in surface.boxes.iter().zip(&surface.slope) {
        let panel = &wing.lattice.boxes[j];
        let strip = surface
            .boxes
            .iter()
            .filter(|&&other| (wing.lattice.boxes[other].mid_point().y - panel.mid_point().y).abs() < 1e-9);
        let hinge_x = strip
            .map(|&other| {
                let [front, _, _, other_front] = wing.lattice.boxes[other].corners;
                0.5 * (front.x + other_front.x)
            })
            .fold(f64::INFINITY, f64::min);
        // about a swept hinge the point goes down by the distance normal to the hinge: cos(sweep) is in `slope`
        let lever = (panel.three_quarter_point().x - hinge_x) * slope;
        incidence[(j, 0)] = c64::new(*slope, omega / flow.v_m_s * lever);
    }
    Forcing { incidence, fields: [0.0; 3] }
}

/// Largest difference of a column of the rig's loads, as a share of the channel's size.
fn apart(response: &Complex, motion: usize, exact: &Complex) -> f64 {
    let of = |c: usize| (response[(c, motion)] - exact[(c, 0)]).norm() / exact[(c, 0)].norm();
    (0..3).map(of).fold(0.0, f64::max)
}

fn undamped(file: &WingFile, modes: usize, air: AirModel) -> RigSettings {
    RigSettings { modes, air, ..RigSettings::new(0.0, file.pitch_axis_x()) }
}

/// The assumed actuator's answer: 15 Hz, 0.8.
fn actuator(omega: f64) -> c64 {
    let natural = TAU * 15.0;
    c64::from(natural * natural)
        / (c64::from(natural * natural - omega * omega) + I * (1.6 * natural * omega))
}

fn at_once(wing: &ElasticWing, w: &Complex) -> Complex {
    mapped(w, |w| wing.pressures(w.as_ref()))
}

#[test]
fn pitching_at_a_frequency_loads_the_root_as_the_whole_structure_without_modes_does() {
    let (file, wing) = wing_with(|_| ());
    let corrections = uneven(&wing);
    let padded = wing.padded(&corrections).unwrap();
    let all = Rig::new(&wing, undamped(&file, usize::MAX, AirModel::QuasiSteady)).unwrap();
    let kept = Rig::new(&wing, undamped(&file, 20, AirModel::QuasiSteady)).unwrap();
    for v_m_s in [0.0, 30.0] {
        let flow = Flow { v_m_s, rho_kg_m3: 1.225 };
        let (all, kept) = (all.at(flow, &corrections).unwrap(), kept.at(flow, &corrections).unwrap());
        for f_hz in [0.5, 2.0, 4.0, 9.0] {
            let omega = TAU * f_hz;
            let forcing = pitching(&file, &wing, flow, omega);
            let exact = without_modes(&file, &wing, flow, &padded, omega, &|w| at_once(&wing, w), &forcing);
            let by_all = apart(&all.frequency_response(omega), 0, &exact);
            assert!(by_all < 1e-6, "{v_m_s} m/s, {f_hz} Hz, all modes: {by_all:e}");
            let by_kept = apart(&kept.frequency_response(omega), 0, &exact);
            assert!(by_kept < 1e-3, "{v_m_s} m/s, {f_hz} Hz, twenty modes: {by_kept:e}");
        }
    }
}

#[test]
fn with_the_doublet_lattice_as_its_air_the_rig_at_a_frequency_is_the_whole_structure_without_modes() {
    let (file, wing) = wing_with(|_| ());
    let corrections = uneven(&wing);
    let padded = wing.padded(&corrections).unwrap();
    let all = Rig::new(&wing, undamped(&file, usize::MAX, AirModel::default())).unwrap();
    let kept = Rig::new(&wing, undamped(&file, 20, AirModel::default())).unwrap();
    let doublets =
        DoubletLattice::new(&wing.lattice, wing.plane, wing.mach, &DlmSettings::default()).unwrap();
    for (v_m_s, f_hz) in [(18.0, 0.5), (18.0, 4.0), (30.0, 4.0), (30.0, 9.0)] {
        let (flow, omega) = (Flow { v_m_s, rho_kg_m3: 1.225 }, TAU * f_hz);
        let of_frequency = doublets.at(omega / v_m_s).unwrap();
        let air = |w: &Complex| of_frequency.pressures(w.as_ref());
        let [all, kept] = [&all, &kept]
            .map(|rig| rig.at_frequency(flow, &corrections, omega).unwrap().frequency_response(omega));
        for motion in 0..=wing.controls.len() {
            let mut forcing = pitching(&file, &wing, flow, omega);
            let mut share = c64::from(1.0);
            if motion > 0 {
                forcing = deflecting(&wing, flow, omega, motion - 1);
                share = actuator(omega);
            }
            let exact = without_modes(&file, &wing, flow, &padded, omega, &air, &forcing);
            let exact = Mat::from_fn(3, 1, |c, _| share * exact[(c, 0)]);
            let (by_all, by_kept) = (apart(&all, motion, &exact), apart(&kept, motion, &exact));
            assert!(by_all < 1e-6, "{v_m_s} m/s, {f_hz} Hz, motion {motion}, all modes: {by_all:e}");
            // the left-out modes' answer is taken without lag
            assert!(by_kept < 1e-3, "{v_m_s} m/s, {f_hz} Hz, motion {motion}, twenty modes: {by_kept:e}");
        }
    }
}

#[test]
fn a_swinging_aileron_loads_the_root_behind_its_actuator_as_the_structure_without_modes_does() {
    let (file, wing) = wing_with(|_| ());
    let corrections = uneven(&wing);
    let padded = wing.padded(&corrections).unwrap();
    let flow = Flow { v_m_s: 30.0, rho_kg_m3: 1.225 };
    let rig = Rig::new(&wing, undamped(&file, usize::MAX, AirModel::QuasiSteady)).unwrap();
    let model: RigModel = rig.at(flow, &corrections).unwrap();
    for f_hz in [1.0, 6.0] {
        let omega = TAU * f_hz;
        for control in 0..wing.controls.len() {
            let forcing = deflecting(&wing, flow, omega, control);
            let exact = without_modes(&file, &wing, flow, &padded, omega, &|w| at_once(&wing, w), &forcing);
            let exact = Mat::from_fn(3, 1, |c, _| actuator(omega) * exact[(c, 0)]);
            let difference = apart(&model.frequency_response(omega), 1 + control, &exact);
            assert!(difference < 1e-6, "control {control} at {f_hz} Hz: {difference:e}");
        }
    }
}
