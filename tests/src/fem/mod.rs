//! Meshes of mapped quadrilaterals as bulk data, solved: what the published cases of finite elements are made with.

#![expect(
    clippy::missing_panics_doc,
    reason = "a case that cannot be solved is the case's own fault; the registry turns the panic into words"
)]

pub mod plies;
pub mod solid_mesh;

use faer::Mat;
use nalgebra::Point3;
use nastran::{
    BulkData, CornerThickness, Expansion, Grid, Mat1, MaterialDirection, Pshell, ShellElement, Span, Spc1,
};
use structure::{Flexibility, Model, ShearModel, Shell, ShellSection, System, normal_modes};

/// Where the cards come from, for messages.
pub fn span() -> Span {
    Span::generated("published case")
}

/// An isotropic shell.
#[derive(Debug, Clone, Copy)]
pub struct Isotropic {
    /// Young's modulus.
    pub e: f64,
    /// Poisson's ratio.
    pub nu: f64,
    /// Density.
    pub rho: f64,
    /// Thickness.
    pub t: f64,
}

impl Isotropic {
    /// Bending stiffness E t^3 / 12 (1 - nu^2).
    pub fn rigidity(&self) -> f64 {
        self.e * self.t.powi(3) / (12.0 * (1.0 - self.nu * self.nu))
    }
}

/// A mesh of `nx` by `ny` quadrilaterals over the unit square, mapped.
#[derive(Debug, Clone)]
pub struct Mesh {
    /// Cards; shells are of property 1.
    pub bulk: BulkData,
    /// Quadrilaterals along the first coordinate.
    pub nx: usize,
    /// Quadrilaterals along the second.
    pub ny: usize,
    /// Whether it is a user's deck, read as Nastran does ([`Model::from_deck`]).
    pub as_deck: bool,
}

impl Mesh {
    /// Nodes at `map(s, t)`, s and t from 0 to 1.
    pub fn mapped(nx: usize, ny: usize, map: impl Fn(f64, f64) -> [f64; 3]) -> Self {
        let mut mesh = Self { bulk: BulkData::default(), nx, ny, as_deck: false };
        for i in 0..=nx {
            for j in 0..=ny {
                mesh.add_grid(mesh.id(i, j), map(i as f64 / nx as f64, j as f64 / ny as f64));
            }
        }
        for i in 0..nx {
            for j in 0..ny {
                let grids = vec![mesh.id(i, j), mesh.id(i + 1, j), mesh.id(i + 1, j + 1), mesh.id(i, j + 1)];
                mesh.add_shell(mesh.id(i, j), grids);
            }
        }
        mesh
    }

    /// As a user's deck, read as Nastran does.
    #[must_use]
    pub fn as_deck(self) -> Self {
        Self { as_deck: true, ..self }
    }

    /// Adds a grid.
    pub fn add_grid(&mut self, id: u32, xyz: [f64; 3]) {
        self.bulk.grids.insert(id, Grid { id, cp: 0, xyz: xyz.into(), cd: 0, ps: Vec::new(), span: span() });
    }

    /// Adds a quadrilateral (or triangle) of property 1.
    pub fn add_shell(&mut self, id: u32, grids: Vec<u32>) {
        let direction = MaterialDirection::AngleDeg(0.0);
        self.bulk.shells.insert(
            id,
            ShellElement {
                id,
                property: 1,
                grids,
                direction,
                is_r: false,
                offset: 0.0,
                midsides: Vec::new(),
                thickness: CornerThickness::default(),
                span: span(),
            },
        );
    }

    /// Number of the grid in column `i` and row `j`.
    pub fn id(&self, i: usize, j: usize) -> u32 {
        u32::try_from(1 + i * (self.ny + 1) + j).expect("a few thousand grids")
    }

    /// Property 1 as a plate of one material.
    #[must_use]
    pub fn of(mut self, plate: Isotropic) -> Self {
        let Isotropic { e, nu, rho, t } = plate;
        let g = e / (2.0 * (1.0 + nu));
        self.bulk
            .materials
            .insert(1, Mat1 { id: 1, e, g, nu, rho, expansion: Expansion::default(), span: span() });
        let section = Pshell {
            id: 1,
            membrane: Some(1),
            thickness: t,
            bending: Some(1),
            bending_ratio: 1.0,
            shear: Some(1),
            shear_ratio: 5.0 / 6.0,
            nsm: 0.0,
            coupling: None,
            span: span(),
        };
        self.bulk.shell_properties.insert(1, section);
        self
    }

    /// Clamps components (digits) of the grids for which `chosen(i, j)` holds.
    #[must_use]
    pub fn clamped(mut self, components: &[u8], chosen: impl Fn(usize, usize) -> bool) -> Self {
        let mut grids = Vec::new();
        for i in 0..=self.nx {
            grids.extend((0..=self.ny).filter(|j| chosen(i, *j)).map(|j| self.id(i, j)));
        }
        self.bulk.constraints.push(Spc1 {
            set: 1,
            components: components.to_vec(),
            grids,
            enforced: 0.0,
            span: span(),
        });
        self
    }

