//! `gust`: a user's deck in discrete and random gusts (SOL 146), as Nastran prints it.

use clap::Args;
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::path::PathBuf;
use std::time::Instant;

use fullaircraft::study::Aim;
use fullaircraft::{DeckGust, DynamicAnswer, GustCase, GustDeck, TimeAnswer, gust_cases};
use nastran::{BulkData, InputError};
use std::f64::consts::TAU;

use super::fullaircraft_deck::say_what_is_assumed;
use super::given_deck::GivenDeck;
use super::gust_files::{self, Quantity, Tables};
use super::gust_result::{Extreme, GustResult, RandomQuantity, SubcaseGust};
use super::gust_text::text;
use super::result_parts::as_json;
use crate::args::Common;
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::{progress, show};

/// Options of `gust`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  wingroot gust --deck my_aircraft.bdf
  wingroot gust --deck my_aircraft.bdf --subcase 20 --grids 101,116")]
pub struct GustArgs {
    /// A Nastran deck: discrete and random gusts as SOL 146 of it asks (GUST, TLOAD, RLOAD, FREQ, TSTEP, RANDPS), in its own units; or a
    /// study (.ron) of decks that lack something for discrete ones
    #[arg(long, value_name = "FILE")]
    pub(crate) deck: PathBuf,
    /// The subcase of the deck [default: all that select a GUST or a DLOAD]
    #[arg(long, value_name = "N")]
    pub(crate) subcase: Option<u32>,
    /// Grids whose motions are written [default: those of DISPLACEMENT, VELOCITY and ACCELERATION, else of SUPORT]
    #[arg(long, value_name = "ID,ID", value_delimiter = ',')]
    pub(crate) grids: Vec<u32>,
}

/// A solved subcase.
struct Solved {
    case: GustCase,
    /// Place of its structure and air.
    deck: usize,
    answer: DynamicAnswer,
    grids: Vec<u32>,
}

/// Runs the command.
pub(crate) fn run(args: &GustArgs, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let given = GivenDeck::read(&args.deck, Aim::Gusts)?;
    let bulk = &given.bulk;
    let mut cases = gust_cases(bulk).map_err(|error| error.or_in(&args.deck))?;
    if let Some(id) = args.subcase {
        cases.retain(|case| case.subcase.id == id);
        if cases.is_empty() {
            let error = InputError::in_file(&args.deck, format!("subcase {id} asks for no gust"));
            return Err(error.with_help("name a subcase with GUST or DLOAD").into());
        }
    }
    if let Some(cards) = bulk.unread_cards().filter(|_| !common.quiet) {
        show::note(&format!("these cards are not read: {cards}"));
    }
    let folder = ResultFolder::begin(&common.out("gust"))?;
    given.enter(&folder)?;
    let decks = assembled(bulk, &cases, common)?;
    let bar = progress::bar(common, cases.len(), "gusts");
    let mut solved = Vec::new();
    for case in cases {
        let place = decks.iter().position(|(before, _)| case.subcase.has_modes_of(&before.subcase));
        let Some(deck) = place else { continue };
        let answer = decks[deck].1.answer(&case)?;
        let grids = grids(args, &decks[deck].1, &case)?;
        solved.push(Solved { case, deck, answer, grids });
        bar.inc(1);
    }
    progress::end(&bar);
    let mut result = GustResult {
        command: "gust",
        deck: args.deck.display().to_string(),
        subcases: Vec::new(),
        random: Vec::new(),
        seconds: 0.0,
    };
    let mut tables = Tables::default();
    for one in &solved {
        result.subcases.push(written(&decks[one.deck].1, one, &folder, &mut tables)?);
    }
    result.random = random(bulk, &decks, &solved, &mut tables)?;
    tables.write(&folder)?;
    if !result.random.is_empty() {
        gust_files::draw_densities(&folder, &tables)?;
    }
    result.seconds = start.elapsed().as_secs_f64();
    let json = as_json(&result)?;
    folder.write_json("result.json", &json)?;
    let out = folder.commit()?;
    let mut said = text(&result);
    let _ = write!(said, "{:.1} s; results in {}", result.seconds, out.display());
    show::summary(common, &said);
    show::json(common, &json)
}

/// Structure and air of the cases, once for those that share them.
fn assembled(
    bulk: &BulkData,
    cases: &[GustCase],
    common: &Common,
) -> Result<Vec<(GustCase, GustDeck)>, Failure> {
    let mut decks: Vec<(GustCase, GustDeck)> = Vec::new();
    for case in cases {
        if decks.iter().any(|(before, _)| case.subcase.has_modes_of(&before.subcase)) {
            continue;
        }
        let alike: Vec<&GustCase> =
            cases.iter().filter(|other| case.subcase.has_modes_of(&other.subcase)).collect();
        let deck = GustDeck::new(bulk, &case.subcase, &alike)?;
        if !common.quiet {
            let modal = &deck.modal;
            say_what_is_assumed(bulk, &modal.loose_boxes, modal.auto_held(), modal.reduction.clone());
        }
        decks.push((case.clone(), deck));
    }
    Ok(decks)
}

