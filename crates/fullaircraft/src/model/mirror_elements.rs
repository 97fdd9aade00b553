//! The mirror image of shells, solids, springs and what ties them.
//!
//! Corners are listed the other way round, so that a shell's normal is the image of its normal and a solid keeps its
//! sense. Angles in a shell's plane change their sign, its plies' too. A motion along y and rotations about x and z
//! change their sign, which matters where one card joins several motions.

use nastran::{
    BulkData, BushAxes, Conm1, InputError, MaterialDirection, Motion, Mpc, Orientation, ScalarElement, Span,
};
use std::collections::BTreeMap;

/// Adds the images of general finite elements of `bulk` to `image`, every number kept.
///
/// # Errors
/// If a card has no image: a GENEL, or a spring between motions of which one changes its sign.
pub(crate) fn add(bulk: &BulkData, image: &mut BulkData) -> Result<(), InputError> {
    shells(bulk, image);
    solids(bulk, image);
    springs(bulk, image)?;
    image.rods.clone_from(&bulk.rods);
    image.rod_properties.clone_from(&bulk.rod_properties);
    image.rigid_bars.clone_from(&bulk.rigid_bars);
    image.averages.clone_from(&bulk.averages);
    image.parameters.clone_from(&bulk.parameters);
    image.equations = bulk.equations.iter().map(equation).collect();
    image.mass_matrices = bulk.mass_matrices.iter().map(|(id, card)| (*id, mass_matrix(card))).collect();
    Ok(())
}

fn shells(bulk: &BulkData, image: &mut BulkData) {
    image.shell_properties.clone_from(&bulk.shell_properties);
    image.ply_materials.clone_from(&bulk.ply_materials);
    image.shells.clone_from(&bulk.shells);
    for shell in image.shells.values_mut() {
        shell.grids.swap(0, 1);
        if shell.grids.len() == 4 {
            shell.grids.swap(2, 3);
        }
        if let MaterialDirection::AngleDeg(angle) = &mut shell.direction {
            *angle = 0.0 - *angle;
        }
    }
    image.laminates.clone_from(&bulk.laminates);
    for ply in image.laminates.values_mut().flat_map(|laminate| &mut laminate.plies) {
        ply.angle_deg = 0.0 - ply.angle_deg;
    }
    image.plane_materials.clone_from(&bulk.plane_materials);
    for material in image.plane_materials.values_mut() {
        // G13 and G23 join shear with stretching.
        for at in [2, 4] {
            material.g[at] = 0.0 - material.g[at];
        }
    }
}

fn solids(bulk: &BulkData, image: &mut BulkData) {
    image.solid_properties.clone_from(&bulk.solid_properties);
    image.solids.clone_from(&bulk.solids);
    for solid in image.solids.values_mut() {
        let order: &[usize] = match solid.grids.len() {
            8 => &[1, 0, 3, 2, 5, 4, 7, 6],
            6 => &[1, 0, 2, 4, 3, 5],
            _ => &[1, 0, 2, 3],
        };
        solid.grids = order.iter().filter_map(|at| solid.grids.get(*at).copied()).collect();
    }
    image.solid_materials.clone_from(&bulk.solid_materials);
    for material in image.solid_materials.values_mut() {
        // The upper triangle row by row; xy and yz (3 and 4) change their sign.
        let odd = |at: usize| at == 3 || at == 4;
        let places = (0..6).flat_map(|row| (row..6).map(move |column| (row, column)));
        for (value, (row, column)) in material.g.iter_mut().zip(places) {
            if odd(row) != odd(column) {
                *value = 0.0 - *value;
            }
        }
    }
}

fn springs(bulk: &BulkData, image: &mut BulkData) -> Result<(), InputError> {
    if let Some(card) = bulk.general.values().next() {
        let message = format!("GENEL {} cannot be mirrored", card.id);
        return Err(InputError::at(&card.span, message).with_help("give the structure as elements"));
    }
    image.bush_properties.clone_from(&bulk.bush_properties);
    image.bushes.clone_from(&bulk.bushes);
    for bush in image.bushes.values_mut() {
        if let BushAxes::Oriented(Orientation::Vector(vector)) = &mut bush.axes {
            vector[1] = 0.0 - vector[1];
        }
        if let Some((_, xyz)) = &mut bush.offset {
            // Also in a mirrored system: its y axis is minus the image of the original's.
            xyz[1] = 0.0 - xyz[1];
        }
    }
    image.spring_properties.clone_from(&bulk.spring_properties);
    image.mass_properties.clone_from(&bulk.mass_properties);
    image.springs = scalars(&bulk.springs)?;
    image.scalar_masses = scalars(&bulk.scalar_masses)?;
    Ok(())
}

/// Whether a component keeps its sign.
fn keeps((_, component): Motion) -> bool {
    matches!(component, 1 | 3 | 5)
}

fn scalars(cards: &BTreeMap<u32, ScalarElement>) -> Result<BTreeMap<u32, ScalarElement>, InputError> {
    for card in cards.values() {
        if let [Some(a), Some(b)] = card.ends
            && keeps(a) != keeps(b)
        {
            return Err(mixed(card.id, &card.span));
        }
    }
    Ok(cards.clone())
}

fn mixed(id: u32, span: &Span) -> InputError {
    let message = format!("scalar element {id} joins motions of which one changes its sign in the mirror");
    InputError::at(span, message)
        .with_help("join motions of the same kind, or use an MPC and a spring to the ground")
}

fn equation(card: &Mpc) -> Mpc {
    let terms = card
        .terms
        .iter()
        .map(|(motion, factor)| (*motion, if keeps(*motion) { *factor } else { 0.0 - *factor }));
    Mpc { terms: terms.collect(), ..card.clone() }
}

fn mass_matrix(card: &Conm1) -> Conm1 {
    let sign = |at: usize| if matches!(at, 0 | 2 | 4) { 1.0 } else { -1.0 };
    let mut mass = card.mass;
    for (i, row) in mass.iter_mut().enumerate() {
        for (j, value) in row.iter_mut().enumerate() {
            *value *= sign(i) * sign(j);
        }
    }
    Conm1 { mass, ..card.clone() }
}
