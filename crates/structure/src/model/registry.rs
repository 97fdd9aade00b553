//! Which cards of a deck become elements, damp, or tie motions together: the one place where a kind is entered.
//!
//! A new element is a file of its own with [`ElementCard`] for its card (and, if [`crate::MatrixElement`] does not do,
//! [`Element`]), and one line in [`visit`]; then it is assembled, has mass, is drawn and can be fitted.

use super::build::Builder;
use crate::cell_shape::CellShape;
use crate::constraints::Dependent;
use crate::constraints::joint::Joint;
use crate::damper::Damper;
use crate::element::Element;
use crate::springs::OverMotions;
use nastran::{BulkData, InputError};
use std::collections::BTreeMap;
use std::sync::Arc;

/// A card that becomes an element.
pub(crate) trait ElementCard {
    /// GE: structural damping as a share of the element's stiffness.
    fn loss_factor(&self, _: &BulkData) -> f64 {
        0.0
    }
    /// Structural damping of the element, over its motions: [`ElementCard::loss_factor`] of its stiffness, if it has one.
    fn structural_damping(&self, builder: &mut Builder) -> Result<Option<OverMotions>, InputError> {
        let share = self.loss_factor(builder.bulk);
        if share == 0.0 {
            return Ok(None);
        }
        let element = self.element(builder)?;
        Ok(element.stiffness().map(|k| (element.dofs(), &*k * share)))
    }
    /// The element, every reference checked.
    fn element(&self, builder: &mut Builder) -> Result<Arc<dyn Element>, InputError>;
    /// Its property, if it has one, by which regions name it.
    fn property(&self) -> Option<u32> {
        None
    }
    /// Shape and grids of the cell that it is drawn as; nothing if it has no extent.
    fn cell(&self) -> Option<(CellShape, Vec<u32>)> {
        None
    }
}

/// A card that damps.
pub(crate) trait DamperCard {
    /// The damper; nothing if its damping is zero.
    fn damper(&self, builder: &Builder) -> Result<Option<Damper>, InputError>;
}

/// A card that makes motions follow others.
pub(crate) trait TieCard {
    /// The motions that follow.
    fn dependents(&self, builder: &Builder) -> Result<Vec<Dependent>, InputError>;
    /// What they do at finite rotations.
    fn joint(&self, builder: &Builder) -> Result<Joint, InputError>;
    /// Its number, and the two ends of each arm that it is drawn as.
    fn arms(&self) -> (u32, Vec<[u32; 2]>);
}

/// What goes over all of these cards, and passes by those that it does not look at.
pub(crate) trait Visitor {
    /// The elements of one kind, in ascending number.
    fn elements<C: ElementCard>(&mut self, _: &BTreeMap<u32, C>) -> Result<(), InputError> {
        Ok(())
    }
    /// The dampers of one kind, in ascending number.
    fn dampers<C: DamperCard>(&mut self, _: &BTreeMap<u32, C>) -> Result<(), InputError> {
        Ok(())
    }
    /// The ties of one kind.
    fn ties<'a, C: TieCard + 'a>(&mut self, _: impl IntoIterator<Item = &'a C>) -> Result<(), InputError> {
        Ok(())
    }
}

/// Shows all elements, in the order in which they are summed, then all dampers and ties. Kinds of cards that are neither are named
/// as well: one that is new to the deck does not compile until it stands here.
#[rustfmt::skip]
pub(crate) fn visit(bulk: &BulkData, visitor: &mut impl Visitor) -> Result<(), InputError> {
    let BulkData {
        beams, rods, conrods, tubes, shear_panels, shells, solids, bushes, line_bushes, springs, general, masses, mass_matrices,
        scalar_masses, dampers, scalar_dampers, rigid, rigid_bodies, rigid_rods, rigid_splines, averages, equations,
        // Read by the elements and ties that refer to them, and by the clamps.
        coords: _, grids: _, scalar_points: _, beam_properties: _, rod_properties: _, tube_properties: _, panel_sections: _, shell_properties: _, laminates: _,
        solid_properties: _, bush_properties: _, line_bush_properties: _, damper_properties: _, damping_properties: _, spring_properties: _, mass_properties: _, materials: _,
        plane_materials: _, ply_materials: _, solid_materials: _, constraints: _, parameters: _, bars_twist: _, loss_factors: _,
        // Read as a whole, once all nodes are there.
        direct_matrices: _, added: _,
        // Taken by the load set that is asked for.
        point_loads: _, scalar_loads: _, line_loads: _, cross_loads: _, beam_loads: _, pressures: _, gravities: _, spins: _, accelerations: _, load_sums: _, enforced: _, temperatures: _,
        // Of the air and of the case control.
        sets: _, panels: _, panel_properties: _, factors: _, surfaces: _, box_lists: _, splines: _, monitors: _,
        matrices: _, aero_reference: _, trim_variables: _, trims: _, divergences: _, aero_links: _, aero_components: _, component_lists: _, supports: _, analysis_sets: _, eigen_methods: _,
        constraint_unions: _, equation_unions: _, subcases: _, unsteady_reference: _, flutters: _, flutter_factors: _,
        reduced_frequencies: _, damping_tables: _,
        // Refused where a structure cannot be without them.
        unknown: _, air_errors: _, gusts: _, dynamic_loads: _, dynamic_sums: _, load_areas: _, extra_points: _,
            frequencies: _, time_steps: _, function_tables: _, spectrum_tables: _, spectra: _,
    } = bulk;
    visitor.elements(beams)?;
    visitor.elements(rods)?;
    visitor.elements(conrods)?;
    visitor.elements(tubes)?;
    visitor.elements(shear_panels)?;
    visitor.elements(shells)?;
    visitor.elements(solids)?;
    visitor.elements(bushes)?;
    visitor.elements(line_bushes)?;
    visitor.elements(springs)?;
    visitor.elements(general)?;
    visitor.elements(masses)?;
    visitor.elements(mass_matrices)?;
    visitor.elements(scalar_masses)?;
    visitor.dampers(dampers)?;
    visitor.dampers(scalar_dampers)?;
    visitor.dampers(bushes)?;
    visitor.dampers(line_bushes)?;
    visitor.ties(rigid.values())?;
    visitor.ties(rigid_bodies.values())?;
    visitor.ties(rigid_rods.values())?;
    visitor.ties(rigid_splines.values())?;
    visitor.ties(averages.values())?;
    visitor.ties(equations)
}
