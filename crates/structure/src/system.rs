//! The assembled structure: sparse stiffness and mass, and the way between all motions and the free ones.

use crate::assemble::{self, Assembled, Free};
use crate::autospc;
use crate::dofs::{DofMap, Sets};
use crate::factor::{self, Analysis};
use crate::model::Model;
use crate::sparse::{self, Lower, Pattern, Sparse};
use faer::sparse::SparseColMatRef;
use faer::{Mat, MatRef};
use nalgebra::{DMatrix, Point3};
use nastran::InputError;
use std::sync::{Arc, OnceLock};

/// An assembled structure.
///
/// The g-set has six degrees of freedom a node (three displacements in m, three rotations in rad, basic axes),
/// nodes in the order of [`System::node_ids`]: degree of freedom 6 * node + component - 1. The f-set are the free
/// ones; `u_g` = T `u_f`.
#[derive(Debug, Clone)]
pub struct System {
    ids: Vec<u32>,
    points: Vec<Point3<f64>>,
    /// Scalar points, which no rigid motion of the whole moves.
    scalar: Vec<usize>,
    dofs: DofMap,
    k_gg: Arc<Lower>,
    m_gg: Arc<Sparse>,
    k_ff: Sparse,
    m_ff: Sparse,
    /// Nodes whose displacements no element touches.
    unattached: Vec<usize>,
    /// Motions held because they have no stiffness.
    auto_held: Vec<(u32, u8)>,
    /// Made when something is factorised for the first time.
    analysis: OnceLock<Arc<Analysis>>,
}

impl System {
    /// Assembles a model.
    ///
    /// Motions that no element has stiffness or mass for (rotations at a solid's nodes, grids nothing is attached
    /// to) are held.
    ///
    /// # Errors
    /// If rigid links contradict each other, form a circle, or a dependent motion is clamped; if a mass or stiffness
    /// is beyond floating-point numbers.
    pub fn assemble(model: &Model) -> Result<Self, InputError> {
        Self::assemble_scaled(model, |_| [1.0, 1.0])
    }

    /// As [`System::assemble`], stiffness and mass of each element (by its place in [`Model::elements`]) multiplied by
    /// the two factors.
    ///
    /// # Errors
    /// As [`System::assemble`].
    pub fn assemble_scaled(
        model: &Model,
        factors: impl Fn(usize) -> [f64; 2] + Sync,
    ) -> Result<Self, InputError> {
        let (sets, touched) = Sets::of_touched(model)?;
        let unattached: Vec<usize> =
            (0..model.nodes.len()).filter(|node| touched[6 * node..6 * node + 3] == [false; 3]).collect();
        let dofs = sets.map();
        let Assembled { k_gg, m_gg, k_ff, m_ff } = assemble::assembled(model, &dofs, factors);
        let ids = model.nodes.iter().map(|node| node.id).collect();
        let points = model.nodes.iter().map(|node| node.point).collect();
        let scalar = (0..model.nodes.len()).filter(|node| model.nodes[*node].is_scalar).collect();
        let (k_gg, m_gg) = (Arc::new(k_gg), Arc::new(m_gg));
        let system = Self {
            ids,
            points,
            scalar,
            dofs,
            k_gg,
            m_gg,
            k_ff,
            m_ff,
            unattached,
            auto_held: Vec::new(),
            analysis: OnceLock::new(),
        };
        tracing::debug!(
            nodes = system.ids.len(),
            free = system.free_count(),
            entries = system.k_ff.val().len(),
            "assembled"
        );
        if !system.is_finite() {
            let message = "the stiffness or mass of the structure is beyond floating-point numbers";
            let help = "look for an offset, mass or coordinate many orders of magnitude off";
            return Err(InputError::general(message).with_help(help));
        }
        Ok(if model.holds_loose { system.without_loose() } else { system })
    }

