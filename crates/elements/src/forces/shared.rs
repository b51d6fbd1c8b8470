//! Parameters that forces given by functions share: the body that gets the reaction, and the axes.

use schema::{Dimension, Field};

pub const J_FLOATING_MARKER: Field = Field::object("j_floating_marker_name", "floating_marker")
    .keyword("JFLOAT")
    .doc("floating marker of the second body, which follows I and gets the reaction");
pub const J_PART: Field = Field::object("j_part_name", "body").doc("second body; a floating marker is made on it");
pub const J_MARKER_ID: Field =
    Field::integer("j_marker_id").on_create().doc("number of the floating marker that is made");
pub const REF_MARKER: Field =
    Field::object("ref_marker_name", "marker").keyword("RM").doc("marker along whose axes components are given");
pub const ERROR: Field = Field::real("error", Dimension::NONE).keyword("ERROR").doc("error allowed");
