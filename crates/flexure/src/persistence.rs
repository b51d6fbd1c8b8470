//! Models kept in `.fx` files: reading and writing them whole, and sessions that are saved with every
//! command they accept.

use std::path::Path;

use commands::{Interpreter, OnError};
use model::{Database, Settings};
use store::{Content, Store};
use text::Diagnostic;

use crate::session::{Report, Session};

/// What a session remembers for the sake of files.
pub(crate) struct Persistence {
    /// The file that every accepted command goes to.
    store: Option<Store>,
    /// Commands accepted so far; those in `store` are counted only there.
    accepted: Vec<String>,
    /// The database as a new session has it: a file can be read into it as it is.
    first: (u64, Settings),
}

impl Persistence {
    pub(crate) fn of(database: &Database) -> Persistence {
        Persistence { store: None, accepted: Vec::new(), first: (database.revision(), database.settings().clone()) }
    }
}

impl Session {
    /// Opens a `.fx` file into this new session; from then on every accepted command is saved in it
    /// before its report is given.
    ///
    /// # Errors
    /// If another session holds the file, if it is damaged, or if this session has begun already.
    pub fn open(&mut self, path: &Path) -> Result<(), Vec<Diagnostic>> {
        if !self.is_untouched() {
            let text = format!("{} cannot be opened in a session that has a model", path.display());
            return Err(vec![Diagnostic::error("store/session-begun", text).help("open it in a new session")]);
        }
        let (store, content) = Store::open(path, self.interpreter.registry()).map_err(|d| vec![d])?;
        self.take_content(path, content)?;
        self.persistence.store = Some(store);
        self.persistence.accepted.clear();
        Ok(())
    }

    /// Writes the session to a `.fx` file and saves every accepted command in it from then on.
    ///
    /// # Errors
    /// If another session holds the file or it cannot be written.
    pub fn save_as(&mut self, path: &Path) -> Result<(), Vec<Diagnostic>> {
        // The file may be the one that is followed now.
        if let Some(old) = self.persistence.store.take()
            && old.path() == path
        {
            self.persistence.store = Some(old);
            return Ok(());
        }
        let state = self.interpreter.state();
        let registry = self.interpreter.registry().clone();
        let journal = std::mem::take(&mut self.persistence.accepted);
        match Store::create(path, &registry, &mut self.interpreter.database, &state, &journal) {
            Ok(store) => {
                self.persistence.store = Some(store);
                Ok(())
            }
            Err(diagnostic) => {
                self.persistence.accepted = journal;
                Err(vec![diagnostic])
            }
        }
    }

    /// The file that follows this session.
    pub fn saved_in(&self) -> Option<&Path> {
        self.persistence.store.as_ref().map(Store::path)
    }

    /// Saves what a command has changed, before anybody is told that it was accepted.
    pub(crate) fn save(&mut self, report: &mut Report, command: &str) {
        let accepted = report.executed + report.skipped > 0;
        let Some(store) = &mut self.persistence.store else {
            if accepted {
                self.persistence.accepted.push(command.to_string());
            }
            return;
        };
        let state = self.interpreter.state();
        let command = accepted.then_some(command);
        if let Err(diagnostic) = store.commit(&mut self.interpreter.database, state, command) {
            report.failed += 1;
            report.diagnostics.push(diagnostic.note("the model in memory has the change, the file has not"));
        }
    }

    /// Reads a `.fx` file: a new session becomes what it holds, another one gets its models.
    pub(crate) fn read_store(&mut self, path: &Path) -> Report {
        let outcome = store::read(path, self.interpreter.registry()).map_err(|d| vec![d]);
        let outcome = match outcome {
            Ok(content) if self.is_untouched() => self.take_content(path, content),
            Ok(content) => return self.merge_content(path, content),
            Err(diagnostics) => Err(diagnostics),
        };
        match outcome {
            Ok(()) => {
                let mut report = Report { executed: 1, ..Report::default() };
                self.save(&mut report, &format!("! read {}", path.display()));
                report
            }
            Err(diagnostics) => Report { failed: 1, diagnostics, ..Report::default() },
        }
    }

    /// Writes all models of the session and its settings.
    pub(crate) fn write_store(&mut self, path: &Path) -> Result<(), Vec<Diagnostic>> {
        if self.saved_in() == Some(path) {
            return Ok(());
        }
        let state = self.interpreter.state();
        store::write(path, &self.interpreter.database, &state, &self.persistence.accepted).map_err(|d| vec![d])
    }

    fn is_untouched(&self) -> bool {
        let (revision, settings) = &self.persistence.first;
        let database = self.database();
        self.persistence.store.is_none() && database.revision() == *revision && database.settings() == settings
    }

    fn take_content(&mut self, path: &Path, content: Content) -> Result<(), Vec<Diagnostic>> {
        let Content { database, session, journal } = content;
        self.interpreter.restore(database, &session).map_err(|what| {
            let text = format!("{} holds something that is not understood; nothing of it was read", path.display());
            vec![Diagnostic::error("store/not-understood", text).note(what)]
        })?;
        self.persistence.accepted = journal;
        Ok(())
    }

    /// Models of a file go into a session that has some already as the commands that build them.
    fn merge_content(&mut self, path: &Path, content: Content) -> Report {
        let mut other = Interpreter::new(self.interpreter.registry().clone());
        other.on_error = OnError::IgnoreCommand;
        if let Err(what) = other.restore(content.database, &content.session) {
            let text = format!("{} holds something that is not understood; nothing of it was read", path.display());
            let diagnostic = Diagnostic::error("store/not-understood", text).note(what);
            return Report { failed: 1, diagnostics: vec![diagnostic], ..Report::default() };
        }
        let roots = other.database.roots().iter().copied();
        let models = roots.filter(|id| other.database.object(*id).class.id == "model");
        let text: String = models.map(|model| other.write_model(model)).collect();
        self.read_bytes(&path.display().to_string(), text.into_bytes())
    }
}