    /// With the motions held that have no stiffness at their grid.
    fn without_loose(self) -> Self {
        let loose = autospc::without_stiffness(&self.k_ff, &self.dofs.free);
        if loose.is_empty() {
            return self;
        }
        let kept: Vec<usize> = (0..self.free_count()).filter(|at| loose.binary_search(at).is_err()).collect();
        let auto_held = loose.iter().map(|at| self.name(*at)).collect();
        Self { auto_held, ..self.restricted(&kept) }
    }

    /// A structure given by its matrices: nodes `ids` in ascending order at `points`, g-set stiffness and mass
    /// (6 n x 6 n; their lower triangles are read), and the clamped degrees of freedom.
    ///
    /// # Panics
    /// If the sizes do not belong together, a clamped degree of freedom is not below 6 n, or an entry is not finite.
    pub fn from_matrices(
        ids: Vec<u32>,
        points: Vec<Point3<f64>>,
        k_gg: MatRef<'_, f64>,
        m_gg: MatRef<'_, f64>,
        clamped: &[usize],
    ) -> Self {
        let n = 6 * ids.len();
        assert_eq!(points.len(), ids.len(), "one point a node");
        assert_eq!((k_gg.nrows(), k_gg.ncols()), (n, n), "six degrees of freedom a node");
        assert_eq!((m_gg.nrows(), m_gg.ncols()), (n, n), "six degrees of freedom a node");
        let mut is_clamped = vec![false; n];
        for dof in clamped {
            is_clamped[*dof] = true;
        }
        let dofs = Sets::clamped(is_clamped).map();
        let sum = |at: &[usize]| {
            let entry = |i: usize, j: usize| [k_gg[(at[i], at[j])], m_gg[(at[i], at[j])]];
            let below = (0..at.len()).flat_map(|j| (j..at.len()).map(move |i| (i, j)));
            let filled: Vec<Vec<usize>> =
                below.filter(|(i, j)| entry(*i, *j) != [0.0; 2]).map(|(i, j)| vec![j, i]).collect();
            let mut values = Pattern::of(at.len(), &filled).values();
            for pair in &filled {
                values.add_entry(pair[1], pair[0], entry(pair[1], pair[0]));
            }
            values.lower()
        };
        let all: Vec<usize> = (0..n).collect();
        let ((k_gg, m_gg), (k_ff, m_ff)) = (sum(&all), sum(&dofs.free));
        let parts = [k_ff.symmetric(), m_ff.symmetric()];
        let system = Self::of_parts(ids, points, dofs, (k_gg, m_gg.symmetric()), parts);
        assert!(system.is_finite(), "stiffness and mass are finite numbers");
        system
    }

    /// Of stiffness and mass that are summed already, of all motions and of the free ones.
    pub(crate) fn of_parts(
        ids: Vec<u32>,
        points: Vec<Point3<f64>>,
        dofs: DofMap,
        (k_gg, m_gg): (Lower, Sparse),
        [k_ff, m_ff]: [Sparse; 2],
    ) -> Self {
        let (k_gg, m_gg) = (Arc::new(k_gg), Arc::new(m_gg));
        Self {
            ids,
            points,
            scalar: Vec::new(),
            dofs,
            k_gg,
            m_gg,
            k_ff,
            m_ff,
            unattached: Vec::new(),
            auto_held: Vec::new(),
            analysis: OnceLock::new(),
        }
    }

    /// The same structure with `change` added to the mass of some motions of the g-set (symmetric, kg and kg m²); `None` if these are not
    /// joined by any element so far.
    ///
    /// # Panics
    /// If there are not as many rows as motions.
    pub fn with_mass_change(&self, dofs: &[usize], change: &DMatrix<f64>) -> Option<Self> {
        assert_eq!(change.nrows(), dofs.len(), "one row a motion");
        let m_gg = sparse::with_sum(&self.m_gg, dofs, change, |i, j| self.k_gg.has(i, j))?;
        let joined = |i: usize, j: usize| sparse::has(&self.k_ff, i, j);
        let m_ff = match assemble::free_motions(dofs, &self.dofs) {
            Free::Combined { dofs, t } => {
                sparse::with_sum(&self.m_ff, &dofs, &(t.transpose() * change * t), joined)?
            }
            Free::Places(places) => {
                let free: Vec<usize> = (0..dofs.len()).filter(|at| places[*at].is_some()).collect();
                let own = change.select_rows(&free).select_columns(&free);
                let places: Vec<usize> = places.into_iter().flatten().collect();
                sparse::with_sum(&self.m_ff, &places, &own, joined)?
            }
        };
        Some(Self { m_gg: Arc::new(m_gg), m_ff, ..self.clone() })
    }

