//! The one place that maps diagnostics to exceptions.

use flexure::Session;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use text::Diagnostic;

/// A diagnostic as a dictionary: severity, code, message, file, line, column, notes, helps, text.
pub fn to_dict<'py>(py: Python<'py>, session: &Session, diagnostic: &Diagnostic) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("severity", diagnostic.severity.word())?;
    dict.set_item("code", diagnostic.code)?;
    dict.set_item("message", &diagnostic.message)?;
    let place = diagnostic.primary.as_ref().map(|label| {
        let sources = session.sources();
        (sources.name(label.span.file), sources.line_column(label.span.file, label.span.start))
    });
    dict.set_item("file", place.map(|p| p.0))?;
    dict.set_item("line", place.map(|p| p.1.line))?;
    dict.set_item("column", place.map(|p| p.1.column))?;
    dict.set_item("notes", &diagnostic.notes)?;
    dict.set_item("helps", diagnostic.helps.iter().map(|h| h.text.clone()).collect::<Vec<_>>())?;
    dict.set_item("text", session.render(std::slice::from_ref(diagnostic), false))?;
    Ok(dict)
}

pub fn to_list<'py>(py: Python<'py>, session: &Session, diagnostics: &[Diagnostic]) -> PyResult<Bound<'py, PyList>> {
    let dicts = diagnostics.iter().map(|d| to_dict(py, session, d)).collect::<PyResult<Vec<_>>>()?;
    PyList::new(py, dicts)
}

/// Raises `flexure.FlexureError` carrying the diagnostics.
pub fn raise(py: Python<'_>, session: &Session, diagnostics: &[Diagnostic]) -> PyErr {
    let built = py.import("flexure._errors").and_then(|module| {
        module.getattr("FlexureError")?.call_method1("_from_native", (to_list(py, session, diagnostics)?,))
    });
    match built {
        Ok(exception) => PyErr::from_value(exception),
        Err(error) => error,
    }
}
