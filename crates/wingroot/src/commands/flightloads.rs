//! `flightloads`: measured against calculated loads of the initial and the updated model.

use clap::Args;
use std::fmt::Write as _;
use std::path::PathBuf;
use std::time::Instant;

use loads::FlightFile;
use loads::compare::{Judged, judge};
use loads::flight::{Channel, Condition, Reading, Source, readings};
use nastran::{InputError, ron_or_json};
use report::Table;

use super::flightloads_aircraft::FlownAircraft;
use super::flightloads_campaign::CampaignPoints;
use super::flightloads_coverage as coverage;
use super::flightloads_figures::write_figures;
use super::flightloads_measured::{MODELS, Measured, comparison};
use super::flightloads_result::{FlightloadsResult, Row, csv};
use super::flightloads_sections::sections;
use super::flightloads_wing::{Calculated, TunnelWing};
use crate::args::Common;
use crate::commands::result_parts::as_json;
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::pages::values::{counted, digits};
use crate::show;

/// Options of `flightloads`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  wingroot flightloads
  wingroot flightloads --measured my_flight/flight.ron --package out/loads
  wingroot flightloads --measured my_flight/flight.ron --aircraft aircraft.ron --plan loads.ron

flight.ron names stations with their gauges, conditions (tables of points, histories, sections of a wing, or wind-tunnel
campaigns) and what is asked of calculated loads: no threshold is built in. Points that fitted the corrections count in no verdict.
`wingroot schema flight` describes the file.")]
pub struct FlightloadsArgs {
    /// The file of measured loads, or the folder of flight.ron
    #[arg(long, value_name = "FILE", default_value = "flight.ron")]
    pub(crate) measured: PathBuf,
    /// Results of `loads`: how far what was flown covers its design loads
    #[arg(long, value_name = "DIR")]
    pub(crate) package: Option<PathBuf>,
    /// An aircraft in flight: its loads at the measured airspeeds (V_m_s) and load factors (n_z), wings level, by both models
    #[arg(long, value_name = "FILE")]
    pub(crate) aircraft: Option<PathBuf>,
    /// With --aircraft: the plan of design loads whose stations it has
    #[arg(long, value_name = "FILE.ron", requires = "aircraft")]
    pub(crate) plan: Option<PathBuf>,
}

/// Runs the command.
pub(crate) fn run(args: &FlightloadsArgs, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let path = if args.measured.is_dir() {
        ron_or_json::expected_in(&args.measured, "flight")?
    } else {
        args.measured.clone()
    };
    let file = FlightFile::read(&path)?;
    let channels = file.channels();
    let campaigns = CampaignPoints::all(&file)?;
    let flown = args
        .aircraft
        .as_deref()
        .map(|aircraft| FlownAircraft::read(aircraft, args.plan.as_deref(), &file, common))
        .transpose()?;
    let wing = TunnelWing::read(&file, &campaigns)?;
    let models = Models { wing: wing.as_ref(), aircraft: flown };
    let all = measured(&file, &channels, &campaigns, &models)?;
    let rows = rows(&file, &all);
    if rows.is_empty() {
        return Err(InputError::in_file(&path, "no load was calculated")
            .with_help(
                "name a `wing`, or --aircraft, or bring columns such as initial_root_Mx_Nm in the tables",
            )
            .into());
    }
    let covered =
        args.package.as_deref().map(|package| coverage::coverage(package, &channels, &all)).transpose()?;
    let folder = ResultFolder::begin(&common.out("flightloads"))?;
    folder.input("measured", &path)?;
    if let Some(wing) = &wing {
        folder.input("wing", &wing.file.path)?;
    }
    if let Some(aircraft) = &models.aircraft {
        aircraft.prepared.inputs.iter().try_for_each(|(what, path)| folder.input(what, path))?;
    }
    if let Some(plan) = &args.plan {
        folder.input("plan", plan)?;
    }
    if let Some(package) = &args.package {
        folder.input("design loads", &package.join("envelope.csv"))?;
        folder.input("design instants", &package.join("selected.csv"))?;
    }
    if let Some(covered) = &covered {
        coverage::write(&folder, covered)?;
    }
    folder.write_text("flightloads.csv", &csv(&rows))?;
    write_figures(&folder, &file, &all)?;
    let mut result = FlightloadsResult::new(&file, models.origin(), rows, &campaigns);
    result.coverage = covered;
    result.seconds = start.elapsed().as_secs_f64();
    let json = as_json(&result)?;
    folder.write_json("result.json", &json)?;
    let out = folder.commit()?;
    let mut text = summary(&result);
    let _ = write!(text, "written to {} in {:.1} s", out.display(), result.seconds);
    show::summary(common, &text);
    show::json(common, &json)
}

