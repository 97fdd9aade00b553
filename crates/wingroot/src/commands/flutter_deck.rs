//! `flutter --deck`: what a user's deck asks for (SOL 145), as Nastran prints it.

use std::fmt::Write as _;
use std::path::Path;
use std::time::Instant;

use fullaircraft::study::Aim;
use fullaircraft::{FlutterDeck, FlutterPoints, FlutterRoots, flutter_cases};
use maneuver::flutter::{CompleteCurves, Crossing, GafTable, Root};
use nastran::{BulkData, Flutter, Subcase};
use report::{Figure, Panel, Series, Style, Table};
use std::f64::consts::TAU;

use super::flutter_deck_beyond as beyond;
use super::flutter_deck_result::{Change, Condition, DeckFlutter, SubcaseFlutter};
use super::fullaircraft_deck::say_what_is_assumed;
use super::given_deck::GivenDeck;
use super::result_parts::as_json;
use crate::args::Common;
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::{progress, show};

/// Branches drawn; the table has all.
const DRAWN: usize = 12;
/// Damping g below which a branch is drawn at it.
const LEAST: f64 = -0.5;
/// What stands below a figure.
const CAPTION: &str = "Damping g and frequency over airspeed, in the deck's units; flutter is where a damping g goes above zero. \
    The twelve slowest oscillations; dampings below -0.5 are drawn there. The table has all roots, those without oscillation too.";

/// Runs the command on a deck or a study, or on one subcase of it.
pub(super) fn run(path: &Path, subcase: Option<u32>, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let given = GivenDeck::read(path, Aim::Flutter)?;
    let bulk = &given.bulk;
    let mut cases = flutter_cases(bulk).map_err(|error| error.or_in(path))?;
    if let Some(id) = subcase {
        cases.retain(|(case, _)| case.id == id);
        if cases.is_empty() {
            let error = nastran::InputError::in_file(path, format!("subcase {id} asks for no flutter"));
            return Err(error.with_help("name a subcase with FMETHOD").into());
        }
    }
    if let Some(cards) = bulk.unread_cards().filter(|_| !common.quiet) {
        show::note(&format!("these cards are not read: {cards}"));
    }
    let folder = ResultFolder::begin(&common.out("flutter_deck"))?;
    given.enter(&folder)?;
    let mut result = DeckFlutter {
        command: "flutter --deck",
        deck: path.display().to_string(),
        subcases: Vec::new(),
        seconds: 0.0,
    };
    let mut table = String::from(HEAD);
    let mut known: Option<(Subcase, FlutterDeck)> = None;
    for (case, card) in &cases {
        let same = known.take().filter(|(before, _)| case.has_modes_of(before));
        let deck = if let Some((_, deck)) = same {
            deck
        } else {
            let deck = FlutterDeck::new(bulk, case)?;
            if !common.quiet {
                let modal = &deck.modal;
                say_what_is_assumed(bulk, &modal.loose_boxes, modal.auto_held(), modal.reduction.clone());
                if let Some(remark) = bulk.damping_remark() {
                    show::note(&remark);
                }
            }
            deck
        };
        result.subcases.push(solved(&Task { bulk, deck: &deck, case, card }, common, &folder, &mut table)?);
        known = Some((case.clone(), deck));
    }
    folder.write_text("roots.csv", &table)?;
    result.seconds = start.elapsed().as_secs_f64();
    let json = as_json(&result)?;
    folder.write_json("result.json", &json)?;
    let out = folder.commit()?;
    let mut text = text(&result);
    let _ = write!(text, "{:.1} s; results in {}", result.seconds, out.display());
    show::summary(common, &text);
    show::json(common, &json)
}

/// A subcase and its card.
struct Task<'a> {
    bulk: &'a BulkData,
    deck: &'a FlutterDeck,
    case: &'a Subcase,
    card: &'a Flutter,
}

const HEAD: &str =
    "subcase,condition,mach,density,branch,k,velocity,damping_g,frequency_hz,growth_rate_1_s,omega_rad_s\n";

