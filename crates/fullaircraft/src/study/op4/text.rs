//! OP4 files in ASCII: heads of eight columns a number (sixteen where the head ends in `|I16`), reals as the head's format says, side by
//! side without blanks.

use super::records::{Head, Records};
use nastran::{InputError, Span};
use std::iter::Enumerate;
use std::path::{Path, PathBuf};
use std::str::Lines;
use std::sync::Arc;

/// Reals of a line and columns of a real where the head has no format (5E16.9).
const USUAL: (usize, usize) = (5, 16);
/// Columns of a real that a format may give.
const WIDEST: usize = 64;

/// A text being read.
pub(super) struct Text<'a> {
    file: Arc<PathBuf>,
    lines: Enumerate<Lines<'a>>,
    /// The line that was read last, counted from one.
    at: usize,
    format: (usize, usize),
}

impl<'a> Text<'a> {
    /// A text from its beginning; `path` is named in errors.
    pub(super) fn new(path: &Path, text: &'a str) -> Self {
        Self { file: Arc::new(path.to_path_buf()), lines: text.lines().enumerate(), at: 1, format: USUAL }
    }

    fn line(&mut self, expected: &str) -> Result<&'a str, InputError> {
        let Some((index, line)) = self.lines.next() else {
            return Err(self.wrong(format!("the file ends where {expected} is expected")));
        };
        self.at = index + 1;
        Ok(line)
    }

    /// A line of whole numbers.
    fn wholes<const N: usize>(&mut self, expected: &str) -> Result<[i64; N], InputError> {
        let line = self.line(expected)?;
        let numbers: Option<Vec<i64>> = line.split_whitespace().map(|word| word.parse().ok()).collect();
        let numbers = numbers.and_then(|all| <[i64; N]>::try_from(all).ok());
        numbers.ok_or_else(|| self.wrong(format!("`{line}` where {expected} is expected")))
    }
}

/// The head of a line, and its format.
fn head(line: &str) -> Option<(Head, (usize, usize))> {
    let (line, width) = match line.trim_end().strip_suffix("|I16") {
        Some(line) => (line, 16),
        None => (line.trim_end(), 8),
    };
    let number = |i: usize| line.get(i * width..(i + 1) * width)?.trim().parse::<i64>().ok();
    let numbers = [number(0)?, number(1)?, number(2)?, number(3)?];
    let rest = line.get(4 * width..)?;
    let (name, format) = rest.split_at_checked(8).unwrap_or((rest, ""));
    let format = if format.trim().is_empty() { USUAL } else { reals_of(format)? };
    Some((Head::new(numbers, name)?, format))
}

/// Reals of a line and columns of each, of a format such as 1P,3E23.16.
fn reals_of(format: &str) -> Option<(usize, usize)> {
    let format = format.trim().to_ascii_uppercase();
    let format = format.trim_start_matches('(').trim_start_matches("1P").trim_start_matches(',');
    let (count, width) = format.split_once(['E', 'D'])?;
    let width = width.split_once('.')?.0.parse().ok()?;
    let count = count.trim().parse().ok()?;
    ((1..=WIDEST).contains(&width) && (1..=WIDEST).contains(&count)).then_some((count, width))
}

impl Records for Text<'_> {
    fn head(&mut self) -> Result<Option<Head>, InputError> {
        let Some((index, line)) = self.lines.find(|(_, line)| !line.trim().is_empty()) else {
            return Ok(None);
        };
        self.at = index + 1;
        let Some((head, format)) = head(line) else {
            return Err(self.wrong(format!("`{line}` is no head of a matrix")));
        };
        self.format = format;
        Ok(Some(head))
    }

    fn column(&mut self) -> Result<[i64; 3], InputError> {
        self.wholes("a column with its first row and length")
    }

    fn whole(&mut self, count: usize) -> Result<[i64; 2], InputError> {
        if count == 2 {
            return self.wholes("a string with its length and first row");
        }
        let [both] = self.wholes("a string with its length and first row in one")?;
        Ok([both, 0])
    }

    fn reals(&mut self, count: u64) -> Result<Vec<f64>, InputError> {
        let (a_line, width) = self.format;
        let mut all = Vec::new();
        while (all.len() as u64) < count {
            let line = self.line("a line of reals")?;
            let left = usize::try_from(count - all.len() as u64).unwrap_or(usize::MAX);
            for i in 0..a_line.min(left) {
                let text = line.get(i * width..line.len().min((i + 1) * width)).unwrap_or_default();
                let value = nastran::real::parse(text);
                let wrong =
                    || format!("`{}` where a real number of {width} columns is expected", text.trim());
                all.push(value.ok_or_else(|| self.wrong(wrong()))?);
            }
        }
        Ok(all)
    }

    fn end(&mut self) -> Result<(), InputError> {
        Ok(())
    }

    /// One number, whatever it is; files may end before it.
    fn skip(&mut self) -> Result<(), InputError> {
        self.lines.next();
        Ok(())
    }

    fn words_of_double(&self) -> [u64; 2] {
        [1, 2]
    }

    fn wrong(&self, message: String) -> InputError {
        InputError::at(&Span::new(&self.file, self.at, 1, 2), message)
            .with_help("expected the ASCII format of Nastran's OUTPUT4")
    }
}
