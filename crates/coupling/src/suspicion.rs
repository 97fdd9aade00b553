//! Units that were probably mistaken, in a wing or a deck: warnings, as the numbers could be meant.
//!
//! Each rule rests on what no wing is: a half span beyond that of any aircraft, boxes and grids a thousand times apart, a
//! material softer than rubber, lighter than foam or heavier than any metal, a wing heavier than half of one of solid steel.

use aero::Lattice;
use nastran::{BulkData, Frames};

/// Half the span of the largest aircraft flown (117 m, the Stratolaunch carrier), rounded up, m.
const LARGEST_HALF_SPAN_M: f64 = 60.0;
/// Rubber has 1e6 to 1e8 Pa, foam cores 1e7 and more.
const SOFTEST_PA: f64 = 1e6;
/// Foams have 15 kg/m^3 and more.
const LIGHTEST_KG_M3: f64 = 5.0;
/// Osmium has 22590 kg/m^3.
const HEAVIEST_KG_M3: f64 = 23000.0;
/// Half of solid steel, kg/m^3: wings have 50 to 700, solid plates of thin models up to a third of their material's.
const HEAVIEST_WING_KG_M3: f64 = 3900.0;
/// Area of a section over its chord squared: 0.7 times a thickness of 15 %.
const SECTION_AREA: f64 = 0.105;
/// A thousand, within a factor of three.
const THOUSANDFOLD: std::ops::Range<f64> = 333.0..3000.0;

/// Sentences about units that were probably mistaken.
pub fn of_wing(bulk: &BulkData, lattice: &Lattice) -> Vec<String> {
    let mut found = Vec::new();
    let boxes = extent(lattice.boxes.iter().flat_map(|panel| panel.corners).map(|corner| corner.y));
    if boxes > LARGEST_HALF_SPAN_M {
        found.push(format!(
            "the boxes span {boxes:.4} m, more than half of the largest aircraft: are lengths in millimetres instead of metres?"
        ));
    }
    found.extend(grids_beside_boxes(bulk, boxes));
    found.extend(materials(bulk));
    let volume: f64 = lattice.boxes.iter().map(aero::AeroBox::area_m2).sum::<f64>()
        * SECTION_AREA
        * mean_chord_m(lattice, boxes);
    let mass: f64 = bulk.masses.values().map(|mass| mass.mass).sum();
    if volume > 0.0 && mass > HEAVIEST_WING_KG_M3 * volume {
        found.push(format!(
            "masses of {mass:.4} kg are more than half of what a wing of this size would have in solid steel: are they in grams instead of kg?"
        ));
    }
    found
}

fn extent(values: impl Iterator<Item = f64>) -> f64 {
    let (low, high) =
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
    (high - low).max(0.0)
}

fn mean_chord_m(lattice: &Lattice, span_m: f64) -> f64 {
    let area: f64 = lattice.boxes.iter().map(aero::AeroBox::area_m2).sum();
    if span_m > 0.0 { area / span_m } else { 0.0 }
}

fn grids_beside_boxes(bulk: &BulkData, boxes: f64) -> Option<String> {
    let frames = Frames::resolve(bulk).ok()?;
    let points: Vec<_> = bulk.grids.values().filter_map(|grid| frames.grid_point(grid).ok()).collect();
    let grids = extent(points.iter().map(|point| point.y));
    let ratio = grids / boxes;
    if THOUSANDFOLD.contains(&ratio) || THOUSANDFOLD.contains(&(1.0 / ratio)) {
        return Some(format!(
            "the grids span {grids:.4} and the boxes {boxes:.4} along y, a thousandfold apart: are some in millimetres and some in metres?"
        ));
    }
    None
}

fn materials(bulk: &BulkData) -> Vec<String> {
    let isotropic = bulk.materials.values().map(|m| ("MAT1", m.id, Some(m.e), m.rho));
    let plies = bulk.ply_materials.values().map(|m| ("MAT8", m.id, Some(m.e1), m.rho));
    let mut found = Vec::new();
    for (card, id, stiffness, density) in isotropic.chain(plies) {
        if let Some(e_pa) = stiffness.filter(|e| *e > 0.0 && *e < SOFTEST_PA) {
            found.push(format!(
                "{card} {id} has {e_pa} Pa, softer than rubber: is it in MPa or GPa instead of Pa?"
            ));
        }
        if density > 0.0 && density < LIGHTEST_KG_M3 {
            found.push(format!(
                "{card} {id} has {density} kg/m3, lighter than foam: is it in g/cm3 or t/mm3 instead of kg/m3?"
            ));
        }
        if density > HEAVIEST_KG_M3 {
            found.push(format!(
                "{card} {id} has {density} kg/m3, heavier than any metal: is it in g/m3 instead of kg/m3?"
            ));
        }
    }
    found
}

#[cfg(test)]
mod tests;
