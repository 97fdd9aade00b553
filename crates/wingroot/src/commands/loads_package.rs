//! The package for stress: cards of the selected instants, the structure they belong to, an index, HDF5, and their round trip,
//! which is made before anything is written.

use std::fmt::Write as _;

use fullaircraft::design_loads::in_time::axis_of;
use fullaircraft::design_loads::instants::FlownInstant;
use fullaircraft::package::cards::{CardCase, CardPart, index, structure};
use fullaircraft::package::round_trip::{Expected, LOADS, RoundTrip, Row, round_trip_csv};
use fullaircraft::{Component, NodalLoads, Station};
use loads::Selection;
use loads::matrix::Case;
use loads::select::Selected;
use loads::select::file::{Component as Exported, ExportAt, Model, SelectFile};
use nastran::InputError;

use crate::commands::fullaircraft_prepared::Prepared;
use crate::commands::loads_flights::{Flights, Flown, FlownAgain, Wanted, is_in_time};
use crate::commands::loads_result::RoundTripResult;
use crate::commands::loads_tables::{case_of, words};
use crate::failure::Failure;
use crate::fingerprint::Fingerprint;
use crate::hdf5::{self, Group, Values};
use crate::version::VERSION;

/// A package in memory.
pub(crate) struct Packed {
    /// Name and bytes of each file.
    pub(crate) files: Vec<(String, Vec<u8>)>,
    /// How well the cards give back what was flown.
    pub(crate) round_trip: RoundTripResult,
}

/// A selected instant on cards, and what the solver says of it.
struct Card {
    case: CardCase,
    text: String,
    expected: Expected,
    /// How far a trim's own tips are from those of its loads on the structure, over what each load does to them.
    trim_tip: f64,
    /// How far these sums are from the first flight's loads at stations.
    repeat: f64,
    /// The instant, with the sums of the nodal loads that are on the cards.
    flown: FlownInstant,
    origin: Vec<String>,
}

/// Most that loads at stations of a case flown again may differ from the first flight's: they are
/// sums of other numbers, and with thin shells differ by 2e-7.
const REPEAT: f64 = 1e-6;

/// What is asked for where the air's loads are a set apart from all others.
const PARTS: [Exported; 2] = [Exported::Air, Exported::Inertia];

/// Makes the package.
///
/// # Errors
/// If cards read back do not give the loads that were flown.
pub(crate) fn package(
    prepared: &Prepared,
    flights: &Flights<'_>,
    flown: &Flown,
    select: &SelectFile,
    selection: &Selection,
) -> Result<Packed, Failure> {
    refuse_unwritten(select)?;
    let aircraft = &prepared.aircraft;
    let common = origin(prepared, flights)?;
    let wanted = |one: &Selected| {
        let (model, number, instant) = (usize::from(one.model == Model::Updated), one.case, one.instant - 1);
        let first = flown.case(model, number).and_then(|case| case.instants.get(instant));
        let first = first.ok_or_else(|| lost(number))?;
        Ok(Wanted { model, number, instant, flown: first })
    };
    let wanted = selection.selected.iter().map(wanted).collect::<Result<Vec<Wanted<'_>>, Failure>>()?;
    let again = flights.again(&wanted)?;
    let deck = structure(aircraft, &common);
    let back = RoundTrip::new(aircraft, &flights.stations, &deck)?;
    let (mut cards, mut rows) = (Vec::new(), Vec::new());
    let last = selection.selected.iter().map(|one| one.sid).max().unwrap_or(0);
    for (one, again) in selection.selected.iter().zip(&again) {
        let mut card = card(one, again, flights, flown, &common, &back)?;
        if select.export.components == PARTS {
            card.part(&again.nodal, last, flights);
        }
        rows.extend(back.compare(&card.case, &card.text, &card.expected)?);
        cards.push(card);
    }
    if let Some(row) = rows.iter().find(|row| !row.holds()) {
        return Err(Failure::Computation(format!(
            "the round trip failed: load set {}, {} {}: {} flown, {} by the cards ({:.1e} of the largest); no package is written",
            row.sid, row.place, row.what, row.solver, row.cards, row.of_largest
        )));
    }
    let most = |of: fn(&Card) -> f64| cards.iter().map(of).fold(0.0, f64::max);
    let (trim_tip, repeat) = (most(|card| card.trim_tip), most(|card| card.repeat));
    if repeat > REPEAT {
        return Err(Failure::Computation(format!(
            "nodal loads of cases flown again differ at stations by {repeat:.1e} of the largest load (at most {REPEAT:.0e}); no package is \
             written"
        )));
    }
    let mut files = vec![("aircraft.bdf".to_owned(), deck.into_bytes())];
    let cases: Vec<CardCase> = cards.iter().map(|card| card.case.clone()).collect();
    let title = format!("Design loads: {}", flights.plan.name);
    files.push(("index.bdf".to_owned(), index(aircraft, &title, &cases, &common).into_bytes()));
    files.push(("index.csv".to_owned(), index_csv(&cards, &common, select.export.factor).into_bytes()));
    files.push((
        "station_loads.csv".to_owned(),
        stations_csv(selection, flights, &cards, &common).into_bytes(),
    ));
    files.push(("round_trip.csv".to_owned(), (comment(&common) + &round_trip_csv(&rows)).into_bytes()));
    files.push(("README.md".to_owned(), readme(&common, cards.len()).into_bytes()));
    files.push(("loads.h5".to_owned(), hdf5_file(prepared, flights, &cards, &common)?));
    files.extend(cards.into_iter().map(|card| (card.case.file(), card.text.into_bytes())));
    Ok(Packed { files, round_trip: RoundTripResult { trim_tip, repeat, ..worst(&rows) } })
}

