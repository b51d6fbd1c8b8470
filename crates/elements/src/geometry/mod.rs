//! Shapes and curves: what a part looks like and, with a density, weighs.

pub mod arc;
pub mod block;
pub mod circle;
pub mod cylinder;
pub mod ellipsoid;
pub mod force_graphic;
pub mod frustum;
pub mod link;
mod mass;
mod outline;
pub mod plate;
pub mod polyline;
pub mod spring_damper_graphic;
pub mod torus;

use model::{Database, ObjectId};
use text::Diagnostic;

pub use mass::{MassProperties, mass_properties};
pub(crate) use outline::{arc_points, round_outline};

use crate::{place::OnBody, shape::Shape};

/// A shape and where its axes are on a body.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed {
    pub on: OnBody,
    pub shape: Shape,
}

/// The shape of an object of geometry; `None` for graphics that hang between bodies (springs, force
/// arrows) and for what is no geometry.
pub fn shape(database: &Database, id: ObjectId) -> Option<Result<Placed, Diagnostic>> {
    let shape: fn(&Database, ObjectId) -> Result<Placed, Diagnostic> = match database.get(id)?.class.id {
        "arc" => arc::draw::shape,
        "block" => block::draw::shape,
        "circle" => circle::draw::shape,
        "cylinder" => cylinder::draw::shape,
        "ellipsoid" => ellipsoid::draw::shape,
        "frustum" => frustum::draw::shape,
        "link" => link::draw::shape,
        "plate" => plate::draw::shape,
        "polyline" => polyline::draw::shape,
        "torus" => torus::draw::shape,
        _ => return None,
    };
    Some(shape(database, id))
}
