//! Figures of `flightloads`: measured over calculated loads, and what is left over the load.

use loads::FlightFile;
use loads::compare::Comparison;
use loads::flight::Channel;
use report::{Figure, Panel, Series, Style};

use super::flightloads_measured::{MODELS, Measured, comparison};
use crate::failure::Failure;
use crate::output::ResultFolder;

/// Two figures a condition: a panel each station and load.
pub(super) fn write_figures(
    folder: &ResultFolder,
    file: &FlightFile,
    all: &[Measured],
) -> Result<(), Failure> {
    for (number, one) in all.iter().enumerate() {
        let channels = &one.channels;
        let of = |channel: usize| -> Vec<(&'static str, Comparison)> {
            let each = MODELS.into_iter().enumerate();
            each.filter_map(|(model, name)| Some((name, comparison(one, channel, model)?))).collect()
        };
        let comparisons: Vec<_> = (0..channels.len()).map(|at| (&channels[at], of(at))).collect();
        let columns = channels.len().min(3);
        let r = file.thresholds().reliable_within;
        let name = &one.condition.name;
        let panels = comparisons.iter().map(|(channel, models)| across(channel, models, r)).collect();
        folder.write_figure(
            &format!("measured_{:02}", number + 1),
            "Measured over calculated loads; dashed equality and what is asked for. Points that fitted the corrections are apart.",
            Figure::new(format!("{name}: measured over calculated"), panels, columns),
        )?;
        let panels = comparisons.iter().map(|(channel, models)| left(channel, models)).collect();
        folder.write_figure(
            &format!("left_{:02}", number + 1),
            "Measured less calculated over the calculated load: a slope is a factor, a curve an effect that the model lacks.",
            Figure::new(format!("{name}: measured less calculated"), panels, columns),
        )?;
    }
    Ok(())
}

/// Calculated and measured loads of the judged or the fitted points.
fn points(comparison: &Comparison, fitted: bool) -> (Vec<f64>, Vec<f64>) {
    let own = comparison.points.iter().filter(|point| point.fitted == fitted);
    own.map(|point| (point.calculated, point.measured)).unzip()
}

fn across(channel: &Channel, models: &[(&str, Comparison)], r: f64) -> Panel {
    let mut series = Vec::new();
    for (name, comparison) in models {
        for (fitted, words) in [(false, (*name).to_owned()), (true, format!("{name}, fitted"))] {
            let (x, y) = points(comparison, fitted);
            if !x.is_empty() {
                series.push(Series::new(words, x, y, Style::Points));
            }
        }
    }
    let all = models.iter().flat_map(|(_, comparison)| &comparison.points);
    let ends = all.fold((0.0f64, 0.0f64), |ends, p| (ends.0.min(p.calculated), ends.1.max(p.calculated)));
    let x = vec![ends.0, ends.1];
    let line = |factor: f64| x.iter().map(|x| factor * x).collect::<Vec<f64>>();
    series.push(Series::new("equal", x.clone(), line(1.0), Style::DashedLine));
    for factor in [1.0 - r, 1.0 + r] {
        series.push(Series::new("asked for", x.clone(), line(factor), Style::Line));
    }
    let axis = |what: &str| format!("{what} {} ({})", channel.load.name(), channel.load.unit());
    Panel::new(title(channel), axis("calculated"), axis("measured"), series)
}

fn left(channel: &Channel, models: &[(&str, Comparison)]) -> Panel {
    let series = models
        .iter()
        .filter_map(|(name, comparison)| {
            let (x, y) = points(comparison, false);
            let left = x.iter().zip(&y).map(|(calculated, measured)| measured - calculated).collect();
            (!x.is_empty()).then(|| Series::new(*name, x, left, Style::Points))
        })
        .collect();
    let unit = channel.load.unit();
    let load = channel.load.name();
    Panel::new(title(channel), format!("calculated {load} ({unit})"), format!("left ({unit})"), series)
}

fn title(channel: &Channel) -> String {
    format!("{} {}", channel.station, channel.load.name())
}
