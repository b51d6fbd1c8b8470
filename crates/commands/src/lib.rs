//! The interpreter of the Adams View command language.
//!
//! A [`Program`](program::Program) is a parsed text. [`Interpreter`] runs it: the keywords lead
//! through the [command tree](tree) to an action, arguments are [bound](call) to parameters, and
//! either the tables of a class [create or change objects](objects) or a [verb](verbs) runs. Every
//! command is all or nothing and one step of undo. What is understood but not executed is named in
//! a warning.

mod arguments;
mod blocks;
mod call;
mod complete;
mod complete_situation;
mod control;
mod depth;
mod ends;
mod evaluation;
mod export;
mod fields;
mod for_loop;
mod function_text;
mod help;
mod host;
mod interpreter;
mod journal;
mod kept;
mod known;
mod lookup;
mod macro_text;
mod macro_values;
mod macros;
mod names;
mod number;
mod objects;
mod parameters;
mod place;
mod program;
mod prompt;
mod reference;
mod refusals;
mod state;
mod statement;
mod symmetric;
mod tree;
mod values;
mod verbs;
mod words;

pub use complete::{Candidate, Completion};
pub use export::write_model;
pub use host::{BodyMass, DataSet, Host, NoHost, OutputTimes, SimulationKind, SimulationRequest};
pub use interpreter::{Interpreter, OnError, Report};
pub use journal::Journal;
pub use known::meaning;
pub use number::{angle as angle_text, real as number_text};
pub use reference::{CommandReference, ParameterReference};
pub use tree::{Action, Command, CommandTree, Parameter, Path, Role};
pub use verbs::solver_commands::{SolverCommand, parse_solver_command};
