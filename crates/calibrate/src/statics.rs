//! From rows of static cases to what is fitted: means per airspeed and angle, block offsets taken out.
//!
//! The model of a row is `cell mean + offset of its block + noise`, one offset a block and channel, common to all
//! airspeeds. Offsets are random effects that sum to zero: estimated jointly from the cells that several blocks
//! share, then shrunk by the share of their spread that noise explains. An offset common to all blocks cannot be
//! told from a pressure offset and stays in the data.
//!
//! With one set of corrections for all airspeeds (`Sets::Common`), means are kept apart by block, as each block has a
//! zero of the tip reading of its own, which the fit finds.

use crate::blocks::BlockFit;
use crate::campaign::{Campaign, Sets, StaticPoint, TIP, TipReading};
use crate::sensors::Sensor;
use aero::flow::{same_airspeed, same_angle};
use nastran::{InputError, Span};
use std::collections::{BTreeMap, BTreeSet};

/// The most blocks: each has an offset, and all are found together.
const MOST_BLOCKS: usize = 200;

/// One angle at one airspeed: the mean of its replicates after block offsets are removed.
#[derive(Debug, Clone, PartialEq)]
pub struct Angle {
    /// Mean angle of attack, rad.
    pub alpha_rad: f64,
    /// Mean Fz, Mx, My; meaningless where the campaign lacks the channel.
    pub loads: [f64; 3],
    /// Mean height of the tip, m; meaningless where it is not fitted.
    pub tip_z_m: f64,
    /// Index (in [`StaticData::block_names`]) of the block its rows are from; zero where blocks are averaged, which
    /// is always so with corrections by airspeed.
    pub block: usize,
    /// Line of its first row in the file, which is the order it was measured in.
    pub line: usize,
    /// Number of replicates.
    pub replicates: usize,
}

impl Angle {
    /// Fz, Mx, My and the tip's height.
    pub fn readings(&self) -> [f64; 4] {
        let [fz, mx, my] = self.loads;
        [fz, mx, my, self.tip_z_m]
    }
}

/// All angles at one airspeed, neutral controls, ascending.
#[derive(Debug, Clone, PartialEq)]
pub struct AirspeedData {
    /// Mean airspeed, m/s.
    pub v_m_s: f64,
    /// Angles in ascending order.
    pub angles: Vec<Angle>,
    /// Where its first row stands.
    pub span: Span,
}

/// A block's offset by channel, already shrunk.
#[derive(Debug, Clone, PartialEq)]
pub struct BlockOffset {
    /// Its name in the file.
    pub block: String,
    /// Fz, Mx, My, tip height (whose zeros are the fit's business where one set serves all airspeeds).
    pub offset: [f64; 4],
}

/// Static cases ready to be fitted.
#[derive(Debug, Clone)]
pub struct StaticData {
    /// Which channels are fitted.
    pub channels: [bool; 4],
    /// What the tip's zero is.
    pub tip: TipReading,
    /// Corrections by airspeed, or one set for all.
    pub sets: Sets,
    /// Names of the blocks in the order of the rows.
    pub block_names: Vec<String>,
    /// Airspeeds in ascending order.
    pub airspeeds: Vec<AirspeedData>,
    /// Offsets that were taken out.
    pub blocks: Vec<BlockOffset>,
    /// Spread of the block offsets (random effect), one standard deviation a channel; zero without blocks.
    pub block_sigma: [f64; 4],
    /// Standard deviation of one row: declared, or pooled from replicates.
    pub point_sigma: Option<[f64; 4]>,
    /// Degrees of freedom behind `point_sigma`; none if it was declared.
    pub noise_dof: Option<usize>,
    /// Rows at V = 0.
    pub weight_tares: Vec<StaticPoint>,
    /// Sensors beside the balance.
    pub sensors: Vec<Sensor>,
    /// Rows with wind on that say more than the means of the angles: with a control deflected, or with a sensor read.
    pub further: Vec<StaticPoint>,
}

/// A cell: rows of one airspeed and angle.
pub(crate) struct Cell<'a> {
    v_m_s: f64,
    alpha_rad: f64,
    pub(crate) rows: Vec<&'a StaticPoint>,
}

