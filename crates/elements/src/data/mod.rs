//! Objects that hold values for others.

pub mod array_general;
pub mod array_ic;
pub mod array_u;
pub mod array_x;
pub mod array_y;
pub mod curve_element;
pub(crate) mod fields;
pub mod function;
pub mod group;
pub mod material;
pub mod matrix_file;
pub mod matrix_full;
pub mod matrix_sparse;
pub mod section;
pub mod solver_variable;
pub mod spline;
pub mod string;
pub mod variable;
