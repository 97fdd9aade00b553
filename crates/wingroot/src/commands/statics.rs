//! `statics`: displacements and reactions of a deck's structure under a load set, or of a wing in steady air, with small or
//! large deflections.

use clap::Args;
use std::fmt::Write as _;
use std::path::PathBuf;
use std::time::Instant;

use nastran::InputError;
use report::Table;
use structure::nonlinear::{Controls, LargeDeflection, Loads, Path, reactions_of};
use structure::{Flexibility, load_sets, loads_of};

use super::statics_air::{self, AirArgs};
use super::statics_files::{self, Answer};
use crate::args::{Common, whole};
use crate::commands::result_parts::as_json;
use crate::commands::statics_result::{StaticsResult, StepResult};
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::show;
use crate::structures::Structure;

/// Options of `statics`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  wingroot statics --deck my_wing.bdf
  wingroot statics --deck my_wing.bdf --load 20
  wingroot statics --deck my_wing.bdf --load 20 --nonlinear --steps 20
  wingroot statics --wing my_wing/wing.ron --airspeeds 20,30,40 --alpha 5 --nonlinear")]
pub struct StaticsArgs {
    /// A Nastran deck with its loads (FORCE, MOMENT, FORCE1, MOMENT1, FORCE2, MOMENT2, PLOAD, PLOAD2, PLOAD4, GRAV, LOAD)
    #[arg(long, value_name = "FILE", required_unless_present = "wing")]
    pub(crate) deck: Option<PathBuf>,
    /// A wing in steady air
    #[command(flatten)]
    pub(crate) air: AirArgs,
    /// The load set [default: LOAD of the subcase, or the only set, or the only sum]
    #[arg(long, value_name = "SET", value_parser = whole::<99_999_999>, conflicts_with = "wing")]
    pub(crate) load: Option<usize>,
    /// The subcase whose LOAD and boundary conditions are taken [default: the only one]
    #[arg(long, value_name = "ID", conflicts_with = "wing")]
    pub(crate) subcase: Option<u32>,
    /// Large deflections: every element turns with the structure, and so do pressures, FORCE1 and the air [default: as PARAM
    /// LGDISP or the wing's `geometry` says]
    #[arg(long)]
    pub(crate) nonlinear: bool,
    /// Equal shares of the load at which large deflections are written
    #[arg(long, value_name = "N", default_value = "10", value_parser = whole::<1000>, conflicts_with = "wing")]
    pub(crate) steps: Option<usize>,
}

/// Runs the command.
pub(crate) fn run(args: &StaticsArgs, common: &Common) -> Result<(), Failure> {
    let Some(deck) = &args.deck else { return statics_air::run(&args.air, args.nonlinear, common) };
    let start = Instant::now();
    let structure = Structure::read_in(None, Some(deck), args.subcase)?;
    let set = load_set(args, &structure)?;
    let loads = loads_of(&structure.bulk, set).map_err(|error| error.or_in(&structure.path))?;
    let linear = linear(&structure, &loads)?;
    let is_large =
        args.nonlinear || structure.bulk.parameters.get("LGDISP").is_some_and(|value| *value > 0.0);
    let walked = if is_large { Some(large(&structure, &loads, args.steps.unwrap_or(1))?) } else { None };
    let folder = ResultFolder::begin(&common.out("statics"))?;
    folder.input("structure", &structure.path)?;
    let answer = Answer { structure: &structure, linear: &linear, large: walked.as_ref() };
    answer.write(&folder)?;
    let result = result(&answer, set, start.elapsed().as_secs_f64());
    let json = as_json(&result)?;
    folder.write_json("result.json", &json)?;
    let out = folder.commit()?;
    let mut text = summary(&result);
    let _ = write!(text, "written to {} in {:.1} s", out.display(), start.elapsed().as_secs_f64());
    show::summary(common, &text);
    show::json(common, &json)
}

/// The set that is asked for, or the one there can be no doubt about.
fn load_set(args: &StaticsArgs, structure: &Structure) -> Result<u32, Failure> {
    if let Some(set) = args.load.and_then(|set| u32::try_from(set).ok()) {
        return Ok(set);
    }
    let mut selected: Vec<(u32, u32)> = structure
        .bulk
        .subcases
        .iter()
        .filter(|case| args.subcase.is_none_or(|id| case.id == id))
        .filter_map(|case| Some((case.id, case.load?)))
        .collect();
    selected.dedup_by_key(|(_, load)| *load);
    match selected.as_slice() {
        [] => {}
        [(_, set)] => return Ok(*set),
        _ => {
            let list: Vec<String> = selected.iter().map(|(id, load)| format!("{id} (LOAD {load})")).collect();
            let error = InputError::in_file(&structure.path, "the deck's subcases have several loads");
            return Err(error.with_help(format!("name one by --subcase: {}", list.join(", "))).into());
        }
    }
    let all = load_sets(&structure.bulk);
    let sums: Vec<u32> = structure.bulk.load_sums.keys().copied().collect();
    match (all.as_slice(), sums.as_slice()) {
        ([set], _) | (_, [set]) => Ok(*set),
        ([], _) => {
            let error = InputError::in_file(&structure.path, "the deck has no loads");
            Err(error
                .with_help("FORCE, MOMENT, FORCE1, MOMENT1, FORCE2, MOMENT2, PLOAD, PLOAD2, PLOAD4, GRAV and LOAD are read")
                .into())
        }
        _ => {
            let list: Vec<String> = all.iter().map(u32::to_string).collect();
            let error = InputError::in_file(&structure.path, "the deck has several load sets");
            Err(error.with_help(format!("name one by --load: {}", list.join(", "))).into())
        }
    }
}

