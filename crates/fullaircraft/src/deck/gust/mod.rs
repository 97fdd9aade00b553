//! Gusts of a user's deck (SOL 146): discrete ones (GUST with TLOAD) and random ones (GUST with RLOAD, RANDPS).
//!
//! ```text
//! [-omega² M + i omega C + K + i D - q Q(k)] x = q Q_g(k) WG f(omega) + Phiᵀ A f(omega)
//! y(t) = 1/pi sum_n C_n Re[y(omega_n) exp(i omega_n t)],   S_y = |y|² S
//! ```
//! in the deck's own units, D = G K (PARAM G) and what elements have by GE, with the modes of METHOD and the doublet lattice of flutter (Rodden and Johnson, *MSC/NASTRAN Aeroelastic
//! Analysis User's Guide*, 1994, sec. 2.9). C_n is the distance of the frequencies, so that equal ones give a Fourier series: what it
//! answers is periodic, and without a frequency of zero its mean is. Stations of grids add air less mass times acceleration.

mod air;
mod asked;
mod random;
mod signal;
mod stations;
mod time;
pub(crate) mod waves;

pub use asked::{GustCase, gust_cases};
pub use random::{DeckGust, RandomAnswer, RandomSet};
pub use time::{MonitorAnswer, TimeAnswer};

use crate::deck::modal::ModalDeck;
use crate::error::AircraftError;
use air::GustAir;
use faer::{Mat, Scale, c64};
use maneuver::flutter::Aeroelastic;
use maneuver::gust::elastic_response;
use nastran::{Asked, BulkData, InputError, Subcase};
use signal::Signal;
use stations::Station;
use std::f64::consts::TAU;

/// Three forces and three moments of a station, by what makes them.
#[derive(Debug, Clone, PartialEq)]
pub struct GustLoads<T> {
    /// Less mass times acceleration.
    pub inertial: [T; 6],
    /// Air forces by the motion.
    pub flexible: [T; 6],
    /// Air forces by the gust.
    pub gust: [T; 6],
}

impl<T: Copy + std::ops::Add<Output = T>> GustLoads<T> {
    /// All of a component (0 to 5).
    pub fn total(&self, component: usize) -> T {
        self.inertial[component] + self.flexible[component] + self.gust[component]
    }
}

/// A deck in gusts, under the boundary conditions of a subcase.
#[derive(Debug)]
pub struct GustDeck {
    /// Its modes and boxes.
    pub modal: ModalDeck,
    /// What the user should know.
    pub remarks: Vec<String>,
    stations: Vec<Station>,
    air: GustAir,
}

/// Answers of a subcase over frequency.
#[derive(Debug, Clone)]
pub struct DynamicAnswer {
    /// Frequencies, Hz.
    pub hz: Vec<f64>,
    /// Function of the gust (or, without one, of the loads) at each frequency: its transform, or its amplitude.
    pub excitation: Vec<c64>,
    /// Amplitudes of the modes, a list a frequency.
    pub modal: Vec<Vec<c64>>,
    /// Loads of the stations, a list a frequency.
    pub stations: Vec<Vec<GustLoads<c64>>>,
}

impl GustDeck {
    /// Assembles the deck under a subcase's boundary conditions and solves its air up to the highest frequency of some cases.
    ///
    /// # Errors
    /// If a card that the answer needs is not there, not read or wrong, or modes or air cannot be solved.
    pub fn new(bulk: &BulkData, subcase: &Subcase, cases: &[&GustCase]) -> Result<Self, AircraftError> {
        let modal = ModalDeck::new(bulk, subcase, "the answer to a gust")?;
        let mut remarks = Vec::new();
        let (stations, left_out) = stations::stations(&modal)?;
        if !left_out.is_empty() {
            remarks.push(format!(
                "stations of groups or of components that are not there are left out: {}",
                left_out.join(", ")
            ));
        }
        if modal.bulk.unknown.contains_key("MONDSP1") {
            remarks.push("MONDSP1 is not read: name grids by DISPLACEMENT in the case control".to_owned());
        }
        let highest = cases.iter().filter_map(|case| case.hz.last().map(|hz| TAU * hz / case.flow.v_m_s));
        let highest = highest.fold(0.0, f64::max);
        let mach = cases.first().map_or(0.0, |case| case.mach);
        let mut rows = Mat::zeros(6 * stations.len(), 2 * modal.lattice.len());
        for (at, station) in stations.iter().enumerate() {
            rows.subrows_mut(6 * at, 6).copy_from(&station.rows);
        }
        let air = GustAir::new(&modal, rows.as_ref(), mach, highest, [0.0, 0.0, 1.0])?;
        remarks.extend(air.remarks.iter().cloned());
        Ok(Self { modal, remarks, stations, air })
    }

    /// Mach number that the air forces are of.
    pub fn mach(&self) -> f64 {
        self.air.mach
    }

    /// The stations' names, labels, whether they are of the structure, and the components that they show (1 to 6).
    pub fn stations(&self) -> impl Iterator<Item = (&str, &str, bool, &[u8])> {
        self.stations.iter().map(|station| {
            (station.name.as_str(), station.label.as_str(), station.is_structural, station.axes.as_slice())
        })
    }

