//! The session: its database, its commands, what it has to report.

use std::{
    path::Path,
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
};

use model::{CellKey, Database, ObjectId};
use schema::Registry;
use syntax::command::Parser;
use text::{Diagnostic, FileId, Sources, Span};

use crate::{
    blocks::{Blocks, Control},
    host::{Host, NoHost},
    journal::Journal,
    kept::Kept,
    macros::Macros,
    names::Names,
    program::Program,
    tree::CommandTree,
};

/// What happens after a command that failed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum OnError {
    /// The file that holds it is left.
    #[default]
    AbortFile,
    /// It is dropped, and the next one runs.
    IgnoreCommand,
    /// The faulty argument is taken as not given.
    ContinueCommand,
}

/// What came of running commands.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// Commands that were executed.
    pub executed: usize,
    /// Commands that are understood but not executed.
    pub skipped: usize,
    /// Commands that failed.
    pub failed: usize,
    /// Whether a file was left because of an error.
    pub aborted: bool,
    /// Whether the run was interrupted from outside.
    pub interrupted: bool,
    /// Whether a command asked for the session to end.
    pub ended: bool,
    pub diagnostics: Vec<Diagnostic>,
}

impl Report {
    pub fn has_errors(&self) -> bool {
        self.failed > 0 || self.aborted || self.interrupted || self.diagnostics.iter().any(Diagnostic::is_error)
    }
}

/// Where execution goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Flow {
    Next,
    Break,
    Continue,
    /// The command was understood and named, but not executed; counted apart from executed ones.
    Skipped,
    /// Leave the current macro or file.
    Return,
    /// Leave the file because of an error.
    Abort,
}

/// Name of the group of what is selected, which every session has.
pub(crate) const SELECT_LIST: &str = "SELECT_LIST";

/// Passes of one loop before it is taken for endless, unless a session says otherwise.
const MOST_PASSES: u64 = 10_000_000;

/// Blocks stand in each other up to this depth; calls count twice.
const DEEPEST_BLOCK: usize = 250;

/// An interpreter of commands.
pub struct Interpreter {
    pub database: Database,
    pub sources: Sources,
    pub on_error: OnError,
    pub journal: Option<Journal>,
    /// Clock, files, environment and messages of expressions. At first it may be looked at only.
    pub world: expressions::World,
    pub(crate) registry: Registry,
    pub(crate) tree: CommandTree,
    pub(crate) host: Box<dyn Host>,
    pub(crate) report: Report,
    pub(crate) names: Names,
    /// Where run-time functions were given, for what is found in them later.
    pub(crate) function_places: rustc_hash::FxHashMap<CellKey, Span>,
    pub(crate) macros: Macros,
    /// Statements whose files or macros are being read, outermost first.
    pub(crate) trace: Vec<Span>,
    /// Where calls have come too deep, if they have.
    pub(crate) depth: crate::depth::Depth,
    /// Names of objects that skipped commands would have made, in lower case.
    pub(crate) unmade: std::collections::HashSet<String>,
    /// Names of parts and models below which skipped commands would have read solids, in lower case.
    pub(crate) unmade_solids: Vec<String>,
    /// Skipped commands that are pieces of models, in the order in which they were read.
    pub(crate) kept: Vec<Kept>,
    /// Kinds of skipped commands in this run: where the warning about each stands in the report, and
    /// how many there were.
    pub(crate) skipped_kinds: indexmap::IndexMap<String, (usize, usize)>,
    /// Files that `file text open` has opened, in that order.
    pub(crate) text_files: Vec<crate::verbs::text_file::TextFile>,
    pub(crate) undo_blocks: usize,
    /// The fewest finished steps of undo since the outermost block began.
    pub(crate) fewest_steps: usize,
    pub(crate) suppress_undo: bool,
    /// Whether the statement or block opener at the outermost level of a program was refused.
    pub(crate) unit_refused: bool,
    /// Depth of blocks, for the journal; negative in the journal while skipping.
    pub(crate) block_depth: usize,
    /// Passes of one loop before it is taken for endless.
    pub most_passes: u64,
    /// Files whose commands take what is missing from the line behind them.
    pub(crate) asking: std::collections::HashSet<FileId>,
    /// The file in which lines were taken as answers, and where the last of them ends.
    pub(crate) answered: Option<(FileId, u32)>,
    interrupt: Arc<AtomicBool>,
}

