//! Parameters that several shapes share.

use schema::{Count, Dimension, Field, Kind};

/// Points of three coordinates each, kept in the axes of the reference marker of the shape, or of
/// its body where it has none.
pub const fn points(name: &'static str) -> Field {
    let mut field = Field::new(name, Kind::Location).count(Count::between(6, usize::MAX));
    field.dimension = Dimension::LENGTH;
    field
}

pub const REFERENCE_MARKER: Field =
    Field::object("reference_marker", "marker").doc("marker in whose axes the shape is given");
pub const ANALYTICAL: Field =
    Field::yes_no("analytical").default_word("no").doc("keep the exact surface in place of facets");
pub const PROFILE_CURVE: Field = Field::objects("profile_curve", "wire").doc("curve that is the outline");
pub const POINTS_FOR_PROFILE: Field = points("points_for_profile").doc("corners of the outline in order");
pub const IMAGE_FILE_NAME: Field = Field::text("image_file_name").doc("picture painted on the inside");
pub const HORIZONTAL: Field = Field::choice("horizontal", &["clamp", "repeat"]).doc("how the picture repeats across");
pub const VERTICAL: Field = Field::choice("vertical", &["clamp", "repeat"]).doc("how the picture repeats upwards");
