//! Shapes and curves: what a part looks like and, with a density, weighs.

pub mod arc;
pub mod block;
pub mod circle;
pub mod cylinder;
pub mod ellipsoid;
pub mod force_graphic;
pub mod frustum;
pub mod link;
pub mod plate;
pub mod polyline;
pub mod spring_damper_graphic;
pub mod torus;