impl Interpreter {
    /// A session with an empty database that can do everything but simulate.
    pub fn new(registry: Registry) -> Interpreter {
        Self::with_host(registry, Box::new(NoHost))
    }

    pub fn with_host(mut registry: Registry, host: Box<dyn Host>) -> Interpreter {
        if registry.class(crate::macros::CLASS.id).is_none() {
            registry.classes.push(&crate::macros::CLASS);
        }
        if registry.class(crate::macros::LIBRARY.id).is_none() {
            registry.classes.push(&crate::macros::LIBRARY);
        }
        let tree = CommandTree::new(&registry);
        let world = expressions::World::new(false).with_classes(registry.classes.clone());
        let mut database = Database::default();
        // The library that macros keep their own variables in is there from the start, and so is the
        // group of what is selected.
        let select_list = registry.class("group").map_or(Ok(()), |c| database.create(c, None, SELECT_LIST).map(drop));
        if database.create(&crate::macros::LIBRARY, None, "mdi").is_ok() && select_list.is_ok() {
            database.flush_history();
        }
        Interpreter {
            database,
            sources: Sources::default(),
            on_error: OnError::default(),
            journal: None,
            world,
            registry,
            tree,
            host,
            report: Report::default(),
            names: Names::default(),
            function_places: rustc_hash::FxHashMap::default(),
            macros: Macros::default(),
            trace: Vec::new(),
            depth: crate::depth::Depth::default(),
            unmade: std::collections::HashSet::new(),
            unmade_solids: Vec::new(),
            kept: Vec::new(),
            skipped_kinds: indexmap::IndexMap::new(),
            text_files: Vec::new(),
            undo_blocks: 0,
            fewest_steps: 0,
            suppress_undo: false,
            unit_refused: false,
            block_depth: 0,
            most_passes: MOST_PASSES,
            asking: std::collections::HashSet::new(),
            answered: None,
            interrupt: Arc::new(AtomicBool::new(false)),
        }
    }

    /// The classes of this session.
    pub fn registry(&self) -> &Registry {
        &self.registry
    }

    /// Where a run-time function of an object was given last; none if no command gave it.
    pub fn function_place(&self, object: ObjectId, cell: &str) -> Option<Span> {
        let index = self.database.get(object)?.class.cell_index(cell)?;
        self.function_places.get(&CellKey::new(object, index)).copied()
    }

    /// The commands of this session.
    pub fn commands(&self) -> &CommandTree {
        &self.tree
    }

    /// Lets several interpreters and a signal handler share one flag.
    pub fn set_interrupt_flag(&mut self, flag: Arc<AtomicBool>) {
        self.interrupt = flag;
    }

    /// Runs a command file.
    pub fn run_file(&mut self, path: &Path) -> Report {
        self.report = Report::default();
        match std::fs::read(path) {
            Ok(bytes) => {
                let file = self.sources.add_bytes(path.display().to_string(), bytes);
                self.asking.insert(file);
                if let Some(journal) = &mut self.journal {
                    journal.raw(&format!(
                        "file command read file_name = {}",
                        syntax::command::quote(&path.display().to_string())
                    ));
                }
                self.run_source(file);
            }
            Err(error) => {
                self.report.failed += 1;
                self.report.diagnostics.push(cannot_read(path, &error));
            }
        }
        self.take_report()
    }

