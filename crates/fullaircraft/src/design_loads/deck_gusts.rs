//! Gusts and turbulence of a plan on a user's deck: its modes in unsteady air about the trim of level flight, as SOL 146 has them.
//!
//! Airspeed and attitude towards gravity stay those of level flight; what grows in the deck's own modes is refused.

use crate::deck::gust::waves::GustWaves;
use crate::deck::modal::ModalDeck;
use crate::deck::trim::TrimDeck;
use crate::design_loads::deck::DeckPlan;
use crate::design_loads::deck_motion::{DeckMotion, Spectrum, Wave, rows_of};
use crate::design_loads::fly::{Done, Nodal, refused};
use crate::design_loads::in_time::{AFTER_S, axis_of, unstable_words};
use crate::design_loads::instants::{FlownCase, driving};
use crate::design_loads::search::{gust, searched};
use crate::design_loads::slowest::{GROWS, slowest_words};
use crate::error::AircraftError;
use crate::flight::gust::{Gust, GustAxis};
use crate::package::round_trip::LOADS;
use crate::stations::places::Station;
use aero::Flow;
use coupling::GRAVITY_M_S2;
use faer::{Mat, c64};
use loads::design::Direction;
use loads::matrix::{Action, Case};
use loads::turbulence::Mode;
use nastran::InputError;
use std::f64::consts::{LN_2, PI, TAU};

/// Harmonics of a gust's length that its answer is made of; one minus a cosine has less than a thousandth of itself beyond.
const HARMONICS: f64 = 8.0;
/// Samples while a gust passes a point.
const SAMPLES: f64 = 128.0;
/// Longest time that is flown after a gust, s: two periods of the first elastic mode, at most this.
const LONGEST_AFTER_S: f64 = 3.0;
/// The period of an answer is at first so many times the flight.
const PERIODS: f64 = 3.0;
/// How often it is doubled, if something of the answer is left.
const DOUBLINGS: usize = 6;
/// Share of a load's peak that may be left at the end of the period.
const LEFT: f64 = 2e-3;
/// Net loads smaller than this share of the largest of their kind, the air's among them, are rounding.
const NOTHING: f64 = 1e-6;
/// What is said of a gust that no station shows.
const NO_LOADS: &str = "net loads at all stations are nothing beside the air's, as those of the whole of a free aircraft are: a gust has no load \
                        to be judged by; give the plan stations: [(name: \"root\", y_m: 1.0)], or the deck a MONPNT3 of a part";
/// Peaks count as at least this share of the largest of their kind: what a gust upwards does to the side of an aircraft may go on for ever.
const SMALL: f64 = 1e-2;
/// Poles with less damping than this share of their size are modes that a grid of frequencies is refined around.
const NARROW: f64 = 0.25;
/// A gust's phase turns by so many radians over half of the aircraft between two frequencies of the air.
const TURN_RAD: f64 = 0.7;
/// Fewest and most frequencies of the air.
const FREQUENCIES: [f64; 2] = [16.0, 96.0];
/// Share by which splines of the air over frequency may miss it.
const MISSED: f64 = 0.02;

/// What gusts on a deck are flown with.
#[derive(Debug, Clone, Copy)]
pub struct DeckFlight<'a> {
    /// The deck at the Mach number of the cases.
    pub deck: &'a TrimDeck,
    /// Stations.
    pub stations: &'a [Station],
    /// Whether the worst gradients are searched for between the plan's, where it asks for that.
    pub search: bool,
    /// Whether loads at grids are asked for.
    pub nodal: bool,
    /// All gusts that the plan has in this flow: frequencies and periods are theirs, so that which of them are flown changes no digit.
    pub all: &'a [&'a Case],
}

/// Cases of one flow, model and axis.
pub(super) struct InGusts<'a> {
    pub(super) motion: DeckMotion<'a>,
    pub(super) which: usize,
    pub(super) axis: GustAxis,
    pub(super) v_m_s: f64,
    /// The deck's unit of length, m.
    pub(super) length_m: f64,
    /// Weight of what the deck has of the aircraft, N.
    pub(super) weight_n: f64,
    /// Narrow modes in the flow.
    pub(super) modes: Vec<Mode>,
    /// Which motion takes longest to decay, in words.
    slowest: String,
    /// From the foremost box to the rearmost, m.
    behind_m: f64,
    after_s: f64,
    search: bool,
    /// All cases of the flow and axis.
    all: Vec<&'a Case>,
}

impl DeckPlan {
    /// Whether a case is one of a gust in time or of turbulence.
    pub fn is_in_gusts(case: &Case) -> bool {
        matches!(case.action, Action::Discrete { .. } | Action::Turbulence { .. })
    }

