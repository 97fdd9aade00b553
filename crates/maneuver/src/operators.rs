//! What a rig needs at every airspeed, computed once: modes on the s-set, static residuals, pressures of motion.

use crate::air::{MotionColumns, SharedAir, UnsteadyAir};
use crate::load_rows::{LoadRows, Momentum};
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
    /// Phi on the g-set.
    pub(crate) shapes_g: Mat<f64>,
    /// F_r, s by s: flexibility of the truncated modes.
    pub(crate) residual: Mat<f64>,
    /// S_r, s by fields: static answer of the truncated modes to the fields.
    pub(crate) residual_fields: Mat<f64>,
    /// Phiᵀ M r, m by fields.
    pub(crate) modal_fields: Mat<f64>,
    /// What is looked at: the balance's three loads first, then stations and strips.
    pub(crate) loads: LoadRows,
    /// Pressures of motion: the modes, root pitch, then the controls.
    pub(crate) air: UnsteadyAir,
    /// Phi at each sensor's z, sensors by m.
    pub(crate) sensor_shapes: Mat<f64>,
    /// x of each sensor aft of the pitch axis, m.
    pub(crate) sensor_arms_m: Vec<f64>,
}

/// The structure's part.
struct Structural {
    omega_rad_s: Vec<f64>,
    shapes: Mat<f64>,
    shapes_g: Mat<f64>,
    residual: Mat<f64>,
    residual_fields: Mat<f64>,
    modal_fields: Mat<f64>,
    loads: LoadRows,
    sensor_shapes: Mat<f64>,
    sensor_arms_m: Vec<f64>,
}

impl RigOperators {
    pub(crate) fn new(
        wing: &ElasticWing,
        settings: &RigSettings,
        shared: Option<&SharedAir>,
    ) -> Result<Self, RigError> {
        let parts = match (&wing.supported, &wing.structure) {
            (Some(supported), Some((system, _))) => structural(wing, supported, system, settings)?,
            _ => rigid(wing, settings),
        };
        Self::of_parts(parts, wing, settings, shared)
    }

    /// The same structure in air of other settings.
    pub(crate) fn in_air(
        &self,
        wing: &ElasticWing,
        settings: &RigSettings,
        shared: Option<&SharedAir>,
    ) -> Result<Self, RigError> {
        let parts = Structural {
            omega_rad_s: self.omega_rad_s.clone(),
            shapes: self.shapes.clone(),
            shapes_g: self.shapes_g.clone(),
            residual: self.residual.clone(),
            residual_fields: self.residual_fields.clone(),
            modal_fields: self.modal_fields.clone(),
            loads: self.loads.clone(),
            sensor_shapes: self.sensor_shapes.clone(),
            sensor_arms_m: self.sensor_arms_m.clone(),
        };
        Self::of_parts(parts, wing, settings, shared)
    }

    fn of_parts(
        parts: Structural,
        wing: &ElasticWing,
        settings: &RigSettings,
        shared: Option<&SharedAir>,
    ) -> Result<Self, RigError> {
        let motion = wing.supported.as_ref().map(|supported| &supported.k_displacements() * &parts.shapes);
        let columns = columns(wing, motion.as_ref(), settings.pitch_axis_x_m);
        let modes = parts.omega_rad_s.len();
        let bent = wing.pressures_by_displacement() * &parts.shapes;
        let steady = Mat::from_fn(wing.lattice.len(), columns.still.ncols(), |j, column| match column {
            mode if mode < modes => bent[(j, mode)],
            pitch if pitch == modes => wing.pressures_by_alpha()[j],
            control => wing.pressures_by_control()[(j, control - modes - 1)],
        });
        let rate = wing.pressures(columns.moving.as_ref());
        let rows = looked_at(wing, motion.as_ref());
        let air = UnsteadyAir::new(settings.air, wing, columns, steady, rate, rows, shared)
            .map_err(coupling::CouplingError::from)?;
        Ok(Self {
            omega_rad_s: parts.omega_rad_s,
            shapes: parts.shapes,
            shapes_g: parts.shapes_g,
            residual: parts.residual,
            residual_fields: parts.residual_fields,
            modal_fields: parts.modal_fields,
            loads: parts.loads,
            sensor_shapes: parts.sensor_shapes,
            sensor_arms_m: parts.sensor_arms_m,
            air,
        })
    }
}

