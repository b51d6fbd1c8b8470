//! What Adams View refuses although every single value is fine.

use model::{Database, ObjectId};
use text::{Diagnostic, Span};

/// Constraints that a body without extent can take.
const OF_A_POINT: [&str; 4] = ["joint_spherical", "jprim_at_point", "jprim_inline", "jprim_inplane"];

/// A point mass has no orientation for a constraint to hold.
pub fn joint_of_a_point_mass(database: &Database, id: ObjectId, span: Span) -> Result<(), Vec<Diagnostic>> {
    let class = database.object(id).class;
    if !(class.is("joint") || class.is("primitive_joint")) || OF_A_POINT.contains(&class.id) {
        return Ok(());
    }
    let owner = |end: &str| database.reference(id, end).and_then(|marker| database.object(marker).parent);
    let bodies = ["i_marker_name", "j_marker_name"].into_iter().filter_map(owner);
    let Some(body) = bodies.into_iter().find(|b| database.object(*b).class.id == "point_mass") else { return Ok(()) };
    let name = database.full_name(body);
    let kind = class.id.trim_start_matches("jprim_").trim_start_matches("joint_");
    let word = if class.id.starts_with("jprim_") { "joint primitive" } else { "joint" };
    Err(vec![
        Diagnostic::error("constraint/point-mass", format!("a {kind} {word} cannot hold the point mass `{name}`"))
            .at(span, "holds angles, which a point mass does not have")
            .help("use a spherical joint, or a primitive joint at_point, inline or inplane; or make it a part")
            .adams(format!("A point mass, such as {name}, can be constrained with only a"))
            .adams("spherical joint, an atpoint joint primitive, an inline joint primitive,")
            .adams(format!("or an inplane joint primitive. Do not connect a {kind} {word} "))
            .adams("to a point mass."),
    ])
}
