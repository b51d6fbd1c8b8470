//! Commands that no class owns: one file for each family, each with the table of its parameters.

use schema::Verb;
use text::Diagnostic;

use crate::{Interpreter, call::Call, interpreter::Flow};

mod aggregate;
mod blocks;
mod copy;
mod defaults;
mod delete;
mod entity;
mod file;
mod flexible_link;
mod foreign;
pub(crate) mod group;
mod list;
mod listing;
mod macros;
mod merge;
mod model;
mod moving;
mod name_generation;
mod scripts;
mod section;
mod session;
mod shared;
mod simulation;
pub mod solver_commands;
pub(crate) mod text_file;
mod twins;
mod undo;
mod variable;

pub(crate) use file::data_set_text as read_data_set;
pub(crate) use variable::warn_outside;

/// What runs a verb.
pub(crate) type Run = fn(&mut Interpreter, &Call) -> Result<Flow, Vec<Diagnostic>>;

/// A verb and what runs it.
#[derive(Debug)]
pub struct VerbEntry {
    pub verb: Verb,
    pub(crate) run: Run,
    /// Understood, but named and skipped.
    refused: bool,
}

impl VerbEntry {
    pub(crate) fn is_refused(&self) -> bool {
        self.refused
    }
}

const fn entry(verb: Verb, run: Run) -> VerbEntry {
    VerbEntry { verb, run, refused: false }
}

/// A verb whose words and values are checked, and that is named and skipped.
const fn refused(verb: Verb) -> VerbEntry {
    VerbEntry { verb, run: shared::refuse, refused: true }
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
    &session::HELP,
    &session::PAUSE,
    &session::ABORT,
    &session::VIEW_ERASE,
    &session::QUIT,
    &session::STOP,
    &session::EXIT,
    &session::SYSTEM,
    &defaults::UNITS,
    &defaults::MODEL,
    &defaults::COORDINATE_SYSTEM,
    &defaults::ORIENT_AXIS_AND_PLANE,
    &defaults::ATTRIBUTES,
    &defaults::COMMAND_FILE,
    &defaults::SOLVER,
    &defaults::ADAMS_OUTPUT,
    &name_generation::LAYOUT,
    &name_generation::MARKER,
    &name_generation::PART,
    &name_generation::MODEL,
    &name_generation::FORCE,
    &name_generation::CONSTRAINT,
    &name_generation::DATA_ELEMENT,
    &name_generation::GEOMETRY,
    &model::DISPLAY,
    &model::VERIFY,
    &model::GENERATE_IDS,
    &merge::MODEL,
    &merge::PART,
    &delete::MODEL,
    &delete::PART,
    &delete::MARKER,
    &delete::FLOATING_MARKER,
    &delete::POINT,
    &delete::GEOMETRY,
    &delete::CONSTRAINT,
    &delete::FORCE,
    &delete::CONTACT,
    &delete::DATA_ELEMENT,
    &delete::MEASURE,
    &delete::REQUEST,
    &delete::SENSOR,
    &delete::MATERIAL,
    &delete::SECTION,
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
    &copy::CONTACT,
    &copy::CONSTRAINT,
    &copy::GEOMETRY,
    &copy::POINT,
    &copy::DATA_ELEMENT,
    &copy::SECTION,
    &copy::GROUP,
    &copy::SCRIPT,
    &copy::ENTITY,
    &section::APPLY,
    &flexible_link::CREATE,
    &flexible_link::REPORT,
    &entity::MODIFY,
    &entity::ATTRIBUTES,
    &moving::OBJECT,
    &moving::TRANSLATION,
    &moving::ROTATION,
    &variable::SET,
    &variable::CREATE,
    &variable::MODIFY,
    &macros::CREATE,
    &macros::MODIFY,
    &macros::READ,
    &macros::WRITE,
    &undo::BACKWARD,
    &undo::FORWARD,
    &undo::BEGIN_BLOCK,
    &undo::END_BLOCK,
    &undo::FLUSH,
    &undo::SET,
    &group::CREATE,
    &group::MODIFY,
    &group::ADD,
    &group::REMOVE,
    &group::EMPTY,
    &group::DELETE_OBJECTS,
    &group::COPY_OBJECTS,
    &group::RENAME_OBJECTS,
    &group::ATTRIBUTES,
    &group::GROUP_ATTRIBUTES,
    &list::ENTITY,
    &list::FORCE,
    &list::PART,
    &list::MARKER,
    &list::MODEL,
    &list::VARIABLE,
    &list::GROUP,
    &list::MACRO,
    &list::CONSTRAINT,
    &list::DATA_ELEMENT,
    &list::GEOMETRY,
    &list::NAMES,
    &list::TOPOLOGY,
    &list::MEASURE,
    &list::DEFAULTS,
    &list::NAME_GENERATION,
    &list::UNDO,
    &aggregate::AGGREGATE_MASS,
    &file::COMMAND_READ,
    &file::COMMAND_WRITE,
    &file::DATA_SET_WRITE,
    &file::DATA_SET_READ,
    &file::DATA_SET_MERGE,
    &text_file::OPEN,
    &text_file::WRITE,
    &text_file::CLOSE,
    &foreign::ANALYSIS_READ,
    &foreign::ANALYSIS_WRITE,
    &foreign::REQUEST_READ,
    &foreign::RESULTS_READ,
    &foreign::GRAPHICS_READ,
    &foreign::BINARY_READ,
    &foreign::BINARY_WRITE,
    &foreign::LOG_FILE,
    &foreign::PARASOLID_READ,
    &foreign::PARASOLID_WRITE,
    &foreign::RESULTS_WRITE,
    &foreign::RESULTS_READ_FROM_FILE,
    &foreign::RESULTS_CREATE,
    &foreign::RESULTS_DELETE,
    &simulation::TRANSIENT,
    &simulation::EQUILIBRIUM,
    &simulation::ASSEMBLE,
    &simulation::EIGEN,
    &simulation::EIGEN_OLD,
    &simulation::SCRIPTED,
    &simulation::RESET,
    &scripts::READ_ACF,
    &scripts::WRITE_ACF,
    &scripts::STATE_MATRIX,
    &scripts::SAVE,
    &scripts::SINGLE_RUN_SET,
    &scripts::SET,
    &scripts::DESIGN_STUDY,
    &scripts::OPTIMIZATION,
];
