//! Lets Ctrl-C in Python stop a run, and hands progress to a callable.

use flexure::{Control, Progress, RunObserver};
use pyo3::prelude::*;

pub struct PythonObserver {
    /// Called with the done part (0 to 1) and a sentence; may be none.
    pub progress: Option<Py<PyAny>>,
    /// The exception that stopped the run.
    pub raised: std::sync::Arc<std::sync::Mutex<Option<PyErr>>>,
}

impl RunObserver for PythonObserver {
    fn progress(&mut self, progress: &Progress) -> Control {
        let outcome = Python::attach(|py| {
            py.check_signals()?;
            match &self.progress {
                Some(callable) => callable.call1(py, (progress.fraction(), progress.to_string())).map(|_| ()),
                None => Ok(()),
            }
        });
        match outcome {
            Ok(()) => Control::Continue,
            Err(error) => {
                if let Ok(mut raised) = self.raised.lock() {
                    *raised = Some(error);
                }
                Control::Stop
            }
        }
    }
}
