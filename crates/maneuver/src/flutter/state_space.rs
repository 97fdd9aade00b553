//! Stability of a linear system x' = A x whose matrix depends on the flow: eigenvalues over airspeed.
//!
//! Changes of stability are found from the number of unstable eigenvalues, which needs no following of branches: between two
//! flows where it differs, the change is halved in on. Branches are followed for the curves only, by shape and
//! distance, in steps that are halved while it is not plain which is which.

use super::FlutterError;
use super::curves::{Crossing, FlutterCurves, Root, in_order};
use aero::Flow;
use faer::{Mat, c64};
use structure::unsymmetric::{eigen, eigenvalues};

/// Real parts below this share of the largest eigenvalue are round-off.
const ROUND_OFF: f64 = 1e-12;
/// An eigenvalue with a smaller share of imaginary part does not oscillate.
const REAL: f64 = 1e-9;
/// Accuracy of a change of stability, as a share of the airspeed.
const ACCURACY: f64 = 1e-10;
/// Damping, a share of critical, below which an eigenvalue at the first flow is a mode (and not, say, an actuator).
const MODE: f64 = 0.5;
/// Halvings of the way between two flows for the curves.
const HALVINGS: u32 = 6;
/// Likeness of shapes below which steps are halved.
const SAME_SHAPE: f64 = 0.8;
/// Eigenvalues nearer to each other than this share are at one place of a curve: their shapes alone tell them apart.
const CLOSE: f64 = 1e-3;

/// Eigenvalues and eigenvectors at a flow.
struct Spectrum {
    values: Vec<c64>,
    vectors: Mat<c64>,
}

impl Spectrum {
    fn new(a: &Mat<f64>) -> Result<Self, FlutterError> {
        let (values, vectors) = eigen(a.as_ref()).ok_or(FlutterError::Eigenvalues("the system"))?;
        Ok(Self { values, vectors })
    }

    fn likeness(&self, i: usize, other: &Self, j: usize) -> f64 {
        let n = self.values.len();
        let product: c64 = (0..n).map(|row| self.vectors[(row, i)].conj() * other.vectors[(row, j)]).sum();
        let size = |spectrum: &Self, k: usize| -> f64 {
            (0..n).map(|row| spectrum.vectors[(row, k)].norm_sqr()).sum()
        };
        product.norm_sqr() / (size(self, i) * size(other, j)).max(f64::MIN_POSITIVE)
    }
}

fn oscillates(value: c64) -> bool {
    value.im > REAL * value.norm()
}

/// Unstable eigenvalues that oscillate (pairs counted once), and that do not.
fn unstable(values: &[c64]) -> [usize; 2] {
    let size = values.iter().map(|value| value.norm()).fold(0.0, f64::max);
    let growing = |value: &&c64| value.re > ROUND_OFF * size;
    let oscillating = values.iter().filter(growing).filter(|value| oscillates(**value)).count();
    let all = values.iter().filter(growing).count();
    [oscillating, all - 2 * oscillating]
}

fn values_of(a: &Mat<f64>) -> Result<Vec<c64>, FlutterError> {
    eigenvalues(a.as_ref()).ok_or(FlutterError::Eigenvalues("the system"))
}

/// Every change of stability over the flows as [`flutter_of_state_space`] finds them, by eigenvalues alone: there are no curves, and the
/// branch of each change is left open (0).
///
/// # Errors
/// As [`flutter_of_state_space`].
pub fn changes_of_stability<E: From<FlutterError>>(
    flows: &[Flow],
    mut matrix: impl FnMut(Flow) -> Result<Mat<f64>, E>,
) -> Result<Vec<Crossing>, E> {
    let mut at = |flow: Flow| -> Result<Vec<c64>, E> { Ok(values_of(&matrix(flow)?)?) };
    let Some(&first) = flows.first() else { return Err(FlutterError::Empty("the list of flows").into()) };
    let mut here = at(first)?;
    let mut found = Vec::new();
    for (leg, pair) in flows.windows(2).enumerate() {
        let there = at(pair[1])?;
        let ends = [ValuesAt { flow: pair[0], are: &here }, ValuesAt { flow: pair[1], are: &there }];
        for kind in 0..2 {
            found.extend(change(ends, kind, &mut at)?.map(|crossing| (leg, crossing)));
        }
        here = there;
    }
    Ok(in_order(flows, found))
}