    /// A load per area along `component` as forces at the corners: a quarter of each element's load, which has its
    /// area and (for parallelograms) its moment.
    pub fn pressure(&self, component: usize, load: impl Fn(Point3<f64>) -> f64) -> Vec<(u32, usize, f64)> {
        let mut loads = Vec::new();
        for shell in self.bulk.shells.values() {
            let corners: Vec<Point3<f64>> = shell.grids.iter().map(|id| self.bulk.grids[id].xyz).collect();
            let (one, other) = (corners[2] - corners[0], corners[3] - corners[1]);
            let area = 0.5 * one.cross(&other).norm();
            let shares = shell.grids.iter().zip(&corners);
            loads.extend(shares.map(|(id, corner)| (*id, component, 0.25 * area * load(*corner))));
        }
        loads
    }

    /// Assembles.
    pub fn system(&self) -> System {
        self.system_with(ShearModel::Equilibrium)
    }

    /// Assembles with another rule for transverse shear of laminates.
    pub fn system_with(&self, shear: ShearModel) -> System {
        let model = if self.as_deck {
            Model::from_deck(&self.bulk, None)
        } else {
            Model::from_bulk_with(&self.bulk, shear)
        };
        let model = model.expect("the case describes a possible structure");
        System::assemble(&model).expect("the case can be assembled")
    }

    /// Displacements under loads (grid, component 1 to 6, value).
    pub fn solved(&self, loads: &[(u32, usize, f64)]) -> Solved {
        solve(self.system(), loads)
    }

    /// Natural frequencies, Hz.
    pub fn frequencies_hz(&self, count: usize) -> Vec<f64> {
        frequencies_hz(&self.system(), count)
    }
}

/// Natural frequencies of a system, Hz.
pub fn frequencies_hz(system: &System, count: usize) -> Vec<f64> {
    let modes = normal_modes(system, count).expect("the modes converge");
    modes.omega_rad_s.iter().map(|omega| omega / std::f64::consts::TAU).collect()
}

/// A structure with its displacements.
#[derive(Debug)]
pub struct Solved {
    /// The structure.
    pub system: System,
    /// Displacements, g-set x 1.
    pub u: Mat<f64>,
}

/// Solves a system under loads (grid, component 1 to 6, value).
pub fn solve(system: System, loads: &[(u32, usize, f64)]) -> Solved {
    let mut load = Mat::zeros(6 * system.node_count(), 1);
    for (grid, component, value) in loads {
        load[(6 * system.node_index(*grid).expect("the grid is there") + component - 1, 0)] += value;
    }
    let flexibility = Flexibility::new(&system).expect("the structure is held");
    let u = system.expand(flexibility.displacements(system.reduce(load.as_ref()).as_ref()).as_ref());
    Solved { system, u }
}

/// Solves with given motions (grid, component, value), which must be among the clamped ones.
pub fn solve_enforced(system: System, motions: &[(u32, usize, f64)]) -> Solved {
    let mut given = Mat::zeros(6 * system.node_count(), 1);
    for (grid, component, value) in motions {
        given[(6 * system.node_index(*grid).expect("the grid is there") + component - 1, 0)] = *value;
    }
    let resisted = system.elastic_loads(given.as_ref());
    let flexibility = Flexibility::new(&system).expect("the structure is held");
    let free = flexibility.displacements((-system.reduce(resisted.as_ref())).as_ref());
    let u = system.expand(free.as_ref()) + given;
    Solved { system, u }
}

impl Solved {
    /// One component (1 to 6) of a grid's displacement.
    pub fn at(&self, grid: u32, component: usize) -> f64 {
        self.u[(6 * self.system.node_index(grid).expect("the grid is there") + component - 1, 0)]
    }

    /// Strains of a quadrilateral at natural coordinates, in its axes, with its axes.
    pub fn strains(
        &self,
        mesh: &Mesh,
        element: u32,
        section: &ShellSection,
        at: [f64; 2],
    ) -> (structure::ShellStrains, Shell) {
        let card = &mesh.bulk.shells[&element];
        let points: Vec<Point3<f64>> = card.grids.iter().map(|id| mesh.bulk.grids[id].xyz).collect();
        let nodes = (0..points.len()).collect();
        let section = std::sync::Arc::new(*section);
        let shell = Shell::new(element, nodes, &points, card.offset, section, 0.0, &span());
        let shell = shell.expect("the element was assembled");
        let motions: Vec<f64> =
            card.grids.iter().flat_map(|grid| (1..=6).map(|c| self.at(*grid, c))).collect();
        (shell.strains(&motions, at), shell)
    }
}
