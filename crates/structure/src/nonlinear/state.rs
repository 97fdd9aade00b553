//! Where the nodes are and how they are turned.

use nalgebra::{Matrix3, Rotation3, Vector3};

use super::rotation::logarithm;
use crate::model::Node;

/// Place and rotation of every node.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// Places, basic system, m.
    pub places: Vec<Vector3<f64>>,
    /// Rotations from the undeformed attitude.
    pub rotations: Vec<Rotation3<f64>>,
}

impl State {
    /// The undeformed one.
    pub(crate) fn undeformed(nodes: &[Node]) -> Self {
        let places = nodes.iter().map(|node| node.point.coords).collect();
        Self { places, rotations: vec![Rotation3::identity(); nodes.len()] }
    }

    /// Displacements (m) and rotation vectors (rad, up to half a turn) of all nodes: the g-set, basic axes.
    pub fn displacements(&self, nodes: &[Node]) -> Vec<f64> {
        let one = |(at, node): (usize, &Node)| {
            let (moved, turned) =
                (self.places[at] - node.point.coords, logarithm(self.rotations[at].matrix()));
            [moved.x, moved.y, moved.z, turned.x, turned.y, turned.z]
        };
        nodes.iter().enumerate().flat_map(one).collect()
    }

    /// Moves every node by a displacement and a spin (g-set, basic axes).
    pub(crate) fn moved(&mut self, motion: &[f64]) {
        for (node, motion) in motion.chunks_exact(6).enumerate() {
            self.places[node] += Vector3::new(motion[0], motion[1], motion[2]);
            let spin = Vector3::new(motion[3], motion[4], motion[5]);
            self.rotations[node] = Rotation3::from_scaled_axis(spin) * self.rotations[node];
        }
    }

    /// Every node moved by a displacement and a spin (m, rad; g-set, basic axes).
    #[must_use]
    pub fn moved_by(&self, motion: &[f64]) -> Self {
        let mut state = self.clone();
        state.moved(motion);
        state
    }

    /// The whole structure turned about the origin: the same equilibrium if loads turn with it.
    #[must_use]
    pub fn turned(&self, rotation: &Rotation3<f64>) -> Self {
        let places = self.places.iter().map(|place| rotation * place).collect();
        Self { places, rotations: self.rotations.iter().map(|own| rotation * own).collect() }
    }

    /// A node's rotation.
    pub(crate) fn rotation(&self, node: usize) -> &Matrix3<f64> {
        self.rotations[node].matrix()
    }
}
