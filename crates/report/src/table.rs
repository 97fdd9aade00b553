//! Aligned plain-text tables for a terminal: words to the left, numbers to the right, two blanks between columns.

/// A column of a table of things: its head, and what it says of a thing.
pub type Column<'a, T> = (&'a str, &'a dyn Fn(&T) -> String);

/// A table; fill it row by row and print it with its `Display`.
///
/// ```
/// let mut table = report::Table::new(&["V (m/s)", "before", "after"]);
/// table.row(["18", "6.98", "0.11"]);
/// assert_eq!(table.to_string(), "V (m/s)  before  after\n-------  ------  -----\n     18    6.98   0.11\n");
/// ```
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Table {
    head: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// An empty table with these column heads.
    pub fn new(head: &[&str]) -> Self {
        Self { head: head.iter().map(ToString::to_string).collect(), rows: Vec::new() }
    }

    /// A table with a row for each thing.
    pub fn of<T>(things: impl IntoIterator<Item = T>, columns: &[Column<'_, T>]) -> Self {
        let mut table = Self::new(&columns.iter().map(|(head, _)| *head).collect::<Vec<_>>());
        for thing in things {
            table.row(columns.iter().map(|(_, cell)| cell(&thing)));
        }
        table
    }

    /// Adds a row. Missing cells stay empty; cells beyond the head get columns of their own.
    pub fn row<T: Into<String>>(&mut self, cells: impl IntoIterator<Item = T>) -> &mut Self {
        self.rows.push(cells.into_iter().map(Into::into).collect());
        self
    }

    /// Number of rows without the head.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether there are no rows.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    fn cell(row: &[String], column: usize) -> &str {
        row.get(column).map_or("", String::as_str)
    }

    /// A column is set to the right if every filled cell in it starts like a number.
    fn is_numeric(&self, column: usize) -> bool {
        let mut filled =
            self.rows.iter().map(|row| Self::cell(row, column)).filter(|c| !c.is_empty()).peekable();
        filled.peek().is_some()
            && filled.all(|c| {
                c == "-" || c.trim_start_matches(['+', '-', '.']).starts_with(|d: char| d.is_ascii_digit())
            })
    }
}

impl std::fmt::Display for Table {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let columns = self.rows.iter().map(Vec::len).chain([self.head.len()]).max().unwrap_or(0);
        let width = |column: usize| {
            let cells = self.rows.iter().map(|row| Self::cell(row, column));
            cells.chain([Self::cell(&self.head, column)]).map(|c| c.chars().count()).max().unwrap_or(0)
        };
        let layout: Vec<(usize, bool)> = (0..columns).map(|c| (width(c), self.is_numeric(c))).collect();
        let line = |row: &[String]| {
            let cells: Vec<String> = layout
                .iter()
                .enumerate()
                .map(|(column, &(width, right))| {
                    let cell = Self::cell(row, column);
                    if right { format!("{cell:>width$}") } else { format!("{cell:<width$}") }
                })
                .collect();
            cells.join("  ").trim_end().to_string()
        };
        let rule: Vec<String> = layout.iter().map(|&(width, _)| "-".repeat(width)).collect();
        writeln!(f, "{}\n{}", line(&self.head), rule.join("  "))?;
        self.rows.iter().try_for_each(|row| writeln!(f, "{}", line(row)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_go_left_and_numbers_right() {
        let mut table = Table::new(&["run", "rmse (N)"]);
        table.row(["doublet", "12.5"]).row(["chirp, 2 Hz", "3"]).row(["none", "-"]);
        let expected = "\
run          rmse (N)
-----------  --------
doublet          12.5
chirp, 2 Hz         3
none                -
";
        assert_eq!(table.to_string(), expected);
        assert_eq!(table.len(), 3);
    }

    #[test]
    fn ragged_rows_are_padded() {
        let mut table = Table::new(&["a"]);
        table.row(["1", "x"]).row(Vec::<String>::new());
        assert_eq!(table.to_string(), "a\n-  -\n1  x\n\n");
    }
}
