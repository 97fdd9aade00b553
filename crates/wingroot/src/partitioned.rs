//! Tables of many rows as Parquet, in folders by what most questions ask for first (`kind=roll/mass_kg=7.3/TABLE.parquet`), which
//! DuckDB, Polars and pandas read as columns. Every column chunk has its smallest and largest value, so that readers pass over
//! most of a table. Behind this file only.

use std::collections::BTreeMap;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::parser::parse_message_type;
use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, utf8_percent_encode};

use crate::failure::Failure;

/// Rows that are in memory for each folder of a table.
const ROWS_AT_ONCE: usize = 32_768;
/// What stands in the name of a folder as it is; the rest is percent-encoded, which readers undo.
const PLAIN: AsciiSet = NON_ALPHANUMERIC.remove(b'_').remove(b'-').remove(b'.');

/// A column: its name, what its cells are, and their unit.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Column(pub(crate) &'static str, pub(crate) Kind);

/// What the cells of a column are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Words.
    Words,
    /// Whole numbers.
    Whole,
    /// Numbers with a unit.
    Real(&'static str),
}

/// A cell of a row, as its column asks for.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Cell<'a> {
    /// Words.
    Words(&'a str),
    /// A whole number.
    Whole(usize),
    /// A number.
    Real(f64),
}

/// A table in the making.
pub(crate) struct Partitioned<'a> {
    folder: PathBuf,
    name: &'static str,
    columns: &'a [Column],
    parts: BTreeMap<String, Part>,
}

/// One of its files.
struct Part {
    writer: SerializedFileWriter<File>,
    waiting: Vec<Waiting>,
    rows: usize,
}

/// Cells of a column that are not written yet.
enum Waiting {
    Words(Vec<ByteArray>),
    Whole(Vec<i64>),
    Real(Vec<f64>),
}

impl<'a> Partitioned<'a> {
    /// A table in a folder of its own, which gets its name.
    pub(crate) fn new(folder: &Path, name: &'static str, columns: &'a [Column]) -> Self {
        Self { folder: folder.join(name), name, columns, parts: BTreeMap::new() }
    }

    /// Adds a row to the part of the table that these names and values choose, in their order.
    ///
    /// # Errors
    /// If a number is not finite, the cells are not those of the columns, or the file cannot be written.
    pub(crate) fn push(&mut self, part: &[(&str, &str)], row: &[Cell<'_>]) -> Result<(), Failure> {
        let folder: Vec<String> = part
            .iter()
            .map(|(name, value)| format!("{name}={}", utf8_percent_encode(value, &PLAIN)))
            .collect();
        let folder = folder.join("/");
        if !self.parts.contains_key(&folder) {
            let part = Part::begin(&self.folder.join(&folder), self.name, self.columns);
            self.parts.insert(folder.clone(), part.map_err(|error| self.refused(&error))?);
        }
        let Some(part) = self.parts.get_mut(&folder) else { return Ok(()) };
        let fits = row.len() == part.waiting.len()
            && part.waiting.iter_mut().zip(row).all(|(waiting, cell)| waiting.add(*cell));
        if !fits {
            let name = self.name;
            return Err(Failure::Computation(format!(
                "{name}.parquet would hold a row that is no result: nothing is written"
            )));
        }
        part.rows += 1;
        if part.rows < ROWS_AT_ONCE {
            return Ok(());
        }
        part.flush().map_err(|error| self.refused(&error))
    }

    /// Writes what is in memory and the ends of all files.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub(crate) fn finish(mut self) -> Result<(), Failure> {
        for (_, mut part) in std::mem::take(&mut self.parts) {
            let written = part.flush().and_then(|()| part.writer.close());
            written.map_err(|error| self.refused(&error))?;
        }
        Ok(())
    }

    fn refused(&self, error: &ParquetError) -> Failure {
        Failure::Computation(format!("{} cannot be written: {error}", self.folder.display()))
    }
}

impl Part {
    fn begin(folder: &Path, name: &str, columns: &[Column]) -> Result<Self, ParquetError> {
        let of = |Column(name, kind): &Column| match kind {
            Kind::Words => format!("REQUIRED BYTE_ARRAY {name} (UTF8);"),
            Kind::Whole => format!("REQUIRED INT64 {name};"),
            Kind::Real(_) => format!("REQUIRED DOUBLE {name};"),
        };
        let fields: String = columns.iter().map(of).collect();
        let schema = parse_message_type(&format!("message {name} {{ {fields} }}"))?;
        let unit = |Column(name, kind): &Column| match kind {
            Kind::Real(unit) => Some(KeyValue::new(format!("unit:{name}"), (*unit).to_owned())),
            Kind::Words | Kind::Whole => None,
        };
        let properties = WriterProperties::builder()
            .set_created_by(format!("wingroot {}", crate::version::VERSION))
            .set_key_value_metadata(Some(columns.iter().filter_map(unit).collect()))
            .set_statistics_enabled(EnabledStatistics::Chunk)
            .build();
        std::fs::create_dir_all(folder)?;
        let file = File::create(folder.join(format!("{name}.parquet")))?;
        let waiting = columns.iter().map(|Column(_, kind)| match kind {
            Kind::Words => Waiting::Words(Vec::new()),
            Kind::Whole => Waiting::Whole(Vec::new()),
            Kind::Real(_) => Waiting::Real(Vec::new()),
        });
        let waiting = waiting.collect();
        let writer = SerializedFileWriter::new(file, Arc::new(schema), Arc::new(properties))?;
        Ok(Self { writer, waiting, rows: 0 })
    }

