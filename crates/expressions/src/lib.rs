//! Expressions of the command language: binding names to objects, evaluating, printing, and
//! re-evaluating what depends on a changed value.
//!
//! [`bind`] turns the tree of what was typed into a [`model::Expression`] that holds its objects by
//! reference, so that it follows renaming; parts in `EVAL(...)` are evaluated at once.
//! [`evaluate`] gives the value in the units in force and lists every cell it read. [`compute`]
//! adds what a cell needs (frame, type), [`recompute`] does that for everything that depends on
//! changed cells. [`print`] writes the normalised text that exports show.

mod scope;
mod world;

mod names;

mod bind;
mod dimension;

mod arithmetic;
mod attributes;
mod evaluate;
mod functions;

mod cells;
mod meaning;
mod pattern;
mod print;
mod unit_help;

pub use attributes::read_as_attribute;
pub use bind::{Bound, bind};
pub use cells::{STRUCTURE, compute, convert_location, convert_orientation, recompute, restructure};
pub use dimension::{is_rate_of_angle, radians_per_time};
pub use evaluate::{Evaluated, evaluate};
pub use functions::{FunctionInfo, functions, refused_functions, sprintf};
pub use meaning::with_another_meaning;
pub use names::{find_object, object_of};
pub use pattern::glob;
pub use print::{number_text, print};
pub use scope::Scope;
pub use unit_help::with_units;
pub use world::World;
