//! The compiled part of the Python package `wingroot`: runs commands as the command line does, and hands arrays over.
//!
//! What users see is in `python/wingroot`; nothing is computed here.
#![expect(clippy::needless_pass_by_value, reason = "what Python hands to a function is a value of its own")]

mod arrays;
mod command;
mod files;
mod model;
mod raised;

/// The module `wingroot._wingroot`.
#[pyo3::pymodule]
mod _wingroot {
    use pyo3::prelude::*;

    #[pymodule_export]
    use crate::command::run;
    #[pymodule_export]
    use crate::files::{
        effect_library, read_aircraft, read_campaign, read_corrections, read_table, read_wing,
        write_campaign, write_corrections, write_wing,
    };
    #[pymodule_export]
    use crate::model::Model;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        wingroot::divide_matrices();
        module.add("__version__", env!("CARGO_PKG_VERSION"))?;
        module.add("VERSION", wingroot::VERSION)
    }
}