    /// The grids that a subcase asks for (DISPLACEMENT, VELOCITY, ACCELERATION), rising; those of SUPORT if it asks for none.
    pub fn asked_grids(&self, subcase: &Subcase) -> Vec<u32> {
        let mut known: Vec<u32> = self.modal.system.node_ids().to_vec();
        known.sort_unstable();
        match &subcase.responses {
            Asked::All => known,
            Asked::Of(ids) => known.into_iter().filter(|id| ids.contains(id)).collect(),
            Asked::Nothing => {
                let supports = self.modal.bulk.supports.iter().map(|support| support.grid);
                let all: std::collections::BTreeSet<u32> = supports.collect();
                all.into_iter().collect()
            }
        }
    }

    /// Six displacements of a grid (rows) by the modes; none if there is no such grid.
    pub fn shapes_at(&self, grid: u32) -> Option<Mat<f64>> {
        let node = self.modal.system.node_index(grid)?;
        Some(self.modal.shapes.subrows(6 * node, 6).to_owned())
    }

    /// The answer of a subcase over its frequencies.
    ///
    /// # Errors
    /// If the equations have no solution at a frequency, as those of a free structure at rest.
    pub fn answer(&self, case: &GustCase) -> Result<DynamicAnswer, AircraftError> {
        let modal = &self.modal;
        let n = modal.omega_rad_s.len();
        let diagonal =
            |value: &dyn Fn(usize) -> f64| Mat::from_fn(n, n, |i, j| if i == j { value(i) } else { 0.0 });
        let stiffness = diagonal(&|i| modal.omega_rad_s[i].powi(2));
        let system = Aeroelastic::new(diagonal(&|_| 1.0), modal.damping.clone(), stiffness, &self.air.modal)?;
        let structural = modal.structural_damping()?;
        let areas = self.areas(&case.load_signal);
        let q = case.flow.dynamic_pressure_pa();
        let mut answer = DynamicAnswer {
            hz: case.hz.clone(),
            excitation: Vec::new(),
            modal: Vec::new(),
            stations: Vec::new(),
        };
        for hz in &case.hz {
            let omega = TAU * hz;
            let kappa = omega / case.flow.v_m_s;
            let (mut load, mut by_gust) = (Mat::<c64>::zeros(n, 1), None);
            let mut excitation = case.load_signal.transform(&modal.bulk, omega);
            if let Some(gust) = &case.gust {
                excitation = case.gust_signal.transform(&modal.bulk, omega);
                let forces =
                    self.air.of_gust(kappa, gust.x_0, excitation * gust.scale)? * Scale(c64::from(q));
                load += forces.subrows(0, n);
                by_gust = Some(forces.subrows(n, forces.nrows() - n).to_owned());
            }
            for (part, area) in case.load_signal.parts.iter().zip(&areas) {
                let one = Signal { parts: vec![part.clone()] }.transform(&modal.bulk, omega);
                (0..n).for_each(|i| load[(i, 0)] += one * area[i]);
            }
            let x = elastic_response(&system, case.flow, omega, structural.as_ref(), load.as_ref())?;
            if x.col(0).iter().any(|value| !value.is_finite()) {
                let message = format!("a free structure has no answer at {hz} Hz");
                return Err(InputError::general(message)
                    .with_help("begin the frequencies above zero")
                    .into());
            }
            let by_motion = self.air.on_stations(kappa, x.as_ref()).map(|p| p * Scale(c64::from(q)));
            answer.stations.push(self.loads(&x, omega, &[by_motion, by_gust]));
            answer.excitation.push(excitation);
            answer.modal.push(x.col(0).iter().copied().collect());
        }
        Ok(answer)
    }

    /// Loads of the stations of amplitudes of the modes, and of the air by the motion and by the gust.
    fn loads(&self, x: &Mat<c64>, omega: f64, air: &[Option<Mat<c64>>; 2]) -> Vec<GustLoads<c64>> {
        let of_stations = self.stations.iter().enumerate().map(|(at, station)| {
            let [flexible, gust] = [0, 1].map(|part| {
                let row = |row: usize| air[part].as_ref().map_or(c64::from(0.0), |p| p[(6 * at + row, 0)]);
                std::array::from_fn(row)
            });
            let inertial = std::array::from_fn(|row| {
                let of = |j: usize| x[(j, 0)] * station.inertia[(row, j)];
                (0..x.nrows()).map(of).sum::<c64>() * (omega * omega)
            });
            GustLoads { inertial, flexible, gust }
        });
        of_stations.collect()
    }

    /// Forces on the modes of each part's DAREA; those of extra points act on nothing.
    fn areas(&self, signal: &Signal) -> Vec<Vec<f64>> {
        let modal = &self.modal;
        let of = |area: u32| -> Vec<f64> {
            let mut forces = vec![0.0; modal.omega_rad_s.len()];
            for card in modal.bulk.load_areas.iter().filter(|card| card.set == area) {
                let Some(node) = modal.system.node_index(card.point) else { continue };
                let row = 6 * node + usize::from(card.component.max(1)) - 1;
                for (mode, force) in forces.iter_mut().enumerate() {
                    *force += card.value * modal.shapes[(row, mode)];
                }
            }
            forces
        };
        signal.parts.iter().map(|(_, load)| of(load.area)).collect()
    }
}
