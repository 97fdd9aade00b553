//! A plan of design loads on a user's deck: its trims at each airspeed, altitude and load factor, as loads at stations and grids.
//!
//! A TRIM card of the deck is level flight. A case of load factor n has its variables, but n times its URDD3 and, where the card gives
//! PITCH, the rate `(n - 1) g/V` of a steady pull-up beside it, `q c/(2 V)` of the reference chord. Dynamic pressure and Mach number are
//! the case's. Gusts in time and turbulence change level flight by the deck's modes (`deck_gusts`). A half model (SYMXZ 1) has half of the mass and of the area of the aircraft.

use crate::cases::file::{Action as Own, CasesFile, DeckUnits};
use crate::deck::cases::{DeckCase, deck_cases};
use crate::deck::trim::{TrimDeck, TrimmedDeck};
use crate::design_loads::instants::{FlownCase, FlownInstant};
use crate::error::AircraftError;
use crate::stations::nodal::{Component, NodalLoads};
use crate::stations::places::Station;
use crate::trim::maneuvers::Steady;
use coupling::GRAVITY_M_S2;
use loads::design::Direction;
use loads::matrix::{Action, Case};
use loads::{Air, Airframe};
use nalgebra::{Matrix3, Point3};
use nastran::{Aero, BulkData, EigenMethod, InputError, Mkaero, Subcase, Trim};
use std::collections::BTreeMap;

/// The acceleration of level flight.
const ACCELERATION: &str = "URDD3";
/// The pitch rate.
const PITCH: &str = "PITCH";
/// Share by which the card's acceleration may differ from gravity: decks have it with three or four digits.
const LEVEL_WITHIN: f64 = 5e-3;
/// Matrices that correct the air of a deck.
const CORRECTIONS: [&str; 2] = ["WKK", "FA2J"];

/// A deck that a plan is flown on.
#[derive(Debug, Clone)]
pub struct DeckPlan {
    /// The deck as the level trim's subcase selects it.
    pub bulk: BulkData,
    /// MPC of the subcase.
    pub equations: Option<u32>,
    /// Units.
    pub units: DeckUnits,
    pub(super) subcase: Subcase,
    level: Trim,
}

/// A case flown on a deck.
#[derive(Debug, Clone, Default)]
pub struct DeckFlown {
    /// Loads at stations, N and N m.
    pub case: FlownCase,
    /// Loads at grids in the deck's units; none if the case could not be trimmed.
    pub nodal: Option<NodalLoads>,
    /// The air's loads of each MONPNT1, N and N m.
    pub air: BTreeMap<String, [f64; 6]>,
    /// Trim variables, in the deck's units.
    pub values: BTreeMap<String, f64>,
}

impl DeckPlan {
    /// The deck with the units of a plan.
    ///
    /// # Errors
    /// If the deck has no trim of that number, or that is no level flight.
    pub fn new(deck: &BulkData, units: DeckUnits) -> Result<Self, InputError> {
        let cases = deck_cases(deck)?;
        let asked = |case: &&DeckCase| units.trim.is_none_or(|id| case.trim.id == id);
        let DeckCase { subcase, trim: level } = cases.iter().find(asked).cloned().ok_or_else(|| {
            let numbers: Vec<String> = cases.iter().map(|case| case.trim.id.to_string()).collect();
            InputError::general("the deck has no TRIM of the number that the plan calls level flight")
                .with_help(format!("there are {}", numbers.join(", ")))
        })?;
        let bulk = in_one_set(deck.in_subcase(&subcase)?);
        let a_units = bulk.parameters.get("AUNITS").copied().unwrap_or(1.0);
        let given =
            level.fixed.iter().find(|(name, _)| name == ACCELERATION).map(|(_, value)| value / a_units);
        let g = GRAVITY_M_S2 / units.length_m;
        if !given.is_some_and(|given| (given.abs() / g - 1.0).abs() < LEVEL_WITHIN) {
            let said = given.map_or_else(|| "none".to_owned(), |given| given.to_string());
            let message = format!(
                "TRIM {} is not level flight: its {ACCELERATION} makes an acceleration of {said}, and gravity is {g:.4} in lengths of \
                 {} m",
                level.id, units.length_m
            );
            return Err(InputError::at(&level.span, message)
                .with_help("name the TRIM of level flight and the deck's unit of length in the plan: deck: (length_m: 0.3048, trim: 1)"));
        }
        Ok(Self { bulk, equations: subcase.mpc, units, subcase, level })
    }

    /// The deck for one Mach number, by model: 0 without its corrections (WKK and FA2J), 1 as it is.
    ///
    /// # Errors
    /// As [`TrimDeck::new`].
    pub fn at(&self, model: usize, mach: f64) -> Result<TrimDeck, AircraftError> {
        TrimDeck::new(&self.of_model(model), mach)
    }

    /// Whether it has corrections of its air, so that its two models may differ.
    pub fn is_corrected(&self) -> bool {
        CORRECTIONS.iter().any(|name| self.bulk.matrices.contains_key(*name))
    }

