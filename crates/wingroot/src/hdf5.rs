//! HDF5 files from groups of named arrays: the one place that knows the library.
//!
//! Matrices are stored row by row, as h5py and HDFView show them.

use hdf5_pure::{AttrValue, FileBuilder};

use crate::failure::Failure;

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
}
