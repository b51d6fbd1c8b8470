//! The registry: one line for each element.

use schema::{Class, Registry};

use crate::{bodies, data, forces, geometry, joints, output, system};

/// Every class, in the order of the manual.
const CLASSES: &[&Class] = &[
    &bodies::model::CLASS,
    &bodies::part::CLASS,
    &bodies::ground::CLASS,
    &bodies::point_mass::CLASS,
    &bodies::marker::CLASS,
    &bodies::floating_marker::CLASS,
    &bodies::point::CLASS,
    &joints::fixed::CLASS,
    &joints::revolute::CLASS,
    &joints::spherical::CLASS,
    &joints::translational::CLASS,
    &joints::cylindrical::CLASS,
    &joints::universal::CLASS,
    &joints::hooke::CLASS,
    &joints::planar::CLASS,
    &joints::rackpin::CLASS,
    &joints::screw::CLASS,
    &joints::convel::CLASS,
    &joints::jprim_at_point::CLASS,
    &joints::jprim_inline::CLASS,
    &joints::jprim_inplane::CLASS,
    &joints::jprim_orientation::CLASS,
    &joints::jprim_parallel_axis::CLASS,
    &joints::jprim_perpendicular::CLASS,
    &joints::jprim_point_point::CLASS,
    &joints::motion::CLASS,
    &joints::coupler::CLASS,
    &joints::gear::CLASS,
    &joints::point_curve::CLASS,
    &joints::curve_curve::CLASS,
    &joints::general_constraint::CLASS,
    &joints::user_constraint::CLASS,
    &forces::beam::CLASS,
    &forces::gravity::CLASS,
    &forces::single_component_force::CLASS,
    &forces::bushing::CLASS,
    &forces::field::CLASS,
    &forces::translational_spring_damper::CLASS,
    &forces::rotational_spring_damper::CLASS,
    &forces::friction::CLASS,
    &forces::force_vector::CLASS,
    &forces::torque_vector::CLASS,
    &forces::general_force::CLASS,
    &forces::multi_point_force::CLASS,
    &forces::modal_force::CLASS,
    &forces::contact::CLASS,
    &system::differential_equation::CLASS,
    &system::transfer_function::CLASS,
    &system::linear_state_equation::CLASS,
    &system::general_state_equation::CLASS,
    &data::spline::CLASS,
    &data::curve_element::CLASS,
    &data::array_general::CLASS,
    &data::array_ic::CLASS,
    &data::array_x::CLASS,
    &data::array_y::CLASS,
    &data::array_u::CLASS,
    &data::matrix_full::CLASS,
    &data::matrix_sparse::CLASS,
    &data::matrix_file::CLASS,
    &data::string::CLASS,
    &data::solver_variable::CLASS,
    &data::function::CLASS,
    &data::material::CLASS,
    &data::section::rectangle::CLASS,
    &data::section::circle::CLASS,
    &data::section::tube::CLASS,
    &data::section::boxed::CLASS,
    &data::section::i_beam::CLASS,
    &data::section::ellipse::CLASS,
    &data::section::properties::CLASS,
    &data::variable::CLASS,
    &data::group::CLASS,
    &geometry::link::CLASS,
    &geometry::cylinder::CLASS,
    &geometry::frustum::CLASS,
    &geometry::block::CLASS,
    &geometry::ellipsoid::CLASS,
    &geometry::torus::CLASS,
    &geometry::plate::CLASS,
    &geometry::arc::CLASS,
    &geometry::circle::CLASS,
    &geometry::polyline::CLASS,
    &geometry::extrusion::CLASS,
    &geometry::revolution::CLASS,
    &geometry::plane::CLASS,
    &geometry::shell::CLASS,
    &geometry::ellipse::CLASS,
    &geometry::bspline::CLASS,
    &geometry::outline_curve::CLASS,
    &geometry::geometry_point::CLASS,
    &geometry::force_graphic::CLASS,
    &geometry::spring_damper_graphic::CLASS,
    &output::request::CLASS,
    &output::measure_pt2pt::CLASS,
    &output::measure_object::CLASS,
    &output::measure_function::CLASS,
    &output::measure_point::CLASS,
    &output::measure_angle::CLASS,
    &output::measure_orient::CLASS,
    &output::measure_computed::CLASS,
    &output::measure_range::CLASS,
    &output::measure_query::CLASS,
    &output::sensor::CLASS,
    &output::analysis::CLASS,
    &output::script::CLASS,
    &output::numerical_integration_parameters::CLASS,
    &output::equilibrium_parameters::CLASS,
    &output::kinematics_parameters::CLASS,
    &output::preferences::CLASS,
    &output::output_settings::CLASS,
    &output::results_settings::CLASS,
];

