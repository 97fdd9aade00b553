//! CSV tables with a header line: cells by column name, and errors that name the cell.
//!
//! Cells are separated by commas, or, if the header has them, by tabs or semicolons; then numbers may have decimal
//! commas. Cells may be quoted (`"a, b"`, `""` for a quote inside) and stay on their line. Blank lines, lines starting
//! with `#`, and a first line such as `sep=;` are skipped. The lines are cut here and not by the `csv` crate because every
//! cell must know its columns. Encodings are `text_file`'s business.

mod cells;
mod headers;

use crate::memory;
use crate::source::{InputError, Span};
use crate::text_file::read_text;
use cells::{Cell, decimal, is_decimal_comma, is_separator_line, separator, split};
use headers::meant;
use std::collections::{BTreeMap, HashSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What a cell takes in memory, bytes: its text and its place.
const MEMORY_A_CELL: f64 = 100.0;

/// A table in memory. Rows are counted from zero, without header and comments.
#[derive(Debug, Clone)]
pub struct Table {
    file: Arc<PathBuf>,
    header: Vec<Cell>,
    rows: Vec<Vec<Cell>>,
    /// What the file calls columns, by the name they have here.
    theirs: ColumnNames,
    /// The first number with a decimal comma: then a point could only part thousands.
    comma: Option<Span>,
}

/// What a file calls columns that have another name here: our name to theirs.
pub type ColumnNames = BTreeMap<String, String>;

impl Table {
    /// Reads a CSV file.
    ///
    /// # Errors
    /// If the file cannot be read, has no header, or a row's cells do not match the header's.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        Self::read_named(path, &ColumnNames::new())
    }

    /// Reads a CSV file in which some columns have other names.
    ///
    /// # Errors
    /// As [`Table::read`].
    pub fn read_named(path: &Path, theirs: &ColumnNames) -> Result<Self, InputError> {
        Self::parse_at(path, &read_text(path)?, theirs)
    }

    /// Parses CSV text; `name` is the file name that errors give.
    ///
    /// # Errors
    /// If there is no header, a column name is empty or occurs twice, or a row's cells do not match the header's.
    pub fn parse(name: &str, text: &str) -> Result<Self, InputError> {
        Self::parse_at(Path::new(name), text, &ColumnNames::new())
    }

    fn parse_at(path: &Path, text: &str, theirs: &ColumnNames) -> Result<Self, InputError> {
        let file = Arc::new(path.to_path_buf());
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let lines = text.lines().enumerate().filter(|(index, line)| {
            let start = line.trim_start();
            !(start.is_empty() || start.starts_with('#') || *index == 0 && is_separator_line(line))
        });
        let mut lines = lines.map(|(index, line)| (index + 1, line));
        let (number, first) = lines.next().ok_or_else(|| {
            InputError::in_file(path, "the table is empty").with_help("the first line must name the columns")
        })?;
        let between = separator(first);
        let cells = text.chars().filter(|&c| c == between || c == '\n').count();
        memory::demand(&format!("the {cells} cells of this table"), MEMORY_A_CELL * cells as f64).map_err(
            |error| {
                InputError::in_file(path, error.message).with_help("split it, or keep what is needed of it")
            },
        )?;
        let mut header = split(&file, number, first, between)?;
        for (ours, name) in theirs {
            for cell in header.iter_mut().filter(|cell| cell.text == *name) {
                cell.text.clone_from(ours);
            }
        }
        check_header(&header)?;
        let mut rows = Vec::new();
        for (number, line) in lines {
            let row = split(&file, number, line, between)?;
            check_row(&row, &header)?;
            rows.push(row);
        }
        let comma = if between == ',' {
            None
        } else {
            rows.iter().flatten().find(|cell| is_decimal_comma(&cell.text))
        };
        let comma = comma.map(|cell| cell.span.clone());
        Ok(Self { file, header, rows, theirs: theirs.clone(), comma })
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
                let words = words.filter(|word| !word.is_empty() && *word != "or");
                return Err(match meant(&cell.text, words) {
                    Some((name, unit)) => error.with_help(format!("did you mean `{name}`?{unit}")),
                    None => error.with_help("take the column out, or give it the name of what it holds"),
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
        let named = self.named(column);
        if cell.text.is_empty() {
            return Err(InputError::at(
                &cell.span,
                format!("column {named} is empty here; expected a number"),
            )
            .with_help("fill the cell, or take the row out"));
        }
        if let Some(comma) = self.comma.as_ref().filter(|_| cell.text.contains('.')) {
            let message = format!(
                "`{}` in column {named} has a point, and line {} a decimal comma",
                cell.text, comma.line
            );
            return Err(InputError::at(&cell.span, message)
                .with_help("a file has decimal points or decimal commas, and nothing between thousands"));
        }
        match decimal(&cell.text, self.comma.is_some()).filter(|value| value.is_finite()) {
            Some(value) => Ok(value),
            None => Err(InputError::at(
                &cell.span,
                format!("`{}` in column {named} is not a finite number", cell.text),
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
            let error = InputError::at(
                &whole_line(&self.header),
                format!("the column {} is missing", self.named(column)),
            );
            let unknown = self.columns().filter(|name| !self.theirs.contains_key(*name));
            error.with_help(match meant(column, unknown) {
                Some((name, unit)) => format!("is `{name}` meant to be `{column}`?{unit}"),
                None => format!("the columns here are {}", self.columns().collect::<Vec<_>>().join(", ")),
            })
        })
    }

    /// A column's name in quotes, with the file's own if that is another.
    fn named(&self, column: &str) -> String {
        match self.theirs.get(column) {
            Some(theirs) => format!("`{column}` (here `{theirs}`)"),
            None => format!("`{column}`"),
        }
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
            return Err(InputError::at(&cell.span, "this column has no name")
                .with_help("name it, or take it out (a separator at the end of a line begins a column)"));
        }
        if !names.insert(&cell.text) {
            return Err(InputError::at(&cell.span, format!("the column `{}` occurs twice", cell.text))
                .with_help("take one of them out"));
        }
    }
    Ok(())
}

fn check_row(row: &[Cell], header: &[Cell]) -> Result<(), InputError> {
    if row.len() == header.len() {
        return Ok(());
    }
    let message = format!("this row has {} cells, the header has {}", row.len(), header.len());
    Err(InputError::at(&whole_line(row), message).with_help(if row.len() > header.len() {
        "numbers with decimal commas need semicolons or tabs between the cells, in the header, too"
    } else {
        "empty cells still need their commas"
    }))
}
