//! The matrices of a wing as named arrays, for HDF5 files and for Python.

use aero::Corrections;
use coupling::{ElasticWing, Exchange, WingFile};
use maneuver::{RigModel, RigSettings, Station};
use structure::{ModesError, normal_modes};

use crate::failure::Failure;
use crate::hdf5::{Group, Values};

/// How the rig of a wing is modelled: the settings of its file, a sensor wherever it has a grid for one.
pub fn rig_settings(file: &WingFile, wing: &ElasticWing) -> RigSettings {
    let mut settings = RigSettings::of_wing(file);
    if let (Some(planform), Some((system, _))) = (file.planform(), &wing.structure) {
        let node = |(name, grid): (String, u32)| system.node_index(grid).map(|node| (name, node));
        settings.sensors = planform.sensor_grids().into_iter().filter_map(node).collect();
    }
    settings.stations = Station::of_wing(file);
    settings
}

/// The boxes: corners, normals, pressures per incidence (the inverse of the influence matrix), camber.
///
/// # Errors
/// If the wing cannot be solved.
pub fn boxes(wing: &ElasticWing) -> Result<Group, Failure> {
    let all = &wing.lattice.boxes;
    let corners = all.iter().flat_map(|panel| panel.corners).flat_map(|c| [c.x, c.y, c.z]).collect();
    let normals = all.iter().map(aero::AeroBox::normal).flat_map(|n| [n.x, n.y, n.z]).collect();
    let areas: Vec<f64> = all.iter().map(aero::AeroBox::area_m2).collect();
    let places = wing.correctable.places.iter().filter_map(|&place| u32::try_from(place).ok()).collect();
    let neutral = Exchange::of(wing, &Corrections::neutral(wing.correctable.len()))?;
    Ok(Group::new(
        "boxes",
        "aerodynamic boxes; qjj: pressure coefficients per incidence, w2gj_rad: camber and twist",
    )
    .with("id", Values::Whole(all.iter().map(|panel| panel.id).collect()))
    .with("corners_m", Values::Real(corners, vec![all.len(), 4, 3]))
    .with("normal", Values::Real(normals, vec![all.len(), 3]))
    .with("area_m2", Values::list(&areas))
    .with("correctable", Values::Whole(places))
    .with("qjj", Values::matrix(neutral.qjj.as_ref()))
    .with("w2gj_rad", Values::list(&neutral.camber_rad)))
}

/// Grids and modes, and how boxes move in each mode; nothing for a rigid wing.
///
/// # Errors
/// If the modes do not converge.
pub fn structure(wing: &ElasticWing, modes: usize) -> Result<Option<Group>, Failure> {
    let Some((system, spline)) = &wing.structure else { return Ok(None) };
    let modes = match normal_modes(system, modes.min(system.free_count())) {
        Err(ModesError::TooMany { available, .. }) => normal_modes(system, available),
        modes => modes,
    }
    .map_err(Failure::computation)?;
    let shapes = system.expand(modes.shapes.as_ref());
    let points = system.points().iter().flat_map(|p| [p.x, p.y, p.z]).collect();
    let on_boxes = spline.displace(shapes.as_ref());
    Ok(Some(
        Group::new(
            "structure",
            "grids and modes of unit generalised mass; box_modes: displacement along the normal and nose-up rotation of every \
             box, alternating, by mode",
        )
        .with("grid_id", Values::Whole(system.node_ids().to_vec()))
        .with("grid_m", Values::Real(points, vec![system.node_count(), 3]))
        .with("omega_rad_s", Values::list(&modes.omega_rad_s))
        .with("modes", Values::matrix(shapes.as_ref()))
        .with("box_modes", Values::matrix(on_boxes.as_ref())),
    ))
}

/// The linear system that `simulate` flies, with the names of its inputs and outputs.
pub fn linear_system(name: &str, model: &RigModel) -> Group {
    let inputs = [
        "one",
        "alpha_rad",
        "alpha_rate_rad_s",
        "alpha_second_rad_s2",
        "g_sin_alpha_m_s2",
        "g_cos_alpha_m_s2",
    ];
    let inputs =
        inputs.into_iter().map(str::to_owned).chain(model.controls.iter().map(|c| format!("delta_{c}_rad")));
    let outputs = model.loads.iter().cloned().chain(["tip_z_m".to_owned()]);
    let outputs = outputs.chain(model.sensors.iter().map(|sensor| format!("az_{sensor}_m_s2")));
    Group::new(name, "x' = A x + B u, y = C x + D u: the wing on its balance at corrections/V_m_s")
        .with("A", Values::matrix(model.a.as_ref()))
        .with("B", Values::matrix(model.b.as_ref()))
        .with("C", Values::matrix(model.c.as_ref()))
        .with("D", Values::matrix(model.d.as_ref()))
        .with("inputs", Values::words(inputs))
        .with("outputs", Values::words(outputs))
}
