//! CSV tables with a header line: cells by column name, and errors that name the cell.
//!
//! Cells are separated by commas and may be quoted (`"a, b"`, `""` for a quote inside); a cell stays on its
//! line. Blank lines and lines starting with `#` are skipped. The lines are cut here and not by the `csv`
//! crate because every cell must know its columns.

use crate::source::{InputError, Span, read_text};
use crate::suggest::nearest;
use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A table in memory. Rows are counted from zero, without header and comments.
#[derive(Debug, Clone)]
pub struct Table {
    file: Arc<PathBuf>,
    header: Vec<Cell>,
    rows: Vec<Vec<Cell>>,
}

#[derive(Debug, Clone)]
struct Cell {
    text: String,
    span: Span,
}

impl Table {
    /// Reads a CSV file.
    ///
    /// # Errors
    /// If the file cannot be read, has no header, or a row's cells do not match the header's.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        Self::parse_at(path, &read_text(path)?)
    }

    /// Parses CSV text; `name` is the file name that errors give.
    ///
    /// # Errors
    /// If there is no header, a column name is empty or occurs twice, or a row's cells do not match the header's.
    pub fn parse(name: &str, text: &str) -> Result<Self, InputError> {
        Self::parse_at(Path::new(name), text)
    }

    fn parse_at(path: &Path, text: &str) -> Result<Self, InputError> {
        let file = Arc::new(path.to_path_buf());
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut lines = Vec::new();
        for (index, line) in text.lines().enumerate() {
            let start = line.trim_start();
            if !start.is_empty() && !start.starts_with('#') {
                lines.push(split(&file, index + 1, line)?);
            }
        }
        let mut lines = lines.into_iter();
        let header = lines.next().ok_or_else(|| {
            InputError::in_file(path, "the table is empty").with_help("the first line must name the columns")
        })?;
        check_header(&header)?;
        let rows: Vec<Vec<Cell>> = lines.collect();
        for row in &rows {
            check_row(row, &header)?;
        }
        Ok(Self { file, header, rows })
    }

    /// The column names, in the file's order.
    pub fn columns(&self) -> impl Iterator<Item = &str> {
        self.header.iter().map(|cell| cell.text.as_str())
    }

    /// The number of rows.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// True if there is a header and nothing else.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// True if there is a column of this name.
    pub fn has(&self, column: &str) -> bool {
        self.columns().any(|name| name == column)
    }

    /// Demands that these columns exist.
    ///
    /// # Errors
    /// If one is missing, with the column that was probably meant.
    pub fn require(&self, columns: &[&str]) -> Result<(), InputError> {
        columns.iter().try_for_each(|column| self.index(column).map(|_| ()))
    }

    /// Refuses columns that `known` does not accept; `expected` says what may stand there, for instance
    /// `"V_m_s, alpha_deg"` (separated by commas, so that a misspelt name finds its neighbour).
    ///
    /// # Errors
    /// If a column is not accepted.
    pub fn allow_only(&self, known: impl Fn(&str) -> bool, expected: &str) -> Result<(), InputError> {
        for cell in &self.header {
            if !known(&cell.text) {
                let error = InputError::at(
                    &cell.span,
                    format!("unknown column `{}`; expected {expected}", cell.text),
                );
                let words = expected.split([',', ' ']).map(|word| word.trim_matches('`'));
                return Err(match nearest(&cell.text, words.filter(|word| !word.is_empty())) {
                    Some(name) => error.with_help(format!("did you mean `{name}`?")),
                    None => error,
                });
            }
        }
        Ok(())
    }

    /// The number in a cell.
    ///
    /// # Errors
    /// If the row or column does not exist, or the cell is empty, not a number or not finite.
    pub fn number(&self, row: usize, column: &str) -> Result<f64, InputError> {
        let cell = self.cell(row, column)?;
        if cell.text.is_empty() {
            return Err(InputError::at(
                &cell.span,
                format!("column `{column}` is empty here; expected a number"),
            )
            .with_help("fill the cell, or take the row out"));
        }
        match cell.text.parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(value),
            _ => Err(InputError::at(
                &cell.span,
                format!("`{}` in column `{column}` is not a finite number", cell.text),
            )
            .with_help("write a number such as 1.5 or -2e-3, or take the row out")),
        }
    }

    /// The text of a cell, without surrounding blanks; it may be empty.
    ///
    /// # Errors
    /// If the row or column does not exist.
    pub fn text(&self, row: usize, column: &str) -> Result<&str, InputError> {
        Ok(&self.cell(row, column)?.text)
    }

    /// All numbers of a column.
    ///
    /// # Errors
    /// As [`Table::number`].
    pub fn numbers(&self, column: &str) -> Result<Vec<f64>, InputError> {
        self.index(column)?;
        (0..self.len()).map(|row| self.number(row, column)).collect()
    }

    /// Where a cell stands; the whole file if there is no such cell.
    pub fn span(&self, row: usize, column: &str) -> Span {
        self.cell(row, column).map_or_else(|_| Span::whole_file(&self.file), |cell| cell.span.clone())
    }

    fn cell(&self, row: usize, column: &str) -> Result<&Cell, InputError> {
        let index = self.index(column)?;
        let cells = self.rows.get(row).ok_or_else(|| {
            let message = format!("the table has {} rows; row {} is wanted", self.rows.len(), row + 1);
            InputError::in_file(&self.file, message)
        })?;
        Ok(&cells[index])
    }

    fn index(&self, column: &str) -> Result<usize, InputError> {
        self.header.iter().position(|cell| cell.text == column).ok_or_else(|| {
            let error =
                InputError::at(&whole_line(&self.header), format!("the column `{column}` is missing"));
            match nearest(column, self.columns()) {
                Some(name) => error.with_help(format!("is `{name}` meant to be `{column}`?")),
                None => error.with_help(format!(
                    "the columns here are {}",
                    self.columns().collect::<Vec<_>>().join(", ")
                )),
            }
        })
    }
}

