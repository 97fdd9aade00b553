//! The rig against the same wing without modes: every degree of freedom of the structure and every box, solved at a
//! frequency as one complex linear system. What the rig does about modes (the static residual of those left out, the
//! loop it closes through the air, inertia at the balance) has no counterpart in this solution.
//!
//! ```text
//! (K - w² M - Gᵀ q W S Q (D1 + i w D2/V) G) u = Gᵀ P_input + M r c,   c = (g a, 0, w² a)
//! root loads = R P + r_bᵀ M (r c + w² u)
//! ```

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

mod common;

use aero::{Corrections, Flow};
use common::{uneven, wing_with};
use coupling::{ElasticWing, GRAVITY_M_S2, WingFile};
use faer::Mat;
use faer::linalg::solvers::Solve;
use maneuver::{Inputs, Rig, RigModel, RigSettings};
use nalgebra::Point3;
use std::f64::consts::TAU;

/// Real and imaginary part of Fz, Mx, My.
type Response = [(f64, f64); 3];

/// x of (re + i im) x = (b_re + i b_im), columns real and imaginary.
fn complex_solve(re: &Mat<f64>, im: &Mat<f64>, b: &Mat<f64>) -> Mat<f64> {
    let n = re.nrows();
    let block = Mat::from_fn(2 * n, 2 * n, |i, j| match (i < n, j < n) {
        (true, true) => re[(i, j)],
        (true, false) => -im[(i, j - n)],
        (false, true) => im[(i - n, j)],
        (false, false) => re[(i - n, j - n)],
    });
    let right = Mat::from_fn(2 * n, 1, |i, _| if i < n { b[(i, 0)] } else { b[(i - n, 1)] });
    let x = block.partial_piv_lu().solve(&right);
    Mat::from_fn(n, 2, |i, part| x[(i + part * n, 0)])
}

/// The rig's answer to inputs that swing at a frequency: C (i w - A)⁻¹ B v + D v.
fn of_rig(model: &RigModel, omega: f64, v: &Mat<f64>) -> Response {
    let n = model.a.nrows();
    let re = Mat::from_fn(n, n, |i, j| -model.a[(i, j)]);
    let im = Mat::from_fn(n, n, |i, j| if i == j { omega } else { 0.0 });
    let x = complex_solve(&re, &im, &(&model.b * v));
    let y = &model.c * &x + &model.d * v;
    std::array::from_fn(|c| (y[(c, 0)], y[(c, 1)]))
}

/// The inputs of a swinging angle of attack of 1 rad, real and imaginary (gravity taken linear).
fn swing(model: &RigModel, omega: f64) -> Mat<f64> {
    let mut v = Mat::zeros(model.inputs.len(), 2);
    v[(Inputs::ALPHA, 0)] = 1.0;
    v[(Inputs::ALPHA_RATE, 1)] = omega;
    v[(Inputs::ALPHA_SECOND, 0)] = -omega * omega;
    v[(Inputs::G_SIN, 0)] = GRAVITY_M_S2;
    v
}

/// What acts on the wing: incidence of the boxes (real, imaginary), and fields of acceleration aft, up, nose up.
struct Forcing {
    cp: Mat<f64>,
    fields: [f64; 3],
}

/// Root loads without modes, see the module.
fn without_modes(
    file: &WingFile,
    wing: &ElasticWing,
    flow: Flow,
    corrections: &Corrections,
    omega: f64,
    forcing: &Forcing,
) -> Response {
    let (system, spline) = wing.structure.as_ref().unwrap();
    let (free, boxes) = (system.free_count(), wing.lattice.len());
    let q_pa = flow.dynamic_pressure_pa();
    let units = system.expand(Mat::<f64>::identity(free, free).as_ref());
    let stiffness = system.reduce(system.elastic_loads(units.as_ref()).as_ref());
    let mass = system.reduce(system.inertia_loads(units.as_ref()).as_ref());
    let motion = spline.displace(units.as_ref());
    let angle = Mat::from_fn(boxes, free, |j, k| motion[(2 * j + 1, k)]);
    let slowness = if flow.v_m_s > 0.0 { omega / flow.v_m_s } else { 0.0 };
    let rate = Mat::from_fn(boxes, free, |j, k| {
        let lever = 0.25 * wing.lattice.boxes[j].chord_m();
        slowness * (lever * motion[(2 * j + 1, k)] - motion[(2 * j, k)])
    });
    let loads = |cp: &Mat<f64>| wing.k_loads_of_pressures(q_pa, cp.as_ref(), corrections);
    let to_free = |p_k: &Mat<f64>| system.reduce(spline.loads(p_k.as_ref()).as_ref());
    let (by_angle, by_rate) = (loads(&wing.pressures(angle.as_ref())), loads(&wing.pressures(rate.as_ref())));
    let input = loads(&forcing.cp);
    let balance = wing.balance.point;
    let moving = system.rigid_body(&Point3::new(file.pitch_axis_x(), balance.y, balance.z));
    let field = Mat::from_fn(moving.nrows(), 2, |dof, part| {
        let of = |k: usize| moving[(dof, [0, 2, 4][k])] * forcing.fields[k];
        if part == 0 { of(0) + of(1) + of(2) } else { 0.0 }
    });
    let field_loads = system.inertia_loads(field.as_ref());
    let re = &stiffness - faer::Scale(omega * omega) * &mass - to_free(&by_angle);
    let im = faer::Scale(-1.0) * &to_free(&by_rate);
    let u = complex_solve(&re, &im, &(to_free(&input) + system.reduce(field_loads.as_ref())));
    // (angle + i rate) (u_re + i u_im)
    let (a, r) = (&by_angle * &u, &by_rate * &u);
    let box_loads = Mat::from_fn(2 * boxes, 2, |k, part| {
        input[(k, part)] + a[(k, part)] + if part == 0 { -r[(k, 1)] } else { r[(k, 0)] }
    });
    let accelerations = faer::Scale(omega * omega) * &system.expand(u.as_ref());
    let inertia = field_loads + system.inertia_loads(accelerations.as_ref());
    let at_balance = system.rigid_body(&balance).transpose() * &inertia;
    let air = &wing.root_rows * &box_loads;
    let part = |c: usize, part: usize| air[(c, part)] + at_balance[(c + 2, part)];
    std::array::from_fn(|c| (part(c, 0), part(c, 1)))
}

