//! Named series with units, their file formats and plots. How a series was computed is not known
//! here.

mod table;

pub use table::{Series, Table};
