//! What a rig needs at every airspeed, computed once: modes on the s-set, static residuals, pressures of motion.

use crate::rig::{RigError, RigSettings};
use coupling::supported::restrict;
use coupling::{ElasticWing, SupportedStructure};
use faer::Mat;
use nalgebra::Point3;
use structure::{Flexibility, Modes, System, normal_modes};

/// Fields of acceleration: aft, up, nose-up rotation about the pitch axis.
pub(crate) const FIELDS: usize = 3;

/// See the module.
#[derive(Debug)]
pub(crate) struct RigOperators {
    /// Natural frequencies, rad/s, m of them.
    pub(crate) omega_rad_s: Vec<f64>,
    /// Phi on the s-set, s by m.
    pub(crate) shapes: Mat<f64>,
    /// F_r, s by s: flexibility of the truncated modes.
    pub(crate) residual: Mat<f64>,
    /// S_r, s by fields: static answer of the truncated modes to the fields.
    pub(crate) residual_fields: Mat<f64>,
    /// Phiᵀ M r, m by fields.
    pub(crate) modal_fields: Mat<f64>,
    /// r_bᵀ M r, rows Fz, Mx, My by fields.
    pub(crate) rigid_inertia: Mat<f64>,
    /// r_bᵀ M Phi, rows Fz, Mx, My by m.
    pub(crate) modal_inertia: Mat<f64>,
    /// Q D2 G Phi, boxes by m: Cp per unit modal velocity times V.
    pub(crate) cp_rates: Mat<f64>,
    /// Q (x_j - x_p) n_z, boxes by 1: Cp per unit pitch rate times V.
    pub(crate) cp_pitch_rate: Mat<f64>,
    /// Phi at each sensor's z, sensors by m.
    pub(crate) sensor_shapes: Mat<f64>,
    /// x of each sensor aft of the pitch axis, m.
    pub(crate) sensor_arms_m: Vec<f64>,
}

impl RigOperators {
    pub(crate) fn new(wing: &ElasticWing, settings: &RigSettings) -> Result<Self, RigError> {
        let parts = match (&wing.supported, &wing.structure) {
            (Some(supported), Some((system, _))) => structural(wing, supported, system, settings)?,
            _ => rigid(),
        };
        let boxes = wing.lattice.len();
        let modes = parts.omega_rad_s.len();
        let mut w = Mat::zeros(boxes, modes + 1);
        if let Some(supported) = &wing.supported {
            let motion = &supported.k_displacements() * &parts.shapes;
            for j in 0..boxes {
                // w = theta' (x_34 - x_mid)/V - h'/V: nose-up rate about the midpoint, minus heave rate
                let quarter = 0.25 * wing.lattice.boxes[j].chord_m();
                for mode in 0..modes {
                    w[(j, mode)] = quarter * motion[(2 * j + 1, mode)] - motion[(2 * j, mode)];
                }
            }
        }
        for (j, panel) in wing.lattice.boxes.iter().enumerate() {
            w[(j, modes)] = (panel.three_quarter_point().x - settings.pitch_axis_x_m) * panel.normal().z;
        }
        let cp = wing.pressures(w.as_ref());
        Ok(Self {
            cp_rates: cp.as_ref().subcols(0, modes).to_owned(),
            cp_pitch_rate: cp.as_ref().subcols(modes, 1).to_owned(),
            ..parts
        })
    }
}

/// A wing without structure: no modes, no inertia.
fn rigid() -> RigOperators {
    RigOperators {
        omega_rad_s: Vec::new(),
        shapes: Mat::zeros(0, 0),
        residual: Mat::zeros(0, 0),
        residual_fields: Mat::zeros(0, FIELDS),
        modal_fields: Mat::zeros(0, FIELDS),
        rigid_inertia: Mat::zeros(3, FIELDS),
        modal_inertia: Mat::zeros(3, 0),
        cp_rates: Mat::zeros(0, 0),
        cp_pitch_rate: Mat::zeros(0, 0),
        sensor_shapes: Mat::zeros(0, 0),
        sensor_arms_m: Vec::new(),
    }
}

fn structural(
    wing: &ElasticWing,
    supported: &SupportedStructure,
    system: &System,
    settings: &RigSettings,
) -> Result<RigOperators, RigError> {
    let modes = modes_of(system, settings.modes)?;
    let count = modes.omega_rad_s.len();
    let shapes_g = system.expand(modes.shapes.as_ref());
    let shapes = restrict(shapes_g.as_ref(), &supported.s_dofs);
    let balance = wing.balance.point;
    let fields_g = fields(system, &Point3::new(settings.pitch_axis_x_m, balance.y, balance.z));
    let field_loads = system.inertia_loads(fields_g.as_ref());
    let flexibility = Flexibility::new(system).map_err(coupling::CouplingError::from)?;
    let answer =
        system.expand(flexibility.displacements(system.reduce(field_loads.as_ref()).as_ref()).as_ref());
    let answer = restrict(answer.as_ref(), &supported.s_dofs);
    let modal_fields = shapes_g.transpose() * &field_loads;
    let soft = |m: usize| 1.0 / modes.omega_rad_s[m].powi(2);
    let weighted = Mat::from_fn(supported.size(), count, |i, m| shapes[(i, m)] * soft(m));
    let rigid = system.rigid_body(&balance);
    let to_root = |loads: &Mat<f64>| {
        let all = rigid.transpose() * loads;
        Mat::from_fn(3, loads.ncols(), |row, column| all[(row + 2, column)])
    };
    let sensor = |s: usize| settings.sensors[s].1;
    Ok(RigOperators {
        residual: &supported.flexibility - &weighted * shapes.transpose(),
        residual_fields: answer - &weighted * &modal_fields,
        rigid_inertia: to_root(&field_loads),
        modal_inertia: to_root(&system.inertia_loads(shapes_g.as_ref())),
        modal_fields,
        cp_rates: Mat::zeros(0, 0),
        cp_pitch_rate: Mat::zeros(0, 0),
        sensor_shapes: Mat::from_fn(settings.sensors.len(), count, |s, m| shapes_g[(6 * sensor(s) + 2, m)]),
        sensor_arms_m: (0..settings.sensors.len())
            .map(|s| system.points()[sensor(s)].x - settings.pitch_axis_x_m)
            .collect(),
        omega_rad_s: modes.omega_rad_s,
        shapes,
    })
}

/// As many modes as asked for, or all there are.
fn modes_of(system: &System, wanted: usize) -> Result<Modes, RigError> {
    Ok(normal_modes(system, wanted.min(system.free_count()))?)
}

/// Unit fields of acceleration on the g-set: aft, up, nose-up rotation about the pitch axis.
fn fields(system: &System, axis: &Point3<f64>) -> Mat<f64> {
    let rigid = system.rigid_body(axis);
    Mat::from_fn(rigid.nrows(), FIELDS, |dof, field| rigid[(dof, [0, 2, 4][field])])
}
