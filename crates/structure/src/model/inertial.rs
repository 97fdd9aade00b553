//! Loads on masses: of a steady rotation (RFORCE), which pushes them outward, and of accelerations at single grids (ACCEL1).

use super::build::Builder;
use super::{MassForm, Model};
use crate::assemble::mass_matrix;
use crate::laminate::ShearModel;
use crate::nonlinear::NodeLoad;
use nalgebra::{DMatrix, DVector, Matrix3, Point3, Vector3};
use nastran::{Acceleration, InputError, Spin};
use std::collections::BTreeSet;
use std::f64::consts::TAU;

/// Forces and moments on the nodes: M c, c = -w x (w x (r - r0)) at the nodes, of the masses in the form that Nastran gives them. A body beside its
/// grid (CONM2) is pushed at its centre of gravity and turned by its inertia, as its particles would be.
pub(super) fn outward(builder: &Builder, card: &Spin) -> Result<Vec<NodeLoad>, InputError> {
    let user = format!("RFORCE of set {}", card.set);
    let omega = builder.frames.axes_at(card.cid, &card.span)? * card.turns_per_s * TAU;
    let through = match card.grid {
        Some(grid) => builder.nodes[builder.node(grid, &user, &card.span)?].point,
        None => Point3::origin(),
    };
    let model = with_masses(builder)?;
    let at = |place: &Point3<f64>| -omega.cross(&omega.cross(&(place - through)));
    let mut loads = unloaded(&model);
    for element in &model.elements {
        let dofs = element.dofs();
        let Some(mass) = mass_matrix(&model, element, &dofs) else { continue };
        let body = Body::of(&mass, &dofs).filter(|_| element.stiffness().is_none());
        if let (Some(body), [node]) = (body, element.nodes()) {
            let force = at(&(model.nodes[*node].point + body.arm_m)) * body.mass_kg;
            loads[*node].force += force;
            loads[*node].moment += body.arm_m.cross(&force) - omega.cross(&(body.inertia_kg_m2 * omega));
            continue;
        }
        push(&mut loads, &mass, &dofs, |node| at(&model.nodes[node].point));
    }
    Ok(loaded(loads))
}

/// Forces and moments on the nodes: M a, a the acceleration at the grids of the card and zero at all others.
pub(super) fn accelerated(builder: &Builder, card: &Acceleration) -> Result<Vec<NodeLoad>, InputError> {
    let user = format!("ACCEL1 of set {}", card.set);
    let vector = builder.frames.axes_at(card.cid, &card.span)? * card.vector;
    let grids: BTreeSet<usize> = builder.nodes_of(&card.grids, &user, &card.span)?.into_iter().collect();
    let model = with_masses(builder)?;
    let mut loads = unloaded(&model);
    for element in &model.elements {
        let dofs = element.dofs();
        if let Some(mass) = mass_matrix(&model, element, &dofs) {
            let at = |node: usize| if grids.contains(&node) { vector } else { Vector3::zeros() };
            push(&mut loads, &mass, &dofs, at);
        }
    }
    Ok(loaded(loads))
}

/// The deck's model with masses in the form that Nastran gives them.
fn with_masses(builder: &Builder) -> Result<Model, InputError> {
    let mut model = Model::read(builder.bulk, ShearModel::Equilibrium, true)?;
    model.mass_form = MassForm::of_deck(builder.bulk);
    Ok(model)
}

fn unloaded(model: &Model) -> Vec<NodeLoad> {
    let none = |node| NodeLoad { node, force: Vector3::zeros(), moment: Vector3::zeros() };
    (0..model.nodes.len()).map(none).collect()
}

fn loaded(mut loads: Vec<NodeLoad>) -> Vec<NodeLoad> {
    loads.retain(|load| load.force != Vector3::zeros() || load.moment != Vector3::zeros());
    loads
}

/// Adds what a mass over some motions does to accelerations of its nodes.
fn push(loads: &mut [NodeLoad], mass: &DMatrix<f64>, dofs: &[usize], at: impl Fn(usize) -> Vector3<f64>) {
    let own = |dof: &usize| if dof % 6 < 3 { at(dof / 6)[dof % 6] } else { 0.0 };
    let pushed = mass * DVector::from_iterator(dofs.len(), dofs.iter().map(own));
    for (dof, value) in dofs.iter().zip(&pushed) {
        let load = &mut loads[dof / 6];
        let vector = if dof % 6 < 3 { &mut load.force } else { &mut load.moment };
        vector[dof % 3] += value;
    }
}

/// A rigid body at a node.
struct Body {
    mass_kg: f64,
    arm_m: Vector3<f64>,
    /// About its centre of gravity.
    inertia_kg_m2: Matrix3<f64>,
}

impl Body {
    /// Of a mass matrix over some motions of one node; nothing if its mass is not the same in all directions.
    fn of(mass: &DMatrix<f64>, dofs: &[usize]) -> Option<Self> {
        let mut all = nalgebra::Matrix6::zeros();
        for (i, row) in dofs.iter().enumerate() {
            for (j, column) in dofs.iter().enumerate() {
                all[(row % 6, column % 6)] = mass[(i, j)];
            }
        }
        let (m, about) = (all[(0, 0)], all.fixed_view::<3, 3>(3, 0).into_owned());
        let is_body =
            m > 0.0 && all.fixed_view::<3, 3>(0, 0) == Matrix3::identity() * m && about == -about.transpose();
        let arm_m = Vector3::new(about[(2, 1)], about[(0, 2)], about[(1, 0)]) / m;
        let cross = arm_m.cross_matrix();
        let inertia_kg_m2 = all.fixed_view::<3, 3>(3, 3) + cross * cross * m;
        is_body.then_some(Self { mass_kg: m, arm_m, inertia_kg_m2 })
    }
}
