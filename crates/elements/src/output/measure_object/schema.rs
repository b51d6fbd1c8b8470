//! Names, types, units and defaults of an object measure.

use schema::{Class, Field, Group};

use crate::{attributes, common, output::measured};

/// What may be asked of an object; which of them it has depends on its kind.
const CHARACTERISTICS: &[&str] = &[
    "angular_acceleration",
    "angular_deformation",
    "angular_deformation_velocity",
    "angular_kinetic_energy",
    "angular_momentum_about_cm",
    "angular_velocity",
    "ax_ay_az_projection_angles",
    "cm_acceleration",
    "cm_angular_acceleration",
    "cm_angular_displacement",
    "euler_angles",
    "cm_angular_velocity",
    "cm_position",
    "cm_position_relative_to_body",
    "cm_velocity",
    "contact_point_location",
    "element_force",
    "element_torque",
    "integrator_order",
    "integrator_stepsize",
    "integrator_time_step",
    "iterator_steps",
    "iteration_count",
    "kinetic_energy",
    "potential_energy_delta",
    "power_consumption",
    "pressure_angle",
    "static_imbalance",
    "strain_kinetic_energy",
    "translational_acceleration",
    "translational_deformation",
    "translational_deformation_velocity",
    "translational_displacement",
    "translational_kinetic_energy",
    "translational_momentum",
    "translational_velocity",
];

pub const CLASS: Class = Class {
    id: "measure_object",
    word: "Measure",
    families: &["measure", "data_element"],
    parents: &["model"],
    prefix: "MEASURE_",
    statement: Some("REQUEST"),
    groups: &[
        Group {
            command: "measure create object",
            creates: true,
            object: "measure_name",
            fields: &[
                common::COMMENTS,
                Field::yes_no("from_first").default_word("no").doc("measured from the first to the second marker"),
                Field::object("object", "any").required().doc("object that is observed"),
                Field::choice("characteristic", CHARACTERISTICS).required().doc("quantity recorded"),
                measured::COMPONENT,
                measured::MOTION_RFRAME,
                measured::COORDINATE_RFRAME,
                measured::DISPLAY,
                measured::LEGEND,
            ],
            rules: &[],
            doc: "a quantity of one object",
        },
        attributes::DATA_ELEMENT,
    ],
};
