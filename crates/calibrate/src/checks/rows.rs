//! Single rows of static cases: one that no others bear out, scatter beyond what is declared, rows of other airspeeds.

use super::finding::{Checked, Finding};
use crate::campaign::{CHANNELS, Campaign, ChannelNoise, Sets, StaticPoint};
use crate::objective::polynomial_residuals;
use crate::statics::cells::block_name;
use crate::statics::{AirspeedData, StaticData};
use aero::flow::{same_airspeed, same_angle};
use faer::Mat;
use statrs::distribution::{ChiSquared, ContinuousCDF, FisherSnedecor};

/// Probability that rows without a fault are called one, in a whole campaign.
const LEVEL: f64 = 1e-4;
/// At most one row in so many is set aside: beyond, it is not single rows that are wrong.
const ONE_SET_ASIDE_IN: usize = 10;
/// Rows set aside at most, however many there are.
const MOST_SET_ASIDE: usize = 20;
/// A row is the wrong one only if no other, left out, takes this share of the squares that it takes.
const ALONE: f64 = 0.8;
/// A row that the curve goes through whatever it reads is told from none.
const LEAST_LEFT: f64 = 1e-6;
/// Rows are not read more closely than this share of the largest load.
const ROUNDING: f64 = 1e-6;
/// Scatter over what is declared that needs no remark.
const SCATTER: f64 = 2.0;
/// The mean of an angle is off the curve through the others by so many standard deviations: more than noise and a little curvature.
const LONE: f64 = 8.0;
/// Rows beyond the first at their angle that their airspeeds are judged by.
const LEAST_REPEATS: usize = 3;
/// Rows of one airspeed differ by their loads' common factor alone if it explains this share of their scatter ...
const COMMON_FACTOR: f64 = 0.8;
/// ... and its root mean square is more than this.
const LEAST_FACTOR: f64 = 0.03;

/// The rows of one airspeed that are fitted, block offsets taken out.
struct Group {
    v_m_s: f64,
    /// Places among the campaign's points.
    rows: Vec<usize>,
    /// By row.
    alphas_rad: Vec<f64>,
    /// By channel and row.
    loads: [Vec<f64>; 4],
    /// Number of different angles.
    angles: usize,
}

/// Groups the rows, sets aside those that no others bear out, and compares their scatter with what is declared.
pub(super) fn check(campaign: &Campaign, data: StaticData) -> Checked {
    let mut checked =
        Checked { campaign: campaign.clone(), data, findings: Vec::new(), set_aside: Vec::new() };
    if campaign.sets == Sets::Common {
        return checked;
    }
    let most = campaign.points.len().div_ceil(ONE_SET_ASIDE_IN).min(MOST_SET_ASIDE);
    loop {
        let groups = groups(&checked.campaign, &checked.data);
        if let Some(found) = other_airspeeds(&groups, &checked.data) {
            checked.findings.push(found);
            return checked;
        }
        let Some(worst) = worst_row(&groups, &checked.campaign, &checked.data) else { break };
        if worst.is_end {
            checked.findings.push(Finding::suspicion(format!(
                "{}; it stays: the wing may stall at the ends of the angles, or the row is wrong",
                worst.sentence
            )));
            break;
        }
        let mut without = checked.campaign.clone();
        let line = without.points.remove(worst.place).span.line;
        match StaticData::from_campaign(&without) {
            Ok(better) if checked.set_aside.len() < most => {
                checked.findings.push(Finding::suspicion(format!("{}; it is set aside", worst.sentence)));
                checked.set_aside.push(line);
                (checked.campaign, checked.data) = (without, better);
            }
            _ => {
                checked.findings.push(Finding::defect(worst.sentence));
                break;
            }
        }
    }
    let groups = groups(&checked.campaign, &checked.data);
    let more = more_scatter(&groups, &checked.data);
    if let (Some(noise), false) = (&mut checked.campaign.noise, more.is_empty()) {
        let mut sigma = noise.static_point.to_array();
        for (channel, seen, _) in &more {
            sigma[*channel] = *seen;
        }
        noise.static_point = ChannelNoise::from_array(sigma);
        checked.data.point_sigma = Some(sigma);
    }
    checked.findings.extend(more.into_iter().map(|(_, _, found)| found));
    let Checked { data, findings, .. } = &mut checked;
    findings.extend(data.airspeeds.iter().filter_map(|airspeed| lone_angle(airspeed, data)));
    checked
}

