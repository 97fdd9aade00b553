//! Cases dealt out to parts: every case to one part, by its content and its cost in a table alone, so that the shares are the same
//! whatever the order of the cases' file, the machine and the time of day.
//!
//! Cases are sorted by what they share and then by hash, and the row is cut into pieces of equal cost: an aircraft and a factorisation
//! that serve many cases are made again only where a cut goes through them (at most once a part), and what needs unsteady air is at the
//! end, so that as few parts as possible make that.

use crate::fingerprint::Fingerprint;
use crate::sweep::share::Share;

/// A case to be dealt out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Weighed {
    /// Fingerprint of what is assembled once for all such cases, an aircraft's state of loading.
    pub frame: Fingerprint,
    /// Whether it belongs to the end of the row: what it needs is made once for all such cases of a part.
    pub is_late: bool,
    /// Fingerprint of what it shares with other cases.
    pub group: Fingerprint,
    /// Fingerprint of the cases that are computed together or not at all; of a case alone its hash.
    pub unit: Fingerprint,
    /// The case's hash.
    pub hash: Fingerprint,
    /// Its cost beside the cheapest, from a table.
    pub cost: u64,
    /// Its number in the sweep.
    pub number: usize,
}

/// The cases of a share, sorted. A case that is there twice is dealt out once.
pub fn share_of(mut all: Vec<Weighed>, share: Share) -> Vec<Weighed> {
    all.sort_unstable();
    all.dedup_by_key(|case| case.hash);
    let total: u128 = all.iter().map(|case| u128::from(case.cost)).sum();
    let mut before = 0;
    let is_own = all.chunk_by(|a, b| a.unit == b.unit).flat_map(|unit| {
        // where the unit's middle lies in the row
        let cost: u128 = unit.iter().map(|case| u128::from(case.cost)).sum();
        let middle = 2 * before + cost;
        before += cost;
        let is_own = middle * share.of as u128 / (2 * total.max(1)) == share.number as u128 - 1;
        std::iter::repeat_n(is_own, unit.len())
    });
    let mut is_own = is_own.collect::<Vec<bool>>().into_iter();
    all.retain(|_| is_own.next() == Some(true));
    all.shrink_to_fit();
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    fn row() -> Vec<Weighed> {
        let print = |text: String| Fingerprint::default().with(text.as_bytes());
        let case = |number: usize| Weighed {
            frame: Fingerprint::default(),
            is_late: number.is_multiple_of(10),
            group: print(format!("group {}", number % 7)),
            unit: print(format!("case {number}")),
            hash: print(format!("case {number}")),
            cost: if number.is_multiple_of(10) { 40 } else { 1 },
            number,
        };
        (0..1000).map(case).collect()
    }

    #[test]
    fn every_case_is_in_one_part_and_parts_weigh_the_same_to_one_case() {
        for of in [1, 2, 7, 16] {
            let parts: Vec<Vec<Weighed>> =
                (1..=of).map(|number| share_of(row(), Share { number, of })).collect();
            let dealt: BTreeSet<usize> = parts.iter().flatten().map(|case| case.number).collect();
            assert_eq!(dealt.len(), 1000, "cases of {of} parts");
            assert_eq!(
                parts.iter().map(Vec::len).sum::<usize>(),
                1000,
                "cases dealt out twice to {of} parts"
            );
            let cost = |part: &Vec<Weighed>| part.iter().map(|case| case.cost).sum::<u64>();
            let (least, most) = (parts.iter().map(cost).min(), parts.iter().map(cost).max());
            assert!(most.unwrap_or(0) - least.unwrap_or(0) <= 80, "{of} parts weigh {least:?} to {most:?}");
        }
    }

    #[test]
    fn the_order_and_repetitions_of_cases_change_no_share() {
        let share = Share { number: 3, of: 7 };
        let mut turned = row();
        turned.reverse();
        turned.extend(row());
        let hashes = |all| share_of(all, share).into_iter().map(|case| case.hash).collect::<Vec<_>>();
        assert_eq!(hashes(turned), hashes(row()));
    }

    #[test]
    fn few_parts_hold_the_late_cases_and_more_parts_than_cases_are_no_fault() {
        let with_late = (1..=16)
            .filter(|&number| share_of(row(), Share { number, of: 4 * 4 }).iter().any(|case| case.is_late));
        // 900 cases of cost 1, then 100 of 40; a part has 306.25: the first late one's middle, 920, lies in the fourth
        assert_eq!(with_late.count(), 13);
        let few: Vec<Weighed> = row().into_iter().take(3).collect();
        let dealt: usize = (1..=50).map(|number| share_of(few.clone(), Share { number, of: 50 }).len()).sum();
        assert_eq!(dealt, 3);
    }

    #[test]
    fn cases_that_are_computed_together_are_in_one_part_and_an_aircraft_in_as_few_as_can_be() {
        let mut units = row();
        for case in &mut units {
            let print = |text: String| Fingerprint::default().with(text.as_bytes());
            case.frame = print(format!("loading {}", case.number % 2));
            case.unit = print(format!("{} {} {} {}", case.frame, case.is_late, case.group, case.number / 70));
        }
        let parts: Vec<Vec<Weighed>> =
            (1..=4).map(|number| share_of(units.clone(), Share { number, of: 4 })).collect();
        assert_eq!(parts.iter().map(Vec::len).sum::<usize>(), 1000);
        let with = |of: fn(&Weighed) -> Fingerprint, print: Fingerprint| {
            parts.iter().filter(|part| part.iter().any(|case| of(case) == print)).count()
        };
        assert!(units.iter().all(|case| with(|c| c.unit, case.unit) == 1), "a unit is in two parts");
        let frames: Vec<usize> = units.iter().take(2).map(|case| with(|c| c.frame, case.frame)).collect();
        assert_eq!(
            frames.iter().sum::<usize>(),
            5,
            "{frames:?}: of three cuts one is between the two aircraft"
        );
    }
}