    /// The same structure with all motions of a node that are free clamped, as an SPC1 card for them would.
    ///
    /// # Panics
    /// If there is no such node.
    #[must_use]
    pub fn clamped_at(&self, node: usize) -> Self {
        assert!(node < self.ids.len(), "the structure has the node");
        let kept: Vec<usize> = (0..self.free_count()).filter(|at| self.dofs.free[*at] / 6 != node).collect();
        self.restricted(&kept)
    }

    /// The same structure with only some of its free motions, ascending.
    pub(crate) fn restricted(&self, kept: &[usize]) -> Self {
        let mut place = vec![None; self.free_count()];
        kept.iter().enumerate().for_each(|(new, old)| place[*old] = Some(new));
        let row = |row: &Vec<(usize, f64)>| {
            row.iter().filter_map(|(at, factor)| place[*at].map(|at| (at, *factor))).collect()
        };
        let dofs = DofMap {
            free: kept.iter().map(|at| self.dofs.free[*at]).collect(),
            rows: self.dofs.rows.iter().map(row).collect(),
        };
        let block = |a: &Sparse| sparse::block(a.as_ref(), kept);
        self.with_free(dofs, [block(&self.k_ff), block(&self.m_ff)])
    }

    /// The same structure with other free motions, and stiffness and mass of these.
    pub(crate) fn with_free(&self, dofs: DofMap, [k_ff, m_ff]: [Sparse; 2]) -> Self {
        Self {
            ids: self.ids.clone(),
            points: self.points.clone(),
            scalar: self.scalar.clone(),
            dofs,
            k_gg: Arc::clone(&self.k_gg),
            m_gg: Arc::clone(&self.m_gg),
            k_ff,
            m_ff,
            unattached: self.unattached.clone(),
            auto_held: self.auto_held.clone(),
            analysis: OnceLock::new(),
        }
    }

    /// The free motions and how all others follow them.
    pub(crate) fn motions(&self) -> &DofMap {
        &self.dofs
    }

    fn is_finite(&self) -> bool {
        [self.k_gg.values(), self.m_gg.val(), self.k_ff.val(), self.m_ff.val()]
            .iter()
            .all(|values| values.iter().all(|v| v.is_finite()))
    }

    /// Number of nodes.
    pub fn node_count(&self) -> usize {
        self.ids.len()
    }

    /// Number of free degrees of freedom.
    pub fn free_count(&self) -> usize {
        self.dofs.free.len()
    }

    /// Grid numbers, ascending.
    pub fn node_ids(&self) -> &[u32] {
        &self.ids
    }

    /// Position of a grid among the nodes.
    pub fn node_index(&self, id: u32) -> Option<usize> {
        self.ids.binary_search(&id).ok()
    }

    /// Whether an element holds a node, or it follows others; a load on a node that nothing holds has no effect.
    pub fn is_attached(&self, node: usize) -> bool {
        self.unattached.binary_search(&node).is_err()
    }

    /// Grid and component of the motions that were held because they have no stiffness at their grid (AUTOSPC).
    pub fn auto_held(&self) -> &[(u32, u8)] {
        &self.auto_held
    }

    /// Places of the nodes in the basic system, m.
    pub fn points(&self) -> &[Point3<f64>] {
        &self.points
    }

    /// Position in the g-set of each free degree of freedom, ascending.
    pub fn free_dofs(&self) -> &[usize] {
        &self.dofs.free
    }

    /// Grid and component (1 to 6) of a free degree of freedom.
    pub fn name(&self, free: usize) -> (u32, u8) {
        let dof = self.dofs.free[free];
        (self.ids[dof / 6], [1, 2, 3, 4, 5, 6][dof % 6])
    }

