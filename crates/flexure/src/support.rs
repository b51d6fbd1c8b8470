//! What is run, what is kept, what is not supported: read off the tables.

use std::fmt;

use schema::Registry;

/// What becomes of a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// Executed, and what it makes takes part in simulations.
    Simulated,
    /// Executed; what it makes is kept, drawn or written, and does not move anything.
    Kept,
    /// Executed.
    Executed,
}

impl fmt::Display for State {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            State::Simulated => "simulated",
            State::Kept => "kept",
            State::Executed => "executed",
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

/// All commands that are executed. A command that is not in the list is reported by name when it
/// occurs.
pub fn support() -> Vec<Support> {
    let registry: Registry = elements::registry();
    let mut list: Vec<Support> = Vec::new();
    for class in &registry.classes {
        let state = if elements::shelf::element(class).is_some() { State::Simulated } else { State::Kept };
        for group in class.groups {
            if !list.iter().any(|s| s.command == group.command) {
                list.push(Support { command: group.command.to_string(), state, note: group.doc.to_string() });
            }
        }
    }
    let interpreter = commands::Interpreter::new(registry);
    for verb in &interpreter.registry().verbs {
        list.push(Support { command: verb.path.to_string(), state: State::Executed, note: verb.doc.to_string() });
    }
    list.sort_by(|a, b| a.command.cmp(&b.command));
    list
}
