//! One deck as `decks` runs it where no command does what it asks for: read, assembled, its stiffness factorised.

use std::fmt::Write as _;
use std::path::Path;

use nastran::InputError;
use structure::{Flexibility, Model, System};
use wingroot::args::Common;
use wingroot::failure::Failure;
use wingroot::show;

/// Reads a deck, assembles it under each of its boundary conditions and factorises its stiffness.
pub(super) fn factorised(path: &Path, common: &Common) -> Result<(), Failure> {
    let bulk = nastran::read_deck(path)?;
    let mut subcases: Vec<Option<u32>> = Vec::new();
    for case in &bulk.subcases {
        let is_known = |id: &Option<u32>| {
            let other = bulk.subcases.iter().find(|other| Some(other.id) == *id);
            other.is_some_and(|other| {
                (other.spc, other.mpc, other.support) == (case.spc, case.mpc, case.support)
            })
        };
        if !subcases.iter().any(is_known) {
            subcases.push(Some(case.id));
        }
    }
    if subcases.is_empty() {
        subcases.push(None);
    }
    let mut text = String::new();
    for subcase in subcases {
        let system = assembled(&bulk, subcase, path).map_err(|error| error.or_in(path))?;
        Flexibility::new(&system).map_err(Failure::computation)?;
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "{} free motions, {} held by AUTOSPC",
            system.free_count(),
            system.auto_held().len()
        );
    }
    show::summary(common, &text);
    Ok(())
}

/// The structure of a deck under the boundary conditions of a subcase.
fn assembled(bulk: &nastran::BulkData, subcase: Option<u32>, path: &Path) -> Result<System, InputError> {
    let model = Model::from_deck(bulk, subcase)?;
    if model.elements().next().is_none() {
        return Err(InputError::in_file(path, "there is no structure: no element"));
    }
    System::assemble(&model)
}
