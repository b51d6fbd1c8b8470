//! Commands that no class owns: one file for each family, each with the table of its parameters.

use schema::Verb;
use text::Diagnostic;

use crate::{Interpreter, call::Call, interpreter::Flow};

mod blocks;
mod copy;
mod defaults;
mod delete;
mod entity;
mod file;
mod group;
mod list;
mod macros;
mod model;
mod simulation;
pub mod solver_commands;
mod undo;
mod variable;

/// What runs a verb.
pub(crate) type Run = fn(&mut Interpreter, &Call) -> Result<Flow, Vec<Diagnostic>>;

/// A verb and what runs it.
#[derive(Debug)]
pub struct VerbEntry {
    pub verb: Verb,
    pub(crate) run: Run,
}

const fn entry(verb: Verb, run: Run) -> VerbEntry {
    VerbEntry { verb, run }
}

/// Every verb. The table of a verb may be extended at run time (`entity attributes`).
pub static ALL: &[&VerbEntry] = &[
    &blocks::IF,
    &blocks::ELSEIF,
    &blocks::ELSE,
    &blocks::END,
    &blocks::WHILE,
    &blocks::FOR,
    &blocks::BREAK,
    &blocks::CONTINUE,
    &blocks::RETURN,
    &defaults::UNITS,
    &defaults::MODEL,
    &defaults::COORDINATE_SYSTEM,
    &defaults::ORIENT_AXIS_AND_PLANE,
    &defaults::ATTRIBUTES,
    &defaults::COMMAND_FILE,
    &defaults::NAME_MARKER,
    &defaults::NAME_PART,
    &defaults::NAME_FORCE,
    &defaults::NAME_CONSTRAINT,
    &defaults::NAME_GEOMETRY,
    &defaults::NAME_MODEL,
    &model::DISPLAY,
    &model::VERIFY,
    &model::GENERATE_IDS,
    &delete::MODEL,
    &delete::PART,
    &delete::MARKER,
    &delete::POINT,
    &delete::GEOMETRY,
    &delete::CONSTRAINT,
    &delete::FORCE,
    &delete::DATA_ELEMENT,
    &delete::MEASURE,
    &delete::REQUEST,
    &delete::MATERIAL,
    &delete::VARIABLE,
    &delete::GROUP,
    &delete::MACRO,
    &delete::SCRIPT,
    &delete::ANALYSIS,
    &delete::ENTITY,
    &copy::MODEL,
    &copy::PART,
    &copy::MARKER,
    &copy::FORCE,
    &copy::CONSTRAINT,
    &copy::GEOMETRY,
    &copy::POINT,
    &copy::DATA_ELEMENT,
    &copy::ENTITY,
    &entity::MODIFY,
    &entity::ATTRIBUTES,
    &variable::SET,
    &variable::CREATE,
    &variable::MODIFY,
    &macros::CREATE,
    &macros::READ,
    &undo::BACKWARD,
    &undo::FORWARD,
    &undo::BEGIN_BLOCK,
    &undo::END_BLOCK,
    &undo::FLUSH,
    &undo::SET,
    &group::ADD,
    &group::REMOVE,
    &group::EMPTY,
    &list::ENTITY,
    &list::FORCE,
    &list::PART,
    &list::MARKER,
    &list::MODEL,
    &list::VARIABLE,
    &list::CONSTRAINT,
    &file::COMMAND_READ,
    &file::COMMAND_WRITE,
    &file::DATA_SET_WRITE,
    &file::DATA_SET_READ,
    &simulation::TRANSIENT,
    &simulation::EQUILIBRIUM,
    &simulation::ASSEMBLE,
    &simulation::EIGEN,
    &simulation::EIGEN_OLD,
    &simulation::SCRIPTED,
    &simulation::RESET,
];
