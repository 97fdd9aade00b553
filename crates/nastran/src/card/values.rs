//! Typed access to the fields of a card: numbers, names, components and what must not be there.

use super::Card;
use crate::motion::Motion;
use crate::real;
use crate::source::InputError;

impl Card {
    /// A name of at most 8 characters.
    pub(crate) fn name_at(&self, index: usize, what: &str) -> Result<String, InputError> {
        match self.text(index) {
            "" => Err(self.empty(index, what, "a name")),
            text if text.chars().count() <= 8 => Ok(text.to_uppercase()),
            text => Err(self.error(
                index,
                format!("`{text}` in field {what} of {} is longer than 8 characters", self.name),
            )),
        }
    }

    /// An identification number, at least 1.
    pub(crate) fn id(&self, index: usize, what: &str) -> Result<u32, InputError> {
        match self.text(index) {
            "" => Err(self.empty(index, what, "a positive whole number")),
            text => text.parse().ok().filter(|id| *id > 0).ok_or_else(|| {
                let is_long = text.len() > 9 && text.bytes().all(|byte| byte.is_ascii_digit());
                let most = format!("a positive whole number up to {}", u32::MAX);
                self.wrong(index, what, if is_long { &most } else { "a positive whole number" })
            }),
        }
    }

    /// A whole number that may be zero, or the default of an empty field.
    pub(crate) fn count_or(&self, index: usize, what: &str, default: u32) -> Result<u32, InputError> {
        match self.text(index) {
            "" => Ok(default),
            text => text.parse().map_err(|_| self.wrong(index, what, "a whole number, zero or more")),
        }
    }

    /// A whole number of either sign, or the default of an empty field.
    pub(crate) fn integer_or(&self, index: usize, what: &str, default: i32) -> Result<i32, InputError> {
        match self.text(index) {
            "" => Ok(default),
            text => text.parse().map_err(|_| self.wrong(index, what, "a whole number")),
        }
    }

    /// A real that must be there.
    pub(crate) fn real(&self, index: usize, what: &str) -> Result<f64, InputError> {
        self.optional_real(index, what)?.ok_or_else(|| self.empty(index, what, "a real number"))
    }

    /// A real, or the default of an empty field.
    pub(crate) fn real_or(&self, index: usize, what: &str, default: f64) -> Result<f64, InputError> {
        Ok(self.optional_real(index, what)?.unwrap_or(default))
    }

    /// A real, or nothing if the field is empty.
    pub(crate) fn optional_real(&self, index: usize, what: &str) -> Result<Option<f64>, InputError> {
        let text = self.text(index);
        if text.is_empty() {
            return Ok(None);
        }
        real::parse(text).map(Some).ok_or_else(|| {
            let error = self.wrong(index, what, "a real number");
            if text.parse::<i64>().is_ok() {
                error.with_help(format!("write `{text}.` with a decimal point"))
            } else {
                error
            }
        })
    }

    /// A point or vector of three reals in a row; empty ones are zero.
    pub(crate) fn vector<V: From<[f64; 3]>>(&self, index: usize, what: [&str; 3]) -> Result<V, InputError> {
        Ok(V::from([
            self.real_or(index, what[0], 0.0)?,
            self.real_or(index + 1, what[1], 0.0)?,
            self.real_or(index + 2, what[2], 0.0)?,
        ]))
    }

    /// Component digits 1 to 6 in ascending order, each once; empty or `0` gives none. Blanks between them say nothing.
    pub(crate) fn components(&self, index: usize, what: &str) -> Result<Vec<u8>, InputError> {
        let said = self.text(index).bytes().filter(|b| !matches!(b, b'0' | b' '));
        let mut digits: Vec<u8> = said.map(|b| b.wrapping_sub(b'0')).collect();
        digits.sort_unstable();
        let twice = digits.windows(2).any(|pair| pair[0] == pair[1]);
        if twice || digits.iter().any(|digit| !(1..=6).contains(digit)) {
            return Err(self.wrong(index, what, "a combination of the digits 1 to 6"));
        }
        Ok(digits)
    }

    /// A real above zero that must be there.
    pub(crate) fn positive(&self, index: usize, what: &str) -> Result<f64, InputError> {
        match self.real(index, what)? {
            value if value > 0.0 => Ok(value),
            _ => Err(self.wrong(index, what, "above zero")),
        }
    }

    /// A real, zero or more, or the default of an empty field.
    pub(crate) fn not_negative(&self, index: usize, what: &str, default: f64) -> Result<f64, InputError> {
        match self.real_or(index, what, default)? {
            value if value >= 0.0 => Ok(value),
            _ => Err(self.wrong(index, what, "zero or more")),
        }
    }

