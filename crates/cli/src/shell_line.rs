//! Where the lines of the command window come from: a terminal with history, Tab and `?`, or a pipe.

use std::borrow::Cow;
use std::io::{BufRead, IsTerminal};
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

use flexure::Session;
use rustyline::completion::{Completer, Pair};
use rustyline::error::ReadlineError;
use rustyline::highlight::Highlighter;
use rustyline::hint::Hinter;
use rustyline::history::FileHistory;
use rustyline::validate::Validator;
use rustyline::{
    Cmd, CompletionType, ConditionalEventHandler, Config, Context, Editor, Event, EventContext, EventHandler, Helper,
    KeyEvent, RepeatCount,
};

/// What came of waiting for a line.
pub(crate) enum Asked {
    Line(String),
    /// Ctrl-C at the prompt: what was typed is dropped.
    Interrupted,
    End,
}

/// A source of lines.
pub(crate) trait Lines {
    /// The next line; `pending` is what was typed of the command so far.
    fn next(&mut self, pending: &str) -> Asked;

    /// A command that was typed, for the history.
    fn remember(&mut self, _command: &str) {}

    /// Whether the dialog goes on after a command was interrupted.
    fn goes_on_when_interrupted(&self) -> bool {
        false
    }
}

/// Standard input that is no terminal: no prompt, no history.
pub(crate) struct Piped;

impl Lines for Piped {
    fn next(&mut self, _: &str) -> Asked {
        let mut bytes = Vec::new();
        match std::io::stdin().lock().read_until(b'\n', &mut bytes) {
            Ok(0) => Asked::End,
            Ok(_) => {
                let text = String::from_utf8(bytes);
                // Old files are in Latin-1, whose letters have the numbers of Unicode.
                let text = text.unwrap_or_else(|e| e.as_bytes().iter().map(|b| char::from(*b)).collect());
                Asked::Line(text.trim_end_matches(['\n', '\r']).to_string())
            }
            Err(error) => {
                crate::commands::complain(format_args!("cannot read standard input: {error}"));
                Asked::End
            }
        }
    }
}

/// A terminal.
pub(crate) struct Typed {
    editor: Editor<Window, FileHistory>,
    history: Option<PathBuf>,
    /// Text before and behind the cursor when `?` asked for help.
    asked: Arc<Mutex<Option<(String, String)>>>,
    session: Arc<Mutex<Session>>,
    pending: Arc<Mutex<String>>,
}

impl Typed {
    /// The terminal, if both sides of the dialog are one.
    pub fn new(session: &Arc<Mutex<Session>>) -> Option<Typed> {
        if !std::io::stdin().is_terminal() || !std::io::stdout().is_terminal() {
            return None;
        }
        let config = Config::builder().completion_type(CompletionType::List).auto_add_history(false).build();
        let mut editor = Editor::with_config(config).ok()?;
        let pending = Arc::new(Mutex::new(String::new()));
        let asked = Arc::new(Mutex::new(None));
        editor.set_helper(Some(Window { session: session.clone(), pending: pending.clone() }));
        let question = Question { session: session.clone(), pending: pending.clone(), asked: asked.clone() };
        editor.bind_sequence(KeyEvent::from('?'), EventHandler::Conditional(Box::new(question)));
        let history = history_path();
        if let Some(path) = &history {
            // There is none the first time.
            let _ = editor.load_history(path);
        }
        Some(Typed { editor, history, asked, session: session.clone(), pending })
    }
}

impl Lines for Typed {
    fn next(&mut self, pending: &str) -> Asked {
        *lock(&self.pending) = pending.to_string();
        // What is open stands where the program's name does.
        let opener = pending.split_whitespace().next().filter(|_| !pending.trim_end().ends_with('&'));
        let prompt = match opener {
            None if pending.is_empty() => "flexure> ".to_string(),
            None => "     ...> ".to_string(),
            Some(word) => format!("{:>5}...> ", word.chars().take(8).collect::<String>()),
        };
        let (mut left, mut right) = (String::new(), String::new());
        loop {
            let outcome = self.editor.readline_with_initial(&prompt, (&left, &right));
            if let Some((before, behind)) = lock(&self.asked).take() {
                let answer = lock(&self.session).question(&format!("{pending}{before}"));
                answer.iter().for_each(|line| println!("{line}"));
                (left, right) = (before, behind);
                continue;
            }
            return match outcome {
                Ok(line) => Asked::Line(line),
                Err(ReadlineError::Interrupted) => Asked::Interrupted,
                Err(_) => Asked::End,
            };
        }
    }

    fn remember(&mut self, command: &str) {
        let added = self.editor.add_history_entry(command);
        if let (Ok(true), Some(path)) = (added, &self.history) {
            if let Some(folder) = path.parent() {
                let _ = std::fs::create_dir_all(folder);
            }
            // A history that cannot be kept is no reason to stop.
            let _ = self.editor.append_history(path);
        }
    }

    fn goes_on_when_interrupted(&self) -> bool {
        true
    }
}

fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// `FLEXURE_HISTORY`, or a file among the user's own.
fn history_path() -> Option<PathBuf> {
    let folder = |name: &str| std::env::var_os(name).filter(|v| !v.is_empty()).map(PathBuf::from);
    folder("FLEXURE_HISTORY").or_else(|| {
        let state = folder("XDG_STATE_HOME")
            .or_else(|| folder("LOCALAPPDATA"))
            .or_else(|| folder("HOME").map(|h| h.join(".local/state")));
        state.map(|s| s.join("flexure").join("history"))
    })
}

/// Completion at the cursor.
struct Window {
    session: Arc<Mutex<Session>>,
    pending: Arc<Mutex<String>>,
}

impl Completer for Window {
    type Candidate = Pair;

    fn complete(&self, line: &str, at: usize, _: &Context<'_>) -> rustyline::Result<(usize, Vec<Pair>)> {
        let pending = lock(&self.pending);
        let text = format!("{pending}{}", line.get(..at).unwrap_or(line));
        let found = lock(&self.session).complete(&text);
        let start = found.start.saturating_sub(pending.len()).min(at);
        let pair = |c: flexure::Candidate| Pair { display: c.text.trim_end().to_string(), replacement: c.text };
        Ok((start, found.candidates.into_iter().map(pair).collect()))
    }
}

impl Hinter for Window {
    type Hint = String;
}

impl Highlighter for Window {
    fn highlight_prompt<'b, 's: 'b, 'p: 'b>(&'s self, prompt: &'p str, _: bool) -> Cow<'b, str> {
        Cow::Borrowed(prompt)
    }
}

impl Validator for Window {}
impl Helper for Window {}

/// The key `?`: ends the line where it asks for help, and is a character elsewhere.
struct Question {
    session: Arc<Mutex<Session>>,
    pending: Arc<Mutex<String>>,
    asked: Arc<Mutex<Option<(String, String)>>>,
}

impl ConditionalEventHandler for Question {
    fn handle(&self, _: &Event, _: RepeatCount, _: bool, context: &EventContext) -> Option<Cmd> {
        let (before, behind) = context.line().split_at(context.pos().min(context.line().len()));
        let text = format!("{}{before}", lock(&self.pending));
        if !lock(&self.session).asks_for_help(&text) {
            return None;
        }
        *lock(&self.asked) = Some((before.to_string(), behind.to_string()));
        Some(Cmd::AcceptLine)
    }
}
