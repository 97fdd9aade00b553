//! Figures of `response`: the choice, the fit, the surface with what is known of it within and beyond the data; effects on
//! normal and half-normal plots; curves of published models.

use report::{Figure, Panel, Series, Style, extent};
use response::{
    Analysis, Effects, Lenth, PlotPoint, TableAnalysis, TableStudy, half_normal_plot, mav, normal_plot,
};

use crate::failure::Failure;
use crate::pages::values::with_unit;

/// Points of a curve over a factor.
const POINTS: usize = 61;
/// How far a curve goes beyond the data, of their range, on either side.
const BEYOND: f64 = 0.3;

/// One response: the curve over the number of terms, measured beside fitted, residuals on a normal plot, and the surface
/// over each factor.
pub(super) fn response(
    study: &TableStudy,
    table: &TableAnalysis,
    analysis: &Analysis,
) -> Result<Figure, Failure> {
    let fitted = &analysis.choice.fitted;
    let mut panels = vec![choice(analysis), fit(table, analysis), residuals(analysis)];
    for name in table.data.factor_names() {
        panels.push(over(study, table, analysis, name)?);
    }
    let title = format!("{} of {}: {} terms", fitted.response, study.data, fitted.coefficients.len());
    Ok(Figure::new(title, panels, 3))
}

fn choice(analysis: &Analysis) -> Panel {
    let curve = &analysis.choice.curve;
    // logarithms: the first terms take off almost everything
    let of = |name: &str, value: &dyn Fn(usize) -> f64, style| {
        let x = curve.iter().map(|step| step.criteria.terms as f64).collect();
        Series::new(name, x, (0..curve.len()).map(|k| value(k).log10()).collect(), style)
    };
    let chosen = &curve[analysis.choice.chosen].criteria;
    Panel::new(
        "choice of terms",
        "number of terms",
        "log10 of mean square",
        vec![
            of("predicted squared error", &|k| curve[k].criteria.pse, Style::Line),
            of("mean squared error", &|k| curve[k].criteria.mse, Style::DashedLine),
            of("leave-one-out", &|k| curve[k].criteria.leave_one_out, Style::DashedLine),
            Series::new("chosen", vec![chosen.terms as f64], vec![chosen.pse.log10()], Style::Points),
        ],
    )
}

fn fit(table: &TableAnalysis, analysis: &Analysis) -> Panel {
    let fitted = &analysis.choice.fitted;
    let measured = table.data.response_values(&fitted.response).unwrap_or_default().to_vec();
    let values: Vec<f64> = measured.iter().zip(&fitted.residuals).map(|(y, rest)| y - rest).collect();
    let (low, high) = extent(values.iter().copied());
    Panel::new(
        "measured over fitted",
        format!("{} fitted", fitted.response),
        format!("{} measured", fitted.response),
        vec![
            Series::new("equal", vec![low, high], vec![low, high], Style::Line),
            Series::new("points", values, measured, Style::Points),
        ],
    )
}

fn residuals(analysis: &Analysis) -> Panel {
    let fitted = &analysis.choice.fitted;
    let plotted = normal_plot(&fitted.residuals);
    let sigma = fitted.error_variance.sqrt();
    let largest = plotted.last().map_or(1.0, |point| point.quantile);
    Panel::new(
        "residuals, normal plot",
        "residual",
        "normal quantile",
        vec![
            Series::new(
                "equal",
                vec![-sigma * largest, sigma * largest],
                vec![-largest, largest],
                Style::Line,
            ),
            cloud("points", &plotted),
        ],
    )
}

fn cloud(name: &str, points: &[PlotPoint]) -> Series {
    let x = points.iter().map(|point| point.effect).collect();
    Series::new(name, x, points.iter().map(|point| point.quantile).collect(), Style::Points)
}

