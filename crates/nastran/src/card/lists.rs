//! Lists of identification numbers in the fields of a card.

use super::Card;
use crate::source::InputError;

/// The longest list that `THRU` may stand for: a slip in a number must not fill the memory.
const LONGEST_RANGE: u32 = 1_000_000;

/// How many numbers the `THRU` of a card stand for, whatever its kind; ranges that the card itself refuses do not count.
pub(crate) fn numbers_in_ranges(card: &Card) -> usize {
    let number = |index: usize| card.text(index).parse::<u32>().ok();
    (1..card.len())
        .filter(|&index| card.text(index).eq_ignore_ascii_case("THRU"))
        .filter_map(|index| Some(number(index + 1)?.saturating_sub(number(index - 1)?) as usize))
        .filter(|&count| count <= LONGEST_RANGE as usize)
        .fold(0, usize::saturating_add)
}

impl Card {
    /// The numbers from a field to the end of the card, `THRU` expanded; at least one.
    pub(crate) fn id_list(&self, from: usize, what: &str) -> Result<Vec<u32>, InputError> {
        self.id_list_until(from, self.len(), what)
    }

    /// As [`Card::id_list`], up to a field.
    pub(crate) fn id_list_until(&self, from: usize, end: usize, what: &str) -> Result<Vec<u32>, InputError> {
        let mut ids: Vec<u32> = Vec::new();
        let mut index = from;
        while index < end {
            if self.text(index).eq_ignore_ascii_case("THRU") {
                let first = *ids.last().ok_or_else(|| self.wrong(index, what, "a positive whole number"))?;
                let last = self.id(index + 1, what)?;
                if last < first || last - first > LONGEST_RANGE {
                    return Err(self
                        .error(index + 1, format!("{first} THRU {last} is not a range that can be meant")));
                }
                ids.extend(first + 1..=last);
                index += 1;
            } else if !self.text(index).is_empty() {
                ids.push(self.id(index, what)?);
            }
            index += 1;
        }
        if ids.is_empty() { Err(self.empty(from, what, "at least one number")) } else { Ok(ids) }
    }
}