fn groups(campaign: &Campaign, data: &StaticData) -> Vec<Group> {
    let offset = |row: &StaticPoint, channel: usize| {
        let block = data.blocks.iter().find(|block| block.block == block_name(row));
        block.map_or(0.0, |block| block.offset[channel])
    };
    let of = |airspeed: &AirspeedData| {
        let here = |point: &StaticPoint| {
            point.v_m_s > 0.0 && point.controls_rad.is_empty() && same_airspeed(point.v_m_s, airspeed.v_m_s)
        };
        let (places, rows): (Vec<usize>, Vec<&StaticPoint>) =
            campaign.points.iter().enumerate().filter(|(_, point)| here(point)).unzip();
        Group {
            v_m_s: airspeed.v_m_s,
            alphas_rad: rows.iter().map(|row| row.alpha_rad).collect(),
            loads: std::array::from_fn(|c| rows.iter().map(|row| row.reading(c) - offset(row, c)).collect()),
            angles: airspeed.angles.len(),
            rows: places,
        }
    };
    data.airspeeds.iter().map(of).collect()
}

/// A row that the others do not bear out.
struct Worst {
    /// Its place among the campaign's points.
    place: usize,
    sentence: String,
    /// It is the only row at the first or last angle: nothing tells a wrong reading from a wing that stalls there.
    is_end: bool,
}

/// The row furthest from what the others say, in their scatter, if chance does not explain it.
fn worst_row(groups: &[Group], campaign: &Campaign, data: &StaticData) -> Option<Worst> {
    let channels: Vec<usize> = (0..4).filter(|&c| data.channels[c]).collect();
    let tests = (groups.iter().map(|group| group.rows.len()).sum::<usize>() * channels.len()) as f64;
    let declared = data.point_sigma.filter(|_| data.noise_dof.is_none());
    let all = groups.iter().flat_map(|group| channels.iter().map(move |&channel| (group, channel)));
    let (group, channel, found) = all
        .filter_map(|(group, c)| Some((group, c, deleted(group, c, declared.map(|sigma| sigma[c]))?)))
        .filter(|(.., found)| found.p_value * tests < LEVEL)
        .max_by(|(.., a), (.., b)| (a.jump / a.scatter).abs().total_cmp(&(b.jump / b.scatter).abs()))?;
    let place = group.rows[found.row];
    let unit = ["N", "N m", "N m", "m"][channel];
    let sentence = format!(
        "line {} of the static cases: {} is {:.4} {unit} {} what the other rows at {} m/s say, whose scatter is {:.2} {unit}",
        campaign.points[place].span.line,
        CHANNELS[channel],
        found.jump.abs(),
        if found.jump > 0.0 { "above" } else { "below" },
        group.v_m_s,
        found.scatter,
    );
    Some(Worst { place, sentence, is_end: group.is_end(found.row) })
}

impl Group {
    /// Rows by angle.
    fn cells(&self) -> Vec<Vec<usize>> {
        let mut order: Vec<usize> = (0..self.rows.len()).collect();
        order.sort_by(|&a, &b| self.alphas_rad[a].total_cmp(&self.alphas_rad[b]));
        let alike = |a: &usize, b: &usize| same_angle(self.alphas_rad[*a], self.alphas_rad[*b]);
        order.chunk_by(alike).map(<[usize]>::to_vec).collect()
    }

    /// The mean of a channel over the rows at its angle, by row.
    fn means(&self, cells: &[Vec<usize>], channel: usize) -> Vec<f64> {
        let mut means = vec![0.0; self.rows.len()];
        for cell in cells {
            let mean = cell.iter().map(|&row| self.loads[channel][row]).sum::<f64>() / cell.len() as f64;
            for &row in cell {
                means[row] = mean;
            }
        }
        means
    }

    /// Whether a row is the only one at the smallest or largest angle.
    fn is_end(&self, row: usize) -> bool {
        let here = |alpha: &&f64| same_angle(**alpha, self.alphas_rad[row]);
        let is_beyond = |beyond: fn(&f64, &f64) -> bool| {
            self.alphas_rad.iter().any(|alpha| !here(&alpha) && beyond(alpha, &self.alphas_rad[row]))
        };
        self.alphas_rad.iter().filter(here).count() == 1 && !(is_beyond(f64::lt) && is_beyond(f64::gt))
    }
}

/// The row of a channel without which a smooth curve fits best.
struct Deleted {
    row: usize,
    /// The row less the curve through the others.
    jump: f64,
    /// Standard deviation of the others about it.
    scatter: f64,
    p_value: f64,
}

