//! What makes flat shells those of Nastran: the normals that they share at grids (PARAM SNORM) and the weak stiffness of
//! rotations about normals (PARAM K6ROT).

use super::node::Node;
use crate::element::Element;
use crate::shell::Shell;
use nalgebra::{Point3, Vector3};
use nastran::{BulkData, InputError, ShellParameters};

/// The rule of a deck.
pub(super) struct NastranShells {
    /// In units of the membrane's shear stiffness.
    tie: f64,
    /// Of each node, in basic axes; nothing where its shells meet at more than SNORM.
    normals: Vec<Option<Vector3<f64>>>,
}

impl NastranShells {
    /// Of a deck with `nodes` in ascending number.
    pub(super) fn new(bulk: &BulkData, nodes: &[Node]) -> Result<Self, InputError> {
        let ShellParameters { k6rot, snorm_deg } = bulk.shell_parameters()?;
        let least = snorm_deg.to_radians().cos();
        let mut own = vec![Vec::new(); nodes.len()];
        let place = |grid: &u32| nodes.binary_search_by_key(grid, |node| node.id).ok();
        for card in bulk.shells.values().filter(|card| card.midsides.is_empty() && snorm_deg > 0.0) {
            // What is missing or has no area is refused with its own message where the element is made.
            let Some(corners) = card.grids.iter().map(place).collect::<Option<Vec<_>>>() else { continue };
            let points: Vec<Point3<f64>> = corners.iter().map(|node| nodes[*node].point).collect();
            let Some(axes) = Shell::axes_of(&points) else { continue };
            for node in corners {
                own[node].push(axes.row(2).transpose());
            }
        }
        Ok(Self { tie: 1e-6 * k6rot, normals: own.iter().map(|own| shared(own, least)).collect() })
    }

    /// A flat shell as Nastran has it.
    pub(super) fn shell(&self, shell: Shell) -> Shell {
        let normals: Vec<_> = shell.nodes().iter().map(|node| self.normals[*node]).collect();
        shell.as_nastran().with_drilling_tie(self.tie).with_grid_normals(normals)
    }
}

/// The mean of normals, whichever way each of them shows, if none stands off it by an angle with less than the cosine `least`.
fn shared(own: &[Vector3<f64>], least: f64) -> Option<Vector3<f64>> {
    let first = own.first()?;
    let mean = own.iter().map(|normal| normal * normal.dot(first).signum()).sum::<Vector3<f64>>();
    let mean = mean.try_normalize(f64::EPSILON)?;
    own.iter().all(|normal| normal.dot(&mean).abs() >= least).then_some(mean)
}