/// What loads are calculated with.
struct Models<'a> {
    wing: Option<&'a TunnelWing>,
    aircraft: Option<FlownAircraft>,
}

impl Models<'_> {
    /// Where the corrections come from.
    fn origin(&self) -> Option<String> {
        let flown = self.aircraft.as_ref().map(|aircraft| aircraft.prepared.wing.origin.clone());
        flown.or_else(|| self.wing.map(TunnelWing::origin))
    }
}

/// Readings and calculated loads of all conditions.
fn measured(
    file: &FlightFile,
    channels: &[Channel],
    campaigns: &[CampaignPoints],
    models: &Models<'_>,
) -> Result<Vec<Measured>, Failure> {
    let wing = models.wing;
    let one = |condition: Condition| -> Result<Measured, Failure> {
        if let Source::Sections(name) = &condition.source {
            let rho = campaigns.first().map(|campaign| campaign.rho_kg_m3).or(file.rho_kg_m3);
            return sections(file, &condition, name, wing.zip(rho));
        }
        let campaign = campaigns.iter().find(|campaign| campaign.condition == condition.name);
        let readings = match campaign {
            Some(campaign) => campaign.readings.clone(),
            None => readings(file, &condition)?,
        };
        let brings = readings.iter().any(|reading| reading.calculated.iter().any(Option::is_some));
        let calculated = if brings || (wing.is_none() && models.aircraft.is_none()) {
            [0, 1].map(|model| brought(&readings, model))
        } else if let Some(aircraft) = &models.aircraft {
            aircraft.calculated(file, &condition, channels, &readings)?
        } else {
            if let Source::History(name, _) = &condition.source {
                let message = format!(
                    "the history {name} brings no calculated loads, and only steady points are calculated"
                );
                let help = "add columns such as updated_root_Mx_Nm, from `simulate` or another program";
                return Err(InputError::in_file(&file.path, message).with_help(help).into());
            }
            let rho = campaign.map(|campaign| campaign.rho_kg_m3).or(file.rho_kg_m3);
            wing.map_or(Ok([None, None]), |wing| wing.calculated(file, channels, &readings, rho))?
        };
        Ok(Measured { condition, channels: channels.to_vec(), readings, calculated })
    };
    file.conditions()?.into_iter().map(one).collect()
}

/// Loads that a table brings.
fn brought(readings: &[Reading], model: usize) -> Option<Vec<Calculated>> {
    let of = |reading: &Reading| {
        let loads = reading.calculated[model].clone()?;
        Some(Calculated { sigma: vec![0.0; loads.len()], loads })
    };
    readings.iter().map(of).collect()
}

/// Judges all conditions, stations and loads of each model together.
fn rows(file: &FlightFile, all: &[Measured]) -> Vec<Row> {
    let mut rows = Vec::new();
    for (model, name) in MODELS.into_iter().enumerate() {
        let mut places = Vec::new();
        let mut comparisons = Vec::new();
        for one in all {
            for (at, channel) in one.channels.iter().enumerate() {
                if let Some(comparison) = comparison(one, at, model) {
                    comparisons.push(comparison);
                    places.push((one.condition.name.clone(), channel));
                }
            }
        }
        let judged = judge(&comparisons, &file.thresholds());
        let row = |((condition, channel), judged): ((String, &Channel), Judged)| {
            Row::new(condition, channel, name, judged)
        };
        rows.extend(places.into_iter().zip(judged).map(row));
    }
    rows
}

fn summary(result: &FlightloadsResult) -> String {
    let mut text = format!(
        "{} in {}",
        counted(result.points, "point", "points"),
        counted(result.conditions, "condition", "conditions")
    );
    if result.fitted > 0 {
        let _ = write!(text, " ({} used to fit corrections: counted apart)", result.fitted);
    }
    text.push('\n');
    let mut table = Table::new(&["condition", "load", "model", "slope", "95 %", "large loads >=", "verdict"]);
    let three = |value: f64| digits(value, 4);
    for row in &result.rows {
        let line = row.judged.line.as_ref();
        table.row(vec![
            row.condition.clone(),
            format!("{} {}", row.station, row.load),
            row.model.to_owned(),
            line.map_or_else(String::new, |line| three(line.slope.value)),
            line.map_or_else(String::new, |line| {
                format!("{} to {}", three(line.slope.low), three(line.slope.high))
            }),
            row.judged.worst_ratio.map_or_else(String::new, three),
            row.judged.verdict.word().to_owned(),
        ]);
    }
    let _ = writeln!(text, "{table}");
    text += &result.coverage.as_ref().map(coverage::line).unwrap_or_default();
    text
}