impl StaticData {
    /// Groups a campaign's rows, estimates and removes block offsets, and the noise.
    ///
    /// # Errors
    /// If there is no airspeed, or an airspeed has fewer than three different angles.
    pub fn from_campaign(campaign: &Campaign) -> Result<Self, InputError> {
        let fitted = rows(campaign);
        let weight_tares: Vec<StaticPoint> =
            campaign.points.iter().filter(|p| p.v_m_s == 0.0).cloned().collect();
        check_blocks(&fitted)?;
        let cells = cells(&fitted);
        match campaign.sets {
            Sets::EachAirspeed => check_angles(campaign, &cells)?,
            Sets::Common => check_rows(campaign, fitted.len())?,
        }
        let data = Self {
            channels: campaign.fitted(),
            tip: campaign.tip,
            sets: campaign.sets,
            block_names: Vec::new(),
            airspeeds: Vec::new(),
            blocks: Vec::new(),
            block_sigma: [0.0; 4],
            point_sigma: campaign.noise.map(|noise| noise.static_point.to_array()),
            noise_dof: None,
            sensors: campaign.sensors.clone(),
            further: campaign.points.iter().filter(|point| point.says_more()).cloned().collect(),
            weight_tares,
        };
        Ok(data.of_cells(&cells, &[]).0)
    }

    /// What is known without some angles (`unseen` is told the indices of airspeed and angle), and these angles, by
    /// airspeed. Nothing that was read at them enters the first: no mean, no offset of a block, no noise. They lose the
    /// offsets that the others give.
    pub(crate) fn without(
        &self,
        campaign: &Campaign,
        unseen: impl Fn(usize, usize) -> bool,
    ) -> (Self, Vec<AirspeedData>) {
        let rows = rows(campaign);
        let places =
            self.airspeeds.iter().enumerate().flat_map(|(i, a)| (0..a.angles.len()).map(move |k| (i, k)));
        let (mut seen, mut left_out) = (Vec::new(), Vec::new());
        for (cell, (airspeed, angle)) in cells(&rows).into_iter().zip(places) {
            if unseen(airspeed, angle) { left_out.push(cell) } else { seen.push(cell) }
        }
        let declared = campaign.noise.map(|noise| noise.static_point.to_array());
        let empty = Self { point_sigma: declared, noise_dof: None, blocks: Vec::new(), ..self.clone() };
        empty.of_cells(&seen, &left_out)
    }

    /// Whether more than root loads with neutral controls is used: the tip, deflected rows, sensors.
    pub fn is_more_than_root_loads(&self) -> bool {
        self.channels[TIP] || !self.further.is_empty()
    }

    /// The offset of a row's block that was taken out of a channel's means.
    pub(crate) fn offset_of(&self, row: &StaticPoint, channel: usize) -> f64 {
        let block = self.blocks.iter().find(|block| block.block == block_name(row));
        block.map_or(0.0, |block| block.offset[channel])
    }

    /// Standard deviation of the mean of an angle's replicates, by channel.
    pub fn mean_sigma(&self, angle: &Angle) -> Option<[f64; 4]> {
        self.point_sigma.map(|sigma| sigma.map(|s| s / (angle.replicates as f64).sqrt()))
    }

    /// The mean of a few blocks' offsets is itself uncertain by their spread over the root of their number, by channel.
    pub(crate) fn common_sigma(&self) -> [f64; 4] {
        let blocks = self.blocks.len().max(1) as f64;
        self.block_sigma.map(|sigma| sigma / blocks.sqrt())
    }

    /// The noise floor of paper 1, Eq. 8 at an airspeed: the sum over channels of the standard deviation of a row over the
    /// root of the rows an angle, times the channel's weight.
    pub fn noise_floor(&self, airspeed: &AirspeedData, weights: [f64; 4]) -> Option<f64> {
        let sigma = self.point_sigma?;
        let mean_inverse = airspeed.angles.iter().map(|angle| 1.0 / angle.replicates as f64).sum::<f64>()
            / airspeed.angles.len() as f64;
        Some(
            (0..4).filter(|&c| self.channels[c]).map(|c| weights[c] * (sigma[c] * mean_inverse.sqrt())).sum(),
        )
    }

