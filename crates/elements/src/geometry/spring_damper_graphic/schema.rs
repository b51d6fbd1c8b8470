//! Names, types, units and defaults of a spring symbol.

use schema::{Class, Count, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "spring_damper_graphic",
    word: "Spring_Damper_Graphic",
    families: &["geometry", "shape"],
    parents: &["part", "ground", "point_mass"],
    prefix: "SPRING_GRAPHIC_",
    statement: Some("GRAPHICS"),
    groups: &[
        Group {
            command: "geometry create shape spring_damper",
            creates: true,
            object: "spring_damper_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                common::I_MARKER.required(),
                common::J_MARKER.required(),
                Field::integer("coil_count").default(3.0).doc("coils drawn"),
                Field::real("diameter_of_spring", Dimension::LENGTH).default(1.0).doc("diameter of the coil"),
                Field::real("damper_diameter_at_ij", Dimension::LENGTH)
                    .count(Count::exactly(2))
                    .default(0.5)
                    .doc("diameters of the damper at I and at J"),
                Field::real("tip_length_at_ij", Dimension::LENGTH)
                    .count(Count::exactly(2))
                    .default(0.1)
                    .doc("straight ends at I and at J"),
                Field::real("cup_length_at_ij", Dimension::LENGTH)
                    .count(Count::exactly(2))
                    .default(0.2)
                    .doc("lengths of the damper cups at I and at J"),
            ],
            rules: &[],
            doc: "the symbol of a spring and a damper",
        },
        attributes::GEOMETRY,
        attributes::GEOMETRY_MORE,
    ],
};
