//! The package of a plan on a deck: cards in the deck's units at the deck's grids, its structure, and their round trip.

use std::collections::BTreeMap;

use fullaircraft::design_loads::deck::{DeckFlown, DeckPlan};
use fullaircraft::design_loads::instants::FlownInstant;
use fullaircraft::package::cards::{CardCase, Hold, structure_of};
use fullaircraft::package::round_trip::{Expected, Own, RoundTrip, Row};
use fullaircraft::{Component, NodalLoads};
use loads::Selection;
use loads::select::Selected;
use loads::select::file::{Model as Which, SelectFile};
use rayon::prelude::*;
use structure::{Model, System};

use crate::commands::loads_export::{Export, Places};
use crate::commands::loads_flights::Wanted;
use crate::commands::loads_on_deck::OnDeck;
use crate::commands::loads_package::{
    PARTS, check_repeat, lost, moment, origin_of, parts, refuse_unwritten, repeat,
};
use crate::commands::loads_package_files::{Card, Heads, Packed, Site, packed};
use crate::commands::loads_tables::{case_of, words};
use crate::failure::Failure;

/// Units of the cards, in words.
const UNITS: &str = "the deck's units of force and length; basic axes of the deck";

/// Makes the package of a flown plan.
///
/// # Errors
/// If cards read back do not give the loads that were flown.
pub(super) fn package(
    on: &OnDeck,
    all: &[DeckFlown],
    select: &SelectFile,
    selection: &Selection,
) -> Result<Packed, Failure> {
    refuse_unwritten(select)?;
    let mut common = origin_of(&on.file.name, &on.inputs)?;
    let units = on.plan.units;
    common.push(format!(
        "tables: N, N m, m; cards and structure: {UNITS} (lengths of {} m, forces of {} N)",
        units.length_m, units.force_n
    ));
    let grids = &on.deck.grids;
    let deck = structure_of(&on.plan.bulk, &common);
    let back = RoundTrip::of(own(on), &on.stations, &deck)?;
    let places = Places {
        stations: &on.stations,
        grids: grids.free.node_ids(),
        hold: Hold::of(&on.plan.bulk, on.plan.equations, grids.support.clone()),
        deck,
        common: &common,
    };
    let export = Export::new(back, select.export.at, places)?;
    let last = selection.selected.iter().map(|one| one.sid).max().unwrap_or(0);
    let at_grids = at_grids(on, all, selection)?;
    let on_cards = |one: &Selected| {
        let nodal = at_grids.get(&one.sid).ok_or_else(|| lost(one.case))?;
        let mut card = card(on, one, flown(all, one)?, nodal, &common, &export.back)?;
        let nodal = export.nodal(nodal.clone());
        card.case.net = nodal.of(Component::Net);
        if select.export.components == PARTS {
            card.case.parts = parts(one.sid, last, &nodal);
        }
        card.text = card.case.text_in(UNITS, export.grids(), &card.origin);
        let read = export.compare(&card.case, &card.text, &card.expected)?;
        Ok((card, read.into_iter().map(|row| in_si(on, row)).collect()))
    };
    let made: Result<Vec<_>, Failure> = selection.selected.par_iter().map(on_cards).collect();
    let (cards, rows): (Vec<Card>, Vec<Vec<Row>>) = made?.into_iter().unzip();
    let rows = rows.concat();
    check_repeat(&cards)?;
    let cases: Vec<CardCase> = cards.iter().map(|card| card.case.clone()).collect();
    let index = export.index(&format!("Design loads: {}", on.file.name), &cases, &common);
    let held = match &grids.support {
        Some((grid, _)) => format!("as its SUPORT at grid {grid} says"),
        None => "by its own constraints".to_owned(),
    };
    let (numbers, words) = (export.grids().to_vec(), export.words(&held));
    let points = export.points();
    let site = Site { stations: &on.stations, grids: &numbers, points, units: UNITS, words: &words };
    let heads =
        Heads { structure: export.file(), index, common: common.clone(), factor: select.export.factor };
    packed(&site, selection, cards, &rows, heads)
}

