//! `statics`: displacements and reactions of a deck's structure under a load set, or of a wing in steady air, with small or
//! large deflections.

use clap::Args;
use std::fmt::Write as _;
use std::path::PathBuf;
use std::time::Instant;

use faer::Mat;
use fullaircraft::{InertiaRelief, clamped};
use nastran::{BulkData, InputError};
use report::Table;
use structure::nonlinear::{Controls, LargeDeflection, Loads, Path, reactions_of};
use structure::{Flexibility, enforced_motions, loads_of, thermal_loads};

use super::statics_air::{self, AirArgs};
use super::statics_cases::{self, Asked};
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
    /// A Nastran deck with its loads (FORCE, MOMENT, FORCE1, MOMENT1, FORCE2, MOMENT2, PLOAD, PLOAD1, PLOAD2, PLOAD4, GRAV, RFORCE, LOAD; SPCD; TEMP, TEMPD, TEMPRB, TEMPP1)
    #[arg(long, value_name = "FILE", required_unless_present = "wing")]
    pub(crate) deck: Option<PathBuf>,
    /// A wing in steady air
    #[command(flatten)]
    pub(crate) air: AirArgs,
    /// The load set [default: LOAD of each subcase; without a case control the only one, or the only LOAD]
    #[arg(long, value_name = "SET", value_parser = whole::<99_999_999>, conflicts_with = "wing")]
    pub(crate) load: Option<usize>,
    /// The subcase of the deck whose loads and boundary conditions hold [default: all that select loads]
    #[arg(long, value_name = "N", conflicts_with = "wing")]
    pub(crate) subcase: Option<u32>,
    /// Large deflections: every element turns with the structure, and so do pressures, FORCE1 and the air [default: as PARAM
    /// LGDISP of a nonlinear solution (SOL 106, 400) or the wing's `geometry` says]
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
    let mut bulk = nastran::read_deck(deck)?;
    for remark in bulk.combination_remarks() {
        show::note(&remark);
    }
    statics_cases::refuse_nonlinear_materials(&bulk, deck)?;
    statics_cases::set_aside_lgdisp(&mut bulk, deck)?;
    let wanted = |value: Option<usize>| value.and_then(|value| u32::try_from(value).ok());
    let cases =
        statics_cases::asked(&bulk, wanted(args.load), args.subcase).map_err(|error| error.or_in(deck))?;
    let folder = ResultFolder::begin(&common.out("statics"))?;
    folder.input("structure", deck)?;
    let mut known: Option<Bounded> = None;
    let mut results: Vec<StaticsResult> = Vec::new();
    let mut text = String::new();
    for case in &cases {
        let bounded = match known.take().filter(|known| known.case.is_bounded_as(case)) {
            Some(known) => known,
            None => Bounded::new(deck, &bulk, case)?,
        };
        let structure = &bounded.structure;
        let loads = match case.load {
            Some(set) => loads_of(&structure.bulk, set).map_err(|error| error.or_in(deck))?,
            None => Loads::default(),
        };
        let linear = bounded.linear(case, &loads)?;
        let walked = bounded.walked(args, case, &loads)?;
        let answer = Answer { structure, linear: &linear, large: walked.as_ref() };
        // The first subcase has the plain names, as a deck of one has.
        answer.write(&folder, results.first().and(case.subcase))?;
        let result = result(&answer, case, start.elapsed().as_secs_f64());
        text += &summary(&result);
        if let Some(set) = case.temperatures[0] {
            let _ = writeln!(text, "temperatures of set {set} expand the structure");
        }
        results.push(result);
        known = Some(bounded);
    }
    let mut results = results.into_iter();
    let Some(first) = results.next() else { return Err(Failure::Computation("no load was computed".into())) };
    let result = StaticsResult { further: results.collect(), ..first };
    let json = as_json(&result)?;
    folder.write_json("result.json", &json)?;
    let out = folder.commit()?;
    let _ = write!(text, "written to {} in {:.1} s", out.display(), start.elapsed().as_secs_f64());
    show::summary(common, &text);
    show::json(common, &json)
}

/// A structure under the boundary conditions of a case, factorised.
struct Bounded {
    case: Asked,
    structure: Structure,
    flexibility: Flexibility,
    /// The deck under these conditions.
    bulk: BulkData,
    /// Where the deck asks for inertia relief.
    relief: Option<InertiaRelief>,
}

impl Bounded {
    fn new(deck: &std::path::Path, bulk: &BulkData, case: &Asked) -> Result<Self, Failure> {
        let name = deck.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let mut bulk = bulk.bounded(case.subcase).map_err(|error| error.or_in(deck))?.into_owned();
        // SUPORT1 holds where a subcase selects it.
        bulk.supports.retain(|card| card.set.is_none() || case.subcase.is_some());
        let relief = if statics_cases::asks_for_inertia_relief(&bulk).map_err(|error| error.or_in(deck))? {
            Some(InertiaRelief::new(&bulk).map_err(|error| error.or_in(deck))?)
        } else {
            None
        };
        if relief.is_none() && !bulk.supports.is_empty() {
            show::note(
                "the motions of SUPORT are clamped (PARAM,INREL,-1 lets the structure accelerate in them)",
            );
        }
        let bulk = clamped(bulk);
        let structure = Structure::of_cards(name, deck.to_path_buf(), bulk.clone(), Some(None))?;
        let flexibility = Flexibility::new(&structure.system).map_err(Failure::computation)?;
        Ok(Self { case: case.clone(), structure, flexibility, bulk, relief })
    }