/// All conditions of a subcase.
fn solved(
    task: &Task,
    common: &Common,
    folder: &ResultFolder,
    table: &mut String,
) -> Result<SubcaseFlutter, Failure> {
    let Task { bulk, deck, case, card } = task;
    let points = deck.points(bulk, card)?;
    let mut machs: Vec<f64> =
        points.iter().flat_map(FlutterPoints::machs).map(|mach| deck.modal.nearest_mach(mach)).collect();
    machs.sort_by(f64::total_cmp);
    machs.dedup();
    let bar = progress::bar(common, machs.len() + points.len(), "flutter");
    let mut tables: Vec<(f64, GafTable)> = Vec::new();
    for mach in machs {
        tables.push((mach, deck.forces(mach).map_err(Failure::computation)?));
        bar.inc(1);
    }
    let mut conditions = Vec::new();
    for (at, group) in points.iter().enumerate() {
        let roots = deck.roots(group, &tables).map_err(Failure::computation)?;
        let name = format!("subcase_{}_condition_{}", case.id, at + 1);
        let lead = format!("{},{}", case.id, at + 1);
        match &roots {
            FlutterRoots::Curves(curves) => {
                *table += &rows(deck, group, curves, &lead);
                folder.write_figure(&name, CAPTION, figure(curves, &name))?;
            }
            FlutterRoots::ByFrequency(list) => {
                for (k, roots) in list {
                    for (branch, root) in roots.iter().enumerate() {
                        let (mach, density) = first(group);
                        let hz = root.omega_rad_s / TAU;
                        // Writing to a String cannot fail.
                        let _ = writeln!(
                            table,
                            "{lead},{mach},{density},{},{k},{},{},{hz},,{}",
                            branch + 1,
                            root.v_m_s,
                            root.g,
                            root.omega_rad_s
                        );
                    }
                }
            }
        }
        conditions.push(condition(deck, group, &roots));
        bar.inc(1);
    }
    progress::end(&bar);
    Ok(SubcaseFlutter {
        subcase: case.id,
        label: case.label.clone(),
        flutter: card.id,
        boxes: deck.modal.lattice.len(),
        frequencies_hz: deck.modal.omega_rad_s.iter().map(|omega| omega / TAU).collect(),
        rigid_modes: deck.modal.omega_rad_s.iter().filter(|omega| **omega == 0.0).count(),
        conditions,
    })
}

/// First Mach number and density of a group.
fn first(group: &FlutterPoints) -> (f64, f64) {
    match group {
        FlutterPoints::Speeds { mach, flows } => (*mach, flows[0].rho_kg_m3),
        FlutterPoints::Matched { machs, flows } => (machs[0], flows[0].rho_kg_m3),
        FlutterPoints::Frequencies { mach, density, .. } => (*mach, *density),
    }
}

/// One line a root, as Nastran's flutter summary has it.
fn rows(deck: &FlutterDeck, group: &FlutterPoints, curves: &CompleteCurves, lead: &str) -> String {
    let mut text = String::new();
    for (number, branch) in curves.branches.iter().enumerate() {
        for (place, root) in (branch.first..).zip(&branch.roots) {
            let flow = curves.flows[place];
            let mach = group.mach_at(flow.v_m_s);
            let k = root.p.im / flow.v_m_s / deck.modal.kappa(1.0);
            let g = root.damping_g().map_or_else(String::new, |g| g.to_string());
            let (density, v) = (flow.rho_kg_m3, flow.v_m_s);
            let (number, hz) = (number + 1, root.frequency_hz());
            // Writing to a String cannot fail.
            let _ = writeln!(
                text,
                "{lead},{mach},{density},{number},{k},{v},{g},{hz},{},{}",
                root.p.re, root.p.im
            );
        }
    }
    text
}

