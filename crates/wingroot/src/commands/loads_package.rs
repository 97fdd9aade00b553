//! The package for stress: cards of the selected instants, the structure they belong to, an index, HDF5, and their round trip,
//! which is made before anything is written.

use fullaircraft::design_loads::in_time::axis_of;
use fullaircraft::design_loads::instants::FlownInstant;
use fullaircraft::package::cards::{CardCase, CardPart, Hold, structure};
use fullaircraft::package::round_trip::{Expected, RoundTrip, Row};
use fullaircraft::{Component, NodalLoads, Station};
use loads::Selection;
use loads::matrix::Case;
use loads::select::Selected;
use loads::select::file::{Component as Exported, Model, SelectFile};
use nastran::InputError;
use rayon::prelude::*;

use crate::commands::fullaircraft_prepared::Prepared;
use crate::commands::loads_export::{Export, Places};
use crate::commands::loads_flights::{Flights, Flown, FlownAgain, Wanted, is_in_time};
use crate::commands::loads_package_files::{Card, Heads, Packed, Site, packed};
use crate::commands::loads_tables::{case_of, words};
use crate::failure::Failure;
use crate::fingerprint::Fingerprint;
use crate::version::VERSION;

/// Most that loads at stations of a case flown again may differ from the first flight's: they are
/// sums of other numbers, and with thin shells differ by 2e-7.
const REPEAT: f64 = 1e-6;

/// What is asked for where the air's loads are a set apart from all others.
pub(crate) const PARTS: [Exported; 2] = [Exported::Air, Exported::Inertia];

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
    // stress works on the structure that was found, if that is another than the drawing's
    let aircraft = prepared.updated();
    let common = origin(prepared, flights)?;
    let wanted = wanted(flown, selection)?;
    let read_back = || -> Result<_, Failure> {
        let deck = structure(aircraft, &common);
        let back = RoundTrip::new(aircraft, &flights.stations, &deck)?;
        Ok((deck, back))
    };
    let (again, back) = rayon::join(|| flights.again(&wanted), read_back);
    let (again, (deck, back)) = (again?, back?);
    let places = Places {
        stations: &flights.stations,
        grids: &flights.grids,
        hold: Hold::at_the_root(aircraft),
        deck,
        common: &common,
    };
    let export = Export::new(back, select.export.at, places)?;
    let last = selection.selected.iter().map(|one| one.sid).max().unwrap_or(0);
    let on_cards = |(one, again): (&Selected, FlownAgain)| {
        let mut card = card(one, &again, flights, flown, &common, &export.back)?;
        let nodal = export.nodal(again.nodal);
        card.case.net = nodal.of(Component::Net);
        if select.export.components == PARTS {
            card.case.parts = parts(one.sid, last, &nodal);
        }
        card.text = card.case.text(export.grids(), &card.origin);
        let rows = export.compare(&card.case, &card.text, &card.expected)?;
        Ok((card, rows))
    };
    let made: Result<Vec<_>, Failure> = selection.selected.par_iter().zip(again).map(on_cards).collect();
    let (cards, rows): (Vec<Card>, Vec<Vec<Row>>) = made?.into_iter().unzip();
    let rows = rows.concat();
    check_repeat(&cards)?;
    let title = format!("Design loads: {}", flights.plan.name);
    let cases: Vec<CardCase> = cards.iter().map(|card| card.case.clone()).collect();
    let (grids, words) = (export.grids().to_vec(), export.words("at the wing's root"));
    let site = Site {
        stations: &flights.stations,
        grids: &grids,
        points: export.points(),
        units: "N, N m; basic axes",
        words: &words,
    };
    let index = export.index(&title, &cases, &common);
    let heads =
        Heads { structure: export.file(), index, common: common.clone(), factor: select.export.factor };
    packed(&site, selection, cards, &rows, heads)
}

/// Refuses loads of cases flown again that are not those of the first flight.
///
/// # Errors
/// If one differs.
pub(crate) fn check_repeat(cards: &[Card]) -> Result<(), Failure> {
    let repeat = cards.iter().map(|card| card.repeat).fold(0.0, f64::max);
    if repeat <= REPEAT {
        return Ok(());
    }
    Err(Failure::Computation(format!(
        "nodal loads of cases flown again differ at stations by {repeat:.1e} of the largest load (at most {REPEAT:.0e}); no package is \
         written"
    )))
}

/// The instants of a selection as they were flown.
fn wanted<'f>(flown: &'f Flown, selection: &Selection) -> Result<Vec<Wanted<'f>>, Failure> {
    let one = |one: &Selected| {
        let (model, number, instant) = (usize::from(one.model == Model::Updated), one.case, one.instant - 1);
        let first = flown.case(model, number).and_then(|case| case.instants.get(instant));
        let first = first.ok_or_else(|| lost(number))?;
        Ok(Wanted { model, number, instant, flown: first })
    };
    selection.selected.iter().map(one).collect()
}