/// The grids whose motions are written.
fn grids(args: &GustArgs, deck: &GustDeck, case: &GustCase) -> Result<Vec<u32>, Failure> {
    if args.grids.is_empty() {
        return Ok(deck.asked_grids(&case.subcase));
    }
    let asked: BTreeSet<u32> = args.grids.iter().copied().collect();
    if let Some(grid) = asked.iter().find(|grid| deck.shapes_at(**grid).is_none()) {
        return Err(InputError::in_file(&args.deck, format!("there is no grid {grid} (--grids)")).into());
    }
    Ok(asked.into_iter().collect())
}

/// Tables, figures and numbers of a subcase.
fn written(
    deck: &GustDeck,
    solved: &Solved,
    folder: &ResultFolder,
    tables: &mut Tables,
) -> Result<SubcaseGust, Failure> {
    let Solved { case, answer, grids, .. } = solved;
    let id = case.subcase.id;
    let mut remarks: Vec<String> = case.remarks.iter().chain(&deck.remarks).cloned().collect();
    tables.over_frequency(id, deck, answer, grids);
    let quantities = if let Some(time) = deck.in_time(case, answer) {
        remarks.extend(time.remarks.iter().cloned());
        tables.over_time(id, deck, &time, grids);
        let quantities = gust_files::in_time(deck, &time, grids);
        draw(folder, id, &quantities, "time (s)", Some(&time))?;
        quantities
    } else {
        let quantities = gust_files::amplitudes(deck, answer, grids);
        draw(folder, id, &quantities, "frequency (Hz)", None)?;
        quantities
    };
    Ok(SubcaseGust {
        subcase: id,
        label: case.subcase.label.clone(),
        gust: case.gust.as_ref().map_or(0, |gust| gust.id),
        velocity: case.flow.v_m_s,
        dynamic_pressure: case.flow.dynamic_pressure_pa(),
        mach: deck.mach(),
        boxes: deck.modal.lattice.len(),
        frequencies_hz: deck.modal.omega_rad_s.iter().map(|omega| omega / TAU).collect(),
        rigid_modes: deck.modal.omega_rad_s.iter().filter(|omega| **omega == 0.0).count(),
        in_time: case.times_s.is_some(),
        extremes: quantities.iter().filter_map(extreme).collect(),
        remarks,
    })
}

fn draw(
    folder: &ResultFolder,
    id: u32,
    quantities: &[Quantity],
    axis: &str,
    time: Option<&TimeAnswer>,
) -> Result<(), Failure> {
    gust_files::figures(id, quantities, axis, time).into_iter().try_for_each(|(name, caption, figure)| {
        folder.write_figure(&name, caption, figure)?;
        Ok(())
    })
}

/// Largest and smallest of a quantity; nothing of one that never moves.
fn extreme(quantity: &Quantity) -> Option<Extreme> {
    let values = || quantity.x.iter().copied().zip(quantity.y.iter().copied());
    let highest = values().max_by(|a, b| a.1.total_cmp(&b.1))?;
    let lowest = values().min_by(|a, b| a.1.total_cmp(&b.1))?;
    (highest.1 != 0.0 || lowest.1 != 0.0).then(|| Extreme {
        of: quantity.of.clone(),
        component: quantity.component.clone(),
        highest: highest.1,
        highest_at: highest.0,
        lowest: lowest.1,
        lowest_at: lowest.0,
    })
}

/// Quantities of every set of RANDPS that a solved subcase selects.
fn random(
    bulk: &BulkData,
    decks: &[(GustCase, GustDeck)],
    solved: &[Solved],
    tables: &mut Tables,
) -> Result<Vec<RandomQuantity>, Failure> {
    let sets: BTreeSet<u32> = solved.iter().filter_map(|one| one.case.subcase.random).collect();
    let gusts: Vec<DeckGust<'_>> = solved
        .iter()
        .map(|one| DeckGust { case: &one.case, deck: &decks[one.deck].1, answer: &one.answer })
        .collect();
    let mut all = Vec::new();
    for set in sets {
        let random = DeckGust::random(bulk, set, &gusts)?;
        let Some(one) = solved.iter().find(|one| one.case.subcase.random == Some(set)) else { continue };
        for (of, component, answer) in gust_files::random(&random, &decks[one.deck].1, &one.grids) {
            let Some(n0_hz) = answer.n0_hz.filter(|_| answer.rms > 0.0) else { continue };
            tables.density(set, &random.hz, &of, &component, &answer);
            all.push(RandomQuantity { set, of, component, rms: answer.rms, n0_hz });
        }
    }
    Ok(all)
}
