//! Names, types, units and defaults of a contact.

use schema::{Class, Dimension, Field, Group, Kind, Rule};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "contact",
    word: "Contact",
    families: &["contact", "force"],
    parents: &["model"],
    prefix: "CONTACT_",
    statement: Some("CONTACT"),
    groups: &[
        Group {
            command: "contact create",
            creates: true,
            object: "contact_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::choice(
                    "type",
                    &[
                        "solid_to_solid",
                        "curve_to_curve",
                        "point_to_curve",
                        "point_to_plane",
                        "curve_to_plane",
                        "sphere_to_plane",
                        "sphere_to_sphere",
                        "flex_to_solid",
                        "flex_to_flex",
                        "flex_edge_to_curve",
                        "flex_edge_to_flex_edge",
                        "flex_edge_to_plane",
                        "cylinder_to_cylinder",
                    ],
                )
                .many()
                .keyword("TYPE")
                .doc("kinds of shape that touch"),
                Field::objects("i_marker_name", "marker").doc("points of the first body that touch"),
                Field::objects("i_geometry_name", "geometry").keyword("IGEOM").doc("shapes of the first body"),
                Field::object("i_flex", "body").doc("flexible body on the first side"),
                Field::object("i_edge", common::MATRIX).doc("edge of the first flexible body"),
                Field::integer("i_edge_index").doc("number of the edge of the first flexible body"),
                Field::objects("j_geometry_name", "geometry").keyword("JGEOM").doc("shapes of the second body"),
                Field::object("j_flex", "body").doc("flexible body on the second side"),
                Field::object("j_edge", common::MATRIX).doc("edge of the second flexible body"),
                Field::integer("j_edge_index").doc("number of the edge of the second flexible body"),
                Field::choice("i_flip_normal", &["yes", "no"]).many().doc("turn the outside of each first shape"),
                Field::choice("j_flip_normal", &["yes", "no"]).many().doc("turn the outside of each second shape"),
                Field::objects("i_flip_geometry_name", "geometry").doc("first curves whose outside is turned"),
                Field::objects("j_flip_geometry_name", "geometry").doc("second curves whose outside is turned"),
                Field::text("geometry_routines").doc("library and entries of subroutines that find where shapes touch"),
                Field::real("stiffness", Dimension::STIFFNESS).keyword("STIFFNESS").doc("stiffness of the surface"),
                Field::real("damping", Dimension::DAMPING).keyword("DAMPING").doc("largest damping"),
                Field::real("exponent", Dimension::NONE).keyword("EXPONENT").doc("power of the penetration"),
                Field::real("dmax", Dimension::LENGTH).keyword("DMAX").doc("penetration at which damping is full"),
                Field::real("penalty", Dimension::DAMPING)
                    .keyword("PENALTY")
                    .doc("force per speed of penetration where impacts follow a coefficient"),
                Field::real("restitution_coefficient", Dimension::NONE)
                    .keyword("RESTITUTION_COEFFICIENT")
                    .doc("speed after an impact over speed before it"),
                Field::new("normal_function", Kind::Real)
                    .many()
                    .doc("constants for a subroutine that gives the normal force"),
                Field::text("normal_routine").doc("library and entry of the subroutine for the normal force"),
                Field::yes_no("augmented_lagrangian_formulation")
                    .default_word("no")
                    .doc("iterate until the penetration is small"),
                Field::true_false("no_friction").doc("switch friction off"),
                Field::choice("coulomb_friction", &["on", "off", "dynamics_only"])
                    .keyword("COULOMB_FRICTION")
                    .doc("whether friction acts, or in dynamic runs alone"),
                Field::real("mu_static", Dimension::NONE).keyword("MU_STATIC").doc("friction coefficient at rest"),
                Field::real("mu_dynamic", Dimension::NONE)
                    .keyword("MU_DYNAMIC")
                    .doc("friction coefficient while sliding"),
                Field::real("stiction_transition_velocity", Dimension::VELOCITY)
                    .keyword("STICTION_TRANSITION_VELOCITY")
                    .doc("speed at which friction is that at rest"),
                Field::real("friction_transition_velocity", Dimension::VELOCITY)
                    .keyword("FRICTION_TRANSITION_VELOCITY")
                    .doc("speed from which friction is that of sliding"),
                Field::on_off("stiction").doc("whether surfaces stick"),
                Field::real("max_stiction_deformation", Dimension::LENGTH)
                    .keyword("MAX_STICTION_DEFORMATION")
                    .doc("creep while surfaces stick"),
                Field::new("friction_function", Kind::Real)
                    .many()
                    .doc("constants for a subroutine that gives friction"),
                Field::text("friction_routine").doc("library and entry of the subroutine for friction"),
                Field::choice("face_contact_top", &["yes", "no"])
                    .many()
                    .doc("whether the upper face of a shell touches"),
                Field::choice("face_contact_bottom", &["yes", "no"])
                    .many()
                    .doc("whether the lower face of a shell touches"),
            ],
            rules: &[
                Rule::AtMostOne(&["i_flip_geometry_name", "j_flip_geometry_name"]),
                Rule::AtMostOne(&["j_geometry_name", "j_flex"]),
                Rule::AtMostOne(&["stiffness", "penalty", "normal_function"]),
            ],
            doc: "a force between shapes of two bodies where they touch",
        },
        attributes::FORCE,
    ],
};
