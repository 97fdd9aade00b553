//! HDF5 files from groups of named arrays: the one place that knows the library.
//!
//! Matrices are stored row by row, as h5py and HDFView show them.

use std::path::Path;

use fullaircraft::study::MassTerms;
use hdf5_pure::{AttrValue, File, FileBuilder};
use nastran::InputError;

use crate::failure::Failure;

/// Where Nastran's HDF5 files keep matrices.
const MATRICES: &str = "NASTRAN/RESULT/MATRIX/GENERAL";
/// Bytes of a row of IDENTITY: an eight-letter name, then whole numbers.
const IDENTITY: usize = 64;

/// What a dataset holds.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// Real numbers with their shape, the last index fastest.
    Real(Vec<f64>, Vec<usize>),
    /// Whole numbers.
    Whole(Vec<u32>),
    /// Words.
    Words(Vec<String>),
}

impl Values {
    /// A list of real numbers.
    pub fn list(values: &[f64]) -> Self {
        Self::Real(values.to_vec(), vec![values.len()])
    }

    /// A matrix.
    pub fn matrix(matrix: faer::MatRef<'_, f64>) -> Self {
        let (rows, columns) = (matrix.nrows(), matrix.ncols());
        let row = |i: usize| (0..columns).map(move |j| matrix[(i, j)]);
        Self::Real((0..rows).flat_map(row).collect(), vec![rows, columns])
    }

    /// Words.
    pub fn words<S: AsRef<str>>(words: impl IntoIterator<Item = S>) -> Self {
        Self::Words(words.into_iter().map(|word| word.as_ref().to_owned()).collect())
    }

    fn is_finite(&self) -> bool {
        match self {
            Self::Real(values, _) => values.iter().all(|value| value.is_finite()),
            _ => true,
        }
    }

    fn is_empty(&self) -> bool {
        match self {
            Self::Real(values, _) => values.is_empty(),
            Self::Whole(values) => values.is_empty(),
            Self::Words(words) => words.is_empty(),
        }
    }
}

/// Datasets below one name.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    /// Its name.
    pub name: String,
    /// What it is, in words with units: the attribute `about`.
    pub about: String,
    /// Name and content of each dataset.
    pub datasets: Vec<(String, Values)>,
}

impl Group {
    /// A group without datasets.
    pub fn new(name: &str, about: &str) -> Self {
        Self { name: name.to_owned(), about: about.to_owned(), datasets: Vec::new() }
    }

    /// The group with one more dataset.
    #[must_use]
    pub fn with(mut self, name: &str, values: Values) -> Self {
        self.datasets.push((name.to_owned(), values));
        self
    }
}

/// The bytes of an HDF5 file; `about` is an attribute of its root. Empty datasets are left out.
///
/// # Errors
/// If a number is not finite, or the library refuses a name.
pub fn bytes(about: &str, groups: &[Group]) -> Result<Vec<u8>, Failure> {
    let mut file = FileBuilder::new();
    file.set_attr("about", AttrValue::String(about.to_owned()));
    for group in groups {
        let mut builder = file.create_group(&group.name);
        builder.set_attr("about", AttrValue::String(group.about.clone()));
        for (name, values) in group.datasets.iter().filter(|(_, values)| !values.is_empty()) {
            if !values.is_finite() {
                let message =
                    format!("{}/{name} has a value that is not finite and is not written", group.name);
                return Err(Failure::Computation(message));
            }
            let dataset = builder.create_dataset(name);
            match values {
                Values::Real(values, shape) => {
                    let shape: Vec<u64> = shape.iter().map(|&length| length as u64).collect();
                    dataset.with_f64_data(values).with_shape(&shape);
                }
                Values::Whole(values) => {
                    dataset.with_u32_data(values).with_shape(&[values.len() as u64]);
                }
                Values::Words(words) => {
                    let words: Vec<&str> = words.iter().map(String::as_str).collect();
                    dataset.with_strings(&words).map_err(Failure::computation)?;
                }
            }
        }
        file.add_group(builder.finish());
    }
    file.finish().map_err(Failure::computation)
}

/// The mass matrix MGG of Nastran's HDF5 file (tables IDENTITY, COLUMN and DATA).
///
/// # Errors
/// If the file cannot be read or has no such matrix.
pub(crate) fn mass_matrix(path: &Path) -> Result<MassTerms, InputError> {
    let wrong = |what: String| {
        InputError::in_file(path, what)
            .with_help(format!("expected the matrix MGG in {MATRICES}, as Nastran writes it"))
    };
    let file =
        File::open(path).map_err(|error| wrong(format!("this is no HDF5 file that can be read: {error}")))?;
    let raw = |name: &str| {
        let table = file.dataset(&format!("{MATRICES}/{name}")).and_then(|table| table.read_raw());
        table.map_err(|error| wrong(format!("its table {name} cannot be read: {error}")))
    };
    let (identity, columns, data) = (raw("IDENTITY")?, raw("COLUMN")?, raw("DATA")?);
    mass_terms(&identity, &columns, &data).map_err(wrong)
}

/// The whole number in a place of a table; nothing beyond its end or below zero.
fn whole(bytes: &[u8], place: usize) -> Option<usize> {
    let at = place.checked_mul(8)?;
    let bytes = bytes.get(at..at.checked_add(8)?)?.try_into().ok()?;
    usize::try_from(i64::from_le_bytes(bytes)).ok()
}

