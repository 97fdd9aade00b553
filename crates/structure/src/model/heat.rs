//! Thermal expansion: what temperatures of a set do to a structure, as forces on its nodes.
//!
//! An element that is warmer by T strains by `A T` where nothing holds it. Of beams, rods and shells the free deformation is a motion of the
//! nodes, and the forces are the stiffness times that; solids, whose temperature varies inside, are integrated. Strains go from TEMPERATURE(INITIAL),
//! else from the material's TREF (laminates: from the property's), as in MSC Nastran's linear statics. Elements without a temperature of their own
//! take the mean of their grids', as there.

use super::build::{Builder, found};
use super::elements::beam_parts;
use super::registry::ElementCard;
use super::temperatures::Warmth;
use crate::beam::element_axes;
use crate::element::Element;
use crate::laminate::ShearModel;
use crate::plane_material::strain_rotation;
use crate::shell::Shell;
use nalgebra::{DVector, Matrix6, Point3, Vector3, Vector6};
use nastran::{
    BeamElement, BulkData, Expansion, InputError, LaminateOption, Pcomp, Pshell, ShellElement, SolidElement,
    Span,
};

/// The forces (N, Nm; g-set, basic axes) that temperatures of the set `load` put on the nodes of a deck under its boundary conditions
/// ([`BulkData::bounded`]): those that would hold the structure's free expansion. `initial` is the set at which nothing has expanded.
///
/// # Errors
/// If a grid of an element that expands has no temperature, or the deck says something of temperatures that is not read.
pub fn thermal_loads(bulk: &BulkData, load: u32, initial: Option<u32>) -> Result<Vec<f64>, InputError> {
    let warmth = Warmth::of(bulk, load, initial)?;
    let mut builder = Builder::new(bulk, ShearModel::Equilibrium)?;
    let mut forces = vec![0.0; 6 * builder.nodes.len()];
    for card in bulk.beams.values() {
        if let Some(motions) = beam(card, &builder, &warmth)? {
            add(&mut forces, &*card.element(&mut builder)?, &motions);
        }
    }
    for card in bulk.rods.values() {
        let material = bulk.rod_properties.get(&card.property).map(|section| section.material);
        let rod = Rod { card, id: card.id, grids: card.grids, material, span: &card.span };
        rod.add(&mut forces, &mut builder, &warmth)?;
    }
    for card in bulk.tubes.values() {
        let material = bulk.tube_properties.get(&card.property).map(|section| section.material);
        let rod = Rod { card, id: card.id, grids: card.grids, material, span: &card.span };
        rod.add(&mut forces, &mut builder, &warmth)?;
    }
    for card in bulk.conrods.values() {
        let material = Some(card.material);
        let rod = Rod { card, id: card.id, grids: card.grids, material, span: &card.span };
        rod.add(&mut forces, &mut builder, &warmth)?;
    }
    for card in bulk.shells.values() {
        if let Some(motions) = shell(card, &builder, &warmth)? {
            add(&mut forces, &*card.element(&mut builder)?, &motions);
        }
    }
    for card in bulk.solids.values() {
        solid(&mut forces, card, &mut builder, &warmth)?;
    }
    Ok(forces)
}

/// Adds stiffness times motions (six a node of the element, basic axes).
fn add(forces: &mut [f64], element: &dyn Element, motions: &[f64]) {
    let Some(k) = element.stiffness() else { return };
    let dofs = element.dofs();
    let own = |dof: &usize| {
        let place = element.nodes().iter().position(|node| *node == dof / 6);
        place.map_or(0.0, |place| motions[6 * place + dof % 6])
    };
    let u = DVector::from_iterator(dofs.len(), dofs.iter().map(own));
    for (dof, force) in dofs.iter().zip((&*k * u).iter()) {
        forces[*dof] += force;
    }
}

/// Motions of a beam's grids as it expands and bends freely with end A held; nothing if it does not expand.
fn beam(card: &BeamElement, builder: &Builder, warmth: &Warmth) -> Result<Option<Vec<f64>>, InputError> {
    let parts = beam_parts(card, builder)?;
    let Expansion { strain, reference } = parts.material.expansion;
    if strain[0] == 0.0 {
        return Ok(None);
    }
    let user = format!("{} {}", if card.is_beam { "CBEAM" } else { "CBAR" }, card.id);
    let (rise, [at_a, at_b]) = warmth.bar(card.id, &card.grids, reference, &user, &card.span)?;
    let (length, axes) = element_axes(card.id, &parts.placement, &card.span)?;
    // A fibre at y strains by A T1 y, and a curvature v'' by -v'' y: v'' = -A T1, linear along the beam.
    let slope = |plane: usize| -strain[0] * length * 0.5 * (at_a[plane] + at_b[plane]);
    let sag = |plane: usize| -strain[0] * length.powi(2) * (at_a[plane] / 3.0 + at_b[plane] / 6.0);
    let turn = axes * Vector3::new(0.0, -slope(1), slope(0));
    let end = axes * Vector3::new(strain[0] * rise * length, sag(0), sag(1));
    let at_grid = end - turn.cross(&parts.placement.offsets[1]);
    let mut motions = vec![0.0; 12];
    (0..3).for_each(|axis| (motions[6 + axis], motions[9 + axis]) = (at_grid[axis], turn[axis]));
    Ok(Some(motions))
}

