//! Objects that hold values for others.

pub mod group;
pub mod material;
pub mod variable;
