//! `fullaircraft --deck`: the trims a user's whole-aircraft Nastran deck asks for (SOL 144).

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;
use std::time::Instant;

use fullaircraft::study::Aim;
use fullaircraft::{
    DeckCase, DivergenceCase, Elastic, TrimDeck, TrimmedDeck, deck_cases_beside_divergence, divergence_cases,
};
use nastran::{BulkData, Subcase};
use schemars::JsonSchema;
use serde::Serialize;

use super::given_deck::GivenDeck;
use crate::args::Common;
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::structures::{held_remark, solid_remark, unreduced_remark};
use crate::{progress, show};

/// Names of the coefficients in the order of the library.
const COEFFICIENTS: [&str; 6] = ["CX", "CY", "CZ", "Cl", "Cm", "Cn"];
/// How many divergence pressures are given.
const DIVERGENCES: usize = 5;

/// What `result.json` holds; forces, lengths and pressures in the deck's units.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Summary {
    /// Name of the command.
    command: &'static str,
    /// The deck.
    deck: String,
    /// Number of aerodynamic boxes.
    boxes: usize,
    /// Cards that are not read, by name.
    cards_not_read: BTreeMap<String, usize>,
    /// Subcases that ask for a trim, in the deck's order.
    subcases: Vec<Trimmed>,
    /// What subcases ask of divergence, Mach number by Mach number.
    divergences: Vec<Divergence>,
    /// Wall clock.
    seconds: f64,
}

/// Divergence at a Mach number, held at the SUPORT motions.
#[derive(Debug, Serialize, JsonSchema)]
struct Divergence {
    /// Number of the subcase.
    subcase: u32,
    /// Its label.
    label: String,
    /// Its DIVERG card.
    diverg: u32,
    /// Mach number.
    mach: f64,
    /// Dynamic pressures, the lowest first, as many as the card asks for and there are.
    q: Vec<f64>,
}

/// One subcase.
#[derive(Debug, Serialize, JsonSchema)]
struct Trimmed {
    /// Its number.
    subcase: u32,
    /// Its label.
    label: String,
    /// Its TRIM card.
    trim: u32,
    /// Mach number.
    mach: f64,
    /// Dynamic pressure.
    q: f64,
    /// Why it was not trimmed; null if it was.
    refused: Option<String>,
    /// Trim variables; angles are those of the SUPORT grid.
    values: BTreeMap<String, f64>,
    /// Angle of attack of the mean axes; null if the subcase was refused, or has no ANGLEA or no SUPORT motion in pitch.
    mean_angle_of_attack_rad: Option<f64>,
    /// Lift; null if the subcase was refused.
    lift: Option<f64>,
    /// Loads at monitor points: three forces, three moments; of the air (MONPNT1), net on all of their grids (MONPNT3).
    monitors: BTreeMap<String, [f64; 6]>,
    /// Dynamic pressures of divergence.
    divergence_q: Vec<f64>,
    /// Neutral point: rigid, restrained, unrestrained; null where pitching changes no lift.
    neutral_point_x: [Option<f64>; 3],
    /// Coefficients by trim variable.
    derivatives: BTreeMap<String, Derivative>,
    /// Whether it is one half of an antisymmetric aircraft.
    #[serde(skip)]
    is_antisymmetric: bool,
}

/// Coefficients per unit of a variable, about the reference axes.
#[derive(Debug, Serialize, JsonSchema)]
struct Derivative {
    /// Of the rigid aircraft.
    rigid: BTreeMap<&'static str, f64>,
    /// Of the rigid aircraft by the air that reaches free motions: Nastran's "splined".
    splined: BTreeMap<&'static str, f64>,
    /// Of the elastic aircraft, held.
    restrained: BTreeMap<&'static str, f64>,
    /// Of the elastic aircraft, free.
    unrestrained: BTreeMap<&'static str, f64>,
}