/// A rod of any kind with what its expansion needs.
struct Rod<'a, C> {
    card: &'a C,
    id: u32,
    grids: [u32; 2],
    material: Option<u32>,
    span: &'a Span,
}

impl<C: ElementCard> Rod<'_, C> {
    /// Adds its forces.
    fn add(&self, forces: &mut [f64], builder: &mut Builder, warmth: &Warmth) -> Result<(), InputError> {
        // What is missing is said where the element is made.
        let material = self.material.and_then(|id| builder.bulk.materials.get(&id));
        let Expansion { strain, reference } = material.map(|material| material.expansion).unwrap_or_default();
        if strain[0] == 0.0 {
            return Ok(());
        }
        let element = self.card.element(builder)?;
        let (rise, _) =
            warmth.bar(self.id, &self.grids, reference, &format!("rod {}", self.id), self.span)?;
        let [a, b] = [0, 1].map(|end| builder.nodes[element.nodes()[end]].point);
        let longer = (b - a) * (strain[0] * rise);
        let mut motions = vec![0.0; 12];
        (0..3).for_each(|axis| motions[6 + axis] = longer[axis]);
        add(forces, &*element, &motions);
        Ok(())
    }
}

/// Free strains of a shell at its reference surface: strains, then curvatures, in the section's axes.
type Free = Vector6<f64>;

/// Motions of a shell's grids as it expands freely; nothing if it does not expand.
fn shell(card: &ShellElement, builder: &Builder, warmth: &Warmth) -> Result<Option<Vec<f64>>, InputError> {
    let bulk = builder.bulk;
    let user = format!("shell {}", card.id);
    let grids: Vec<u32> = card.grids.iter().chain(card.midsides.iter().flatten()).copied().collect();
    let warm = |reference: f64| warmth.plate(card.id, &grids, reference, &user, &card.span);
    let plain = bulk.shell_properties.get(&card.property);
    let (free, is_isotropic) = match (plain, bulk.laminates.get(&card.property)) {
        (Some(property), _) => plate(property, builder, warm)?,
        (None, Some(property)) => (laminate(property, builder, warm)?, false),
        // Said where the element is made.
        (None, None) => return Ok(None),
    };
    if free.amax() == 0.0 {
        return Ok(None);
    }
    let nodes = builder.nodes_of(&grids, &user, &card.span)?;
    let points: Vec<Point3<f64>> = nodes.iter().map(|node| builder.nodes[*node].point).collect();
    let mut motions = vec![0.0; 6 * points.len()];
    let bends = free.fixed_rows::<3>(3).amax() > 0.0;
    if is_isotropic && !bends {
        for (at, point) in points.iter().enumerate() {
            let moved = (point - points[0]) * free[0];
            (0..3).for_each(|axis| motions[6 * at + axis] = moved[axis]);
        }
        return Ok(Some(motions));
    }
    let corners = &points[..card.grids.len()];
    let flat = Shell::axes_of(corners).filter(|_| card.midsides.is_empty());
    let Some(axes) = flat else {
        let message =
            format!("{user} with grids on its sides is warmed unevenly or has no isotropic material");
        return Err(InputError::at(&card.span, message).with_help("use CQUAD4 and CTRIA3 for it"));
    };
    let turn = strain_rotation(-builder.angle(card, corners, &user)?);
    let (strain, curvature) = (turn * free.fixed_rows::<3>(0), turn * free.fixed_rows::<3>(3));
    for (at, point) in points.iter().enumerate() {
        let place = axes * (point - points[0]);
        let (x, y) = (place.x, place.y);
        // e + z k with k = -(w,xx w,yy 2 w,xy).
        let [kx, ky, kxy] = [curvature[0], curvature[1], curvature[2]];
        let slopes = [-(kx * x + 0.5 * kxy * y), -(ky * y + 0.5 * kxy * x)];
        let w = -0.5 * (kx * x * x + ky * y * y + kxy * x * y);
        let own = Vector3::new(strain[0] * x + 0.5 * strain[2] * y, strain[1] * y + 0.5 * strain[2] * x, w);
        let turned = Vector3::new(slopes[1], -slopes[0], 0.0);
        // The reference surface stands off the grids.
        let own = own - turned.cross(&Vector3::new(0.0, 0.0, card.offset));
        let (moved, turned) = (axes.transpose() * own, axes.transpose() * turned);
        for axis in 0..3 {
            (motions[6 * at + axis], motions[6 * at + 3 + axis]) = (moved[axis], turned[axis]);
        }
    }
    Ok(Some(motions))
}