/// Forces on the nodes, displacements and reactions.
fn linear(structure: &Structure, loads: &Loads) -> Result<statics_files::State, Failure> {
    let system = &structure.system;
    let forces = system.forces_of(loads);
    let flexibility = Flexibility::new(system).map_err(Failure::computation)?;
    let u_g = system.expand(flexibility.displacements(system.reduce(forces.as_ref()).as_ref()).as_ref());
    let unbalanced = system.elastic_loads(u_g.as_ref()) - &forces;
    let unbalanced: Vec<f64> = unbalanced.col(0).iter().copied().collect();
    Ok(statics_files::State {
        displacements: u_g.col(0).iter().copied().collect(),
        forces: forces.col(0).iter().copied().collect(),
        reactions: reactions_of(&structure.model, &unbalanced)
            .map_err(|error| error.or_in(&structure.path))?,
    })
}

/// The way of the load, and the end as the linear answer has it.
fn large(
    structure: &Structure,
    loads: &Loads,
    steps: usize,
) -> Result<(Path, statics_files::State, Vec<Vec<f64>>), Failure> {
    let wing = LargeDeflection::new(&structure.model).map_err(|error| error.or_in(&structure.path))?;
    let stops = (1..=steps).map(|step| step as f64 / steps as f64).collect();
    let controls = Controls { stops, ..Controls::default() };
    let path =
        wing.path(&wing.undeformed(), &Loads::default(), loads, &controls).map_err(Failure::computation)?;
    let end = &path.end().state;
    let state = statics_files::State {
        displacements: end.displacements(wing.nodes()),
        forces: wing.load_forces(end, loads),
        reactions: wing.reactions(end, loads),
    };
    let shapes = path.points.iter().map(|point| point.state.displacements(wing.nodes())).collect();
    Ok((path, state, shapes))
}

fn result(answer: &Answer, load_set: u32, seconds: f64) -> StaticsResult {
    let structure = answer.structure;
    let node = answer.largest();
    let of = |displacements: &[f64]| [0, 1, 2].map(|axis| displacements[6 * node + axis]);
    let (force, moment) = answer.resultant();
    let steps = answer.large.iter().flat_map(|(path, _, shapes)| path.points.iter().zip(shapes));
    StaticsResult {
        command: "statics",
        structure: structure.name.clone(),
        load_set,
        large_deflections: answer.large.is_some(),
        grids: structure.system.node_count(),
        free_motions: structure.system.free_count(),
        applied_force_n: force,
        applied_moment_nm: moment,
        grid: structure.system.node_ids()[node],
        displacement_m: of(&answer.end().displacements),
        linear_displacement_m: of(&answer.linear.displacements),
        steps: steps
            .map(|(point, shape)| StepResult {
                load_factor: point.load_factor,
                iterations: point.iterations,
                displacement_m: of(shape),
                negative_pivots: point.negative_pivots,
            })
            .collect(),
        largest_local_rotation_deg: answer
            .large
            .map(|(path, _, _)| path.end().largest_local_rotation.0.to_degrees()),
        seconds,
    }
}

fn summary(result: &StaticsResult) -> String {
    let three = |values: &[f64; 3]| values.map(|value| format!("{value:.6}")).join(", ");
    let mut text = format!(
        "{}, load set {}: force {} N, {} deflections\n",
        result.structure,
        result.load_set,
        three(&result.applied_force_n),
        if result.large_deflections { "large" } else { "small" },
    );
    let _ = writeln!(text, "GRID {} moves most: {} m", result.grid, three(&result.displacement_m));
    if !result.large_deflections {
        return text;
    }
    let _ = writeln!(text, "linear theory says: {} m", three(&result.linear_displacement_m));
    let mut table = Table::new(&["share of the load", "iterations", "x (m)", "y (m)", "z (m)"]);
    for step in &result.steps {
        let mut row = vec![format!("{:.4}", step.load_factor), step.iterations.to_string()];
        row.extend(step.displacement_m.iter().map(|value| format!("{value:.6}")));
        table.row(row);
    }
    let _ = writeln!(text, "{table}");
    if let Some(angle) = result.largest_local_rotation_deg.filter(|angle| *angle > 30.0) {
        let _ = writeln!(
            text,
            "a grid turns {angle:.0} degrees within an element: its mesh is too coarse for this load"
        );
    }
    text
}
