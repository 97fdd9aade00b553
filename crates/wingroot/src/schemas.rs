//! JSON schemas of all files that are read and of every `result.json`, made from the types that read and write them.
//!
//! Meaning is what the types' documentation says; a unit that only a field's name says is put behind it.

use discover::result::DiscoverResult;
use hidden::score::BenchmarkResult;
use schemars::generate::SchemaSettings;
use schemars::transform::RecursiveTransform;
use schemars::{JsonSchema, Schema};
use serde_json::Value;

use crate::commands::calibrate_result::CalibrateResult;
use crate::commands::deck_result::DeckResult;
use crate::commands::deflection_result::DeflectionResult;
use crate::commands::flightloads_result::FlightloadsResult;
use crate::commands::flutter_result::FlutterResult;
use crate::commands::fullaircraft::FullaircraftResult;
use crate::commands::fullaircraft_cases_merged::Summary as CasesSummary;
use crate::commands::fullaircraft_deck::Summary as DeckSummary;
use crate::commands::modes_result::{ModesMeasuredResult, ModesResult};
use crate::commands::pipeline_result::PipelineResult;
use crate::commands::response_missing_result::MissingResult;
use crate::commands::response_result::{DisplacementResult, ResponseResult};
use crate::commands::simulate_result::SimulateResult;
use crate::commands::statics_air_result::StaticsAirResult;
use crate::commands::statics_result::StaticsResult;
use crate::commands::tunnel_result::TunnelResult;

/// A schema with its name.
#[derive(Debug)]
pub struct Named {
    /// What `wingroot schema` calls it.
    pub name: &'static str,
    /// Which file it is of.
    pub of: &'static str,
    make: fn() -> Schema,
}

impl Named {
    /// The schema (draft 2020-12).
    pub fn schema(&self) -> Schema {
        (self.make)()
    }
}

fn input<T: JsonSchema>(name: &'static str, of: &'static str) -> Named {
    Named { name, of, make: || made::<T>(SchemaSettings::draft2020_12()) }
}

fn result<T: JsonSchema>(name: &'static str, of: &'static str) -> Named {
    Named { name, of, make: || made::<T>(SchemaSettings::draft2020_12().for_serialize()) }
}

fn made<T: JsonSchema>(settings: SchemaSettings) -> Schema {
    let settings = settings.with_transform(RecursiveTransform(with_units));
    settings.into_generator().into_root_schema_for::<T>()
}

/// All of them: inputs, then results.
pub fn all() -> Vec<Named> {
    inputs().into_iter().chain(results()).collect()
}

fn inputs() -> Vec<Named> {
    vec![
        input::<coupling::WingFile>(
            "wing",
            "wing.ron: geometry, structure, balance, unknowns of the calibration",
        ),
        input::<calibrate::campaign::CampaignFile>("campaign", "campaign.ron: a folder of measurements"),
        input::<calibrate::Schedule>("corrections", "corrections.ron, written by calibrate"),
        input::<calibrate::Ensemble>(
            "ensemble",
            "ensemble.ron, written by calibrate: wings that are as likely as the calibrated one",
        ),
        input::<maneuver::ManeuverFile>("maneuver", "simulate --maneuver"),
        input::<structure::update::MeasuredFile>("measured", "modes --measured"),
        input::<fullaircraft::AircraftFile>("aircraft", "aircraft.ron"),
        input::<fullaircraft::study::Study>(
            "study",
            "study.ron (fullaircraft, flutter, gust or loads --deck): what decks lack for trims, flutter and gusts",
        ),
        input::<fullaircraft::CasesFile>("cases", "fullaircraft --cases"),
        input::<loads::SelectFile>("select", "select.ron: which cases go to stress"),
        input::<loads::FlightFile>("flight", "flight.ron: measured loads, for flightloads"),
        input::<tunnel::TunnelFile>("tunnel", "tunnel.ron: what the virtual wind tunnel measures"),
        input::<response::Study>("response", "response.ron: tables to analyse"),
        input::<discover::null_distribution::NullDistribution>(
            "null_distribution",
            "null_distribution.ron, written by discover",
        ),
        input::<free::rig::Rig>("rig", "rig.ron: a wing on a heave and a pitch spring"),
    ]
}

