//! The wing bent by its loads at the fastest airspeed and the steepest angle of attack of the campaign, initial and updated.

use aero::{Corrections, Flow};
use calibrate::Calibration;
use coupling::{SteadyCase, shape::deformed_boxes};
use report::deformed::{Quad, View};

use super::calibrate_model::{Fitted, Seen};
use super::calibrate_numbers::speed_name;
use crate::failure::Failure;
use crate::output::ResultFolder;

/// Writes the shapes; nothing for a rigid wing.
pub(super) fn write(
    folder: &ResultFolder,
    fitted: &Fitted<'_>,
    calibration: &Calibration,
) -> Result<(), Failure> {
    let wing = fitted.elastic();
    let fastest = calibration.airspeeds.iter().max_by(|a, b| a.data.v_m_s.total_cmp(&b.data.v_m_s));
    let (Some(held), Some(airspeed)) = (&wing.supported, fastest) else { return Ok(()) };
    let angles = airspeed.data.angles.iter().map(|angle| angle.alpha_rad);
    let Some(alpha_rad) = angles.max_by(|a, b| a.abs().total_cmp(&b.abs())) else { return Ok(()) };
    let flow = Flow { v_m_s: airspeed.data.v_m_s, rho_kg_m3: calibration.rho_kg_m3 };
    let neutral = Corrections::neutral(wing.correctable.len());
    let found = calibration.common.as_ref().map_or(&airspeed.corrections, |set| &set.corrections);
    let view = |title: String, corners: Vec<[_; 4]>| View {
        title,
        groups: vec!["wing".into()],
        quads: corners.into_iter().map(|corners| Quad { corners, group: 0 }).collect(),
        ..View::default()
    };
    let flat = wing.lattice.boxes.iter().map(|panel| panel.corners).collect();
    let mut views = vec![view("undeformed".into(), flat)];
    for (name, corrections) in [("initial", &neutral), ("updated", found)] {
        for seen in fitted.solve(&[SteadyCase::new(flow, alpha_rad)], corrections)? {
            let corners = match &seen {
                Seen::Small(state) => deformed_boxes(&wing.lattice, held, &state.displacement),
                Seen::Large(state) => state.lattice.boxes.iter().map(|panel| panel.corners).collect(),
            };
            let [_, _, _, tip_m] = seen.readings();
            views.push(view(format!("{name}: tip {tip_m:.3} m"), corners));
        }
    }
    let title = format!("The wing at {} m/s, {:.1} degrees", speed_name(flow.v_m_s), alpha_rad.to_degrees());
    let caption = "Bent by air and weight, drawn without the angle of attack; the tip's height is measured from where it is at \
                   zero degrees without wind. Drag to turn, scroll to come nearer; a click on a name hides a shape.";
    folder.write_shapes("wing_shapes", &title, caption, views, &[])
}
