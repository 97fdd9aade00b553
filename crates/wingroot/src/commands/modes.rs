//! `modes`: natural frequencies and shapes of a wing's or a deck's structure; with measurements, their fit.

use clap::Args;
use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::path::PathBuf;
use std::time::Instant;

use nastran::EigenMethod;
use rayon::prelude::*;
use report::Table;
use structure::{Modes, ModesError, count_below, effective_masses, masses_along, normal_modes};

use super::modes_pictures::hertz;
use super::{modes_pictures, modes_shapes, modes_update};
use crate::args::{Common, whole};
use crate::commands::modes_result::ModesResult;
use crate::commands::result_parts::as_json;
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::show;
use crate::structures::Structure;

/// Options of `modes`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  wingroot modes
  wingroot modes --deck my_wing.bdf --count 20
  wingroot modes --wing my_wing/wing.ron --measured my_wing/vibration_test.ron")]
pub struct ModesArgs {
    /// The wing [default: wing.ron of the current folder]
    #[arg(long, value_name = "FILE", conflicts_with = "deck")]
    pub(crate) wing: Option<PathBuf>,
    /// A Nastran deck instead of a wing
    #[arg(long, value_name = "FILE")]
    pub(crate) deck: Option<PathBuf>,
    /// The subcase of the deck whose boundary conditions hold [default: the only ones]
    #[arg(long, value_name = "N", requires = "deck")]
    pub(crate) subcase: Option<u32>,
    /// Number of modes [default: as METHOD of the deck asks, or 10; as many as there are]
    #[arg(long, value_name = "N", value_parser = whole::<10_000>)]
    pub(crate) count: Option<usize>,
    /// Measured frequencies, shapes and deflections, and the regions whose stiffness and mass are fitted to them
    #[arg(long, value_name = "FILE")]
    pub(crate) measured: Option<PathBuf>,
}

/// Modes if nothing is said, or as many as there are.
const COUNT: usize = 10;

/// Runs the command.
pub(crate) fn run(args: &ModesArgs, common: &Common) -> Result<(), Failure> {
    if let Some(measured) = &args.measured {
        return modes_update::run(args.wing.as_deref(), args.deck.as_deref(), measured, common);
    }
    let start = Instant::now();
    let mut structure = Structure::read_in(args.wing.as_deref(), args.deck.as_deref(), args.subcase)?;
    if args.deck.is_some() {
        structure = structure.reduced(args.subcase)?;
    }
    let modes = match asked(&structure, args.subcase).filter(|_| args.count.is_none() && args.deck.is_some())
    {
        Some(method) => solve_as(&structure, method)?,
        None => solve(&structure, args.count)?,
    };
    let folder = ResultFolder::begin(&common.out("modes"))?;
    folder.input("structure", &structure.path)?;
    let cells = structure::mesh::cells(&structure.bulk, &structure.system);
    let files: Vec<String> =
        (1..=modes.omega_rad_s.len()).map(|mode| format!("mode_{mode:02}.vtu")).collect();
    let frame = modes_pictures::frame(&structure.system, &cells);
    files.par_iter().enumerate().try_for_each(|(mode, file)| {
        let moved = modes_pictures::moved(&modes_pictures::scaled(&structure.system, &modes, mode));
        folder.write_text(file, &frame.with(&moved))
    })?;
    modes_shapes::write(&folder, &structure.name, &structure.system, &cells, &modes, &files)?;
    if let Some(figure) = modes_pictures::figure(&structure, &modes) {
        let caption = "Displacements of all nodes, scaled to the largest of a mode.";
        folder.write_figure("shapes", caption, figure)?;
    }
    let result = as_json(&result(&structure, &modes, start.elapsed().as_secs_f64()))?;
    folder.write_json("result.json", &result)?;
    let out = folder.commit()?;
    let mut text = summary(&structure, &modes);
    let _ = write!(text, "written to {} in {:.1} s", out.display(), start.elapsed().as_secs_f64());
    show::summary(common, &text);
    show::json(common, &result)
}