    /// Offsets of blocks and noise from `cells`, and the means of these and of others with those offsets taken out.
    fn of_cells(mut self, cells: &[Cell<'_>], others: &[Cell<'_>]) -> (Self, Vec<AirspeedData>) {
        let mut names: Vec<&str> = Vec::new();
        for row in cells.iter().flat_map(|cell| &cell.rows) {
            let name = block_name(row);
            if !names.contains(&name) {
                names.push(name);
            }
        }
        let mut offsets = vec![[0.0; 4]; names.len()];
        let mut pooled = [0.0; 4];
        let mut dof = 0;
        let common = self.sets == Sets::Common;
        // A common set finds the tip's zero of each block itself.
        for channel in (0..4).filter(|&c| self.channels[c] && !(common && c == TIP)) {
            let fit = BlockFit::new(cells, &names, channel);
            dof = fit.dof;
            pooled[channel] = if fit.dof > 0 { (fit.residual_squares / fit.dof as f64).sqrt() } else { 0.0 };
            let sigma = self.point_sigma.map_or(pooled[channel], |declared| declared[channel]);
            let (spread, shrunk) = fit.shrunk(sigma);
            self.block_sigma[channel] = spread;
            for (offset, value) in offsets.iter_mut().zip(shrunk) {
                offset[channel] = value;
            }
        }
        if self.point_sigma.is_none() && dof > 0 {
            self.point_sigma = Some(pooled);
            self.noise_dof = Some(dof);
        }
        self.block_names = names.iter().map(|&name| name.to_owned()).collect();
        self.airspeeds = if common {
            self.average(&split_by_block(cells, &names), &names, &offsets)
        } else {
            self.average(cells, &names, &offsets)
        };
        let others = self.average(others, &names, &offsets);
        if names.len() > 1 {
            self.blocks = names
                .iter()
                .zip(offsets)
                .map(|(name, offset)| BlockOffset { block: (*name).to_owned(), offset })
                .collect();
        }
        (self, others)
    }

    /// Means of the cells, block offsets taken out, by airspeed.
    fn average(&self, cells: &[Cell<'_>], names: &[&str], offsets: &[[f64; 4]]) -> Vec<AirspeedData> {
        let block_of = |row: &StaticPoint| names.iter().position(|name| *name == block_name(row));
        let offset_of =
            |row: &StaticPoint, channel: usize| block_of(row).map_or(0.0, |i| offsets[i][channel]);
        let mut airspeeds: Vec<(AirspeedData, usize)> = Vec::new();
        for cell in cells {
            let count = cell.rows.len();
            let mean = |channel: usize| {
                let value = |row: &&StaticPoint| row.reading(channel) - offset_of(row, channel);
                cell.rows.iter().map(value).sum::<f64>() / count as f64
            };
            let angle = Angle {
                alpha_rad: cell.alpha_rad,
                loads: [mean(0), mean(1), mean(2)],
                tip_z_m: mean(TIP),
                block: if self.sets == Sets::Common { block_of(cell.rows[0]).unwrap_or(0) } else { 0 },
                line: cell.rows.iter().map(|row| row.span.line).min().unwrap_or(0),
                replicates: count,
            };
            match airspeeds.last_mut() {
                Some((last, rows)) if same_airspeed(last.v_m_s, cell.v_m_s) => {
                    last.v_m_s =
                        (last.v_m_s * *rows as f64 + cell.v_m_s * count as f64) / (*rows + count) as f64;
                    *rows += count;
                    last.angles.push(angle);
                }
                _ => airspeeds.push((
                    AirspeedData { v_m_s: cell.v_m_s, angles: vec![angle], span: cell.rows[0].span.clone() },
                    count,
                )),
            }
        }
        airspeeds.into_iter().map(|(airspeed, _)| airspeed).collect()
    }
}

/// Rows that are fitted: wind on, controls neutral.
fn rows(campaign: &Campaign) -> Vec<&StaticPoint> {
    let fitted = |point: &&StaticPoint| point.v_m_s > 0.0 && point.controls_rad.is_empty();
    campaign.points.iter().filter(fitted).collect()
}

/// Cells of one block each, in the order of the cells, then of the blocks.
fn split_by_block<'a>(cells: &[Cell<'a>], names: &[&str]) -> Vec<Cell<'a>> {
    let mut split = Vec::new();
    for cell in cells {
        for name in names {
            let rows: Vec<&StaticPoint> =
                cell.rows.iter().copied().filter(|row| block_name(row) == *name).collect();
            let count = rows.len() as f64;
            if rows.is_empty() {
                continue;
            }
            split.push(Cell {
                v_m_s: rows.iter().map(|row| row.v_m_s).sum::<f64>() / count,
                alpha_rad: rows.iter().map(|row| row.alpha_rad).sum::<f64>() / count,
                rows,
            });
        }
    }
    split
}

pub(crate) fn block_name(row: &StaticPoint) -> &str {
    row.block.as_deref().unwrap_or("")
}