/// Eigenvalues that oscillate at the first flow with less than half the critical damping, followed through the list, and every
/// change of stability (of all eigenvalues; it is ascribed to the branch nearest in frequency).
///
/// A list of a branch ends where its eigenvalue does not oscillate any more. `matrix` gives A at a flow; flows in between
/// are asked for too.
///
/// # Errors
/// What `matrix` reports; if there is no flow, or eigenvalues do not converge.
pub fn flutter_of_state_space<E: From<FlutterError>>(
    flows: &[Flow],
    mut matrix: impl FnMut(Flow) -> Result<Mat<f64>, E>,
) -> Result<FlutterCurves, E> {
    let Some(&first) = flows.first() else { return Err(FlutterError::Empty("the list of flows").into()) };
    let mut here = Spectrum::new(&matrix(first)?)?;
    let mode = |value: c64| oscillates(value) && value.re.abs() < MODE * value.norm();
    let mut places: Vec<usize> = (0..here.values.len()).filter(|i| mode(here.values[*i])).collect();
    places.sort_by(|a, b| here.values[*a].im.total_cmp(&here.values[*b].im));
    let mut curves = FlutterCurves {
        flows: flows.to_vec(),
        branches: places.iter().map(|i| vec![root(here.values[*i])]).collect(),
        crossings: Vec::new(),
        lost: Vec::new(),
    };
    let mut alive: Vec<Option<usize>> = places.into_iter().map(Some).collect();
    let mut found = Vec::new();
    for (leg, pair) in flows.windows(2).enumerate() {
        let there = Spectrum::new(&matrix(pair[1])?)?;
        let ends = [SpectrumAt { flow: pair[0], is: &here }, SpectrumAt { flow: pair[1], is: &there }];
        let mut between = |flow: Flow| -> Result<Spectrum, E> { Ok(Spectrum::new(&matrix(flow)?)?) };
        alive = follow(ends[0], ends[1], alive, HALVINGS, &mut between)?;
        for (branch, place) in curves.branches.iter_mut().zip(&alive) {
            branch.extend(place.map(|i| root(there.values[i])));
        }
        for kind in 0..2 {
            let mut at = |flow: Flow| -> Result<Vec<c64>, E> { Ok(values_of(&matrix(flow)?)?) };
            if let Some(crossing) = change(ends.map(SpectrumAt::values), kind, &mut at)? {
                found.push((leg, Crossing { branch: curves.beside(&crossing, leg + 1), ..crossing }));
            }
        }
        here = there;
    }
    curves.crossings = in_order(&curves.flows, found);
    Ok(curves)
}

fn root(p: c64) -> Root {
    Root { p, beyond_table: false }
}

fn middle(a: Flow, b: Flow) -> Flow {
    Flow { v_m_s: f64::midpoint(a.v_m_s, b.v_m_s), rho_kg_m3: f64::midpoint(a.rho_kg_m3, b.rho_kg_m3) }
}

/// Eigenvalues and eigenvectors, and the flow that they are of.
#[derive(Clone, Copy)]
struct SpectrumAt<'a> {
    flow: Flow,
    is: &'a Spectrum,
}

impl<'a> SpectrumAt<'a> {
    fn values(self) -> ValuesAt<'a> {
        ValuesAt { flow: self.flow, are: &self.is.values }
    }
}

/// The eigenvalues alone.
#[derive(Clone, Copy)]
struct ValuesAt<'a> {
    flow: Flow,
    are: &'a [c64],
}

/// Which eigenvalue of the second spectrum each living branch of the first becomes.
fn follow<E: From<FlutterError>>(
    from: SpectrumAt<'_>,
    to: SpectrumAt<'_>,
    alive: Vec<Option<usize>>,
    halvings: u32,
    at: &mut impl FnMut(Flow) -> Result<Spectrum, E>,
) -> Result<Vec<Option<usize>>, E> {
    let (matched, plain) = matched(from.is, to.is, &alive);
    if plain || halvings == 0 {
        return Ok(matched);
    }
    let flow = middle(from.flow, to.flow);
    let spectrum = at(flow)?;
    let between = SpectrumAt { flow, is: &spectrum };
    let alive = follow(from, between, alive, halvings - 1, at)?;
    follow(between, to, alive, halvings - 1, at)
}

