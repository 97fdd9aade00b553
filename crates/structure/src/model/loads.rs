//! Load sets of a deck as loads on the nodes of its model.

use super::build::{Builder, found, present};
use super::elements::beam_parts;
use super::inertial::{accelerated, outward};
use crate::beam_load::on_grids;
use crate::laminate::ShearModel;
use crate::nonlinear::{Following, Loads, NodeLoad, pressure_shares};
use nalgebra::Vector3;
use nastran::{
    BeamLoad, BulkData, CrossLoad, Gravity, InputError, LineLoad, LoadSum, PointLoad, Pressed, Pressure,
    ScalarLoad, SolidElement, Span, Unread,
};
use std::collections::BTreeSet;

/// Loads that are not read, and would be missing if a set had some.
const UNREAD: &[&str] = &["PLOADX1", "ACCEL", "DEFORM", "CLOAD"];

/// Sine of an angle that is round-off of places.
const ROUND_OFF: f64 = 1e-9;

/// The sets of loads that a deck has, ascending.
pub fn load_sets(bulk: &BulkData) -> Vec<u32> {
    let sums = bulk.load_sums.keys().copied();
    let points = bulk.point_loads.iter().map(|load| load.set);
    let scalars = bulk.scalar_loads.iter().map(|load| load.set);
    let lines = bulk.line_loads.iter().map(|load| load.set);
    let across = bulk.cross_loads.iter().map(|load| load.set);
    let beams = bulk.beam_loads.iter().map(|load| load.set);
    let pressures = bulk.pressures.iter().map(|load| load.set);
    let weights = bulk.gravities.iter().map(|load| load.set);
    let spins = bulk.spins.iter().map(|load| load.set);
    let accelerations = bulk.accelerations.iter().map(|load| load.set);
    let enforced = bulk.enforced.iter().map(|card| card.set);
    let all: BTreeSet<u32> = sums
        .chain(points)
        .chain(scalars)
        .chain(lines)
        .chain(across)
        .chain(beams)
        .chain(pressures)
        .chain(weights)
        .chain(spins)
        .chain(accelerations)
        .chain(enforced)
        .collect();
    all.into_iter().collect()
}

/// The loads of a set: LOAD sums up others. FORCE, MOMENT, PLOAD1, GRAV, ACCEL1 and RFORCE keep their direction, FORCE1, MOMENT1, FORCE2, MOMENT2
/// and pressures follow the structure.
///
/// # Errors
/// If there is no such set, it names what is not there, or the deck has loads that are not read.
pub fn loads_of(bulk: &BulkData, set: u32) -> Result<Loads, InputError> {
    let parts = bulk.summed_sets(set)?;
    let is_meant = |unread: &Unread| parts.iter().any(|(_, part)| unread.numbers.contains(part));
    let mut unread = bulk.unknown.iter().filter(|(name, _)| UNREAD.contains(&name.as_str()));
    if let Some((name, unread)) = unread.find(|(_, unread)| is_meant(unread)) {
        let message = format!("{name} is a load that is not read: leaving it out would change the loads");
        let help = "give it as FORCE, MOMENT, FORCE1, FORCE2, PLOAD, PLOAD1, PLOAD2, PLOAD4, GRAV, ACCEL1 or RFORCE, or take it out of the deck";
        return Err(InputError::at(&unread.first, message).with_help(help));
    }
    let builder = Builder::new(bulk, ShearModel::Equilibrium)?;
    let Some(LoadSum { span, .. }) = bulk.load_sums.get(&set) else {
        let is_enforced = || bulk.enforced.iter().any(|card| card.set == set);
        return match single(&builder, set, None) {
            // Motions alone may load a structure.
            Err(_) if is_enforced() && !has_forces(bulk, set) => Ok(Loads::default()),
            other => other,
        };
    };
    if let Some(card) = bulk.enforced.iter().find(|card| parts.iter().any(|part| part.1 == card.set)) {
        let message = format!("LOAD {set} sums set {}, whose SPCD a LOAD card does not combine", card.set);
        return Err(InputError::at(&card.span, message)
            .with_help("give the SPCD the number that the case control's LOAD names"));
    }
    let mut sum = Loads::default();
    for (factor, part) in parts {
        sum = sum.and(&single(&builder, part, Some(span))?.times(factor));
    }
    Ok(sum)
}

