//! The session and its runs, as Python sees them.

use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

use flexure::{Analysis, BeamAngles, BeamsAt, Outputs, Report, SimulationOptions};
use numpy::{IntoPyArray, PyArray1, PyArray2};
use pyo3::IntoPyObjectExt;
use pyo3::exceptions::{PyAttributeError, PyKeyError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::beams::{self, BeamState};
use crate::errors;
use crate::observer::PythonObserver;
use crate::values;

/// A finished run.
#[pyclass(frozen)]
pub struct Run {
    inner: flexure::Run,
}

#[pymethods]
impl Run {
    /// Names of the series, `time` first.
    fn names(&self) -> Vec<String> {
        self.inner.table.series.iter().map(|s| s.name.clone()).collect()
    }

    /// Values (shape: outputs) and unit of a series.
    fn series<'py>(&self, py: Python<'py>, name: &str) -> PyResult<(Bound<'py, PyArray1<f64>>, String)> {
        let series = self.inner.table.get(name).ok_or_else(|| PyKeyError::new_err(name.to_string()))?;
        Ok((PyArray1::from_slice(py, &series.values), series.unit.clone()))
    }

    fn title(&self) -> &str {
        &self.inner.header.title
    }

    fn messages(&self) -> Vec<String> {
        self.inner.messages.clone()
    }

    fn interrupted(&self) -> bool {
        self.inner.interrupted
    }

    /// Counts of the solver's work.
    fn statistics<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for (name, count) in self.inner.counts() {
            dict.set_item(name, count)?;
        }
        Ok(dict)
    }

    fn write(&self, path: PathBuf) -> PyResult<()> {
        let file = std::io::BufWriter::new(std::fs::File::create(&path)?);
        if path.extension().is_some_and(|e| e.eq_ignore_ascii_case("parquet")) {
            flexure::parquet::write(&self.inner.table, file)?;
        } else {
            flexure::results::csv::write(&self.inner.table, file)?;
        }
        Ok(())
    }
}

/// One session with one or more models.
#[pyclass]
pub struct Session {
    /// In a mutex because Python may hand the object to another thread.
    inner: Mutex<flexure::Session>,
}

#[pymethods]
impl Session {
    #[new]
    fn new() -> Session {
        Session { inner: Mutex::new(flexure::Session::new()) }
    }

