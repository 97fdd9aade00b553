//! The structure of a case in its own modes, and what of it the air and the balance see.

use super::{GRAVITY_M_S2, Rig};
use crate::beam::{Axis, Beam, Extra, Modes, Stiffness};
use crate::setting::Setting;
use nalgebra::{DMatrix, DVector};

/// See the module.
#[derive(Debug, Clone)]
pub struct Structure {
    /// Natural frequencies, rad/s.
    pub omega_rad_s: Vec<f64>,
    /// Damping over critical, by mode.
    pub damping: Vec<f64>,
    /// Height of the strips' quarter points, strips by modes.
    pub(crate) height: DMatrix<f64>,
    /// Nose-up rotation of the strips, strips by modes.
    pub(crate) pitch: DMatrix<f64>,
    /// Height of the axis at the tip, by mode.
    pub(crate) tip: DVector<f64>,
    /// Generalised forces of a unit downward pull and of a unit nose-up acceleration.
    pub(crate) fields: DMatrix<f64>,
    /// What the modes' accelerations take off the balance's loads.
    pub(crate) balance: DMatrix<f64>,
    /// Balance loads by a unit downward pull and by a unit nose-up acceleration.
    pub(crate) rigid: [[f64; 3]; 2],
    /// Modal coordinates in still air, level.
    pub(crate) sag: DVector<f64>,
}

impl Structure {
    /// The structure of a rig in a setting.
    pub fn new(rig: &Rig, setting: &Setting) -> Self {
        let beam = beam_of(rig, setting);
        let modes: Modes = beam.modes(rig.modes);
        let (pitch_x_m, balance_x_m) = (rig.wing.pitch_x_m, rig.wing.balance_x_m);
        let strips = &rig.lattice.strips;
        let count = modes.omega_rad_s.len();
        let (mut height, mut pitch) =
            (DMatrix::zeros(strips.len(), count), DMatrix::zeros(strips.len(), count));
        for (s, strip) in strips.iter().enumerate().filter(|(_, strip)| strip.metric) {
            let shape = beam.shape(&modes, strip.quarter_x_m(), strip.y_m);
            for mode in 0..count {
                height[(s, mode)] = shape.height[mode];
                pitch[(s, mode)] = shape.pitch[mode];
            }
        }
        let tip = beam.shape(&modes, beam.axis.x_m(beam.end_y_m), beam.end_y_m).height;
        let fields = modes.loads(&beam.fields(pitch_x_m));
        let sag = modes.deflected(&(fields.column(0) * GRAVITY_M_S2));
        let [mass, aft, out] = beam.moments(pitch_x_m);
        let moved = pitch_x_m - balance_x_m;
        let product = beam.product_kg_m2(pitch_x_m);
        // about the balance: arms are longer by the way from the axis of pitch
        let pulled = [-mass, -out, aft + moved * mass];
        let turned = [aft, product, -(beam.pitch_inertia_kg_m2(pitch_x_m) + moved * aft)];
        let tip = DVector::from_vec(tip);
        Self {
            damping: (0..count).map(|mode| setting.damping_of(mode)).collect(),
            balance: beam.balance_rows(balance_x_m) * &modes.slices,
            rigid: [pulled, turned],
            sag,
            omega_rad_s: modes.omega_rad_s,
            height,
            pitch,
            tip,
            fields,
        }
    }
}

/// The beam of a setting.
fn beam_of(rig: &Rig, setting: &Setting) -> Beam {
    let (wing, planform) = (&rig.wing, &rig.wing.planform);
    let mut beam = Beam::of_wing(wing, rig.slices);
    let eta = |y_m: f64| y_m / planform.semispan_m;
    for slice in &mut beam.slices {
        let factor = setting.mass.at(eta(slice.y_m));
        slice.mass_kg *= factor;
        slice.pitch_kg_m2 *= factor;
        slice.roll_kg_m2 *= factor;
        slice.aft_m += setting.mass_aft_over_c.at(eta(slice.y_m)) * planform.chord_m(slice.y_m);
    }
    let (aft_m, out_m) = setting.lumps_moved_m;
    for extra in &mut beam.extras {
        extra.x_m += aft_m;
        extra.y_m += out_m;
    }
    beam.extras.extend(setting.extras.iter().copied());
    let stations = &wing.stations;
    let stiffness = |y_m: f64| {
        [
            stations.at(&stations.bending_n_m2, y_m) * setting.bending.at(eta(y_m)),
            stations.at(&stations.torsion_n_m2, y_m) * setting.torsion.at(eta(y_m)),
        ]
    };
    let axis = Axis::of(planform, stations);
    rebuilt(beam, axis, &stiffness)
}

fn rebuilt(beam: Beam, axis: Axis, stiffness: &dyn Stiffness) -> Beam {
    let extras: Vec<Extra> = beam.extras;
    let mut beam = Beam::new(axis, beam.end_y_m, beam.slices, stiffness);
    beam.extras = extras;
    beam
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wing::Wing;
    use std::path::Path;

    /// What a mode's inertia puts on the balance is what the root carries: the moments that bend and twist the axis there.
    #[test]
    fn the_root_carries_what_inertia_puts_on_the_balance() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex/wing_beam.ron");
        let rig = Rig::new(Wing::read(&path).unwrap(), None);
        let setting = Setting::drawn(0.02, 3);
        let (structure, beam) = (Structure::new(&rig, &setting), beam_of(&rig, &setting));
        let modes = beam.modes(rig.modes);
        let (stations, axis) = (&rig.wing.stations, beam.axis);
        let s_m = 0.004;
        let y_m = s_m * axis.cos;
        let shape = beam.shape(&modes, axis.x_m(y_m), y_m);
        for mode in 0..4 {
            let omega2 = modes.omega_rad_s[mode].powi(2);
            let bent = 2.0 * shape.height[mode] / (s_m * s_m) * stations.bending_n_m2[0];
            // nose-up rotation along x is cos t - sin f
            let turned = (shape.pitch[mode] + axis.sin * 2.0 * shape.height[mode] / s_m) / axis.cos;
            let twisted = turned / s_m * stations.torsion_n_m2[0];
            let roll = bent * axis.cos + twisted * axis.sin;
            let found = omega2 * structure.balance[(1, mode)];
            assert!((found / roll - 1.0).abs() < 0.02, "mode {mode}: {found} {roll}");
            // about the axis's root: the balance stands ahead of it, and lifts aft of it turn the nose down
            let ahead_m = axis.root_x_m - rig.wing.balance_x_m;
            let pitch = twisted * axis.cos - bent * axis.sin;
            let about = omega2 * (structure.balance[(2, mode)] + ahead_m * structure.balance[(0, mode)]);
            let most = about.abs().max(roll.abs() * axis.sin);
            assert!((about - pitch).abs() < 0.02 * most, "mode {mode}: {about} {pitch}");
            // what an acceleration does to a mode is what the mode's acceleration does to the balance
            let (fz, my) = (structure.balance[(0, mode)], structure.balance[(2, mode)]);
            assert!((structure.fields[(mode, 0)] + fz).abs() < 1e-9 + 1e-6 * fz.abs());
            assert!((structure.fields[(mode, 1)] + my).abs() < 1e-9 + 1e-6 * my.abs());
        }
    }
}
