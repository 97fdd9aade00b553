//! The whole aircraft as one deck: right wing, its image, tail, fuselage, and the rigid ties between them.

use crate::aircraft::file::AircraftFile;
use crate::model::mirror::Image;
use crate::model::{fuselage, tail};
use aero::Lattice;
use coupling::WingFile;
use coupling::planform::Mount;
use coupling::planform::cards::add_tie;
use nalgebra::{Point3, Vector3};
use nastran::{BulkData, Frames, InputError, Step};

/// Parts in ascending numbers: each has one step of numbers to itself, the right wing keeps its own.
const LEFT_WING: u32 = 1;
const HTP: u32 = 2;
const VTP: u32 = 4;
const FUSELAGE: u32 = 5;
/// Ties and the closing mass.
const TIES: u32 = 6;

/// Overlaps below this are rounding, m.
const SAME_PLACE_M: f64 = 1e-6;

/// The aircraft's cards, free in space, without the closing mass.
#[derive(Debug, Clone)]
pub struct Cards {
    /// All cards.
    pub bulk: BulkData,
    /// The right wing alone, as its file gives it.
    pub right: BulkData,
    /// Its image alone, numbers raised.
    pub left: BulkData,
    /// Which box is whose image.
    pub image: Image,
    /// From a number of the right wing to the left one's.
    pub step: Step,
    /// The fuselage's grid at the wing's root: the reference of angles and deflections.
    pub centre: u32,
    /// Grids the boxes of the right wing follow; the left wing's are `step.cards` higher.
    pub wing_spline: Vec<u32>,
    /// Grids along the fuselage, nose first.
    pub fuselage_spline: Vec<u32>,
    /// Root grids of the tail surfaces with their number of grids: right and left half of the horizontal, vertical.
    pub tail_splines: [Vec<u32>; 3],
    /// A number above all others, for the closing mass.
    pub closing: u32,
}

/// Builds the cards.
///
/// # Errors
/// If the wing's deck cannot be read or mirrored, or has no structure.
pub fn build(file: &AircraftFile, wing: &WingFile) -> Result<Cards, InputError> {
    let span = file.span();
    let right = wing.bulk(Mount::Aircraft)?;
    let lattice = Lattice::from_bulk(&right)?;
    let wing_spline = wing.spline_grid_ids(&right);
    let root = root_grid(&right, &wing_spline)?.ok_or_else(|| {
        InputError::in_file(&wing.path, "the wing has no structure, which a flexible aircraft needs")
            .with_help("add `structure: ShellSolid((...))` or `Beam((...))` to the wing's file")
    })?;
    let image = Image::of(&right)?;
    let step = Step::above(&image.bulk, lattice.boxes.last().map_or(0, |panel| panel.id));
    let left = image.bulk.clone().raised(times(step, LEFT_WING), "L_")?;
    let mut bulk = right.clone();
    bulk.join(left.clone())?;

    let htp = tail::cards(&file.htp, &Vector3::y(), first(step, HTP), &span);
    bulk.join(htp.clone())?;
    bulk.join(Image::of(&htp)?.bulk.raised(step, "L_")?)?;
    let vtp = tail::cards(&file.vtp, &Vector3::z(), first(step, VTP), &span);
    bulk.join(vtp.clone())?;

    let stations = fuselage::stations(&file.fuselage, root.1.x);
    let half_width_m = strip_edge(&lattice, file)?;
    let body = fuselage::cards(&file.fuselage, &stations, half_width_m, first(step, FUSELAGE), &span);
    let fuselage_spline: Vec<u32> = body.grids.keys().copied().collect();
    bulk.join(body)?;
    let nearest = |x_m: f64| {
        let grids = fuselage_spline.iter().zip(&stations);
        grids.min_by(|a, b| (a.1 - x_m).abs().total_cmp(&(b.1 - x_m).abs())).map_or(0, |(id, _)| *id)
    };
    let centre = nearest(root.1.x);
    let tail_splines = [grid_ids(&htp, 0), grid_ids(&htp, step.cards), grid_ids(&vtp, 0)];
    let number = step.cards * TIES;
    add_tie(&mut bulk, number + 1, centre, vec![root.0, root.0 + step.cards], &span);
    for (at, (part, dependent)) in (number + 2..)
        .zip([(&htp, vec![tail_splines[0][0], tail_splines[1][0]]), (&vtp, vec![tail_splines[2][0]])])
    {
        let x_m = part.grids.values().next().map_or(0.0, |grid| grid.xyz[0]);
        add_tie(&mut bulk, at, nearest(x_m), dependent, &span);
    }
    let closing = number + 9;
    Ok(Cards { bulk, right, left, image, step, centre, wing_spline, fuselage_spline, tail_splines, closing })
}

