//! `modes --measured`: frequencies, shapes and deflections beside the model's, and factors of regions fitted to them.

use std::fmt::Write as _;
use std::path::Path;
use std::time::Instant;

use report::{Figure, Panel, Series, Style, Table};
use structure::update::{Fit, MeasuredFile, Prediction, Quantity, Settings, State, UpdateError, fit};

use crate::args::Common;
use crate::commands::modes_result::{MeasurementResult, ModesMeasuredResult, RegionFactor, StateResult};
use crate::commands::result_parts::as_json;
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::show;
use crate::structures::Structure;

/// Sum of squares a degree of freedom beyond which the regions are said not to explain the data (normal errors go
/// beyond 3 at five degrees of freedom once in a hundred).
const MISFIT: f64 = 3.0;

/// Runs the comparison and the fit.
pub(super) fn run(
    wing: Option<&Path>,
    deck: Option<&Path>,
    measured: &Path,
    common: &Common,
) -> Result<(), Failure> {
    let start = Instant::now();
    let structure = Structure::read(wing, deck)?;
    let file = MeasuredFile::read(measured)?;
    let measurements = file.measurements(&structure.system)?;
    let parameters = file.parameters(&structure.bulk, &structure.model)?;
    let found = fit(&structure.model, &parameters, &measurements, &Settings::default()).map_err(failure)?;
    let folder = ResultFolder::begin(&common.out("modes"))?;
    folder.input("structure", &structure.path)?;
    folder.input("measurements", measured)?;
    folder.write_text("factors.ron", &factors(&structure, &found))?;
    if let Some(figure) = deviations(&found) {
        let caption = "Model less measurement in standard deviations of it, in the order of the table.";
        folder.write_figure("deviations", caption, figure)?;
    }
    let result = as_json(&result(&structure, &found, start.elapsed().as_secs_f64()))?;
    folder.write_json("result.json", &result)?;
    let out = folder.commit_if(found.is_converged)?;
    let text = format!("{}written to {}", summary(&structure, &found), out.display());
    show::summary(common, &text);
    show::json(common, &result)?;
    if found.is_converged { Ok(()) } else { Err(Failure::computation("the fit did not converge")) }
}

fn failure(error: UpdateError) -> Failure {
    match error {
        UpdateError::Input(error) => error.into(),
        error @ (UpdateError::Modes(_) | UpdateError::Singular(_)) => Failure::computation(error),
    }
}

fn word(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Stiffness => "stiffness",
        Quantity::Mass => "mass",
    }
}

/// The factors as a file.
fn factors(structure: &Structure, found: &Fit) -> String {
    let mut text = format!(
        "// Factors of regions of {}, fitted to measurements; sigma is one standard deviation.\n(\n    factors: [\n",
        structure.name
    );
    for factor in &found.factors {
        let sigma = if factor.is_determined { format!("Some({:.6})", factor.sigma) } else { "None".into() };
        let _ = writeln!(
            text,
            "        (region: {:?}, quantity: {:?}, factor: {:.6}, sigma: {sigma}, determined: {}),",
            factor.region, factor.quantity, factor.value, factor.is_determined
        );
    }
    text.push_str("    ],\n)\n");
    text
}

fn state(state: &State) -> StateResult {
    StateResult {
        frequencies_hz: state.frequencies_hz.clone(),
        modal_assurance: state.assurance.clone(),
        pairs: state.pairs.iter().map(|pair| pair.map(|mode| mode + 1)).collect(),
        chi_square: state.chi_square(),
        compared: state.compared(),
    }
}

fn open_directions(found: &Fit) -> Vec<Vec<(String, f64)>> {
    let name = |p: usize| format!("{} of {}", word(found.factors[p].quantity), found.factors[p].region);
    let directions = found.determination.undetermined_directions();
    directions.into_iter().map(|parts| parts.into_iter().map(|(p, part)| (name(p), part)).collect()).collect()
}

/// How far both models are off each measurement; none without measurements.
fn deviations(found: &Fit) -> Option<Figure> {
    let series = |name: &str, state: &State| {
        let off = |p: &Prediction| p.model.map_or(f64::NAN, |model| (model - p.measured) / p.sigma);
        let (x, y) = (1..).map(f64::from).zip(state.predictions.iter().map(off)).unzip();
        Series::new(name, x, y, Style::Points)
    };
    let panel = Panel::new(
        "",
        "number of the measurement",
        "model less measurement (sigma)",
        vec![series("initial", &found.before), series("updated", &found.after)],
    );
    let any = |state: &State| state.predictions.iter().any(|p| p.model.is_some());
    (any(&found.before) || any(&found.after))
        .then(|| Figure::new("What is left of the measurements", vec![panel], 1))
}

