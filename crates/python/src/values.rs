//! Values of attributes that Python gives.

use flexure::AttributeInput;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyBytes, PyFloat, PyInt, PySequence, PyString};

/// A number, text, object of the model or a list of them, as the facade takes it.
pub fn input(value: &Bound<'_, PyAny>) -> PyResult<AttributeInput> {
    if value.is_none() {
        return Ok(AttributeInput::None);
    }
    if let Ok(text) = value.cast::<PyString>() {
        return Ok(AttributeInput::Text(text.to_cow()?.into_owned()));
    }
    if value.is_instance_of::<PyBool>() {
        return Ok(AttributeInput::Flag(value.extract()?));
    }
    if value.is_instance_of::<PyInt>() {
        return value.extract().map(AttributeInput::Integer).or_else(|_| value.extract().map(AttributeInput::Number));
    }
    if value.is_instance_of::<PyFloat>() {
        return Ok(AttributeInput::Number(value.extract()?));
    }
    // Objects of the model.
    if let Some(name) = value.getattr_opt("full_name")? {
        return Ok(AttributeInput::Text(name.extract()?));
    }
    // Numbers and arrays of numpy.
    if let Some(list) = value.getattr_opt("tolist")? {
        return input(&list.call0()?);
    }
    let sequence = value.cast::<PySequence>().ok().filter(|_| !value.is_instance_of::<PyBytes>());
    let Some(sequence) = sequence else {
        let message = format!("{} is no value of an attribute", value.get_type().name()?);
        return Err(PyTypeError::new_err(message));
    };
    let items = sequence.try_iter()?.map(|item| input(&item?));
    Ok(AttributeInput::List(items.collect::<PyResult<_>>()?))
}