/// The surface over a factor, the others in the middle of their range, with the interval of the next reading.
fn over(
    study: &TableStudy,
    table: &TableAnalysis,
    analysis: &Analysis,
    factor: &str,
) -> Result<Panel, Failure> {
    let (data, fitted) = (&table.data, &analysis.choice.fitted);
    let range = |name: &str| extent(data.factor_values(name).unwrap_or_default().iter().copied());
    let names = data.factor_names();
    let mut point: Vec<(&str, f64)> =
        names.iter().map(|name| (*name, 0.5 * (range(name).0 + range(name).1))).collect();
    let place = names.iter().position(|name| *name == factor).unwrap_or(0);
    let (low, high) = range(factor);
    let (mut x, mut known, mut beyond, mut bounds) =
        (Vec::new(), Vec::new(), Vec::new(), [Vec::new(), Vec::new()]);
    for k in 0..POINTS {
        let share = k as f64 / (POINTS - 1) as f64 * (1.0 + 2.0 * BEYOND) - BEYOND;
        point[place].1 = low + share * (high - low);
        // a pole beyond the data is no fault of the data
        let Ok(prediction) = fitted.predict(&point) else { continue };
        let (least, most) = prediction.reading_interval(study.level).map_err(Failure::computation)?;
        x.push(point[place].1);
        let outside = prediction.extrapolated || !(-1e-9..=1.0 + 1e-9).contains(&share);
        known.push(if outside { f64::NAN } else { prediction.value });
        beyond.push(prediction.value);
        bounds[0].push(least);
        bounds[1].push(most);
    }
    let interval = format!("interval of a reading, {} %", 100.0 * study.level);
    let [least, most] = bounds;
    Ok(Panel::new(
        format!("over {factor}, the others in the middle"),
        with_unit(factor),
        with_unit(&fitted.response),
        vec![
            Series::new(interval.clone(), x.clone(), least, Style::Edge),
            Series::new(interval, x.clone(), most, Style::Edge),
            Series::new("beyond the data", x.clone(), beyond, Style::Line),
            Series::new("surface", x, known, Style::Line),
        ],
    ))
}

/// Effects of all responses of a table, half-normal beside normal plots, with Lenth's margin.
pub(super) fn effects(study: &TableStudy, all: &[Effects]) -> Option<Figure> {
    let mut panels = Vec::new();
    for effects in all.iter().filter(|effects| effects.effects.len() > 1) {
        let values: Vec<f64> = effects.effects.iter().map(|effect| effect.value).collect();
        for (kind, points) in [("half-normal", half_normal_plot(&values)), ("normal", normal_plot(&values))] {
            let (bottom, top) = extent(points.iter().map(|point| point.quantile).chain([0.0, 0.1]));
            let mut series: Vec<Series> = points
                .iter()
                .map(|point| {
                    let name = effects.effects[point.index].term.to_string();
                    cloud(&name, std::slice::from_ref(point))
                })
                .collect();
            // noise lies on a line through zero whose slope is its standard deviation
            let tested = effects.effects[0].test.map(|test| test.standard_error);
            if let Some(sigma) = tested.or_else(|| effects.lenth.map(|lenth| lenth.pseudo_standard_error)) {
                let ends = vec![bottom, top];
                series.push(Series::new(
                    "noise",
                    ends.iter().map(|end| sigma * end).collect(),
                    ends,
                    Style::Line,
                ));
            }
            if let Some(lenth) = worth_a_look(effects) {
                let at = |margin: f64| {
                    Series::new("Lenth's margin", vec![margin; 2], vec![bottom, top], Style::DashedLine)
                };
                series.push(at(lenth.margin));
                if kind == "normal" {
                    series.push(at(-lenth.margin));
                }
            }
            panels.push(Panel::new(
                format!("{}, {kind} plot", effects.response),
                if kind == "normal" { "effect" } else { "size of effect" },
                "normal quantile",
                series,
            ));
        }
    }
    if panels.is_empty() {
        return None;
    }
    let title = format!("Effects of {}", study.data);
    Some(Figure::new(title, panels, 2))
}

/// Lenth's margins if they say something: of few effects most must be noise, and replicates say more.
pub(super) fn worth_a_look(effects: &Effects) -> Option<Lenth> {
    effects.lenth.filter(|_| effects.effects.len() > 5 || effects.degrees_of_freedom <= 0.0)
}

/// A figure of the published models.
pub(super) fn published(figure: mav::figures::Figure) -> Figure {
    let panels = figure.panels.into_iter().map(|panel| {
        Panel::new(
            "",
            panel.x_label,
            panel.y_label,
            panel
                .curves
                .into_iter()
                .map(|curve| Series::new(curve.name, curve.x, curve.y, Style::Line))
                .collect(),
        )
    });
    let panels: Vec<Panel> = panels.collect();
    let columns = if panels.len() == 6 { 2 } else { 3 };
    // a single panel is too narrow for more than the beginning; result.json has it all
    let end = if panels.len() > 1 { None } else { figure.title.find([',', '(']) };
    let title = figure.title[..end.unwrap_or(figure.title.len())].trim_end().to_string();
    Figure::new(title, panels, columns)
}
