//! What Nastran needs besides the boxes: splines, AEROS and AERO with the plane of symmetry.

use crate::error::CouplingError;
use crate::wing_file::{RootPlane, SplineKind, WingFile};
use aero::Lattice;
use nalgebra::{Point3, Vector3};
use nastran::{BulkData, Coord, CoordDefinition, Frames, InputError, Set1, Span, SplineCard};
use std::fmt::Write as _;

/// Density at sea level, for AERO (RHOREF), kg/m^3.
const RHO_KG_M3: f64 = 1.225;
/// Grids nearer to a straight line than this share of its length carry no surface spline.
const STRAIGHT: f64 = 1e-3;

/// Adds splines and coordinate systems; returns the cards AEROS and AERO. Nothing for a deck without panels.
pub(super) fn add(bulk: &mut BulkData, file: &WingFile) -> Result<String, CouplingError> {
    if bulk.panels.is_empty() {
        return Ok(String::new());
    }
    let lattice = Lattice::from_bulk(bulk)?;
    let span = Span::whole_file(&file.path);
    if bulk.splines.is_empty() && !bulk.grids.is_empty() {
        add_splines(bulk, file, &lattice, &span)?;
    }
    let corners = || lattice.boxes.iter().flat_map(|panel| panel.corners);
    let plane_y = match file.root_plane {
        Some(RootPlane::None) => None,
        Some(RootPlane::Symmetric(y_m)) => Some(y_m),
        None => Some(corners().map(|corner| corner.y).fold(f64::INFINITY, f64::min)),
    };
    let origin = Point3::new(file.balance.x_m, plane_y.unwrap_or(file.balance.y_m), file.balance.z_m);
    let system = add_system(bulk, &origin, &Vector3::x(), &Vector3::y(), &span);
    let fairing = file.fairing_panel_ids();
    let (mut area, mut low, mut high) = (0.0, f64::INFINITY, f64::NEG_INFINITY);
    for surface in lattice.surfaces.iter().filter(|surface| !fairing.contains(&surface.id)) {
        for panel in
            &lattice.boxes[surface.first_box..surface.first_box + surface.chordwise * surface.spanwise]
        {
            area += panel.area_m2();
            low = panel.corners.iter().fold(low, |low, corner| low.min(corner.y));
            high = panel.corners.iter().fold(high, |high, corner| high.max(corner.y));
        }
    }
    let width = if high > low { high - low } else { 1.0 };
    let (chord, symmetry) = (area / width, u8::from(plane_y.is_some()));
    // Of a half model the span is the whole wing's, the area the half's.
    let reference_span = if symmetry == 1 { 2.0 * width } else { width };
    let mut text = String::new();
    let _ = writeln!(
        text,
        "AEROS,{system},{system},{},{},{},{symmetry}",
        real(chord),
        real(reference_span),
        real(area)
    );
    let _ = writeln!(text, "AERO,{system},,{},{},{symmetry}", real(chord), real(RHO_KG_M3));
    Ok(text)
}

/// A real for a free field: at most eight characters, with a point.
fn real(value: f64) -> String {
    let text = format!("{value:.5}");
    text.chars().take(8).collect()
}

/// One spline a panel, on the wing's spline grids: a beam along them for [`SplineKind::Beam`] or if they stand in
/// line, else a plate.
fn add_splines(
    bulk: &mut BulkData,
    file: &WingFile,
    lattice: &Lattice,
    span: &Span,
) -> Result<(), InputError> {
    let ids = file.spline_grid_ids(bulk);
    let frames = Frames::resolve(bulk)?;
    let mut points = Vec::with_capacity(ids.len());
    for id in &ids {
        let grid = bulk.grids.get(id).ok_or_else(|| {
            InputError::in_file(
                &file.path,
                format!("the spline set names grid {id}, which the deck does not have"),
            )
        })?;
        points.push(frames.grid_point(grid)?);
    }
    let (Some(first), Some(last)) = (points.first().copied(), points.last().copied()) else { return Ok(()) };
    let same = bulk.sets.values().find(|set| set.ids == ids).map(|set| set.id);
    let set = same.unwrap_or_else(|| {
        let id = bulk.sets.keys().next_back().map_or(1, |id| id + 1);
        bulk.sets.insert(id, Set1 { id, ids, span: span.clone() });
        id
    });
    let axis = (last - first).try_normalize(0.0);
    let off = |axis: &Vector3<f64>| {
        points.iter().map(|point| (point - first).cross(axis).norm()).fold(0.0, f64::max)
            / (last - first).norm()
    };
    let line = axis.filter(|axis| file.spline == SplineKind::Beam || off(axis) < STRAIGHT);
    let kind = match line {
        Some(axis) => {
            // The spline's plane is that of axis and stream; its y axis runs along the grids.
            let system = add_system(bulk, &first, &Vector3::x(), &axis, span);
            nastran::SplineKind::Beam { system, torsional_ratio: 1.0, attachment: [0.0; 2] }
        }
        None => nastran::SplineKind::Plate,
    };
    for surface in &lattice.surfaces {
        let count = surface.chordwise * surface.spanwise;
        let boxes = (lattice.boxes[surface.first_box].id, lattice.boxes[surface.first_box + count - 1].id);
        let id = surface.id;
        bulk.splines.insert(
            id,
            SplineCard {
                id,
                panel: surface.id,
                boxes,
                list: None,
                set,
                kind,
                flexibility: 0.0,
                is_finite_plate: false,
                span: span.clone(),
            },
        );
    }
    Ok(())
}

/// A new rectangular system with the y axis along `y` and the x axis in the plane of `y` and `near_x`.
fn add_system(
    bulk: &mut BulkData,
    origin: &Point3<f64>,
    near_x: &Vector3<f64>,
    y: &Vector3<f64>,
    span: &Span,
) -> u32 {
    let z = near_x.cross(y).try_normalize(1e-9).unwrap_or_else(Vector3::z);
    let x = y.cross(&z);
    let id = bulk.coords.keys().next_back().map_or(1, |id| id + 1);
    let definition = CoordDefinition::Points { rid: 0, a: *origin, b: origin + z, c: origin + x };
    let kind = nastran::CoordKind::Rectangular;
    bulk.coords.insert(id, Coord { id, kind, definition, span: span.clone() });
    id
}
