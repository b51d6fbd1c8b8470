//! The native module of the Python package: arguments in, one call of the facade, results out.
//! The classes people see are in `python/flexure`.

// Python's values arrive as owned arguments.
#![allow(clippy::needless_pass_by_value)]

mod beams;
mod errors;
mod observer;
mod session;
mod values;

use pyo3::prelude::*;

/// Runs the command line with the given arguments (without the program's name first); returns the
/// exit status.
#[pyfunction]
fn run_command_line(py: Python<'_>, arguments: Vec<String>) -> u8 {
    let arguments = std::iter::once("flexure".to_string()).chain(arguments).map(Into::into).collect::<Vec<_>>();
    py.detach(|| flexure_cli::status(arguments))
}

#[pymodule]
fn _native(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_class::<session::Session>()?;
    module.add_class::<session::Run>()?;
    module.add_class::<beams::BeamState>()?;
    module.add_function(wrap_pyfunction!(run_command_line, module)?)
}
