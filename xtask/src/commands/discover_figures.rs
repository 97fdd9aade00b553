//! Pictures of `discover`: held-out runs before and after, with what is uncertain about the model after.
//!
//! The band is two standard deviations of a measured sample about the model after: noise, parameters that calibration
//! knows only so well (one after the other, one standard deviation each) and model-form variants of the same wing. The
//! corrections' own uncertainty is not in it.

use std::fmt::Write as _;

use discover::load_model::LoadModel;
use maneuver::effects::{Active, Flown};
use rayon::prelude::*;
use report::{Figure, Panel, Series, Style};

use crate::commands::discover::{Discovered, is_held_out};
use crate::failure::Failure;
use crate::output::ResultFolder;

const CHANNELS: [(&str, &str); 3] = [("Fz_N", "Fz (N)"), ("Mx_Nm", "Mx (N m)"), ("My_Nm", "My (N m)")];
/// Standard deviations that the band is wide to either side.
const BAND: f64 = 2.0;
/// Name of its two edges, which have one colour.
const BAND_NAME: &str = "after, 2 standard deviations to either side";
/// Where the noise of a sample is taken from, Hz.
const NOISE_HZ: f64 = 6.0;

/// A held-out run.
struct Shown<'a> {
    name: &'a str,
    t_s: Vec<f64>,
    /// Places of the loads that the runs have.
    channels: Vec<usize>,
    measured: &'a [Vec<f64>; 3],
    before: &'a Flown,
    after: &'a Flown,
    /// Half the band.
    half: [Vec<f64>; 3],
}

/// Writes a picture and a CSV for every held-out run.
pub(crate) fn write(found: &Discovered<'_>, results: &ResultFolder) -> Result<(), Failure> {
    let data = &found.prepared.data;
    let first = data.statics.len();
    let held_out: Vec<usize> = (0..data.runs.len()).filter(|i| is_held_out(data.runs[*i].usage)).collect();
    if held_out.is_empty() {
        return Ok(());
    }
    let places: Vec<usize> = held_out.iter().map(|i| first + i).collect();
    let (plain, with) = (found.before(), found.after());
    let before = plain.0.fly(&plain.0.models(plain.1, None), plain.1, &places);
    let after = with.0.fly(&with.0.models(with.1, None), with.1, &places);
    let squares = uncertain_squares(found, &places, (&before, &after));
    for (k, &i) in held_out.iter().enumerate() {
        let run = &data.runs[i];
        let dt = run.stimulus.time_step_s;
        let half = |c: usize| {
            let noise = found.prepared.noise.sigma(run.airspeed, c, NOISE_HZ);
            squares[k][c].iter().map(|square| BAND * (square + noise * noise).sqrt()).collect()
        };
        let shown = Shown {
            name: &run.name,
            t_s: (0..run.measured[0].len()).map(|k| k as f64 * dt).collect(),
            channels: (0..3).filter(|&c| data.run_loads[c]).collect(),
            measured: &run.measured,
            before: &before[k],
            after: &after[k],
            half: std::array::from_fn(half),
        };
        results.write_text(&format!("runs/{}.csv", run.name), &csv(&shown))?;
        let name = format!("runs/{}", run.name);
        results.write_figure_of(&name, "", figure(&shown), &format!("{name}.csv"))?;
    }
    Ok(())
}

/// Sum of squares of what one standard deviation of everything uncertain changes, by run, channel and sample.
fn uncertain_squares(
    found: &Discovered<'_>,
    places: &[usize],
    (before, after): (&[Flown], &[Flown]),
) -> Vec<[Vec<f64>; 3]> {
    let prepared = found.prepared;
    let (simulator, effects) = found.after();
    let models = simulator.models(effects, None);
    let known = prepared.uncertain.par_iter().map(|one| {
        let more: Vec<Active> = effects.iter().chain([one]).cloned().collect();
        (simulator.fly(&simulator.models(&more, Some(&models)), &more, places), after)
    });
    let variants =
        prepared.variants.par_iter().map(|other| (other.fly(&other.models(&[], None), &[], places), before));
    let changed: Vec<(Vec<Flown>, &[Flown])> = known.chain(variants).collect();
    let mut squares: Vec<[Vec<f64>; 3]> =
        after.iter().map(|flown| flown.loads.each_ref().map(|load| vec![0.0; load.len()])).collect();
    for (new, old) in &changed {
        for ((sums, new), old) in squares.iter_mut().zip(new).zip(*old) {
            for ((sums, new), old) in sums.iter_mut().zip(&new.loads).zip(&old.loads) {
                sums.iter_mut().zip(new).zip(old).for_each(|((sum, new), old)| *sum += (new - old).powi(2));
            }
        }
    }
    squares
}

fn csv(shown: &Shown<'_>) -> String {
    let mut text = String::from("t_s");
    for &c in &shown.channels {
        let name = CHANNELS[c].0;
        let _ = write!(text, ",{name}_measured,{name}_before,{name}_after,{name}_low,{name}_high");
    }
    text.push('\n');
    for (i, t) in shown.t_s.iter().enumerate() {
        let _ = write!(text, "{t:.4}");
        for &c in &shown.channels {
            let (before, after, half) = (shown.before.loads[c][i], shown.after.loads[c][i], shown.half[c][i]);
            let (low, high) = (after - half, after + half);
            let _ = write!(text, ",{:.4},{before:.4},{after:.4},{low:.4},{high:.4}", shown.measured[c][i]);
        }
        text.push('\n');
    }
    text
}

fn figure(shown: &Shown<'_>) -> Figure {
    let line = |label: &str, values: Vec<f64>, style| Series::new(label, shown.t_s.clone(), values, style);
    let panel = |&c: &usize| {
        let edge = |sign: f64| {
            shown.after.loads[c].iter().zip(&shown.half[c]).map(|(after, half)| after + sign * half).collect()
        };
        Panel::new(
            "",
            "time (s)",
            CHANNELS[c].1,
            vec![
                line("measured", shown.measured[c].clone(), Style::Line),
                line("before", shown.before.loads[c].clone(), Style::DashedLine),
                line("after", shown.after.loads[c].clone(), Style::Line),
                line(BAND_NAME, edge(-1.0), Style::DashedLine),
                line(BAND_NAME, edge(1.0), Style::DashedLine),
            ],
        )
    };
    Figure::new(
        format!("{}: held out, before and after", shown.name),
        shown.channels.iter().map(panel).collect(),
        1,
    )
}
