//! What a campaign's loads may have been mistaken for: each cause undoes itself on the measured lines, and the evidence of what
//! is left, under what panel models are usually off by, is compared with that of the lines as they are.
//!
//! Slopes and loads at zero angle `d` of all airspeeds are Gaussian about theory `m`: lift slope, load centre, zero-lift angle
//! and zero-lift moment are off by so much in common and so much at each airspeed, and the whole by half, once or three times
//! of that. A cause with parameter `p` turns `d` into `A d + b`; its evidence is the mean over `p` of the density of that times
//! the determinant of `A`.

use super::finding::Finding;
use super::lines::{Line, Lines};
use crate::campaign::Campaign;
use aero::{Corrections, Flow};
use coupling::{ByLoad, CouplingError, Load, RootLoads, SteadyCase, SteadyModel};
use faer::{Mat, Side};

/// What theory is off by, one standard deviation: in common, and at each airspeed for itself.
struct Spread {
    /// Of the lift slope, as a share.
    lift: [f64; 2],
    /// Of the load centre along the span, as a share of its arm.
    centre_y: [f64; 2],
    /// Of the load centre along the chord, in chords.
    centre_x: [f64; 2],
    /// Of the zero-lift angle, rad.
    zero_lift_rad: [f64; 2],
    /// Of the zero-lift moment coefficient.
    moment: [f64; 2],
}

/// Sections of panel models without thickness: lift slopes of polars are 0.85 to 1.1 of theory's, the centre of lift lies
/// within 0.03 to 0.08 chords of the quarter chord, zero-lift angles within a degree or two.
const USUAL: Spread = Spread {
    lift: [0.08, 0.03],
    centre_y: [0.06, 0.02],
    centre_x: [0.04, 0.015],
    zero_lift_rad: [0.015, 0.015],
    moment: [0.02, 0.01],
};
/// A pressure offset acts elsewhere than lift by the angle of attack: its centre, as shares of arm and chord.
const OFFSET_CENTRE: [f64; 2] = [0.3, 0.2];
/// Moment coefficients turn into the slope of lift by this, per rad.
const LIFT_SLOPE: f64 = 5.0;
/// How much more or less than usual theory may be off as a whole.
const SCALES: [f64; 3] = [0.5, 1.0, 3.0];
/// Log Bayes factor against the lines as they are from which a cause is named: mistakes of each kind are rare (one campaign
/// in a hundred, 4.6), and a sentence must be right (3.0).
const NAMED: f64 = 7.6;
/// A cause within this of the best is named beside it.
const BESIDE: f64 = 3.0;
/// Other places of the balance's axes, in arms of the lift, and other spans, as a share.
const SHIFTS: [f64; 14] =
    [-1.0, -0.7, -0.5, -0.35, -0.25, -0.17, -0.12, 0.12, 0.17, 0.25, 0.35, 0.5, 0.7, 1.0];
const SPANS: [f64; 10] = [0.35, 0.45, 0.55, 0.65, 0.75, 1.3, 1.5, 1.8, 2.2, 2.8];

/// A cause at one value of its parameter.
struct Undone {
    /// What it is, with its size.
    words: String,
    /// On the loads in the order Fz, Mx, My.
    matrix: [[f64; 3]; 3],
    /// Added to the loads at zero angle afterwards.
    shift: RootLoads,
}

/// A cause: its values, equally likely.
type Cause = Vec<Undone>;