/// Runs the command.
pub(crate) fn run(path: &Path, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let given = GivenDeck::read(path, Aim::Trims)?;
    let bulk = &given.bulk;
    let cases = deck_cases_beside_divergence(bulk).map_err(|error| error.or_in(path))?;
    let asked = divergence_cases(bulk).map_err(|error| error.or_in(path))?;
    if let Some(cards) = bulk.unread_cards().filter(|_| !common.quiet) {
        show::note(&format!("these cards are not read: {cards}"));
    }
    let folder = ResultFolder::begin(&common.out("fullaircraft_deck"))?;
    let mut summary = Summary {
        command: "fullaircraft --deck",
        deck: path.display().to_string(),
        boxes: 0,
        cards_not_read: bulk.unknown.iter().map(|(card, unread)| (card.clone(), unread.count)).collect(),
        subcases: Vec::new(),
        divergences: Vec::new(),
        seconds: 0.0,
    };
    let known = answered(bulk, &cases, &asked, &folder, common, &mut summary)?;
    if let Some((_, deck)) = known.filter(|_| !common.quiet) {
        say_what_is_assumed(bulk, &deck.loose_boxes, deck.auto_held(), unreduced_remark(bulk));
        say_of_stations(&deck.skipped_monitors);
    }
    summary.seconds = start.elapsed().as_secs_f64();
    given.enter(&folder)?;
    folder.write_json("result.json", &summary)?;
    let refused = summary.subcases.iter().find_map(|case| case.refused.clone());
    let refused = refused.filter(|_| {
        summary.divergences.is_empty() && summary.subcases.iter().all(|case| case.refused.is_some())
    });
    let out = folder.commit_if(refused.is_none())?;
    let text = format!(
        "{}\n{} boxes, {:.2} s; results in {}",
        text(&summary),
        summary.boxes,
        summary.seconds,
        out.display()
    );
    show::summary(common, &text);
    show::json(common, &summary)?;
    refused.map_or(Ok(()), |why| Err(Failure::Computation(why)))
}

/// Fills in the subcases' answers; gives the deck of the last.
fn answered(
    bulk: &BulkData,
    cases: &[DeckCase],
    asked: &[DivergenceCase],
    folder: &ResultFolder,
    common: &Common,
    summary: &mut Summary,
) -> Result<Option<(Conditions, TrimDeck)>, Failure> {
    let bar = progress::bar(common, cases.len() + asked.len(), "subcases");
    let mut known: Option<(Conditions, TrimDeck)> = None;
    for case in cases {
        let deck = assembled(bulk, &case.subcase, case.trim.mach, &mut known)?;
        summary.boxes = deck.lattice.len();
        let found = deck.trim_card(&case.trim);
        if let Ok(trimmed) = &found {
            folder.write_text(&format!("boxes_trim_{}.csv", case.trim.id), &boxes(deck, trimmed))?;
        }
        summary.subcases.push(numbers(case, deck, found.map_err(|error| error.to_string())));
        bar.inc(1);
    }
    for case in asked {
        for mach in &case.diverg.machs {
            let deck = assembled(bulk, &case.subcase, *mach, &mut known)?;
            summary.boxes = deck.lattice.len();
            summary.divergences.push(divergence(case, *mach, deck));
        }
        bar.inc(1);
    }
    progress::end(&bar);
    Ok(known)
}

fn say_of_stations(skipped: &[String]) {
    if !skipped.is_empty() {
        show::note(&format!(
            "stations left out (MONPNT3 of a group, MONPNT1 of components made of grids or not there): {}",
            skipped.join(", ")
        ));
    }
}

/// What of splines, divisions, constraints, shells and solids is not as the deck might expect; `held` are the motions that AUTOSPC holds,
/// `reduction` is what became of ASET and OMIT.
pub(crate) fn say_what_is_assumed(
    bulk: &BulkData,
    loose: &[u32],
    held: &[(u32, u8)],
    reduction: Option<String>,
) {
    let (divisions, splines) = (bulk.division_remark(), bulk.spline_remark());
    let (shells, solids) = (bulk.shell_remark(), solid_remark(bulk));
    let all = [divisions, splines, shells, solids, held_remark(held), reduction];
    bulk.remarks().iter().chain(all.iter().flatten()).for_each(|remark| show::note(remark));
    if let Some(first) = loose.first() {
        show::note(&format!(
            "{} boxes have no spline, the first {first}: they neither move nor load the structure",
            loose.len()
        ));
    }
}

/// What a deck is assembled for: what a subcase makes of the cards (SPC, MPC, SUPORT1, symmetry, added matrices), the Mach number and LOAD.
type Conditions = (BulkData, f64, Option<u32>);

/// The deck in a subcase's conditions; `known` is that of the subcase before.
fn assembled<'a>(
    bulk: &BulkData,
    subcase: &Subcase,
    mach: f64,
    known: &'a mut Option<(Conditions, TrimDeck)>,
) -> Result<&'a TrimDeck, Failure> {
    let asked = (bulk.in_subcase(subcase)?, mach, subcase.load);
    let deck = match known.take().filter(|(before, _)| *before == asked) {
        Some((_, deck)) => deck,
        None => TrimDeck::under_load(&asked.0, mach, subcase.load)?,
    };
    Ok(&known.insert((asked, deck)).1)
}

fn divergence(case: &DivergenceCase, mach: f64, deck: &TrimDeck) -> Divergence {
    Divergence {
        subcase: case.subcase.id,
        label: case.subcase.label.clone(),
        diverg: case.diverg.id,
        mach,
        q: deck.divergence_pressures().iter().copied().take(case.diverg.roots as usize).collect(),
    }
}

