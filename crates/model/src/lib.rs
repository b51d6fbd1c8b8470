//! The modelling database: a tree of named objects made of cells, with references, expressions,
//! current defaults, units and undo.
//!
//! It knows classes only as schema tables: what a beam is stays unknown here. Every change goes
//! through a method of [`Database`] that records its inverse, so that a command is all or nothing
//! and every step can be undone.

mod cell;
mod cells;
mod database;
mod dependencies;
mod expression;
mod index;
mod names;
mod pose;
mod settings;
mod stored;
mod undo;

pub use cell::{Array, Cell, FunctionText, Piece, Source, Value};
pub use cells::Cells;
pub use database::{Database, NameTaken, Object, ObjectId};
pub use dependencies::{CellKey, Cycle};
pub use expression::{BinaryOperator, Expression, Node, UnaryOperator};
pub use names::{name_steps, quoted, split_name};
pub use pose::{Pose, Sequence, angles_of, rotation_of};
pub use settings::{CoordinateSystem, Settings, UnitsId};
pub use stored::StoredObject;
pub use undo::{Effect, Mark};
