//! Numbers of Rust as numpy arrays, which take the memory over.

use faer::sparse::SparseColMatRef;
use numpy::{IntoPyArray, PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use wingroot::hdf5::{Group, Values};

/// The datasets of a group by name.
pub(crate) fn dict(py: Python<'_>, group: Group) -> PyResult<Bound<'_, PyDict>> {
    let dict = PyDict::new(py);
    for (name, values) in group.datasets {
        match values {
            Values::Real(values, shape) => dict.set_item(name, values.into_pyarray(py).reshape(shape)?)?,
            Values::Whole(values) => dict.set_item(name, values.into_pyarray(py))?,
            Values::Words(words) => dict.set_item(name, words)?,
        }
    }
    Ok(dict)
}

/// A sparse matrix by columns, as `scipy.sparse.csc_array` takes it: values, rows, where each column begins.
pub(crate) type Sparse<'py> =
    (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<i64>>, Bound<'py, PyArray1<i64>>);

/// Both halves of a symmetric sparse matrix.
pub(crate) fn sparse<'py>(py: Python<'py>, matrix: SparseColMatRef<'_, usize, f64>) -> Sparse<'py> {
    let whole = |places: &[usize]| {
        let places = places.iter().filter_map(|&place| i64::try_from(place).ok());
        places.collect::<Vec<_>>().into_pyarray(py)
    };
    (
        matrix.val().to_vec().into_pyarray(py),
        whole(matrix.symbolic().row_idx()),
        whole(matrix.symbolic().col_ptr()),
    )
}
