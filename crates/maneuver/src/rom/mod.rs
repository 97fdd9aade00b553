//! The reduced-order model of a rig at one flow: forces of the air on modes and balance by everything that moves, zone by
//! zone along the span, and what structure and masses add. From it frequency responses follow in microseconds, with
//! changes of the air, the structure and the masses ([`Change`]) applied exactly, without assembling the wing again.
//!
//! ```text
//! (s² M + s C + K - Z_m(s)) xi = Z_u(s) u + F c        c = (g sin a, -g cos a, -a'')
//! loads = R_m(s) xi + R_u(s) u + inertia
//! ```
//! Z and R are sums over zones of strips, so that factors along the span multiply zones. Thin here: changes of the air
//! do not pass through the static residual of the truncated modes, which belongs to the unchanged wing.

mod blocks;
mod change;
mod drive;
mod driven;
mod response;
mod spectrum;
mod stiffness;
mod structural;
mod zones;

pub use change::{Change, PointMass};
pub use drive::{Constants, Drive, Outputs};
pub use driven::Driven;
pub use spectrum::ResponseTable;
pub use stiffness::StiffnessParts;
pub use zones::Zones;

use crate::assemble::{inertia, open_loop, tip};
use crate::linear::Layout;
use crate::rig::{Actuator, Rig, RigError};
use aero::{Corrections, Flow};
use coupling::ElasticWing;
use faer::{Mat, MatRef};

/// Loads of the balance among the outputs: Fz, Mx, My.
pub(crate) const BALANCE: usize = 3;

/// See the module.
#[derive(Debug, Clone)]
pub struct ReducedOrderModel {
    /// The flow.
    pub flow: Flow,
    /// Names of the controls.
    pub controls: Vec<String>,
    /// The zones.
    pub zones: Zones,
    pub(crate) layout: Layout,
    pub(crate) poles_per_m: [Vec<f64>; 2],
    /// Air on modes and balance by the layout's columns: all of it, then the share of each zone.
    pub(crate) air: Mat<f64>,
    pub(crate) zone_air: Vec<Mat<f64>>,
    /// The share of each zone if its lift acted one chord further forward: a moment.
    pub(crate) zone_moment: Vec<Mat<f64>>,
    /// Apparent mass of still air, modes and balance by motions, times s².
    pub(crate) apparent: Mat<f64>,
    /// What air without memory gives by rates: modes and balance by motions, times s.
    pub(crate) quasi_steady_rate: Mat<f64>,
    /// The wake's memory ([`crate::air::Wake`]): modes and balance by motions, of incidence at rest and of that by rates (times V/s), one
    /// pair a pole, times s/(s + g V).
    pub(crate) wake: Vec<[Mat<f64>; 2]>,
    pub(crate) wake_poles_per_m: Vec<f64>,
    /// Lift of each zone by the layout's columns, N.
    pub(crate) lift: Mat<f64>,
    /// Lift of each zone on modes and balance, per N.
    pub(crate) zone_drive: Mat<f64>,
    /// Modes and balance per unit pitching moment coefficient of each zone; and per unit of upwash gradient, 1/m.
    pub(crate) unit_moment: Mat<f64>,
    pub(crate) unit_upwash: Vec<f64>,
    /// Tip by the layout's columns.
    pub(crate) tip: Mat<f64>,
    /// Gravity and accelerated masses in the balance's loads, by the layout's columns.
    pub(crate) inertia: Mat<f64>,
    pub(crate) modal_fields: Mat<f64>,
    /// Height of each zone's middle by modes.
    pub(crate) heights: Mat<f64>,
    /// Twist of each zone by modes.
    pub(crate) twists: Mat<f64>,
    pub(crate) omega_rad_s: Vec<f64>,
    pub(crate) damping_ratio: f64,
    pub(crate) actuator: Actuator,
    pub(crate) gravity_m_s2: f64,
    pub(crate) balance_m: [f64; 2],
    pub(crate) pitch_axis_x_m: f64,
    pub(crate) stiffness: Option<StiffnessParts>,
    pub(crate) cutoff_hz: f64,
}

