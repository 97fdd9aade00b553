//! `fullaircraft --cases`: a grid of airspeeds, load factors and maneuvers with both models, and the load envelope; all in one
//! process, or as a share, preparation, merge and status of many.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::time::Instant;

use aero::Corrections;
use fullaircraft::{Aircraft, CaseResult, CasesFile, TrimTools};
use nastran::InputError;

use crate::args::Common;
use crate::commands::fullaircraft_cases_flown::{COMMAND, Flown, Flying};
use crate::commands::fullaircraft_cases_merged::{Merged, remark, table};
use crate::commands::fullaircraft_draws::Draws;
use crate::commands::fullaircraft_prepared::{FullaircraftArgs, PreparedCases, prepared_cases};
use crate::failure::Failure;
use crate::fingerprint::Fingerprint;
use crate::show;
use crate::store::{Inputs, Shared, Store, Told};
use crate::sweep::estimate::Estimate;
use crate::sweep::share::Share;
use crate::sweep::split::{Weighed, share_of};
use crate::sweep::{Task, merging, status};

/// What a task needs beside the cases.
struct Here<'a> {
    common: &'a Common,
    target: PathBuf,
    inputs: Vec<(&'static str, PathBuf)>,
    /// Where the corrections come from, in words.
    origin: String,
    start: Instant,
}

/// Runs the command.
pub(crate) fn run(path: &Path, args: &FullaircraftArgs, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let task = args.sweep.task()?;
    let target = common.out(args.results());
    let file = CasesFile::read(path)?;
    let keeps = matches!(task, Task::Prepare | Task::Part(_));
    let shared = Shared::new(&Store::folder_beside(&target)?, keeps);
    let PreparedCases { mut aircraft, mut found, corrections, origin, ensemble, mut inputs } =
        prepared_cases(args, common, &shared)?;
    inputs.push(("cases", file.path.clone()));
    if !aircraft.wing.deflection.is_empty() && !common.quiet {
        show::note(
            "cases fly surfaces to where they are commanded: the wing's deflection correction is left out",
        );
    }
    // maneuvers in time know the wing's stations only
    for aircraft in std::iter::once(&mut aircraft).chain(&mut found) {
        aircraft.wing.stations.extend(file.stations.iter().cloned());
    }
    let of_found = found.as_ref().map(|found| tools(found, &file)).transpose()?;
    let tools = tools(&aircraft, &file)?;
    let updated = found.as_ref().unwrap_or(&aircraft).with_corrections(&corrections)?;
    let models = [aircraft.uncorrected(), updated];
    let limits = aircraft.file.lift_limits()?;
    let depends = inputs_of(&aircraft, found.as_ref(), &corrections, &file);
    let draws = Draws::new(ensemble.as_ref(), &aircraft.file, &shared);
    let depends = draws.inputs().iter().fold(depends, |all, text| all.with("ensemble", text));
    let flying = Flying {
        grid: file.grid(),
        tools: &tools,
        models: [&models[0], &models[1]],
        found: of_found.as_ref(),
        limits: limits.as_deref(),
        store: Store::beside(&target, depends)?.labelled(task.label()),
        shared: &shared,
        common,
        draws,
    };
    let here = Here { common, target, inputs, origin, start };
    let done = match task {
        Task::All => all(flying, &file, &here),
        Task::Part(share) => part(&flying, share, &here),
        Task::Case(hash) => again(&flying, hash, common),
        Task::Prepare => prepare(&flying, common),
        Task::Merge => merge(&flying, &file, &here, None),
        Task::Estimate => estimate(&flying, here.start).map(|estimate| args.sweep.estimate.put(estimate)),
        Task::Status => {
            let status = status::status(COMMAND, &flying.store, flying.row());
            status::show(common, &flying.store, &status)
        }
    };
    done.map_err(|failure| in_file(failure, &file))
}

/// What finished cases depend on.
fn inputs_of(
    aircraft: &Aircraft,
    found: Option<&Aircraft>,
    corrections: &Corrections,
    file: &CasesFile,
) -> Inputs {
    let depends = aircraft.inputs_of_cases(corrections, file);
    let depends = depends.iter().fold(Inputs::default(), |all, (name, text)| all.with(name, text));
    let found = found.map(|found| format!("{:?}", found.wing.departure));
    found.iter().fold(depends, |all, text| all.with("found", text))
}

/// All cases and their results; the store goes when these are in place.
fn all(flying: Flying<'_>, file: &CasesFile, here: &Here<'_>) -> Result<(), Failure> {
    let flown = flying.fly(&share_of(flying.row(), Share { number: 1, of: 1 }))?;
    merge(&flying, file, here, Some(&flown))?;
    flying.store.close()
}

