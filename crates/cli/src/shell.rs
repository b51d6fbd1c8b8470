//! `flexure shell`: the command window. Lines are put together to commands, commands are executed one
//! by one; with a `.fx` file each is saved before its outcome is shown.

use std::mem::ManuallyDrop;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

use flexure::{Control, Progress, Run, RunHeader, RunObserver, Session};

use crate::arguments::{Edits, Shell};
use crate::commands::{complain, open, print, session, set_recording};
use crate::output::{Target, extension};
use crate::progress::{Log, Watcher};
use crate::shell_line::{Asked, Lines, Piped, Typed};
use crate::{Outcome, interrupt};

pub(crate) fn execute(shell: &Shell) -> Outcome {
    interrupt::install();
    // This session is taken apart in the end: the file that follows it is closed then.
    let mut session = ManuallyDrop::into_inner(session());
    if let Some(path) = &shell.journal
        && let Err(error) = session.keep_journal(path)
    {
        complain(format_args!("cannot write the journal {}: {error}", path.display()));
        return Outcome::Findings;
    }
    if !begin(&mut session, shell) {
        return Outcome::Findings;
    }
    set_recording(&mut session, shell.record);
    let (watcher, log) = Watcher::new(Target::Folder(shell.out.clone()));
    session.set_observer(Box::new(Window(watcher)));
    let session = Arc::new(Mutex::new(session));
    let typed = Typed::new(&session);
    let mut window = Dialog { session, log, refused: 0 };
    match typed {
        Some(mut typed) => {
            greet(&window);
            window.run(&mut typed);
            // Who types sees what is refused.
            Outcome::Fine
        }
        None => match window.run(&mut Piped) {
            true => Outcome::Interrupted,
            false if window.refused > 0 => Outcome::Findings,
            false => Outcome::Fine,
        },
    }
}

/// Reads the model and opens the file that follows the session. False where there is no session.
fn begin(session: &mut Session, shell: &Shell) -> bool {
    let refuse = |session: &Session, outcome: Result<(), Vec<text::Diagnostic>>| match outcome {
        Ok(()) => true,
        Err(diagnostics) => {
            print(session, &diagnostics);
            false
        }
    };
    if let Some(path) = &shell.model {
        let is_store = extension(path) == "fx";
        if is_store && !shell.read_only {
            let outcome = if path.exists() { session.open(path) } else { session.save_as(path) };
            if !refuse(session, outcome) {
                return false;
            }
        } else {
            session.simulate_nothing(true);
            let sound = open(session, path, &Edits { commands: Vec::new() });
            session.simulate_nothing(false);
            // As for a `.fx` file: what was read is where the session begins.
            session.forget_steps();
            if is_store && !sound || !path.exists() && path.as_path() != Path::new("-") {
                return false;
            }
        }
    }
    let Some(path) = &shell.save else { return true };
    if path.exists() && session.saved_in() != Some(path) && !shell.overwrite {
        complain(format_args!("{} exists; open it, or add --overwrite", path.display()));
        return false;
    }
    let outcome = session.save_as(path);
    refuse(session, outcome)
}

fn greet(dialog: &Dialog) {
    let session = dialog.session.lock().unwrap_or_else(PoisonError::into_inner);
    println!("Flexure {}", env!("CARGO_PKG_VERSION"));
    if let Some(name) = session.model_name() {
        println!("model .{name}");
    }
    if let Some(path) = session.saved_in() {
        println!("every command is saved in {}", path.display());
    }
    println!("Enter a command, '?', or 'help'.");
}

/// Commands of the window itself.
enum Own<'a> {
    Quit,
    Help(Vec<&'a str>),
    /// A word that stands for a command.
    Short(&'static str),
    None,
}

fn own(text: &str) -> Own<'_> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let first = words.first().map(|w| w.to_ascii_lowercase()).unwrap_or_default();
    match (first.as_str(), words.len()) {
        ("quit" | "exit", 1) => Own::Quit,
        ("undo", 1) => Own::Short("undo backward"),
        ("redo", 1) => Own::Short("undo forward"),
        ("help", _) if !text.contains('=') => Own::Help(words[1..].to_vec()),
        _ => Own::None,
    }
}

