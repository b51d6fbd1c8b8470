//! Named series with units, their file formats and plots. How a series was computed is not known
//! here.

mod compare;
pub mod csv;
mod diagram;
mod outline;
mod picture;
mod plot;
mod table;

pub use compare::{Difference, compare};
pub use diagram::{Curve, DiagramRequest, Panel, diagram};
pub use outline::{OutlineRequest, SizeMark, TextSide, outline};
pub use picture::{PictureRequest, Polyline, picture};
pub use plot::{Format, PlotError, PlotRequest, plot};
pub use table::{Series, Table};
