//! Parts, markers, points, constraints, forces and contacts against the sheet of their commands.

mod common;

use common::sheet::{Command, Sheet, assert_same};
use flexure_elements::registry;

/// Where a schema differs from the sheet, and why.
const KNOWN: &[(&str, &str)] = &[
    // Without a mass of its own a part has that of its shapes, which a default would hide.
    ("rigid_body mass_properties mass: default", "the mass of the shapes counts where none is given"),
    ("rigid_body mass_properties ixx: default", "as the mass"),
    ("rigid_body mass_properties iyy: default", "as the mass"),
    ("rigid_body mass_properties izz: default", "as the mass"),
    ("rigid_body mass_properties ixy: default", "as the mass"),
    ("rigid_body mass_properties izx: default", "as the mass"),
    ("rigid_body mass_properties iyz: default", "as the mass"),
    ("rigid_body mass_properties density: default", "the density of the material counts where none is given"),
    ("point_mass mass_properties mass: default", "as of a rigid part"),
    ("point_mass mass_properties density: default", "as of a rigid part"),
    ("rigid_body initial_velocity wx: kind", "a plain number is in radians whatever the unit of angles is"),
    ("rigid_body initial_velocity wy: kind", "as wx"),
    ("rigid_body initial_velocity wz: kind", "as wx"),
    ("differential_equation no_initial_condition: default", "the start value that is required would be forgotten"),
    ("general_state_equation interface_routines: Count", "an export gives four routines"),
    ("marker create curve_name: kind", "markers on curves are kept by name only"),
    ("coupler type_of_freedom: kind", "the sheet names the type; the words are those of exports"),
    ("coupler motion_multipliers: Count", "three joints have three factors"),
    ("modal_force flex_body: kind", "there are no flexible bodies: any body will do"),
    ("modal_force j_part_name: kind", "the command that modifies takes any body"),
    ("contact create i_flex: kind", "there are no flexible bodies"),
    ("contact create j_flex: kind", "there are no flexible bodies"),
    ("contact create i_flip_geometry_name: kind", "curves that touch are shapes"),
    ("contact create j_flip_geometry_name: kind", "curves that touch are shapes"),
    ("kind Object(Old, \"any\"), not old ", "arrays, matrices and curves"),
];

#[test]
fn bodies_constraints_forces_and_contacts_have_the_parameters_of_their_commands() {
    let Some(sheet) = Sheet::read() else { return };
    let sections = ["Parts", "Markers and points", "Constraints", "Forces", "Contact"];
    let commands: Vec<&Command> =
        sections.iter().flat_map(|s| sheet.section(s)).filter(|c| c.is_of_a_class()).collect();
    assert!(commands.len() >= 50, "only {} commands were found", commands.len());
    assert_same(&registry(), &commands, KNOWN);
}
