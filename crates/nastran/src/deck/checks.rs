//! Checks that need the whole deck, for fields that are read only if they say what another card says already.

use crate::bulk_data::BulkData;
use crate::cards::CornerThickness;
use crate::source::InputError;

/// Demands that corner thicknesses of shells are those of their properties.
///
/// Whether the property is there is not asked here.
pub(super) fn corner_thicknesses(deck: &BulkData, given: &[CornerThickness]) -> Result<(), InputError> {
    for corner in given {
        let Some(element) = deck.shells.get(&corner.element) else { continue };
        let shell = deck.shell_properties.get(&element.property).map(|shell| shell.thickness);
        let laminate = deck.laminates.get(&element.property).map(|laminate| {
            let listed: f64 = laminate.plies.iter().map(|ply| ply.thickness).sum();
            if laminate.is_symmetric { 2.0 * listed } else { listed }
        });
        let Some(expected) = shell.or(laminate) else { continue };
        let expected = if corner.is_ratio { 1.0 } else { expected };
        // Ply thicknesses are summed, and decks hold eight characters.
        if (corner.value - expected).abs() > 1e-6 * expected {
            let message = format!(
                "corner thickness {} of shell {} is not the property's, {expected}; shells of varying thickness are not read",
                corner.value, corner.element
            );
            return Err(InputError::at(&corner.span, message)
                .with_help("leave the corner thicknesses empty and use a property for each thickness"));
        }
    }
    Ok(())
}

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
    let elements = deck.springs.values().chain(deck.scalar_masses.values());
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
