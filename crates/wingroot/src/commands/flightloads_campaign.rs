//! Points of `flightloads` from wind-tunnel campaigns: static cases, of which every so many angles fit the corrections.

use std::collections::BTreeMap;

use calibrate::Campaign;
use calibrate::statics::{AirspeedData, StaticData};
use loads::FlightFile;
use loads::flight::{Channel, Reading, Source, State};
use loads::select::file::Load;
use nastran::InputError;

use crate::failure::Failure;

/// The static cases of a campaign as points.
pub(super) struct CampaignPoints {
    /// The condition they are of.
    pub(super) condition: String,
    /// Readings with wind on and neutral controls, less the offsets of their blocks.
    pub(super) readings: Vec<Reading>,
    /// What fits the corrections, if anything does.
    pub(super) fitted: Option<Campaign>,
    /// Density of the air.
    pub(super) rho_kg_m3: f64,
    /// Rows with deflected controls, which are not compared.
    pub(super) left_out: usize,
}

impl CampaignPoints {
    /// Those of a file.
    pub(super) fn all(file: &FlightFile) -> Result<Vec<Self>, Failure> {
        let mut all = Vec::new();
        for condition in file.conditions()? {
            if let Source::Campaign(folder, every) = &condition.source {
                let folder = file.path.parent().unwrap_or_else(|| std::path::Path::new("")).join(folder);
                let campaign = Campaign::read(&folder)?;
                all.push(Self::of(condition.name.clone(), &campaign, *every, &file.channels())?);
            }
        }
        Ok(all)
    }

    fn of(
        condition: String,
        campaign: &Campaign,
        every: Option<usize>,
        channels: &[Channel],
    ) -> Result<Self, Failure> {
        let data = StaticData::from_campaign(campaign)?;
        let is_fitted = |v_m_s: f64, alpha_rad: f64| {
            every.is_some_and(|every| angle_of(&data.airspeeds, v_m_s, alpha_rad).is_multiple_of(every))
        };
        let kept = every.map(|_| {
            let mut kept = campaign.clone();
            kept.points.retain(|point| point.v_m_s == 0.0 || is_fitted(point.v_m_s, point.alpha_rad));
            kept
        });
        // Offsets of blocks are those of the points that fit, so that nothing of the others is used.
        let offsets = match &kept {
            Some(kept) => StaticData::from_campaign(kept)?.blocks,
            None => data.blocks.clone(),
        };
        let wind = campaign.points.iter().filter(|point| point.v_m_s > 0.0);
        let mut readings = Vec::new();
        let mut left_out = 0;
        for point in wind {
            if !point.controls_rad.is_empty() {
                left_out += 1;
                continue;
            }
            let block = offsets.iter().find(|offset| Some(&offset.block) == point.block.as_ref());
            let measured = channels
                .iter()
                .map(|channel| {
                    let at = root_load(channel).filter(|at| campaign.channels[*at]);
                    let at = at.ok_or_else(|| not_measured(campaign, channel))?;
                    Ok(point.loads[at].map(|load| load - block.map_or(0.0, |block| block.offset[at])))
                })
                .collect::<Result<Vec<_>, InputError>>()?;
            readings.push(Reading {
                place: point.span.clone(),
                state: Some(State {
                    v_m_s: point.v_m_s,
                    alpha_deg: point.alpha_rad.to_degrees(),
                    controls_deg: BTreeMap::new(),
                }),
                v_m_s: Some(point.v_m_s),
                n_z: None,
                measured,
                calculated: [None, None],
                fitted: is_fitted(point.v_m_s, point.alpha_rad),
            });
        }
        Ok(Self { condition, readings, fitted: kept, rho_kg_m3: campaign.rho_kg_m3, left_out })
    }
}

/// Which of Fz, Mx and My of the balance a channel is.
pub(super) fn root_load(channel: &Channel) -> Option<usize> {
    let place = [Load::Fz, Load::Mx, Load::My].iter().position(|load| *load == channel.load);
    place.filter(|_| channel.station == "root")
}

fn not_measured(campaign: &Campaign, channel: &Channel) -> InputError {
    let message = format!("the campaign has no {} of station {}", channel.load.name(), channel.station);
    InputError::in_file(&campaign.path, message).with_help("a campaign has Fz, Mx and My of station root")
}

/// Which angle of its airspeed a row is, by the nearest.
fn angle_of(airspeeds: &[AirspeedData], v_m_s: f64, alpha_rad: f64) -> usize {
    let nearest = |distances: &mut dyn Iterator<Item = f64>| {
        let best = distances.enumerate().min_by(|a, b| a.1.total_cmp(&b.1));
        best.map_or(0, |(place, _)| place)
    };
    let airspeed = nearest(&mut airspeeds.iter().map(|data| (data.v_m_s - v_m_s).abs()));
    // One angle may stand there once a block.
    let mut angles: Vec<f64> = Vec::new();
    for angle in airspeeds.get(airspeed).map_or(&[][..], |data| &data.angles[..]) {
        if angles.last().is_none_or(|last| (angle.alpha_rad - last).abs() > SAME_RAD) {
            angles.push(angle.alpha_rad);
        }
    }
    nearest(&mut angles.iter().map(|angle| (angle - alpha_rad).abs()))
}

/// Angles of different blocks that are this near are the same, rad.
const SAME_RAD: f64 = 2e-3;