fn results() -> Vec<Named> {
    vec![
        result::<CalibrateResult>("calibrate_result", "result.json of calibrate"),
        result::<SimulateResult>("simulate_result", "result.json of simulate"),
        result::<DeflectionResult>("deflection_result", "result.json of deflection"),
        result::<DiscoverResult>("discover_result", "result.json of discover"),
        result::<crate::commands::discover_campaigns_result::CampaignsResult>(
            "discover_campaigns_result",
            "result.json of discover --campaigns",
        ),
        result::<BenchmarkResult>("hidden_result", "result.json of hidden"),
        result::<FullaircraftResult>("fullaircraft_result", "result.json of fullaircraft"),
        result::<crate::commands::loads_result::LoadsResult>("loads_result", "result.json of loads"),
        result::<crate::sweep::status::Status>("status_result", "status --json"),
        result::<CasesSummary>("fullaircraft_cases_result", "result.json of fullaircraft --cases"),
        result::<DeckSummary>("fullaircraft_deck_result", "result.json of fullaircraft --deck"),
        result::<PipelineResult>("pipeline_result", "result.json of pipeline"),
        result::<TunnelResult>("tunnel_result", "result.json of tunnel"),
        result::<ModesResult>("modes_result", "result.json of modes"),
        result::<ModesMeasuredResult>("modes_measured_result", "result.json of modes --measured"),
        result::<StaticsResult>("statics_result", "result.json of statics --deck"),
        result::<StaticsAirResult>("statics_air_result", "result.json of statics --wing"),
        result::<DeckResult>("deck_result", "result.json of deck"),
        result::<ResponseResult>("response_result", "result.json of response"),
        result::<MissingResult>("response_missing_result", "result.json of response --missing"),
        result::<DisplacementResult>(
            "response_displacement_result",
            "result.json of response --displacement",
        ),
        result::<FlightloadsResult>("flightloads_result", "result.json of flightloads"),
        result::<FlutterResult>("flutter_result", "result.json of flutter"),
        result::<crate::commands::flutter_bent_result::BentFlutterResult>(
            "flutter_bent_result",
            "result.json of flutter with large deflections",
        ),
        result::<crate::commands::free_result::FreeResult>("free_result", "result.json of free"),
        result::<crate::commands::flutter_deck_result::DeckFlutter>(
            "flutter_deck_result",
            "result.json of flutter --deck",
        ),
        result::<crate::commands::gust_result::GustResult>("gust_result", "result.json of gust"),
    ]
}

/// Units by the end of a field's name, longer ends first.
const UNITS: &[(&str, &str)] = &[
    ("_deg_s2", "deg/s2"),
    ("_per_deg2", "1/deg2"),
    ("_rad_s2", "rad/s2"),
    ("_m_s2", "m/s2"),
    ("_kg_m3", "kg/m3"),
    ("_deg_s", "deg/s"),
    ("_rad_s", "rad/s"),
    ("_m_s", "m/s"),
    ("_kg_m", "kg/m"),
    ("_n_s_per_m", "N s/m"),
    ("_n_per_m", "N/m"),
    ("_per_s", "1/s"),
    ("_nm_s", "N m s"),
    ("_kgm", "kg m"),
    ("_per_rad", "1/rad"),
    ("_per_deg", "1/deg"),
    ("_percent", "%"),
    ("_over_c", "share of the chord"),
    ("_nm2", "N m2"),
    ("_nm", "N m"),
    ("_n", "N"),
    ("_deg", "deg"),
    ("_rad", "rad"),
    ("_hz", "Hz"),
    ("_pa", "Pa"),
    ("_kg", "kg"),
    ("_mm", "mm"),
    ("_mb", "MB"),
    ("_m", "m"),
    ("_s", "s"),
    ("_seconds", "s"),
];

/// The unit that a field's name says.
fn unit(name: &str) -> Option<&'static str> {
    let name = format!("_{}", name.to_lowercase());
    UNITS.iter().find(|(end, _)| name.ends_with(end)).map(|(_, unit)| *unit)
}

/// Puts units behind the descriptions of fields that do not say them.
fn with_units(schema: &mut Schema) {
    let Some(Value::Object(fields)) = schema.get_mut("properties") else { return };
    for (name, field) in fields {
        let (Some(unit), Some(Value::String(text))) = (unit(name), field.get_mut("description")) else {
            continue;
        };
        let said = text.replace('²', "2").replace('³', "3");
        if !format!("{said} ").contains(&format!(", {unit}")) {
            text.push_str(" Unit: ");
            text.push_str(unit);
            text.push('.');
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::Cli;
    use clap::CommandFactory;

    #[test]
    fn every_command_with_a_result_has_its_schema() {
        // `merge` gives the result of the sweep's command
        let without = ["new", "docs", "completions", "man", "schema", "prepare", "merge", "cluster"];
        let names: Vec<&str> = all().iter().map(|schema| schema.name).collect();
        for command in Cli::command().get_subcommands().filter(|c| !without.contains(&c.get_name())) {
            let name = format!("{}_result", command.get_name());
            assert!(names.contains(&name.as_str()), "{name} is not in the list");
        }
    }

    #[test]
    fn a_unit_is_put_behind_a_description_that_does_not_say_it() {
        let mut schema = schemars::json_schema!({ "properties": {
            "span_m": { "description": "From root to tip." }, "rho_kg_m3": { "description": "Density, kg/m³." },
            "name": { "description": "Its name." },
        } });
        with_units(&mut schema);
        let said = |name: &str| schema.as_value()["properties"][name]["description"].clone();
        assert_eq!(said("span_m"), "From root to tip. Unit: m.");
        assert_eq!(said("rho_kg_m3"), "Density, kg/m³.");
        assert_eq!(said("name"), "Its name.");
    }
}