impl Cards {
    /// The cards without tail and fuselage panels: the structure stays whole.
    pub fn wings_in_flow(&self) -> BulkData {
        let mut bulk = self.bulk.clone();
        let boxes = self.step.boxes * HTP;
        bulk.panels.retain(|id, _| *id < boxes);
        bulk.surfaces.retain(|id, _| *id < self.step.cards * HTP);
        let rows = |part: &BulkData| part.matrices.get("W2GJ").map_or(0, |matrix| matrix.rows);
        let wings = rows(&self.right) + rows(&self.left);
        if let Some(incidence) = bulk.matrices.get_mut("W2GJ") {
            incidence.columns.iter_mut().for_each(|column| column.truncate(wings));
            incidence.rows = wings;
        }
        bulk
    }

    /// Numbers of the panels that are tail or fuselage.
    pub fn is_wing_panel(&self, id: u32) -> bool {
        id < self.step.boxes * HTP
    }

    /// The grids that the boxes of a panel follow.
    pub fn spline_of_panel(&self, id: u32) -> Vec<u32> {
        match id / self.step.boxes {
            0 => self.wing_spline.clone(),
            LEFT_WING => self.wing_spline.iter().map(|id| id + self.step.cards).collect(),
            part @ HTP..=VTP => self.tail_splines[(part - HTP) as usize].clone(),
            _ => self.fuselage_spline.clone(),
        }
    }
}

fn times(step: Step, factor: u32) -> Step {
    Step { cards: step.cards * factor, boxes: step.boxes * factor }
}

fn first(step: Step, part: u32) -> Step {
    Step { cards: step.cards * part + 1, boxes: step.boxes * part + 1 }
}

fn grid_ids(part: &BulkData, add: u32) -> Vec<u32> {
    part.grids.keys().map(|id| id + add).collect()
}

/// The spline grid nearest to the plane of symmetry, and where it is.
fn root_grid(wing: &BulkData, spline: &[u32]) -> Result<Option<(u32, Point3<f64>)>, InputError> {
    let frames = Frames::resolve(wing)?;
    let mut root: Option<(u32, Point3<f64>)> = None;
    for grid in spline.iter().filter_map(|id| wing.grids.get(id)) {
        let point = frames.grid_point(grid)?;
        if root.is_none_or(|(_, nearest)| point.y.abs() < nearest.y.abs()) {
            root = Some((grid.id, point));
        }
    }
    Ok(root)
}

/// The outer edge of the strip that the fuselage's half width is given by.
fn strip_edge(lattice: &Lattice, file: &AircraftFile) -> Result<f64, InputError> {
    let strip = file.fuselage.half_width_wing_strips;
    let fault = |field, message| InputError::in_field(&file.path, field, message);
    let surface = lattice.surfaces.first().filter(|surface| strip < surface.spanwise).ok_or_else(|| {
        let message =
            format!("fuselage.half_width_wing_strips is {strip}, as wide as the wing's first panel or wider");
        fault("fuselage.half_width_wing_strips", message).with_help("a fuselage is a few strips wide")
    })?;
    let inboard = &lattice.boxes[surface.first_box..surface.first_box + strip * surface.chordwise];
    let x_m = || inboard.iter().flat_map(|panel| panel.corners).map(|corner| corner.x);
    let (front, back) = (x_m().fold(f64::INFINITY, f64::min), x_m().fold(f64::NEG_INFINITY, f64::max));
    let (gap_front, gap_back) = file.fuselage.gap_x_m;
    if gap_front > front + SAME_PLACE_M || gap_back < back - SAME_PLACE_M {
        let message = format!(
            "fuselage.gap_x_m is ({gap_front}, {gap_back}), but inside the fuselage the wing reaches from x = \
             {front:.3} to {back:.3} m"
        );
        return Err(fault("fuselage.gap_x_m", message)
            .with_help("boxes of wing and fuselage must not overlap; widen the gap"));
    }
    Ok(lattice.boxes[surface.first_box + strip * surface.chordwise].corners[0].y)
}