    /// `u_g` = T `u_f`, column by column.
    pub fn expand(&self, u_f: MatRef<'_, f64>) -> Mat<f64> {
        let row = |i: usize, j: usize| self.dofs.rows[i].iter().map(|(at, f)| f * u_f[(*at, j)]).sum();
        Mat::from_fn(self.dofs.rows.len(), u_f.ncols(), row)
    }

    /// The rows `dofs` of [`System::expand`].
    pub fn expand_at(&self, u_f: MatRef<'_, f64>, dofs: &[usize]) -> Mat<f64> {
        let row = |i: usize, j: usize| self.dofs.rows[dofs[i]].iter().map(|(at, f)| f * u_f[(*at, j)]).sum();
        Mat::from_fn(dofs.len(), u_f.ncols(), row)
    }

    /// Loads of one on single degrees of freedom of the g-set, a column each: `f_f` as of [`System::reduce`].
    pub fn reduce_units(&self, dofs: &[usize]) -> Mat<f64> {
        let mut reduced = Mat::zeros(self.free_count(), dofs.len());
        for (j, dof) in dofs.iter().enumerate() {
            for (at, factor) in &self.dofs.rows[*dof] {
                reduced[(*at, j)] += factor;
            }
        }
        reduced
    }

    /// `f_f` = T^T `f_g`, column by column: loads on clamped motions go to the ground.
    pub fn reduce(&self, f_g: MatRef<'_, f64>) -> Mat<f64> {
        let mut reduced = Mat::zeros(self.free_count(), f_g.ncols());
        for j in 0..f_g.ncols() {
            for (i, row) in self.dofs.rows.iter().enumerate() {
                for (at, factor) in row {
                    reduced[(*at, j)] += factor * f_g[(i, j)];
                }
            }
        }
        reduced
    }

    /// `M_gg` a: the forces (N, Nm) that accelerate the masses by `acc_g` (m/s^2, rad/s^2), g-set.
    pub fn inertia_loads(&self, acc_g: MatRef<'_, f64>) -> Mat<f64> {
        sparse::multiply((*self.m_gg).as_ref(), acc_g)
    }

    /// `K_gg` u: the forces (N, Nm) that hold the shape `u_g`, g-set; minus the applied loads these are the
    /// reactions at the clamps.
    pub fn elastic_loads(&self, u_g: MatRef<'_, f64>) -> Mat<f64> {
        self.k_gg.multiply(u_g)
    }

    /// Stiffness of the f-set.
    pub fn stiffness(&self) -> SparseColMatRef<'_, usize, f64> {
        self.k_ff.as_ref()
    }

    /// Mass of the f-set; the stiffness has an entry, if only of zero, where it has one.
    pub fn mass(&self) -> SparseColMatRef<'_, usize, f64> {
        self.m_ff.as_ref()
    }

    /// The pattern of the factor of stiffness, mass and their combinations.
    pub(crate) fn analysis(&self) -> &Arc<Analysis> {
        self.analysis.get_or_init(|| Arc::new(factor::analysed(self.k_ff.symbolic())))
    }

    /// The six rigid motions about a point, g-set x 6: unit displacements along x, y, z, unit rotations about them.
    pub fn rigid_body(&self, about: &Point3<f64>) -> Mat<f64> {
        let mut rigid = Mat::zeros(6 * self.points.len(), 6);
        for (node, point) in self.points.iter().enumerate() {
            let arm = point - about;
            for axis in 0..3 {
                let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
                rigid[(6 * node + axis, axis)] = 1.0;
                rigid[(6 * node + 3 + axis, 3 + axis)] = 1.0;
                rigid[(6 * node + next, 3 + axis)] = -arm[last];
                rigid[(6 * node + last, 3 + axis)] = arm[next];
            }
        }
        for node in &self.scalar {
            (0..36).for_each(|at| rigid[(6 * node + at / 6, at % 6)] = 0.0);
        }
        rigid
    }
}