/// As many modes as asked for, or as there are; without a wish [`COUNT`] of them.
pub(crate) fn solve(structure: &Structure, count: Option<usize>) -> Result<Modes, Failure> {
    let wanted = count.unwrap_or(COUNT).min(structure.system.free_count()).max(1);
    match normal_modes(&structure.system, wanted) {
        Err(ModesError::TooMany { available, .. }) if available > 0 => {
            if let Some(count) = count {
                show::note(&format!("{count} modes were asked for; the masses allow {available}"));
            }
            normal_modes(&structure.system, available).map_err(Failure::computation)
        }
        modes => modes.map_err(Failure::computation),
    }
}

/// The EIGRL or EIGR that the deck's case control selects.
fn asked(structure: &Structure, subcase: Option<u32>) -> Option<&EigenMethod> {
    let mut cases = structure.bulk.subcases.iter().filter(|case| subcase.is_none_or(|id| case.id == id));
    structure.bulk.eigen_methods.get(&cases.find_map(|case| case.method)?)
}

/// The modes of an EIGRL or EIGR: its number, those up to its highest frequency, or both.
fn solve_as(structure: &Structure, method: &EigenMethod) -> Result<Modes, Failure> {
    let count = method.count.map(|count| count as usize);
    let Some(highest_hz) = method.highest_hz else { return solve(structure, count) };
    let below = count_below(&structure.system, highest_hz * TAU).map_err(Failure::computation)?;
    if below == 0 {
        show::note(&format!(
            "no mode lies below the {highest_hz} Hz of the deck's METHOD; the first is given"
        ));
    }
    solve(structure, Some(below.min(count.unwrap_or(below)).max(1)))
}

fn result(structure: &Structure, modes: &Modes, seconds: f64) -> ModesResult {
    let mass = structure.system.mass_properties();
    ModesResult {
        command: "modes",
        structure: structure.name.clone(),
        mass_kg: mass.mass_kg,
        centre_of_gravity_m: mass.centre.coords.into(),
        // Stored by columns.
        inertia_about_centre_kg_m2: mass.inertia_kg_m2.transpose().into(),
        grids: structure.system.node_count(),
        free_motions: structure.system.free_count(),
        elements: structure.bulk.element_counts(),
        frequencies_hz: hertz(modes),
        rigid_modes: modes.omega_rad_s.iter().filter(|omega| **omega == 0.0).count(),
        effective_masses: effective_masses(&structure.system, modes, &mass.centre),
        seconds,
    }
}

fn summary(structure: &Structure, modes: &Modes) -> String {
    let system = &structure.system;
    let mass = system.mass_properties();
    let elements: Vec<String> =
        structure.bulk.element_counts().iter().map(|(card, count)| format!("{count} {card}")).collect();
    let mut text = format!(
        "{}: {:.4} kg, centre of gravity {:.4}, {:.4}, {:.4} m; {} grids, {} free motions; {}\n",
        structure.name,
        mass.mass_kg,
        mass.centre.x,
        mass.centre.y,
        mass.centre.z,
        system.node_count(),
        system.free_count(),
        elements.join(", ")
    );
    let mut table = Table::new(&["mode", "Hz", "rad/s", "mass x (%)", "y (%)", "z (%)"]);
    let (effective, along) = (effective_masses(system, modes, &mass.centre), masses_along(system));
    for (mode, (hz, share)) in hertz(modes).iter().zip(&effective).enumerate() {
        let mut row =
            vec![(mode + 1).to_string(), format!("{hz:.4}"), format!("{:.3}", modes.omega_rad_s[mode])];
        let share = share.iter().zip(along);
        row.extend(share.map(|(kg, whole)| format!("{:.1}", 100.0 * kg / whole.max(f64::MIN_POSITIVE))));
        table.row(row);
    }
    let _ = writeln!(text, "{table}");
    let rigid = modes.omega_rad_s.iter().filter(|omega| **omega == 0.0).count();
    if rigid > 0 {
        let _ = writeln!(text, "{rigid} of them are rigid motions: the structure is not held against them");
    }
    text
}