/// Whether a set has cards beside motions.
fn has_forces(bulk: &BulkData, set: u32) -> bool {
    load_sets(&BulkData { enforced: Vec::new(), ..bulk.clone() }).contains(&set)
}

/// A set that is no sum; `asked` is the card that names it.
fn single(builder: &Builder, set: u32, asked: Option<&Span>) -> Result<Loads, InputError> {
    let bulk = builder.bulk;
    let mut loads = Loads::default();
    for load in bulk.point_loads.iter().filter(|load| load.set == set) {
        loads.dead.push(point(builder, load)?);
    }
    for load in bulk.scalar_loads.iter().filter(|load| load.set == set) {
        loads.dead.push(scalar(builder, load)?);
    }
    for load in bulk.line_loads.iter().filter(|load| load.set == set) {
        loads.following.push(line(builder, load)?);
    }
    for load in bulk.cross_loads.iter().filter(|load| load.set == set) {
        loads.following.push(across(builder, load)?);
    }
    for load in bulk.beam_loads.iter().filter(|load| load.set == set) {
        loads.dead.extend(along(builder, load)?);
    }
    for load in bulk.pressures.iter().filter(|load| load.set == set) {
        pressure(builder, load, &mut loads)?;
    }
    for Gravity { cid, vector, span, .. } in bulk.gravities.iter().filter(|load| load.set == set) {
        loads.gravity_m_s2 += builder.frames.axes_at(*cid, span)? * vector;
    }
    for load in bulk.spins.iter().filter(|load| load.set == set) {
        loads.dead.extend(outward(builder, load)?);
    }
    for load in bulk.accelerations.iter().filter(|load| load.set == set) {
        loads.dead.extend(accelerated(builder, load)?);
    }
    if loads == Loads::default() {
        let known: Vec<String> = load_sets(bulk).iter().map(u32::to_string).collect();
        let message = format!("the deck has no loads of set {set}");
        let help = if known.is_empty() {
            "it has none at all".into()
        } else {
            format!("there are {}", known.join(", "))
        };
        return Err(asked
            .map_or_else(|| InputError::general(&message), |span| InputError::at(span, &message))
            .with_help(help));
    }
    Ok(loads)
}

fn point(builder: &Builder, load: &PointLoad) -> Result<NodeLoad, InputError> {
    let user = if load.is_moment { "MOMENT" } else { "FORCE" };
    let node = builder.node(load.grid, &format!("{user} of set {}", load.set), &load.span)?;
    let axes = builder.frames.axes_at_point(load.cid, &builder.nodes[node].point, &load.span)?;
    let (own, none) = (axes * load.vector, Vector3::zeros());
    let (force, moment) = if load.is_moment { (none, own) } else { (own, none) };
    Ok(NodeLoad { node, force, moment })
}

/// The one motion of a scalar point is the first of its six.
fn scalar(builder: &Builder, load: &ScalarLoad) -> Result<NodeLoad, InputError> {
    let node = builder.node(load.point, &format!("SLOAD of set {}", load.set), &load.span)?;
    if !builder.nodes[node].is_scalar {
        let message = format!("SLOAD of set {}: {} is a GRID, not a scalar point", load.set, load.point);
        return Err(InputError::at(&load.span, message).with_help("load a GRID by FORCE or MOMENT"));
    }
    Ok(NodeLoad { node, force: Vector3::x() * load.size, moment: Vector3::zeros() })
}

fn line(builder: &Builder, load: &LineLoad) -> Result<Following, InputError> {
    let user = format!("{} of set {}", if load.is_moment { "MOMENT1" } else { "FORCE1" }, load.set);
    let node = builder.node(load.grid, &user, &load.span)?;
    let line =
        [builder.node(load.line[0], &user, &load.span)?, builder.node(load.line[1], &user, &load.span)?];
    if (builder.nodes[line[1]].point - builder.nodes[line[0]].point).norm() == 0.0 {
        let message = format!("{user}: GRID {} and {} are at one place", load.line[0], load.line[1]);
        return Err(
            InputError::at(&load.span, message).with_help("its direction is from one grid to the other")
        );
    }
    Ok(Following::Along { node, line, size: load.size, is_moment: load.is_moment })
}

