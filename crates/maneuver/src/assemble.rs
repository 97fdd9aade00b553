//! From a rig, a flow and corrections to a linear system with named inputs and outputs.

use crate::rig::Rig;
use crate::rig_model::{Inputs, RigModel};
use aero::{Corrections, Flow};
use faer::linalg::solvers::Solve;
use faer::{Mat, MatRef};

/// Aerodynamic inputs: one (camber, offset), angle of attack, its rate, then each control's deflection.
const AIR_INPUTS: usize = 3;

/// What depends linearly on modal displacement, modal velocity, aerodynamic inputs and fields of acceleration.
struct Linear {
    xi: Mat<f64>,
    rate: Mat<f64>,
    air: Mat<f64>,
    fields: Mat<f64>,
}

impl Linear {
    /// left * self
    fn mapped(&self, left: MatRef<'_, f64>) -> Self {
        Self {
            xi: left * &self.xi,
            rate: left * &self.rate,
            air: left * &self.air,
            fields: left * &self.fields,
        }
    }

    fn plus(self, other: &Self) -> Self {
        Self {
            xi: self.xi + &other.xi,
            rate: self.rate + &other.rate,
            air: self.air + &other.air,
            fields: self.fields + &other.fields,
        }
    }
}

/// Builds the state space of a rig at a flow; corrections are of the whole lattice.
pub(crate) fn assemble(rig: &Rig<'_>, flow: Flow, corrections: &Corrections) -> RigModel {
    let loads = box_loads(rig, flow, corrections);
    let o = &rig.operators;
    let modes = o.omega_rad_s.len();
    let (displacement, box_loads) = elastic(rig, flow, corrections, loads);
    // xi'' = Phiᵀ Gᵀ P + Phiᵀ M r c - Omega² xi - 2 zeta Omega xi'
    let mut modal = match &rig.wing.supported {
        Some(supported) => {
            let gathered = Linear {
                xi: supported.gather(box_loads.xi.as_ref()),
                rate: supported.gather(box_loads.rate.as_ref()),
                air: supported.gather(box_loads.air.as_ref()),
                fields: supported.gather(box_loads.fields.as_ref()),
            };
            gathered.mapped(o.shapes.transpose())
        }
        None => zeros(0, 0, rig.wing.controls.len()),
    };
    for mode in 0..modes {
        let omega = o.omega_rad_s[mode];
        modal.xi[(mode, mode)] -= omega * omega;
        modal.rate[(mode, mode)] -= 2.0 * rig.settings.damping_ratio * omega;
        for field in 0..Rig::fields() {
            modal.fields[(mode, field)] += o.modal_fields[(mode, field)];
        }
    }
    let mut root = box_loads.mapped(rig.wing.root_rows.as_ref());
    root = minus_inertia(root, &o.modal_inertia, &modal);
    for row in 0..3 {
        for field in 0..Rig::fields() {
            root.fields[(row, field)] += o.rigid_inertia[(row, field)];
        }
        // the tare: wind off, alpha = 0, the field is g down
        root.air[(row, 0)] += o.rigid_inertia[(row, 1)] * rig.wing.gravity_m_s2;
    }
    let mut tip = zeros(1, modes, rig.wing.controls.len());
    if let Some(supported) = &rig.wing.supported {
        let z = supported.tip_z;
        tip = displacement.mapped(unit_row(supported.size(), z).as_ref());
        tip.air[(0, 0)] += supported.sag[(z, 2)] * rig.wing.gravity_m_s2;
    }
    let mut sensors = modal.mapped(o.sensor_shapes.as_ref());
    for (s, arm_m) in o.sensor_arms_m.iter().enumerate() {
        // nose-up rotation lowers what is aft; the field is minus the rotation's acceleration
        sensors.fields[(s, 2)] += arm_m;
    }
    state_space(rig, flow, &modal, &[&root, &tip, &sensors])
}

fn zeros(rows: usize, modes: usize, controls: usize) -> Linear {
    Linear {
        xi: Mat::zeros(rows, modes),
        rate: Mat::zeros(rows, modes),
        air: Mat::zeros(rows, AIR_INPUTS + controls),
        fields: Mat::zeros(rows, Rig::fields()),
    }
}

fn unit_row(size: usize, place: usize) -> Mat<f64> {
    Mat::from_fn(1, size, |_, j| f64::from(u8::from(j == place)))
}

/// root - r_bᵀ M Phi xi''
fn minus_inertia(root: Linear, inertia: &Mat<f64>, modal: &Linear) -> Linear {
    let negative = Mat::from_fn(inertia.nrows(), inertia.ncols(), |i, j| -inertia[(i, j)]);
    root.plus(&modal.mapped(negative.as_ref()))
}