fn numbers(case: &DeckCase, deck: &TrimDeck, found: Result<TrimmedDeck, String>) -> Trimmed {
    let kinds = [Elastic::Rigid, Elastic::Restrained, Elastic::Unrestrained];
    let [rigid, restrained, unrestrained] = kinds.map(|kind| deck.derivatives_of_card(&case.trim, kind));
    let splined = deck.splined_derivatives();
    let named = |values: &[f64; 6]| COEFFICIENTS.into_iter().zip(*values).collect();
    let derivatives = deck.variables.iter().map(|name| {
        let derivative = Derivative {
            rigid: named(&rigid[name]),
            splined: named(&splined[name]),
            restrained: named(&restrained[name]),
            unrestrained: named(&unrestrained[name]),
        };
        (name.clone(), derivative)
    });
    let (trimmed, refused) = match found {
        Ok(trimmed) => (Some(trimmed), None),
        Err(why) => (None, Some(why)),
    };
    Trimmed {
        subcase: case.subcase.id,
        label: case.subcase.label.clone(),
        trim: case.trim.id,
        mach: case.trim.mach,
        q: case.trim.q,
        refused,
        values: trimmed.as_ref().map(|trimmed| trimmed.values.clone()).unwrap_or_default(),
        mean_angle_of_attack_rad: trimmed.as_ref().and_then(|trimmed| trimmed.mean_angle_of_attack_rad),
        lift: trimmed.as_ref().map(|trimmed| trimmed.lift.iter().sum()),
        monitors: trimmed.map(|trimmed| trimmed.monitors).unwrap_or_default(),
        divergence_q: deck.divergence_pressures().iter().copied().take(DIVERGENCES).collect(),
        neutral_point_x: [&rigid, &restrained, &unrestrained].map(|all| deck.neutral_point_x(all)),
        derivatives: derivatives.collect(),
        is_antisymmetric: deck.aeros().symmetry < 0,
    }
}

/// Pressures and lifts of all boxes.
fn boxes(deck: &TrimDeck, trimmed: &TrimmedDeck) -> String {
    let mut text = String::from("box,cp,lift\n");
    for (j, panel) in deck.lattice.boxes.iter().enumerate() {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{},{},{}", panel.id, trimmed.cp[j], trimmed.lift[j]);
    }
    text
}

fn text(summary: &Summary) -> String {
    let mut text = String::new();
    for case in &summary.subcases {
        let first = case.divergence_q.first().map_or("none".to_owned(), |q| format!("{q:.6}"));
        let head = format!("TRIM {}, Mach {}, q {}", case.trim, case.mach, case.q);
        let _ = writeln!(text, "SUBCASE {} {}: {head}; divergence at q {first}", case.subcase, case.label);
        if let Some(why) = &case.refused {
            let _ = writeln!(text, "  not trimmed: {why}");
        }
        // Of an antisymmetric half, lift and pitch are those of one side and cancel.
        let shown: &[&str] = if case.is_antisymmetric { &["CY", "Cl", "Cn"] } else { &["CZ", "Cm"] };
        let heads: Vec<String> =
            shown.iter().flat_map(|name| ["rigid", "elastic"].map(|kind| format!("{name} {kind}"))).collect();
        let heads: Vec<&str> = ["", "trim"].into_iter().chain(heads.iter().map(String::as_str)).collect();
        let mut table = report::Table::new(&heads);
        for (name, derivative) in &case.derivatives {
            let value = case.values.get(name).map_or("-".to_owned(), |value| format!("{value:.6e}"));
            let (rigid, free) = (&derivative.rigid, &derivative.unrestrained);
            let cells = shown.iter().flat_map(|name| [rigid[name], free[name]].map(|x| format!("{x:.6}")));
            table.row([name.clone(), value].into_iter().chain(cells));
        }
        let _ = writeln!(text, "{table}");
        if let Some(angle) = case.mean_angle_of_attack_rad {
            let _ = writeln!(text, "  ANGLEA of the mean axes: {angle:.6e} (above: of the SUPORT grid)");
        }
        for (name, loads) in &case.monitors {
            let loads: Vec<String> = loads.iter().map(|load| format!("{load:.4e}")).collect();
            let _ = writeln!(text, "  MONPNT1 {name}: {}", loads.join(" "));
        }
    }
    for case in &summary.divergences {
        let q: Vec<String> = case.q.iter().map(|q| format!("{q:.6}")).collect();
        let at = if q.is_empty() { "none".to_owned() } else { format!("at q {}", q.join(", ")) };
        let head = format!("DIVERG {}, Mach {}", case.diverg, case.mach);
        let _ = writeln!(text, "SUBCASE {} {}: {head}; divergence {at}", case.subcase, case.label);
    }
    text
}
