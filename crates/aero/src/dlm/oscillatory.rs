//! The oscillatory influence matrix and its factorisation.

use crate::dlm::exponentials::KernelIntegral;
use crate::dlm::halves::Halves;
use crate::dlm::increment::Increment;
use crate::dlm::kept::Kept;
use crate::dlm::numerators::Stream;
use crate::dlm::span_fit::SpanFit;
use crate::dlm::strips::Strip;
use crate::error::AeroError;
use crate::lattice::Lattice;
use crate::mirror::{MirrorPlane, silence};
use crate::vlm::{influence_of_image, influence_of_own, lost_pivot};
use faer::linalg::solvers::{PartialPivLu, Solve};
use faer::{Mat, MatRef, Scale, c64};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// How the doublets' incidence is integrated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DlmSettings {
    /// Integrals of the kernel.
    pub integral: KernelIntegral,
    /// Integral along the doublet line.
    pub fit: SpanFit,
}

impl DlmSettings {
    /// The approximations of MSC Nastran's N5KQ: with them its printed forces and roots are met more closely.
    pub const NASTRAN: Self = Self { integral: KernelIntegral::Laschka, fit: SpanFit::Parabolic };
}

/// Influences of one set of boxes on another: at rest, and what oscillation adds.
#[derive(Debug, Clone)]
struct Block {
    steady: Mat<f64>,
    increment: Increment,
}

impl Block {
    fn at(&self, stream: &Stream) -> Mat<c64> {
        let steady = self.steady.as_ref();
        let mut matrix = Mat::from_fn(steady.nrows(), steady.ncols(), |i, j| c64::from(steady[(i, j)]));
        if stream.kappa > 0.0 {
            self.increment.add_to(&mut matrix, stream);
        }
        matrix
    }
}

/// What the image is to the lattice.
#[derive(Debug, Clone)]
enum Image {
    None,
    /// The other half, with the factor of its pressures.
    Plane(Block, f64),
    /// The left half of a whole that is symmetric about y = 0.
    Left(Block, Halves),
}

/// A lattice at one Mach number, ready for any frequency.
///
/// A lattice without a plane that is its own mirror image about y = 0 (to 1e-9 of its boxes) is solved in two halves.
#[derive(Debug, Clone)]
pub struct DoubletLattice {
    own: Block,
    image: Image,
    mach: f64,
    integral: KernelIntegral,
    /// Numbers of the boxes of `own`.
    ids: Vec<u32>,
    /// Boxes that carry nothing, in the plane of symmetric flow.
    silent: Vec<usize>,
    kept: Option<Arc<Kept<OscillatoryAero>>>,
}

impl DoubletLattice {
    /// Computes what does not depend on the frequency.
    ///
    /// # Errors
    /// If the lattice is empty, meets the plane of symmetry, the Mach number is not in 0..1, or a box has no width
    /// across the stream.
    pub fn new(
        lattice: &Lattice,
        plane: MirrorPlane,
        mach: f64,
        settings: &DlmSettings,
    ) -> Result<Self, AeroError> {
        plane.check(lattice)?;
        let halves = if plane == MirrorPlane::None { Halves::find(lattice) } else { None };
        let kept = halves.as_ref().map_or_else(|| lattice.clone(), |halves| halves.kept(lattice));
        let receivers = Strip::all(&kept.boxes)?;
        let increment =
            |senders: Vec<Strip>| Increment { receivers: receivers.clone(), senders, fit: settings.fit };
        let mirrored = |y_m: f64, boxes: usize| -> Result<Block, AeroError> {
            let steady = influence_of_image(&kept, mach, y_m);
            let senders = Strip::all(&kept.mirrored(y_m).0.boxes[..boxes])?;
            Ok(Block { steady: steady.subcols(0, boxes).to_owned(), increment: increment(senders) })
        };
        let own = Block { steady: influence_of_own(&kept, mach)?, increment: increment(receivers.clone()) };
        let image = match (halves, plane.image()) {
            (Some(halves), _) => Image::Left(mirrored(0.0, halves.pairs())?, halves),
            (None, Some((y_m, sign))) => Image::Plane(mirrored(y_m, kept.len())?, sign),
            (None, None) => Image::None,
        };
        let ids = kept.boxes.iter().map(|panel| panel.id).collect();
        let silent = plane.silent(lattice);
        Ok(Self { own, image, mach, integral: settings.integral, ids, silent, kept: None })
    }

    /// The same, but what is factorised is kept for the next who asks for it, here and in copies of it: for wings that share the
    /// lattice. A quarter of a gigabyte at most.
    #[must_use]
    pub fn keeping_factors(self) -> Self {
        Self { kept: Some(Arc::new(Kept::new())), ..self }
    }

    /// The same without what was kept.
    #[must_use]
    pub fn without_kept_factors(self) -> Self {
        Self { kept: None, ..self }
    }

