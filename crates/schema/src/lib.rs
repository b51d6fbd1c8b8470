//! What an element or a command may declare: names, types, units, defaults, rules. Data only.
//!
//! A [`Class`] describes one kind of object of the model (a beam, a marker, a revolute joint); its
//! [`Group`]s are the command families that create and modify it. A [`Verb`] is a command that
//! owns no class (`file command read`). Both list [`Field`]s. From these tables come binding and
//! abbreviation, `?` help, completion, the dataset statement, Python attributes and the manual.

mod class;
mod field;
mod referred;
mod symmetric;
mod units;

pub use class::{Class, Group, Registry, Rule, Verb};
pub use field::{Count, Default, Field, Kind, Limit, Names, Use};
pub use referred::referred;
pub use symmetric::{SYMMETRY_TOLERANCE, Unequal, lower_triangle, place_by_columns, triangle_places};
pub use units::{Dimension, Quantity, UnitName, UnitSystem, UnitTable, parse_unit_expression, unit_table};