/// Causes that explain the lines far better than theory's usual errors; none where the lines need none.
pub(super) fn find<M: SteadyModel>(
    model: &M,
    campaign: &Campaign,
    lines: &[Lines],
) -> Result<Vec<Finding>, CouplingError> {
    if lines.is_empty() || lines[0].channels.iter().filter(|measured| **measured).count() < 2 {
        return Ok(Vec::new());
    }
    let as_it_is = Undone::linear("", IDENTITY);
    let null = log_evidence(lines, std::slice::from_ref(&as_it_is)).0;
    let mut judged: Vec<(f64, String)> = Vec::new();
    for cause in causes(model, campaign, lines)? {
        let (evidence, best) = log_evidence(lines, &cause);
        judged.push((evidence - null, cause[best].words.clone()));
    }
    judged.sort_by(|a, b| b.0.total_cmp(&a.0));
    let Some(best) = judged.first().filter(|best| best.0 > NAMED) else { return Ok(Vec::new()) };
    let rivals: Vec<&str> =
        judged.iter().filter(|one| one.0 > best.0 - BESIDE).map(|one| one.1.as_str()).collect();
    Ok(vec![Finding::defect(format!(
        "the root loads of the static cases do not fit this wing as they are: {} (log Bayes factor {:.0})",
        rivals.join(", or "),
        best.0,
    ))])
}

const IDENTITY: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl Undone {
    fn linear(words: &str, matrix: [[f64; 3]; 3]) -> Self {
        Self { words: words.to_owned(), matrix, shift: RootLoads::default() }
    }

    fn scales(words: &str, by: [f64; 3]) -> Self {
        Self::linear(words, [[by[0], 0.0, 0.0], [0.0, by[1], 0.0], [0.0, 0.0, by[2]]])
    }

    fn determinant(&self) -> f64 {
        Mat::from_fn(3, 3, |i, j| self.matrix[i][j]).determinant().abs()
    }
}

/// Signs, channels and units.
fn mistaken(lines: &[Lines]) -> Vec<Cause> {
    let ByLoad { mx, my, .. } = lines[0].channels;
    let mut all: Vec<Cause> = Vec::new();
    let mut one = |is_possible: bool, undone: Undone| {
        if is_possible {
            all.push(vec![undone]);
        }
    };
    one(my, Undone::scales("My_Nm has the other sign (nose up is positive)", [1.0, 1.0, -1.0]));
    one(mx, Undone::scales("Mx_Nm has the other sign (tip up is positive)", [1.0, -1.0, 1.0]));
    let swapped = |sign: f64| [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, sign, 0.0]];
    for (sign, nose) in [(1.0, "up"), (-1.0, "down")] {
        let words = format!(
            "Mx_Nm and My_Nm are swapped (column My_Nm holds the bending moment Mx, tip up positive; column Mx_Nm holds the pitching \
             moment My, nose {nose} positive)"
        );
        one(mx && my, Undone::linear(&words, swapped(sign)));
    }
    let (lbf_n, ft_m, in_m, kgf_n) = (4.448_221_615, 0.3048, 0.0254, 9.806_65);
    one(
        true,
        Undone::scales(
            "loads are in lbf and lbf ft instead of N and N m",
            [lbf_n, lbf_n * ft_m, lbf_n * ft_m],
        ),
    );
    one(
        true,
        Undone::scales(
            "loads are in lbf and lbf in instead of N and N m",
            [lbf_n, lbf_n * in_m, lbf_n * in_m],
        ),
    );
    one(true, Undone::scales("loads are in kgf and kgf m instead of N and N m", [kgf_n; 3]));
    one(true, Undone::scales("V_m_s is in knots", [0.514_444_f64.powi(-2); 3]));
    one(true, Undone::scales("V_m_s is in ft/s", [0.3048_f64.powi(-2); 3]));
    one(true, Undone::scales("V_m_s is in mph", [0.447_04_f64.powi(-2); 3]));
    all
}