/// Free strains of a PSHELL, and whether they are alike in all directions.
fn plate(
    card: &Pshell,
    builder: &Builder,
    warm: impl Fn(f64) -> Result<[f64; 2], InputError>,
) -> Result<(Free, bool), InputError> {
    let of = |id: Option<u32>| id.map_or(Expansion::default(), |id| expansion(builder.bulk, id));
    let (membrane, bending) = (of(card.membrane.or(card.bending)), of(card.bending.or(card.membrane)));
    if membrane == Expansion::default() && bending == membrane {
        return Ok((Free::zeros(), true));
    }
    if card.coupling.is_some() {
        let message = format!("PSHELL {} has MID4, and its thermal expansion is not computed", card.id);
        return Err(InputError::at(&card.span, message).with_help("write its layers as PCOMP"));
    }
    let [rise, gradient] = warm(membrane.reference)?;
    let [a, b] = [membrane, bending].map(|of| Vector3::new(of.strain[0], of.strain[1], of.strain[3]));
    let free = Free::from_iterator((a * rise).iter().chain((b * gradient).iter()).copied());
    Ok((free, a[0] == a[1] && a[2] == 0.0))
}

/// Free strains of a laminate: those at which the sums of its layers' forces and moments vanish.
fn laminate(
    card: &Pcomp,
    builder: &Builder,
    warm: impl Fn(f64) -> Result<[f64; 2], InputError>,
) -> Result<Free, InputError> {
    let layers = builder.layers(card)?;
    let expands = |id: u32| expansion(builder.bulk, id).strain != [0.0; 6];
    if !layers.iter().any(|(_, material)| expands(*material)) {
        return Ok(Free::zeros());
    }
    if let Some(word) = card.option.word().filter(|_| card.option != LaminateOption::Symmetric) {
        let message = format!("PCOMP {} has LAM {word}, and its thermal expansion is not computed", card.id);
        return Err(InputError::at(&card.span, message).with_help("list all plies and leave LAM empty"));
    }
    let [rise, gradient] = warm(card.reference)?;
    let (mut stiff, mut push) = (Matrix6::<f64>::zeros(), Free::zeros());
    for (ply, material) in &layers {
        let strain = expansion(builder.bulk, *material).strain;
        let own = strain_rotation(-ply.angle_rad) * Vector3::new(strain[0], strain[1], strain[3]);
        let q = ply.material.turned(ply.angle_rad).stiffness;
        let power = |n: i32| (ply.z_high_m.powi(n) - ply.z_low_m.powi(n)) / f64::from(n);
        for (row, column) in (0..4).map(|at| (at / 2, at % 2)) {
            let mut block = stiff.fixed_view_mut::<3, 3>(3 * row, 3 * column);
            block += q * power(1 + i32::from(row == 1) + i32::from(column == 1));
        }
        let pushed = q * own;
        let mut forces = push.fixed_rows_mut::<3>(0);
        forces += pushed * (rise * power(1) + gradient * power(2));
        let mut moments = push.fixed_rows_mut::<3>(3);
        moments += pushed * (rise * power(2) + gradient * power(3));
    }
    stiff.lu().solve(&push).ok_or_else(|| {
        InputError::at(&card.span, format!("PCOMP {} stores no energy in some strain", card.id))
    })
}

/// The expansion of a material of any kind; what is missing is said where the element is made.
fn expansion(bulk: &BulkData, id: u32) -> Expansion {
    let plane = bulk.plane_materials.get(&id).map(|card| card.expansion);
    let ply = bulk.ply_materials.get(&id).map(|card| card.expansion);
    bulk.materials.get(&id).map(|card| card.expansion).or(plane).or(ply).unwrap_or_default()
}

/// Adds the forces of a solid.
fn solid(
    forces: &mut [f64],
    card: &SolidElement,
    builder: &mut Builder,
    warmth: &Warmth,
) -> Result<(), InputError> {
    let user = format!("solid {}", card.id);
    let property = found(&builder.bulk.solid_properties, card.property, &user, "PSOLID", &card.span)?;
    let of_axes = builder.bulk.solid_materials.get(&property.material).map(|material| material.expansion);
    let of_all = builder.bulk.materials.get(&property.material).map(|material| material.expansion);
    let own = of_all.or(of_axes).unwrap_or_default();
    if own.strain == [0.0; 6] {
        return Ok(());
    }
    if of_all.is_none() && property.cordm != 0 {
        let message =
            format!("{user} expands in axes of its own (CORDM {}), which is not computed", property.cordm);
        return Err(
            InputError::at(&property.span, message).with_help("give the material in the basic system")
        );
    }
    let grids: Vec<u32> = card.grids.iter().chain(card.midsides.iter().flatten()).copied().collect();
    let rises = warmth.grids(&grids, own.reference, &user, &card.span)?;
    let pushed = builder.solid_expansion(card, &Vector6::from(own.strain), &rises)?;
    for (dof, force) in pushed {
        forces[dof] += force;
    }
    Ok(())
}