/// What a selection can ask for and is not written.
fn refuse_unwritten(select: &SelectFile) -> Result<(), InputError> {
    let known = [&[Exported::Net][..], &PARTS];
    if select.export.at == ExportAt::Grids && known.contains(&&select.export.components[..]) {
        return Ok(());
    }
    let message = "cards are written at grids, as net loads or as those of the air with all others apart";
    Err(InputError::in_field(&select.path, "export", message)
        .with_help("write export: (at: Grids, components: [Net]) or [Air, Inertia], or leave both out"))
}

/// Program, plan and fingerprints of everything that was read.
fn origin(prepared: &Prepared, flights: &Flights<'_>) -> Result<Vec<String>, Failure> {
    let mut lines = vec![format!("wingroot {VERSION}, loads"), format!("plan \"{}\"", flights.plan.name)];
    for (what, path) in &prepared.inputs {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let print = if path.is_file() {
            Fingerprint::of_file(path).map_err(|error| InputError::in_file(path, error.to_string()))?
        } else {
            Fingerprint::default()
        };
        lines.push(format!("{what} {name} {print}"));
    }
    lines.push(format!("wing with all its files {}", prepared.aircraft.wing.hash));
    let corrections = format!("{:?}", prepared.corrections);
    lines.push(format!("corrections of boxes {}", Fingerprint::default().with(corrections.as_bytes())));
    lines.push("N, N m, m; basic axes x aft, y right, z up".to_owned());
    Ok(lines)
}

