//! From a rig, a flow and corrections to a linear system with named inputs and outputs.

use crate::air::AirParts;
use crate::linear::{Layout, Linear};
use crate::rig::Rig;
use crate::rig_model::RigModel;
use crate::state_space::state_space;
use aero::{Corrections, Flow};
use faer::Mat;
use faer::linalg::solvers::Solve;

/// What the air and gravity do to a rig at a flow, before the modes are set free: the displacement of the s-set and the
/// box loads, by everything in the layout.
pub(crate) struct OpenLoop {
    pub(crate) displacement: Linear,
    pub(crate) box_loads: Linear,
}

/// The open loop of a rig at a flow; corrections are of the whole lattice.
pub(crate) fn open_loop(
    rig: &Rig<'_>,
    flow: Flow,
    corrections: &Corrections,
    air: &AirParts<'_>,
) -> OpenLoop {
    let layout = Layout {
        modes: rig.operators.omega_rad_s.len(),
        slow_modes: air.slow_modes,
        controls: rig.wing.controls.len(),
        poles: air.families.map(|family| family.lags.len()),
        fields: Rig::fields(),
    };
    let loads = box_loads(rig, flow, corrections, layout, air);
    let (displacement, box_loads) = elastic(rig, flow, corrections, loads);
    OpenLoop { displacement, box_loads }
}

/// Builds the state space of a rig at a flow; corrections are of the whole lattice.
pub(crate) fn assemble(rig: &Rig<'_>, flow: Flow, corrections: &Corrections, air: &AirParts<'_>) -> RigModel {
    let OpenLoop { displacement, box_loads } = open_loop(rig, flow, corrections, air);
    let (o, layout) = (&rig.operators, box_loads.layout);
    let modal = modal_accelerations(rig, &box_loads);
    let mut loads = box_loads.mapped(o.loads.air.as_ref());
    loads.by += inertia(rig, layout);
    let accelerations = layout.modal_accelerations().start;
    let tip = tip(rig, &displacement);
    let mut sensors = Linear::zeros(o.sensor_arms_m.len(), layout);
    for (s, arm_m) in o.sensor_arms_m.iter().enumerate() {
        for mode in 0..layout.modes {
            sensors.by[(s, accelerations + mode)] = o.sensor_shapes[(s, mode)];
        }
        // nose-up rotation lowers what is aft; the field is minus the rotation's acceleration
        sensors.by[(s, layout.field(2))] = *arm_m;
    }
    let outputs = [loads, tip, sensors].map(|part| part.with_modal(&modal));
    state_space(rig, flow, &modal, &outputs, air.families.map(|family| family.poles_per_m.as_slice()))
}

/// The share of gravity and of accelerated masses in the loads that are looked at: rows by the layout's columns.
pub(crate) fn inertia(rig: &Rig<'_>, layout: Layout) -> Mat<f64> {
    let o = &rig.operators;
    let mut by = Mat::zeros(o.loads.names.len(), layout.len());
    let accelerations = layout.modal_accelerations().start;
    for row in 0..o.loads.names.len() {
        // forces of gravity, less what accelerates the masses
        for mode in 0..layout.modes {
            by[(row, accelerations + mode)] -= o.loads.by_modes[(row, mode)];
        }
        for field in 0..layout.fields {
            by[(row, layout.field(field))] += o.loads.by_fields[(row, field)];
        }
        // the tare: wind off, alpha = 0, the field is g down
        by[(row, layout.one())] += o.loads.by_fields[(row, 1)] * rig.wing.gravity_m_s2;
    }
    by
}

/// Height of the tip above its wind-off place at alpha = 0.
pub(crate) fn tip(rig: &Rig<'_>, displacement: &Linear) -> Linear {
    let layout = displacement.layout;
    let Some(supported) = &rig.wing.supported else { return Linear::zeros(1, layout) };
    let z = supported.tip_z;
    let unit = Mat::from_fn(1, supported.size(), |_, j| f64::from(u8::from(j == z)));
    let mut tip = displacement.mapped(unit.as_ref());
    tip.by[(0, layout.one())] += supported.sag[(z, 2)] * rig.wing.gravity_m_s2;
    tip
}

