//! `schema`: what a file may say, for editors and programs.

use std::fmt::Write as _;

use clap::Args;
use nastran::InputError;
use nastran::suggest::nearest;

use crate::args::Common;
use crate::failure::Failure;
use crate::schemas;
use crate::show;

/// Options of `schema`.
#[derive(Debug, Clone, Args)]
#[command(after_help = "Examples:
  wingroot schema
  wingroot schema wing
  wingroot schema calibrate_result

A schema is of the file in JSON; RON says the same with the same names. Meaning and unit of a field are in its description.")]
pub struct SchemaArgs {
    /// The schema to print [default: the names of all]
    #[arg(value_name = "NAME")]
    name: Option<String>,
}

/// Prints the schema, or the list.
pub(crate) fn run(args: &SchemaArgs, common: &Common) -> Result<(), Failure> {
    let all = schemas::all();
    let Some(name) = args.name.as_deref() else {
        let mut text = String::new();
        for schema in &all {
            let _ = writeln!(text, "{:<28} {}", schema.name, schema.of);
        }
        show::summary(common, &text);
        let names: Vec<&str> = all.iter().map(|schema| schema.name).collect();
        return show::json(common, &names);
    };
    let Some(found) = all.iter().find(|schema| schema.name == name) else {
        let help = match nearest(name, all.iter().map(|schema| schema.name)) {
            Some(meant) => format!("did you mean {meant}?"),
            None => "`wingroot schema` lists the names".to_owned(),
        };
        return Err(InputError::general(format!("there is no schema {name}")).with_help(help).into());
    };
    show::json(&Common { json: true, ..common.clone() }, &found.schema())
}
