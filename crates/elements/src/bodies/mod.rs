//! What has a place: models, bodies and the frames in them.

pub mod floating_marker;
pub mod ground;
pub mod marker;
pub mod model;
pub mod part;
pub mod point;
pub mod point_mass;
pub mod rigid_body;
pub mod start;
