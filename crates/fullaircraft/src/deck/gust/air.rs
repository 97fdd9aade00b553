//! Air forces of the modes and of a gust over frequency: on the modes, and on what monitoring stations add up.
//!
//! Rows are the modes and after them the stations; the doublet lattice is solved at the reduced frequencies of MKAERO1 and MKAERO2, at
//! rest, and at the highest frequency asked for if that lies beyond; cubic splines lie between.

use crate::deck::modal::ModalDeck;
use crate::deck::trim::mirror_plane;
use crate::error::AircraftError;
use aero::{DlmSettings, DoubletLattice, Integration};
use faer::{Mat, MatRef, Scale, c64};
use maneuver::flutter::{GafTable, MatrixSpline, incidence_of_motion};
use maneuver::gust::{FrequencyTable, gust_incidence_along};

/// Share of the air forces by which a spline may miss them in the widest gap before it is said.
const SAID: f64 = 0.02;

/// Air forces over frequency, per unit dynamic pressure.
#[derive(Debug)]
pub(crate) struct GustAir {
    /// On the modes by the modes.
    pub(crate) modal: GafTable,
    /// On the stations by the modes; none without stations.
    pub(crate) stations: Option<MatrixSpline>,
    /// On modes and stations by a gust of one radian.
    pub(crate) gust: FrequencyTable,
    /// Mach number that the forces are of.
    pub(crate) mach: f64,
    /// What the user should know.
    pub(crate) remarks: Vec<String>,
    /// Share of the air forces by which the splines miss them amid the widest gap of the frequencies.
    pub(crate) missed: f64,
}

impl GustAir {
    /// Solves the lattice at the Mach number of MKAERO1 and MKAERO2 that is nearest; `rows` weigh box loads for the stations (two
    /// columns a box), `highest` is the highest omega/V asked for, and the air of the gust moves along `direction`.
    pub(crate) fn new(
        deck: &ModalDeck,
        rows: MatRef<'_, f64>,
        mach: f64,
        highest: f64,
        direction: [f64; 3],
    ) -> Result<Self, AircraftError> {
        let mut remarks = Vec::new();
        let near = deck.nearest_mach(mach);
        if (near - mach).abs() > 1e-9 {
            remarks
                .push(format!("MKAERO1 and MKAERO2 have no Mach number {mach}; forces are those of {near}"));
        }
        let mut kappa: Vec<f64> = deck.reduced_frequencies(near).iter().map(|k| deck.kappa(*k)).collect();
        let last = kappa[kappa.len() - 1];
        if highest > last * (1.0 + 1e-9) {
            remarks.push(format!(
                "MKAERO1 and MKAERO2 end at the reduced frequency {:.4}, the frequencies at {:.4}: forces are computed there, too",
                last / deck.kappa(1.0),
                highest / deck.kappa(1.0)
            ));
            kappa.push(highest);
        }
        let all = all_rows(deck, rows);
        let solver = Solver::new(deck, near, &all, direction)?;
        let solved: Vec<[Mat<c64>; 2]> =
            kappa.iter().map(|kappa| solver.at(*kappa)).collect::<Result<_, AircraftError>>()?;
        let modes = deck.omega_rad_s.len();
        let part = |from: usize, count: usize| -> Vec<Mat<c64>> {
            solved.iter().map(|pair| pair[0].subrows(from, count).to_owned()).collect()
        };
        let stations = if rows.nrows() == 0 {
            None
        } else {
            Some(MatrixSpline::new(kappa.clone(), part(modes, rows.nrows()))?)
        };
        let modal = GafTable::new(kappa.clone(), part(0, modes))?;
        let columns = solved.iter().map(|pair| pair[1].clone()).collect();
        let gust = FrequencyTable::new(kappa.clone(), columns, solver.middle)?;
        let air = Self { modal, stations, gust, mach: near, remarks, missed: 0.0 };
        air.with_check(&solver, &kappa)
    }

