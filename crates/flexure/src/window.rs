//! What a command window asks a session: whether what is typed is whole, what may follow it, and help.

pub use commands::{Candidate, CommandReference, Completion, ParameterReference, Role};

use crate::session::Session;

impl Session {
    /// Whether a text ends within a block or a continued command, so that more must be typed.
    pub fn is_incomplete(&mut self, text: &str) -> bool {
        self.interpreter.is_incomplete(text)
    }

    /// Lets history begin here: what was done so far, such as reading a file, is not taken back.
    pub fn forget_steps(&mut self) {
        self.interpreter.database.flush_history();
    }

    /// What may stand at the end of half-typed text.
    pub fn complete(&self, text: &str) -> Completion {
        self.interpreter.complete(text)
    }

    /// Whether `?` at the end of a text asks what may follow.
    pub fn asks_for_help(&self, text: &str) -> bool {
        self.interpreter.asks_for_help(text)
    }

    /// What `?` shows at the end of a text.
    pub fn question(&self, text: &str) -> Vec<String> {
        self.interpreter.question(text)
    }

    /// What `help` shows, with the words behind it.
    pub fn help(&self, words: &[&str]) -> Vec<String> {
        self.interpreter.help_lines(words)
    }

    /// A command and its parameters as data; `None` where there is no such command.
    pub fn reference(&self, words: &[&str]) -> Option<CommandReference> {
        self.interpreter.reference(words)
    }
}
