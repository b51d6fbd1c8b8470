//! The session: one interpreter with its models, and what users do with it.

use std::io::{self, Write};
use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use commands::{Interpreter, OnError};
use dataset::Digits;
use elements::Finding;
use elements::forces::beam::Angles;
use model::{Database, ObjectId};
use results::Polyline;
use text::{Diagnostic, Format, Sources, render};

use crate::assign::{self, AttributeInput};
use crate::attributes::{self, Attribute};
use crate::beams::{self, BeamsAt, BeamsReport};
use crate::compare_models::{ModelDifferences, Side, compare_models};
use crate::engine::{Engine, write_data_set};
use crate::files;
use crate::host::EngineHost;
use crate::modes::{ModesAbout, ModesReport};
use crate::persistence::Persistence;
use crate::run::{Run, RunObserver};
use crate::settings::SimulationOptions;

pub use commands::Report;

/// What verification found: the report in Adams' words, and findings with their mending.
#[derive(Clone, Debug, Default)]
pub struct Verification {
    pub report: Vec<String>,
    pub findings: Vec<Finding>,
}

/// A session.
pub struct Session {
    pub(crate) interpreter: Interpreter,
    engine: Arc<Mutex<Engine>>,
    journal: Option<JournalFile>,
    pub(crate) persistence: Persistence,
}

struct JournalFile {
    file: std::fs::File,
    /// Lines written so far.
    written: usize,
}

impl Default for Session {
    fn default() -> Self {
        Self::new()
    }
}

impl Session {
    pub fn new() -> Session {
        let engine = Arc::new(Mutex::new(Engine::default()));
        let mut interpreter = Interpreter::with_host(elements::registry(), Box::new(EngineHost(engine.clone())));
        interpreter.on_error = OnError::IgnoreCommand;
        interpreter.world.allows_changes = true;
        let persistence = Persistence::of(&interpreter.database);
        Session { interpreter, engine, journal: None, persistence }
    }