    /// Refuses a deck that says nothing of its modes.
    ///
    /// # Errors
    /// If neither the plan nor a METHOD of the deck says how many modes gusts move.
    pub fn check_modes(&self) -> Result<(), InputError> {
        let is_said = self.units.modes_up_to_hz.is_some()
            || self.subcase.method.is_some()
            || self.bulk.eigen_methods.len() == 1;
        if is_said {
            return Ok(());
        }
        Err(InputError::general("gusts and turbulence move the deck's modes, and nothing says which")
            .with_help("give the highest frequency in the plan, deck: (modes_up_to_hz: 50.0), or a METHOD in the deck"))
    }

    /// Flies the gusts and turbulence of one altitude and airspeed with a model; `done` gets each case, and may stop the rest.
    ///
    /// # Errors
    /// What `done` says. What cannot be flown is a result.
    pub fn fly_in_gusts<E: From<AircraftError>>(
        &self,
        flight: DeckFlight<'_>,
        model: usize,
        cases: &[&Case],
        done: &mut Done<'_, E>,
    ) -> Result<(), E> {
        for axis in [GustAxis::Vertical, GustAxis::Lateral] {
            let own: Vec<&Case> = cases.iter().copied().filter(|case| axis_of(case) == axis).collect();
            if own.is_empty() {
                continue;
            }
            match self.in_gusts(flight, (model, axis), own[0]) {
                Ok(ready) => ready.fly(&own, done)?,
                Err(why) => {
                    own.iter().try_for_each(|case| done(refused(case, model, &why), &|_| None))?;
                }
            }
        }
        Ok(())
    }

    /// The deck about level flight, or why there is none.
    fn in_gusts<'a>(
        &self,
        flight: DeckFlight<'a>,
        (model, axis): (usize, GustAxis),
        first: &Case,
    ) -> Result<InGusts<'a>, String> {
        let all: Vec<&Case> = flight.all.iter().copied().filter(|case| axis_of(case) == axis).collect();
        let level = self.fly(flight.deck, first, model, flight.stations);
        let (Some(instant), Some(nodal)) = (level.case.instants.first(), level.nodal) else {
            return Err(level.case.refused.unwrap_or_default());
        };
        let v_m_s = first.v_m_s;
        let length_m = self.units.length_m;
        let highest_rad_s = all.iter().map(|case| highest_rad_s(case)).fold(0.0, f64::max);
        let direction = if axis == GustAxis::Lateral { [0.0, -1.0, 0.0] } else { [0.0, 0.0, 1.0] };
        let v = v_m_s / length_m;
        let q = self.dynamic_pressure(first);
        let flow = Flow { v_m_s: v, rho_kg_m3: 2.0 * q / (v * v) };
        let kappa = frequencies_of_air(highest_rad_s / v, half_length(flight.deck));
        let made = || -> Result<(GustWaves, Vec<usize>), AircraftError> {
            let modal = self.modal(model, first.mach, &kappa)?;
            let s_dofs = if flight.nodal { modal.spline.used_dofs() } else { Vec::new() };
            let rows = rows_of(&modal, flight.stations, &s_dofs);
            let waves = GustWaves::new(modal, rows.as_ref(), (flow, first.mach), highest_rad_s, direction)?;
            Ok((waves, s_dofs))
        };
        let (waves, s_dofs) = made().map_err(|error| error.to_string())?;
        if waves.missed() > MISSED {
            return Err(format!(
                "the air of this deck turns too fast with frequency: between {} frequencies up to {:.1} Hz it is known within {:.0} % \
                 only (at most {:.0} %); fly longer gradients, or a lower cut-off",
                kappa.len(),
                highest_rad_s / TAU,
                100.0 * waves.missed(),
                100.0 * MISSED
            ));
        }
        let roots = waves.roots().map_err(|error| error.to_string())?;
        let modes = stable(&roots).map_err(unstable_words)?;
        let slowest = waves.modal.omega_rad_s.iter().copied().filter(|omega| *omega > 0.0);
        let after_s = (2.0 * TAU / slowest.fold(f64::INFINITY, f64::min)).clamp(AFTER_S, LONGEST_AFTER_S);
        let weight_n = flight.deck.grids.mass * self.units.force_n / length_m * GRAVITY_M_S2;
        let level = (instant.loads.clone(), nodal);
        let motion = DeckMotion::new(waves, flight.stations, s_dofs, self.unit_loads(), level);
        Ok(InGusts {
            behind_m: 2.0 * half_length(flight.deck) * length_m,
            which: model,
            search: flight.search,
            motion,
            axis,
            v_m_s,
            length_m,
            weight_n,
            after_s,
            modes,
            slowest: slowest_words(&roots),
            all,
        })
    }

    /// The deck's modes with the air's frequencies (omega/V) of a Mach number.
    fn modal(&self, model: usize, mach: f64, kappa: &[f64]) -> Result<ModalDeck, AircraftError> {
        let (bulk, subcase) = self.moved(model, mach, kappa)?;
        let modal = ModalDeck::new(&bulk, &subcase, "the answer to a gust")?;
        let Some(damper) = modal.dampers.first() else { return Ok(modal) };
        let message = format!("{}: loads of stations in gusts would be without its forces", damper.owner);
        Err(InputError::at(&damper.span, message).with_help("damp modes by SDAMPING").into())
    }
}

