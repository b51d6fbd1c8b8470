//! Shapes and curves: what a part looks like and, with a density, weighs.

pub mod arc;
pub mod block;
pub mod bspline;
pub mod circle;
pub mod cylinder;
pub mod ellipse;
pub mod ellipsoid;
pub mod extrusion;
pub(crate) mod fields;
pub mod force_graphic;
pub mod frustum;
pub mod geometry_point;
pub mod link;
mod mass;
mod outline;
pub mod outline_curve;
pub mod plane;
pub mod plate;
pub mod polyline;
mod profile;
pub mod revolution;
pub mod shell;
pub mod spring_damper_graphic;
pub mod torus;

use model::{Database, ObjectId};
use text::Diagnostic;

pub use mass::{MassProperties, mass_properties};
pub(crate) use outline::{arc_points, round_outline};

use crate::{
    place::{Cells, OnBody},
    shape::Shape,
};

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
        "ellipse" => ellipse::draw::shape,
        "ellipsoid" => ellipsoid::draw::shape,
        "extrusion" => extrusion::draw::shape,
        "frustum" => frustum::draw::shape,
        "geometry_point" => geometry_point::draw::shape,
        "link" => link::draw::shape,
        "outline" => outline_curve::draw::shape,
        "plane" => plane::draw::shape,
        "plate" => plate::draw::shape,
        "polyline" => polyline::draw::shape,
        "revolution" => revolution::draw::shape,
        "torus" => torus::draw::shape,
        _ => return None,
    };
    Some(shape(database, id))
}

/// Why an object of geometry cannot be drawn, if it belongs to a kind that cannot. Solids among them
/// make the mass of their part doubtful.
pub(crate) fn not_drawn(database: &Database, id: ObjectId) -> Option<Diagnostic> {
    let cells = Cells { database, id };
    match database.get(id)?.class.id {
        "shell" => Some(profile::not_evaluated(&cells, "file_name")),
        "bspline" => {
            let what = "is not drawn: B-spline curves are not evaluated yet";
            Some(cells.trouble("geometry/not-drawn", what).help("draw a polyline through points of the curve"))
        }
        _ => None,
    }
}
