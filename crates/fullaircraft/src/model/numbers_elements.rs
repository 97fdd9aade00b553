//! Raised numbers of shells, solids, springs, what ties them, their properties and materials; and putting them together.

use crate::model::numbers::{merge, rekeyed};
use nastran::{
    BulkData, BushAxes, InputError, MaterialDirection, Motion, Orientation, ScalarElement, ScalarValue,
};
use std::mem::take;

/// The largest number of these cards.
pub(crate) fn largest(bulk: &BulkData) -> u32 {
    let keys = [
        bulk.shells.keys().max(),
        bulk.shell_properties.keys().max(),
        bulk.laminates.keys().max(),
        bulk.solids.keys().max(),
        bulk.solid_properties.keys().max(),
        bulk.rods.keys().max(),
        bulk.rod_properties.keys().max(),
        bulk.bushes.keys().max(),
        bulk.bush_properties.keys().max(),
        bulk.springs.keys().max(),
        bulk.spring_properties.keys().max(),
        bulk.scalar_masses.keys().max(),
        bulk.mass_properties.keys().max(),
        bulk.general.keys().max(),
        bulk.mass_matrices.keys().max(),
        bulk.rigid_bars.keys().max(),
        bulk.averages.keys().max(),
        bulk.plane_materials.keys().max(),
        bulk.ply_materials.keys().max(),
        bulk.solid_materials.keys().max(),
    ];
    keys.into_iter().flatten().copied().max().unwrap_or(0)
}

/// Raises every number of these cards by `step`; coordinate system 0 stays the basic one.
pub(crate) fn raise(new: &mut BulkData, step: u32) {
    let cards = |id: u32| id.saturating_add(step);
    shells_and_solids(new, step);
    springs(new, step);
    new.rods = rekeyed(take(&mut new.rods), cards, |c| {
        (c.id, c.property, c.grids) = (cards(c.id), cards(c.property), c.grids.map(cards));
    });
    new.rod_properties = rekeyed(take(&mut new.rod_properties), cards, |c| {
        (c.id, c.material) = (cards(c.id), cards(c.material));
    });
    new.mass_matrices = rekeyed(take(&mut new.mass_matrices), cards, |c| {
        (c.id, c.grid, c.cid) = (cards(c.id), cards(c.grid), system(c.cid, step));
    });
    new.rigid_bars =
        rekeyed(take(&mut new.rigid_bars), cards, |c| (c.id, c.grids) = (cards(c.id), c.grids.map(cards)));
    new.averages = rekeyed(take(&mut new.averages), cards, |c| {
        (c.id, c.reference) = (cards(c.id), cards(c.reference));
        let members = c.groups.iter_mut().flat_map(|group| &mut group.grids);
        members.for_each(|id| *id = cards(*id));
        c.um.iter_mut().for_each(|(id, _)| *id = cards(*id));
    });
    let terms = new.equations.iter_mut().flat_map(|card| &mut card.terms);
    terms.for_each(|((grid, _), _)| *grid = cards(*grid));
}

fn system(id: u32, step: u32) -> u32 {
    if id == 0 { 0 } else { id.saturating_add(step) }
}

fn shells_and_solids(new: &mut BulkData, step: u32) {
    let cards = |id: u32| id.saturating_add(step);
    new.shells = rekeyed(take(&mut new.shells), cards, |c| {
        (c.id, c.property) = (cards(c.id), cards(c.property));
        c.grids.iter_mut().for_each(|id| *id = cards(*id));
        if let MaterialDirection::System(cid) = &mut c.direction {
            *cid = system(*cid, step);
        }
    });
    new.shell_properties = rekeyed(take(&mut new.shell_properties), cards, |c| {
        c.id = cards(c.id);
        for material in [&mut c.membrane, &mut c.bending, &mut c.shear, &mut c.coupling] {
            *material = material.map(cards);
        }
    });
    new.laminates = rekeyed(take(&mut new.laminates), cards, |c| {
        c.id = cards(c.id);
        c.plies.iter_mut().for_each(|ply| ply.material = cards(ply.material));
    });
    new.solids = rekeyed(take(&mut new.solids), cards, |c| {
        (c.id, c.property) = (cards(c.id), cards(c.property));
        c.grids.iter_mut().for_each(|id| *id = cards(*id));
    });
    new.solid_properties = rekeyed(take(&mut new.solid_properties), cards, |c| {
        (c.id, c.material) = (cards(c.id), cards(c.material));
        if let Ok(cid) = u32::try_from(c.cordm) {
            c.cordm = i32::try_from(system(cid, step)).unwrap_or(c.cordm);
        }
    });
    new.plane_materials = rekeyed(take(&mut new.plane_materials), cards, |c| c.id = cards(c.id));
    new.ply_materials = rekeyed(take(&mut new.ply_materials), cards, |c| c.id = cards(c.id));
    new.solid_materials = rekeyed(take(&mut new.solid_materials), cards, |c| c.id = cards(c.id));
}