/// The deck's structure: its tips are its rightmost grid and, unless it is half an aircraft, its leftmost.
fn own(on: &OnDeck) -> Own<'_> {
    let grids = &on.deck.grids;
    let points = grids.free.points();
    let furthest = |side: f64| {
        (0..points.len()).max_by(|a, b| (side * points[*a].y).total_cmp(&(side * points[*b].y))).unwrap_or(0)
    };
    let mut tips = vec![("right tip", furthest(1.0))];
    if on.deck.aeros().symmetry == 0 {
        tips.push(("left tip", furthest(-1.0)));
    }
    Own {
        free: &grids.free,
        held: &grids.held,
        tips,
        balanced: grids.balanced.clone(),
        assemble: |bulk| System::assemble(&Model::from_deck(bulk, None)?),
    }
}

/// A row in the deck's units in N, N m and m.
fn in_si(on: &OnDeck, row: Row) -> Row {
    let [force_n, moment_nm] = on.plan.unit_loads();
    let unit = match row.what {
        "stiffness" => 1.0,
        "deflection_m" => on.plan.units.length_m,
        moment if moment.starts_with('M') => moment_nm,
        _ => force_n,
    };
    Row { solver: unit * row.solver, cards: unit * row.cards, ..row }
}

/// A selected instant as it was flown.
fn flown<'f>(all: &'f [DeckFlown], one: &Selected) -> Result<&'f FlownInstant, Failure> {
    let case = found(all, one)?;
    case.case.instants.get(one.instant - 1).ok_or_else(|| lost(one.case))
}

fn found<'f>(all: &'f [DeckFlown], one: &Selected) -> Result<&'f DeckFlown, Failure> {
    let model = usize::from(one.model == Which::Updated);
    let same = |flown: &&DeckFlown| (flown.case.model, flown.case.number) == (model, one.case);
    all.iter().find(same).ok_or_else(|| lost(one.case))
}

/// Loads at grids of what was selected, by load set: kept of trims; gusts are flown again.
fn at_grids(
    on: &OnDeck,
    all: &[DeckFlown],
    selection: &Selection,
) -> Result<BTreeMap<u32, NodalLoads>, Failure> {
    let mut loads = BTreeMap::new();
    let (mut again, mut wanted) = (Vec::new(), Vec::new());
    for one in &selection.selected {
        if let Some(nodal) = &found(all, one)?.nodal {
            loads.insert(one.sid, nodal.clone());
        } else {
            let model = usize::from(one.model == Which::Updated);
            let (instant, flown) = (one.instant - 1, flown(all, one)?);
            wanted.push(Wanted { model, number: one.case, instant, flown });
            again.push(one.sid);
        }
    }
    loads.extend(again.into_iter().zip(on.again(&wanted)?.into_iter().map(|again| again.nodal)));
    Ok(loads)
}

fn card(
    on: &OnDeck,
    one: &Selected,
    first: &FlownInstant,
    nodal: &NodalLoads,
    common: &[String],
    back: &RoundTrip<'_>,
) -> Result<Card, Failure> {
    let case = case_of(&on.matrix, one.case).ok_or_else(|| lost(one.case))?;
    let net = nodal.of(Component::Net);
    let tips = back.tips();
    let tip = |side: usize| net.iter().enumerate().map(|(dof, load)| tips[(dof, side)] * load).sum::<f64>();
    let expected = Expected {
        stations: on.stations.iter().map(|station| station.sums(back.points(), &net)).collect(),
        tips_m: (0..tips.ncols()).map(tip).collect(),
    };
    let flown =
        FlownInstant { loads: on.plan.at_stations(nodal, &on.stations, back.points()), ..first.clone() };
    let mass = &on.design.masses[case.mass].name;
    let title =
        format!("case {} {}, {:.1} m/s, n {:.2}, {mass}", one.case, case.condition, case.v_m_s, case.n_z);
    let moment = if DeckPlan::is_in_gusts(case) {
        let names: Vec<String> = on.stations.iter().map(|station| station.name.clone()).collect();
        format!("instant {} {}", one.instant, moment(&names, case, &flown))
    } else {
        "a trim".to_owned()
    };
    let mut origin = common.to_vec();
    origin.push(format!("{}; mass {mass}; model {}; {moment}", words(case), one.model.name()));
    let case = CardCase { sid: one.sid, words: title, net, parts: Vec::new() };
    let repeat = repeat(&first.net(), &flown.net());
    Ok(Card { case, text: String::new(), expected, trim_tip: 0.0, repeat, flown, origin })
}