    /// Solves the lattice amid the widest gap of its frequencies, and says so if the splines miss what it gives there.
    fn with_check(mut self, solver: &Solver<'_>, kappa: &[f64]) -> Result<Self, AircraftError> {
        let widest = kappa.windows(2).max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])));
        let Some(gap) = widest else { return Ok(self) };
        let amid = f64::midpoint(gap[0], gap[1]);
        let [by_modes, by_gust] = solver.at(amid)?;
        let splined = maneuver::flutter::GeneralisedForces::at(&self.modal, amid, 1.0)?;
        let off = |a: MatRef<'_, c64>, b: MatRef<'_, c64>| {
            let largest = b.norm_l2();
            if largest > 0.0 { (a - b).norm_l2() / largest } else { 0.0 }
        };
        let modes = splined.nrows();
        let missed = off(splined.as_ref(), by_modes.subrows(0, modes))
            .max(off(self.gust.at(amid, solver.middle)?.subrows(0, modes), by_gust.subrows(0, modes)));
        self.missed = missed;
        if missed > SAID {
            self.remarks.push(format!(
                "between the reduced frequencies {:.4} and {:.4} of MKAERO the splined air forces are off by {:.0} %: list more",
                gap[0] / solver.deck.kappa(1.0),
                gap[1] / solver.deck.kappa(1.0),
                100.0 * missed
            ));
        }
        Ok(self)
    }

    /// Forces on the stations per unit dynamic pressure, of amplitudes of the modes; none without stations.
    pub(crate) fn on_stations(&self, kappa: f64, x: MatRef<'_, c64>) -> Option<Mat<c64>> {
        self.stations.as_ref().and_then(|spline| spline.at(kappa)).map(|q| q * x)
    }

    /// Forces of a gust of `amplitude`, rad, whose phase is taken at `x_0` per unit dynamic pressure: on modes and stations.
    pub(crate) fn of_gust(&self, kappa: f64, x_0: f64, amplitude: c64) -> Result<Mat<c64>, AircraftError> {
        Ok(self.gust.at(kappa, x_0)? * Scale(amplitude))
    }
}

/// The motions of the modes, and the stations, as rows over box loads.
fn all_rows(deck: &ModalDeck, rows: MatRef<'_, f64>) -> Mat<f64> {
    let modes = deck.omega_rad_s.len();
    Mat::from_fn(modes + rows.nrows(), 2 * deck.lattice.len(), |i, j| {
        if i < modes { deck.motion[(j, i)] } else { rows[(i - modes, j)] }
    })
}

/// The lattice, ready for any frequency.
struct Solver<'a> {
    deck: &'a ModalDeck,
    doublets: DoubletLattice,
    integration: Integration,
    rows: &'a Mat<f64>,
    /// Where the gust's phase is taken: amid the boxes, so that the forces turn slowly with frequency.
    middle: f64,
    /// Where the gust's air goes.
    direction: [f64; 3],
}

impl<'a> Solver<'a> {
    fn new(
        deck: &'a ModalDeck,
        mach: f64,
        rows: &'a Mat<f64>,
        direction: [f64; 3],
    ) -> Result<Self, AircraftError> {
        let plane = mirror_plane(deck.aero.symmetry);
        let doublets = DoubletLattice::new(&deck.lattice, plane, mach, &DlmSettings::NASTRAN)?;
        let places = deck.lattice.boxes.iter().map(|panel| panel.three_quarter_point().x);
        let (low, high) =
            places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        let integration = Integration::new(&deck.lattice);
        Ok(Self { deck, doublets, integration, rows, middle: f64::midpoint(low, high), direction })
    }

    /// Forces on all rows by the modes, and by a gust.
    fn at(&self, kappa: f64) -> Result<[Mat<c64>; 2], AircraftError> {
        let lattice = &self.deck.lattice;
        let solved = self.doublets.at(kappa)?;
        let loads = self.integration.corrected(&self.deck.corrections);
        let of = |w: Mat<c64>| loads.weighed(self.rows.as_ref(), solved.pressures(w.as_ref()).as_ref());
        Ok([
            of(incidence_of_motion(lattice, self.deck.motion.as_ref(), kappa)),
            of(gust_incidence_along(lattice, self.direction, self.middle, kappa)),
        ])
    }
}

#[cfg(test)]
mod tests;