/// The narrow modes among roots, or how long the fastest growing takes to double, s.
fn stable(roots: &[c64]) -> Result<Vec<Mode>, f64> {
    let zero = GROWS * roots.iter().map(|p| p.norm()).fold(0.0, f64::max);
    let growing = roots.iter().filter(|p| p.norm() > zero && p.re > GROWS * p.norm());
    let fastest = growing.map(|p| p.re).fold(0.0, f64::max);
    if fastest > 0.0 {
        return Err(LN_2 / fastest);
    }
    let narrow = roots.iter().filter(|p| p.im > 0.0 && -p.re < NARROW * p.im);
    Ok(narrow.map(|p| Mode { omega_rad_s: p.im, decay_rad_s: -p.re }).collect())
}

/// The highest frequency that a case needs, rad/s.
fn highest_rad_s(case: &Case) -> f64 {
    match case.action {
        Action::Turbulence { cut_off_hz, .. } => TAU * cut_off_hz,
        Action::Discrete { gradient_m, .. } => HARMONICS * PI * case.v_m_s / gradient_m,
        _ => 0.0,
    }
}

/// Half of the way from the foremost to the rearmost box.
fn half_length(deck: &TrimDeck) -> f64 {
    let places = deck.lattice.boxes.iter().map(|panel| panel.three_quarter_point().x);
    let (low, high) =
        places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    0.5 * (high - low)
}

/// Frequencies omega/V at which the air is solved: closer towards rest, and close enough for a gust's phase.
fn frequencies_of_air(highest: f64, half_length: f64) -> Vec<f64> {
    let [fewest, most] = FREQUENCIES;
    let count = (1.5 * highest * half_length / TURN_RAD).ceil().clamp(fewest, most);
    let mut all = Vec::new();
    let mut at = 1.0;
    while at <= count {
        all.push(highest * (at / count).powf(1.5));
        at += 1.0;
    }
    all
}