/// Largest difference, as a share of the channel's size.
fn apart(a: &Response, b: &Response) -> f64 {
    let of = |c: usize| (a[c].0 - b[c].0).hypot(a[c].1 - b[c].1) / b[c].0.hypot(b[c].1);
    (0..3).map(of).fold(0.0, f64::max)
}

fn undamped(file: &WingFile, modes: usize) -> RigSettings {
    RigSettings { modes, ..RigSettings::new(0.0, file.pitch_axis_x()) }
}

#[test]
fn pitching_at_a_frequency_loads_the_root_as_the_whole_structure_without_modes_does() {
    let (file, wing) = wing_with(|_| ());
    let corrections = uneven(&wing);
    let padded = wing.padded(&corrections).unwrap();
    let all = Rig::new(&wing, undamped(&file, usize::MAX)).unwrap();
    let kept = Rig::new(&wing, undamped(&file, 20)).unwrap();
    for v_m_s in [0.0, 30.0] {
        let flow = Flow { v_m_s, rho_kg_m3: 1.225 };
        let (all, kept) = (all.at(flow, &corrections).unwrap(), kept.at(flow, &corrections).unwrap());
        for f_hz in [0.5, 2.0, 4.0, 9.0] {
            let omega = TAU * f_hz;
            let by_alpha = wing.pressures_by_alpha();
            let slowness = if v_m_s > 0.0 { omega / v_m_s } else { 0.0 };
            let turning = Mat::from_fn(wing.lattice.len(), 1, |j, _| {
                let panel = &wing.lattice.boxes[j];
                slowness * (panel.three_quarter_point().x - file.pitch_axis_x()) * panel.normal().z
            });
            let turning = wing.pressures(turning.as_ref());
            let cp =
                Mat::from_fn(
                    wing.lattice.len(),
                    2,
                    |j, part| {
                        if part == 0 { by_alpha[j] } else { turning[(j, 0)] }
                    },
                );
            let forcing = Forcing { cp, fields: [GRAVITY_M_S2, 0.0, omega * omega] };
            let exact = without_modes(&file, &wing, flow, &padded, omega, &forcing);
            let whole = apart(&of_rig(&all, omega, &swing(&all, omega)), &exact);
            let truncated = apart(&of_rig(&kept, omega, &swing(&kept, omega)), &exact);
            assert!(whole < 1e-6, "all modes at {v_m_s} m/s, {f_hz} Hz: {whole:e}");
            assert!(truncated < 5e-3, "twenty modes at {v_m_s} m/s, {f_hz} Hz: {truncated:e}");
        }
    }
}

#[test]
fn a_swinging_aileron_loads_the_root_behind_its_actuator_as_the_structure_without_modes_does() {
    let (file, wing) = wing_with(|_| ());
    let corrections = uneven(&wing);
    let padded = wing.padded(&corrections).unwrap();
    let flow = Flow { v_m_s: 30.0, rho_kg_m3: 1.225 };
    let rig = Rig::new(&wing, undamped(&file, usize::MAX)).unwrap();
    let model = rig.at(flow, &corrections).unwrap();
    // the assumed actuator: 15 Hz, 0.8
    let (natural, damping) = (TAU * 15.0, 0.8);
    for f_hz in [1.0, 6.0] {
        let omega = TAU * f_hz;
        let (re, im) = (natural * natural - omega * omega, 2.0 * damping * natural * omega);
        let size = natural * natural / (re * re + im * im);
        for control in 0..wing.controls.len() {
            let cp = Mat::from_fn(wing.lattice.len(), 2, |j, part| {
                let share = if part == 0 { size * re } else { -size * im };
                wing.pressures_by_control()[(j, control)] * share
            });
            let exact = without_modes(&file, &wing, flow, &padded, omega, &Forcing { cp, fields: [0.0; 3] });
            let mut v = Mat::zeros(model.inputs.len(), 2);
            v[(Inputs::CONTROLS + control, 0)] = 1.0;
            let difference = apart(&of_rig(&model, omega, &v), &exact);
            assert!(difference < 1e-6, "control {control} at {f_hz} Hz: {difference:e}");
        }
    }
}