/// Box loads of modal velocity and aerodynamic inputs on the undeformed wing.
fn box_loads(rig: &Rig<'_>, flow: Flow, corrections: &Corrections) -> Linear {
    let (wing, o) = (rig.wing, &rig.operators);
    let q_pa = flow.dynamic_pressure_pa();
    let slowness = if flow.v_m_s > 0.0 { 1.0 / flow.v_m_s } else { 0.0 };
    let boxes = wing.lattice.len();
    let cp_air = Mat::from_fn(boxes, AIR_INPUTS + wing.controls.len(), |j, input| match input {
        0 => wing.pressures_of_camber()[j],
        1 => wing.pressures_by_alpha()[j],
        2 => o.cp_pitch_rate[(j, 0)] * slowness,
        control => wing.pressures_by_control()[(j, control - AIR_INPUTS)],
    });
    let mut air = wing.k_loads_of_pressures(q_pa, cp_air.as_ref(), corrections);
    for (j, f_e) in corrections.pressure_offset.iter().enumerate() {
        let lift = q_pa * wing.integration.area(j) * f_e;
        air[(2 * j, 0)] += lift;
        air[(2 * j + 1, 0)] += lift * wing.integration.moment_arm(j);
    }
    let modes = o.omega_rad_s.len();
    let cp_rate = Mat::from_fn(boxes, modes, |j, mode| o.cp_rates[(j, mode)] * slowness);
    Linear {
        xi: Mat::zeros(2 * boxes, modes),
        rate: wing.k_loads_of_pressures(q_pa, cp_rate.as_ref(), corrections),
        air,
        fields: Mat::zeros(2 * boxes, Rig::fields()),
    }
}

/// The displacement of the s-set (small loop of the static residual solved) and the box loads it brings with it.
fn elastic(rig: &Rig<'_>, flow: Flow, corrections: &Corrections, loads: Linear) -> (Linear, Linear) {
    let (wing, o) = (rig.wing, &rig.operators);
    let Some(supported) = &wing.supported else { return (zeros(0, 0, wing.controls.len()), loads) };
    let by_displacement =
        wing.k_loads_of_pressures(flow.dynamic_pressure_pa(), wing.pressures_by_displacement(), corrections);
    let stiffness = supported.gather(by_displacement.as_ref());
    let size = supported.size();
    let product = &o.residual * &stiffness;
    let factor =
        Mat::from_fn(size, size, |i, j| f64::from(u8::from(i == j)) - product[(i, j)]).partial_piv_lu();
    let answer = |k_loads: &Mat<f64>| factor.solve(&o.residual * &supported.gather(k_loads.as_ref()));
    let displacement = Linear {
        xi: factor.solve(&o.shapes),
        rate: answer(&loads.rate),
        air: answer(&loads.air),
        fields: factor.solve(&o.residual_fields),
    };
    let box_loads = displacement.mapped(by_displacement.as_ref()).plus(&loads);
    (displacement, box_loads)
}

/// States: modal displacements, modal velocities, deflections, their rates.
fn state_space(rig: &Rig<'_>, flow: Flow, modal: &Linear, outputs: &[&Linear]) -> RigModel {
    let modes = rig.operators.omega_rad_s.len();
    let controls = rig.wing.controls.len();
    let inputs = Inputs::new(controls);
    let states = 2 * modes + 2 * controls;
    let place = |linear: &Linear, row: usize| -> (Vec<f64>, Vec<f64>) {
        let mut by_state = vec![0.0; states];
        let mut by_input = vec![0.0; inputs.len()];
        for mode in 0..modes {
            by_state[mode] = linear.xi[(row, mode)];
            by_state[modes + mode] = linear.rate[(row, mode)];
        }
        for control in 0..controls {
            by_state[2 * modes + control] = linear.air[(row, AIR_INPUTS + control)];
        }
        by_input[Inputs::ONE] = linear.air[(row, 0)];
        by_input[Inputs::ALPHA] = linear.air[(row, 1)];
        by_input[Inputs::ALPHA_RATE] = linear.air[(row, 2)];
        // c = (g sin a, -g cos a, -a'')
        by_input[Inputs::G_SIN] = linear.fields[(row, 0)];
        by_input[Inputs::G_COS] = -linear.fields[(row, 1)];
        by_input[Inputs::ALPHA_SECOND] = -linear.fields[(row, 2)];
        (by_state, by_input)
    };
    let mut a = Mat::zeros(states, states);
    let mut b = Mat::zeros(states, inputs.len());
    for mode in 0..modes {
        a[(mode, modes + mode)] = 1.0;
        let (by_state, by_input) = place(modal, mode);
        by_state.into_iter().enumerate().for_each(|(k, value)| a[(modes + mode, k)] = value);
        by_input.into_iter().enumerate().for_each(|(k, value)| b[(modes + mode, k)] = value);
    }
    let actuator = rig.settings.actuator;
    let omega = std::f64::consts::TAU * actuator.frequency_hz;
    for control in 0..controls {
        let (at, rate) = (2 * modes + control, 2 * modes + controls + control);
        a[(at, rate)] = 1.0;
        a[(rate, at)] = -omega * omega;
        a[(rate, rate)] = -2.0 * actuator.damping_ratio * omega;
        b[(rate, Inputs::CONTROLS + control)] = omega * omega;
    }
    let rows: Vec<(Vec<f64>, Vec<f64>)> =
        outputs.iter().flat_map(|output| (0..output.xi.nrows()).map(|row| place(output, row))).collect();
    RigModel {
        c: Mat::from_fn(rows.len(), states, |row, k| rows[row].0[k]),
        d: Mat::from_fn(rows.len(), inputs.len(), |row, k| rows[row].1[k]),
        a,
        b,
        inputs,
        controls: rig.wing.controls.iter().map(|control| control.name.clone()).collect(),
        sensors: rig.settings.sensors.iter().map(|(name, _)| name.clone()).collect(),
        flow,
        gravity_m_s2: rig.wing.gravity_m_s2,
        cutoff_hz: rig.settings.cutoff_hz,
    }
}
