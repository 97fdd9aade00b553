//! Corrections for programs that have neither `W_kk` nor `f_e`, such as Loads Kernel: a matrix of pressures and an
//! incidence, which every panel method has.
//!
//! With Q the inverse of the influence matrix A (cp = Q w), F the force factors and f the pressure offsets, the corrected
//! pressures are cp = F Q w + f. The matrix Q' = F Q and the incidence w_e = A F^-1 f, added to camber and twist, give
//! the same for every w: Q' (w + w_e) = F Q w + F Q A F^-1 f. So lift, box by box, is carried exactly, and with it its
//! moment. Not carried are the moment factors: the moment of a box about its midpoint, W_m times that of theory, becomes F times
//! it, as the lift acts at the quarter chord.

use crate::case::SteadyCase;
use crate::error::CouplingError;
use crate::root_loads::RootLoads;
use crate::wing::ElasticWing;
use aero::{Corrections, Flow, influence};
use faer::Mat;
use nastran::{Dmi, InputError};

/// Force factors below this share of the largest cannot be divided by.
const LEAST_FACTOR: f64 = 1e-6;

/// Corrections as a matrix and an incidence.
#[derive(Debug, Clone)]
pub struct Exchange {
    /// Pressure coefficients per incidence (rad, nose up positive), boxes by boxes, with the force factors.
    pub qjj: Mat<f64>,
    /// Camber and twist, plus what acts as the pressure offsets with `qjj`, rad, one a box.
    pub w2gj_rad: Vec<f64>,
    /// Camber and twist alone.
    pub camber_rad: Vec<f64>,
}

/// Root loads with all corrections, and with those that are carried.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LeftOut {
    /// Fz, Mx, My (N, N m, N m) of the elastic wing with all corrections.
    pub complete: RootLoads,
    /// The same where the moment factors are the force factors.
    pub carried: RootLoads,
}

impl Exchange {
    /// The corrections (one entry for each correctable box) of a wing.
    ///
    /// # Errors
    /// If there is not one entry for each box, or a force factor is zero where an offset must be carried.
    pub fn of(wing: &ElasticWing, corrections: &Corrections) -> Result<Self, CouplingError> {
        let all = wing.padded(corrections)?;
        let boxes = wing.lattice.len();
        let largest = all.force.iter().fold(0.0, |most: f64, factor| most.max(factor.abs()));
        let lost = |&j: &usize| all.force[j].abs() <= LEAST_FACTOR * largest && all.pressure_offset[j] != 0.0;
        if let Some(j) = (0..boxes).find(lost) {
            let message = format!(
                "the force factor of box {} is {:e}: its pressure offset has no equivalent incidence",
                wing.lattice.boxes[j].id, all.force[j]
            );
            return Err(InputError::general(message)
                .with_help("take WKK and FA2J, which Nastran reads")
                .into());
        }
        let identity = Mat::<f64>::identity(boxes, boxes);
        let theory = wing.pressures(identity.as_ref());
        let qjj = Mat::from_fn(boxes, boxes, |i, j| all.force[i] * theory[(i, j)]);
        let of_theory = Mat::from_fn(boxes, 1, |j, _| {
            if all.pressure_offset[j] == 0.0 { 0.0 } else { all.pressure_offset[j] / all.force[j] }
        });
        let added = influence(&wing.lattice, wing.plane, wing.mach)? * of_theory;
        let w2gj_rad = (0..boxes).map(|j| wing.camber[j] + added[(j, 0)]).collect();
        Ok(Self { qjj, w2gj_rad, camber_rad: wing.camber.clone() })
    }

    /// The incidence as DMI W2GJ, in fields of eight characters.
    pub fn w2gj(&self) -> Dmi {
        Dmi::column_vector("W2GJ", self.w2gj_rad.clone()).rounded_to_fields()
    }

    /// The matrix as the text of an ASCII OP4 file, name QJJ, nothing lost.
    pub fn op4(&self) -> String {
        let columns: Vec<Vec<f64>> =
            self.qjj.as_ref().col_iter().map(|column| column.iter().copied().collect()).collect();
        nastran::op4_text("QJJ", &columns)
    }

    /// What the moment factors do to the root loads, which is what is not carried.
    ///
    /// # Errors
    /// If the wing diverges.
    pub fn left_out(
        wing: &ElasticWing,
        corrections: &Corrections,
        flow: Flow,
        alpha_rad: f64,
    ) -> Result<LeftOut, CouplingError> {
        let loads = |corrections: &Corrections| -> Result<RootLoads, CouplingError> {
            let states = wing.at(flow, corrections)?.solve(&[SteadyCase::new(flow, alpha_rad)]);
            Ok(states[0].root)
        };
        let carried = Corrections { moment: corrections.force.clone(), ..corrections.clone() };
        Ok(LeftOut { complete: loads(corrections)?, carried: loads(&carried)? })
    }
}
