//! Natural modes: K x = omega^2 M x, proven complete by a pivot count.
//!
//! A few modes of a large structure by block Lanczos (`lanczos.rs`), many of a small one by Jacobi rotations (`jacobi.rs`); else
//! by Bathe's subspace iteration (*Finite Element Procedures*, ch. 11), each sweep over a short block Krylov space (`subspace.rs`). The start has no symmetry: fixed noise, or
//! the motions of least stiffness that the factor found from it. A structure that can move freely is held where its rigid motions
//! move, which does nothing to loads without a resultant, and everything is kept orthogonal to those motions; should that not
//! converge, it is factorised as K + s M, where s goes down to the first elastic eigenvalue as soon as that shows. After convergence
//! the number of eigenvalues below a shift just above the last mode ([`crate::sturm`]) must be the number found; if not, the
//! search goes on for more. A single-vector method would miss the copies of repeated frequencies (two equal wings) without
//! noticing.
//!
//! Motions without mass have no frequency and are not counted among the modes.

mod error;
mod way;

pub use error::ModesError;

use crate::blocks::Noise;
use crate::factor::{Factor, Room};
use crate::flexibility::SingularStructure;
use crate::jacobi;
use crate::lanczos::{self, Asked};
use crate::sparse;
use crate::sturm;
use crate::subspace::{self, Inverse, Rigid, Ritz};
use crate::system::System;
use faer::sparse::SparseColMatRef;
use faer::{Mat, MatRef};
use nalgebra::Point3;
use way::Way;

/// Residual at which a mode is converged; its eigenvalue's relative error is about the square of it, or round-off.
const CONVERGED: f64 = 1e-9;

/// The same for structures of more than [`LARGE`] motions, whose round-off does not allow much less: eigenvalues have twelve digits, and the
/// step after it ([`subspace::refined`]) takes more off shapes.
const CONVERGED_LARGE: f64 = 1e-6;

/// Number of motions of a large structure.
const LARGE: usize = 3000;

/// Residual that is accepted when round-off prevents a smaller one (a thousand elements in a row): frequencies are
/// then good to about six digits.
const STAGNANT: f64 = 1e-3;

/// Sweeps with one block size.
const SWEEPS: usize = 200;

/// A mode of a free-free structure is rigid if its eigenvalue is below this share of the first elastic one. Generous,
/// since the number of rigid motions is known from the pivots: with many elements the round-off of the
/// stiffest motions is all that is left of a rigid one's stiffness.
const RIGID: f64 = 1e-3;

/// Natural modes in ascending frequency.
#[derive(Debug, Clone)]
pub struct Modes {
    /// Natural frequencies, rad/s. Exactly zero for a rigid motion: at most as many as the stiffness has zero
    /// pivots, if the computed eigenvalue is less than a thousandth of the first elastic one.
    pub omega_rad_s: Vec<f64>,
    /// Shapes, f-set x modes: X^T M X = E. The largest displacement along z is positive; of a mode that hardly
    /// moves along z, the largest component.
    pub shapes: Mat<f64>,
}

/// The `count` lowest natural modes.
///
/// # Errors
/// If there are not so many, a motion has neither stiffness nor mass, or the completeness cannot be shown.
pub fn normal_modes(system: &System, count: usize) -> Result<Modes, ModesError> {
    let n = system.free_count();
    if count > n {
        return Err(ModesError::TooMany { asked: count, available: n });
    }
    if count == 0 {
        return Ok(Modes { omega_rad_s: Vec::new(), shapes: Mat::zeros(n, 0) });
    }
    found(system, held(system), count, None)
}

/// The natural modes below a frequency, at least `least` of them: as [`normal_modes`] of as many as
/// [`crate::count_below`] finds, with one factorisation less.
///
/// # Errors
/// As [`normal_modes`].
pub fn normal_modes_below(system: &System, omega_rad_s: f64, least: usize) -> Result<Modes, ModesError> {
    // Before both sides of the join ask for it.
    system.analysis();
    let (counted, factor) = rayon::join(|| sturm::count_below(system, omega_rad_s), || held(system));
    let counted = counted?;
    if counted < least.max(1) {
        return normal_modes(system, least);
    }
    found(system, factor, counted, Some(Count { square: omega_rad_s * omega_rad_s, below: counted }))
}

