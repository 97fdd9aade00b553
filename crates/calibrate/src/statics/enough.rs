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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::statics::cells::cells;
    use crate::tests::{campaign, point};

    fn rows(all: &[(f64, f64)]) -> Campaign {
        campaign(
            all.iter().enumerate().map(|(i, &(v, alpha))| point(i + 2, v, alpha, [0.0; 4])).collect(),
            None,
        )
    }

    #[test]
    fn blocks_are_two_hundred_at_most() {
        let of = |count: usize| {
            let mut all = rows(&vec![(10.0, 0.0); 2 * count]);
            for (i, point) in all.points.iter_mut().enumerate() {
                point.block = Some(format!("day {}", i / 2));
            }
            check_blocks(&all.points.iter().collect::<Vec<_>>())
        };
        assert!(of(200).is_ok());
        let refused = of(201).expect_err("one too many");
        assert!(refused.to_string().contains("more than 200 blocks"), "{refused}");
        assert_eq!(refused.span.map(|span| span.line), Some(402));
    }

    #[test]
    fn a_common_set_needs_three_rows() {
        let all = rows(&[(10.0, 0.0); 3]);
        assert!(check_rows(&all, 3).is_ok() && check_rows(&all, 4).is_ok());
        let refused = check_rows(&all, 2).expect_err("two");
        assert!(refused.to_string().contains("2 static cases"), "{refused}");
        assert!(check_rows(&rows(&[]), 0).is_err());
    }

    fn checked(all: &[(f64, f64)]) -> Result<(), InputError> {
        let campaign = rows(all);
        check_angles(&campaign, &cells(&campaign.points.iter().collect::<Vec<_>>()))
    }

    #[test]
    fn every_airspeed_needs_three_angles() {
        let three = |v: f64| [(v, 0.0), (v, 0.1), (v, 0.2)];
        assert!(checked(&[three(10.0), three(20.0)].concat()).is_ok());
        let refused =
            checked(&[&three(10.0)[..], &three(20.0)[..2], &three(30.0)].concat()).expect_err("two");
        assert!(refused.to_string().contains("20 m/s has 2 different angle(s)"), "{refused}");
        assert_eq!(refused.span.as_ref().map(|span| span.line), Some(5));
        assert!(format!("{refused:?}").contains("sets: Common"), "{refused:?}");
        // an angle twice is one
        assert!(checked(&[(10.0, 0.0), (10.0, 0.0), (10.0, 0.1)]).is_err());
        assert!(checked(&[]).expect_err("none").to_string().contains("no static case with wind on"));
    }

    #[test]
    fn angles_that_differ_within_six_tenths_of_a_degree_may_be_radians() {
        let hint = |alphas_deg: [f64; 2]| {
            let refused =
                checked(&alphas_deg.map(|alpha_deg| (10.0, alpha_deg.to_radians()))).expect_err("two");
            format!("{refused:?}").contains("in radians instead of degrees")
        };
        assert!(hint([-0.1, 0.5]) && !hint([0.1, 0.61]) && !hint([-0.61, 0.1]) && !hint([0.3, 0.3]));
    }
}