    /// Reads the bytes of a solver dataset as the file of that name, which may hold others.
    pub fn read_data_set(&mut self, name: &str, bytes: Vec<u8>) -> Report {
        self.report = Report::default();
        match crate::verbs::read_data_set(self, name, bytes) {
            Ok(()) => self.report.executed += 1,
            Err(troubles) => {
                self.report.failed += 1;
                self.report.diagnostics.extend(troubles);
            }
        }
        self.take_report()
    }

    /// Runs commands from a text that is not a file; `name` appears in diagnostics.
    pub fn run_text(&mut self, name: &str, text: &str) -> Report {
        self.report = Report::default();
        let file = self.sources.add(name, text);
        if let Some(journal) = &mut self.journal {
            journal.expect_typed();
        }
        self.run_source(file);
        self.take_report()
    }

    /// Runs what was typed at a prompt, or given on a command line.
    pub fn execute(&mut self, text: &str) -> Report {
        self.run_text("<command>", text)
    }

    fn take_report(&mut self) -> Report {
        if self.undo_blocks == 0 {
            self.database.finish_step();
        }
        let mut report = std::mem::take(&mut self.report);
        for (kind, (at, count)) in std::mem::take(&mut self.skipped_kinds).into_iter().filter(|(_, (_, n))| *n > 1) {
            if let Some(warning) = report.diagnostics.get_mut(at) {
                warning.notes.push(format!("{} more `{kind}` commands are skipped", count - 1));
            }
        }
        self.say_once(&mut report.diagnostics);
        report
    }

    /// Whether a text ends within a block or a continued command, so that more must be typed.
    pub fn is_incomplete(&mut self, text: &str) -> bool {
        if crate::complete_situation::is_continued(text) {
            return true;
        }
        let mut sources = Sources::default();
        let file = sources.add("<command>", text);
        let program = Program::parse(&sources, file);
        let words = self.tree.next_words(&[], &self.database);
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        !Blocks::of(&program, &words).unclosed.is_empty()
    }

    /// Runs a text from beginning to end; errors have been reported when this returns. Statements
    /// are read as they are needed, so that memory does not grow with the text.
    pub(crate) fn run_source(&mut self, file: FileId) -> Flow {
        if !self.goes_deeper(file) {
            return Flow::Abort;
        }
        let before = self.report.diagnostics.len();
        let words = self.tree.next_words(&[], &self.database);
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        let source = self.sources.share(file);
        let mut parser = Parser::new(file, source.text());
        let mut program = Program::new(&self.sources, file);
        let mut blocks = Blocks::default();
        let journal_state = self.journal.as_mut().map(Journal::begin_program);
        // A file that is read within a block is echoed at the depth of that block.
        let depth = self.block_depth;
        let mut flow = Flow::Next;
        while flow == Flow::Next && blocks.read_unit(&mut program, &mut parser, &words) {
            flow = self.run_unit(&program, &blocks);
            if !blocks.unclosed.is_empty() {
                break; // which was the last one
            }
        }
        if flow != Flow::Abort {
            self.warn_unclosed(&program, &blocks.unclosed);
        }
        self.echo_rest(&program, flow);
        self.block_depth = depth;
        if let (Some(journal), Some(state)) = (&mut self.journal, journal_state) {
            journal.end_program(state);
        }
        // Warnings of block openers have no trace yet.
        self.trace_warnings(before);
        let unwinds = self.comes_back();
        match flow {
            Flow::Abort => {
                self.report.aborted |= !self.report.ended && !unwinds;
                Flow::Abort
            }
            _ => Flow::Next,
        }
    }

    fn warn_unclosed(&mut self, program: &Program, openers: &[usize]) {
        let Some((&first, others)) = openers.split_first() else { return };
        let name = self.sources.name(program.file).to_string();
        let place = |opener: usize| program.statements[opener].statement.span;
        let mut warning = Diagnostic::warning("command/unclosed-block", "this block has no `end`")
            .at(place(first), "opened here")
            .help("close it with a line that holds the word `end` alone")
            .adams(name)
            .adams("The preceding file or macro has an IF, WHILE, or FOR without a matching END.");
        for other in others {
            warning = warning.label(place(*other), "nor has this one");
        }
        self.complain(vec![warning]);
    }