    fn of_model(&self, model: usize) -> BulkData {
        let mut bulk = self.bulk.clone();
        if model == 0 {
            bulk.matrices.retain(|name, _| !CORRECTIONS.contains(&name.as_str()));
        }
        bulk
    }

    /// The deck of a model with what its modes in unsteady air need: references as its AEROS has them, reduced frequencies by
    /// `kappa` (omega/V) at a Mach number, modes as the plan or the deck asks for.
    ///
    /// # Errors
    /// If it has no AEROS.
    pub(super) fn moved(
        &self,
        model: usize,
        mach: f64,
        kappa: &[f64],
    ) -> Result<(BulkData, Subcase), InputError> {
        let (mut bulk, mut subcase) = (self.of_model(model), self.subcase.clone());
        let missing = || InputError::general("the deck has no AEROS, which its air needs");
        let aeros = bulk.aero_reference.clone().ok_or_else(missing)?;
        let (chord, span) = (aeros.chord, aeros.span);
        bulk.unsteady_reference = Some(Aero {
            acsid: aeros.acsid,
            velocity: None,
            chord,
            density: 0.0,
            symmetry: aeros.symmetry,
            span: span.clone(),
        });
        let pairs = kappa.iter().map(|kappa| (mach, 0.5 * kappa * chord)).collect();
        bulk.reduced_frequencies = vec![Mkaero { pairs, span: span.clone() }];
        if let Some(hz) = self.units.modes_up_to_hz {
            let id = bulk.eigen_methods.keys().max().map_or(1, |last| last + 1);
            bulk.eigen_methods.insert(id, EigenMethod { id, highest_hz: Some(hz), count: None, span });
            subcase.method = Some(id);
        }
        Ok((bulk, subcase))
    }

    /// Dynamic pressure of a case, the deck's unit.
    pub(super) fn dynamic_pressure(&self, case: &Case) -> f64 {
        let DeckUnits { length_m, force_n, .. } = self.units;
        0.5 * Air::at(case.h_m).rho_kg_m3 * case.v_m_s * case.v_m_s * length_m * length_m / force_n
    }

    /// One unit of force and of moment of the deck, N and N m.
    pub fn unit_loads(&self) -> [f64; 2] {
        [self.units.force_n, self.units.force_n * self.units.length_m]
    }

    /// How many times the deck the aircraft is: twice a half model.
    fn times(&self) -> f64 {
        let symmetry = self.bulk.aero_reference.as_ref().map_or(0, |aeros| aeros.symmetry);
        if symmetry == 0 { 1.0 } else { 2.0 }
    }

    /// Mass of the whole aircraft, kg.
    pub fn mass_kg(&self, deck: &TrimDeck) -> f64 {
        // a force by a length over a time squared; seconds are seconds
        self.times() * deck.grids.mass * self.units.force_n / self.units.length_m
    }

    /// What rules know of it: area, reference chord, and the rigid deck's slope of lift.
    ///
    /// # Errors
    /// If the deck has no angle of attack.
    pub fn airframe(&self, deck: &TrimDeck) -> Result<Airframe, InputError> {
        let lift_slope_per_rad = deck.lift_slope().ok_or_else(|| {
            InputError::general("the deck has no ANGLEA").with_help("add an AESTAT card for ANGLEA")
        })?;
        let length_m = self.units.length_m;
        Ok(Airframe {
            area_m2: self.times() * deck.aeros().area * length_m * length_m,
            mean_chord_m: deck.aeros().chord * length_m,
            lift_slope_per_rad,
        })
    }

    /// MONPNT3 of the deck, what is outboard (to the right) of the plan's stations, and the whole; in the deck's unit of length.
    ///
    /// # Errors
    /// If two have a name, or one has nothing outboard of it.
    pub fn stations(&self, deck: &TrimDeck, file: &CasesFile) -> Result<Vec<Station>, InputError> {
        let grids = &deck.grids;
        let points = grids.free.points();
        let node = grids.support.as_ref().and_then(|(grid, _)| grids.free.node_index(*grid)).unwrap_or(0);
        let about = points[node];
        let mut all = grids.monitored(&self.bulk)?;
        for at in &file.stations {
            let place = |given: Option<f64>, or: f64| given.map_or(or, |metres| metres / self.units.length_m);
            let y = at.y_m / self.units.length_m;
            let nodes: Vec<usize> = (0..points.len()).filter(|node| points[*node].y > y).collect();
            if nodes.is_empty() {
                let message = format!("station {} has no grid outboard of y = {} m", at.name, at.y_m);
                return Err(InputError::in_field(&file.path, "stations", message)
                    .with_help("expected a y inside the right tip; the plan's lengths are metres"));
            }
            let point = Point3::new(place(at.x_m, about.x), y, place(at.z_m, about.z));
            all.push(station(&at.name, point, nodes));
        }
        all.push(station("whole", about, (0..points.len()).collect()));
        for (at, one) in all.iter().enumerate() {
            if all[..at].iter().any(|other| other.name == one.name) {
                let message = format!("two stations are called {}", one.name);
                return Err(InputError::in_field(&file.path, "stations", message)
                    .with_help("the deck's MONPNT3 and the plan's stations need names of their own"));
            }
        }
        Ok(all)
    }

