//! Parameters that many elements share. Each sentence, unit and keyword is written here once; an
//! element changes what differs for it (`common::LOCATION.keyword("QP")`).

use schema::{Count, Field, Kind, Rule};

pub const ADAMS_ID: Field =
    Field::integer("adams_id").doc("number in the solver's files; 0 until numbers are generated");
pub const COMMENTS: Field = Field::texts("comments").doc("lines kept with the object and written before it");

// Where a frame is.

pub const LOCATION: Field = Field::location("location").doc("position of the origin");
pub const ORIENTATION: Field = Field::orientation("orientation").doc("three angles that turn the axes into place");
pub const ALONG_AXIS_ORIENTATION: Field = Field::location("along_axis_orientation")
    .count(Count::between(3, 6))
    .doc("one or two points at which the chosen axis is aimed");
pub const IN_PLANE_ORIENTATION: Field = Field::location("in_plane_orientation")
    .count(Count::between(6, 9))
    .doc("two or three points: an axis is aimed, and a plane put through the last");
pub const RELATIVE_TO: Field = Field::object("relative_to", "frame")
    .or_default_coordinate_system()
    .doc("frame in which positions and angles are read");

/// The axes are given in one way.
pub const ONE_ORIENTATION: Rule = Rule::AtMostOne(&["orientation", "along_axis_orientation", "in_plane_orientation"]);

// What is between two markers, or between two bodies that then get a marker each.

pub const I_MARKER: Field =
    Field::object("i_marker_name", "marker").keyword("I").doc("marker on the first body, on which the load acts");
pub const J_MARKER: Field =
    Field::object("j_marker_name", "marker").keyword("J").doc("marker on the second body, which gets the reaction");
pub const I_PART: Field =
    Field::object("i_part_name", "body").on_create().doc("first body; a marker is made on it at the location");
pub const J_PART: Field =
    Field::object("j_part_name", "body").on_create().doc("second body; a marker is made on it at the location");

/// Parameters of a constraint that has nothing but its two markers.
pub const BETWEEN_MARKERS: &[Field] = &[
    ADAMS_ID,
    COMMENTS,
    I_MARKER,
    J_MARKER,
    I_PART,
    J_PART,
    LOCATION.on_create(),
    ORIENTATION.on_create(),
    ALONG_AXIS_ORIENTATION.on_create(),
    IN_PLANE_ORIENTATION.on_create(),
    RELATIVE_TO.on_create(),
];

/// Each end is a marker or a body.
pub const MARKERS_OR_PARTS: &[Rule] = &[
    Rule::AtMostOne(&["i_marker_name", "i_part_name"]),
    Rule::AtLeastOne(&["i_marker_name", "i_part_name"]),
    Rule::AtMostOne(&["j_marker_name", "j_part_name"]),
    Rule::AtLeastOne(&["j_marker_name", "j_part_name"]),
    ONE_ORIENTATION,
];

// What follows a function of the run, or a subroutine of the user.

pub const FUNCTION: Field =
    Field::function("function").keyword("FUNCTION").doc("function of time and state, evaluated during the run");
pub const USER_FUNCTION: Field = Field::new("user_function", Kind::Real)
    .count(Count::between(1, 30))
    .doc("constants handed to a subroutine, 30 at most");
pub const ROUTINE: Field = Field::text("routine").keyword("ROUTINE").doc("library and entry of the subroutine");

// Data that other objects refer to.

pub const ARRAY: &str = "any";
pub const MATRIX: &str = "any";
pub const CURVE: &str = "any";