/// MGG of the tables' bytes: IDENTITY has NAME FORM ROW COLUMN NON_ZERO COLUMN_POS DATA_POS DOMAIN_ID, COLUMN where each column's terms
/// begin, DATA their rows (from zero) and values.
fn mass_terms(identity: &[u8], positions: &[u8], data: &[u8]) -> Result<MassTerms, String> {
    let own = identity.chunks_exact(IDENTITY).find(|row| row.starts_with(b"MGG"));
    let own = own.ok_or_else(|| "there is no matrix MGG".to_owned())?;
    let number = |k: usize| whole(own, k).ok_or_else(|| "the row of MGG in IDENTITY is not right".to_owned());
    let (rows, columns, count) = (number(2)?, number(3)?, number(4)?);
    let (first_column, first_term) = (number(5)?, number(6)?);
    let short = || format!("MGG has {columns} columns and {count} terms, but its tables end before");
    let mut terms = Vec::new();
    for column in 0..columns {
        let position =
            |column: usize| whole(positions, first_column.saturating_add(column)).ok_or_else(short);
        let (from, to) =
            (position(column)?, if column + 1 < columns { position(column + 1)? } else { count });
        for term in from..to {
            let place = first_term.saturating_add(term).saturating_mul(2);
            let value = |at: usize| data.get(at..at + 8)?.try_into().ok().map(f64::from_le_bytes);
            let found = whole(data, place).and_then(|row| Some((row, value(8 * place + 8)?)));
            let (row, value) = found.ok_or_else(short)?;
            if row >= rows || rows != columns || !value.is_finite() {
                return Err(format!("MGG has {rows} rows and {columns} columns, and {value} in row {row}"));
            }
            terms.push((row, column, value));
        }
    }
    Ok(MassTerms::Rows { count: rows, terms })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read_again() {
        let matrix = faer::Mat::from_fn(2, 3, |i, j| 10.0 * i as f64 + j as f64);
        let group = Group::new("model", "a matrix")
            .with("A", Values::matrix(matrix.as_ref()))
            .with("ids", Values::Whole(vec![7, 9]))
            .with("nothing", Values::list(&[]))
            .with("names", Values::words(["Fz_N", "alpha"]));
        let file = hdf5_pure::File::from_bytes(bytes("a test", &[group]).unwrap()).unwrap();
        let read = file.dataset("model/A").unwrap();
        assert_eq!(read.shape().unwrap(), [2, 3]);
        assert_eq!(read.read_f64().unwrap(), [0.0, 1.0, 2.0, 10.0, 11.0, 12.0]);
        assert_eq!(file.dataset("model/names").unwrap().read_string().unwrap(), ["Fz_N", "alpha"]);
        assert!(file.dataset("model/nothing").is_err());
    }

    #[test]
    fn a_number_that_is_not_finite_is_refused_by_name() {
        let group = Group::new("model", "").with("A", Values::list(&[1.0, f64::NAN]));
        let refused = bytes("a test", &[group]).unwrap_err().to_string();
        assert!(refused.contains("model/A"), "{refused}");
    }

    fn words(all: &[i64]) -> Vec<u8> {
        all.iter().flat_map(|word| word.to_le_bytes()).collect()
    }

    /// KAA with two columns first, then MGG with three rows: (0, 0) 2.5, (2, 1) -1, nothing in the third.
    fn tables() -> [Vec<u8>; 3] {
        let named = |name: &[u8; 8], numbers: [i64; 7]| [name.to_vec(), words(&numbers)].concat();
        let identity =
            [named(b"KAA     ", [6, 2, 2, 1, 0, 0, 1]), named(b"MGG     ", [6, 3, 3, 2, 2, 1, 1])].concat();
        let term = |row: i64, value: f64| [row.to_le_bytes(), value.to_le_bytes()].concat();
        [identity, words(&[0, 1, 0, 1, 2]), [term(0, 9.0), term(0, 2.5), term(2, -1.0)].concat()]
    }

    #[test]
    fn the_mass_matrix_is_found_among_others_by_its_positions() {
        let [identity, columns, data] = tables();
        let found = mass_terms(&identity, &columns, &data);
        assert_eq!(found, Ok(MassTerms::Rows { count: 3, terms: vec![(0, 0, 2.5), (2, 1, -1.0)] }));
    }

    #[test]
    fn tables_that_end_early_or_point_outside_are_no_matrix() {
        let [identity, columns, data] = tables();
        let none = mass_terms(&identity[..64], &columns, &data).unwrap_err();
        assert!(none.contains("no matrix MGG"), "{none}");
        for (columns, data) in [(&columns[..32], &data[..]), (&columns[..], &data[..40])] {
            let short = mass_terms(&identity, columns, data).unwrap_err();
            assert!(short.contains("tables end before"), "{short}");
        }
        let mut outside = data.clone();
        outside[16..24].copy_from_slice(&3_i64.to_le_bytes());
        assert!(mass_terms(&identity, &columns, &outside).unwrap_err().contains("in row 3"));
        let mut far = identity;
        far[64 + 48..64 + 56].copy_from_slice(&i64::MAX.to_le_bytes());
        assert!(mass_terms(&far, &columns, &data).unwrap_err().contains("tables end before"));
    }
}