/// `xi'' = Phiᵀ Gᵀ P + Phiᵀ M r c - Omega² xi - 2 zeta Omega xi'`, solved for xi'': the air's share of it (apparent
/// mass) is brought to the left.
fn modal_accelerations(rig: &Rig<'_>, box_loads: &Linear) -> Linear {
    let (o, layout) = (&rig.operators, box_loads.layout);
    let Some(supported) = &rig.wing.supported else { return Linear::zeros(0, layout) };
    let gathered = Linear { layout, by: supported.gather(box_loads.by.as_ref()) };
    let mut modal = gathered.mapped(o.shapes.transpose());
    for mode in 0..layout.modes {
        let omega = o.omega_rad_s[mode];
        modal.by[(mode, layout.motion(0).start + mode)] -= omega * omega;
        modal.by[(mode, layout.motion(1).start + mode)] -= 2.0 * rig.settings.damping_ratio * omega;
        for field in 0..layout.fields {
            modal.by[(mode, layout.field(field))] += o.modal_fields[(mode, field)];
        }
    }
    let columns = layout.modal_accelerations();
    let mass = Mat::from_fn(layout.modes, layout.modes, |i, j| {
        f64::from(u8::from(i == j)) - modal.by[(i, columns.start + j)]
    });
    modal.by.as_mut().subcols_mut(columns.start, columns.len()).fill(0.0);
    if layout.modes > 0 {
        modal.by = mass.partial_piv_lu().solve(&modal.by);
    }
    modal
}

/// Box loads of the inputs and of everything the modes do beyond their steady incidence, which [`elastic`] adds with
/// the displacement it belongs to.
fn box_loads(
    rig: &Rig<'_>,
    flow: Flow,
    corrections: &Corrections,
    layout: Layout,
    air: &AirParts<'_>,
) -> Linear {
    let wing = rig.wing;
    let at_rest = &rig.operators.air.rational.steady;
    let boxes = wing.lattice.len();
    let q_pa = flow.dynamic_pressure_pa();
    let mut cp = Mat::zeros(boxes, layout.len());
    let mut place = |to: usize, part: &Mat<f64>, from: usize, factor: f64| {
        for j in 0..boxes {
            cp[(j, to)] += factor * part[(j, from)];
        }
    };
    for motion in 0..layout.motions() {
        let of = air.families[layout.family_of(motion)];
        place(layout.motion(0).start + motion, &of.steady, motion, q_pa);
        if motion < layout.modes {
            // that of the modes at rest comes with their displacement
            place(layout.motion(0).start + motion, at_rest, motion, -q_pa);
        }
        // q/V and q/V²: both finite without a stream
        place(layout.motion(1).start + motion, &of.rate, motion, 0.5 * flow.rho_kg_m3 * flow.v_m_s);
        place(layout.motion(2).start + motion, &of.second, motion, 0.5 * flow.rho_kg_m3);
    }
    for (lag, (family, pole, motion)) in layout.every_lag().enumerate() {
        place(layout.first_lag() + lag, &air.families[family].lags[pole], motion, q_pa);
    }
    for (j, camber) in wing.pressures_of_camber().iter().enumerate() {
        cp[(j, layout.one())] = q_pa * camber;
    }
    let loads = wing.integration.corrected(corrections);
    let mut by = loads.of_pressures(1.0, cp.as_ref());
    loads.add_offset(q_pa, &mut by, layout.one());
    Linear { layout, by }
}

/// The displacement of the s-set (small loop of the static residual solved) and the box loads it brings with it.
fn elastic(rig: &Rig<'_>, flow: Flow, corrections: &Corrections, loads: Linear) -> (Linear, Linear) {
    let (wing, o, layout) = (rig.wing, &rig.operators, loads.layout);
    let Some(supported) = &wing.supported else { return (Linear::zeros(0, layout), loads) };
    let loads_of = wing.integration.corrected(corrections);
    let by_displacement = loads_of.of_pressures(flow.dynamic_pressure_pa(), wing.pressures_by_displacement());
    let stiffness = supported.gather(by_displacement.as_ref());
    let size = supported.size();
    let product = &o.residual * &stiffness;
    let factor =
        Mat::from_fn(size, size, |i, j| f64::from(u8::from(i == j)) - product[(i, j)]).partial_piv_lu();
    let mut displacement = &o.residual * &supported.gather(loads.by.as_ref());
    for i in 0..size {
        for mode in 0..layout.modes {
            displacement[(i, layout.motion(0).start + mode)] += o.shapes[(i, mode)];
        }
        for field in 0..layout.fields {
            displacement[(i, layout.field(field))] += o.residual_fields[(i, field)];
        }
    }
    let displacement = Linear { layout, by: factor.solve(&displacement) };
    let box_loads = displacement.mapped(by_displacement.as_ref()).plus(&loads);
    (displacement, box_loads)
}