/// The classes of all elements. Verbs are added by whoever runs commands.
pub fn registry() -> Registry {
    Registry { classes: CLASSES.to_vec(), verbs: Vec::new() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use schema::{Count, Default, Dimension, Kind, Use};

    #[test]
    fn the_tables_keep_their_rules() {
        assert_eq!(registry().check(), Vec::<String>::new());
    }

    #[test]
    fn class_ids_are_unique_and_parents_exist() {
        let registry = registry();
        for (k, class) in registry.classes.iter().enumerate() {
            assert!(!registry.classes[..k].iter().any(|c| c.id == class.id), "{} is there twice", class.id);
            for parent in class.parents {
                assert!(registry.class(parent).is_some(), "{} wants the unknown parent {parent}", class.id);
            }
        }
    }

    #[test]
    fn two_classes_never_share_a_command_that_creates() {
        for class in registry().classes {
            for group in class.groups.iter().filter(|g| g.creates) {
                let creating = registry().groups(group.command).iter().filter(|(_, g)| g.creates).count();
                assert_eq!(creating, 1, "{}", group.command);
            }
        }
    }

    #[test]
    fn no_group_lists_a_parameter_twice_and_rules_name_parameters() {
        use schema::Rule;
        for class in registry().classes {
            for group in class.groups {
                let names: Vec<_> = group.fields.iter().map(|f| f.name).collect();
                for (k, name) in names.iter().enumerate() {
                    assert!(!names[..k].contains(name), "{}: {name} is there twice", group.command);
                }
                for rule in group.rules {
                    let lists: Vec<&[&str]> = match *rule {
                        Rule::OneOf(sets) => sets.to_vec(),
                        Rule::AtMostOne(list) | Rule::AtLeastOne(list) => vec![list],
                    };
                    for name in lists.concat() {
                        assert!(names.contains(&name), "{}: a rule names {name}", group.command);
                    }
                }
            }
        }
    }

    /// The object commands of the first release.
    #[test]
    fn the_commands_that_make_objects_are_there() {
        let joints = ["fixed", "revolute", "spherical", "translational", "cylindrical", "universal", "hooke", "planar"];
        let shapes = ["cylinder", "frustum", "link", "block", "ellipsoid", "torus", "plate", "force", "spring_damper"];
        let mut wanted: Vec<String> = [
            "model create",
            "part create rigid_body name_and_position",
            "part create rigid_body mass_properties",
            "part create rigid_body initial_velocity",
            "part create point_mass name_and_position",
            "part create point_mass mass_properties",
            "part create point_mass initial_velocity",
            "part create new_ground",
            "marker create",
            "point create",
            "material create",
            "constraint create motion_generator",
            "constraint attributes",
            "force create element_like beam",
            "force create body gravitational",
            "force create direct single_component_force",
            "variable create",
            "measure create pt2pt",
            "measure create object",
            "measure create function",
            "output_control create request",
            "executive_control set numerical_integration_parameters",
            "executive_control set equilibrium_parameters",
            "executive_control set kinematics_parameters",
            "simulation script create",
        ]
        .map(String::from)
        .to_vec();
        wanted.extend(joints.map(|j| format!("constraint create joint {j}")));
        wanted.extend(shapes.map(|s| format!("geometry create shape {s}")));
        wanted.extend(["arc", "circle", "polyline"].map(|c| format!("geometry create curve {c}")));
        for command in wanted {
            assert!(!registry().groups(&command).is_empty(), "{command} is missing");
        }
    }

    /// Truth: the table of the beam's create and modify commands: names, dimensions, defaults, and
    /// which of them modify takes as well.
    #[test]
    fn the_beam_has_the_parameters_of_its_commands() {
        use Dimension as D;
        let number = Default::Number;
        let expected = [
            ("adams_id", D::NONE, Default::None, true),
            ("comments", D::NONE, Default::None, true),
            ("ixx", D::AREA_INERTIA, number(1.0), true),
            ("iyy", D::AREA_INERTIA, number(1.0), true),
            ("izz", D::AREA_INERTIA, number(1.0), true),
            ("y_shear_area_ratio", D::NONE, number(0.0), true),
            ("z_shear_area_ratio", D::NONE, number(0.0), true),
            ("youngs_modulus", D::PRESSURE, number(1.0), true),
            ("shear_modulus", D::PRESSURE, number(1.0), true),
            ("length", D::LENGTH, number(1.0), true),
            ("area_of_cross_section", D::AREA, number(1.0), true),
            ("damping_ratio", D::TIME, number(0.0), true),
            ("matrix_of_damping_terms", D::NONE, Default::None, true),
            ("formulation", D::NONE, Default::Word("linear"), true),
            ("location", D::LENGTH, Default::None, false),
            ("orientation", D::ANGLE, Default::None, false),
            ("along_axis_orientation", D::LENGTH, Default::None, false),
            ("in_plane_orientation", D::LENGTH, Default::None, false),
            ("relative_to", D::NONE, Default::CoordinateSystem, false),
            ("i_part_name", D::NONE, Default::None, false),
            ("j_part_name", D::NONE, Default::None, false),
            ("i_marker_name", D::NONE, Default::None, true),
            ("j_marker_name", D::NONE, Default::None, true),
        ];
        let group = &registry().class("beam").unwrap().groups[0];
        assert_eq!(group.object, "beam_name");
        assert_eq!(group.fields.len(), expected.len());
        for (name, dimension, default, on_modify) in expected {
            let field = group.fields.iter().find(|f| f.name == name).unwrap_or_else(|| panic!("no {name}"));
            assert_eq!((field.dimension, field.default), (dimension, default), "{name}");
            assert_eq!(field.usage == Use::Both, on_modify, "{name}");
        }
        let field = |name| *group.fields.iter().find(|f| f.name == name).unwrap();
        assert_eq!(field("matrix_of_damping_terms").count, Count::exactly(21));
        assert_eq!(field("formulation").kind, Kind::Choice(&["linear", "string", "nonlinear"]));
    }

    /// Truth: the order of 119 exported beams.
    #[test]
    fn beams_are_written_in_the_order_of_exports() {
        let exported = [
            "adams_id",
            "i_marker_name",
            "j_marker_name",
            "length",
            "area_of_cross_section",
            "y_shear_area_ratio",
            "z_shear_area_ratio",
            "youngs_modulus",
            "shear_modulus",
            "ixx",
            "iyy",
            "izz",
            "damping_ratio",
            "formulation",
        ];
        let group = &registry().class("beam").unwrap().groups[0];
        let written: Vec<_> = group.fields.iter().map(|f| f.name).filter(|n| exported.contains(n)).collect();
        assert_eq!(written, exported);
    }
}
