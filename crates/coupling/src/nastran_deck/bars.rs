//! CBAR and PBAR for CBEAM and PBEAM where these say no more.

use nastran::{BeamProperty, BulkData};
use std::collections::BTreeSet;

/// Turns uniform beams into bars and returns how many beams had to stay: tapered ones, ones with mass or neutral
/// axis off the shear centre or with rotary inertia, and ones that shear with I12.
pub fn bars_for_beams(bulk: &mut BulkData) -> usize {
    let uniform: BTreeSet<u32> = bulk
        .beam_properties
        .values()
        .filter(|property| property.is_beam && is_uniform(property))
        .map(|property| property.id)
        .collect();
    for id in &uniform {
        if let Some(property) = bulk.beam_properties.get_mut(id) {
            property.is_beam = false;
            property.stations.truncate(1);
        }
    }
    let mut kept = 0;
    for beam in bulk.beams.values_mut().filter(|beam| beam.is_beam) {
        if uniform.contains(&beam.property) {
            beam.is_beam = false;
        } else {
            kept += 1;
        }
    }
    kept
}

fn is_uniform(property: &BeamProperty) -> bool {
    let Some(first) = property.stations.first() else { return false };
    let alike = property.stations.iter().all(|station| {
        let mut other = *station;
        other.x_over_l = first.x_over_l;
        other == *first
    });
    let offsets = [property.nsm_offset, property.neutral_axis];
    // A PBAR with I12 has no shear flexibility.
    let is_sheared = first.i12 != 0.0 && property.shear_factors != [0.0; 2];
    alike
        && !is_sheared
        && property.nsi == [0.0; 2]
        && offsets.iter().flatten().flatten().all(|value| *value == 0.0)
}
