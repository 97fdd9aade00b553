//! Loads along a beam as forces and moments on its grids: those that give the grids the displacements of the loaded beam, exactly,
//! whatever its taper, shear flexibility, pins and offsets.
//!
//! With end A held the loads cause section forces s(x) by equilibrium alone, and move end B by d = L int H^T f s dx/L. Held at both
//! ends the beam is pushed at B by K_B d (K_B: stiffness of end B), and at A by what is left of the loads; so are the grids.

use crate::beam::{
    BeamPlacement, element_axes, end_stiffness, grid_to_element, release, section_forces, stiffness,
};
use crate::section::{Section, gauss};
use nalgebra::{Matrix6, SVector, Vector3, Vector6};
use nastran::{BeamLoad, BeamProperty, InputError, Mat1};

/// A beam as its cards have it.
#[derive(Debug, Clone)]
pub(crate) struct BeamParts<'a> {
    /// Its two nodes, by position.
    pub(crate) nodes: [usize; 2],
    pub(crate) placement: BeamPlacement,
    pub(crate) property: &'a BeamProperty,
    pub(crate) material: &'a Mat1,
}

/// A load per length on a stretch, in element axes: force and moment, linear between its ends (x/L); or all of it at one place.
struct Stretch {
    ends: [f64; 2],
    values: [Vector6<f64>; 2],
}

impl Stretch {
    fn is_concentrated(&self) -> bool {
        self.ends[1] <= self.ends[0]
    }

    /// Sum over the stretch outboard of `from` (x/L) of a matrix times the load, lengths in m.
    fn sum(&self, from: f64, length: f64, of: impl Fn(f64) -> Matrix6<f64>) -> Vector6<f64> {
        let [a, b] = self.ends;
        if self.is_concentrated() {
            return if a > from || from == 0.0 { of(a) * self.values[0] } else { Vector6::zeros() };
        }
        let begin = a.max(from);
        if begin >= b {
            return Vector6::zeros();
        }
        let at = |(x, weight): (f64, f64)| {
            let load = self.values[0] + (self.values[1] - self.values[0]) * ((x - a) / (b - a));
            of(x) * load * (weight * length)
        };
        gauss([begin, b]).into_iter().map(at).sum()
    }
}

/// Force and moment (N, Nm; basic axes) on the grids of ends A and B.
///
/// # Errors
/// If the load does not fit on the beam, or the beam's stiffness cannot be computed.
pub(crate) fn on_grids(beam: &BeamParts, load: &BeamLoad) -> Result<[[Vector3<f64>; 2]; 2], InputError> {
    let section = Section { property: beam.property, material: beam.material };
    section.check()?;
    let (length, axes) = element_axes(load.element, &beam.placement, &load.span)?;
    let stretch = stretch(load, length, &axes)?;
    let cannot = || {
        InputError::at(&load.span, format!("beam {}: its stiffness cannot be computed", load.element))
            .with_help("look for a property or material many orders of magnitude off")
    };
    let mut moved = Vector6::zeros();
    for (x, weight) in section.quadrature_between(&stretch.ends) {
        let forces = stretch.sum(x, length, |place| section_forces(section, (place - x) * length));
        let by_end = section_forces(section, (1.0 - x) * length);
        moved += by_end.transpose() * (section.flexibility(x) * forces) * (weight * length);
    }
    let at_b = end_stiffness(section, length).ok_or_else(cannot)? * moved;
    // Moments about end A.
    let about_a = |place: f64| {
        let mut arms = Matrix6::identity();
        (arms[(4, 2)], arms[(5, 1)]) = (-place * length, place * length);
        arms
    };
    let at_a = stretch.sum(0.0, length, about_a) - about_a(1.0) * at_b;
    let mut ends = SVector::<f64, 12>::from_fn(|i, _| if i < 6 { at_a[i] } else { at_b[i - 6] });
    release(stiffness(section, length).ok_or_else(cannot)?, &beam.placement.pins, &mut ends);
    let grids = grid_to_element(&axes, &beam.placement.offsets).transpose() * ends;
    let three = |first: usize| Vector3::from_fn(|i, _| grids[first + i]);
    Ok([[three(0), three(3)], [three(6), three(9)]])
}

fn stretch(load: &BeamLoad, length: f64, axes: &nalgebra::Matrix3<f64>) -> Result<Stretch, InputError> {
    let scale = if load.is_length { length } else { 1.0 };
    let ends = load.places.map(|place| place / scale);
    if ends[1] > 1.0 + 1e-6 {
        let message = format!(
            "PLOAD1 of set {} reaches beyond element {}, which is {length} long",
            load.set, load.element
        );
        return Err(
            InputError::at(&load.span, message).with_help("write SCALE as FR for shares of the length")
        );
    }
    let ends = ends.map(|end| end.min(1.0));
    let mut along = Vector3::zeros();
    along[(usize::from(load.component) + 2) % 3] = 1.0;
    let own = if load.is_element { along } else { axes.transpose() * along };
    let seen = if load.is_projected && ends[1] > ends[0] { Vector3::x().cross(&own).norm() } else { 1.0 };
    let first = if load.component > 3 { 3 } else { 0 };
    let of = |value: f64| {
        let mut six = Vector6::zeros();
        (0..3).for_each(|i| six[first + i] = own[i] * value * seen);
        six
    };
    Ok(Stretch { ends, values: load.values.map(of) })
}