fn across(builder: &Builder, load: &CrossLoad) -> Result<Following, InputError> {
    let user = format!("{} of set {}", if load.is_moment { "MOMENT2" } else { "FORCE2" }, load.set);
    let node = builder.node(load.grid, &user, &load.span)?;
    let ends = builder.nodes_of(&load.ends, &user, &load.span)?;
    let lines = [[ends[0], ends[1]], [ends[2], ends[3]]];
    let [a, b] = lines.map(|[from, to]| builder.nodes[to].point - builder.nodes[from].point);
    if a.cross(&b).norm() <= ROUND_OFF * a.norm() * b.norm() {
        let message = format!("{user}: its two lines are parallel, or one has no length");
        return Err(InputError::at(&load.span, message).with_help("its direction is normal to both lines"));
    }
    Ok(Following::Across { node, lines, size: load.size, is_moment: load.is_moment })
}

/// A load along a beam, on its two grids.
fn along(builder: &Builder, load: &BeamLoad) -> Result<[NodeLoad; 2], InputError> {
    let user = format!("PLOAD1 of set {}", load.set);
    let card = found(&builder.bulk.beams, load.element, &user, "CBAR or CBEAM", &load.span)?;
    let parts = beam_parts(card, builder)?;
    let ends = on_grids(&parts, load)?;
    Ok([0, 1].map(|end| NodeLoad { node: parts.nodes[end], force: ends[end][0], moment: ends[end][1] }))
}

fn pressure(builder: &Builder, load: &Pressure, into: &mut Loads) -> Result<(), InputError> {
    let direction =
        load.direction.map(|(system, vector)| directed(builder, system, &vector, load)).transpose()?;
    let user = format!("{} of set {}", ["PLOAD", "PLOAD2", "PLOAD4"][load.form.min(2)], load.set);
    let mut press = |grids: &[u32], sides: &[Option<u32>], sign: f64| -> Result<(), InputError> {
        let (with, midsides) = present(sides);
        if !with.is_empty() && with.len() < grids.len() {
            let message = format!("{user} presses on a face with grids on {} of its sides", with.len());
            return Err(InputError::at(&load.span, message).with_help("on all of them, or on none"));
        }
        let mut face = builder.nodes_of(grids, &user, &load.span)?;
        let pascal: Vec<f64> = load.pressure[..face.len()].iter().map(|p| p * sign).collect();
        face.extend(builder.nodes_of(&midsides, &user, &load.span)?);
        let Some(direction) = direction else {
            into.following.push(Following::Pressure { face, pascal });
            return Ok(());
        };
        // Per area, along a direction of its own, which it keeps.
        let places: Vec<Vector3<f64>> = face.iter().map(|node| builder.nodes[*node].point.coords).collect();
        let shares = pressure_shares(&places, &load.pressure[..pascal.len()]);
        into.dead.extend(face.iter().zip(shares).map(|(node, share)| NodeLoad {
            node: *node,
            force: direction * share,
            moment: Vector3::zeros(),
        }));
        Ok(())
    };
    match &load.on {
        Pressed::Grids(grids) => press(grids, &[], 1.0),
        Pressed::Elements(elements) => {
            for element in elements {
                // PLOAD4 with THRU may run over numbers that no shell has.
                let Some(shell) = builder.bulk.shells.get(element) else {
                    // As in Nastran, a range runs over the elements that there are.
                    let some = || elements.iter().any(|other| builder.bulk.shells.contains_key(other));
                    if load.is_range && (load.form == 2 || some()) {
                        continue;
                    }
                    let message =
                        format!("{user} presses on element {element}, which is no CQUAD4 or CTRIA3");
                    let help = "for a solid PLOAD4 names its face by G1 and G3";
                    return Err(InputError::at(&load.span, message).with_help(help));
                };
                press(&shell.grids, &shell.midsides, 1.0)?;
            }
            Ok(())
        }
        Pressed::Face { element, corner, other } => {
            let solid = builder.bulk.solids.get(element);
            let face = solid.and_then(|solid| Some((solid, face_of(builder, solid, *corner, *other)?)));
            let Some((solid, grids)) = face else {
                let message = format!("{user}: G1 and G3 name no face of a solid {element}");
                let help = "two opposite corners of the face; of a CTETRA one of the face and the one off it";
                return Err(InputError::at(&load.span, message).with_help(help));
            };
            // Faces run so that their normal points out of the solid; pressure pushes in.
            press(&grids, &sides_of(solid, &grids), -1.0)
        }
    }
}

