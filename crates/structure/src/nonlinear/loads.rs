//! Loads on a structure that bends far: fixed in space, turning with it, and the weight of what it carries.

use super::state::State;
use crate::serendipity::{self, Edge, with_midsides};
use crate::solid::{gauss_2, gauss_3, radon};
use crate::system::System;
use faer::Mat;
use nalgebra::{Rotation3, Vector3};

/// Force and moment at a node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NodeLoad {
    /// Position of the node.
    pub node: usize,
    /// Force, basic axes, N.
    pub force: Vector3<f64>,
    /// Moment, basic axes, Nm.
    pub moment: Vector3<f64>,
}

/// A load whose direction follows the structure.
#[derive(Debug, Clone, PartialEq)]
pub enum Following {
    /// Turns with the node it acts on; given at the undeformed place.
    Node(NodeLoad),
    /// Along the line from one node to another (FORCE1, MOMENT1).
    Along {
        /// The node it acts on.
        node: usize,
        /// The two ends of the line.
        line: [usize; 2],
        /// N, or Nm.
        size: f64,
        /// A moment about the line instead of a force along it.
        is_moment: bool,
    },
    /// Normal to two lines, first cross second (FORCE2, MOMENT2).
    Across {
        /// The node it acts on.
        node: usize,
        /// The ends of both lines.
        lines: [[usize; 2]; 2],
        /// N, or Nm.
        size: f64,
        /// A moment instead of a force.
        is_moment: bool,
    },
    /// A pressure on a face of three or four corners, with or without nodes on all of its sides, along its normal of now: positive on the side from which the
    /// nodes run the other way round, so that it pushes along the normal by the right hand.
    Pressure {
        /// The corners, around the face, then the nodes of its sides (from the first corner to the second and so on), if it has some.
        face: Vec<usize>,
        /// Pa, by corner.
        pascal: Vec<f64>,
    },
}

/// A set of loads.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Loads {
    /// Fixed in space.
    pub dead: Vec<NodeLoad>,
    /// Following the structure.
    pub following: Vec<Following>,
    /// Acceleration of gravity on all masses, basic axes, m/s^2.
    pub gravity_m_s2: Vector3<f64>,
}

impl Loads {
    /// The loads times a factor.
    #[must_use]
    pub fn times(&self, factor: f64) -> Self {
        let node =
            |load: &NodeLoad| NodeLoad { force: load.force * factor, moment: load.moment * factor, ..*load };
        let following = |load: &Following| {
            let mut load = load.clone();
            match &mut load {
                Following::Node(own) => *own = node(own),
                Following::Along { size, .. } | Following::Across { size, .. } => *size *= factor,
                Following::Pressure { pascal, .. } => pascal.iter_mut().for_each(|p| *p *= factor),
            }
            load
        };
        Self {
            dead: self.dead.iter().map(node).collect(),
            following: self.following.iter().map(following).collect(),
            gravity_m_s2: self.gravity_m_s2 * factor,
        }
    }

    /// Both sets together.
    #[must_use]
    pub fn and(mut self, other: &Self) -> Self {
        self.dead.extend_from_slice(&other.dead);
        self.following.extend_from_slice(&other.following);
        self.gravity_m_s2 += other.gravity_m_s2;
        self
    }

    /// Forces and moments on the nodes (g-set, basic axes) at a state, without weight.
    pub(crate) fn at(&self, state: &State) -> Vec<f64> {
        let mut sum = self.following_at(state);
        for load in &self.dead {
            for i in 0..3 {
                sum[6 * load.node + i] += load.force[i];
                sum[6 * load.node + 3 + i] += load.moment[i];
            }
        }
        sum
    }

