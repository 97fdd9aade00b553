//! `response`: response surfaces of measured coefficients, their tests, tables and figures.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;
use std::time::Instant;

use rayon::prelude::*;
use response::mav::{Published, figures};
use response::{TableAnalysis, TableStudy};

use super::response_points::Points;
use super::response_source::Source;
use super::{response_asymmetry, response_figures, response_files, response_missing, response_text};
use crate::args::{Common, ResponseArgs};
use crate::commands::response_result::{FigureNotes, ResponseResult, SurfaceResult};
use crate::commands::result_parts::as_json;
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::show;

/// Runs the command.
pub(crate) fn run(args: &ResponseArgs, common: &Common) -> Result<(), Failure> {
    if !args.displacement.is_empty() {
        return response_asymmetry::run(args, common);
    }
    if args.missing {
        return response_missing::run(args, common);
    }
    let start = Instant::now();
    let source = Source::read(args)?;
    let points = wanted_points(args, &source)?;
    let analyses: Vec<TableAnalysis> = source
        .tables
        .par_iter()
        .map(|(study, table)| study.analyse(table).map_err(Failure::from))
        .collect::<Result<_, _>>()?;
    let folder = ResultFolder::begin(&common.out("response"))?;
    folder.input("data", &crate::paths::study(args.data.as_deref())?)?;
    let (mut responses, mut at, mut text) = (Vec::new(), Vec::new(), format!("{}\n", source.name));
    let mut known = BTreeMap::new();
    for ((study, _), analysis) in source.tables.iter().zip(&analyses) {
        let stem = stem(study, &mut known);
        responses.extend(write(&folder, &stem, study, analysis)?);
        let _ = write!(text, "\n{}", response_text::table(study, analysis));
        let Some(points) = points.as_ref().filter(|points| points.require(study).is_ok()) else { continue };
        for predictions in points.predictions(study, analysis)? {
            folder.write_text(&format!("{stem}_{}_at.csv", predictions.name), &predictions.csv())?;
            let _ = write!(text, "\n{}", predictions.text());
            at.push(predictions.result(&study.data));
        }
    }
    let notes = match &source.published {
        Some(published) => Some(draw_published(&folder, published)?),
        None => None,
    };
    let seconds = start.elapsed().as_secs_f64();
    let result = as_json(&ResponseResult {
        command: "response",
        name: source.name,
        responses,
        at,
        published_figures: notes,
        seconds,
    })?;
    folder.write_json("result.json", &result)?;
    let out = folder.commit()?;
    let _ = write!(text, "\nwritten to {} in {seconds:.1} s", out.display());
    show::summary(common, &text);
    show::json(common, &result)
}

/// The points of `--at`; they need the factors of a table at least.
fn wanted_points(args: &ResponseArgs, source: &Source) -> Result<Option<Points>, Failure> {
    let Some(path) = &args.at else { return Ok(None) };
    let points = Points::read(path)?;
    let found = source.tables.iter().map(|(study, _)| points.require(study)).reduce(Result::or);
    Ok(found.transpose()?.map(|()| points))
}

/// Name for the files of a table: that of its file, numbered if a file is analysed twice.
fn stem(study: &TableStudy, known: &mut BTreeMap<String, usize>) -> String {
    let stem =
        Path::new(&study.data).file_stem().map_or_else(String::new, |s| s.to_string_lossy().into_owned());
    let count = known.entry(stem.clone()).or_insert(0);
    *count += 1;
    if *count == 1 { stem } else { format!("{stem}_{count}") }
}

/// Tables and figures of one data table; what result.json says of its responses.
fn write(
    folder: &ResultFolder,
    stem: &str,
    study: &TableStudy,
    analysis: &TableAnalysis,
) -> Result<Vec<SurfaceResult>, Failure> {
    let mut responses = Vec::new();
    for of_response in &analysis.responses {
        let name = format!("{stem}_{}", of_response.choice.fitted.response);
        folder.write_text(&format!("{name}_terms.csv"), &response_files::terms_csv(study, of_response))?;
        folder.write_text(&format!("{name}_curve.csv"), &response_files::curve_csv(of_response))?;
        folder
            .write_text(&format!("{name}_points.csv"), &response_files::points_csv(analysis, of_response))?;
        let figure = response_figures::response(study, analysis, of_response)?;
        folder.write_figure_of(&name, "", figure, &format!("{name}_points.csv"))?;
        responses.push(response_files::response(study, analysis, of_response));
    }
    if !analysis.effects.is_empty() {
        folder.write_text(&format!("{stem}_effects.csv"), &response_files::effects_csv(analysis))?;
        if let Some(figure) = response_figures::effects(study, &analysis.effects) {
            let name = format!("{stem}_effects");
            folder.write_figure_of(&name, "", figure, &format!("{name}.csv"))?;
        }
    }
    Ok(responses)
}

/// Figures of the published models; their notes.
fn draw_published(folder: &ResultFolder, published: &Path) -> Result<Vec<FigureNotes>, Failure> {
    let published = Published::read(published)?;
    let mut notes = Vec::new();
    for number in figures::FIGURES {
        let figure = figures::figure(&published, number)?;
        let (title, said) = (figure.title.clone(), figure.notes.clone());
        notes.push(FigureNotes { figure: number, title, notes: said });
        folder.write_figure(&format!("fig_{number}"), "", response_figures::published(figure))?;
    }
    Ok(notes)
}
