//! Cross sections of beams as objects: sizes, and the properties that follow from them. The commands
//! are an extension of Flexure; what Adams has behind the keyword `section` is not known to us.

pub mod boxed;
pub mod circle;
pub mod ellipse;
pub(crate) mod fields;
pub mod i_beam;
pub mod properties;
pub mod rectangle;
pub mod tube;