    /// The part of those that follow.
    pub(crate) fn following_at(&self, state: &State) -> Vec<f64> {
        let mut sum = vec![0.0; 6 * state.places.len()];
        let mut add = |node: usize, first: usize, value: &Vector3<f64>| {
            (0..3).for_each(|i| sum[6 * node + first + i] += value[i]);
        };
        let place = |node: &usize| state.places[*node];
        for load in &self.following {
            match load {
                Following::Node(load) => {
                    let turned = state.rotations[load.node];
                    add(load.node, 0, &(turned * load.force));
                    add(load.node, 3, &(turned * load.moment));
                }
                Following::Along { node, line: [a, b], size, is_moment } => {
                    let direction = (place(b) - place(a)).try_normalize(0.0).unwrap_or_default();
                    add(*node, if *is_moment { 3 } else { 0 }, &(direction * *size));
                }
                Following::Across { node, lines: [[a, b], [c, d]], size, is_moment } => {
                    let normal = (place(b) - place(a)).cross(&(place(d) - place(c)));
                    let direction = normal.try_normalize(0.0).unwrap_or_default();
                    add(*node, if *is_moment { 3 } else { 0 }, &(direction * *size));
                }
                Following::Pressure { face, pascal } => {
                    let corners: Vec<Vector3<f64>> = face.iter().map(place).collect();
                    for (node, force) in face.iter().zip(pressure_forces(&corners, pascal)) {
                        add(*node, 0, &force);
                    }
                }
            }
        }
        sum
    }
}

impl System {
    /// Forces and moments (N, Nm; g-set, basic axes) of loads on the undeformed structure, the weight of its masses among
    /// them.
    pub fn forces_of(&self, loads: &Loads) -> Mat<f64> {
        let places: Vec<Vector3<f64>> = self.points().iter().map(|point| point.coords).collect();
        let rotations = vec![Rotation3::identity(); places.len()];
        let fixed = loads.at(&State { places, rotations });
        let pull = |i: usize| if i % 6 < 3 { loads.gravity_m_s2[i % 6] } else { 0.0 };
        let weight = self.inertia_loads(Mat::from_fn(fixed.len(), 1, |i, _| pull(i)).as_ref());
        Mat::from_fn(fixed.len(), 1, |i, _| fixed[i] + weight[(i, 0)])
    }
}

/// Work-equivalent forces of a pressure that is interpolated between the corners (`pascal`), along the surface's normal. A face of six
/// or eight nodes is curved: its corners, then the nodes of its sides.
pub(crate) fn pressure_forces(nodes: &[Vector3<f64>], pascal: &[f64]) -> Vec<Vector3<f64>> {
    pressed(nodes, pascal, |normal| normal)
}

/// Sizes of the work-equivalent forces of a load per area, whatever its direction.
pub(crate) fn pressure_shares(nodes: &[Vector3<f64>], pascal: &[f64]) -> Vec<f64> {
    let sizes = pressed(nodes, pascal, |normal| Vector3::new(normal.norm(), 0.0, 0.0));
    sizes.into_iter().map(|size| size.x).collect()
}

/// The integral of the pressure times something of the normal (its length an area), shared by the shape functions.
fn pressed(
    nodes: &[Vector3<f64>],
    pascal: &[f64],
    of: impl Fn(Vector3<f64>) -> Vector3<f64>,
) -> Vec<Vector3<f64>> {
    let mut forces = vec![Vector3::zeros(); nodes.len()];
    for (at, weight) in face_points(nodes.len()) {
        let is_triangle = nodes.len().is_multiple_of(3);
        let linear = if is_triangle { serendipity::triangle(at) } else { serendipity::quadrilateral(at) };
        let p: f64 = pascal.iter().zip(&linear.values).map(|(p, n)| p * n).sum();
        let sides: &[Edge] = match nodes.len() {
            6 => &serendipity::TRIANGLE,
            8 => &serendipity::QUADRILATERAL,
            _ => &[],
        };
        let functions = with_midsides(linear, sides.iter().copied(), [at[0], at[1], 0.0]);
        let along = |axis: usize| -> Vector3<f64> {
            nodes.iter().zip(&functions.slopes).map(|(x, slope)| x * slope[axis]).sum()
        };
        let normal = of(along(0).cross(&along(1))) * (p * weight);
        forces.iter_mut().zip(&functions.values).for_each(|(force, n)| *force += normal * *n);
    }
    forces
}

/// Points of integration of a face and their weights.
fn face_points(nodes: usize) -> Vec<([f64; 2], f64)> {
    if nodes.is_multiple_of(3) {
        return radon().map(|(r, s, weight)| ([r, s], weight)).into();
    }
    let square = |line: &[(f64, f64)]| -> Vec<([f64; 2], f64)> {
        line.iter().flat_map(|(x, wx)| line.iter().map(move |(y, wy)| ([*x, *y], wx * wy))).collect()
    };
    if nodes == 4 { square(&gauss_2()) } else { square(&gauss_3()) }
}