/// The direction of a load per area, of length one in basic axes.
fn directed(
    builder: &Builder,
    system: u32,
    vector: &Vector3<f64>,
    load: &Pressure,
) -> Result<Vector3<f64>, InputError> {
    let Some(grid) = grid_of(builder, load) else { return Ok(vector.normalize()) };
    let place = builder.node(grid, &format!("PLOAD4 of set {}", load.set), &load.span)?;
    let axes = builder.frames.axes_at_point(system, &builder.nodes[place].point, &load.span)?;
    Ok((axes * vector).normalize())
}

/// A grid of what a pressure acts on: axes of curved systems are taken there.
fn grid_of(builder: &Builder, load: &Pressure) -> Option<u32> {
    match &load.on {
        Pressed::Grids(grids) => grids.first().copied(),
        Pressed::Elements(list) => builder.bulk.shells.get(list.first()?)?.grids.first().copied(),
        Pressed::Face { corner, .. } => Some(*corner),
    }
}

/// Faces of the solids by corners, with the normal outside if the corners are in Nastran's order.
const FACES: [&[&[usize]]; 3] = [
    &[&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3]],
    &[&[0, 2, 1], &[3, 4, 5], &[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]],
    &[&[0, 3, 2, 1], &[4, 5, 6, 7], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]],
];

/// The grids on the sides of a face, from its first corner to its second and so on.
fn sides_of(solid: &SolidElement, face: &[u32]) -> Vec<Option<u32>> {
    let grid_between = |at: usize| {
        let ends = [face[at], face[(at + 1) % face.len()]];
        let is_meant = |edge: &[usize; 2]| edge.iter().all(|end| ends.contains(&solid.grids[*end]));
        solid.midsides.get(solid.edges().iter().position(is_meant)?).copied().flatten()
    };
    (0..face.len()).map(grid_between).collect()
}

/// The corners of the face that PLOAD4 names, from `corner` on, with the normal outside.
fn face_of(builder: &Builder, solid: &SolidElement, corner: u32, other: Option<u32>) -> Option<Vec<u32>> {
    let faces = match solid.grids.len() {
        4 => FACES[0],
        6 => FACES[1],
        _ => FACES[2],
    };
    let named = faces.iter().map(|face| face.iter().map(|at| solid.grids[*at]).collect::<Vec<u32>>());
    let is_meant = |face: &Vec<u32>| {
        let place = |grid: u32| face.iter().position(|own| *own == grid);
        match (place(corner), other) {
            (None, _) => false,
            (Some(_), None) => face.len() == 3,
            (Some(_), Some(off)) if solid.grids.len() == 4 => {
                place(off).is_none() && solid.grids.contains(&off)
            }
            (Some(one), Some(opposite)) => face.len() == 4 && place(opposite) == Some((one + 2) % 4),
        }
    };
    let mut face = named.into_iter().find(is_meant)?;
    let at = face.iter().position(|own| *own == corner)?;
    face.rotate_left(at);
    // An element may be numbered in either sense.
    let place =
        |grid: &u32| builder.node(*grid, "", &solid.span).ok().map(|node| builder.nodes[node].point.coords);
    let middle = |grids: &[u32]| -> Option<Vector3<f64>> {
        Some(grids.iter().map(place).sum::<Option<Vector3<f64>>>()? / (grids.len() as f64))
    };
    let out = middle(&face)? - middle(&solid.grids)?;
    let normal = (place(&face[1])? - place(&face[0])?).cross(&(place(&face[2])? - place(&face[0])?));
    if normal.dot(&out) < 0.0 {
        face[1..].reverse();
    }
    Some(face)
}