    /// Runs a statement or a block, for the journal to keep what was typed and has not failed.
    fn run_unit(&mut self, program: &Program, blocks: &Blocks) -> Flow {
        let block = matches!(blocks.control.first(), Some(Control::If | Control::While | Control::For));
        let count = program.statements.len();
        let mark = self.journal.as_ref().map(Journal::mark);
        let flow = if block {
            self.as_one_step(|s| s.run_range(program, blocks, 0, count))
        } else {
            self.run_range(program, blocks, 0, count)
        };
        let refused = std::mem::take(&mut self.unit_refused) || flow == Flow::Abort && !block && !self.report.ended;
        if let (Some(journal), Some(mark)) = (&mut self.journal, mark) {
            journal.keep_typed(program, mark, count, refused);
        }
        flow
    }

    /// An outermost block is one step of undo once it has ended, like a macro. While it runs each of
    /// its commands is one, for an `undo backward` in it.
    fn as_one_step(&mut self, run: impl FnOnce(&mut Interpreter) -> Flow) -> Flow {
        let outer = std::mem::replace(&mut self.fewest_steps, self.database.history_depth().0);
        let flow = run(self);
        if self.undo_blocks == 0 {
            self.database.finish_step();
        }
        self.database.join_steps(self.fewest_steps);
        self.fewest_steps = outer.min(self.fewest_steps);
        flow
    }

    /// Runs the statements `from..to`.
    pub(crate) fn run_range(&mut self, program: &Program, blocks: &Blocks, from: usize, to: usize) -> Flow {
        let mut at = from;
        while at < to {
            if self.interrupt.load(Ordering::Relaxed) {
                self.report.interrupted = true;
                let span = program.statements[at].statement.span;
                self.complain(vec![
                    Diagnostic::error("command/interrupted", "interrupted before this command")
                        .at(span, "not executed"),
                ]);
                return Flow::Abort;
            }
            let opens = matches!(blocks.control[at], Control::If | Control::While | Control::For);
            let (flow, next) = match blocks.control[at] {
                _ if opens && self.block_depth + 2 * self.trace.len() >= DEEPEST_BLOCK => {
                    (self.too_deep(program, at), blocks.end[at] + 1)
                }
                Control::If => (self.run_if(program, blocks, at), blocks.end[at] + 1),
                Control::While => (self.run_while(program, blocks, at), blocks.end[at] + 1),
                Control::For => (self.run_for(program, blocks, at), blocks.end[at] + 1),
                _ => (self.run_statement(program, at, blocks.control[at]), at + 1),
            };
            if flow != Flow::Next {
                return flow;
            }
            at = next;
        }
        Flow::Next
    }

    /// Refuses a block: every level costs stack.
    fn too_deep(&mut self, program: &Program, at: usize) -> Flow {
        let span = program.statements[at].statement.span;
        self.failed(vec![
            Diagnostic::error("command/too-deep", "this block stands too deep in other blocks")
                .at(span, "left out")
                .note(format!("at most {DEEPEST_BLOCK} levels are executed")),
        ])
    }

    /// Files diagnostics, each with the calls that led to it, and writes them to the journal.
    pub(crate) fn complain(&mut self, diagnostics: Vec<Diagnostic>) {
        for mut diagnostic in diagnostics {
            crate::depth::add_calls(&mut diagnostic, &self.trace);
            self.report.diagnostics.push(diagnostic);
        }
    }
}

/// The complaint about a file that cannot be read.
pub(crate) fn cannot_read(path: &Path, error: &std::io::Error) -> Diagnostic {
    Diagnostic::error("file/cannot-read", format!("cannot read `{}`: {error}", path.display()))
        .adams(format!("Adams/View could not open the command file '{}' for reading.", path.display()))
}