/// Leaves every row out of a line and of a parabola in turn: the row's residual over one less its leverage is its distance from the
/// curve through the others (Cook and Weisberg, Residuals and Influence in Regression, 1982, Section 2.2).
fn deleted(group: &Group, channel: usize, declared: Option<f64>) -> Option<Deleted> {
    let loads = &group.loads[channel];
    let n = loads.len();
    let size = loads.iter().fold(f64::MIN_POSITIVE, |most, load| most.max(load.abs()));
    let mut best: Option<Deleted> = None;
    for order in (1..=2).filter(|order| group.angles >= order + 3) {
        let dof = (n - 1 - (order + 1)) as f64;
        let (residuals, _) = polynomial_residuals(&group.alphas_rad, loads, order);
        let left = leverages(&group.alphas_rad, order).into_iter().map(|h| (1.0 - h).max(LEAST_LEFT));
        let jumps: Vec<f64> = residuals.iter().zip(left).map(|(r, left)| r / left).collect();
        let taken: Vec<f64> = residuals.iter().zip(&jumps).map(|(r, jump)| r * jump).collect();
        let row = (0..n).max_by(|&a, &b| taken[a].total_cmp(&taken[b]))?;
        let second = (0..n).filter(|&i| i != row).map(|i| taken[i]).fold(0.0, f64::max);
        let squares = residuals.iter().map(|r| r * r).sum::<f64>() - taken[row];
        // exact data scatter by rounding, which is no noise
        let shown = (squares / dof).max((ROUNDING * size).powi(2));
        // where what is left is what is declared, the declaration's certainty counts
        let known = declared.filter(|sigma| shown <= 4.0 * sigma * sigma);
        let variance = known.map_or(shown, |sigma| shown.max(sigma * sigma));
        let f = taken[row] / variance;
        let p_value = match known {
            Some(_) => ChiSquared::new(1.0).ok()?.sf(f),
            None => FisherSnedecor::new(1.0, dof).ok()?.sf(f),
        };
        // where another row takes nearly as much, it could be that one
        let is_alone = second < ALONE * taken[row];
        if is_alone && best.as_ref().is_none_or(|b| p_value < b.p_value) {
            best = Some(Deleted { row, jump: jumps[row], scatter: variance.sqrt(), p_value });
        }
    }
    best
}

/// Share of each reading in its own fitted value, for a least-squares polynomial.
fn leverages(x: &[f64], order: usize) -> Vec<f64> {
    let scale = x.iter().fold(f64::MIN_POSITIVE, |most, v| most.max(v.abs()));
    let matrix = Mat::from_fn(x.len(), order + 1, |i, k| (0..k).fold(1.0, |power, _| power * x[i] / scale));
    let q = matrix.qr().compute_thin_Q();
    (0..x.len()).map(|i| (0..=order).map(|k| q[(i, k)].powi(2)).sum()).collect()
}

/// Rows of one airspeed and angle whose loads are all too large or all too small together. Angles are compared with themselves
/// only: stall makes all loads small together, too.
fn other_airspeeds(groups: &[Group], data: &StaticData) -> Option<Finding> {
    let channels: Vec<usize> = (0..3).filter(|&c| data.channels[c]).collect();
    if channels.len() < 2 {
        return None;
    }
    let of = |group: &Group| {
        let cells = group.cells();
        let rows = group.rows.len();
        if rows < cells.len() + LEAST_REPEATS {
            return None;
        }
        let fits: Vec<(Vec<f64>, Vec<f64>, f64)> = channels
            .iter()
            .map(|&c| {
                let means = group.means(&cells, c);
                let residuals = group.loads[c].iter().zip(&means).map(|(load, mean)| load - mean).collect();
                let size = means.iter().map(|mean| mean * mean).sum::<f64>() / rows as f64;
                (residuals, means, 1.0 / size.max(f64::MIN_POSITIVE))
            })
            .collect();
        let sum = |of: &dyn Fn(f64, f64) -> f64, i: usize| -> f64 {
            fits.iter().map(|(residuals, fitted, weight)| weight * of(residuals[i], fitted[i])).sum()
        };
        let factor: Vec<f64> =
            (0..rows).map(|i| sum(&|r, f| r * f, i) / sum(&|_, f| f * f, i).max(f64::MIN_POSITIVE)).collect();
        let all: f64 = (0..rows).map(|i| sum(&|r, _| r * r, i)).sum();
        let left: f64 = (0..rows).map(|i| sum(&|r, f| (r - factor[i] * f).powi(2), i)).sum();
        let rms = (factor.iter().map(|k| k * k).sum::<f64>() / rows as f64).sqrt();
        // one row alone is a wrong row, not a wrong label of many
        let many = factor.iter().filter(|k| k.abs() > 0.5 * rms).count() * 3 > rows;
        (left < (1.0 - COMMON_FACTOR) * all && rms > LEAST_FACTOR && many).then(|| {
            let ends = factor.iter().fold([0.0_f64, 0.0], |[a, b], k| [a.min(*k), b.max(*k)]);
            let [slow, fast] = ends.map(|k| group.v_m_s * (1.0 + k).max(0.0).sqrt());
            Finding::defect(format!(
                "rows with V_m_s = {}: the loads of a row are all too large or all too small together, by {:.0} to {:+.0} %, as if \
                 they had been measured between about {slow:.0} and {fast:.0} m/s: is V_m_s the airspeed of each row?",
                group.v_m_s, 100.0 * ends[0], 100.0 * ends[1],
            ))
        })
    };
    groups.iter().find_map(of)
}