impl ReducedOrderModel {
    /// The rig at a flow with corrections (one entry for each correctable box).
    ///
    /// # Errors
    /// As [`Rig::at`].
    pub fn new(
        rig: &Rig<'_>,
        flow: Flow,
        corrections: &Corrections,
        stiffness: Option<&StiffnessParts>,
    ) -> Result<Self, RigError> {
        rig.wing.at(flow, corrections)?;
        let (o, wing) = (&rig.operators, rig.wing);
        let corrections = wing.padded(corrections)?;
        let parts = o.air.at_airspeed(&o.omega_rad_s, flow.v_m_s);
        let open = open_loop(rig, flow, &corrections, &parts);
        let (layout, q_pa) = (open.box_loads.layout, flow.dynamic_pressure_pa());
        let zones = Zones::new(wing);
        let rows = Rows::new(rig, &zones);
        let steady = SteadyLoads::new(wing, flow, &corrections, &zones);
        let box_loads = open.box_loads.by.as_ref();
        let zone_air = zones.each(|boxes| rows.of_boxes(box_loads, boxes));
        let zone_moment =
            zones.each_with_chord(wing, |boxes, chord_m| rows.as_moment(box_loads, boxes, chord_m));
        Ok(Self {
            flow,
            controls: wing.control_names(),
            air: rows.all.as_ref() * box_loads,
            apparent: rows.of_pressures(wing, 0.5 * flow.rho_kg_m3, &corrections, &o.air.instant.second),
            quasi_steady_rate: rows.of_pressures(
                wing,
                0.5 * flow.rho_kg_m3 * flow.v_m_s,
                &corrections,
                &o.air.quasi_steady.rate,
            ),
            wake: (o.air.wake.still.iter().zip(&o.air.wake.moving))
                .map(|(still, moving)| {
                    [still, moving].map(|lag| rows.of_pressures(wing, q_pa, &corrections, lag))
                })
                .collect(),
            wake_poles_per_m: o.air.wake.poles_per_m.clone(),
            lift: zones.lift(wing, box_loads),
            zone_drive: rows.all.as_ref() * &steady.unit_lift,
            unit_moment: rows.all.as_ref() * &steady.unit_moment,
            unit_upwash: (rows.all.as_ref() * &steady.upwash).col_as_slice(0).to_vec(),
            tip: tip(rig, &open.displacement).by,
            inertia: inertia(rig, layout).subrows(0, BALANCE).to_owned(),
            modal_fields: o.modal_fields.clone(),
            heights: rows.heights,
            twists: rows.twists,
            poles_per_m: parts.families.map(|family| family.poles_per_m.clone()),
            omega_rad_s: o.omega_rad_s.clone(),
            damping_ratio: rig.settings.damping_ratio,
            actuator: rig.settings.actuator,
            gravity_m_s2: wing.gravity_m_s2,
            balance_m: [wing.balance.point.x, wing.balance.point.y],
            pitch_axis_x_m: rig.settings.pitch_axis_x_m,
            stiffness: stiffness.cloned(),
            cutoff_hz: rig.settings.cutoff_hz,
            layout,
            zones,
            zone_air,
            zone_moment,
        })
    }

    /// Number of modes.
    pub fn modes(&self) -> usize {
        self.layout.modes
    }

    /// y of the balance, m.
    pub(crate) fn balance_y_m(&self) -> f64 {
        self.balance_m[1]
    }

    /// Gravity, m/s².
    pub fn gravity_m_s2(&self) -> f64 {
        self.gravity_m_s2
    }

    /// Height of the outermost zone in the first mode; zero for a rigid wing.
    pub(crate) fn outer_shape(&self) -> f64 {
        match self.zones.len().checked_sub(1) {
            Some(zone) if self.modes() > 0 => self.heights[(zone, 0)],
            _ => 0.0,
        }
    }

    /// Stiffness of the first mode, (rad/s)².
    pub(crate) fn first_stiffness(&self) -> f64 {
        self.omega_rad_s.first().map_or(0.0, |omega| omega * omega)
    }

    /// Cutoff of the smoothing of measured inputs, Hz.
    pub fn cutoff_hz(&self) -> f64 {
        self.cutoff_hz
    }
}

/// Rows by which box loads (two a box) act on modes and balance.
struct Rows {
    all: Mat<f64>,
    heights: Mat<f64>,
    twists: Mat<f64>,
}

