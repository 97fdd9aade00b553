//! What `response` analyses: the tables of a RON file, or CSV files with the columns named on the command line.

use std::path::{Path, PathBuf};

use nastran::ron_or_json::expected_in;
use nastran::{InputError, Table, named_file};
use response::{Blocking, EffectsStudy, ErrorRule, Search, Study, TableStudy};

use crate::args::ResponseArgs;
use crate::failure::Failure;
use crate::paths::STUDY;
use crate::{paths, show};

/// Tables to analyse.
pub(super) struct Source {
    /// For the heading.
    pub(super) name: String,
    /// Each with its study.
    pub(super) tables: Vec<(TableStudy, Table)>,
    /// Folder of published models to draw.
    pub(super) published: Option<PathBuf>,
}

impl Source {
    /// Reads what the arguments name.
    ///
    /// # Errors
    /// If there is no such file, no CSV file of a folder has the columns, or a file cannot be read.
    pub(super) fn read(args: &ResponseArgs) -> Result<Self, Failure> {
        let data = paths::study(args.data.as_deref())?;
        let mut source =
            if args.factors.is_empty() { Self::of_study(&data)? } else { Self::of_columns(&data, args)? };
        for (study, _) in &mut source.tables {
            overrule(study, args);
        }
        Ok(source)
    }

    fn of_study(data: &Path) -> Result<Self, Failure> {
        let file = if data.is_dir() { expected_in(data, STUDY)? } else { data.to_path_buf() };
        if file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv"))
            || data.is_dir() && !file.is_file()
        {
            let message = "which columns are factors and responses is not said";
            return Err(InputError::in_file(data, message)
                .with_help(format!(
                    "add --factors A,B --responses C, or write them into {STUDY}.ron in the folder"
                ))
                .into());
        }
        let study = Study::read(&file)?;
        let mut tables = Vec::new();
        for of_table in study.tables {
            let table = Table::read(&named_file(&file, &of_table.data)?)?;
            tables.push((of_table, table));
        }
        let published = study.published.map(|name| file.with_file_name(name));
        Ok(Self { name: study.name, tables, published })
    }

    fn of_columns(data: &Path, args: &ResponseArgs) -> Result<Self, Failure> {
        let columns: Vec<&str> =
            [&args.factors, &args.responses, &args.blocks, &args.effects, &args.effect_blocks]
                .into_iter()
                .flatten()
                .map(String::as_str)
                .collect();
        let mut tables = Vec::new();
        let in_folder = data.is_dir();
        let mut complaint = InputError::in_file(data, "there is no CSV file in the folder");
        for path in if in_folder { csv_files(data)? } else { vec![data.to_path_buf()] } {
            let table = Table::read(&path)?;
            let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
            match table.require(&columns) {
                Ok(()) => {
                    let study = TableStudy::new(&name, &args.factors, &args.responses, &args.blocks);
                    tables.push((study, table));
                }
                // of a folder all tables with these columns are taken
                Err(error) if in_folder => {
                    show::note(&format!("{name} is passed over: {}", error.message));
                    complaint = error;
                }
                Err(error) => return Err(error.into()),
            }
        }
        if tables.is_empty() {
            return Err(complaint.into());
        }
        Ok(Self { name: data.display().to_string(), tables, published: None })
    }
}

fn csv_files(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let unreadable =
        |error: std::io::Error| InputError::in_file(folder, format!("cannot be listed: {error}"));
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv")) {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

/// Options of the command line go before those of a file.
fn overrule(study: &mut TableStudy, args: &ResponseArgs) {
    if args.order.is_some() || !args.terms.is_empty() {
        (study.order, study.terms) = (args.order, args.terms.clone());
    }
    study.blocking = args.blocking.as_deref().map_or(study.blocking, |how| match how {
        "random" => Blocking::Random,
        "ignored" => Blocking::Ignored,
        _ => Blocking::Fixed,
    });
    study.search = args.search.as_deref().map_or(study.search, |how| match how {
        "stepwise" => Search::Stepwise,
        "ranked" => Search::Ranked,
        _ => Search::BestSubset,
    });
    study.sigma0_squared = args.least_t.map_or(study.sigma0_squared, ErrorRule::LeastT);
    study.level = args.level.unwrap_or(study.level);
    if !args.effects.is_empty() {
        let blocks = if args.effect_blocks.is_empty() { &args.blocks } else { &args.effect_blocks };
        let (factors, blocks) = (args.effects.clone(), blocks.clone());
        study.effects = Some(EffectsStudy { factors, blocks, order: None });
    }
}
