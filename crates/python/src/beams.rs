//! What goes through one beam, as Python sees it.

use flexure::BeamsReport;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// One beam in one state, in model units.
#[pyclass(frozen)]
pub struct BeamState {
    inner: flexure::BeamState,
    /// Units: of force, moment, length, angle, energy and power.
    units: Vec<(&'static str, String)>,
}

#[pymethods]
impl BeamState {
    #[getter]
    fn name(&self) -> &str {
        &self.inner.name
    }

    #[getter]
    fn length(&self) -> f64 {
        self.inner.length
    }

    /// N, Vy, Vz.
    #[getter]
    fn force(&self) -> (f64, f64, f64) {
        self.inner.force.into()
    }

    /// T, My, Mz at a share of the way from J to I.
    fn moment(&self, station: f64) -> (f64, f64, f64) {
        self.inner.moment(station).into()
    }

    #[getter]
    fn angle(&self) -> f64 {
        self.inner.angle
    }

    #[getter]
    fn energy(&self) -> f64 {
        self.inner.energy
    }

    #[getter]
    fn power(&self) -> f64 {
        self.inner.power
    }

    #[getter]
    fn residual(&self) -> f64 {
        self.inner.residual
    }

    #[getter]
    fn units<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for (quantity, unit) in &self.units {
            dict.set_item(quantity, unit)?;
        }
        Ok(dict)
    }

    fn __repr__(&self) -> String {
        let [n, y, z] = self.inner.force;
        format!("<BeamState {}: N={n:.6}, Vy={y:.6}, Vz={z:.6}>", self.inner.name)
    }
}

/// The beams of a report in order of creation.
pub fn states(report: &BeamsReport) -> Vec<BeamState> {
    let unit = |column: &str| report.unit(column).to_string();
    let units = vec![
        ("force", unit("N")),
        ("moment", unit("MY_J")),
        ("length", report.length_unit.clone()),
        ("angle", unit("ANGLE")),
        ("energy", unit("ENERGY")),
        ("power", unit("POWER")),
    ];
    report.beams.iter().map(|beam| BeamState { inner: beam.clone(), units: units.clone() }).collect()
}