struct Dialog {
    session: Arc<Mutex<Session>>,
    log: Arc<Mutex<Log>>,
    /// Commands that failed.
    refused: usize,
}

impl Dialog {
    /// Reads and executes until the end; true if it was interrupted from outside.
    fn run(&mut self, lines: &mut dyn Lines) -> bool {
        let mut pending = String::new();
        loop {
            interrupt::wait(true);
            let asked = lines.next(&pending);
            interrupt::wait(false);
            match asked {
                Asked::End => break,
                Asked::Interrupted => pending.clear(),
                Asked::Line(line) => {
                    if let Some(before) = self.asks(&pending, &line) {
                        self.answer(&before);
                        continue;
                    }
                    pending.push_str(&line);
                    pending.push('\n');
                    if self.lock().is_incomplete(&pending) {
                        if let Own::Quit = own(&line) {
                            // It may be meant as a command of the block.
                            let opener = pending.split_whitespace().next().unwrap_or_default();
                            eprintln!("`{opener}` is open and `{}` belongs to it: `end` closes it", line.trim());
                        }
                        continue;
                    }
                    let text = std::mem::take(&mut pending);
                    match self.obey(text.trim_end(), lines) {
                        Some(interrupted) if interrupted => return true,
                        Some(_) => return false,
                        None => {}
                    }
                }
            }
        }
        // What was begun and never ended is executed as far as it goes, as at the end of a file.
        if !pending.trim().is_empty() {
            self.obey(pending.trim_end(), lines);
        }
        false
    }

    fn lock(&self) -> std::sync::MutexGuard<'_, Session> {
        self.session.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// What stands before a `?` that ends a line and asks what may follow.
    fn asks(&self, pending: &str, line: &str) -> Option<String> {
        let before = format!("{pending}{}", line.trim_end().strip_suffix('?')?);
        self.lock().asks_for_help(&before).then_some(before)
    }

    fn answer(&self, before: &str) {
        self.lock().question(before).iter().for_each(|line| println!("{line}"));
    }

    /// Executes one command; `Some` at the end of the session, with whether it was interrupted.
    fn obey(&mut self, text: &str, lines: &mut dyn Lines) -> Option<bool> {
        if text.trim().is_empty() {
            return None;
        }
        lines.remember(text);
        let command = match own(text) {
            Own::Quit => return Some(false),
            Own::Help(words) => {
                self.lock().help(&words).iter().for_each(|line| println!("{line}"));
                return None;
            }
            Own::Short(command) => command,
            Own::None => text,
        };
        interrupt::flag().store(false, std::sync::atomic::Ordering::Relaxed);
        let report = self.lock().execute(command);
        print(&self.lock(), &report.diagnostics);
        let errors = report.diagnostics.iter().filter(|d| d.is_error()).count().max(report.failed);
        self.refused += errors;
        let mut log = self.log.lock().unwrap_or_else(PoisonError::into_inner);
        self.refused += log.troubles.len();
        log.troubles.drain(..).for_each(complain);
        log.written.drain(..).for_each(|path| println!("{}", path.display()));
        let interrupted = report.interrupted || std::mem::take(&mut log.interrupted) || interrupt::requested();
        interrupt::flag().store(false, std::sync::atomic::Ordering::Relaxed);
        (interrupted && !lines.goes_on_when_interrupted()).then_some(true)
    }
}

/// Shows lists on standard output and everything else as other subcommands do.
struct Window(Watcher);

impl RunObserver for Window {
    fn begin(&mut self, header: &RunHeader) {
        self.0.begin(header);
    }

    fn row(&mut self, row: &[f64]) {
        self.0.row(row);
    }

    fn progress(&mut self, progress: &Progress) -> Control {
        self.0.progress(progress)
    }

    fn message(&mut self, text: &str) {
        self.0.aside(|| println!("{text}"));
    }

    fn end(&mut self, run: &Run) {
        self.0.end(run);
    }
}
