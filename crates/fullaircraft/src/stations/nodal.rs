//! Nodal loads of the whole structure (g-set, 6 a node: N and N m along and about the basic axes) by what they come from.

/// What nodal loads come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Component {
    /// The air's, by the splines.
    Air,
    /// Minus mass times what an accelerometer feels: rigid and elastic acceleration less gravity.
    Inertia,
    /// Thrust, at the wing's root.
    Thrust,
    /// The structure's damping: none in steady flight.
    Damping,
    /// Their sum: what bends the structure.
    Net,
}

impl Component {
    /// All of them, the sum last.
    pub const ALL: [Self; 5] = [Self::Air, Self::Inertia, Self::Thrust, Self::Damping, Self::Net];

    /// Its name in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Air => "air",
            Self::Inertia => "inertia",
            Self::Thrust => "thrust",
            Self::Damping => "structural damping",
            Self::Net => "net",
        }
    }
}

/// Nodal loads.
#[derive(Debug, Clone, PartialEq)]
pub struct NodalLoads {
    /// See [`Component::Air`].
    pub air: Vec<f64>,
    /// See [`Component::Inertia`].
    pub inertia: Vec<f64>,
    /// See [`Component::Thrust`].
    pub thrust: Vec<f64>,
    /// See [`Component::Damping`].
    pub damping: Vec<f64>,
}

impl NodalLoads {
    /// A component's.
    pub fn of(&self, component: Component) -> Vec<f64> {
        match component {
            Component::Air => self.air.clone(),
            Component::Inertia => self.inertia.clone(),
            Component::Thrust => self.thrust.clone(),
            Component::Damping => self.damping.clone(),
            Component::Net => (0..self.air.len())
                .map(|dof| self.air[dof] + self.inertia[dof] + self.thrust[dof] + self.damping[dof])
                .collect(),
        }
    }
}
