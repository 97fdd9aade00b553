//! From rows of static cases to what is fitted: means per airspeed and angle, block offsets taken out.
//!
//! The model of a row is `cell mean + offset of its block + noise`, one offset a block and channel, common to all
//! airspeeds. Offsets are random effects that sum to zero: estimated jointly from the cells that several blocks
//! share, then shrunk by the share of their spread that noise explains. An offset common to all blocks cannot be
//! told from a pressure offset and stays in the data.
//!
//! With one set of corrections for all airspeeds (`Sets::Common`), means are kept apart by block, as each block has a
//! zero of the tip reading of its own, which the fit finds.

pub(crate) mod cells;
mod enough;

use self::cells::{Cell, block_name, cells, split_by_block};
use self::enough::{check_angles, check_blocks, check_rows};
use crate::blocks::BlockFit;
use crate::campaign::{Campaign, Sets, StaticPoint, TIP, TipReading};
use crate::sensors::Sensor;
use aero::flow::same_airspeed;
use coupling::ByLoad;
use nastran::{InputError, Span};

/// One angle at one airspeed: the mean of its replicates after block offsets are removed.
#[derive(Debug, Clone, PartialEq)]
pub struct Angle {
    /// Mean angle of attack, rad.
    pub alpha_rad: f64,
    /// Mean Fz, Mx, My; meaningless where the campaign lacks the channel.
    pub loads: ByLoad<f64>,
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
        let ByLoad { fz, mx, my } = self.loads;
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
    /// Rows that say more than the means of the angles: with a control deflected, with a sensor read, or under a dead weight.
    pub further: Vec<StaticPoint>,
}

impl StaticData {
    /// Groups a campaign's rows, estimates and removes block offsets, and the noise.
    ///
    /// # Errors
    /// If there is no airspeed, or an airspeed has fewer than three different angles.
    pub fn from_campaign(campaign: &Campaign) -> Result<Self, InputError> {
        let fitted = rows(campaign);
        let weight_tares: Vec<StaticPoint> =
            campaign.points.iter().filter(|p| p.is_tare(&campaign.sensors)).cloned().collect();
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
            further: campaign.points.iter().filter(|p| p.says_more(&campaign.sensors)).cloned().collect(),
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
                loads: ByLoad::from_fn(|load| mean(load as usize)),
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

#[cfg(test)]
mod tests;
