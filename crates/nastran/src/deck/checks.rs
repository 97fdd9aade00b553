//! Checks that need the whole deck, for fields that are read only if they say what another card says already.

use crate::bulk_data::BulkData;
use crate::source::InputError;

/// Demands known axes of solids that are not isotropic.
pub(super) fn material_axes(deck: &BulkData) -> Result<(), InputError> {
    let wrong = deck
        .solid_properties
        .values()
        .find(|property| property.cordm == -1 && deck.solid_materials.contains_key(&property.material));
    wrong.map_or(Ok(()), |property| {
        let message =
            format!("PSOLID {} has a MAT9 in element axes (CORDM = -1), which is not read", property.id);
        Err(InputError::at(&property.span, message)
            .with_help("name a coordinate system in CORDM, 0 for the basic one"))
    })
}

/// Demands a component wherever a spring, mass or equation names a grid; only scalar points have none.
pub(super) fn components(deck: &BulkData) -> Result<(), InputError> {
    let elements =
        deck.springs.values().chain(deck.scalar_masses.values()).chain(deck.scalar_dampers.values());
    let of_elements =
        elements.flat_map(|card| card.ends.iter().flatten().map(move |motion| (motion, &card.span)));
    let of_equations =
        deck.equations.iter().flat_map(|card| card.terms.iter().map(move |term| (&term.0, &card.span)));
    let mut open = of_elements
        .chain(of_equations)
        .filter(|((id, component), _)| *component == 0 && deck.grids.contains_key(id));
    open.next().map_or(Ok(()), |((id, _), span)| {
        Err(InputError::at(span, format!("there is no component for GRID {id}, which is no scalar point"))
            .with_help("give one digit from 1 to 6"))
    })
}