/// Incidences of the modes (`motion`: two rows a box by modes), of root pitch and of the controls.
fn columns(wing: &ElasticWing, motion: Option<&Mat<f64>>, pitch_axis_x_m: f64) -> MotionColumns {
    let boxes = wing.lattice.len();
    let modes = motion.map_or(0, Mat::ncols);
    let mut still = Mat::zeros(boxes, modes + 1 + wing.controls.len());
    let mut moving = Mat::zeros(boxes, still.ncols());
    for (j, panel) in wing.lattice.boxes.iter().enumerate() {
        if let Some(motion) = motion {
            // theta + theta' (x_34 - x_mid)/V - h'/V
            let quarter = 0.25 * panel.chord_m();
            for mode in 0..modes {
                still[(j, mode)] = motion[(2 * j + 1, mode)];
                moving[(j, mode)] = quarter * motion[(2 * j + 1, mode)] - motion[(2 * j, mode)];
            }
        }
        still[(j, modes)] = panel.normal().z;
        moving[(j, modes)] = (panel.three_quarter_point().x - pitch_axis_x_m) * panel.normal().z;
    }
    for (c, control) in wing.controls.iter().enumerate() {
        let (slope, lever) = (control.column(boxes), control.rate_column_m(boxes));
        for j in 0..boxes {
            still[(j, modes + 1 + c)] = slope[j];
            moving[(j, modes + 1 + c)] = lever[j];
        }
    }
    MotionColumns { still, moving }
}

/// Generalised forces of the modes and root loads per unit pressure coefficient and dynamic pressure, rows by boxes:
/// what the poles are chosen for, without corrections.
fn looked_at(wing: &ElasticWing, motion: Option<&Mat<f64>>) -> Mat<f64> {
    let modes = motion.map_or(0, Mat::ncols);
    let rows = Mat::from_fn(modes + 3, wing.root_rows.ncols(), |row, k| match motion {
        Some(motion) if row < modes => motion[(k, row)],
        _ => wing.root_rows[(row - modes, k)],
    });
    wing.integration.rows_by_pressure(rows.as_ref())
}

/// A wing without structure: no modes, no inertia.
fn rigid(wing: &ElasticWing, settings: &RigSettings) -> Structural {
    Structural {
        omega_rad_s: Vec::new(),
        shapes: Mat::zeros(0, 0),
        shapes_g: Mat::zeros(0, 0),
        residual: Mat::zeros(0, 0),
        residual_fields: Mat::zeros(0, FIELDS),
        modal_fields: Mat::zeros(0, FIELDS),
        loads: loads(wing, settings, None),
        sensor_shapes: Mat::zeros(0, 0),
        sensor_arms_m: Vec::new(),
    }
}

fn loads(wing: &ElasticWing, settings: &RigSettings, momentum: Option<&Momentum<'_>>) -> LoadRows {
    let mut parts = vec![LoadRows::balance(wing, momentum, FIELDS)];
    parts.extend(settings.stations.iter().map(|s| LoadRows::station(wing, s, momentum, FIELDS)));
    if settings.strip_loads {
        parts.push(LoadRows::strips(wing, FIELDS, momentum.map_or(0, |m| m.modes.ncols())));
    }
    LoadRows::stacked(&parts)
}

fn structural(
    wing: &ElasticWing,
    supported: &SupportedStructure,
    system: &System,
    settings: &RigSettings,
) -> Result<Structural, RigError> {
    let modes = modes_of(system, settings.modes)?;
    let count = modes.omega_rad_s.len();
    let shapes_g = system.expand(modes.shapes.as_ref());
    let shapes = restrict(shapes_g.as_ref(), &supported.s_dofs);
    let balance = wing.balance.point;
    let fields_g = fields(system, &Point3::new(settings.pitch_axis_x_m, balance.y, balance.z));
    let field_loads = system.inertia_loads(fields_g.as_ref());
    let mode_loads = system.inertia_loads(shapes_g.as_ref());
    let flexibility = Flexibility::new(system).map_err(coupling::CouplingError::from)?;
    let answer =
        system.expand(flexibility.displacements(system.reduce(field_loads.as_ref()).as_ref()).as_ref());
    let answer = restrict(answer.as_ref(), &supported.s_dofs);
    let modal_fields = shapes_g.transpose() * &field_loads;
    let soft = |m: usize| 1.0 / modes.omega_rad_s[m].powi(2);
    let weighted = Mat::from_fn(supported.size(), count, |i, m| shapes[(i, m)] * soft(m));
    let sensor = |s: usize| settings.sensors[s].1;
    let momentum = Momentum { system, fields: field_loads.as_ref(), modes: mode_loads.as_ref() };
    Ok(Structural {
        residual: &supported.flexibility - &weighted * shapes.transpose(),
        residual_fields: answer - &weighted * &modal_fields,
        modal_fields,
        loads: loads(wing, settings, Some(&momentum)),
        sensor_shapes: Mat::from_fn(settings.sensors.len(), count, |s, m| shapes_g[(6 * sensor(s) + 2, m)]),
        sensor_arms_m: (0..settings.sensors.len())
            .map(|s| system.points()[sensor(s)].x - settings.pitch_axis_x_m)
            .collect(),
        omega_rad_s: modes.omega_rad_s,
        shapes,
        shapes_g,
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