impl Rows {
    fn new(rig: &Rig<'_>, zones: &Zones) -> Self {
        let (o, boxes) = (&rig.operators, rig.wing.lattice.len());
        let modes = o.omega_rad_s.len();
        let motion = match &rig.wing.supported {
            Some(supported) => &supported.k_displacements() * &o.shapes,
            None => Mat::zeros(2 * boxes, 0),
        };
        let all = Mat::from_fn(modes + BALANCE, 2 * boxes, |row, k| {
            if row < modes { motion[(k, row)] } else { o.loads.air[(row - modes, k)] }
        });
        let (heights, twists) =
            (zones.heights(rig.wing, motion.as_ref()), zones.twists(rig.wing, motion.as_ref()));
        Self { all, heights, twists }
    }

    /// The share of some boxes.
    fn of_boxes(&self, box_loads: MatRef<'_, f64>, boxes: &[usize]) -> Mat<f64> {
        let pick: Vec<usize> = boxes.iter().flat_map(|j| [2 * j, 2 * j + 1]).collect();
        let left = Mat::from_fn(self.all.nrows(), pick.len(), |row, k| self.all[(row, pick[k])]);
        let right = Mat::from_fn(pick.len(), box_loads.ncols(), |k, column| box_loads[(pick[k], column)]);
        left * right
    }

    /// The lift of some boxes times a chord, as a moment nose up.
    fn as_moment(&self, box_loads: MatRef<'_, f64>, boxes: &[usize], chord_m: &[f64]) -> Mat<f64> {
        let left = Mat::from_fn(self.all.nrows(), boxes.len(), |row, k| {
            chord_m[k] * self.all[(row, 2 * boxes[k] + 1)]
        });
        let lift =
            Mat::from_fn(boxes.len(), box_loads.ncols(), |k, column| box_loads[(2 * boxes[k], column)]);
        left * lift
    }

    /// Modes and balance by motions, for pressures by motions.
    fn of_pressures(
        &self,
        wing: &ElasticWing,
        q_pa: f64,
        corrections: &Corrections,
        cp: &Mat<f64>,
    ) -> Mat<f64> {
        self.all.as_ref() * &wing.integration.corrected(corrections).of_pressures(q_pa, cp.as_ref())
    }
}

/// Box loads that do not depend on motion, two rows a box.
struct SteadyLoads {
    /// 1 N on each zone, distributed as its lift by angle of attack.
    unit_lift: Mat<f64>,
    /// A pitching moment coefficient of one in each zone.
    unit_moment: Mat<f64>,
    /// Incidence growing by one a metre of span from the balance outward.
    upwash: Mat<f64>,
}

impl SteadyLoads {
    fn new(wing: &ElasticWing, flow: Flow, corrections: &Corrections, zones: &Zones) -> Self {
        let (boxes, q_pa) = (wing.lattice.len(), flow.dynamic_pressure_pa());
        let alpha = Mat::from_fn(boxes, 1, |j, _| wing.pressures_by_alpha()[j]);
        let loads = wing.integration.corrected(corrections);
        let alpha = loads.of_pressures(1.0, alpha.as_ref());
        let mut unit_lift = Mat::zeros(2 * boxes, zones.len());
        let mut unit_moment = Mat::zeros(2 * boxes, zones.len());
        for (zone, members) in zones.boxes.iter().enumerate() {
            let total: f64 = members.iter().map(|&j| alpha[(2 * j, 0)]).sum();
            for &j in members {
                unit_lift[(2 * j, zone)] = alpha[(2 * j, 0)] / total;
                unit_lift[(2 * j + 1, zone)] = alpha[(2 * j + 1, 0)] / total;
                unit_moment[(2 * j + 1, zone)] = q_pa * wing.integration.area(j) * zones.chord_m[zone];
            }
        }
        let slope = Mat::from_fn(boxes, 1, |j, _| {
            let panel = &wing.lattice.boxes[j];
            (panel.mid_point().y - wing.balance.point.y) * panel.normal().z
        });
        let upwash = loads.of_pressures(q_pa, wing.pressures(slope.as_ref()).as_ref());
        Self { unit_lift, unit_moment, upwash }
    }
}

#[cfg(test)]
pub(crate) mod tests;