/// A share of the cases, which are kept; results are made by `merge`.
fn part(flying: &Flying<'_>, share: Share, here: &Here<'_>) -> Result<(), Failure> {
    let own = share_of(flying.row(), share);
    let flown = flying.fly(&own)?;
    let text = format!(
        "part {share}: {} of {} cases, {} of them not to be flown, {} finished before; {} factorisations, {:.2} s; kept in {}\n",
        own.len(),
        flying.count(),
        flown.refused,
        flown.before,
        flying.tools.factorisations(),
        here.start.elapsed().as_secs_f64(),
        flying.store.folder().display()
    );
    show::summary(here.common, &text);
    Ok(())
}

/// One case, whether it is finished or not; it is kept if it was not.
fn again(flying: &Flying<'_>, hash: Fingerprint, common: &Common) -> Result<(), Failure> {
    let Some(case) = flying.row().into_iter().find(|case| case.hash == hash) else {
        return Err(merging::no_such_case(hash));
    };
    let before: Option<CaseResult> = flying.kept(case.number);
    let result = flying.fly_one(case.number)?;
    let outcome = match (&result.refused, &before) {
        (Some(why), _) => format!("cannot be flown: {why}"),
        (None, Some(before)) if *before == result => "the same to the last digit as kept".to_owned(),
        (None, Some(_)) => "its digits are not those that are kept".to_owned(),
        (None, None) => "flown and kept".to_owned(),
    };
    show::summary(common, &format!("{}, {}: {outcome}\n", result.model, result.label()));
    show::json(common, &result)
}

/// What all cases share, computed and kept before many processes begin.
fn prepare(flying: &Flying<'_>, common: &Common) -> Result<(), Failure> {
    merging::one_state(&flying.store)?;
    flying.leave(flying.grid.cases().any(|case| case.is_dynamic()))?;
    let (files, bytes) = flying.shared.size();
    let text = format!(
        "{} cases of {} boxes; all names are known, and nothing in {} is of another state; \
         {files} files of {:.1} MB there spare parts what all cases share\n",
        flying.count(),
        flying.tools.aircraft.flow.lattice.len(),
        flying.store.folder().display(),
        bytes as f64 / 1e6
    );
    show::summary(common, &text);
    Ok(())
}

/// The first, the middle and the last case of the row flown, and what all of them will take.
fn estimate(flying: &Flying<'_>, start: Instant) -> Result<Estimate, Failure> {
    let row = share_of(flying.row(), Share { number: 1, of: 1 });
    let places = BTreeSet::from([0, row.len() / 2, row.len() - 1]);
    let three: Vec<Weighed> = places.into_iter().map(|at| row[at]).collect();
    flying.fly(&three)?;
    let told: Vec<(Weighed, Told)> =
        three.iter().filter_map(|case| Some((*case, flying.store.told_of(case.hash)?))).collect();
    Ok(Estimate::of_some(&row, &told, start))
}

/// Results from the store, case by case.
fn merge(
    flying: &Flying<'_>,
    file: &CasesFile,
    here: &Here<'_>,
    flown: Option<&Flown>,
) -> Result<(), Failure> {
    if flown.is_none() {
        merging::one_state(&flying.store)?;
    }
    merging::complete(&flying.store, &flying.missing(), || flying.row())?;
    merging::remarks(&flying.store);
    let merged = Merged::of(flying, file)?;
    let out = merged.write(flying, &here.target, &here.inputs)?;
    let summary = merged.summary;
    if !here.common.quiet {
        remark(&summary);
    }
    let flown = flown.map_or_else(
        || ", merged".to_owned(),
        |flown| {
            format!(", {} finished before; {} factorisations", flown.before, flying.tools.factorisations())
        },
    );
    let text = format!(
        "{}\n{} cases, {} of them not to be flown{flown}, {:.2} s\n\
         corrections at {} m/s: {}\n{}results in {}\n",
        table(&summary.envelope),
        summary.cases,
        summary.refused.len(),
        here.start.elapsed().as_secs_f64(),
        summary.correction_airspeed_m_s,
        here.origin,
        summary.intervals_from.as_ref().map_or_else(String::new, |from| format!("90 % intervals: {from}\n")),
        out.display()
    );
    show::summary(here.common, &text);
    show::json(here.common, &summary)?;
    if summary.refused.len() == summary.cases {
        return Err(Failure::Computation("none of the cases can be flown".into()));
    }
    Ok(())
}

/// What trims are made with, once the aircraft knows every name in the file.
fn tools<'a>(aircraft: &'a Aircraft, file: &CasesFile) -> Result<TrimTools<'a>, Failure> {
    let tools = TrimTools::new(aircraft, &[]).map_err(|error| in_file(error.into(), file))?;
    file.check_names(&tools)?;
    Ok(tools)
}

/// Input that no file was named for is the file's of the cases.
fn in_file(failure: Failure, file: &CasesFile) -> Failure {
    match failure {
        Failure::Input(error) if error.span.is_none() => {
            let here = InputError::in_file(&file.path, error.message);
            Failure::Input(InputError { help: error.help, ..here })
        }
        other => other,
    }
}
