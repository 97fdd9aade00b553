//! From a wing's file and its deck to the parts an elastic wing is made of.

use crate::case::CorrectableBoxes;
use crate::error::CouplingError;
use crate::load_rows::Balance;
use crate::spline::Spline;
use crate::supported::SupportedStructure;
use crate::wing_file::{RootPlane, SplineKind, WingFile};
use aero::{ControlSurface, Lattice, MirrorPlane};
use nalgebra::Point3;
use nastran::{BulkData, InputError};
use structure::{Model, System};

/// What an [`ElasticWing`](crate::ElasticWing) is made of.
#[derive(Debug)]
pub struct WingParts {
    /// All boxes.
    pub lattice: Lattice,
    /// Control surfaces.
    pub controls: Vec<ControlSurface>,
    /// Balance point and metric boxes.
    pub balance: Balance,
    /// Plane at the root.
    pub plane: MirrorPlane,
    /// Mach number of the air.
    pub mach: f64,
    /// Which surfaces of the lattice are fairings: in the flow, never corrected.
    pub fairing_surfaces: Vec<u32>,
    /// Camber and twist incidence, one a box, rad.
    pub camber: Vec<f64>,
    /// The reduced structure.
    pub supported: Option<SupportedStructure>,
    /// The assembled structure and its spline.
    pub structure: Option<(System, Spline)>,
}

/// Turns a deck into the parts of a wing.
pub(crate) fn wing_parts(file: &WingFile, bulk: &BulkData) -> Result<WingParts, CouplingError> {
    let lattice = Lattice::from_bulk(bulk)?;
    let controls = ControlSurface::all_from_bulk(bulk, &lattice)?;
    let camber = aero::camber_and_twist(bulk, &lattice)?;
    let fairing_surfaces = file.fairing_panel_ids();
    let mut metric = vec![true; lattice.len()];
    if !file.fairing_metric {
        for surface in lattice.surfaces.iter().filter(|surface| fairing_surfaces.contains(&surface.id)) {
            metric[surface.first_box..surface.first_box + surface.chordwise * surface.spanwise].fill(false);
        }
    }
    let point = Point3::new(file.balance.x_m, file.balance.y_m, file.balance.z_m);
    let plane = match file.root_plane {
        Some(RootPlane::None) => MirrorPlane::None,
        Some(RootPlane::Symmetric(y_m)) => MirrorPlane::Symmetric { y_m },
        None => MirrorPlane::Symmetric { y_m: inner_edge(&lattice) },
    };
    let mut parts = WingParts {
        lattice,
        controls,
        balance: Balance { point, metric },
        plane,
        mach: 0.0,
        fairing_surfaces,
        camber,
        supported: None,
        structure: None,
    };
    if !bulk.grids.is_empty() {
        let system = System::assemble(&Model::from_bulk(bulk)?)?;
        let nodes = spline_nodes(file, bulk, &system)?;
        let spline = match file.spline {
            SplineKind::Beam => Spline::beam(&parts.lattice, system.points(), &nodes),
            SplineKind::NearestNode => Spline::nearest_node(&parts.lattice, system.points(), &nodes),
        };
        let tip = tip_node(file, &system, &nodes)?;
        parts.supported = Some(SupportedStructure::new(&system, &spline, tip, &point)?);
        parts.structure = Some((system, spline));
    }
    Ok(parts)
}

/// Indices of the spline's grids among the system's nodes, in the order the file gives them.
///
/// # Errors
/// If the set names a grid that the deck does not have, or that no element holds.
pub fn spline_nodes(file: &WingFile, bulk: &BulkData, system: &System) -> Result<Vec<usize>, InputError> {
    let place = |id: u32| {
        let fault = |what: &str| {
            InputError::in_file(&file.path, format!("the spline set names grid {id}, which {what}"))
        };
        let node = system.node_index(id).ok_or_else(|| fault("the deck does not have"))?;
        if system.is_attached(node) {
            return Ok(node);
        }
        Err(fault("no element holds: loads on it would be lost")
            .with_help("name grids of the structure, or tie this one to it with RBE2 or RBE3"))
    };
    file.spline_grid_ids(bulk).into_iter().map(place).collect()
}

/// The node whose height is the tip deflection: the file's `tip_grid`, or the spline node with the largest y.
fn tip_node(file: &WingFile, system: &System, nodes: &[usize]) -> Result<usize, InputError> {
    let y_m = |node: usize| system.points()[node].y;
    match file.tip_grid {
        None => Ok(nodes.iter().copied().max_by(|&a, &b| y_m(a).total_cmp(&y_m(b))).unwrap_or(0)),
        Some(id) => system.node_index(id).ok_or_else(|| {
            InputError::in_field(
                &file.path,
                "tip_grid",
                format!("tip_grid is {id}, which the structure does not have"),
            )
            .with_help("give the number of a grid, or leave it out for the outermost grid of the axis")
        }),
    }
}

/// The smallest y of any corner.
fn inner_edge(lattice: &Lattice) -> f64 {
    lattice.boxes.iter().flat_map(|panel| panel.corners).map(|corner| corner.y).fold(f64::INFINITY, f64::min)
}

/// The planform of all boxes that are not fairing.
pub(crate) fn correctable_boxes(lattice: &Lattice, fairing: &[u32]) -> CorrectableBoxes {
    let mut boxes = CorrectableBoxes {
        places: Vec::new(),
        chord_row: Vec::new(),
        chord_rows: Vec::new(),
        strip: Vec::new(),
        y_norm: Vec::new(),
        area_share: Vec::new(),
        area_m2: 0.0,
        ends_m: [0.0; 2],
    };
    let mut strips = 0;
    for surface in lattice.surfaces.iter().filter(|surface| !fairing.contains(&surface.id)) {
        for strip in 0..surface.spanwise {
            for row in 0..surface.chordwise {
                boxes.places.push(surface.first_box + strip * surface.chordwise + row);
                boxes.chord_row.push(row);
                boxes.chord_rows.push(surface.chordwise);
                boxes.strip.push(strips + strip);
            }
        }
        strips += surface.spanwise;
    }
    let corners =
        || boxes.places.iter().flat_map(|&place| lattice.boxes[place].corners).map(|corner| corner.y);
    let (low, high) = corners().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), y| (a.min(y), b.max(y)));
    let total: f64 = boxes.places.iter().map(|&place| lattice.boxes[place].area_m2()).sum();
    boxes.y_norm =
        boxes.places.iter().map(|&p| (lattice.boxes[p].mid_point().y - low) / (high - low)).collect();
    boxes.area_share = boxes.places.iter().map(|&place| lattice.boxes[place].area_m2() / total).collect();
    (boxes.area_m2, boxes.ends_m) = (total, [low, high]);
    boxes
}

#[cfg(test)]
mod tests;