    /// The influence matrix A, n by n, at `omega_over_v` in 1/m: incidence `w_i` that box i needs for the pressure
    /// coefficients `cp_j`, w = A cp. At 0 it is the vortex lattice's.
    ///
    /// # Errors
    /// If the frequency is negative or not a number.
    pub fn influence(&self, omega_over_v: f64) -> Result<Mat<c64>, AeroError> {
        let stream = self.stream(omega_over_v)?;
        let own = self.own.at(&stream);
        Ok(match &self.image {
            Image::None => own,
            Image::Plane(image, sign) => {
                let mut whole = own + image.at(&stream) * Scale(c64::from(*sign));
                silence(&mut whole, &self.silent);
                whole
            }
            Image::Left(image, halves) => halves.unfolded(&own, &image.at(&stream)),
        })
    }

    /// Factorises the matrix at `omega_over_v` in 1/m.
    ///
    /// # Errors
    /// As [`DoubletLattice::influence`], and if the matrix is singular.
    pub fn at(&self, omega_over_v: f64) -> Result<Arc<OscillatoryAero>, AeroError> {
        match &self.kept {
            Some(kept) => kept.at(omega_over_v, self.factored(), || self.solved(omega_over_v)),
            None => self.solved(omega_over_v).map(Arc::new),
        }
    }

    /// How many numbers factors have.
    fn factored(&self) -> usize {
        let symmetric = if let Image::Left(_, halves) = &self.image { halves.pairs() } else { 0 };
        symmetric.pow(2) + self.ids.len().pow(2)
    }

    fn solved(&self, omega_over_v: f64) -> Result<OscillatoryAero, AeroError> {
        let Image::Left(image, halves) = &self.image else {
            let factors = self.factorised(&self.influence(omega_over_v)?)?;
            return Ok(OscillatoryAero { factors: Factors::Whole(factors, self.silent.clone()) });
        };
        let stream = self.stream(omega_over_v)?;
        let (mut own, image) = (self.own.at(&stream), image.at(&stream));
        let pairs = halves.pairs();
        let symmetric = own.submatrix(0, 0, pairs, pairs) + image.submatrix(0, 0, pairs, pairs);
        let symmetric = self.factorised(&symmetric)?;
        let mut between_pairs = own.subcols_mut(0, pairs);
        between_pairs -= &image;
        let antisymmetric = self.factorised(&own)?;
        Ok(OscillatoryAero { factors: Factors::Halves([symmetric, antisymmetric], halves.clone()) })
    }

    fn stream(&self, omega_over_v: f64) -> Result<Stream, AeroError> {
        if !(omega_over_v >= 0.0 && omega_over_v.is_finite()) {
            return Err(AeroError::Frequency { omega_over_v });
        }
        Ok(Stream::new(self.mach, omega_over_v, self.integral))
    }

    fn factorised(&self, matrix: &Mat<c64>) -> Result<PartialPivLu<c64>, AeroError> {
        let factors = matrix.partial_piv_lu();
        let pivots: Vec<f64> = factors.U().diagonal().column_vector().iter().map(|p| p.norm()).collect();
        match lost_pivot(&pivots) {
            Some(i) => Err(AeroError::Singular { id: self.ids[i] }),
            None => Ok(factors),
        }
    }
}

/// The influence matrix at one frequency: [`DoubletLattice::influence`] for a single use.
///
/// # Errors
/// As [`DoubletLattice::new`] and [`DoubletLattice::influence`].
pub fn oscillatory(
    lattice: &Lattice,
    plane: MirrorPlane,
    mach: f64,
    omega_over_v: f64,
    settings: &DlmSettings,
) -> Result<Mat<c64>, AeroError> {
    DoubletLattice::new(lattice, plane, mach, settings)?.influence(omega_over_v)
}

#[derive(Debug, Clone)]
enum Factors {
    /// With the boxes that carry nothing.
    Whole(PartialPivLu<c64>, Vec<usize>),
    /// Symmetric and antisymmetric.
    Halves([PartialPivLu<c64>; 2], Halves),
}

/// The lattice solved at one frequency: pressures for any incidence.
#[derive(Debug, Clone)]
pub struct OscillatoryAero {
    factors: Factors,
}

impl OscillatoryAero {
    /// Amplitudes of the pressure coefficients, n by columns, for those of the incidences in rad, n by columns.
    ///
    /// # Panics
    /// If `w` has not one row per box.
    pub fn pressures(&self, w: MatRef<'_, c64>) -> Mat<c64> {
        match &self.factors {
            Factors::Whole(factors, silent) => {
                let mut pressures = factors.solve(w);
                for at in silent {
                    pressures.row_mut(*at).fill(c64::ZERO);
                }
                pressures
            }
            Factors::Halves([symmetric, antisymmetric], halves) => {
                let [same, other] = halves.split(w);
                halves.join([symmetric.solve(same), antisymmetric.solve(other)])
            }
        }
    }
}
