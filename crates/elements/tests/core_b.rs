//! Shapes, data elements, measures, settings, sensors and the like against the sheet of their
//! commands.

mod common;

use common::sheet::{Command, Sheet, assert_same};
use flexure_elements::registry;

/// Where a schema differs from the sheet, and why.
const KNOWN: &[(&str, &str)] = &[
    ("angle_extent: default None", "the default is radians whatever the unit of angles is: not given is the whole arc"),
    ("ellipse end_angle: default None", "as angle_extent"),
    ("sensor angular_error: default None", "as angle_extent; and a sensor has one error or the other"),
    ("kind Object(Old, \"wire\"), not old wire geometry", "the family has a shorter name"),
    ("kind Object(Old, \"marker\"), not old triad", "markers are what the solver calls triads here"),
    ("force jprim_name: kind", "the family is written the other way round"),
    ("plate marker_name: Count", "three or more: plates of four markers are exported"),
    ("outline marker_name: Count", "two or more: an outline is a chain of markers"),
    ("spline x: Count", "four or more: an exported spline has eight"),
    ("spline y: Count", "as x"),
    ("spline z: Count", "two or more, as x"),
    ("shell file_name: kind", "a file; its usual ending is `.shl`"),
    ("kind Boolean(\"on\", \"off\"), not boolean", "exports write on and off"),
    ("output grsave: kind", "the sheet names the type and not its words"),
    ("measure create object object: kind", "any object of the database"),
    ("measure create point characteristic: kind", "two of the fifteen words are not known: all are taken"),
    ("computed text_of_expression: kind", "its names follow renaming, and exports fill it in at the end"),
    ("query gui_driver_name: kind", "there are no dialogs whose controls could be named"),
    ("variable create object_value: kind", "any object"),
    ("group create objects_in_group: kind", "any object"),
    ("group create type_filter: kind", "types are words"),
];

#[test]
fn shapes_data_measures_and_settings_have_the_parameters_of_their_commands() {
    let Some(sheet) = Sheet::read() else { return };
    let whole = ["Geometry", "Data elements", "Output and measures"];
    let mut commands: Vec<&Command> = whole
        .iter()
        .flat_map(|s| sheet.section(s))
        .filter(|c| c.is_of_a_class() || c.path.starts_with("output_control set"))
        .collect();
    let of_classes = ["simulation script create", "executive_control ", "analysis create"];
    let simulation = sheet.section("Simulation").iter();
    commands.extend(simulation.filter(|c| of_classes.iter().any(|path| c.path.starts_with(path))));
    let rest = sheet.section("Variables, macros, groups, entities, functions").iter();
    let of_elements = ["variable create", "group create", "function create", "material create"];
    commands.extend(rest.filter(|c| of_elements.contains(&c.path.as_str())));
    assert!(commands.len() >= 50, "only {} commands were found", commands.len());
    assert_same(&registry(), &commands, KNOWN);
}