    /// Motions that SPC and the SPCD of a load set enforce, six a node.
    fn enforced(&self, load: Option<u32>) -> Result<Option<Mat<f64>>, InputError> {
        let motions = enforced_motions(&self.bulk, &self.structure.model, load)
            .map_err(|error| error.or_in(&self.structure.path))?;
        Ok(motions.map(|motions| Mat::from_fn(motions.len(), 1, |i, _| motions[i])))
    }

    /// The way of the load where deflections are large; nothing where they are small.
    fn walked(&self, args: &StaticsArgs, case: &Asked, loads: &Loads) -> Result<Option<Walked>, Failure> {
        let bulk = &self.structure.bulk;
        if !args.nonlinear && bulk.parameters.get("LGDISP").is_none_or(|value| *value <= 0.0) {
            return Ok(None);
        }
        let refused = |message: &str, help: &str| {
            Err(InputError::in_file(&self.structure.path, message).with_help(help).into())
        };
        if self.relief.is_some() {
            let message = "large deflections know no inertia relief";
            return refused(message, "leave out --nonlinear and PARAM LGDISP, or PARAM INREL and SUPORT");
        }
        if case.temperatures[0].is_some() || self.enforced(case.load)?.is_some() {
            let message = "large deflections know no motions that SPC or SPCD enforces, and no temperatures";
            return refused(message, "leave out --nonlinear and PARAM LGDISP, or press by forces");
        }
        let turns = |set: u32| bulk.spins.iter().any(|spin| spin.set == set);
        let sets = case.load.map_or_else(|| Ok(Vec::new()), |set| bulk.summed_sets(set))?;
        if sets.iter().any(|(_, set)| turns(*set)) {
            let message = "large deflections know no RFORCE, whose forces grow as the masses move outward";
            return refused(message, "leave out --nonlinear and PARAM LGDISP, or give its forces as FORCE");
        }
        large(&self.structure, loads, args.steps.unwrap_or(1)).map(Some)
    }

    /// Forces on the nodes (those that would hold the free expansion among them), displacements and reactions.
    fn linear(&self, case: &Asked, loads: &Loads) -> Result<statics_files::State, Failure> {
        let system = &self.structure.system;
        let mut forces = system.forces_of(loads);
        if let [Some(warm), initial] = case.temperatures {
            let expanding = thermal_loads(&self.bulk, warm, initial)
                .map_err(|error| error.or_in(&self.structure.path))?;
            (0..expanding.len()).for_each(|dof| forces[(dof, 0)] += expanding[dof]);
        }
        let enforced = self.enforced(case.load)?;
        let mut pushing = forces.clone();
        if let Some(relief) = &self.relief {
            let (inertia, accelerations) =
                relief.inertia(forces.as_ref()).map_err(|error| error.or_in(&self.structure.path))?;
            pushing += inertia;
            statics_cases::say_accelerations(&accelerations);
        }
        let pushed = pushing.clone();
        if let Some(enforced) = &enforced {
            pushing -= system.elastic_loads(enforced.as_ref());
        }
        let mut u_g =
            system.expand(self.flexibility.displacements(system.reduce(pushing.as_ref()).as_ref()).as_ref());
        if let Some(enforced) = &enforced {
            u_g += enforced;
        }
        let unbalanced = system.elastic_loads(u_g.as_ref()) - pushed;
        let unbalanced: Vec<f64> = unbalanced.col(0).iter().copied().collect();
        Ok(statics_files::State {
            displacements: u_g.col(0).iter().copied().collect(),
            forces: forces.col(0).iter().copied().collect(),
            reactions: reactions_of(&self.structure.model, &unbalanced)
                .map_err(|error| error.or_in(&self.structure.path))?,
        })
    }
}

/// The way of the load, the end as the linear answer has it, and the shapes on the way.
type Walked = (Path, statics_files::State, Vec<Vec<f64>>);

/// The way of the load.
fn large(structure: &Structure, loads: &Loads, steps: usize) -> Result<Walked, Failure> {
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

fn result(answer: &Answer, case: &Asked, seconds: f64) -> StaticsResult {
    let structure = answer.structure;
    let node = answer.largest();
    let of = |displacements: &[f64]| [0, 1, 2].map(|axis| displacements[6 * node + axis]);
    let (force, moment) = answer.resultant();
    let steps = answer.large.iter().flat_map(|(path, _, shapes)| path.points.iter().zip(shapes));
    StaticsResult {
        command: "statics",
        structure: structure.name.clone(),
        subcase: case.subcase,
        load_set: case.load.unwrap_or_default(),
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
        further: Vec::new(),
    }
}

fn summary(result: &StaticsResult) -> String {
    let three = |values: &[f64; 3]| values.map(|value| format!("{value:.6}")).join(", ");
    let mut text = format!(
        "{}{}, load set {}: force {} N, {} deflections\n",
        result.structure,
        result.subcase.map_or_else(String::new, |subcase| format!(", subcase {subcase}")),
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
