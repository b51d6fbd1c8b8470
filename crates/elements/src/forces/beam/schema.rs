//! Names, types, units and defaults of a beam.

use schema::{Class, Count, Dimension, Field, Group};

use crate::{attributes, common};

/// The cells of the damping, which is given by one of them.
pub const DAMPING_RATIO: &str = "damping_ratio";
pub const DAMPING_MATRIX: &str = "matrix_of_damping_terms";

pub const CLASS: Class = Class {
    id: "beam",
    word: "Beam",
    families: &["force", "element_like"],
    parents: &["model"],
    prefix: "BEAM_",
    statement: Some("BEAM"),
    groups: &[
        Group {
            command: "force create element_like beam",
            creates: true,
            object: "beam_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                common::I_MARKER,
                common::J_MARKER,
                Field::real("length", Dimension::LENGTH)
                    .default(1.0)
                    .keyword("LENGTH")
                    .above(0.0)
                    .doc("length without load, along x of J"),
                Field::real("area_of_cross_section", Dimension::AREA)
                    .default(1.0)
                    .keyword("AREA")
                    .above(0.0)
                    .doc("area of the section"),
                Field::real("y_shear_area_ratio", Dimension::NONE)
                    .default(0.0)
                    .keyword("ASY")
                    .zero_or_at_least(1.0)
                    .doc("shear factor along y: area over shear area, at least 1, or 0 for no shear deflection"),
                Field::real("z_shear_area_ratio", Dimension::NONE)
                    .default(0.0)
                    .keyword("ASZ")
                    .zero_or_at_least(1.0)
                    .doc("shear factor along z: area over shear area, at least 1, or 0 for no shear deflection"),
                Field::real("youngs_modulus", Dimension::PRESSURE)
                    .default(1.0)
                    .keyword("EMODULUS")
                    .above(0.0)
                    .doc("modulus of elasticity"),
                Field::real("shear_modulus", Dimension::PRESSURE)
                    .default(1.0)
                    .keyword("GMODULUS")
                    .above(0.0)
                    .doc("shear modulus"),
                Field::real("ixx", Dimension::AREA_INERTIA)
                    .default(1.0)
                    .keyword("IXX")
                    .at_least(0.0)
                    .doc("torsion constant of the section about x of J"),
                Field::real("iyy", Dimension::AREA_INERTIA)
                    .default(1.0)
                    .keyword("IYY")
                    .at_least(0.0)
                    .doc("second moment of area about y of J"),
                Field::real("izz", Dimension::AREA_INERTIA)
                    .default(1.0)
                    .keyword("IZZ")
                    .at_least(0.0)
                    .doc("second moment of area about z of J"),
                Field::real(DAMPING_RATIO, Dimension::TIME)
                    .default(0.0)
                    .keyword("CRATIO")
                    .at_least(0.0)
                    .doc("damping matrix as a multiple of the stiffness matrix"),
                Field::real(DAMPING_MATRIX, Dimension::NONE)
                    .lower_triangle(6)
                    .keyword("CMATRIX")
                    .doc("damping matrix: 21 terms, its lower triangle by columns, or all 36 if it is symmetric"),
                Field::choice("formulation", &["linear", "string", "nonlinear"])
                    .default_word("linear")
                    .keyword("FORMULATION")
                    .doc("law of the beam"),
                common::LOCATION
                    .count(Count::between(3, 6))
                    .doc("position of the markers that are made; a second triple is that of the J marker")
                    .on_create(),
                common::ORIENTATION.on_create(),
                common::ALONG_AXIS_ORIENTATION.on_create(),
                common::IN_PLANE_ORIENTATION.on_create(),
                common::RELATIVE_TO.on_create(),
                common::I_PART,
                common::J_PART,
            ],
            rules: common::MARKERS_OR_PARTS,
            doc: "a massless elastic beam between two markers",
        },
        attributes::FORCE,
    ],
};