fn whole_line(cells: &[Cell]) -> Span {
    let mut span = cells[0].span.clone();
    (span.column, span.end_column) = (0, 0);
    span
}

fn check_header(header: &[Cell]) -> Result<(), InputError> {
    let mut names = HashSet::new();
    for cell in header {
        if cell.text.is_empty() {
            return Err(InputError::at(&cell.span, "this column has no name"));
        }
        if !names.insert(&cell.text) {
            return Err(InputError::at(&cell.span, format!("the column `{}` occurs twice", cell.text)));
        }
    }
    Ok(())
}

fn check_row(row: &[Cell], header: &[Cell]) -> Result<(), InputError> {
    if row.len() == header.len() {
        return Ok(());
    }
    let message = format!("this row has {} cells, the header has {}", row.len(), header.len());
    Err(InputError::at(&whole_line(row), message).with_help("empty cells still need their commas"))
}

/// Cuts a line into cells; at least one.
fn split(file: &Arc<PathBuf>, line: usize, text: &str) -> Result<Vec<Cell>, InputError> {
    let characters: Vec<char> = text.chars().collect();
    let mut cells = Vec::new();
    let mut start = 0;
    let mut quoted = false;
    for position in 0..=characters.len() {
        let at_end = position == characters.len();
        if !at_end && characters[position] == '"' {
            quoted = !quoted;
        }
        if at_end || (characters[position] == ',' && !quoted) {
            cells.push(cell(file, line, &characters, start..position));
            start = position + 1;
        }
    }
    if quoted {
        let last = &cells[cells.len() - 1].span;
        return Err(
            InputError::at(last, "a quoted cell does not end on its line").with_help("add the closing \"")
        );
    }
    Ok(cells)
}

fn cell(file: &Arc<PathBuf>, line: usize, characters: &[char], range: std::ops::Range<usize>) -> Cell {
    let raw = &characters[range.clone()];
    let blanks = raw.iter().take_while(|c| c.is_whitespace()).count();
    let trimmed: String = raw.iter().collect::<String>().trim().to_owned();
    let column = if trimmed.is_empty() { range.start } else { range.start + blanks } + 1;
    let width = trimmed.chars().count().max(1);
    let text = match trimmed.strip_prefix('"').and_then(|rest| rest.strip_suffix('"')) {
        Some(inner) => inner.replace("\"\"", "\""),
        None => trimmed,
    };
    Cell { text, span: Span::new(file, line, column, column + width) }
}
