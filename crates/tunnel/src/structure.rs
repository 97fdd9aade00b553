//! The true beam: the wing file's beam with other stiffness, mass and axis, changed card by card.

use crate::file::BeamChange;
use coupling::planform::{FIRST_AXIS_GRID, Planform};
use nastran::BulkData;

/// Changes the beam's cards in place. Grids move aft with the axis; masses stay where they are, but for
/// `mass_aft_over_c`.
pub(crate) fn change_beam(bulk: &mut BulkData, planform: &Planform, change: &BeamChange) {
    let at =
        |ends: (f64, f64), y_m: f64| ends.0 + (ends.1 - ends.0) * (y_m / planform.semispan_m).clamp(0.0, 1.0);
    for beam in bulk.beams.values() {
        let y_m =
            0.5 * beam.grids.iter().filter_map(|id| bulk.grids.get(id)).map(|grid| grid.xyz[1]).sum::<f64>();
        let Some(property) = bulk.beam_properties.get_mut(&beam.property) else { continue };
        for station in &mut property.stations {
            station.i1 *= at(change.bending, y_m);
            station.i2 *= at(change.bending, y_m);
            station.j *= at(change.torsion, y_m);
        }
    }
    let axis: Vec<u32> = bulk.sets.values().flat_map(|set| set.ids.iter().copied()).collect();
    for mass in
        bulk.masses.values_mut().filter(|mass| mass.grid >= FIRST_AXIS_GRID && axis.contains(&mass.grid))
    {
        let Some(grid) = bulk.grids.get(&mass.grid) else { continue };
        let (y_m, chord_m) = (grid.xyz[1], planform.chord_m(grid.xyz[1]));
        let factor = at(change.mass, y_m);
        mass.mass *= factor;
        mass.inertia = mass.inertia.map(|inertia| inertia * factor);
        mass.offset[0] += (change.mass_aft_over_c - change.axis_aft_over_c) * chord_m;
    }
    for (id, grid) in &mut bulk.grids {
        if axis.contains(id) {
            grid.xyz[0] += change.axis_aft_over_c * planform.chord_m(grid.xyz[1]);
        }
    }
}
