//! What the interpreter asks of the engine: runs, datasets, files, masses, frequencies.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

use commands::{BodyMass, DataSet, Host, SimulationRequest};
use dataset::Digits;
use model::{Database, ObjectId};
use schema::Registry;
use text::{Diagnostic, FileId, Sources};

use crate::engine::{Engine, data_set, write_data_set};
use crate::files;
use crate::modes::ModesAbout;
use crate::reading::refuse_dataset;
use crate::session::{Session, lock};

/// What the interpreter asks of the engine.
pub(crate) struct EngineHost(pub Arc<Mutex<Engine>>);

impl Host for EngineHost {
    fn simulate(&mut self, database: &mut Database, request: &SimulationRequest) -> Result<(), Vec<Diagnostic>> {
        lock(&self.0).obey(database, request)
    }

    fn take_warnings(&mut self) -> Vec<Diagnostic> {
        std::mem::take(&mut lock(&self.0).warnings)
    }

    fn write_data_set(&mut self, database: &mut Database, model: ObjectId, path: &Path) -> Result<(), Vec<Diagnostic>> {
        let read_only = lock(&self.0).read_only;
        let warnings =
            if read_only { data_set(database, model)? } else { write_data_set(database, model, path, Digits::View)? };
        let mut engine = lock(&self.0);
        warnings.iter().for_each(|w| engine.observer.message(&text::one_line(&Sources::default(), w)));
        Ok(())
    }

    fn read_data_set(
        &mut self,
        database: &mut Database,
        registry: &Registry,
        (sources, file): (&Sources, FileId),
        model_name: Option<&str>,
    ) -> Result<DataSet, Vec<Diagnostic>> {
        let stem = Path::new(sources.name(file)).file_stem().map(|stem| stem.to_string_lossy().into_owned());
        let otherwise = stem.unwrap_or_default();
        let naming = dataset::Naming { model: model_name, otherwise: &otherwise };
        let read = dataset::read(database, registry, file, sources.text(file), naming)?;
        Ok(DataSet { model: read.model, functions: read.functions, diagnostics: read.diagnostics })
    }

    fn refuse_commands(&self, path: &Path, bytes: &[u8]) -> Option<Diagnostic> {
        refuse_dataset(&path.display().to_string(), bytes)
    }

    fn verify(&mut self, database: &Database, model: ObjectId) -> (Vec<String>, Vec<Diagnostic>) {
        let lowering = lock(&self.0).lowering;
        let found = crate::verify::verify(database, model, lowering);
        (found.report, found.findings.into_iter().map(|f| f.diagnostic).collect())
    }

    fn generate_ids(&mut self, database: &mut Database, model: ObjectId) -> Result<(), Vec<Diagnostic>> {
        dataset::number_objects(database, model)
    }

    fn write_file(&mut self, path: &Path, text: &str) -> io::Result<()> {
        if lock(&self.0).read_only { Ok(()) } else { files::write(path, text) }
    }

    fn may_write(&self) -> bool {
        !lock(&self.0).read_only
    }

    fn mass_properties(&self, database: &Database, body: ObjectId) -> Result<BodyMass, Vec<Diagnostic>> {
        let found = elements::bodies::part::lower::mass_properties(database, body)?;
        Ok(BodyMass { mass: found.mass, centre: found.centre, inertia: found.inertia_c_b })
    }

    fn natural_frequencies(&self, commands: &str) -> Result<Vec<f64>, Vec<Diagnostic>> {
        let mut session = Session::new();
        session.touch_nothing(true);
        let report = session.execute(commands);
        let found = if report.has_errors() { Err(report.diagnostics) } else { session.modes(&ModesAbout::Present) };
        match found {
            Ok(found) => Ok(found.modes.iter().map(|m| m.frequency_hz).collect()),
            Err(mut diagnostics) => {
                // Places in that session's text mean nothing in this one.
                for diagnostic in &mut diagnostics {
                    diagnostic.primary = None;
                    diagnostic.secondary.clear();
                }
                Err(diagnostics)
            }
        }
    }

    fn show(&mut self, lines: &[String]) {
        let mut engine = lock(&self.0);
        lines.iter().for_each(|line| engine.observer.listing(line));
    }

    fn resolve(&self, path: &str) -> PathBuf {
        lock(&self.0).resolve(path)
    }
}