    /// Writes what is waiting as a group of rows.
    fn flush(&mut self) -> Result<(), ParquetError> {
        if std::mem::take(&mut self.rows) == 0 {
            return Ok(());
        }
        let mut group = self.writer.next_row_group()?;
        for waiting in &mut self.waiting {
            let Some(mut column) = group.next_column()? else { break };
            match waiting {
                Waiting::Words(cells) => {
                    column.typed::<ByteArrayType>().write_batch(cells, None, None)?;
                    cells.clear();
                }
                Waiting::Whole(cells) => {
                    column.typed::<Int64Type>().write_batch(cells, None, None)?;
                    cells.clear();
                }
                Waiting::Real(cells) => {
                    column.typed::<DoubleType>().write_batch(cells, None, None)?;
                    cells.clear();
                }
            }
            column.close()?;
        }
        group.close().map(|_| ())
    }
}

impl Waiting {
    /// Adds a cell; false if it is of another kind, or no finite number.
    fn add(&mut self, cell: Cell<'_>) -> bool {
        match (self, cell) {
            (Self::Words(cells), Cell::Words(words)) => cells.push(words.as_bytes().to_vec().into()),
            (Self::Whole(cells), Cell::Whole(number)) => {
                let Ok(number) = i64::try_from(number) else { return false };
                cells.push(number);
            }
            (Self::Real(cells), Cell::Real(value)) if value.is_finite() => cells.push(value),
            _ => return false,
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::file::statistics::Statistics;

    use super::*;

    const COLUMNS: [Column; 3] =
        [Column("case", Kind::Whole), Column("station", Kind::Words), Column("Mx_max_Nm", Kind::Real("N m"))];

    fn folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("wingroot-parquet-{name}-{}", std::process::id()));
        let _ = std::fs::remove_dir_all(&folder);
        folder
    }

    #[test]
    fn rows_come_back_from_their_folders_with_units_and_the_ends_of_every_group() {
        let folder = folder("rows");
        let mut table = Partitioned::new(&folder, "station_loads", &COLUMNS);
        let rows = 2 * ROWS_AT_ONCE + 5;
        for number in 0..rows {
            let kind = if number % 2 == 0 { "roll" } else { "elevator kick" };
            let row = [Cell::Whole(number), Cell::Words("right root"), Cell::Real(0.1 * number as f64)];
            table.push(&[("kind", kind), ("mass_kg", "7.3")], &row).expect("a row");
        }
        table.finish().expect("it is written");
        let mut found = 0;
        for (kind, first) in [("roll", 0), ("elevator%20kick", 1)] {
            let path = folder.join(format!("station_loads/kind={kind}/mass_kg=7.3/station_loads.parquet"));
            let reader = SerializedFileReader::new(File::open(path).expect("a file")).expect("Parquet");
            let units = reader.metadata().file_metadata().key_value_metadata().expect("units");
            let unit = units.iter().map(|unit| (unit.key.as_str(), unit.value.as_deref()));
            assert_eq!(unit.collect::<Vec<_>>(), [("unit:Mx_max_Nm", Some("N m"))]);
            for group in reader.metadata().row_groups() {
                let Some(Statistics::Double(ends)) = group.column(2).statistics() else { panic!("no ends") };
                assert!(ends.min_opt() < ends.max_opt(), "{ends:?}");
            }
            for row in reader.get_row_iter(None).expect("rows") {
                let text = row.expect("a row").to_string();
                assert!(text.contains("station: \"right root\""), "{text}");
                found += 1;
            }
            let row = reader.get_row_iter(None).expect("rows").next().expect("one").expect("a row");
            assert!(row.to_string().starts_with(&format!("{{case: {first},")), "{row}");
        }
        assert_eq!(found, rows);
        std::fs::remove_dir_all(folder).expect("our own folder");
    }

    #[test]
    fn numbers_that_are_not_finite_and_rows_of_another_length_are_refused() {
        let folder = folder("refused");
        let mut table = Partitioned::new(&folder, "station_loads", &COLUMNS);
        let row = |value| [Cell::Whole(1), Cell::Words("tip"), Cell::Real(value)];
        for value in [f64::NAN, f64::INFINITY] {
            let error = table.push(&[("kind", "roll")], &row(value)).expect_err("no result");
            assert!(error.to_string().contains("no result"), "{error}");
        }
        assert!(table.push(&[("kind", "roll")], &row(1.0)[..2]).is_err());
        std::fs::remove_dir_all(folder).expect("our own folder");
    }
}
