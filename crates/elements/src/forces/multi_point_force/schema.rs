//! Names, types, units and defaults of a multi-point force.

use schema::{Class, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "multi_point_force",
    word: "Multi_Point_Force",
    families: &["force", "direct"],
    parents: &["model"],
    prefix: "NFORCE_",
    statement: Some("NFORCE"),
    groups: &[
        Group {
            command: "force create direct multi_point_force",
            creates: true,
            object: "multi_point_force_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::objects("i_marker_name", "marker")
                    .required()
                    .keyword("I")
                    .doc("markers on which the force acts"),
                common::J_MARKER.required(),
                Field::object("stiffness_matrix_name", common::MATRIX)
                    .required()
                    .keyword("KMATRIX")
                    .doc("stiffness, six rows for each marker"),
                Field::object("damping_matrix_name", common::MATRIX)
                    .keyword("CMATRIX")
                    .doc("damping, six rows for each marker"),
                Field::real("damping_ratio", Dimension::TIME)
                    .keyword("CRATIO")
                    .doc("damping matrix as a multiple of the stiffness matrix"),
                Field::object("length_matrix_name", common::MATRIX)
                    .keyword("LENGTH")
                    .doc("displacements at which the force is the preload"),
                Field::object("force_matrix_name", common::MATRIX).keyword("FORCE").doc("preloads"),
            ],
            rules: &[],
            doc: "a linear force between several markers and one, through matrices",
        },
        attributes::FORCE,
    ],
};