/// How many eigenvalues lie below one, as the pivots say.
#[derive(Debug, Clone, Copy)]
struct Count {
    square: f64,
    below: usize,
}

/// The stiffness, held by springs at motions that have none; the rigid motions of the whole are tried before others are searched for.
fn held(system: &System) -> Factor {
    let rigid = system.rigid_body(&system.points().first().copied().unwrap_or_else(Point3::origin));
    let free = system.free_dofs();
    let expected = Mat::from_fn(free.len(), 6, |i, j| rigid[(free[i], j)]);
    Factor::held_expecting(system.analysis(), system.stiffness(), &expected)
}

/// Modes from the held stiffness; where rounding leaves open which motions have no stiffness, from a shifted one.
fn found(system: &System, factor: Factor, count: usize, known: Option<Count>) -> Result<Modes, ModesError> {
    let rigid = factor.loose.len();
    let mass = system.mass();
    let Some(motions) = Rigid::of(mass, &factor) else {
        let shift = first_shift(system);
        return Search::new(system, mass, count, known, rigid, shift, shifted(system, shift)?).run();
    };
    match (Search { motions, ..Search::new(system, mass, count, known, rigid, 0.0, factor) }).run() {
        Err(error) if rigid > 0 => {
            tracing::debug!(%error, "modes of a free-free structure with a shift");
            let shift = first_shift(system);
            Search::new(system, mass, count, known, rigid, shift, shifted(system, shift)?).run()
        }
        done => done,
    }
}

struct Search<'a> {
    system: &'a System,
    /// Its mass without zeros.
    mass: SparseColMatRef<'a, usize, f64>,
    count: usize,
    /// A count of eigenvalues that is there already.
    known: Option<Count>,
    /// Number of motions without stiffness.
    rigid: usize,
    /// What they are, if springs hold them and not a shift.
    motions: Rigid,
    shift: f64,
    /// None while it is not needed, since a count has one of its own.
    factor: Option<Factor>,
    way: Way,
    noise: Noise,
    /// What sweeps start from.
    block: Mat<f64>,
    ritz: Ritz,
    /// True if every motion with mass was looked at.
    is_exhausted: bool,
}

impl<'a> Search<'a> {
    fn new(
        system: &'a System,
        mass: SparseColMatRef<'a, usize, f64>,
        count: usize,
        known: Option<Count>,
        rigid: usize,
        shift: f64,
        factor: Factor,
    ) -> Self {
        let n = system.free_count();
        let way = Way::of(n, count, shift, factor.loose.is_empty());
        let size = (2 * count.max(rigid)).min(count.max(rigid) + 8).min(n);
        let mut noise = Noise::new();
        let block = noise.extend(Mat::zeros(n, 0).as_ref(), if way == Way::Lanczos { 0 } else { size });
        Self {
            system,
            mass,
            count,
            known,
            rigid,
            motions: Rigid::none(n),
            shift,
            factor: Some(factor),
            way,
            noise,
            block,
            ritz: Ritz { values: Vec::new(), vectors: Mat::zeros(n, 0) },
            is_exhausted: false,
        }
    }

    fn run(mut self) -> Result<Modes, ModesError> {
        let mut asked = self.count;
        loop {
            let factor = match self.factor.take() {
                Some(factor) => factor,
                None if self.shift > 0.0 => shifted(self.system, self.shift)?,
                None => held(self.system),
            };
            let mut room = Room::default();
            match self.way {
                Way::Lanczos => {
                    self.by_lanczos(&factor, asked)?;
                    // The count has one of its own.
                    room = factor.into_room();
                }
                Way::Rotations => self.by_rotations(factor)?,
                Way::Sweeps => self.by_sweeps(factor)?,
            }
            match self.check(room)? {
                None => return Ok(self.modes()),
                Some(difference) if self.is_exhausted => return Err(difference),
                Some(_) => {}
            }
            if self.way == Way::Lanczos {
                asked += (asked / 2).max(4);
            } else {
                let size = self.block.ncols();
                let more = (size / 2).max(4).min(self.system.free_count() - size);
                self.block = self.noise.extend(self.block.as_ref(), more);
            }
            tracing::debug!(asked, size = self.block.ncols(), "the count of eigenvalues asks for more");
        }
    }

