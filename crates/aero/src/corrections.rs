//! Corrections of box loads by measurements: P = q W S Q w + q S `f_e` (Giesing, Kalman and Rodden's form).
//!
//! W holds a force and a moment factor per box, alternating (Nastran's `WKK`); `f_e` is a pressure coefficient per
//! box (here always the offset over q, Nastran's `FA2J`). W never multiplies `f_e`.

use crate::lattice::Lattice;
use nalgebra::Vector3;
use nastran::{Dmi, InputError};
use serde::{Deserialize, Serialize};

/// Direction cosines below this are zero when factors are placed in six components.
const NO_COMPONENT: f64 = 1e-12;

/// One set of corrections: three numbers for each box.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Corrections {
    /// Factor of each box's lift.
    pub force: Vec<f64>,
    /// Factor of each box's moment about its midpoint.
    pub moment: Vec<f64>,
    /// Pressure coefficient added to each box, not multiplied by the factors.
    pub pressure_offset: Vec<f64>,
}

impl Corrections {
    /// Corrections of `n` boxes that change nothing: factors 1, offsets 0.
    pub fn neutral(n: usize) -> Self {
        Self { force: vec![1.0; n], moment: vec![1.0; n], pressure_offset: vec![0.0; n] }
    }

    /// Number of boxes.
    pub fn len(&self) -> usize {
        self.force.len()
    }

    /// True if for no boxes.
    pub fn is_empty(&self) -> bool {
        self.force.is_empty()
    }

    /// True if they change nothing.
    pub fn is_neutral(&self) -> bool {
        *self == Self::neutral(self.len())
    }

    /// The same corrections in a lattice of `total` boxes: entry i goes to box `places[i]`, other boxes (a
    /// fairing, say) get neutral ones.
    ///
    /// # Panics
    /// If a place is not below `total`.
    #[must_use]
    pub fn padded(&self, total: usize, places: &[usize]) -> Self {
        let mut all = Self::neutral(total);
        for (i, &place) in places.iter().enumerate().take(self.len()) {
            all.force[place] = self.force[i];
            all.moment[place] = self.moment[i];
            all.pressure_offset[place] = self.pressure_offset[i];
        }
        all
    }

    /// Nastran's `WKK`: force and moment factors alternating, two rows per box.
    pub fn wkk(&self) -> Dmi {
        let pairs = self.force.iter().zip(&self.moment).flat_map(|(force, moment)| [*force, *moment]);
        Dmi::diagonal("WKK", pairs.collect())
    }

    /// Nastran's `FA2J`: pressure offsets over q, one row per box.
    pub fn fa2j(&self) -> Dmi {
        Dmi::column_vector("FA2J", self.pressure_offset.clone())
    }

    /// Corrections from Nastran's two matrices.
    ///
    /// `wkk` may be a diagonal, a column, or a square matrix that is diagonal.
    ///
    /// # Errors
    /// If the sizes do not fit, `wkk` has entries off its diagonal, or a value is not finite.
    pub fn from_dmi(wkk: &Dmi, fa2j: &Dmi) -> Result<Self, InputError> {
        let factors = diagonal_of(wkk)?;
        let [offsets] = fa2j.columns.as_slice() else {
            return Err(InputError::general(format!(
                "DMI {} has {} columns, expected one",
                fa2j.name,
                fa2j.columns.len()
            )));
        };
        if factors.len() != 2 * offsets.len() {
            return Err(InputError::general(format!(
                "DMI {} has {} rows and DMI {} has {}, expected two and one for each box",
                wkk.name,
                factors.len(),
                fa2j.name,
                offsets.len()
            )));
        }
        if factors.iter().chain(offsets).any(|value| !value.is_finite()) {
            return Err(InputError::general(format!(
                "DMI {} or {} has a value that is not finite",
                wkk.name, fa2j.name
            )));
        }
        Ok(Self {
            force: factors.iter().copied().step_by(2).collect(),
            moment: factors.iter().copied().skip(1).step_by(2).collect(),
            pressure_offset: offsets.clone(),
        })
    }

    /// The factors for programs that keep six load components per box (Fx Fy Fz Mx My Mz): the force factor at
    /// the components in which the normal points, the moment factor at those of the pitch axis, 1 elsewhere.
    ///
    /// # Panics
    /// If the lattice has not as many boxes as the corrections.
    pub fn six_dof(&self, lattice: &Lattice) -> Vec<[f64; 6]> {
        assert_eq!(self.len(), lattice.len(), "corrections are for another number of boxes");
        let place = |direction: &Vector3<f64>, axis: usize, factor: f64| {
            if direction[axis].abs() > NO_COMPONENT { factor } else { 1.0 }
        };
        let one = |(j, panel): (usize, &crate::AeroBox)| {
            let (n, e) = (panel.normal(), panel.pitch_axis());
            let (force, moment) = (self.force[j], self.moment[j]);
            std::array::from_fn(|c| if c < 3 { place(&n, c, force) } else { place(&e, c - 3, moment) })
        };
        lattice.boxes.iter().enumerate().map(one).collect()
    }
}

/// The diagonal of a matrix given as diagonal, as column or in full.
fn diagonal_of(matrix: &Dmi) -> Result<Vec<f64>, InputError> {
    let columns = &matrix.columns;
    if let [column] = columns.as_slice() {
        return Ok(column.clone());
    }
    let square = columns.iter().all(|column| column.len() == columns.len());
    let off =
        |(c, column): (usize, &Vec<f64>)| column.iter().enumerate().any(|(r, value)| r != c && *value != 0.0);
    if !square || columns.iter().enumerate().any(off) {
        return Err(InputError::general(format!("DMI {} is not diagonal", matrix.name))
            .with_help("only factors of each box's own load are used"));
    }
    Ok(columns.iter().enumerate().map(|(i, column)| column[i]).collect())
}