/// Other places of the balance's axes, and other spans.
fn places(lines: &[Lines]) -> Vec<Cause> {
    let arm_m = arm_m(&lines[lines.len() - 1]);
    let ByLoad { fz, mx, my } = lines[0].channels;
    let mut all: Vec<Cause> = Vec::new();
    if fz && my {
        let moved = |share: &f64| {
            let dx_m = share * arm_m;
            let words = format!(
                "My_Nm is about a point {:.2} m {} the wing file's balance",
                dx_m.abs(),
                if dx_m > 0.0 { "aft of" } else { "ahead of" }
            );
            // My = -(x - dx) Fz
            Undone::linear(&words, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-dx_m, 0.0, 1.0]])
        };
        all.push(SHIFTS.iter().map(moved).collect());
    }
    if fz && mx {
        let moved = |share: &f64| {
            let dy_m = share * arm_m;
            let words = format!(
                "Mx_Nm is about a point {:.2} m {} of the wing file's balance",
                dy_m.abs(),
                if dy_m > 0.0 { "outboard" } else { "inboard" }
            );
            Undone::linear(&words, [[1.0, 0.0, 0.0], [dy_m, 1.0, 0.0], [0.0, 0.0, 1.0]])
        };
        all.push(SHIFTS.iter().map(moved).collect());
        let spanned = |share: &f64| {
            let words = format!("the measured wing has {share:.2} times the span of the wing file's");
            Undone::scales(&words, [1.0 / share, 1.0 / (share * share), 1.0 / share])
        };
        all.push(SPANS.iter().map(spanned).collect());
    }
    all
}

fn causes<M: SteadyModel>(
    model: &M,
    campaign: &Campaign,
    lines: &[Lines],
) -> Result<Vec<Cause>, CouplingError> {
    let mut all = mistaken(lines);
    all.extend(places(lines));
    if campaign.points.iter().all(|point| point.v_m_s > 0.0) {
        let weight = weight(model, campaign)?;
        let words = format!(
            "the wing's weight ({:.1} N, {:.1} N m, {:.1} N m) is not tared: the static cases have no rows at V_m_s = 0 to show it",
            -weight.fz_n, -weight.mx_nm, -weight.my_nm,
        );
        all.push(vec![Undone { words, matrix: IDENTITY, shift: RootLoads::default() - weight }]);
    }
    Ok(all)
}

/// Root loads of the wing's weight at alpha = 0, N and N m: the tare of the model is half of what turning it over takes.
pub(super) fn weight<M: SteadyModel>(model: &M, campaign: &Campaign) -> Result<RootLoads, CouplingError> {
    let flow = Flow { v_m_s: 0.0, rho_kg_m3: campaign.rho_kg_m3 };
    let neutral = Corrections::neutral(model.correctable().len());
    let turned = model.root_loads(&[SteadyCase::new(flow, std::f64::consts::PI)], &neutral)?;
    Ok(RootLoads::from_array(
        turned.first().map_or([0.0; 3], |load| load.to_array().map(|value| -0.5 * value)),
    ))
}

/// Arm of theory's lift along the span, m.
fn arm_m(lines: &Lines) -> f64 {
    (lines.theory.mx.slope / lines.theory.fz.slope).abs()
}

/// Logarithm of the mean density over a cause's values and over scales of what theory is off by, and the likeliest value.
fn log_evidence(lines: &[Lines], cause: &[Undone]) -> (f64, usize) {
    let by_value: Vec<f64> =
        cause.iter().map(|undone| log_mean(&SCALES.map(|scale| log_density(lines, undone, scale)))).collect();
    let best = (0..by_value.len()).max_by(|&a, &b| by_value[a].total_cmp(&by_value[b])).unwrap_or(0);
    (log_mean(&by_value), best)
}

fn log_mean(values: &[f64]) -> f64 {
    let largest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if largest == f64::NEG_INFINITY {
        return largest;
    }
    largest + (values.iter().map(|value| (value - largest).exp()).sum::<f64>() / values.len() as f64).ln()
}

/// A number of the lines: which airspeed's, of which load, its slope (0) or load at zero angle (1).
#[derive(Clone, Copy)]
struct Entry {
    line: usize,
    load: Load,
    part: usize,
}

impl Entry {
    fn of(self, lines: &[ByLoad<Line>]) -> f64 {
        lines[self.line][self.load].parts()[self.part]
    }
}