/// What is said of a group of points.
fn condition(deck: &FlutterDeck, group: &FlutterPoints, roots: &FlutterRoots) -> Condition {
    let (mach, density) = first(group);
    let (mut changes, mut remarks) = (Vec::new(), Vec::new());
    let asked = group.machs();
    let far: Vec<f64> =
        asked.iter().copied().filter(|mach| (deck.modal.nearest_mach(*mach) - mach).abs() > 1e-9).collect();
    if let Some(mach) = far.first() {
        remarks.push(format!(
            "MKAERO1 and MKAERO2 have no Mach number {mach}; forces are those of {}",
            deck.modal.nearest_mach(*mach)
        ));
    }
    let mut speeds = [f64::INFINITY, f64::NEG_INFINITY];
    let mut reach = |v: f64| speeds = [speeds[0].min(v), speeds[1].max(v)];
    match roots {
        FlutterRoots::Curves(curves) => {
            curves.flows.iter().for_each(|flow| reach(flow.v_m_s));
            changes.extend(curves.crossings.iter().map(|crossing| change(group, crossing)));
            remarks.extend(beyond::remark(deck, group, curves));
            for branch in &curves.begun_unstable {
                let before = curves.flows[curves.branches[*branch].first - 1].v_m_s;
                let first = curves.flows[curves.branches[*branch].first].v_m_s;
                remarks.push(format!(
                    "branch {} begins between {before} and {first} and is unstable at the latter",
                    branch + 1
                ));
            }
            let unstable = curves.branches.iter().filter(|branch| branch.at(0).is_some_and(Root::is_growing));
            let count = unstable.count();
            if count > 0 {
                remarks.push(format!("{count} roots are unstable at the lowest airspeed already"));
            }
        }
        FlutterRoots::ByFrequency(list) => {
            list.iter().flat_map(|(_, roots)| roots).for_each(|root| reach(root.v_m_s));
            remarks.push("the K method gives the damping that keeps an oscillation; see roots.csv".into());
        }
    }
    let machs = asked.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], mach| {
        [f64::min(low, *mach), f64::max(high, *mach)]
    });
    Condition { mach, machs, density, speeds, changes_of_stability: changes, remarks }
}

fn change(group: &FlutterPoints, crossing: &Crossing) -> Change {
    Change {
        velocity: crossing.flow.v_m_s,
        mach: group.mach_at(crossing.flow.v_m_s),
        density: crossing.flow.rho_kg_m3,
        frequency_hz: crossing.omega_rad_s / TAU,
        branch: crossing.branch + 1,
        becomes: if crossing.unstable { "unstable" } else { "stable" },
        beyond_table: crossing.beyond_table,
    }
}

fn figure(curves: &CompleteCurves, name: &str) -> Figure {
    let moving = || {
        let all = curves.branches.iter().enumerate();
        all.filter(|(_, branch)| branch.roots.iter().any(|root| root.p.im > 0.0)).take(DRAWN)
    };
    let panel = |label: &str, value: &dyn Fn(&Root) -> f64| {
        let series = moving().map(|(number, branch)| {
            let x =
                branch.roots.iter().enumerate().map(|(i, _)| curves.flows[branch.first + i].v_m_s).collect();
            let y = branch.roots.iter().map(value).collect();
            Series::new(format!("branch {}", number + 1), x, y, Style::Line)
        });
        Panel::new(label, "airspeed (the deck's unit)", label, series.collect())
    };
    let panels = vec![
        panel("damping g, not below -0.5", &|root| root.damping_g().map_or(f64::NAN, |g| g.max(LEAST))),
        panel("frequency (Hz)", &|root| if root.p.im > 0.0 { root.frequency_hz() } else { f64::NAN }),
    ];
    Figure::new(name.replace('_', " "), panels, 2)
}

/// The Mach number of a condition, or from which to which.
fn machs(condition: &Condition) -> String {
    let [low, high] = condition.machs;
    if low == high { format!("{low:.4}") } else { format!("{low:.4} to {high:.4}") }
}

fn text(result: &DeckFlutter) -> String {
    let mut text = String::new();
    for case in &result.subcases {
        let _ = writeln!(
            text,
            "subcase {} {}: FLUTTER {}, {} boxes, {} modes, {} of them rigid",
            case.subcase,
            case.label,
            case.flutter,
            case.boxes,
            case.frequencies_hz.len(),
            case.rigid_modes
        );
        let mut table = Table::new(&["Mach", "density", "velocity", "frequency (Hz)", "branch", "becomes"]);
        for condition in &case.conditions {
            for change in &condition.changes_of_stability {
                table.row([
                    format!("{:.4}", change.mach),
                    format!("{:.5e}", change.density),
                    format!("{:.4}", change.velocity),
                    format!("{:.4}", change.frequency_hz),
                    change.branch.to_string(),
                    change.becomes.to_owned(),
                ]);
            }
            if condition.changes_of_stability.is_empty() {
                let density = format!("{:.5e}", condition.density);
                let [low, high] = condition.speeds;
                table.row([
                    machs(condition),
                    density,
                    format!("{low:.4} to {high:.4}"),
                    "-".into(),
                    "-".into(),
                    "no change".into(),
                ]);
            }
        }
        let _ = write!(text, "{table}");
        for condition in &case.conditions {
            for remark in &condition.remarks {
                let (machs, density) = (machs(condition), condition.density);
                let _ = writeln!(text, "Mach {machs}, density {density:.5e}: {remark}");
            }
        }
    }
    text
}