    fn inverse<'f>(&'f self, factor: &'f Factor) -> Inverse<'f> {
        Inverse { factor, shift: self.shift, rigid: &self.motions }
    }

    /// The `asked` lowest modes beside those that are there already.
    fn by_lanczos(&mut self, factor: &Factor, asked: usize) -> Result<(), ModesError> {
        let not_converged = |residual| ModesError::NotConverged { asked: self.count, residual };
        let first = self.motions.count();
        let known = self.ritz.after(first);
        let asked = Asked { elastic: asked.max(first + 1) - first, miss: CONVERGED_LARGE, known: &known };
        let inverse = Inverse { factor, shift: self.shift, rigid: &self.motions };
        let found = lanczos::lowest(self.mass, &inverse, &mut self.noise, asked)
            .ok_or_else(|| not_converged(f64::INFINITY))?;
        let available = found.ritz.values.len();
        if available < self.count && found.is_complete {
            return Err(ModesError::TooMany { asked: self.count, available });
        }
        (self.ritz, self.is_exhausted) = (found.ritz, found.is_complete);
        // Rigid motions alone are exact.
        if available > first {
            let (refined, misses) = subspace::refined(self.mass, &inverse, &self.ritz, available)
                .ok_or_else(|| not_converged(f64::INFINITY))?;
            let worst = misses.into_iter().take(self.count.saturating_sub(first)).fold(0.0, f64::max);
            if worst > STAGNANT || available < self.count {
                return Err(not_converged(worst));
            }
            self.ritz = refined;
        }
        Ok(())
    }

    /// All modes, of the shifted stiffness where there is a shift; one that is not positive, if only by rounding, is left to sweeps.
    fn by_rotations(&mut self, factor: Factor) -> Result<(), ModesError> {
        let k = self.system.stiffness();
        let shifted = sparse::combine(k, self.shift, self.system.mass());
        let Some(mut all) = jacobi::all_modes(SparseColMatRef::new(k.symbolic(), &shifted), self.mass) else {
            return self.by_sweeps(factor);
        };
        all.values.iter_mut().for_each(|value| *value -= self.shift);
        let available = all.values.len();
        if available < self.count {
            return Err(ModesError::TooMany { asked: self.count, available });
        }
        (self.ritz, self.is_exhausted) = (all, true);
        Ok(())
    }

    fn by_sweeps(&mut self, mut factor: Factor) -> Result<(), ModesError> {
        let (k, m) = (self.system.stiffness(), self.mass);
        let enough = if self.system.free_count() > LARGE { CONVERGED_LARGE } else { CONVERGED };
        let mut worst = f64::INFINITY;
        let mut best = f64::INFINITY;
        let mut idle = 0;
        let mut x = self.block.clone();
        for _ in 0..SWEEPS {
            self.ritz = subspace::sweep(k, m, &self.inverse(&factor), x.as_ref())
                .ok_or(ModesError::NotConverged { asked: self.count, residual: worst })?;
            let available = self.ritz.values.len();
            if available < self.count {
                return Err(ModesError::TooMany { asked: self.count, available });
            }
            let kept = self.block.ncols().min(available);
            x = self.ritz.vectors.subcols(0, kept).to_owned();
            if self.lowers_shift() {
                factor = shifted(self.system, self.shift)?;
                continue;
            }
            let residuals = subspace::residuals(m, &self.inverse(&factor), &self.ritz, self.count);
            worst = residuals.into_iter().fold(0.0, f64::max);
            idle = if worst < 0.5 * best { 0 } else { idle + 1 };
            best = best.min(worst);
            if worst < enough || (worst < STAGNANT && idle > 8) {
                self.block = self.keep_size(x.as_ref());
                self.is_exhausted = available < self.block.ncols() || self.block.ncols() >= x.nrows();
                if let Some((refined, _)) = subspace::refined(m, &self.inverse(&factor), &self.ritz, kept) {
                    self.ritz = refined;
                }
                return Ok(());
            }
        }
        Err(ModesError::NotConverged { asked: self.count, residual: worst })
    }

    /// The vectors found, filled with zeros to the block's size so that more columns come after it.
    fn keep_size(&self, x: MatRef<'_, f64>) -> Mat<f64> {
        Mat::from_fn(x.nrows(), self.block.ncols(), |i, j| if j < x.ncols() { x[(i, j)] } else { 0.0 })
    }

