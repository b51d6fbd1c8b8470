//! Names, types, units and defaults of a bushing.

use schema::{Class, Count, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "bushing",
    word: "Bushing",
    families: &["force", "element_like"],
    parents: &["model"],
    prefix: "BUSHING_",
    statement: Some("BUSHING"),
    groups: &[
        Group {
            command: "force create element_like bushing",
            creates: true,
            object: "bushing_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                common::I_MARKER,
                common::J_MARKER,
                Field::real("damping", Dimension::DAMPING)
                    .count(Count::exactly(3))
                    .default(0.0)
                    .keyword("C")
                    .doc("viscous damping along x, y and z of J"),
                Field::real("stiffness", Dimension::STIFFNESS)
                    .count(Count::exactly(3))
                    .default(1.0)
                    .keyword("K")
                    .doc("stiffness along x, y and z of J"),
                Field::real("force_preload", Dimension::FORCE)
                    .count(Count::exactly(3))
                    .default(0.0)
                    .keyword("FORCE")
                    .doc("force on I while nothing is displaced or moves"),
                Field::real("tdamping", Dimension::TORSION_DAMPING)
                    .count(Count::exactly(3))
                    .default(0.0)
                    .keyword("CT")
                    .doc("viscous damping about x, y and z of J"),
                Field::real("tstiffness", Dimension::TORSION_STIFFNESS)
                    .count(Count::exactly(3))
                    .default(1.0)
                    .keyword("KT")
                    .doc("stiffness about x, y and z of J"),
                Field::real("torque_preload", Dimension::TORQUE)
                    .count(Count::exactly(3))
                    .default(0.0)
                    .keyword("TORQUE")
                    .doc("torque on I while nothing is displaced or moves"),
                common::I_PART,
                common::J_PART,
                common::LOCATION.on_create(),
                common::ORIENTATION.on_create(),
                common::ALONG_AXIS_ORIENTATION.on_create(),
                common::IN_PLANE_ORIENTATION.on_create(),
                common::RELATIVE_TO.on_create(),
            ],
            rules: common::MARKERS_OR_PARTS,
            doc: "springs and dampers along and about three axes, without coupling",
        },
        attributes::FORCE,
    ],
};