/// Groups rows by airspeed, then angle, both ascending.
fn cells<'a>(rows: &[&'a StaticPoint]) -> Vec<Cell<'a>> {
    let mut sorted = rows.to_vec();
    sorted.sort_by(|a, b| a.v_m_s.total_cmp(&b.v_m_s));
    let mut groups: Vec<Vec<&StaticPoint>> = Vec::new();
    for row in sorted {
        match groups.last_mut() {
            Some(group) if same_airspeed(group[0].v_m_s, row.v_m_s) => group.push(row),
            _ => groups.push(vec![row]),
        }
    }
    let mut cells: Vec<Cell<'a>> = Vec::new();
    for mut group in groups {
        group.sort_by(|a, b| a.alpha_rad.total_cmp(&b.alpha_rad));
        let first = cells.len();
        for row in group {
            match cells[first..].last_mut() {
                Some(cell) if same_angle(cell.rows[0].alpha_rad, row.alpha_rad) => {
                    cell.rows.push(row);
                }
                _ => cells.push(Cell { v_m_s: 0.0, alpha_rad: 0.0, rows: vec![row] }),
            }
        }
    }
    for cell in &mut cells {
        let count = cell.rows.len() as f64;
        cell.v_m_s = cell.rows.iter().map(|row| row.v_m_s).sum::<f64>() / count;
        cell.alpha_rad = cell.rows.iter().map(|row| row.alpha_rad).sum::<f64>() / count;
    }
    cells
}

/// A common set needs some rows: a zero, a slope, and something to compare them with.
fn check_rows(campaign: &Campaign, rows: usize) -> Result<(), InputError> {
    if rows >= 3 {
        return Ok(());
    }
    let place =
        campaign.points.first().map_or_else(|| Span::whole_file(&campaign.folder), |row| row.span.clone());
    Err(InputError::at(&place, format!("{rows} static cases with wind on and neutral controls"))
        .with_help("a common set of corrections needs at least three"))
}

/// Blocks are days and mountings: many of them are a column that means something else, such as a point's number.
fn check_blocks(rows: &[&StaticPoint]) -> Result<(), InputError> {
    let mut names = BTreeSet::new();
    match rows.iter().find(|row| names.insert(block_name(row)) && names.len() > MOST_BLOCKS) {
        None => Ok(()),
        Some(row) => {
            Err(InputError::at(&row.span, format!("the static cases have more than {MOST_BLOCKS} blocks"))
                .with_help("a block is a day or a mounting, and all its rows have the same name"))
        }
    }
}

/// No angle beyond 0.6 degrees, though they differ: a sweep in radians looks like this.
fn all_within_a_degree(campaign: &Campaign) -> bool {
    let angles = || campaign.points.iter().map(|point| point.alpha_rad.to_degrees());
    angles().all(|angle| angle.abs() < 0.6)
        && angles().any(|angle| angle != campaign.points[0].alpha_rad.to_degrees())
}

/// Every airspeed needs three angles: a line through two has no error to compare with.
fn check_angles(campaign: &Campaign, cells: &[Cell<'_>]) -> Result<(), InputError> {
    let mut counts: BTreeMap<usize, (usize, f64, Span)> = BTreeMap::new();
    let mut group = 0;
    for (index, cell) in cells.iter().enumerate() {
        if index > 0 && !same_airspeed(cells[index - 1].v_m_s, cell.v_m_s) {
            group += 1;
        }
        counts.entry(group).or_insert((0, cell.v_m_s, cell.rows[0].span.clone())).0 += 1;
    }
    if counts.is_empty() {
        let place = campaign
            .points
            .first()
            .map_or_else(|| Span::whole_file(&campaign.folder), |row| row.span.clone());
        return Err(InputError::at(
            &place,
            "the campaign has no static case with wind on and neutral controls",
        )
        .with_help("calibration needs at least three angles at one airspeed"));
    }
    for (angles, v_m_s, span) in counts.into_values() {
        if angles < 3 {
            return Err(InputError::at(
                &span,
                format!(
                    "the airspeed {v_m_s} m/s has {angles} different angle(s), at least three are needed"
                ),
            )
            .with_help(if all_within_a_degree(campaign) {
                "every alpha_deg is within 0.6: are the angles in radians instead of degrees?"
            } else {
                "add angles at this airspeed, take its rows out of the static cases, or ask for one set of \
                 corrections for all airspeeds (`sets: Common` in campaign.ron)"
            }));
        }
    }
    Ok(())
}