fn card(
    one: &Selected,
    again: &FlownAgain,
    flights: &Flights<'_>,
    flown: &Flown,
    common: &[String],
    back: &RoundTrip<'_>,
) -> Result<Card, Failure> {
    let tips = back.tips();
    let FlownAgain { model, number, instant, .. } = *again;
    let case = case_of(flights.matrix, number).ok_or_else(|| lost(number))?;
    let first = flown.case(model, number).and_then(|case| case.instants.get(instant));
    let first = first.ok_or_else(|| lost(number))?;
    let parts = Component::ALL.map(|component| again.nodal.of(component));
    let sums = |station: &Station| std::array::from_fn(|part| station.sums(back.points(), &parts[part]));
    let flown = FlownInstant { loads: flights.stations.iter().map(sums).collect(), ..first.clone() };
    let mass = &flights.design.masses[case.mass].name;
    let net = again.nodal.of(Component::Net);
    let does = |side: usize| net.iter().enumerate().map(move |(dof, load)| tips[(dof, side)] * load);
    let tips_m = [0, 1].map(|side| does(side).sum::<f64>());
    let off = |side: usize| (flown.tips_m[side] - tips_m[side]).abs() / does(side).map(f64::abs).sum::<f64>();
    let trim_tip = if is_in_time(case, &flights.maneuvers) { 0.0 } else { off(0).max(off(1)) };
    let title = format!("case {number} {}, {:.1} m/s, n {:.2}, {mass}", case.condition, case.v_m_s, case.n_z);
    let mut origin = common.to_vec();
    origin.push(format!(
        "{}; mass {mass}; model {}; instant {} {}",
        words(case),
        one.model.name(),
        one.instant,
        moment(flights, case, &flown)
    ));
    let card = CardCase { sid: one.sid, words: title, net, parts: Vec::new() };
    let text = card.text(&flights.grids, &origin);
    Ok(Card {
        case: card,
        text,
        repeat: repeat(&first.net(), &flown.net()),
        expected: Expected { stations: flown.net(), tips_m },
        flown,
        trim_tip,
        origin,
    })
}

/// When an instant is, or which load is at its limit in it.
fn moment(flights: &Flights<'_>, case: &Case, flown: &FlownInstant) -> String {
    let names = || flights.stations.iter().map(|station| station.name.clone()).collect::<Vec<String>>();
    match (flown.limit, flown.gradient_m) {
        (Some(limit), _) => {
            format!(
                "with {} at its limit, and the loads that go with it",
                limit.words(axis_of(case), &names())
            )
        }
        (None, Some(gradient_m)) => format!("at {} s, gradient {gradient_m:.2} m", flown.t_s),
        (None, None) => format!("at {} s", flown.t_s),
    }
}

fn lost(number: usize) -> Failure {
    Failure::Computation(format!("case {number} was selected and is not there"))
}

impl Card {
    /// Parts the case in the air's loads and all others, whose sets are numbered beyond those of the cases.
    fn part(&mut self, nodal: &NodalLoads, last: u32, flights: &Flights<'_>) {
        let air = nodal.of(Component::Air);
        let rest = self.case.net.iter().zip(&air).map(|(net, air)| net - air).collect();
        let beyond = |part: u32| last + 2 * (self.case.sid - 1) + part;
        self.case.parts = vec![
            CardPart { sid: beyond(1), words: "air", loads: air },
            CardPart { sid: beyond(2), words: "inertia, gravity, thrust and damping", loads: rest },
        ];
        self.text = self.case.text(&flights.grids, &self.origin);
    }
}

/// Largest difference of two flights' loads at stations, as a share of the largest force or moment.
fn repeat(first: &[[f64; 6]], again: &[[f64; 6]]) -> f64 {
    let of_kind = |from: usize| {
        let pairs =
            || first.iter().zip(again).flat_map(|(a, b)| a[from..from + 3].iter().zip(&b[from..from + 3]));
        let largest = pairs().fold(0.0_f64, |most, (a, _)| most.max(a.abs()));
        pairs().fold(0.0_f64, |most, (a, b)| most.max((a - b).abs())) / largest.max(f64::MIN_POSITIVE)
    };
    of_kind(0).max(of_kind(3))
}

fn worst(rows: &[Row]) -> RoundTripResult {
    let most = |of: &dyn Fn(&Row) -> bool| {
        rows.iter().filter(|row| of(row)).map(|row| row.of_largest).fold(0.0, f64::max)
    };
    let is_tip = |row: &Row| row.what == "deflection_m";
    RoundTripResult {
        stations: most(&|row| !is_tip(row) && !["balance", "structure"].contains(&row.place.as_str())),
        balance: most(&|row| row.place == "balance"),
        tip: most(&is_tip),
        structure: most(&|row| row.place == "structure"),
        trim_tip: 0.0,
        repeat: 0.0,
    }
}

fn comment(lines: &[String]) -> String {
    lines.iter().fold(String::new(), |text, line| text + "# " + line + "\n")
}