    /// Why a case is not flown on a deck, if it is not.
    pub fn left_out(&self, case: &Case, maneuvers: &[Own]) -> Option<&'static str> {
        match case.action {
            Action::Condition(place) => match &maneuvers[place] {
                Own::Steady(Steady::Level | Steady::Pull { .. }) => None,
                Own::Steady(_) => Some("of maneuvers a deck flies level flight and pull-ups only"),
                Own::Motion(_) => Some("a deck is flown in gusts, and not in maneuvers in time"),
            },
            Action::Discrete { direction: Direction::Lateral, .. }
            | Action::Turbulence { direction: Direction::Lateral, .. }
                if self.times() > 1.0 =>
            {
                Some("half of an aircraft meets no gust from the side")
            }
            Action::Trim | Action::Discrete { .. } | Action::Turbulence { .. } => None,
        }
    }

    /// Trims a case; what cannot be trimmed is a result.
    pub fn fly(&self, deck: &TrimDeck, case: &Case, model: usize, stations: &[Station]) -> DeckFlown {
        let refused = |error: &AircraftError| DeckFlown {
            case: FlownCase {
                number: case.number,
                model,
                refused: Some(error.to_string()),
                ..FlownCase::default()
            },
            ..DeckFlown::default()
        };
        match deck.trim_card(&self.card(case, deck.aeros().chord)) {
            Ok(trimmed) => self.flown(deck, (case.number, model), &trimmed, stations),
            Err(error) => refused(&error),
        }
    }

    /// The TRIM card of a case.
    fn card(&self, case: &Case, chord: f64) -> Trim {
        let length_m = self.units.length_m;
        let rate = (case.n_z - 1.0) * GRAVITY_M_S2 / case.v_m_s;
        let pitch = rate * chord * length_m / (2.0 * case.v_m_s);
        let of_case = |(name, value): &(String, f64)| {
            let value = match name.as_str() {
                ACCELERATION => case.n_z * value,
                PITCH => value + pitch,
                _ => *value,
            };
            (name.clone(), value)
        };
        Trim {
            mach: case.mach,
            q: self.dynamic_pressure(case),
            fixed: self.level.fixed.iter().map(of_case).collect(),
            ..self.level.clone()
        }
    }

    /// Loads at grids (the deck's units, at its points) added up at stations by component, N and N m.
    pub fn at_stations(
        &self,
        nodal: &NodalLoads,
        stations: &[Station],
        points: &[Point3<f64>],
    ) -> Vec<[[f64; 6]; 5]> {
        let units = self.unit_loads();
        let parts = Component::ALL.map(|component| nodal.of(component));
        let in_si = |six: [f64; 6]| std::array::from_fn(|load| six[load] * units[load / 3]);
        let sums = |station: &Station| std::array::from_fn(|part| in_si(station.sums(points, &parts[part])));
        stations.iter().map(sums).collect()
    }

    fn flown(
        &self,
        deck: &TrimDeck,
        (number, model): (usize, usize),
        trimmed: &TrimmedDeck,
        stations: &[Station],
    ) -> DeckFlown {
        let nodal = deck.nodal_loads(trimmed);
        let points = deck.grids.free.points();
        let units = self.unit_loads();
        let in_si = |six: [f64; 6]| std::array::from_fn(|load| six[load] * units[load / 3]);
        let instant = FlownInstant {
            t_s: 0.0,
            tips_m: [0.0; 2],
            gradient_m: None,
            limit: None,
            loads: self.at_stations(&nodal, stations, points),
        };
        let of_air = |card: &&nastran::MonitorPoint| !card.is_structural;
        let names = self.bulk.monitors.iter().filter(of_air).map(|card| &card.name);
        let air =
            names.filter_map(|name| Some((name.clone(), in_si(*trimmed.monitors.get(name)?)))).collect();
        let case = FlownCase { number, model, instants: vec![instant], ..FlownCase::default() };
        DeckFlown { case, nodal: Some(nodal), air, values: trimmed.values.clone() }
    }
}

/// The sets that an SPCADD or MPCADD unites as one of its number: structures are written without the cards that unite.
fn in_one_set(mut bulk: BulkData) -> BulkData {
    if let Some((united, _)) = bulk.constraint_unions.pop_first() {
        bulk.constraints.iter_mut().for_each(|card| card.set = united);
    }
    if let Some((united, _)) = bulk.equation_unions.pop_first() {
        bulk.equations.iter_mut().for_each(|card| card.set = united);
    }
    bulk
}

fn station(name: &str, point: Point3<f64>, nodes: Vec<usize>) -> Station {
    Station { name: name.to_owned(), channel: name.to_owned(), point, nodes, axes: Matrix3::identity() }
}
