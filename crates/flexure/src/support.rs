//! What is run, what is kept, what is not supported: read off the tables.

use std::fmt;

use commands::{Action, Interpreter};

/// What becomes of a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// Executed, and what it makes takes part in simulations.
    Simulated,
    /// Executed; what it makes is kept, drawn or written, and does not move anything.
    Kept,
    /// Executed.
    Executed,
    /// Known, not executed, and reported once for each kind in a run.
    NotSupported,
}

impl fmt::Display for State {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            State::Simulated => "simulated",
            State::Kept => "kept",
            State::Executed => "executed",
            State::NotSupported => "not supported",
        })
    }
}

/// One line of the list.
#[derive(Clone, Debug, PartialEq)]
pub struct Support {
    pub command: String,
    pub state: State,
    pub note: String,
}

/// All commands known, by name.
pub fn support() -> Vec<Support> {
    let interpreter = Interpreter::new(elements::registry());
    let mut list: Vec<Support> = interpreter
        .commands()
        .commands(&interpreter.database)
        .into_iter()
        .map(|command| {
            let of_class = |class| match elements::shelf::element(class) {
                Some(_) => State::Simulated,
                None => State::Kept,
            };
            let path = command.path.to_string();
            let (state, note) = match &command.action {
                Action::Create(class, group) => (of_class(class), group.doc.to_string()),
                Action::Set(groups) => (
                    groups.first().map_or(State::Kept, |(class, _)| of_class(class)),
                    groups.first().map_or_else(String::new, |(_, group)| group.doc.to_string()),
                ),
                Action::Settings(_, group) => (State::Executed, group.doc.to_string()),
                Action::Verb(_) if command.is_refused() => (State::NotSupported, commands::meaning(&path).to_string()),
                Action::Verb(entry) => (State::Executed, entry.verb.doc.to_string()),
                Action::Macro(_) => (State::Executed, "a macro".to_string()),
                Action::Unsupported => (State::NotSupported, commands::meaning(&path).to_string()),
            };
            Support { command: path, state, note }
        })
        .collect();
    list.sort_by(|a, b| a.command.cmp(&b.command));
    list
}