    /// Brings the shift of a free-free structure down to its first elastic eigenvalue; true if that asks for another factor.
    fn lowers_shift(&mut self) -> bool {
        let first = self.ritz.values.get(self.rigid).copied();
        let lower = first.filter(|first| *first > 0.0 && *first <= 0.1 * self.shift);
        self.shift = lower.unwrap_or(self.shift);
        lower.is_some()
    }

    /// Compares the modes found with the count of eigenvalues that is known, or else just above the last one.
    fn check(&self, room: Room) -> Result<Option<ModesError>, ModesError> {
        let below = |square: f64| self.ritz.values.iter().filter(|value| **value < square).count();
        if self.known.is_some_and(|known| known.below == self.count && below(known.square) == known.below) {
            return Ok(None);
        }
        let last = self.ritz.values[self.count - 1];
        let rigid_below = match self.shift {
            0.0 if self.rigid > 0 => RIGID * self.first_elastic(),
            shift => 1e-3 * shift,
        };
        // A nearby frequency that belongs to a pair shall be on the same side, the nudged shift included.
        let above = (last * (1.0 + 1e-5)).max(rigid_below);
        let counted = sturm::count_below_square(self.system, above, room)?;
        let found = below(above);
        let difference = ModesError::Incomplete { found, counted, omega_rad_s: above.sqrt() };
        Ok((found != counted).then_some(difference))
    }

    /// The first elastic eigenvalue; of a structure without any, something small.
    fn first_elastic(&self) -> f64 {
        let found = self.ritz.values.get(self.rigid).copied().filter(|value| *value > 0.0);
        found.unwrap_or_else(|| first_shift(self.system))
    }

    fn modes(&self) -> Modes {
        let elastic = self.first_elastic();
        let omega = |at: usize| {
            let value = self.ritz.values[at];
            if at < self.rigid && value < RIGID * elastic { 0.0 } else { value.max(0.0).sqrt() }
        };
        let omega_rad_s = (0..self.count).map(omega).collect();
        let mut shapes = self.ritz.vectors.subcols(0, self.count).to_owned();
        for j in 0..self.count {
            if sign_component(self.system, shapes.subcols(j, 1)) < 0.0 {
                for i in 0..shapes.nrows() {
                    shapes[(i, j)] = -shapes[(i, j)];
                }
            }
        }
        Modes { omega_rad_s, shapes }
    }
}

/// A start for the shift of a free-free structure: a millionth of the smallest ratio of stiffness to mass.
fn first_shift(system: &System) -> f64 {
    let (k, m) = (sparse::diagonal(system.stiffness()), sparse::diagonal(system.mass()));
    let ratios = k.iter().zip(&m).filter(|(k, m)| **k > 0.0 && **m > 0.0).map(|(k, m)| k / m);
    let least = ratios.fold(f64::INFINITY, f64::min);
    if least.is_finite() { 1e-6 * least } else { 1.0 }
}

fn shifted(system: &System, shift: f64) -> Result<Factor, ModesError> {
    let k = system.stiffness();
    let values = sparse::combine(k, shift, system.mass());
    let factor = Factor::held(system.analysis(), SparseColMatRef::new(k.symbolic(), &values));
    if factor.loose.is_empty() {
        return Ok(factor);
    }
    Err(ModesError::Massless(SingularStructure::at(system, &factor.loose)))
}

/// The component that must be positive. Of equally large ones (a mirror image) the first is taken.
fn sign_component(system: &System, shape: MatRef<'_, f64>) -> f64 {
    let motion = system.expand(shape);
    let largest = |components: &[usize]| {
        let values = || (0..motion.nrows()).filter(|i| components.contains(&(i % 6))).map(|i| motion[(i, 0)]);
        let size = values().map(f64::abs).fold(0.0, f64::max);
        values().find(|value| value.abs() >= (1.0 - 1e-6) * size).unwrap_or(0.0)
    };
    let (z, displacement) = (largest(&[2]), largest(&[0, 1, 2]));
    if z.abs() > 1e-6 * displacement.abs() {
        z
    } else if displacement == 0.0 {
        largest(&[3, 4, 5])
    } else {
        displacement
    }
}

#[cfg(test)]
mod tests;
