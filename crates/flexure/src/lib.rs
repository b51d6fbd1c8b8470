//! The facade: a [`Session`] reads and executes commands, simulates, verifies and writes. Every
//! door (command line, Python) stands on it and on nothing behind it.

mod assign;
mod attributes;
mod beams;
mod compare_models;
mod coordinates;
mod engine;
pub mod files;
mod fixes;
mod function_check;
mod host;
mod layout;
mod modes;
mod overdamped;
mod persistence;
mod reading;
mod recorder;
mod run;
mod session;
mod settings;
mod simulate;
mod start;
mod support;
mod verify;
mod window;

pub use assign::AttributeInput;
pub use attributes::{Attribute, AttributeValue};
pub use beams::{BeamState, BeamsAt, BeamsReport, ChainLink};
pub use compare_models::{ModelChange, ModelDifferences, ValueChange, Why};
pub use fixes::{Fixed, apply_fixes};
pub use layout::Layout;
pub use modes::{Mode, ModesAbout, ModesReport};
pub use run::{Control, Progress, Run, RunHeader, RunObserver, Silent};
pub use session::{Report, Session, Verification};
pub use settings::{Analysis, Outputs, SimulationOptions};
pub use support::{Support, support};
pub use window::{Candidate, CommandReference, Completion, ParameterReference, Role};

pub use elements::Finding;
pub use elements::forces::beam::Angles as BeamAngles;
pub use parquet;
pub use results;
pub use schema::{Count, Dimension, Rule, UnitName};
pub use sections;
pub use text;
