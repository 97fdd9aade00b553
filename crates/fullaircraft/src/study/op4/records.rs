//! What a reader of OP4 files gives, whatever the file's form.

use nastran::InputError;

/// Rows from which on strings are those of BIGMAT even where the head does not say so by a minus.
const MANY_ROWS: u64 = 65_536;
/// What the head of a matrix says.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Head {
    pub(super) columns: u64,
    pub(super) rows: u64,
    /// 1 square, 2 rectangular, 6 symmetric, others of special shape.
    form: i64,
    /// 1 and 2 real, 3 and 4 complex; odd ones in single precision.
    pub(super) kind: i64,
    pub(super) name: String,
    /// Whether strings are those of BIGMAT.
    pub(super) is_big: bool,
}

impl Head {
    /// A head of what stands in a file; rows below zero announce BIGMAT.
    pub(super) fn new([columns, rows, form, kind]: [i64; 4], name: &str) -> Option<Self> {
        let columns = u64::try_from(columns).ok()?;
        let is_big = rows < 0 || rows.unsigned_abs() >= MANY_ROWS;
        let is_possible = rows != 0 && columns > 0 && (1..=4).contains(&kind);
        let name = name.trim_matches(|c: char| c.is_whitespace() || c == '\0').to_ascii_uppercase();
        is_possible.then_some(Self { columns, rows: rows.unsigned_abs(), form, kind, name, is_big })
    }

    /// Words of a number in double precision, where single precision has one.
    pub(super) fn words(&self, of_double: u64) -> u64 {
        if self.kind % 2 == 1 { 1 } else { of_double }
    }

    /// Why it is no mass matrix, if it is none.
    pub(super) fn fault(&self) -> Option<String> {
        let Self { columns, rows, form, kind, name, .. } = self;
        if *kind > 2 {
            return Some(format!("{name} is complex (type {kind})"));
        }
        let is_square = columns == rows && [1, 2, 6].contains(form);
        (!is_square).then(|| format!("{name} has {rows} rows, {columns} columns and the form {form}"))
    }
}

/// A file of matrices, read from its beginning to its end.
pub(super) trait Records {
    /// The next head; nothing at the end.
    fn head(&mut self) -> Result<Option<Head>, InputError>;
    /// Column, first row and length of the next record.
    fn column(&mut self) -> Result<[i64; 3], InputError>;
    /// So many whole numbers, one or two, before a string.
    fn whole(&mut self, count: usize) -> Result<[i64; 2], InputError>;
    /// So many real numbers.
    fn reals(&mut self, count: u64) -> Result<Vec<f64>, InputError>;
    /// Ends a record.
    fn end(&mut self) -> Result<(), InputError>;
    /// Skips what is left of the record beyond the last column, and ends it.
    fn skip(&mut self) -> Result<(), InputError>;
    /// Words of a number of a dense column, and of a string, in double precision.
    fn words_of_double(&self) -> [u64; 2];
    /// An error at the place that is being read.
    fn wrong(&self, message: String) -> InputError;
}