/// What a selection can ask for and is not written.
pub(crate) fn refuse_unwritten(select: &SelectFile) -> Result<(), InputError> {
    let known = [&[Exported::Net][..], &PARTS];
    if known.contains(&&select.export.components[..]) {
        return Ok(());
    }
    let message = "cards are written as net loads or as those of the air with all others apart";
    Err(InputError::in_field(&select.path, "export", message)
        .with_help("write export: (components: [Net]) or [Air, Inertia], or leave it out"))
}

/// Program, plan and fingerprints of everything that was read.
fn origin(prepared: &Prepared, flights: &Flights<'_>) -> Result<Vec<String>, Failure> {
    let mut lines = origin_of(&flights.plan.name, &prepared.inputs)?;
    lines.push(format!("wing with all its files {}", prepared.aircraft.wing.hash));
    let corrections = format!("{:?}", prepared.corrections);
    lines.push(format!("corrections of boxes {}", Fingerprint::default().with(corrections.as_bytes())));
    if let Some(found) = &prepared.wing.schedule.found {
        let [bending, torsion] = found.log_flexibility.map(f64::exp);
        lines.push(format!(
            "structure as found by the calibration: flexibility in bending times {bending:.4}, in torsion {torsion:.4}"
        ));
    }
    lines.push("N, N m, m; basic axes x aft, y right, z up".to_owned());
    Ok(lines)
}

/// Program, plan and the files' fingerprints.
///
/// # Errors
/// If a file can no longer be read.
pub(crate) fn origin_of(
    plan: &str,
    inputs: &[(&'static str, std::path::PathBuf)],
) -> Result<Vec<String>, Failure> {
    let mut lines = vec![format!("wingroot {VERSION}, loads"), format!("plan \"{plan}\"")];
    for (what, path) in inputs {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let print = if path.is_file() {
            Fingerprint::of_file(path).map_err(|error| InputError::in_file(path, error.to_string()))?
        } else {
            Fingerprint::default()
        };
        lines.push(format!("{what} {name} {print}"));
    }
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
    // in time the tip flies with inertia; and the initial model's stiffness is not the package's where another was found
    let is_other = flights.states.found.is_some() && one.model == Model::Initial;
    let trim_tip = if is_in_time(case, &flights.maneuvers) || is_other { 0.0 } else { off(0).max(off(1)) };
    let title = format!("case {number} {}, {:.1} m/s, n {:.2}, {mass}", case.condition, case.v_m_s, case.n_z);
    let names: Vec<String> = flights.stations.iter().map(|station| station.name.clone()).collect();
    let mut origin = common.to_vec();
    origin.push(format!(
        "{}; mass {mass}; model {}; instant {} {}",
        words(case),
        one.model.name(),
        one.instant,
        moment(&names, case, &flown)
    ));
    Ok(Card {
        case: CardCase { sid: one.sid, words: title, net, parts: Vec::new() },
        text: String::new(),
        repeat: repeat(&first.net(), &flown.net()),
        expected: Expected { stations: flown.net(), tips_m: tips_m.to_vec() },
        flown,
        trim_tip,
        origin,
    })
}

/// When an instant is, or which load is at its limit in it.
pub(crate) fn moment(stations: &[String], case: &Case, flown: &FlownInstant) -> String {
    match (flown.limit, flown.gradient_m) {
        (Some(limit), _) => {
            format!(
                "with {} at its limit, and the loads that go with it",
                limit.words(axis_of(case), stations)
            )
        }
        (None, Some(gradient_m)) => format!("at {} s, gradient {gradient_m:.2} m", flown.t_s),
        (None, None) => format!("at {} s", flown.t_s),
    }
}

pub(crate) fn lost(number: usize) -> Failure {
    Failure::Computation(format!("case {number} was selected and is not there"))
}

/// The air's loads of a case and all others, as sets that are numbered beyond those of the cases.
pub(crate) fn parts(sid: u32, last: u32, nodal: &NodalLoads) -> Vec<CardPart> {
    let air = nodal.of(Component::Air);
    let rest = nodal.of(Component::Net).iter().zip(&air).map(|(net, air)| net - air).collect();
    let beyond = |part: u32| last + 2 * (sid - 1) + part;
    vec![
        CardPart { sid: beyond(1), words: "air", loads: air },
        CardPart { sid: beyond(2), words: "inertia, gravity, thrust and damping", loads: rest },
    ]
}

/// Largest difference of two flights' loads at stations, as a share of the largest force or moment.
pub(crate) fn repeat(first: &[[f64; 6]], again: &[[f64; 6]]) -> f64 {
    let of_kind = |from: usize| {
        let pairs =
            || first.iter().zip(again).flat_map(|(a, b)| a[from..from + 3].iter().zip(&b[from..from + 3]));
        let largest = pairs().fold(0.0_f64, |most, (a, _)| most.max(a.abs()));
        pairs().fold(0.0_f64, |most, (a, b)| most.max((a - b).abs())) / largest.max(f64::MIN_POSITIVE)
    };
    of_kind(0).max(of_kind(3))
}