/// The best pairs first; whether all are plain: like in shape, and no two nearer to each other's eigenvalues than to their own.
/// Branches that cross are, and so are branches that stay apart and exchange their shapes: steps between tell one from the other.
fn matched(from: &Spectrum, to: &Spectrum, alive: &[Option<usize>]) -> (Vec<Option<usize>>, bool) {
    let mut pairs = Vec::new();
    for (branch, place) in alive.iter().enumerate() {
        let Some(i) = *place else { continue };
        for (j, value) in to.values.iter().enumerate().filter(|(_, value)| oscillates(**value)) {
            let near = (value - from.values[i]).norm() / from.values[i].norm();
            let like = from.likeness(i, to, j);
            pairs.push((like - near, like, branch, j));
        }
    }
    pairs.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut found = vec![None; alive.len()];
    let mut taken = vec![false; to.values.len()];
    let mut plain = true;
    for (_, like, branch, j) in pairs {
        if found[branch].is_none() && !taken[j] {
            found[branch] = Some(j);
            taken[j] = true;
            plain &= like > SAME_SHAPE;
        }
    }
    let ends: Vec<[c64; 2]> = alive
        .iter()
        .zip(&found)
        .filter_map(|(before, after)| Some([from.values[(*before)?], to.values[(*after)?]]))
        .collect();
    let crossed = |a: &[c64; 2], b: &[c64; 2]| {
        let own = (a[1] - a[0]).norm() + (b[1] - b[0]).norm();
        let exchanged = (a[1] - b[0]).norm() + (b[1] - a[0]).norm();
        own - exchanged > CLOSE * a[0].norm().max(b[0].norm())
    };
    plain &= !ends.iter().enumerate().any(|(at, a)| ends[..at].iter().any(|b| crossed(a, b)));
    let kept = alive.iter().zip(&found).all(|(before, after)| before.is_some() == after.is_some());
    (found, plain && kept)
}

/// A change of the number of unstable eigenvalues that oscillate (`kind` 0) or do not (1) between two flows: one that is net. Its branch
/// is left open.
fn change<E: From<FlutterError>>(
    [from, to]: [ValuesAt<'_>; 2],
    kind: usize,
    at: &mut impl FnMut(Flow) -> Result<Vec<c64>, E>,
) -> Result<Option<Crossing>, E> {
    let before = unstable(from.are)[kind];
    let after = unstable(to.are)[kind];
    if before == after {
        return Ok(None);
    }
    let (mut low, mut high) = (from.flow, to.flow);
    let mut last = None;
    while (high.v_m_s - low.v_m_s).abs() > ACCURACY * high.v_m_s
        || (high.rho_kg_m3 - low.rho_kg_m3).abs() > ACCURACY * high.rho_kg_m3
    {
        let flow = middle(low, high);
        let values = at(flow)?;
        if unstable(&values)[kind] == before {
            low = flow;
        } else {
            high = flow;
        }
        last = Some(values);
    }
    let values = last.as_deref().unwrap_or(to.are);
    let wanted = |value: &&c64| if kind == 0 { oscillates(**value) } else { value.im == 0.0 };
    let nearest = values.iter().filter(wanted).min_by(|a, b| a.re.abs().total_cmp(&b.re.abs()));
    let omega_rad_s = nearest.map_or(0.0, |value| value.im);
    Ok(Some(Crossing { branch: 0, flow: high, omega_rad_s, unstable: after > before, beyond_table: false }))
}

impl FlutterCurves {
    /// The branch that is nearest in frequency to a change of stability at the flow behind it.
    fn beside(&self, change: &Crossing, place: usize) -> usize {
        let distance = |branch: &[Root]| {
            branch.get(place).map_or(f64::INFINITY, |root| (root.p.im - change.omega_rad_s).abs())
        };
        (0..self.branches.len())
            .min_by(|a, b| distance(&self.branches[*a]).total_cmp(&distance(&self.branches[*b])))
            .unwrap_or(0)
    }
}

#[cfg(test)]
mod tests;