fn result(structure: &Structure, found: &Fit, seconds: f64) -> ModesMeasuredResult {
    let factor = |factor: &structure::update::Factor| RegionFactor {
        region: factor.region.clone(),
        quantity: word(factor.quantity),
        value: factor.value,
        sigma: factor.is_determined.then_some(factor.sigma),
        determined: factor.is_determined,
    };
    let measurements = found
        .before
        .predictions
        .iter()
        .zip(&found.after.predictions)
        .map(|(before, after)| MeasurementResult {
            name: before.name.clone(),
            unit: before.unit.into(),
            measured: before.measured,
            sigma: before.sigma,
            before: before.model,
            after: after.model,
        })
        .collect();
    ModesMeasuredResult {
        command: "modes",
        structure: structure.name.clone(),
        mass_kg: structure.system.mass_properties().mass_kg,
        grids: structure.system.node_count(),
        elements: structure.bulk.element_counts(),
        frequencies_hz: found.before.frequencies_hz.clone(),
        measurements,
        factors: found.factors.iter().map(factor).collect(),
        covariance: found.determination.covariance(),
        undetermined: open_directions(found),
        determined_directions: found.determination.determined,
        before: state(&found.before),
        after: state(&found.after),
        degrees_of_freedom: found.degrees_of_freedom(),
        steps: found.steps,
        converged: found.is_converged,
        seconds,
    }
}

fn summary(structure: &Structure, found: &Fit) -> String {
    let mut text = format!("{}\n", structure.name);
    let mut table =
        Table::new(&["measured", "unit", "value", "sigma", "model", "updated", "off (sigma)", "then"]);
    let number = |value: Option<f64>| value.map_or_else(|| "-".into(), |value| format!("{value:.5}"));
    let off = |value: Option<f64>| value.map_or_else(|| "-".into(), |value| format!("{value:+.2}"));
    for (before, after) in found.before.predictions.iter().zip(&found.after.predictions) {
        let (measured, sigma) = (number(Some(before.measured)), number(Some(before.sigma)));
        table.row([
            before.name.clone(),
            before.unit.into(),
            measured,
            sigma,
            number(before.model),
            number(after.model),
            off(before.residual()),
            off(after.residual()),
        ]);
    }
    let _ = writeln!(text, "{table}");
    text.push_str(&assurance(&found.after));
    if found.factors.is_empty() {
        text.push_str("no regions to fit\n");
        return text;
    }
    let mut table = Table::new(&["region", "quantity", "factor", "sigma", ""]);
    for factor in &found.factors {
        let (sigma, remark) = if factor.is_determined {
            (format!("{:.4}", factor.sigma), String::new())
        } else {
            ("-".into(), "not determined by these data".into())
        };
        let value = format!("{:.4}", factor.value);
        table.row([factor.region.clone(), word(factor.quantity).into(), value, sigma, remark]);
    }
    let _ = writeln!(text, "{table}");
    for parts in open_directions(found) {
        let parts: Vec<String> = parts.into_iter().map(|(name, part)| format!("{part:+.2} {name}")).collect();
        let _ = writeln!(text, "left open: {}", parts.join(" "));
    }
    let freedom = found.degrees_of_freedom();
    let _ = writeln!(
        text,
        "sum of squares (in sigma) {:.1} before, {:.1} after {} steps, with {freedom} degrees of freedom",
        found.before.chi_square(),
        found.after.chi_square(),
        found.steps
    );
    if freedom > 0 && found.after.chi_square() > MISFIT * freedom as f64 {
        text.push_str("these factors do not explain the measurements within their uncertainty: the true uncertainty of the\n\
            factors is larger than given; look at the largest deviations above, or for other regions\n");
    }
    text
}

/// Modal assurance of the measured shapes (rows) with the updated model's modes; nothing if no shape was measured.
fn assurance(state: &State) -> String {
    let columns = state.assurance.iter().map(Vec::len).max().unwrap_or(0).min(10);
    if columns == 0 {
        return String::new();
    }
    let head: Vec<String> =
        (0..columns).map(|mode| format!("{:.1} Hz", state.frequencies_hz[mode])).collect();
    let mut names: Vec<&str> = vec!["modal assurance", "pair"];
    names.extend(head.iter().map(String::as_str));
    let mut table = Table::new(&names);
    let modes = state.predictions.iter().zip(&state.assurance).zip(&state.pairs);
    for ((prediction, row), pair) in modes {
        let pair = pair.map_or_else(|| "-".into(), |pair| (pair + 1).to_string());
        let cells = row.iter().take(columns).map(|value| format!("{value:.3}"));
        table.row([prediction.name.clone(), pair].into_iter().chain(cells));
    }
    format!("{table}\n")
}