    pub(crate) fn engine(&self) -> MutexGuard<'_, Engine> {
        lock(&self.engine)
    }

    // ---- how the session behaves ----

    /// Whether a file is left at its first error; otherwise the command is dropped.
    pub fn abort_on_error(&mut self, abort: bool) {
        self.interpreter.on_error = if abort { OnError::AbortFile } else { OnError::IgnoreCommand };
    }

    /// How many passes a loop may have before it is taken for endless and stopped.
    pub fn limit_passes(&mut self, most: u64) {
        self.interpreter.most_passes = most;
    }

    /// Whether simulations that commands ask for are left out, and whatever functions of
    /// expressions would change outside the model: files, folders, the environment.
    pub fn simulate_nothing(&mut self, nothing: bool) {
        self.interpreter.world.allows_changes = !nothing;
        self.engine().idle = nothing;
    }

    /// Whether commands leave everything outside of the session alone: nothing is simulated and no
    /// file is written.
    pub fn touch_nothing(&mut self, nothing: bool) {
        self.interpreter.world.allows_changes = !nothing;
        let mut engine = self.engine();
        engine.idle = nothing;
        engine.read_only = nothing;
    }

    /// Whether runs record every part, joint, motion and force beside requests and measures.
    pub fn record_everything(&mut self, all: bool) {
        self.engine().lowering.record_all = all;
    }

    /// Whether runs record what goes through every beam, its energy and the power it takes, beside
    /// requests and measures.
    pub fn record_beams(&mut self, beams: bool) {
        self.engine().lowering.record_beams = beams;
    }

    /// How LINEAR and STRING beams measure the rotation of I from J. All agree for small angles.
    pub fn measure_beam_angles(&mut self, angles: Angles) {
        self.engine().lowering.beam_angles = angles;
    }

    /// How LINEAR and STRING beams measure the rotation of I from J at present.
    pub fn beam_angles(&self) -> Angles {
        self.engine().lowering.beam_angles
    }

    /// Whether NONLINEAR beams shear at present.
    pub fn nonlinear_beams_shear(&self) -> bool {
        self.engine().lowering.nonlinear_shear
    }

    /// Whether NONLINEAR beams shear by their shear ratios. Adams' do not (Euler and Bernoulli).
    pub fn shear_nonlinear_beams(&mut self, shear: bool) {
        self.engine().lowering.nonlinear_shear = shear;
    }

    /// A flag that stops execution before the next command.
    pub fn set_interrupt(&mut self, flag: Arc<AtomicBool>) {
        self.interpreter.set_interrupt_flag(flag);
    }

    /// Who watches the runs from now on.
    pub fn set_observer(&mut self, observer: Box<dyn RunObserver>) {
        self.engine().observer = observer;
    }

    /// Writes a journal in the layout of `aview.log` from now on.
    ///
    /// # Errors
    /// If the file cannot be created.
    pub fn keep_journal(&mut self, path: &Path) -> io::Result<()> {
        let file = std::fs::File::create(path)?;
        self.interpreter.journal = Some(commands::Journal::default());
        self.journal = Some(JournalFile { file, written: 0 });
        Ok(())
    }

    /// Appends what the journal has grown by; a journal that cannot be written is a warning.
    fn write_journal(&mut self, report: &mut Report) {
        let (Some(target), Some(journal)) = (&mut self.journal, &self.interpreter.journal) else { return };
        let lines = journal.lines_from(target.written);
        let text: String = lines.iter().flat_map(|line| [line.as_str(), "\n"]).collect();
        if let Err(error) = target.file.write_all(text.as_bytes()).and_then(|()| target.file.flush()) {
            report
                .diagnostics
                .push(Diagnostic::warning("file/cannot-write", format!("cannot write the journal: {error}")));
            self.journal = None;
            return;
        }
        target.written += lines.len();
    }

    /// Runs something on the interpreter and keeps the journal file up to date.
    pub(crate) fn journalled(&mut self, command: &str, run: impl FnOnce(&mut Interpreter) -> Report) -> Report {
        let mut report = run(&mut self.interpreter);
        self.write_journal(&mut report);
        self.save(&mut report, command);
        report
    }

    // ---- reading and executing ----

    /// Executes command text.
    pub fn execute(&mut self, text: &str) -> Report {
        self.journalled(text, |interpreter| interpreter.execute(text))
    }

    /// Takes the last step back; false if there is none.
    pub fn undo(&mut self) -> bool {
        let undone = self.interpreter.undo();
        self.save(&mut Report { executed: usize::from(undone), ..Report::default() }, "undo backward");
        undone
    }

    /// Does the step undone last again; false if there is none.
    pub fn redo(&mut self) -> bool {
        let redone = self.interpreter.redo();
        self.save(&mut Report { executed: usize::from(redone), ..Report::default() }, "undo forward");
        redone
    }

    // ---- looking ----

    pub fn sources(&self) -> &Sources {
        &self.interpreter.sources
    }

    pub fn database(&self) -> &Database {
        &self.interpreter.database
    }

    /// Diagnostics as the terminal shows them.
    pub fn render(&self, diagnostics: &[Diagnostic], colour: bool) -> String {
        render(self.sources(), diagnostics, Format::Terminal { colours: colour })
    }

    /// The current model.
    pub fn model(&self) -> Option<ObjectId> {
        self.database().current("model")
    }

    /// Name of the current model, without dot.
    pub fn model_name(&self) -> Option<String> {
        Some(self.database().object(self.model()?).name.clone())
    }

    /// Full names of the models beside the current one.
    pub fn other_models(&self) -> Vec<String> {
        let (database, current) = (self.database(), self.model());
        let models = database.roots().iter().filter(|id| database.object(**id).class.is("model"));
        models.filter(|id| Some(**id) != current).map(|id| database.full_name(*id)).collect()
    }

    /// Full names of all objects of a class or family below the current model.
    pub fn objects(&self, wanted: &str) -> Vec<String> {
        let database = self.database();
        self.model()
            .map(|m| database.below(m, wanted))
            .unwrap_or_default()
            .into_iter()
            .map(|id| database.full_name(id))
            .collect()
    }

    /// Full name of an object given by full name, partial path or short name.
    pub fn resolve(&self, name: &str, wanted: &str) -> Option<String> {
        attributes::resolve(self.database(), self.model(), name, wanted).map(|id| self.database().full_name(id))
    }

    /// Names of the attributes of an object: the parameters of its commands.
    pub fn attributes(&self, object: &str) -> Vec<String> {
        attributes::names(self.database(), object)
    }

    /// An attribute in model units.
    pub fn attribute(&self, object: &str, name: &str) -> Option<Attribute> {
        attributes::read(self.database(), object, name)
    }

    /// Sets attributes by the commands that modify objects of the class. If one is refused, none is set.
    pub fn modify(&mut self, object: &str, values: &[(String, AttributeInput)]) -> Report {
        let commands = match assign::modify_commands(self.database(), object, values) {
            Ok(commands) => commands,
            Err(diagnostic) => return refused(diagnostic),
        };
        let mut total = Report::default();
        for command in commands {
            let report = self.execute(&command);
            let failed = report.has_errors();
            total.diagnostics.extend(report.diagnostics);
            total.failed += report.failed;
            if failed {
                for _ in 0..std::mem::take(&mut total.executed) {
                    self.undo();
                }
                break;
            }
            total.executed += report.executed;
        }
        total
    }

    /// Gives an object another name; references follow.
    pub fn rename(&mut self, object: &str, name: &str) -> Report {
        match assign::rename_command(self.database(), object, name) {
            Ok(command) => self.execute(&command),
            Err(diagnostic) => refused(diagnostic),
        }
    }

    /// Lines that draw the current model, in global axes.
    pub fn drawing(&self) -> Vec<Polyline> {
        self.model().map(|m| elements::draw::draw_model(self.database(), m).0).unwrap_or_default()
    }

    /// What of the current model is not in its drawing, and why.
    pub fn not_drawn(&self) -> Vec<Diagnostic> {
        self.model().map(|m| elements::draw::draw_model(self.database(), m).1).unwrap_or_default()
    }

    /// The global axis that points up: against gravity, or z without gravity.
    pub fn up_axis(&self) -> usize {
        let database = self.database();
        let gravity = self.model().and_then(|m| database.below(m, "gravity").first().copied());
        let component = |name| gravity.and_then(|g| database.number(g, name)).unwrap_or(0.0).abs();
        let sizes = ["x_component_gravity", "y_component_gravity", "z_component_gravity"].map(component);
        (0..3).max_by(|a, b| sizes[*a].total_cmp(&sizes[*b])).unwrap_or(2)
    }

    /// What is different in the current model of another session. A difference of numbers up to
    /// `tolerance`, relative to their size, does not count.
    ///
    /// # Errors
    /// If either session has no model.
    pub fn compare(&self, other: &Session, tolerance: f64) -> Result<ModelDifferences, Vec<Diagnostic>> {
        let (a, b) = (self.model_or_error()?, other.model_or_error()?);
        let (kept_a, kept_b) = (self.interpreter.kept_commands(a), other.interpreter.kept_commands(b));
        let a = Side { database: self.database(), model: a, kept: &kept_a };
        let b = Side { database: other.database(), model: b, kept: &kept_b };
        Ok(compare_models(a, b, tolerance))
    }

    // ---- doing ----

    /// Simulates the current model from its modelled state, or from where the last analysis of the
    /// unchanged model left it.
    ///
    /// # Errors
    /// What is wrong with the model, or why the solver gave up.
    pub fn simulate(&mut self, options: &SimulationOptions) -> Result<Run, Vec<Diagnostic>> {
        let model = self.model_or_error()?;
        let database = &self.interpreter.database;
        lock(&self.engine).simulate(database, model, options)
    }

    /// What goes through every beam of the current model, in one state.
    pub fn beams(&mut self, at: &BeamsAt) -> Result<BeamsReport, Vec<Diagnostic>> {
        let model = self.model_or_error()?;
        if let BeamsAt::Table { table, time } = at {
            return beams::from_table(self.database(), model, table, *time);
        }
        let mut engine = lock(&self.engine);
        let run = engine.beams_run(&self.interpreter.database, model, at)?;
        let mut report = beams::from_table(&self.interpreter.database, model, &run.table, None)?;
        report.diagnostics = run.diagnostics;
        Ok(report)
    }

    /// Linear modes about the modelled state, the static equilibrium or a steady spin.
    ///
    /// # Errors
    /// As [`Session::simulate`].
    pub fn modes(&mut self, about: &ModesAbout) -> Result<ModesReport, Vec<Diagnostic>> {
        let model = self.model_or_error()?;
        let database = &self.interpreter.database;
        lock(&self.engine).modes(database, model, about)
    }

    /// Runs made since the last call.
    pub fn take_runs(&mut self) -> Vec<Run> {
        std::mem::take(&mut self.engine().runs)
    }

    /// Degrees of freedom, redundant constraints, and the traps.
    pub fn verify(&self) -> Verification {
        let Some(model) = self.model() else { return Verification::default() };
        let lowering = self.engine().lowering;
        crate::verify::verify(self.database(), model, lowering)
    }

    /// Executes the commands that mend findings.
    pub fn fix(&mut self, found: &Verification) -> Report {
        let mut total = Report::default();
        for command in found.findings.iter().filter_map(|f| f.fix.as_deref()) {
            let report = self.execute(command);
            total.executed += report.executed;
            total.failed += report.failed;
            total.diagnostics.extend(report.diagnostics);
        }
        total
    }

    /// Writes the current model as `.cmd`, `.adm` or `.fx`; returns what of the model the file does not hold.
    ///
    /// # Errors
    /// If the format is unknown, no file could stand for the model, or it cannot be written.
    pub fn write(&mut self, path: &Path) -> Result<Vec<Diagnostic>, Vec<Diagnostic>> {
        let extension = path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase()).unwrap_or_default();
        if extension == "fx" {
            return self.write_store(path).map(|()| Vec::new());
        }
        let model = self.model_or_error()?;
        let mut warnings = match extension.as_str() {
            "adm" => write_data_set(&mut self.interpreter.database, model, path, Digits::Exact)?,
            "cmd" => {
                let text = self.interpreter.write_model(model);
                files::write(path, text).map_err(|e| vec![cannot_write(path, &e)])?;
                Vec::new()
            }
            other => {
                return Err(vec![
                    Diagnostic::error("file/unknown-format", format!("a model cannot be written as `.{other}`"))
                        .help("`.cmd`, `.adm` and `.fx` are written"),
                ]);
            }
        };
        let others = self.other_models();
        if let Some(first) = others.first() {
            let (current, names) = (self.database().full_name(model), others.join(", "));
            warnings.push(
                Diagnostic::warning("file/other-models", format!("{} does not hold {names}", path.display()))
                    .note(format!("such a file holds one model, here the current one, {current}"))
                    .help(format!("`model display model_name = {first}` makes another the current one"))
                    .help("a `.fx` file holds all models of a session"),
            );
        }
        Ok(warnings)
    }

    fn model_or_error(&self) -> Result<ObjectId, Vec<Diagnostic>> {
        self.model().ok_or_else(|| {
            let help = "`model create model_name = ...` or reading a command file makes one";
            vec![Diagnostic::error("model/none", "there is no model").help(help)]
        })
    }
}

/// The report of something that was refused as a whole.
pub(crate) fn refused(refusal: Diagnostic) -> Report {
    Report { failed: 1, diagnostics: vec![refusal], ..Report::default() }
}

pub(crate) fn cannot_write(path: &Path, error: &io::Error) -> Diagnostic {
    Diagnostic::error("file/cannot-write", format!("cannot write {}: {error}", path.display()))
}

pub(crate) fn lock(engine: &Mutex<Engine>) -> MutexGuard<'_, Engine> {
    engine.lock().unwrap_or_else(PoisonError::into_inner)
}