fn springs(new: &mut BulkData, step: u32) {
    let cards = |id: u32| id.saturating_add(step);
    let motion = |motion: &mut Motion| motion.0 = cards(motion.0);
    let scalar = |c: &mut ScalarElement| {
        c.id = cards(c.id);
        if let ScalarValue::Property(id) = &mut c.value {
            *id = cards(*id);
        }
        c.ends.iter_mut().flatten().for_each(motion);
    };
    new.bushes = rekeyed(take(&mut new.bushes), cards, |c| {
        (c.id, c.property) = (cards(c.id), cards(c.property));
        c.grids = (cards(c.grids.0), c.grids.1.map(cards));
        match &mut c.axes {
            BushAxes::System(cid) => *cid = system(*cid, step),
            BushAxes::Oriented(Orientation::Grid(grid)) => *grid = cards(*grid),
            BushAxes::Oriented(Orientation::Vector(_)) | BushAxes::Line => {}
        }
        if let Some((cid, _)) = &mut c.offset {
            *cid = system(*cid, step);
        }
    });
    new.bush_properties = rekeyed(take(&mut new.bush_properties), cards, |c| c.id = cards(c.id));
    new.springs = rekeyed(take(&mut new.springs), cards, scalar);
    new.scalar_masses = rekeyed(take(&mut new.scalar_masses), cards, scalar);
    new.spring_properties = rekeyed(take(&mut new.spring_properties), cards, |c| c.id = cards(c.id));
    new.mass_properties = rekeyed(take(&mut new.mass_properties), cards, |c| c.id = cards(c.id));
    new.general = rekeyed(take(&mut new.general), cards, |c| {
        c.id = cards(c.id);
        c.ui.iter_mut().chain(&mut c.ud).for_each(motion);
    });
}

/// Adds these cards of `other`.
///
/// # Errors
/// If both use a number for the same kind of card, or measure mass in different units (PARAM WTMASS).
pub(crate) fn join(all: &mut BulkData, other: &mut BulkData) -> Result<(), InputError> {
    merge(&mut all.shells, take(&mut other.shells), "CQUAD4")?;
    merge(&mut all.shell_properties, take(&mut other.shell_properties), "PSHELL")?;
    merge(&mut all.laminates, take(&mut other.laminates), "PCOMP")?;
    merge(&mut all.solids, take(&mut other.solids), "CHEXA")?;
    merge(&mut all.solid_properties, take(&mut other.solid_properties), "PSOLID")?;
    merge(&mut all.rods, take(&mut other.rods), "CROD")?;
    merge(&mut all.rod_properties, take(&mut other.rod_properties), "PROD")?;
    merge(&mut all.bushes, take(&mut other.bushes), "CBUSH")?;
    merge(&mut all.bush_properties, take(&mut other.bush_properties), "PBUSH")?;
    merge(&mut all.springs, take(&mut other.springs), "CELAS")?;
    merge(&mut all.spring_properties, take(&mut other.spring_properties), "PELAS")?;
    merge(&mut all.scalar_masses, take(&mut other.scalar_masses), "CMASS")?;
    merge(&mut all.mass_properties, take(&mut other.mass_properties), "PMASS")?;
    merge(&mut all.general, take(&mut other.general), "GENEL")?;
    merge(&mut all.mass_matrices, take(&mut other.mass_matrices), "CONM1")?;
    merge(&mut all.rigid_bars, take(&mut other.rigid_bars), "RBAR")?;
    merge(&mut all.averages, take(&mut other.averages), "RBE3")?;
    merge(&mut all.plane_materials, take(&mut other.plane_materials), "MAT2")?;
    merge(&mut all.ply_materials, take(&mut other.ply_materials), "MAT8")?;
    merge(&mut all.solid_materials, take(&mut other.solid_materials), "MAT9")?;
    all.equations.append(&mut other.equations);
    for (name, value) in take(&mut other.parameters) {
        let first = all.parameters.entry(name.clone()).or_insert(value);
        if name == "WTMASS" && *first != value {
            let message =
                format!("the parts of the aircraft have different PARAM WTMASS, {first} and {value}");
            return Err(InputError::general(message).with_help("give all of them in one system of units"));
        }
    }
    Ok(())
}