    /// Reads a file without simulating; returns the warnings, raises on errors.
    fn read<'py>(&mut self, py: Python<'py>, path: PathBuf) -> PyResult<Bound<'py, PyList>> {
        self.session().simulate_nothing(true);
        let session = self.session();
        let report = py.detach(|| session.read(&path));
        self.session().simulate_nothing(false);
        self.settle(py, &report)
    }

    /// Executes command text; returns the warnings, raises on errors.
    fn execute<'py>(&mut self, py: Python<'py>, text: String) -> PyResult<Bound<'py, PyList>> {
        let session = self.session();
        let report = py.detach(|| session.execute(&text));
        self.settle(py, &report)
    }

    /// Name of the current model without dot.
    fn model(&mut self) -> Option<String> {
        self.session().model_name()
    }

    /// Full names of all objects of a class or family, in order of creation.
    fn objects(&mut self, wanted: &str) -> Vec<String> {
        self.session().objects(wanted)
    }

    /// Full name of an object given by full or short name.
    fn resolve(&mut self, name: &str, wanted: &str) -> PyResult<String> {
        self.session().resolve(name, wanted).ok_or_else(|| PyKeyError::new_err(name.to_string()))
    }

    /// Names of the attributes of an object.
    fn attributes(&mut self, object: &str) -> Vec<String> {
        self.session().attributes(object)
    }

    /// Value, unit label and expression text of an attribute, in model units.
    fn attribute<'py>(
        &mut self,
        py: Python<'py>,
        object: &str,
        name: &str,
    ) -> PyResult<(Bound<'py, PyAny>, String, Option<String>)> {
        let attribute = self
            .session()
            .attribute(object, name)
            .ok_or_else(|| PyAttributeError::new_err(format!("{object} has no attribute {name}")))?;
        let value = match attribute.value {
            flexure::AttributeValue::None => py.None().into_bound(py),
            flexure::AttributeValue::Number(x) => x.into_bound_py_any(py)?,
            flexure::AttributeValue::Integer(x) => x.into_bound_py_any(py)?,
            flexure::AttributeValue::Flag(x) => x.into_bound_py_any(py)?,
            flexure::AttributeValue::Text(x) => x.into_bound_py_any(py)?,
            flexure::AttributeValue::Numbers(x) => x.into_pyarray(py).into_any(),
            flexure::AttributeValue::Texts(x) => x.into_bound_py_any(py)?,
        };
        Ok((value, attribute.unit, attribute.expression))
    }

    /// Sets attributes by the class's modify commands.
    fn modify<'py>(
        &mut self,
        py: Python<'py>,
        object: &str,
        values: Vec<(String, Bound<'py, PyAny>)>,
    ) -> PyResult<Bound<'py, PyList>> {
        let values = values.into_iter().map(|(name, value)| Ok((name, values::input(&value)?)));
        let values = values.collect::<PyResult<Vec<_>>>()?;
        let report = self.session().modify(object, &values);
        self.settle(py, &report)
    }

    /// Gives an object another name, without path and quotes; returns its new full name.
    fn rename(&mut self, py: Python<'_>, object: &str, name: &str) -> PyResult<String> {
        let id = self.session().database().find(object, "any");
        let report = self.session().rename(object, name);
        self.settle(py, &report)?;
        Ok(id.map_or_else(|| object.to_string(), |id| self.session().database().full_name(id)))
    }

    #[pyo3(signature = (kind, end=None, steps=None, dtout=None, integrator=None, error=None, hmax=None, all=false, beam_loads=false, progress=None))]
    #[allow(clippy::too_many_arguments)]
    fn simulate(
        &mut self,
        py: Python<'_>,
        kind: &str,
        end: Option<f64>,
        steps: Option<usize>,
        dtout: Option<f64>,
        integrator: Option<String>,
        error: Option<f64>,
        hmax: Option<f64>,
        all: bool,
        beam_loads: bool,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Run> {
        let outputs = match (steps, dtout) {
            (Some(steps), _) => Outputs::Steps(steps),
            (None, Some(interval)) => Outputs::Interval(interval),
            (None, None) => Outputs::Steps(100),
        };
        let end = end.unwrap_or(1.0);
        let analysis = match kind {
            "static" => Analysis::Static,
            "kinematic" => Analysis::Kinematic { end, outputs },
            _ => Analysis::Dynamic { end, outputs },
        };
        let raised = Arc::new(Mutex::new(None));
        self.session().set_observer(Box::new(PythonObserver { progress, raised: raised.clone() }));
        self.session().record_everything(all);
        self.session().record_beams(beam_loads);
        let options = SimulationOptions { analysis, integrator, error, largest_step: hmax };
        let session = self.session();
        let outcome = py.detach(|| session.simulate(&options));
        if let Some(error) = raised.lock().ok().and_then(|mut r| r.take()) {
            return Err(error);
        }
        outcome.map(|inner| Run { inner }).map_err(|diagnostics| errors::raise(py, self.session(), &diagnostics))
    }

    /// How LINEAR and STRING beams measure rotation: `projected` or `rotvec`.
    fn beam_angles(&mut self) -> &'static str {
        match self.session().beam_angles() {
            BeamAngles::Projected => "projected",
            BeamAngles::RotationVector => "rotvec",
        }
    }

    fn set_beam_angles(&mut self, how: &str) -> PyResult<()> {
        let angles = match how {
            "projected" => BeamAngles::Projected,
            "rotvec" => BeamAngles::RotationVector,
            _ => return Err(PyValueError::new_err(format!("`{how}` is not `projected` or `rotvec`"))),
        };
        self.session().measure_beam_angles(angles);
        Ok(())
    }

    /// Whether NONLINEAR beams shear by their shear ratios.
    fn nonlinear_shear(&mut self) -> bool {
        self.session().nonlinear_beams_shear()
    }

    fn set_nonlinear_shear(&mut self, shear: bool) {
        self.session().shear_nonlinear_beams(shear);
    }

    /// What goes through every beam, in order of creation.
    #[pyo3(signature = (statics=false, at=None))]
    fn beams(&mut self, py: Python<'_>, statics: bool, at: Option<f64>) -> PyResult<Vec<BeamState>> {
        let at = match at {
            Some(end) => BeamsAt::Time { end, statics },
            None if statics => BeamsAt::Equilibrium,
            None => BeamsAt::Present,
        };
        let session = self.session();
        match py.detach(|| session.beams(&at)) {
            Ok(report) => Ok(beams::states(&report)),
            Err(diagnostics) => Err(errors::raise(py, self.session(), &diagnostics)),
        }
    }

    /// Runs that commands made (`simulation single_run ...`) since the last call.
    fn take_runs(&mut self) -> Vec<Run> {
        self.session().take_runs().into_iter().map(|inner| Run { inner }).collect()
    }

    /// Modes: frequencies (Hz), damping ratios, real and imaginary parts (shape: modes), shapes
    /// (modes x unknowns, complex as two arrays), names of the unknowns.
    #[pyo3(signature = (statics=false, spin=None))]
    fn modes<'py>(
        &mut self,
        py: Python<'py>,
        statics: bool,
        spin: Option<(String, f64)>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let session = self.session();
        let about = match spin {
            Some((marker, rate)) => flexure::ModesAbout::Spin { marker, rate },
            None if statics => flexure::ModesAbout::Equilibrium,
            None => flexure::ModesAbout::Present,
        };
        let found = match py.detach(|| session.modes(&about)) {
            Ok(found) => found,
            Err(diagnostics) => return Err(errors::raise(py, self.session(), &diagnostics)),
        };
        let dict = PyDict::new(py);
        let column = |f: &dyn Fn(&flexure::Mode) -> f64| PyArray1::from_iter(py, found.modes.iter().map(f));
        dict.set_item("frequency", column(&|m| m.frequency_hz))?;
        dict.set_item("damping_ratio", column(&|m| m.damping_ratio))?;
        dict.set_item("real", column(&|m| m.real))?;
        dict.set_item("imaginary", column(&|m| m.imaginary))?;
        let shape = |f: &dyn Fn(&(f64, f64)) -> f64| -> PyResult<Bound<'py, PyArray2<f64>>> {
            let rows: Vec<Vec<f64>> = found.modes.iter().map(|m| m.shape.iter().map(f).collect()).collect();
            if rows.is_empty() {
                return Ok(PyArray2::zeros(py, [0, found.unknowns.len()], false));
            }
            Ok(PyArray2::from_vec2(py, &rows)?)
        };
        dict.set_item("shape_real", shape(&|s| s.0)?)?;
        dict.set_item("shape_imaginary", shape(&|s| s.1)?)?;
        dict.set_item("unknowns", &found.unknowns)?;
        Ok(dict)
    }

    /// Report lines, and findings as dictionaries with the command that mends them.
    fn verify<'py>(&mut self, py: Python<'py>) -> PyResult<(Vec<String>, Bound<'py, PyList>)> {
        let found = self.session().verify();
        let list = PyList::empty(py);
        for finding in &found.findings {
            let dict = errors::to_dict(py, self.session(), &finding.diagnostic)?;
            dict.set_item("fix", finding.fix.clone())?;
            list.append(dict)?;
        }
        Ok((found.report, list))
    }

    /// Where the word at the end of a text begins, and what may stand there: text and note.
    fn complete(&mut self, text: &str) -> (usize, Vec<(String, String)>) {
        let found = self.session().complete(text);
        // Python counts characters.
        let start = text[..found.start].chars().count();
        (start, found.candidates.into_iter().map(|c| (c.text, c.note)).collect())
    }

    fn undo(&mut self) -> bool {
        self.session().undo()
    }

    fn redo(&mut self) -> bool {
        self.session().redo()
    }

    /// Writes the model; returns the warnings about what the file does not hold.
    fn write<'py>(&mut self, py: Python<'py>, path: PathBuf) -> PyResult<Bound<'py, PyList>> {
        match self.session().write(&path) {
            Ok(warnings) => errors::to_list(py, self.session(), &warnings),
            Err(diagnostics) => Err(errors::raise(py, self.session(), &diagnostics)),
        }
    }
}

impl Session {
    fn session(&mut self) -> &mut flexure::Session {
        self.inner.get_mut().unwrap_or_else(PoisonError::into_inner)
    }

    /// Raises if there are errors; else returns the warnings.
    fn settle<'py>(&mut self, py: Python<'py>, report: &Report) -> PyResult<Bound<'py, PyList>> {
        if report.has_errors() {
            return Err(errors::raise(py, self.session(), &report.diagnostics));
        }
        errors::to_list(py, self.session(), &report.diagnostics)
    }
}
