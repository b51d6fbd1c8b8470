//! What the interpreter asks of the rooms it may not see: to simulate, to verify, to write data
//! sets. The facade implements [`Host`].

use std::path::{Path, PathBuf};

use model::{CellKey, Database, ObjectId};
use schema::Registry;
use text::{Diagnostic, FileId, Sources, Span};

/// The kind of a simulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SimulationKind {
    /// Kinematic where no degree of freedom is left, dynamic otherwise.
    Auto,
    Dynamic,
    Kinematic,
    /// Static solutions over a range of time.
    Static,
    /// One static solution at the present time.
    Equilibrium,
    /// Initial conditions only.
    Assemble,
    /// Linear modes about the present state.
    Eigen,
    /// Back to the state as modelled.
    Reset,
}

/// How output times are chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OutputTimes {
    /// Number of steps.
    Steps(u64),
    /// Time between outputs in seconds.
    Every(f64),
}

/// One run of the solver. All times in seconds.
#[derive(Clone, Debug, PartialEq)]
pub struct SimulationRequest {
    pub model: ObjectId,
    pub kind: SimulationKind,
    /// Absolute end time.
    pub end: Option<f64>,
    /// Time to go from the present one; given instead of `end`.
    pub duration: Option<f64>,
    pub output: OutputTimes,
    /// A static solution first.
    pub initial_static: bool,
    /// Name of the analysis the results go to.
    pub analysis_name: Option<String>,
    /// Settings of this run as solver commands give them: (`INTEGRATOR`, `ERROR`, `1E-5`).
    pub settings: Vec<(String, String, String)>,
}

impl SimulationRequest {
    pub fn new(model: ObjectId, kind: SimulationKind) -> Self {
        SimulationRequest {
            model,
            kind,
            end: None,
            duration: None,
            output: OutputTimes::Steps(10),
            initial_static: false,
            analysis_name: None,
            settings: Vec::new(),
        }
    }
}

/// Mass of a body in its own axes, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyMass {
    pub mass: f64,
    /// Centre of mass from the body's origin.
    pub centre: glam::DVec3,
    /// About the centre of mass.
    pub inertia: glam::DMat3,
}

/// A model read from a solver data set.
#[derive(Clone, Debug)]
pub struct DataSet {
    pub model: ObjectId,
    /// Where the functions of its objects stand in the text.
    pub functions: Vec<(CellKey, Span)>,
    /// What of the data set was not understood, or has no place in the model.
    pub diagnostics: Vec<Diagnostic>,
}

/// What the interpreter cannot do itself.
pub trait Host: Send {
    fn simulate(&mut self, database: &mut Database, request: &SimulationRequest) -> Result<(), Vec<Diagnostic>>;

    /// Writes the solver data set of a model; ids that were 0 are assigned and kept.
    fn write_data_set(&mut self, database: &mut Database, model: ObjectId, path: &Path) -> Result<(), Vec<Diagnostic>>;

    /// Reads a solver data set, a text among the sources, as a new model of that name (or of the
    /// name it gives itself, or of the file's).
    fn read_data_set(
        &mut self,
        _database: &mut Database,
        _registry: &Registry,
        (sources, file): (&Sources, FileId),
        _model_name: Option<&str>,
    ) -> Result<DataSet, Vec<Diagnostic>> {
        Err(vec![unavailable(&format!("reading the data set `{}`", sources.name(file)))])
    }

    /// Why a file that a command wants to run holds no commands.
    fn refuse_commands(&self, _path: &Path, _bytes: &[u8]) -> Option<Diagnostic> {
        None
    }

    /// The lines of the verification report, and findings.
    fn verify(&mut self, database: &Database, model: ObjectId) -> (Vec<String>, Vec<Diagnostic>);

    /// Gives an id to every object below `model` that has none.
    fn generate_ids(&mut self, _database: &mut Database, _model: ObjectId) -> Result<(), Vec<Diagnostic>> {
        Err(vec![unavailable("numbering ids")])
    }

    /// What the last simulation warned of, for the journal.
    fn take_warnings(&mut self) -> Vec<Diagnostic> {
        Vec::new()
    }

    /// Writes a file that a command names. Everything that a command leaves outside of the session
    /// goes through the host, so that a session that only looks leaves nothing.
    fn write_file(&mut self, path: &Path, text: &str) -> std::io::Result<()> {
        std::fs::write(path, text)
    }

    /// What a body weighs, by its own values or by its shapes.
    fn mass_properties(&self, _database: &Database, _body: ObjectId) -> Result<BodyMass, Vec<Diagnostic>> {
        Err(vec![unavailable("the mass of a body")])
    }

    /// Natural frequencies, Hz, of the model that commands build in a session of their own.
    fn natural_frequencies(&self, _commands: &str) -> Result<Vec<f64>, Vec<Diagnostic>> {
        Err(vec![unavailable("the frequencies of a model")])
    }

    /// Whether commands may write files; a session that only checks leaves them alone.
    fn may_write(&self) -> bool {
        true
    }

    /// Lines for the information window.
    fn show(&mut self, _lines: &[String]) {}

    /// Where a file that a command names is; relative paths are relative to the working folder.
    fn resolve(&self, path: &str) -> PathBuf {
        PathBuf::from(path)
    }
}

/// A host that refuses everything: for reading and checking models.
#[derive(Debug, Default)]
pub struct NoHost;

impl Host for NoHost {
    fn simulate(&mut self, _: &mut Database, _: &SimulationRequest) -> Result<(), Vec<Diagnostic>> {
        Err(vec![unavailable("a simulation")])
    }

    fn write_data_set(&mut self, _: &mut Database, _: ObjectId, _: &Path) -> Result<(), Vec<Diagnostic>> {
        Err(vec![unavailable("writing a data set")])
    }

    fn verify(&mut self, _: &Database, _: ObjectId) -> (Vec<String>, Vec<Diagnostic>) {
        (Vec::new(), vec![unavailable("verification")])
    }
}

fn unavailable(what: &str) -> Diagnostic {
    Diagnostic::error("host/not-available", format!("{what} is not available in this session"))
}