/// Scatter of replicates, or about smooth curves where there are none, where it is more than declared: channel and size.
fn more_scatter(groups: &[Group], data: &StaticData) -> Vec<(usize, f64, Finding)> {
    let Some(declared) = data.point_sigma.filter(|_| data.noise_dof.is_none()) else { return Vec::new() };
    let mut found = Vec::new();
    for channel in (0..4).filter(|&c| data.channels[c]) {
        let replicated: Vec<(f64, usize)> =
            groups.iter().map(|group| of_replicates(group, channel)).collect();
        let freedom = |all: &[(f64, usize)]| {
            all.iter().map(|one| one.1).sum::<usize>().saturating_sub(data.blocks.len().saturating_sub(1))
        };
        let (scatter, about) = if freedom(&replicated) >= 3 {
            (replicated, "repeated rows")
        } else {
            (groups.iter().map(|group| about_a_curve(group, channel)).collect(), "rows about smooth curves")
        };
        let dof = freedom(&scatter);
        let squares: f64 = scatter.iter().map(|one| one.0).sum();
        let Ok(law) = ChiSquared::new(dof.max(1) as f64) else { continue };
        let ratio = (squares / dof.max(1) as f64).sqrt() / declared[channel];
        if dof >= 3 && ratio > SCATTER && law.sf(squares / declared[channel].powi(2)) < LEVEL {
            let seen = ratio * declared[channel];
            let said = Finding::suspicion(format!(
                "{}: {about} scatter by {:.2}, {ratio:.1} times the {} that campaign.ron declares; what they show is taken",
                CHANNELS[channel], seen, declared[channel],
            ));
            found.push((channel, seen, said));
        }
    }
    found
}

/// One angle between others whose rows agree and contradict all other angles. Stall bends what follows, too, and the ends alone.
fn lone_angle(airspeed: &AirspeedData, data: &StaticData) -> Option<Finding> {
    let angles = &airspeed.angles;
    let means = Group {
        v_m_s: airspeed.v_m_s,
        rows: (0..angles.len()).collect(),
        alphas_rad: angles.iter().map(|angle| angle.alpha_rad).collect(),
        loads: std::array::from_fn(|c| angles.iter().map(|angle| angle.readings()[c]).collect()),
        angles: angles.len(),
    };
    (0..3).filter(|&c| data.channels[c]).find_map(|channel| {
        let sigma_of = |angle| Some(data.mean_sigma(angle)?[channel].hypot(data.block_sigma[channel]));
        let sigma = angles.iter().map(sigma_of).try_fold(0.0, |most: f64, sigma| Some(most.max(sigma?)))?;
        let found = deleted(&means, channel, Some(sigma))?;
        let is_lone = found.scatter <= 2.0 * sigma && found.jump.abs() > LONE * sigma;
        (is_lone && !means.is_end(found.row)).then(|| {
            Finding::defect(format!(
                "rows with V_m_s = {} and alpha_deg = {:.2}: {} is {:.3} {} a smooth curve through the other angles, {:.0} times what \
                 the rows' scatter explains: they contradict the other angles",
                airspeed.v_m_s,
                means.alphas_rad[found.row].to_degrees(),
                CHANNELS[channel],
                found.jump.abs(),
                if found.jump > 0.0 { "above" } else { "below" },
                found.jump.abs() / sigma,
            ))
        })
    })
}

/// Squares about the means of rows at one angle, and their degrees of freedom.
fn of_replicates(group: &Group, channel: usize) -> (f64, usize) {
    let cells = group.cells();
    let means = group.means(&cells, channel);
    let squares = group.loads[channel].iter().zip(means).map(|(load, mean)| (load - mean).powi(2)).sum();
    (squares, group.rows.len() - cells.len())
}

/// Squares about the stiffest polynomial that leaves one degree of freedom, of third order at most.
fn about_a_curve(group: &Group, channel: usize) -> (f64, usize) {
    let order = group.angles.saturating_sub(2).min(3);
    if order == 0 || group.rows.len() < order + 2 {
        return (0.0, 0);
    }
    let (residuals, _) = polynomial_residuals(&group.alphas_rad, &group.loads[channel], order);
    (residuals.iter().map(|r| r * r).sum(), group.rows.len() - order - 1)
}

#[cfg(test)]
mod tests;
