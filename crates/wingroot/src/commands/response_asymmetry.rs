//! `response --displacement FIELD.csv`: the asymmetry ratio of displacement fields (Eqs. 2 and 3 of paper 2), with its uncertainty from
//! the noise of the points and from a rigid wing.

use std::fmt::Write as _;
use std::path::PathBuf;

use report::Table;
use response::asymmetry::{Asymmetry, RigidWing, Settings, asymmetry, read_displacements};

use super::response_result::{DisplacementResult, FieldResult, RigidResult};
use super::response_text::{interval, number};
use crate::args::{Common, ResponseArgs};
use crate::commands::result_parts::as_json;
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::show;

/// Runs the command for fields.
pub(super) fn run(args: &ResponseArgs, common: &Common) -> Result<(), Failure> {
    let mut settings = Settings::default();
    settings.centre_y_mm = args.centre_y_mm.unwrap_or(settings.centre_y_mm);
    settings.sigma_w_mm = args.sigma_w_mm.unwrap_or(settings.sigma_w_mm);
    settings.confidence = args.level.unwrap_or(settings.confidence);
    let rigid_fields = ratios(&args.rigid, &settings)?;
    let rigid = if rigid_fields.is_empty() {
        RigidWing::PUBLISHED
    } else {
        RigidWing::from_ratios(&rigid_fields.iter().map(|field| field.ratio).collect::<Vec<_>>())?
    };
    let fields = ratios(&args.displacement, &settings)?;
    let folder = ResultFolder::begin(&common.out("response"))?;
    let of_field = |(path, asymmetry): (&PathBuf, &Asymmetry)| FieldResult {
        file: path.display().to_string(),
        asymmetry: *asymmetry,
        beyond_the_rigid_wing: rigid.is_exceeded_by(asymmetry),
    };
    let result = as_json(&DisplacementResult {
        command: "response",
        rigid: RigidResult {
            mean: rigid.mean,
            bias: rigid.bias(),
            scatter: rigid.scatter,
            fields: rigid_fields.len(),
        },
        fields: args.displacement.iter().zip(&fields).map(of_field).collect(),
    })?;
    folder.write_json("result.json", &result)?;
    let out = folder.commit()?;
    let text = summary(args, &fields, &rigid);
    show::summary(common, &format!("{text}written to {}", out.display()));
    show::json(common, &result)
}

fn ratios(paths: &[PathBuf], settings: &Settings) -> Result<Vec<Asymmetry>, Failure> {
    let one = |path: &PathBuf| {
        let field = read_displacements(path)?;
        asymmetry(&field, settings).map_err(|error| {
            // what is wrong with the points is said without their file
            let place = nastran::InputError::in_file(path, error.message.clone());
            let error = if error.span.is_some() { error } else { place };
            Failure::from(error)
        })
    };
    paths.iter().map(one).collect()
}

fn summary(args: &ResponseArgs, fields: &[Asymmetry], rigid: &RigidWing) -> String {
    let mut table =
        Table::new(&["field", "left/right", "sigma", "interval", "pairs", "unpaired", "asymmetric"]);
    for (path, field) in args.displacement.iter().zip(fields) {
        table.row([
            path.display().to_string(),
            number(field.ratio),
            number(field.sigma),
            field.interval.map_or_else(|| "open".to_string(), interval),
            field.pairs.to_string(),
            field.unpaired.to_string(),
            if rigid.is_exceeded_by(field) { "yes" } else { "not told from the rigid wing" }.to_string(),
        ]);
    }
    let mut text = table.to_string();
    let scatter = rigid.scatter.map_or_else(String::new, |scatter| format!(", scatter {}", number(scatter)));
    let source = if args.rigid.is_empty() { "the paper's" } else { "from its fields" };
    let _ = writeln!(text, "rigid wing ({source}): mean ratio {}{scatter}", number(rigid.mean));
    text
}