fn index_csv(cards: &[Card], common: &[String], factor: f64) -> String {
    let mut text = comment(common) + "sid,file,fingerprint,factor,case\n";
    for card in cards {
        let print = Fingerprint::default().with(card.text.as_bytes());
        // Writing to a String cannot fail.
        let _ =
            writeln!(text, "{},{},{print},{factor},\"{}\"", card.case.sid, card.case.file(), card.case.words);
    }
    text
}

fn stations_csv(selection: &Selection, flights: &Flights<'_>, cards: &[Card], common: &[String]) -> String {
    let mut text = comment(common) + "sid,case,instant,t_s,station,component," + &LOADS.join(",") + "\n";
    for (one, card) in selection.selected.iter().zip(cards) {
        let instant = &card.flown;
        for (station, components) in flights.stations.iter().zip(&instant.loads) {
            for (component, loads) in Component::ALL.iter().zip(components) {
                // Writing to a String cannot fail.
                let _ = write!(
                    text,
                    "{},{},{},{},{},{}",
                    one.sid,
                    one.case,
                    one.instant,
                    instant.t_s,
                    station.name,
                    component.name()
                );
                for load in loads {
                    let _ = write!(text, ",{load:.12e}");
                }
                text.push('\n');
            }
        }
    }
    text
}

fn readme(common: &[String], cases: usize) -> String {
    let lines = common.iter().fold(String::new(), |text, line| text + "- " + line + "\n");
    format!(
        "# Loads for stress\n\n{lines}\n{cases} load sets: `index.bdf` is a deck of linear statics with a subcase each; it includes \
         `aircraft.bdf` (the structure the cards belong to) and the cards, `case_NNNNN.bdf`. Cards are limit loads: all that is applied \
         (air, inertia, thrust, damping, gravity), no reactions; each set is in balance. `index.bdf` holds the aircraft at the \
         wing's root, where no reaction is left. Centrifugal forces of steady rolls and turns are left out. `round_trip.csv`: \
         cards read back, summed at the stations, over the whole aircraft, and put on the structure. `loads.h5` has the same as arrays.\n"
    )
}

fn hdf5_file(
    prepared: &Prepared,
    flights: &Flights<'_>,
    cards: &[Card],
    common: &[String],
) -> Result<Vec<u8>, Failure> {
    let free = &prepared.aircraft.free;
    let dofs = 6 * free.node_count();
    let nets: Vec<f64> = cards.iter().flat_map(|card| card.case.net.iter().copied()).collect();
    let points: Vec<f64> = free.points().iter().flat_map(|point| [point.x, point.y, point.z]).collect();
    let count = flights.stations.len();
    let sums: Vec<f64> =
        cards.iter().flat_map(|card| card.expected.stations.iter().flatten().copied()).collect();
    let about: Vec<f64> = flights
        .stations
        .iter()
        .flat_map(|station| [station.point.x, station.point.y, station.point.z])
        .collect();
    let loads = Group::new(
        "loads",
        "net loads at grids, a row a load set; Fx, Fy, Fz (N), Mx, My, Mz (N m) of each grid; basic axes",
    )
    .with("sid", Values::Whole(cards.iter().map(|card| card.case.sid).collect()))
    .with("words", Values::words(cards.iter().map(|card| &card.case.words)))
    .with("origin", Values::words(cards.iter().map(|card| card.origin.join("\n"))))
    .with("f_g", Values::Real(nets, vec![cards.len(), dofs]))
    .with("grids", Values::Whole(free.node_ids().to_vec()))
    .with("xyz_m", Values::Real(points, vec![free.node_count(), 3]));
    let stations = Group::new(
        "stations",
        "net loads at stations by load set, station and Fx, Fy, Fz (N), Mx, My, Mz (N m)",
    )
    .with("names", Values::words(flights.stations.iter().map(|station| &station.name)))
    .with("points_m", Values::Real(about, vec![count, 3]))
    .with("net", Values::Real(sums, vec![cards.len(), count, 6]));
    hdf5::bytes(&common.join("\n"), &[loads, stations])
}