/// Logarithm of the density of all lines, a cause undone, in the coordinates of the lines as they are.
fn log_density(lines: &[Lines], undone: &Undone, scale: f64) -> f64 {
    let channels: Vec<Load> = Load::ALL.into_iter().filter(|&load| lines[0].channels[load]).collect();
    let entries: Vec<Entry> = (0..lines.len())
        .flat_map(|line| {
            let both = move |&load: &Load| [0, 1].map(|part| Entry { line, load, part });
            channels.iter().flat_map(both)
        })
        .collect();
    let n = entries.len();
    let columns = columns(lines, scale);
    let matrix = &undone.matrix;
    let on = |load: Load, from: Load| matrix[load as usize][from as usize];
    let shift = ByLoad::from(undone.shift);
    let measured = |at: Entry| {
        let of = |from: Load| on(at.load, from) * lines[at.line].measured[from].parts()[at.part];
        Load::ALL.map(of).into_iter().sum::<f64>() + if at.part == 1 { shift[at.load] } else { 0.0 }
    };
    let noise = |a: Entry, b: Entry| {
        if a.line != b.line {
            return 0.0;
        }
        let of = |from: Load| {
            on(a.load, from) * on(b.load, from) * lines[a.line].noise[from].matrix()[a.part][b.part]
        };
        Load::ALL.map(of).into_iter().sum()
    };
    let covariance = Mat::from_fn(n, n, |i, j| {
        let (a, b) = (entries[i], entries[j]);
        let common: f64 = columns.iter().map(|column| a.of(column) * b.of(column)).sum();
        common + noise(a, b)
    });
    let Ok(factor) = covariance.llt(Side::Lower) else { return f64::NEG_INFINITY };
    let mut off = Mat::from_fn(n, 1, |i, _| {
        let at = entries[i];
        measured(at) - lines[at.line].theory[at.load].parts()[at.part]
    });
    factor.L().solve_lower_triangular_in_place(off.as_mut());
    let squares: f64 = (0..n).map(|i| off[(i, 0)].powi(2)).sum();
    let log_det: f64 = (0..n).map(|i| factor.L()[(i, i)].ln()).sum();
    let all_measured = channels.len() == 3;
    // of channels that are not measured the determinant is one: only scales act on them
    let determinant = if all_measured {
        undone.determinant()
    } else {
        channels.iter().map(|&load| on(load, load).abs()).product()
    };
    -0.5 * squares - log_det + 2.0 * lines.len() as f64 * f64::ln(determinant)
}

/// What one source of error does to the lines of an airspeed.
type Shape<'a> = &'a dyn Fn(&Lines) -> ByLoad<Line>;

/// By source of error: one standard deviation of slope and load at zero angle by airspeed and channel.
fn columns(lines: &[Lines], scale: f64) -> Vec<Vec<ByLoad<Line>>> {
    let mut all = Vec::new();
    let mx = |mx: Line| ByLoad { mx, ..ByLoad::default() };
    let my = |my: Line| ByLoad { my, ..ByLoad::default() };
    let shapes: [(Shape<'_>, [f64; 2]); 7] = [
        (&|l: &Lines| l.theory, USUAL.lift),
        (&|l: &Lines| mx(l.theory.mx), USUAL.centre_y),
        (&|l: &Lines| my(l.theory.fz.times(l.chord_m, l.chord_m)), USUAL.centre_x),
        (&|l: &Lines| l.theory.map(|line| Line::level(line.slope)), USUAL.zero_lift_rad),
        (&|l: &Lines| mx(Line::level(OFFSET_CENTRE[0] * l.theory.mx.slope)), USUAL.zero_lift_rad),
        (&|l: &Lines| my(Line::level(OFFSET_CENTRE[1] * l.theory.fz.slope * l.chord_m)), USUAL.zero_lift_rad),
        (&|l: &Lines| my(Line::level(l.theory.fz.slope / LIFT_SLOPE * l.chord_m)), USUAL.moment),
    ];
    for (shape, [common, own]) in shapes {
        let sized =
            |lines: &Lines, size: f64| shape(lines).map(|line| line.times(scale * size, scale * size));
        all.push(lines.iter().map(|line| sized(line, common)).collect());
        for k in 0..lines.len() {
            all.push(
                lines
                    .iter()
                    .enumerate()
                    .map(|(j, line)| sized(line, if j == k { own } else { 0.0 }))
                    .collect(),
            );
        }
    }
    all
}

#[cfg(test)]
mod tests;
