//! Are there rows enough? What static cases must have before anything is fitted to them.

use super::cells::{Cell, block_name};
use crate::campaign::{Campaign, StaticPoint};
use aero::flow::same_airspeed;
use nastran::{InputError, Span};
use std::collections::{BTreeMap, BTreeSet};

/// The most blocks: each has an offset, and all are found together.
const MOST_BLOCKS: usize = 200;

/// A common set needs some rows: a zero, a slope, and something to compare them with.
pub(super) fn check_rows(campaign: &Campaign, rows: usize) -> Result<(), InputError> {
    if rows >= 3 {
        return Ok(());
    }
    let place =
        campaign.points.first().map_or_else(|| Span::whole_file(&campaign.folder), |row| row.span.clone());
    Err(InputError::at(&place, format!("{rows} static cases with wind on and neutral controls"))
        .with_help("a common set of corrections needs at least three"))
}

/// Blocks are days and mountings: many of them are a column that means something else, such as a point's number.
pub(super) fn check_blocks(rows: &[&StaticPoint]) -> Result<(), InputError> {
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
pub(super) fn check_angles(campaign: &Campaign, cells: &[Cell<'_>]) -> Result<(), InputError> {
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
