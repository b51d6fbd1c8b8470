//! Names, types, units and defaults of a point mass.

use schema::{Class, Dimension, Field, Group, Rule};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "point_mass",
    word: "Point_Mass",
    families: &["body", "frame"],
    parents: &["model"],
    prefix: "POINT_MASS_",
    statement: Some("POINT_MASS"),
    groups: &[
        Group {
            command: "part create point_mass name_and_position",
            creates: true,
            object: "point_mass_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                common::LOCATION.keyword("QG"),
                common::ORIENTATION.keyword("REULER"),
                Field::texts("view_name").doc("views that show the object"),
                common::ALONG_AXIS_ORIENTATION,
                common::IN_PLANE_ORIENTATION,
                common::RELATIVE_TO,
                Field::choice("exact_coordinates", &["x", "y", "z", "none", "all"])
                    .many()
                    .doc("start coordinates that the assembly leaves as they are"),
            ],
            rules: &[common::ONE_ORIENTATION],
            doc: "a point mass and where it is",
        },
        Group {
            command: "part create point_mass mass_properties",
            creates: false,
            object: "point_mass_name",
            fields: &[
                Field::real("density", Dimension::DENSITY).doc("mass per volume of the shapes of the part"),
                Field::object("material_type", "material").doc("material whose density the shapes of the part have"),
                Field::real("mass", Dimension::MASS).keyword("MASS").doc("mass"),
                Field::object("center_of_mass_marker", "marker").keyword("CM").doc("marker at the centre of mass"),
            ],
            rules: &[
                Rule::AtMostOne(&["center_of_mass_marker", "material_type", "density"]),
                Rule::AtMostOne(&["center_of_mass_marker", "material_type"]),
            ],
            doc: "how heavy a point mass is",
        },
        Group {
            command: "part create point_mass initial_velocity",
            creates: false,
            object: "point_mass_name",
            fields: &[
                Field::object("vm", "marker")
                    .keyword("VM")
                    .doc("marker along whose axes vx, vy, vz are measured; global axes if not given"),
                Field::real("vx", Dimension::VELOCITY).keyword("VX").doc("start velocity along x"),
                Field::true_false("no_vx").doc("forget the start velocity along x"),
                Field::real("vy", Dimension::VELOCITY).keyword("VY").doc("start velocity along y"),
                Field::true_false("no_vy").doc("forget the start velocity along y"),
                Field::real("vz", Dimension::VELOCITY).keyword("VZ").doc("start velocity along z"),
                Field::true_false("no_vz").doc("forget the start velocity along z"),
            ],
            rules: &[],
            doc: "how fast a point mass moves at the start",
        },
        attributes::POINT_MASS,
    ],
};