impl InGusts<'_> {
    fn fly<E: From<AircraftError>>(&self, cases: &[&Case], done: &mut Done<'_, E>) -> Result<(), E> {
        let (rough, single): (Vec<&Case>, Vec<&Case>) =
            cases.iter().copied().partition(|case| matches!(case.action, Action::Turbulence { .. }));
        for case in rough {
            self.rough(case, done)?;
        }
        if single.is_empty() {
            return Ok(());
        }
        let lasting = match self.lasting() {
            Ok(lasting) => lasting,
            Err(why) => {
                return single.iter().try_for_each(|case| done(refused(case, self.which, &why), &|_| None));
            }
        };
        for direction in [Direction::Up, Direction::Down, Direction::Lateral] {
            let own = |case: &&&Case| matches!(case.action, Action::Discrete { direction: own, .. } if own == direction);
            let is_searched =
                |case: &&Case| self.search && matches!(case.action, Action::Discrete { refine: true, .. });
            let (family, alone): (Vec<&Case>, Vec<&Case>) =
                single.iter().filter(own).copied().partition(is_searched);
            for case in alone {
                let Some(gust_of) = gust(case, None) else { continue };
                let flown = self.one(&lasting, case.number, &gust_of);
                let nodal: &Nodal<'_> = &|instant| {
                    let gust_of = gust(case, instant.gradient_m)?;
                    let changes = lasting.in_time(&self.wave(&gust_of), &[instant.t_s]);
                    Some(self.motion.nodal(&changes, 0))
                };
                done(flown, nodal)?;
            }
            let spectrum = &lasting;
            let fly = &mut |gusts: &[(usize, Gust)]| {
                let one =
                    |(number, gust): &(usize, Gust)| (self.one(spectrum, *number, gust), 0.5 * gust.length_m);
                Ok::<_, E>(gusts.iter().map(one).collect())
            };
            for flown in searched(&family, self.axis, fly)? {
                done(flown, &|_| None)?;
            }
        }
        Ok(())
    }

    /// How long a gust is flown, s.
    fn flight_s(&self, gust: &Gust) -> f64 {
        (gust.length_m + self.behind_m) / self.v_m_s + self.after_s
    }

    fn wave(&self, gust: &Gust) -> Wave {
        Wave {
            velocity: gust.velocity_m_s / self.length_m,
            lasts_s: gust.length_m / self.v_m_s,
            harmonics: HARMONICS,
        }
    }

    /// Answers over frequency whose period is long enough for all gusts to die away, or why there are none.
    fn lasting(&self) -> Result<Spectrum, String> {
        let cases: Vec<&Case> =
            self.all.iter().copied().filter(|case| matches!(case.action, Action::Discrete { .. })).collect();
        let mut gusts: Vec<Gust> = cases.iter().filter_map(|case| gust(case, None)).collect();
        gusts.sort_by(|a, b| a.length_m.total_cmp(&b.length_m));
        gusts.dedup_by(|a, b| a.length_m == b.length_m);
        let longest_s = gusts.iter().map(|gust| self.flight_s(gust)).fold(0.0, f64::max);
        let highest = cases.iter().map(|case| highest_rad_s(case)).fold(0.0, f64::max);
        let mut period_s = PERIODS * longest_s.max(f64::MIN_POSITIVE);
        let mut left = (0.0, 0);
        for _ in 0..=DOUBLINGS {
            let step = TAU / period_s;
            let omega = std::iter::successors(Some(0.5 * step), |omega| Some(omega + step));
            let omega: Vec<f64> = omega.take_while(|omega| *omega <= highest).collect();
            let spectrum = self.motion.spectrum(omega).map_err(|error| error.to_string())?;
            let all: Option<Vec<_>> = gusts.iter().map(|gust| self.left(&spectrum, gust, period_s)).collect();
            left = all
                .ok_or(NO_LOADS)?
                .into_iter()
                .fold((0.0, 0), |most, one| if one.0 > most.0 { one } else { most });
            if left.0 <= LEFT {
                return Ok(spectrum);
            }
            period_s *= 2.0;
        }
        Err(format!(
            "{:.1} % of {} at {} is left {:.0} s after a gust; {}",
            100.0 * left.0,
            LOADS[left.1 % 6],
            self.motion.stations[left.1 / 6].name,
            0.5 * period_s,
            self.slowest
        ))
    }

    /// The most that is left of one of a gust's net loads at the end of the period, share of its peak, and which; none where all of them are
    /// nothing beside the air's, as at the whole of a free aircraft.
    fn left(&self, spectrum: &Spectrum, gust: &Gust, period_s: f64) -> Option<(f64, usize)> {
        let peaks = |t_s: &[f64]| -> [Vec<f64>; 2] {
            let most = |all: Mat<f64>| {
                all.row_iter()
                    .map(|row| row.iter().fold(0.0_f64, |most, load| most.max(load.abs())))
                    .collect()
            };
            spectrum.net_and_air_in_time(&self.wave(gust), t_s).map(most)
        };
        let ends: Vec<f64> = (0..64).map(|at| period_s * (0.95 + 0.05 / 64.0 * f64::from(at))).collect();
        let flown: Vec<f64> = self.times(gust).into_iter().step_by(4).collect();
        let ([largest, air], [last, _]) = (peaks(&flown), peaks(&ends));
        let of_kind = |of: &[f64], kind: usize| {
            let own = of.iter().enumerate().filter(|(at, _)| at % 6 / 3 == kind);
            own.map(|(_, value)| *value).fold(0.0, f64::max)
        };
        let kinds = [0, 1].map(|kind| of_kind(&largest, kind).max(of_kind(&air, kind)));
        let moves = |at: &usize| largest[*at] > NOTHING * kinds[at % 6 / 3];
        let share = |at: usize| (last[at] / largest[at].max(SMALL * kinds[at % 6 / 3]), at);
        (0..largest.len())
            .filter(moves)
            .map(share)
            .reduce(|most, one| if one.0 > most.0 { one } else { most })
    }

    fn times(&self, gust: &Gust) -> Vec<f64> {
        let step = gust.length_m / self.v_m_s / SAMPLES;
        let lasts = self.flight_s(gust);
        std::iter::successors(Some(0.0), |t| Some(t + step)).take_while(|t| *t <= lasts).collect()
    }

    /// A gust by the instants that can drive a load.
    fn one(&self, spectrum: &Spectrum, number: usize, gust: &Gust) -> FlownCase {
        let t_s = self.times(gust);
        let change = spectrum.net_in_time(&self.wave(gust), &t_s);
        let net = |station: usize, sample: usize| {
            let level = self.motion.level(station);
            std::array::from_fn(|load| level[load] + change[(6 * station + load, sample)])
        };
        let driving = driving(&net, self.motion.stations.len(), t_s.len(), self.axis);
        let at_s: Vec<f64> = driving.into_iter().map(|sample| t_s[sample]).collect();
        let changes = spectrum.in_time(&self.wave(gust), &at_s);
        let instants =
            at_s.iter().enumerate().map(|(at, t_s)| self.motion.instant(&changes, *t_s, at)).collect();
        FlownCase { number, model: self.which, instants, ..FlownCase::default() }.if_finite()
    }
}

#[cfg(test)]
mod tests;