    /// An identification number, or the default of an empty field.
    pub(crate) fn id_or(&self, index: usize, what: &str, default: u32) -> Result<u32, InputError> {
        if self.text(index).is_empty() { Ok(default) } else { self.id(index, what) }
    }

    /// An identification number, or nothing if the field is empty.
    pub(crate) fn optional_id(&self, index: usize, what: &str) -> Result<Option<u32>, InputError> {
        if self.text(index).is_empty() { Ok(None) } else { self.id(index, what).map(Some) }
    }

    /// Component digits, at least one.
    pub(crate) fn some_components(&self, index: usize, what: &str) -> Result<Vec<u8>, InputError> {
        let digits = self.components(index, what)?;
        if self.text(index).is_empty() {
            return Err(self.empty(index, what, "a combination of the digits 1 to 6"));
        }
        if digits.is_empty() {
            return Err(self.wrong(index, what, "a combination of the digits 1 to 6"));
        }
        Ok(digits)
    }

    /// A grid and one component digit in the next field; 0 or nothing there means a scalar point.
    pub(crate) fn motion(&self, index: usize, grid: &str, digit: &str) -> Result<Motion, InputError> {
        let id = self.id(index, grid)?;
        match self.components(index + 1, digit)?.as_slice() {
            [one] => Ok((id, *one)),
            [] => Ok((id, 0)),
            _ => Err(self.wrong(index + 1, digit, "one digit from 1 to 6")),
        }
    }

    /// Grids in a row, each once.
    pub(crate) fn corners(&self, from: usize, names: &[&str]) -> Result<Vec<u32>, InputError> {
        let mut grids = Vec::with_capacity(names.len());
        for (index, name) in (from..).zip(names) {
            let grid = self.id(index, name)?;
            if grids.contains(&grid) {
                let message = format!("grid {grid} stands twice in {} {}", self.name, self.text(0));
                return Err(self.error(index, message).with_help("every corner has its own grid"));
            }
            grids.push(grid);
        }
        Ok(grids)
    }

    /// Demands that the card has no fields behind the first `count`.
    pub(crate) fn ends_after(&self, count: usize) -> Result<(), InputError> {
        if self.len() <= count {
            return Ok(());
        }
        let surplus = (count..self.len()).find(|index| !self.text(*index).is_empty()).unwrap_or(count);
        let message = format!("`{}` stands behind the last field of {}", self.text(surplus), self.name);
        Err(self.error(surplus, message).with_help(format!("the card has at most {count} fields")))
    }

    /// Demands that a field is empty or zero, because what it asks for is not read.
    pub(crate) fn unset(&self, index: usize, what: &str) -> Result<(), InputError> {
        let text = self.text(index);
        if text.is_empty() || text == "0" || real::parse(text) == Some(0.0) {
            return Ok(());
        }
        Err(self
            .error(index, format!("field {what} of {} is not read, but has `{text}`", self.name))
            .with_help("leave it empty, or zero"))
    }

    /// Demands that a field is empty or one of the words given.
    pub(crate) fn word(&self, index: usize, what: &str, words: &[&str]) -> Result<(), InputError> {
        let text = self.text(index);
        if text.is_empty() || words.iter().any(|word| text.eq_ignore_ascii_case(word)) {
            return Ok(());
        }
        Err(self.wrong(index, what, &format!("empty or {}, the only ones that are read", words.join(", "))))
    }

    /// PARAM: name and value (of AUTOSPC 1 for YES and 0 for NO); nothing if the value is no number, or complex.
    pub(crate) fn parameter(&self) -> Result<Option<(String, f64)>, InputError> {
        let name = self.name_at(0, "N")?;
        let text = self.text(1);
        if text.is_empty() {
            return Err(self.empty(1, "V1", "a value"));
        }
        // Kept as a number, as the others are.
        let is_switch = name == "AUTOSPC" && ["YES", "NO"].iter().any(|word| text.eq_ignore_ascii_case(word));
        if is_switch {
            return Ok(Some((name, f64::from(u8::from(text.eq_ignore_ascii_case("YES"))))));
        }
        let whole = text.parse::<i32>().ok().map(f64::from);
        let Some(value) = whole.or_else(|| real::parse(text)) else {
            if text.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c)) {
                return Err(self.wrong(1, "V1", "a number or a word"));
            }
            return Ok(None);
        };
        if name == "WTMASS" && (value <= 0.0 || whole.is_some()) {
            return Err(self.wrong(1, "V1", "a real number above zero, as WTMASS must be"));
        }
        Ok(self.text(2).is_empty().then_some((name, value)))
    }
}
