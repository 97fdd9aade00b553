//! Weight and loads fixed in space: how they change as the nodes move, seen from the other side.

use super::adjoint::moments_across;
use super::corotated::Corotated;
use super::differences::differenced;
use super::loads::Loads;
use super::state::State;
use super::structure::LargeDeflection;
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};

/// Entries below this share of an element's mass are round-off.
const ROUND_OFF: f64 = 1e-12;

/// The change of dead loads about a state.
#[derive(Debug, Clone)]
pub struct DeadChange {
    /// Change of an element's weight by the motion of its nodes, of those whose weight turns with them: motions and matrix.
    terms: Vec<(Vec<usize>, DMatrix<f64>)>,
    /// Forces and moments on the nodes, N and Nm (g-set).
    forces: Vec<f64>,
}

impl DeadChange {
    /// Derivatives (N, Nm; g-set) by displacements and spins of the work of the loads in a virtual motion of the nodes (m, rad;
    /// g-set, basic axes).
    pub fn transposed(&self, motion: &[f64]) -> Vec<f64> {
        let mut all = vec![0.0; motion.len()];
        for (dofs, by_motion) in &self.terms {
            for (i, column) in dofs.iter().enumerate() {
                all[*column] +=
                    dofs.iter().enumerate().map(|(j, dof)| by_motion[(j, i)] * motion[*dof]).sum::<f64>();
            }
        }
        all
    }

    /// The same in the symmetric form that [`LargeDeflection::adjoint`] asks for.
    pub fn transposed_in_equilibrium(&self, motion: &[f64]) -> Vec<f64> {
        let across = moments_across(&self.forces, motion);
        self.transposed(motion).iter().zip(across).map(|(own, across)| own - 0.5 * across).collect()
    }
}

impl LargeDeflection {
    /// How loads fixed in space, weight among them, change about a state.
    pub fn change_of_dead(&self, state: &State, loads: &Loads) -> DeadChange {
        let gravity_m_s2 = &loads.gravity_m_s2;
        let turning =
            self.elements.iter().filter(|element| element.mass.as_ref().is_some_and(|m| turns(element, m)));
        let terms = turning.map(|element| (element.dofs(), by_motion(element, gravity_m_s2, state)));
        let terms = if gravity_m_s2.norm() == 0.0 { Vec::new() } else { terms.collect() };
        DeadChange { terms, forces: self.load_forces(state, loads) }
    }
}

/// Whether the weight of an element hangs on its attitude: not if it is forces at the nodes, the same along all axes.
fn turns(element: &Corotated, mass: &DMatrix<f64>) -> bool {
    let uniform =
        DMatrix::from_fn(mass.nrows(), 3, |i, axis| f64::from(u8::from(i % element.per_node == axis)));
    let felt = mass * uniform;
    let least = ROUND_OFF * mass.amax();
    (0..felt.nrows()).step_by(3).any(|at| {
        let block: Matrix3<f64> = felt.fixed_view::<3, 3>(at, 0).into_owned();
        let same =
            if at % element.per_node == 0 { Matrix3::identity() * block[(0, 0)] } else { Matrix3::zeros() };
        (block - same).amax() > least
    })
}

/// Change of an element's weight by the motion of its nodes.
fn by_motion(element: &Corotated, gravity_m_s2: &Vector3<f64>, state: &State) -> DMatrix<f64> {
    let (alone, mass) = (element.alone(), element.mass.as_ref().expect("it is massive"));
    let own = State {
        places: element.nodes.iter().map(|node| state.places[*node]).collect(),
        rotations: element.nodes.iter().map(|node| state.rotations[*node]).collect(),
    };
    let (size, each) = (mass.nrows(), element.per_node);
    let pull = DVector::from_fn(size, |i, _| if i % each < 3 { gravity_m_s2[i % each] } else { 0.0 });
    let column = |at: usize| {
        let mut unit = vec![0.0; 6 * element.nodes.len()];
        unit[6 * (at / each) + at % each] = 1.0;
        differenced(&unit, |motion| (alone.turned(mass, &own.moved_by(motion)) * &pull).as_slice().to_vec())
    };
    let columns: Vec<Vec<f64>> = (0..size).map(column).collect();
    DMatrix::from_fn(size, size, |i, j| columns[j][i])
}
